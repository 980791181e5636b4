"""Accuracy against time: both edges of a motion cone, and direction errors of models for a rim."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes

from planar_pushing.figures.figure import PAGE, Figure
from planar_pushing.figures.parts.methods import (
    LOOKS,
    handles,
    methods,
    name_ends,
    note,
    work_precision,
)

FIGURE = Figure(
    title="Both edges of a cone",
    reads=("accuracy/cone",),
    size=(PAGE, 3.7),
)
LIMITS = (1e-15, 1e2)


def draw(figure: Any, data: xr.Dataset) -> None:
    """Draw the work-precision diagram and the mean errors for a rim of points."""
    left, right = figure.subplots(1, 2, width_ratios=(3.4, 1))
    figure.subplots_adjust(left=0.085, right=0.985, bottom=0.125, top=0.83, wspace=0.35)
    work_precision(left, data.method.values, data.cone_seconds, data.cone_error.values, LIMITS)
    left.margins(x=0.35)  # room for the labels of settings
    left.set(yticks=10.0 ** np.arange(-14, 3, 4))
    left.set(xlabel="time for both edges of a cone, seconds", ylabel="largest error, degrees")
    name_ends(left, data, "cone", NAMED)
    _rim(right, data)
    figure.legend(
        handles=handles(methods(data)), loc="upper left", ncols=4, bbox_to_anchor=(0.075, 1.0),
        fontsize=8,
    )  # fmt: skip


#: Format and alignment of the labels of a method's settings.
NAMED = {
    "linear table": ("{} entries", "right"),
    "cubic table": ("{} entries", "left"),
    "find_root": ("tolerance {}", "left"),
    "brentq on quad": ("tolerance {}", "left"),
}


def _rim(ax: Axes, data: xr.Dataset) -> None:
    names = ["ellipsoid", "convex quartic"]
    values = data.rim_error.values
    ax.bar([0, 1], values, width=0.6, color=[LOOKS[name]["color"] for name in names], alpha=0.75)
    for place, value in enumerate(values):
        note(ax, place, value + 0.02 * max(values), f"{value:.2f}", ha="center", va="bottom")
    ax.set(ylim=(0, 1.1 * max(values)), xlim=(-0.6, 1.6), xticks=[0, 1])
    ax.set_xticklabels(["ellipsoid", "convex\nquartic"])
    ax.set_ylabel("mean direction error, degrees")
    ax.set_title("rim of 100 points")
    ax.minorticks_off()
