"""The manual's pages and their blocks of code."""

from __future__ import annotations

import re
from pathlib import Path

FOLDER = Path("paper/manual").resolve()
PAGES = sorted(FOLDER.rglob("*.md"))
#: A fence, what it holds, and its end.
BLOCK = re.compile(r"^(`{3,})([^\n]*)\n(.*?)^\1 *$", re.MULTILINE | re.DOTALL)
#: Directives that show no code of their own.
SHOWN = (
    "{command-reference}", "{figure}", "{figure-gallery}", "{image}", "{include}", "{ledger-proofs}",
    "{list-table}", "{literalinclude}", "{math}", "{note}", "{results-table}", "{table}", "{toctree}",
    "{warning}",
)  # fmt: skip
#: Cells of a notebook, which runs when the manual is built.
CELLS = "{code-cell}"


def name(page: Path) -> str:
    """The page as Sphinx names it."""
    return page.relative_to(FOLDER).with_suffix("").as_posix()


def blocks(page: Path) -> list[tuple[str, str]]:
    """Kind and text of each block of code, in order."""
    found = BLOCK.findall(page.read_text(encoding="utf-8"))
    marked = [(mark.split()[0] if mark.strip() else "", text) for _, mark, text in found]
    return [(kind, text) for kind, text in marked if kind not in (*SHOWN, CELLS)]
