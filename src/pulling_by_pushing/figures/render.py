"""Draw figures from the datasets of a results folder, and save them."""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache, partial
from typing import TYPE_CHECKING, Any

from planar_pushing.drawing.canvas.style import save_drawn
from pulling_by_pushing.figures.figure import Cuts, Drawing, drawing, view

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from planar_pushing.terms.replacing import PathLike

LOGGER = logging.getLogger("planar_pushing")


def draw_figures(
    *,
    results: PathLike,
    figures: Mapping[str, Cuts],
    simulations: Sequence[str] = (),
    **paths: Sequence[PathLike],
) -> None:
    """Draw figures from their datasets, and simulations from their logs, and save each.

    Parameters
    ----------
    results : path
        Folder that contains data/*.nc.
    figures : mapping of str to mapping
        Values of the study for each figure, such as "figure_01", from `studies.cuts`; none for a figure of
        no study.
    simulations : sequence of str
        Names of simulations, such as "turning_fence".
    paths : sequences of paths
        Pictures of one format each, of the figures and then of the simulations; the ending of a name
        determines the format.
    """
    drawings = _drawings(results, figures, simulations)
    for (draw, size), *pictures in zip(drawings, *paths.values(), strict=True):
        save_drawn(draw, size, pictures)


def _drawings(
    results: PathLike, figures: Mapping[str, Cuts], simulations: Sequence[str]
) -> Iterator[tuple[Callable[[Figure], object], tuple[float, float]]]:
    """The function that draws each picture, and the size of the picture in inches."""
    from pulling_by_pushing.study.store import open_dataset

    read: Callable[..., Any] = cache(open_dataset)  # figures of one section share datasets
    for name, cuts in figures.items():
        LOGGER.info("drawing %s", name)
        figure_drawing = drawing(name)
        data = view(name, results, cuts, read)
        yield partial(_draw_view, figure_drawing, data), figure_drawing.figure.size
    if simulations:
        from planar_pushing.drawing.draw import LOG, plot_log

        for name in simulations:
            LOGGER.info("drawing simulation_%s", name)
            yield partial(plot_log, read(f"simulations/{name}", results)), LOG


def _draw_view(figure_drawing: Drawing, data: Any, figure: Figure) -> None:
    figure_drawing.draw(figure, data)
