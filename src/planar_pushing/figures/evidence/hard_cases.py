"""The hard cases: error of each in units in the last place, beside what its inputs' rounding costs."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from planar_pushing.figures.style import BLUE, GREY, VERMILION
from planar_pushing.mechanics.plane import Array

#: The hard places, in order of `line`.
PLACES = (
    "centre on\nthe ring",
    "translation,\nrotation",
    "lengths and\nproportions",
    "friction 0 to $\\infty$,\ncone edges",
    "slow and\nfast",
    "at\nrest",
    "slips that\nmerge",
)
#: Errors of at most this, zero included, are drawn here.
FLOOR = 0.01
#: Places kept free between two groups, in cases.
GAP = 4


def positions(lines: Array) -> Array:
    """Abscissa of each case: in order, with gaps between the groups."""
    return np.asarray(np.arange(lines.size) + GAP * (lines.astype(int) - 1))


def draw(figure: Figure, data: xr.Dataset) -> None:
    """Draw errors as dots and condition numbers as strokes, each group from best to worst condition."""
    data = data.isel(case=np.lexsort((data.condition.values, data.line.values)))
    ax = figure.add_axes((0.075, 0.15, 0.915, 0.67))
    at = positions(data.line.values)
    error = np.maximum(data.error_ulp.values, FLOOR)
    ill = data.ill_conditioned.values > 0
    ax.set(yscale="log", xlim=(at[0] - GAP / 2, at[-1] + GAP / 2), ylim=(FLOOR / 1.6, 1e15))
    ax.axhspan(FLOOR / 1.6, 4, color="#E3EEF6", zorder=0, lw=0, label="up to 4 units")
    ax.plot(
        at, np.maximum(data.condition, 1), "_", color=GREY, ms=3, mew=1.4,
        label="condition number: error that half an ulp in the inputs causes",
    )  # fmt: skip
    ax.plot(at[~ill], error[~ill], "o", color=BLUE, ms=2.6, mew=0, label="error")
    ax.plot(
        at[ill], error[ill], "D", color=VERMILION, ms=3.4, mew=0,
        label="error, ill-conditioned: rounding the inputs costs six digits or more",
    )  # fmt: skip
    _decorate(ax, data.line.values, at)
    ax.legend(
        loc="lower left", bbox_to_anchor=(0.0, 1.01), ncols=2, handletextpad=0.4, columnspacing=1.5
    )


def _decorate(ax: Axes, lines: Array, at: Array) -> None:
    middles = [at[lines == line].mean() for line in range(1, len(PLACES) + 1)]
    ax.set_xticks(middles, PLACES)
    ax.tick_params(axis="x", length=0)
    for line in range(2, len(PLACES) + 1):
        ax.axvline(at[lines == line][0] - (GAP + 1) / 2, color="#D0D0D0", lw=0.5, zorder=0)
    ax.set_yticks([1e-2, 1, 1e4, 1e8, 1e12], ["0", "1", "$10^4$", "$10^8$", "$10^{12}$"])
    ax.minorticks_off()
    ax.set_ylabel("units in the last place")
