"""Accuracy against time of the friction wrench, with a panel for each spin ratio."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.figures.colors import GRAY
from planar_pushing.figures.figure import PAGE, Figure
from planar_pushing.figures.marks import NOTE
from planar_pushing.figures.parts.methods import (
    LIMITS,
    TITLES,
    best,
    handles,
    mark_errors,
    methods,
    work_precision,
)

FIGURE = Figure(
    title="The friction wrench",
    reads=("accuracy/wrench",),
    size=(PAGE, 7.4),
)


def draw(figure: Any, data: xr.Dataset) -> None:
    """Draw nine work-precision diagrams with one legend."""
    axes = figure.subplots(3, 3, sharex=True, sharey=True)
    figure.subplots_adjust(left=0.085, right=0.985, bottom=0.065, top=0.875, hspace=0.2, wspace=0.1)
    names = data.method.values
    for ax, (spin_ratio, title) in zip(axes.flat, TITLES.items(), strict=True):
        one = data.sel(spin_ratio=spin_ratio)
        work_precision(ax, names, one.wrench_seconds, one.error.values, LIMITS)
        ax.set_title(title)
        ax.margins(x=0.08)
        ax.set_xticks(10.0 ** np.arange(-7, -2, 2))
        mark_errors(ax, best(one.wrench_seconds), one.error.values)
    for ax in axes[-1]:
        ax.set_xlabel("time for one wrench, seconds")
    for ax in axes[:, 0]:
        ax.set_ylabel("relative error")
    figure.legend(handles=handles(methods(data)), loc="upper center", ncols=5, fontsize=8)
    figure.text(
        0.5, 0.918, "Dotted: rounding of a double. Hairs lead from the least time to the median.",
        ha="center", fontsize=NOTE, color=GRAY,
    )  # fmt: skip
