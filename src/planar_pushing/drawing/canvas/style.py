"""The style sheet of all pictures, and their files, whose bytes depend only on the picture."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import matplotlib.style
from matplotlib.figure import Figure

from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.replacing import PathLike, replacing

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


#: Options for each format, which omit metadata on the date and the program version.
SAVING: dict[str, dict[str, Any]] = {
    "svg": {"metadata": {"Date": None, "Creator": "planar-pushing"}},
    "pdf": {"metadata": {"CreationDate": None, "Creator": "planar-pushing", "Producer": None}},
    "png": {"metadata": {"Software": None}},
}


def save(figure: Figure, path: PathLike) -> None:
    """Save a picture, completely or not at all; its bytes depend only on the picture.

    Raises
    ------
    InvalidValue
        If the file name does not end in .svg, .pdf or .png.
    """
    kind = Path(path).suffix.lstrip(".").lower()
    if kind not in SAVING:
        allowed = ", ".join(f".{ending}" for ending in SAVING)
        raise InvalidValue("output", str(path), f"a name ending in {allowed}", "rename the file")
    with replacing(path) as temporary:
        figure.savefig(temporary, format=kind, **SAVING[kind])


def save_drawn(
    draw: Callable[[Figure], object], size: tuple[float, float], paths: Iterable[PathLike]
) -> None:
    """Draw on a figure of a given size in inches and save it under each name; errors as in `save`."""
    with paper_style():
        figure = Figure(figsize=size)
        draw(figure)
        for path in paths:
            save(figure, path)
