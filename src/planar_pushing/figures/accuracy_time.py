"""Accuracy of the friction wrench against time at four spin ratios, measured on one machine."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes

from planar_pushing.figures.figure import COLUMN, PAGE, Figure
from planar_pushing.figures.parts.methods import (
    LIMITS,
    best,
    row_of_panels,
    work_precision,
)
from planar_pushing.mechanics.plane import Array

FIGURE = Figure(
    title="Error of the friction wrench against time",
    reads=("accuracy_time",),
    size=(PAGE, 2.7),
    column=(COLUMN, 4.6),
)
#: Factor by which the time axis extends beyond the fastest and the slowest method.
BEYOND = 2.5
TICKS = 10.0 ** np.arange(-7, -2, 2)


def caption(data: xr.Dataset) -> str:
    """Caption of the figure."""
    return (
        "Error of the friction wrench against the time for one wrench, for the methods, settings, "
        "and spin ratios of the figure on evaluations. A marker is at the shortest time of repeated runs, "
        "and a hair extends to their median; methods that take arrays are timed on arrays. Other "
        "machines and other runs give other times. Dotted: rounding error of a double."
    )


def draw(figure: Any, data: xr.Dataset) -> None:
    """Draw four panels of error against time with one legend."""
    row_of_panels(figure, data, "time for one wrench, seconds", _panel)
    least, median = data.wrench_seconds.min(), data.wrench_seconds.median("repeat").max()
    for ax in figure.axes:
        ax.set_xticks(TICKS)
        ax.set_xlim(float(least) / BEYOND, float(median) * BEYOND)


def _panel(ax: Axes, one: xr.Dataset) -> Array:
    work_precision(ax, one.method.values, one.wrench_seconds, one.error.values, LIMITS)
    return best(one.wrench_seconds)
