"""A page of the manual as plain Markdown: roles and directives become text, blocks, links and pictures."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from PIL import Image

from planar_pushing.terms.errors import InvalidFile
from pulling_by_pushing.figures.pages.cells import Shown, run_cells

#: Folders of the sources, of the rendered pages, and of the stored images of figures.
SOURCE, OUTPUT, IMAGES = Path("paper/manual"), Path("docs"), Path("tests/golden/images")
#: Where a page finds the results, seen from the project's folder.
RESULTS = Path("results")
#: A directive: its fence, name, argument, and content with options.
DIRECTIVE = re.compile(r"^(`{3,})\{([\w-]+)\} ?([^\n]*)\n(.*?)^\1 *$\n?", re.MULTILINE | re.DOTALL)
#: A block that is not a directive, which stays as it is.
BLOCK = re.compile(r"(^(`{3,})[^{].*?^\2 *$)", re.MULTILINE | re.DOTALL)
OPTION = re.compile(r"^:([\w-]+): ?(.*)\n", re.MULTILINE)
ROLE = re.compile(r"\{([\w:]+)\}`([^`]+)`")
LINK = re.compile(r"(!?)\[([^\]]*)\]\(([^)\s]+)\)")
CELL = re.compile(r"^```\{code-cell\} ipython3\n(.*?)^```$", re.MULTILINE | re.DOTALL)
#: Pages that only the built manual shows: their text comes from docstrings, commands and the ledger.
BUILT = ("reference/", "gallery.md", "theory/proofs.md", "index.md")
#: File of numbers by key, in the folder of the tables.
NUMBERS = "numbers.json"
#: Symbols appended to numbers with these units; the text names all other units.
MARKS = {"degree": "°", "percent": " %"}
#: A number with an exponent, and the superscript digits.
POWER = re.compile(r"\b([\d.]+)e([+-]\d+)\b")
RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


class Rendered(NamedTuple):
    """A page as text, and its pictures by file name."""

    text: str
    pictures: dict[str, Image.Image]


def rendered_pages() -> list[Path]:
    """Pages that are rendered, relative to the folder of the sources, in order."""
    every = sorted(path.relative_to(SOURCE) for path in SOURCE.rglob("*.md"))
    return [page for page in every if not page.as_posix().startswith(BUILT)]


def render_page(page: Path, results: Path = RESULTS) -> Rendered:
    """Page with its numbers, outputs and pictures.

    Parameters
    ----------
    page : Path
        Relative to the folder of the sources.
    results : Path
        Folder of the results, whose numbers and datasets the page shows.

    Raises
    ------
    InvalidFile
        If the page has a role or directive that plain Markdown cannot show, or a number is missing.
    """
    return _Page(page, results).render()


class _Page:
    """A page on its way to plain Markdown."""

    def __init__(self, page: Path, results: Path) -> None:
        self.page, self.results = page, results
        self.source = (SOURCE / page).read_text(encoding="utf-8")
        cells = CELL.findall(self.source)
        self.shown = iter(run_cells(cells, results) if cells else ())
        self.pictures: dict[str, Image.Image] = {}
        self.equations = {
            label: number
            for number, label in enumerate(re.findall(r"^:label: (\S+)$", self.source, re.M), 1)
        }

    def render(self) -> Rendered:
        parts, end = [], 0
        for directive in DIRECTIVE.finditer(self.source):
            parts += [self._prose(self.source[end : directive.start()]), self._directive(directive)]
            end = directive.end()
        parts.append(self._prose(self.source[end:]))
        return Rendered("".join(parts), self.pictures)

    def _prose(self, text: str) -> str:
        """Text with its links and roles written out; its blocks stay as they are."""
        # Of each block, split gives the text before it, the block, and its fence.
        parts = BLOCK.split(text)
        for number in range(0, len(parts), 3):
            parts[number] = ROLE.sub(self._role, LINK.sub(self._link, parts[number]))
        return "".join(part for number, part in enumerate(parts) if number % 3 != 2)

    def _role(self, role: re.Match[str]) -> str:
        kind, content = role.groups()
        if kind == "number":
            return self._number(content)
        if kind == "eq":
            return f"({self.equations[content]})"
        if kind.startswith("py:"):
            return f"`{content.removeprefix('~').removeprefix('planar_pushing.')}`"
        raise self._unknown(kind)

    def _number(self, key: str) -> str:
        path = self.results / "tables" / NUMBERS
        number = json.loads(path.read_text(encoding="utf-8")).get(key)
        if number is None:
            raise InvalidFile(f"{SOURCE / self.page}: {key}: no such number in {path}")
        return format_number(number["text"], number["unit"])

    def _link(self, link: re.Match[str]) -> str:
        shows, text, address = link.groups()
        name, mark, anchor = address.partition("#")
        if not name or re.match(r"[a-z]+:", name):
            return link[0]
        target = Path(os.path.normpath((SOURCE / self.page).parent / name))
        if target.suffix == ".md" and target.is_relative_to(SOURCE):
            inside = target.relative_to(SOURCE)
            if inside not in rendered_pages():
                return text
            target = OUTPUT / inside
        return f"{shows}[{text}]({self._path_to(target)}{mark}{anchor})"

    def _path_to(self, target: Path) -> str:
        return Path(os.path.relpath(target, (OUTPUT / self.page).parent)).as_posix()

    def _directive(self, directive: re.Match[str]) -> str:
        _, kind, argument, content = directive.groups()
        known: dict[str, Callable[[str, dict[str, str], str], str]] = {
            "code-cell": self._cell, "figure": self._figure, "literalinclude": self._file,
            "math": self._math, "toctree": self._contents,
        }  # fmt: skip
        if kind not in known:
            raise self._unknown(kind)
        if kind == "code-cell":
            return self._cell(argument, {}, content)
        return known[kind](argument, dict(OPTION.findall(content)), OPTION.sub("", content).strip())

    def _cell(self, _argument: str, _options: dict[str, str], code: str) -> str:
        shown: Shown = next(self.shown)
        text = f"```python\n{code}```\n"
        if shown.text:
            text += f"\n```text\n{shown.text.rstrip()}\n```\n"
        for picture in shown.pictures:
            name = f"{self.page.stem}_{len(self.pictures) + 1}.png"
            self.pictures[name] = picture
            text += f"\n![Picture of this cell]({self._path_to(OUTPUT / 'pictures' / name)})\n"
        return text

    def _figure(self, path: str, options: dict[str, str], caption: str) -> str:
        image, caption = IMAGES / f"{Path(path).stem}.png", self._prose(caption)
        if not image.is_file():
            return f"*{caption}* (in the built manual)\n" if caption else ""
        return f"![{options.get('alt', '')}]({self._path_to(image)})\n\n*{caption}*\n"

    def _file(self, name: str, options: dict[str, str], _content: str) -> str:
        path = Path(os.path.normpath((SOURCE / self.page).parent / name))
        if path.is_relative_to(RESULTS):
            path = self.results / path.relative_to(RESULTS)
        lines = path.read_text(encoding="utf-8").splitlines()
        if start := options.get("start-at"):
            lines = lines[next(n for n, line in enumerate(lines) if start in line) :]
        if last := options.get("lines"):
            lines = lines[: int(last.removeprefix("-"))]
        language = options.get("language", "text").replace("none", "text")
        return "\n".join([f"```{language}", *lines, "```", ""])

    def _math(self, _argument: str, options: dict[str, str], formula: str) -> str:
        tag = f" \\tag{{{self.equations[options['label']]}}}" if "label" in options else ""
        return f"```math\n{formula}{tag}\n```\n"

    def _contents(self, _argument: str, _options: dict[str, str], names: str) -> str:
        folder, items = self.page.parent, []
        for name in names.split():
            page = folder / f"{name}.md"
            if page in rendered_pages():
                title = (SOURCE / page).read_text(encoding="utf-8").split("\n", 1)[0].lstrip("# ")
                items.append(f"- [{title}]({name}.md)\n")
        return "".join(items)

    def _unknown(self, kind: str) -> InvalidFile:
        allowed = "number, eq, py:, code-cell, figure, literalinclude, math, toctree"
        return InvalidFile(f"{SOURCE / self.page}: {{{kind}}}; allowed: {allowed}")


def format_number(text: str, unit: str = "") -> str:
    """A number formatted for text: a minus sign, powers of ten, separated thousands, and a symbol."""
    if text.isdigit() and len(text) > 4:
        return f"{int(text):,}".replace(",", "\u202f") + MARKS.get(unit, "")
    return POWER.sub(_power, text).replace("-", "\u2212") + MARKS.get(unit, "")


def _power(power: re.Match[str]) -> str:
    ten = "10" + str(int(power[2])).translate(RAISED)
    return ten if power[1] == "1" else f"{power[1]} \u00d7 {ten}"
