"""The directive `ledger-proofs`: every entry of the ledger with its arguments, which Typst sets as HTML."""

from __future__ import annotations

import os
import re

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

from planar_pushing.terms.errors import InvalidFile
from pulling_by_pushing.report.typeset import typeset_html

#: The source that sets the entries, relative to the project.
SOURCE = "paper/proofs.typ"
#: A section of its HTML: the title and the content.
SECTION = re.compile(r'<section title="([^"]*)">(.*?)</section>', re.DOTALL)


class LedgerProofs(SphinxDirective):
    """A section for each section of the paper, one for the theorems, and one for the propositions."""

    def run(self) -> list[nodes.Node]:
        project = self.env.srcdir.parents[1]
        results = self.env.srcdir / self.config.results_folder
        self.env.note_dependency(results / "tables/claims.json")
        try:
            html = typeset_html(project / SOURCE, project, os.path.relpath(results, project))
        except InvalidFile as error:
            raise self.error(str(error)) from None
        return [_section(title, content) for title, content in SECTION.findall(html)]


def _section(title: str, content: str) -> nodes.section:
    section = nodes.section("", nodes.title("", title), ids=[nodes.make_id(title)])
    section += nodes.raw("", content, format="html")
    return section


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directive."""
    app.add_directive("ledger-proofs", LedgerProofs)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
