"""Work-precision diagrams: error against time, with a line per method and a marker per setting."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, NamedTuple

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from planar_pushing.drawing.canvas.colors import DARK, FORCE, GRAY, MOTION
from planar_pushing.drawing.canvas.marks import NOTE
from planar_pushing.mechanics.plane import Array
from pulling_by_pushing.figures.figure import Data

#: Colors of the groups of methods: ours, other formulas, and quadrature rules, each with its dashes.
OURS, FORMULA = FORCE, MOTION
TRAPEZOID, GAUSS, ADAPTIVE = "#8F6400", "#1B7837", "#8A3C70"
HOLLOW = {"markerfacecolor": "white", "markeredgewidth": 0.9}
_OURS: dict[str, Any] = {"marker": "*", "color": OURS, "markersize": 8, "zorder": 6}
_ADAPTIVE: dict[str, Any] = {"marker": "v", "color": ADAPTIVE, "linestyle": (0, (1, 1.2))}
#: Marker, line and color of each method.
LOOKS: dict[str, dict[str, Any]] = {
    "closed form": {**_OURS, "linestyle": "none"},
    "hyp2f1": {"marker": "s", "color": FORMULA, "linestyle": "none"},
    "Carlson": {"marker": "D", "color": FORMULA, "linestyle": "none", **HOLLOW},
    "textbook E and K": {"marker": "X", "color": FORMULA, "linestyle": "none", "markersize": 5},
    "trapezoid": {"marker": ".", "color": TRAPEZOID, "markersize": 5},
    "Gauss-Legendre": {"marker": "^", "color": GAUSS, "linestyle": (0, (4, 1.5)), **HOLLOW},
    "quad": _ADAPTIVE,
    "brentq on quad": _ADAPTIVE,
    "event-driven": _OURS,
    "time-stepping": {"marker": "o", "color": FORMULA, "linestyle": (0, (5, 1.5))},
    "ellipsoid": {"marker": "o", "color": GRAY, "linestyle": "none", "markersize": 5, **HOLLOW},
}
#: Methods of this work, and the look of their calls for one result.
OUR_METHODS = ("closed form", "event-driven")
CALL: dict[str, Any] = {**_OURS, **HOLLOW, "linestyle": "none", "markersize": 7, "clip_on": False}
#: Factor by which the error axis extends beyond its limits, to keep marks there inside.
MARGIN = 6.0


def methods(data: xr.Dataset) -> list[str]:
    """Names of the methods in the order of the dataset."""
    return list(dict.fromkeys(map(str, data.method.values)))


def with_times(data: Data, quantity: str) -> xr.Dataset:
    """Errors of the methods for a quantity with their times: in arrays, or else in calls, and in calls."""
    errors: xr.Dataset = data[f"accuracy/{quantity}"]
    times = data[f"accuracy_time/{quantity}"]
    calls = times[f"{quantity}_call_seconds"]
    seconds = times.assign({f"{quantity}_seconds": times[f"{quantity}_seconds"].fillna(calls)})
    return errors.assign({name: seconds[name].variable for name in seconds.data_vars})


def mark_calls(ax: Axes, data: xr.Dataset, quantity: str, limits: tuple[float, float]) -> None:
    """Mark the shortest time of our methods in a call for one result."""
    rows = np.flatnonzero(np.isin(data.method.values, OUR_METHODS))
    calls = data.isel(point=rows)
    ax.plot(
        calls[f"{quantity}_call_seconds"].min("repeat"),
        within(calls[f"{quantity}_error"].values, limits),
        **CALL,
    )


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
    entries = [Line2D([], [], label=name, **{**options, **LOOKS[name]}) for name in names]
    return [entries[0], Line2D([], [], label="one call", **CALL), *entries[1:]]


def setting_text(value: float) -> str:
    """Setting of a method: a count with separated thousands, or a tolerance as a power of ten."""
    if value >= 1:
        return f"{value:,.0f}".replace(",", "\N{THIN SPACE}")
    return rf"$10^{{{round(np.log10(value))}}}$"


class Label(NamedTuple):
    """Text beside the marker of a setting, which is the row of its method; offset of the text, points.

    Braces in the text stand for the setting. A text level with its marker starts beyond the hair.
    """

    row: int
    text: str
    offset: tuple[float, float]
    align: str = "left"


def label_settings(
    ax: Axes, data: xr.Dataset, quantity: str, labels: Mapping[str, Iterable[Label]]
) -> None:
    """Write the labels of methods beside their markers."""
    for name, texts in labels.items():
        rows = np.flatnonzero(data.method.values == name)
        for row, text, offset, align in texts:
            point = data.isel(point=rows[row])
            times = point[f"{quantity}_seconds"]
            time = times.median() if align == "left" and not offset[1] else times.min()
            words = text.format(setting_text(float(point.setting))) if "{}" in text else text
            ax.annotate(
                words, (float(time), float(point[f"{quantity}_error"])), offset,
                textcoords="offset points", ha=align, va="center", color=DARK, fontsize=NOTE,
            )  # fmt: skip
