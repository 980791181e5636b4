"""The directive `figure-gallery`: every figure with its caption, its code and the command that draws it."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import takewhile
from pathlib import Path

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

from planar_pushing.drawing.canvas.svg import to_svg
from planar_pushing.drawing.files import contacts_picture, sketch_of_file
from planar_pushing.drawing.scene import scene_picture
from planar_pushing.scenes.contacts_files import load_any_file
from planar_pushing.scenes.contacts_model import ContactsFile
from planar_pushing.scenes.files import load_scene_file
from pulling_by_pushing.figures.figure import entry, module_name
from pulling_by_pushing.figures.studies import OURS
from pulling_by_pushing.study.studies import PAPER_FILE, SLIDERS_FILE
from pulling_by_pushing.study.study_file import load_study

#: A symbol with an index in a caption, such as v_p.
INDEXED = re.compile(r"\b([a-z])_([a-z])\b")
#: Titles of the groups in their order.
PAPER, BEYOND, SUPPORTS, METHODS, MOTIONS, SEVERAL = (
    "Figures of the paper",
    "Contact modes and motion over time",
    "Any support",
    "Numerical accuracy and measured pushes",
    "Other simulations",
    "Several contacts and walls",
)
#: Scene files with several contacts or walls, and the size of their pictures in pixels.
SCENES, SIZE = ("two_fingers", "box_along_a_wall", "finger_in_a_corner"), (460.0, 400.0)
MODULES = "src/pulling_by_pushing/figures"


@dataclass(frozen=True, kw_only=True)
class Shown:
    """A figure of the gallery.

    `file` is its picture in the results, and `code` a path in the project. A picture that is not among the
    results is `svg`, and `command` draws it.
    """

    group: str
    name: str
    title: str
    caption: str
    code: str
    file: str = ""
    language: str = "python"
    svg: str = ""
    command: str = ""


def figures(project: Path, results: Path) -> Iterator[Shown]:
    """The figures in the table of captions, in its order."""
    table = json.loads((results / "tables/figures.json").read_text(encoding="utf-8"))
    supports = load_study(project / SLIDERS_FILE).figures
    for name, values in table.items():
        about = entry(name)
        if name in OURS:
            group = METHODS
        elif name in supports:
            group = SUPPORTS
        else:
            group = PAPER if about.promise else BEYOND
        yield Shown(
            group=group, name=name, file=values["file"], title=f"Figure {values['number']}. {about.title}",
            caption=values["caption"],
            code=f"{MODULES}/{module_name(name).replace('.', '/')}.py",
        )  # fmt: skip


def simulations(project: Path) -> Iterator[Shown]:
    """The simulations that no figure shows, with their scene files."""
    for folder, file in (("", PAPER_FILE), ("studies/sliders/", SLIDERS_FILE)):
        study = load_study(project / file)
        read = {source for name in study.figures for source in entry(name).reads}
        for name, scene in study.simulations.items():
            if f"simulations/{name}" not in read:
                yield Shown(
                    group=MOTIONS, name=f"simulation_{name}",
                    title=name.replace("_", " ").capitalize(),
                    file=f"{folder}figures/simulation_{name}",
                    caption=f"{load_scene_file(scene).title}.",
                    code=str(Path(scene).relative_to(project)), language="yaml",
                )  # fmt: skip


def several(project: Path) -> Iterator[Shown]:
    """Scenes with several contacts or walls, of which each file begins with a comment on what happens."""
    for name in SCENES:
        code = f"workflow/scenes/{name}.yaml"
        lines = (project / code).read_text(encoding="utf-8").splitlines()
        about = [line.removeprefix("# ") for line in takewhile(lambda line: line[:1] == "#", lines)]
        yield Shown(
            group=SEVERAL, name=f"scene_{name}", title=load_any_file(project / code).title,
            caption=" ".join(about), code=code, language="yaml", svg=_svg(project / code),
            command=f"planar-pushing draw {code} -o {name}.svg",
        )  # fmt: skip


def _svg(path: Path) -> str:
    """The picture of a scene file at its start, as the command `draw` shows it."""
    file = load_any_file(path)
    if isinstance(file, ContactsFile):
        sketch = contacts_picture(file)
        return to_svg(sketch.draw(), sketch.box(), SIZE)
    pushed = sketch_of_file(file)
    return to_svg(scene_picture(pushed), pushed.box, SIZE)


def gallery(project: Path, results: Path) -> list[Shown]:
    """All figures of the paper's study and of the study `sliders`, and scenes with several contacts."""
    return [*figures(project, results), *simulations(project), *several(project)]


def _text(caption: str) -> list[nodes.Node]:
    """A caption with its symbols in italics, their indices lowered, and equations on one line."""
    parts: list[nodes.Node] = []
    caption = caption.replace(" = ", "\u00a0=\u00a0")
    end = 0
    for match in INDEXED.finditer(caption):
        parts += [
            nodes.Text(caption[end : match.start()]),
            nodes.emphasis("", match[1]),
            nodes.subscript("", match[2]),
        ]
        end = match.end()
    return [*parts, nodes.Text(caption[end:])]


def _block(text: str, language: str) -> nodes.literal_block:
    return nodes.literal_block(text, text, language=language)


def _titled(title: str, name: str) -> nodes.section:
    return nodes.section("", nodes.title("", title), ids=[nodes.make_id(name)])


class FigureGallery(SphinxDirective):
    """A section for each group, and in it one for each figure."""

    def run(self) -> list[nodes.Node]:
        project = self.env.srcdir.parents[1]
        results = (self.env.srcdir / self.config.results_folder).resolve()
        groups: dict[str, nodes.section] = {}
        for figure in gallery(project, results):
            group = groups.setdefault(figure.group, _titled(figure.group, figure.group))
            group += self._section(figure, project)
        return list(groups.values())

    def _section(self, figure: Shown, project: Path) -> nodes.section:
        self.env.note_dependency(project / figure.code)
        image: nodes.Node = nodes.raw("", figure.svg, format="html")
        command = figure.command
        if figure.file:
            place = f"{self.config.results_folder}/{figure.file}.svg"
            image = nodes.image(uri=place, alt=figure.title)
            command = f"snakemake results/{figure.file}.svg"
        code = (project / figure.code).read_text(encoding="utf-8").rstrip()
        section = _titled(figure.title, figure.name)
        section += nodes.figure("", image, nodes.caption("", "", *_text(figure.caption)))
        section += _block(f"$ {command}", "console")
        summary = f"<details><summary><code>{figure.code}</code></summary>"
        section += nodes.raw("", summary, format="html")
        section += _block(code, figure.language)
        section += nodes.raw("", "</details>", format="html")
        return section


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directive."""
    app.add_directive("figure-gallery", FigureGallery)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
