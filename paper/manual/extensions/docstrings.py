"""Convert docstrings, which are written for a Python prompt, to reStructuredText."""

from __future__ import annotations

import re

from sphinx.application import Sphinx


def keep_magnitudes(
    app: Sphinx, kind: str, name: str, value: object, options: object, lines: list[str]
) -> None:
    """Escape |f|, the magnitude of a force, which would otherwise be read as a substitution."""
    lines[:] = [re.sub(r"\|(\w+)\|", r"\\|\1\\|", line) for line in lines]


def setup(app: Sphinx) -> dict[str, bool]:
    """Process docstrings before numpydoc does."""
    app.connect("autodoc-process-docstring", keep_magnitudes, priority=400)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
