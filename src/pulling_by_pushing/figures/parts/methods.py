"""Work-precision diagrams: error against time, with a line per method and a marker per setting."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from planar_pushing.drawing.canvas.colors import FORCE, GRAY, MOTION
from planar_pushing.drawing.canvas.marks import NOTE
from planar_pushing.mechanics.plane import Array
from pulling_by_pushing.figures.figure import Data

#: Colors of the groups of methods: ours, other formulas, and quadrature rules.
OURS, FORMULA, RULE = FORCE, MOTION, "#8F6400"
_OURS: dict[str, Any] = {"marker": "*", "color": OURS, "markersize": 8, "zorder": 6}
#: Marker and color of each method.
LOOKS: dict[str, dict[str, Any]] = {
    "closed form": _OURS,
    "hyp2f1": {"marker": "s", "color": FORMULA},
    "Carlson": {"marker": "D", "color": FORMULA},
    "textbook E and K": {"marker": "X", "color": FORMULA, "markersize": 5},
    "trapezoid": {"marker": "o", "color": RULE, "markersize": 3},
    "Gauss-Legendre": {"marker": "^", "color": RULE},
    "quad": {"marker": "v", "color": RULE},
    "brentq on quad": {"marker": "v", "color": RULE},
    "event-driven": _OURS,
    "time-stepping": {"marker": "o", "color": FORMULA},
    "ellipsoid": {"marker": "o", "color": GRAY, "markersize": 5, "markerfacecolor": "white"},
}
#: Factor by which the error axis extends beyond its limits, to keep marks there inside.
MARGIN = 6.0


def methods(data: xr.Dataset) -> list[str]:
    """Names of the methods in the order of the dataset."""
    return list(dict.fromkeys(map(str, data.method.values)))


def with_times(data: Data, quantity: str) -> xr.Dataset:
    """Errors of the methods for a quantity with their times."""
    errors: xr.Dataset = data[f"accuracy/{quantity}"]
    times = data[f"accuracy_time/{quantity}"]
    seconds = {name: variable.variable for name, variable in times.data_vars.items()}
    return errors.assign(seconds)


def work_precision(
    ax: Axes, names: Array, times: xr.DataArray, errors: Array, limits: tuple[float, float]
) -> None:
    """Draw errors of shape (point,) against times of shape (point, repeat) on logarithmic axes.

    A marker is at the shortest time, and a hair extends to the median; each method has a line.
    """
    shortest, median = times.min("repeat").values, times.median("repeat").values
    drawn = within(errors, limits)
    for name in dict.fromkeys(names):
        rows = np.flatnonzero(names == name)
        look = {"markersize": 4.0, "linewidth": 0.9, "clip_on": False, **LOOKS[str(name)]}
        ax.hlines(drawn[rows], shortest[rows], median[rows], color=look["color"], linewidth=0.6)
        ax.plot(shortest[rows], drawn[rows], **look)
    ax.set(xscale="log", yscale="log", ylim=(limits[0] / MARGIN, limits[1] * MARGIN))
    ax.minorticks_off()
    ax.grid(True)
    ax.set_axisbelow(True)


def within(errors: Array, limits: tuple[float, float]) -> Array:
    """Errors with zero at the lower limit and NaN at the upper limit."""
    return np.asarray(np.clip(np.nan_to_num(errors, nan=limits[1], posinf=limits[1]), *limits))


def handles(names: list[str]) -> list[Line2D]:
    """Legend entries of methods."""
    options = {"markersize": 4.5, "linewidth": 0.9}
    return [Line2D([], [], label=name, **{**options, **LOOKS[name]}) for name in names]


def setting_text(value: float) -> str:
    """Setting of a method: a count with separated thousands, or a tolerance as a power of ten."""
    if value >= 1:
        return f"{value:,.0f}".replace(",", "\N{THIN SPACE}")
    return rf"$10^{{{round(np.log10(value))}}}$"


def name_ends(
    ax: Axes, data: xr.Dataset, quantity: str, named: Mapping[str, tuple[str, str]]
) -> None:
    """Write the first and the last setting of some methods beside their markers.

    `named` gives, for each method, the format of a setting and the horizontal alignment of the text.
    """
    for name, (words, side) in named.items():
        for row in np.flatnonzero(data.method.values == name)[[0, -1]]:
            times = data[f"{quantity}_seconds"][row]
            time, offset = (times.min(), -8) if side == "right" else (times.median(), 8)
            ax.annotate(
                words.format(setting_text(float(data.setting[row]))),
                (float(time), float(data[f"{quantity}_error"][row])), (offset, 0),
                textcoords="offset points", ha=side, va="center", color=GRAY, fontsize=NOTE - 1,
            )  # fmt: skip
