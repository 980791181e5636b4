"""The style sheet of all pictures."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import matplotlib.style

#: Widths of a journal's column and page in inches.
COLUMN, PAGE = 3.4, 7.0
STYLE_SHEET = Path(__file__).with_name("paper.mplstyle")


@contextmanager
def paper_style() -> Iterator[None]:
    """Context for drawing and saving with only matplotlib's defaults and the style sheet."""
    with matplotlib.style.context(["default", str(STYLE_SHEET)]):
        yield
        interactive = matplotlib.is_interactive()
    # The first figure of a notebook loads its backend, which turns this on for all later figures.
    matplotlib.interactive(interactive)
