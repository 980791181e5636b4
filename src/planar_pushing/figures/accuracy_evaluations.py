"""Accuracy of the friction wrench against evaluations at four spin ratios, the same on every run."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes

from planar_pushing.figures.figure import COLUMN, PAGE, Figure
from planar_pushing.figures.parts.methods import LIMITS, curves, methods, row_of_panels
from planar_pushing.mechanics.plane import Array

FIGURE = Figure(
    title="Error of the friction wrench against evaluations",
    reads=("accuracy_errors/wrench",),
    size=(PAGE, 2.7),
    column=(COLUMN, 4.6),
)
#: Abscissas: formulas evaluate no integrand and are drawn side by side in a separate strip.
STRIP = (0.03, 2.5)
END = 3e5


def abscissas(data: xr.Dataset, evaluations: Array) -> Array:
    """Evaluations of shape (point,), or a position in the strip for a method without an integrand."""
    formulas = [name for name in methods(data) if not evaluations[data.method.values == name].any()]
    places = dict(zip(formulas, np.geomspace(*STRIP, len(formulas)), strict=True))
    found = zip(data.method.values, evaluations, strict=True)
    return np.array([places.get(str(name), count) for name, count in found], dtype=float)


def caption(data: xr.Dataset) -> str:
    """Caption of the figure."""
    return (
        "Error of the friction wrench against evaluations of the integrand at four spin ratios k, "
        "with a marker for each setting of a method: stars are the closed form of this work, blue "
        "markers other formulas, brown markers quadrature rules, and hollow markers models. Formulas "
        "evaluate no integrand and are drawn in the gray strip; errors of zero and results of NaN "
        "are drawn at the ends of the axis. Dotted: rounding error of a double."
    )


def draw(figure: Any, data: xr.Dataset) -> None:
    """Draw four panels of error against evaluations with one legend."""
    row_of_panels(figure, data, "evaluations of the integrand", _panel)


def _panel(ax: Axes, one: xr.Dataset) -> Array:
    places = abscissas(one, one.evaluations.values)
    ax.axvspan(STRIP[0] / 2, STRIP[1] * 1.6, color="#F0F0F0", zorder=0, lw=0)
    curves(ax, one.method.values, places, one.error.values, LIMITS)
    ax.set(xlim=(STRIP[0] / 2, END))
    ax.set_xticks([np.sqrt(STRIP[0] * STRIP[1]), 1e1, 1e3, 1e5])
    ax.set_xticklabels(["none", "$10^1$", "$10^3$", "$10^5$"])
    ax.xaxis.get_gridlines()[0].set_visible(False)
    ax.minorticks_off()
    return places
