"""Picture of one simulation: the trajectory with its modes in color, and time series beside it."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from planar_pushing.figures.motion.over_time import mark_time, ribbon, series
from planar_pushing.figures.motion.timeline import impacts, plotted
from planar_pushing.figures.motion.trajectory import box, mark_impact, snapshots
from planar_pushing.figures.render import PathLike, draw_to_files
from planar_pushing.study.figures import FIGURES
from planar_pushing.study.store import read_dataset

#: Instants at which slider and fence are drawn.
COUNT = 5
#: Variables over time that are shown where they vary, and their labels.
SERIES = {
    "path_rod_angle": "rod angle $\\psi$\n(degrees)",
    "path_slip": "slip",
    "path_gap": "gap",
}


def draw(figure: Figure, data: xr.Dataset, struck: Sequence[int] = ()) -> None:
    """Draw the trajectory on the left, and on the right what changes over time.

    `struck` are the rows of impacts; slider and fence are drawn there too.
    """
    left = snapshots(figure, data, (0.0, 0.0, 0.6, 1.0), box(data), COUNT, struck)
    shown = [name for name in SERIES if np.ptp(data[name].values) > 0] or ["path_rod_angle"]
    grid = figure.add_gridspec(
        len(shown) + 1, 1, left=0.69, right=0.98, bottom=0.15, top=0.97, hspace=0.28,
        height_ratios=[*(1.0 for _ in shown), 0.28],
    )  # fmt: skip
    for place, name in enumerate(shown):
        series(figure.add_subplot(grid[place]), data, name, SERIES[name])
    ribbon(figure.add_subplot(grid[len(shown)]), data)
    figure.align_ylabels()
    for row in struck:
        mark_impact(left, data, row)
        for ax in figure.axes[1:]:
            mark_time(ax, data, row)


def render(log: PathLike, outputs: Sequence[PathLike]) -> None:
    """Draw a log and save the picture as every file that is named; errors as in `save`."""
    found = read_dataset(log)
    data = plotted(found)  # which says what a file that is no log lacks
    drawn = partial(draw, struck=impacts(found))
    draw_to_files(drawn, FIGURES["figure_15"].size, data, outputs)
