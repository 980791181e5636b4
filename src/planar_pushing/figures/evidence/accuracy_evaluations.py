"""What accuracy costs in evaluations: the friction wrench at four spin ratios, the same on every run."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from planar_pushing.figures.evidence.accuracy_wrench import LIMITS, TITLES
from planar_pushing.figures.evidence.work_precision import curves, handles, methods, name_limits
from planar_pushing.figures.style import GREY, NOTE_SIZE
from planar_pushing.mechanics.plane import Array

#: Places of the spin ratios among those of the dataset: regular, next to the ring, on it, a spin.
SHOWN = (1, 4, 5, 8)
#: Abscissas: formulas evaluate no integrand and stand side by side in a strip of their own.
STRIP = (0.03, 2.5)
END = 3e5


def abscissas(data: xr.Dataset, evaluations: Array) -> Array:
    """Evaluations of shape (point,), or a place in the strip for a method without an integrand."""
    formulas = [name for name in methods(data) if not evaluations[data.method.values == name].any()]
    places = dict(zip(formulas, np.geomspace(*STRIP, len(formulas)), strict=True))
    found = zip(data.method.values, evaluations, strict=True)
    return np.array([places.get(str(name), count) for name, count in found], dtype=float)


def draw(figure: Figure, data: xr.Dataset) -> None:
    """Draw four panels of error against evaluations with one legend."""
    axes = figure.subplots(1, len(SHOWN), sharey=True)
    figure.subplots_adjust(left=0.085, right=0.985, bottom=0.15, top=0.77, wspace=0.09)
    for ax, index in zip(axes, SHOWN, strict=True):
        one = data.isel(spin_ratio=index)
        places = abscissas(data, one.evaluations.values)
        curves(ax, data.method.values, places, one.error.values, LIMITS)
        ax.set_title(TITLES[index].partition(",")[0])
        _decorate(ax)
        for row in np.flatnonzero(~np.isfinite(one.error.values)):
            place = float(places[row]), LIMITS[1]
            ax.annotate("NaN", place, (6, -3), textcoords="offset points", fontsize=NOTE_SIZE)
    axes[0].set_ylabel("relative error")
    figure.supxlabel("evaluations of the integrand", fontsize=9, y=0.01)
    figure.legend(handles=handles(methods(data)), loc="upper center", ncols=5, fontsize=8)


def _decorate(ax: Axes) -> None:
    ax.axvspan(STRIP[0] / 2, STRIP[1] * 1.6, color="#F0F0F0", zorder=0, lw=0)
    ax.axhline(np.finfo(float).eps, color=GREY, linewidth=0.6, linestyle=":")
    ax.set(xlim=(STRIP[0] / 2, END))
    name_limits(ax, LIMITS)
    ax.set_xticks([np.sqrt(STRIP[0] * STRIP[1]), 1e1, 1e3, 1e5])
    ax.set_xticklabels(["none", "$10^1$", "$10^3$", "$10^5$"])
    ax.xaxis.get_gridlines()[0].set_visible(False)
    ax.minorticks_off()
