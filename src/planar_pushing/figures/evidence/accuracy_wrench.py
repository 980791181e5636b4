"""What accuracy costs: the friction wrench, a panel for each spin ratio."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from planar_pushing.figures.evidence.work_precision import (
    handles,
    methods,
    name_limits,
    work_precision,
)
from planar_pushing.figures.style import GREY, NOTE_SIZE

#: Where errors of zero, and NaN, are marked.
LIMITS = (1e-19, 1e4)
TITLES = (
    r"$k = 10^{-8}$, almost a translation",
    r"$k = 0.1$",
    r"$k = 0.9$",
    r"$k = 1 - 10^{-3}$",
    r"$k = 1 - 10^{-9}$",
    r"$k = 1$, centre on the ring",
    r"$k = 1 + 10^{-9}$",
    r"$k = 3$",
    r"$k = 10^{8}$, almost a spin in place",
)


def draw(figure: Figure, data: xr.Dataset) -> None:
    """Draw nine work-precision diagrams with one legend."""
    axes = figure.subplots(3, 3, sharex=True, sharey=True)
    figure.subplots_adjust(left=0.085, right=0.985, bottom=0.065, top=0.875, hspace=0.2, wspace=0.1)
    names = data.method.values
    for index, (ax, title) in enumerate(zip(axes.flat, TITLES, strict=True)):
        one = data.isel(spin_ratio=index)
        work_precision(ax, names, one.wrench_seconds, one.error.values, LIMITS)
        ax.axhline(np.finfo(float).eps, color=GREY, linewidth=0.6, linestyle=":")
        ax.set_title(title)
        ax.margins(x=0.08)
        ax.set_xticks(10.0 ** np.arange(-7, -2, 2))
        name_limits(ax, LIMITS)
        for row in np.flatnonzero(~np.isfinite(one.error.values)):
            place = float(one.wrench_seconds[row].min()), LIMITS[1]
            ax.annotate("NaN", place, (6, -3), textcoords="offset points", fontsize=NOTE_SIZE)
    for ax in axes[-1]:
        ax.set_xlabel("time for one wrench, seconds")
    for ax in axes[:, 0]:
        ax.set_ylabel("relative error")
    figure.legend(handles=handles(methods(data)), loc="upper center", ncols=5, fontsize=8)
    figure.text(
        0.5, 0.918, "Dotted: rounding of a double. Hairs lead from the least time to the median.",
        ha="center", fontsize=NOTE_SIZE, color=GREY,
    )  # fmt: skip
