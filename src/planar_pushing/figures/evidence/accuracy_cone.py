"""What accuracy costs: both edges of a motion cone, and the models' direction errors for a rim."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from planar_pushing.figures.evidence.work_precision import (
    LOOKS,
    handles,
    methods,
    note,
    work_precision,
)
from planar_pushing.figures.style import GREY, NOTE_SIZE

LIMITS = (1e-15, 1e2)


def draw(figure: Figure, data: xr.Dataset) -> None:
    """Draw the work-precision diagram and, beside it, the mean errors for a rim of points."""
    left, right = figure.subplots(1, 2, width_ratios=(3.4, 1))
    figure.subplots_adjust(left=0.085, right=0.985, bottom=0.125, top=0.83, wspace=0.35)
    work_precision(left, data.method.values, data.cone_seconds, data.cone_error.values, LIMITS)
    left.set(xlim=(1e-8, 3e-1), yticks=10.0 ** np.arange(-14, 3, 4))
    left.set(xlabel="time for both edges of a cone, seconds", ylabel="largest error, degrees")
    _settings(left, data)
    _rim(right, data)
    figure.legend(
        handles=handles(methods(data)), loc="upper left", ncols=4, bbox_to_anchor=(0.075, 1.0),
        fontsize=8,
    )  # fmt: skip


#: Which settings of a method are named, and on which side of their markers.
NAMED = {
    "linear table": ("{:g} entries", (0, -1), "right"),
    "cubic table": ("{:g} entries", (0, -1), "left"),
    "find_root": ("tolerance {:g}", (0, -1), "left"),
    "brentq on quad": ("tolerance {:g}", (0, -1), "left"),
}


def _settings(ax: Axes, data: xr.Dataset) -> None:
    """Name the ends of each line by their settings."""
    for name, (text, which, side) in NAMED.items():
        rows = np.flatnonzero(data.method.values == name)
        away = 8 if side == "left" else -8
        for row in rows[list(which)]:
            times = data.cone_seconds[row]
            beside = times.min() if side == "right" else times.median()
            at = float(beside), float(data.cone_error[row])
            words = text.format(float(data.setting[row]))
            ax.annotate(
                words, at, (away, 0), textcoords="offset points", ha=side, va="center",
                color=GREY, fontsize=NOTE_SIZE - 1,
            )  # fmt: skip


def _rim(ax: Axes, data: xr.Dataset) -> None:
    names = ["ellipsoid", "convex quartic"]
    values = data.rim_error.values
    ax.bar([0, 1], values, width=0.6, color=[LOOKS[name]["color"] for name in names], alpha=0.75)
    for place, value in enumerate(values):
        note(ax, place, value * 1.12, f"{value:.2f}", ha="center", va="bottom")
    ax.set(yscale="log", ylim=(0.05, 20), xlim=(-0.6, 1.6), xticks=[0, 1])
    ax.set_xticklabels(["ellipsoid", "convex\nquartic"])
    ax.set_ylabel("mean direction error, degrees")
    ax.set_title("rim of 100 points")
    ax.minorticks_off()
