"""Pictures in files, whose bytes depend only on the picture."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

from matplotlib.figure import Figure

from planar_pushing.drawing.canvas.style import paper_style
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.replacing import PathLike, replacing

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
        allowed = ", ".join(f".{each}" for each in SAVING)
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
