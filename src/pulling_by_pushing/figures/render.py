"""Draw a figure from the datasets of a results folder, and save it."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

from planar_pushing.drawing.canvas.style import save_drawn
from pulling_by_pushing.figures.figure import Cuts, drawing, view

if TYPE_CHECKING:
    from planar_pushing.terms.replacing import PathLike


def figure(
    *, name: str, results: PathLike, cuts: Cuts | None = None, **paths: PathLike
) -> None:  # fmt: skip
    """Draw a figure from its datasets and save it.

    Parameters
    ----------
    name : str
        Name of the figure, such as "figure_01".
    results : path
        Folder that contains data/*.nc.
    cuts : mapping, optional
        Values of the study for this figure, from `studies.cuts`; none for a figure of no study.
    paths : paths
        Pictures to save; the ending of a name determines the format.
    """
    figure_drawing, data = drawing(name), view(name, results, cuts)

    def draw(figure: Any) -> None:
        figure_drawing.draw(figure, data)

    save_drawn(draw, figure_drawing.figure.size, paths.values())


def simulation_figures(sources: Sequence[PathLike], **paths: Sequence[PathLike]) -> None:
    """Draw simulations from their logs; the paths are lists in the order of the logs."""
    from planar_pushing.drawing.draw import LOG, plot_log
    from planar_pushing.terms.netcdf import read_dataset

    for source, *pictures in zip(sources, *paths.values(), strict=True):
        save_drawn(partial(plot_log, read_dataset(source)), LOG, pictures)
