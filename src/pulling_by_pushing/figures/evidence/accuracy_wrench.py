"""Accuracy of the friction wrench against time at four spin ratios."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes

from planar_pushing.drawing.canvas.colors import GRAY
from planar_pushing.drawing.canvas.marks import NOTE
from planar_pushing.drawing.canvas.style import PAGE
from planar_pushing.mechanics.plane import Array
from pulling_by_pushing.figures.figure import Data, Figure
from pulling_by_pushing.figures.parts.methods import handles, methods, with_times, work_precision

FIGURE = Figure(
    title="What the accuracy of a friction wrench costs",
    reads=("accuracy/wrench", "accuracy_time/wrench"),
    size=(PAGE, 2.7),
)
#: Spin ratios of the panels: regular, close to the ring, on the ring, a spin.
PANELS = {0.1: "$k = 0.1$", 1 - 1e-9: "$k = 1 - 10^{-9}$", 1.0: "$k = 1$", 1e8: "$k = 10^{8}$"}
#: Values at which relative errors of zero and NaN are marked.
LIMITS = (1e-19, 1e4)
#: Factor by which the time axis extends beyond the fastest and the slowest method.
BEYOND = 2.5


def caption(data: Data) -> str:
    """Caption of the figure."""
    return (
        "Error of the friction wrench against the time for one wrench, at four spin ratios k, with a "
        "marker for each setting of a method: stars are the closed form of this work, blue markers other "
        "formulas, brown markers quadrature rules, and hollow markers the ellipsoid. A marker is at the "
        "shortest time of repeated runs, and a hair extends to their median; methods that take arrays "
        "are timed on arrays. A result of NaN is drawn at the end of the axis. Dotted: rounding error of "
        "a double."
    )


def draw(figure: Any, data: Data) -> None:
    """Draw a panel for each spin ratio, with one legend."""
    every = with_times(data, "wrench").sel(spin_ratio=list(PANELS))
    axes = figure.subplots(1, len(PANELS), sharex=True, sharey=True)
    figure.subplots_adjust(left=0.085, right=0.985, bottom=0.15, top=0.77, wspace=0.09)
    for ax, (spin_ratio, title) in zip(axes, PANELS.items(), strict=True):
        part = every.sel(spin_ratio=spin_ratio)
        errors = part.wrench_error.values
        work_precision(ax, part.method.values, part.wrench_seconds, errors, LIMITS)
        _mark_limits(ax, part.wrench_seconds.min("repeat").values, errors)
        ax.set_title(title)
    axes[0].set_ylabel("relative error")
    times = every.wrench_seconds
    ends = float(times.min()) / BEYOND, float(times.median("repeat").max()) * BEYOND
    axes[0].set(xticks=10.0 ** np.arange(-7, -2, 2), xlim=ends)
    figure.supxlabel("time for one wrench, seconds", fontsize=8.5, y=0.01)
    figure.legend(handles=handles(methods(every)), loc="upper center", ncols=4, fontsize=8)


def _mark_limits(ax: Axes, times: Array, errors: Array) -> None:
    """Mark the rounding error of a double, the positions of zero and NaN, and each result of NaN."""
    ax.axhline(np.finfo(float).eps, color=GRAY, linewidth=0.6, linestyle=":")
    powers = range(-16, 1, 4)
    names = [f"$10^{{{power}}}$" for power in powers]
    ax.set_yticks([LIMITS[0], *(10.0**power for power in powers), LIMITS[1]], ["0", *names, "NaN"])
    for row in np.flatnonzero(~np.isfinite(errors)):
        marker = float(times[row]), LIMITS[1]
        ax.annotate("NaN", marker, (6, -3), textcoords="offset points", fontsize=NOTE)
