"""The role `number` and the directive `results-table`: numbers and tables from the results."""

from __future__ import annotations

import csv
import json
from pathlib import Path

from docutils import nodes
from docutils.parsers.rst import directives
from sphinx.application import Sphinx
from sphinx.config import Config
from sphinx.util.docutils import SphinxDirective, SphinxRole

from pulling_by_pushing.figures.pages.markdown import NUMBERS, format_number


def tables(app_config: Config, source_folder: Path) -> Path:
    """Folder of the tables in the results."""
    return (source_folder / app_config.results_folder / "tables").resolve()


class Number(SphinxRole):
    """A number, by its key in the files of numbers."""

    def run(self) -> tuple[list[nodes.Node], list[nodes.system_message]]:
        path = tables(self.config, self.env.srcdir) / NUMBERS
        self.env.note_dependency(path)
        number = json.loads(path.read_text(encoding="utf-8")).get(self.text)
        if number:
            return [nodes.Text(format_number(number["text"], number["unit"]))], []
        said = f"{self.text}: no such number in {path}"
        return [], [self.inliner.reporter.error(said, line=self.lineno)]


class ResultsTable(SphinxDirective):
    """A table from the results."""

    required_arguments = 1
    final_argument_whitespace = False
    option_spec = {"caption": directives.unchanged_required}  # noqa: RUF012 - as docutils declares it

    def run(self) -> list[nodes.Node]:
        path = tables(self.config, self.env.srcdir) / self.arguments[0]
        if not path.exists():
            raise self.error(f"{path}: no such table; build it with make")
        self.env.note_dependency(path)
        rows = list(csv.reader(path.read_text(encoding="utf-8").splitlines()))
        return [_table(rows, self.options.get("caption", ""))]


def _table(rows: list[list[str]], caption: str) -> nodes.table:
    head, *body = rows
    group = nodes.tgroup("", cols=len(head))
    group += [nodes.colspec(colwidth=1) for _ in head]
    group += nodes.thead("", _row([cell.replace("_", " ") for cell in head]))
    group += nodes.tbody("", *map(_row, body))
    title = [nodes.title(caption, caption)] if caption else []
    return nodes.table("", *title, group, classes=["results"])


def _row(cells: list[str]) -> nodes.row:
    entries = (nodes.entry("", nodes.paragraph("", format_number(cell))) for cell in cells)
    return nodes.row("", *entries)


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the role and the directive."""
    app.add_config_value("results_folder", "results", "env", types=frozenset({str}))
    app.add_role("number", Number())
    app.add_directive("results-table", ResultsTable)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
