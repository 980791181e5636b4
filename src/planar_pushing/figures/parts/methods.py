"""Work-precision diagrams: error against cost, with a line per method and a marker per setting."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from planar_pushing.figures.axes import is_column
from planar_pushing.figures.colors import DARK, FORCE, GRAY, MOTION
from planar_pushing.figures.marks import NOTE
from planar_pushing.mechanics.plane import Array

#: Colors of the groups of methods: ours, other formulas, quadrature and root-finding rules, and models.
OURS, FORMULA, RULE = FORCE, MOTION, "#8F6400"
_MODEL: dict[str, Any] = {"markersize": 5, "markerfacecolor": "white"}
#: Marker and color of each method.
LOOKS: dict[str, dict[str, Any]] = {
    "closed form": {"marker": "*", "color": OURS, "markersize": 8, "zorder": 6},
    "hyp2f1": {"marker": "s", "color": FORMULA},
    "Carlson": {"marker": "D", "color": FORMULA},
    "textbook E and K": {"marker": "X", "color": FORMULA, "markersize": 5},
    "trapezoid": {"marker": "o", "color": RULE, "markersize": 3},
    "Gauss-Legendre": {"marker": "^", "color": RULE},
    "quad": {"marker": "v", "color": RULE},
    "tanhsinh": {"marker": "p", "color": RULE},
    "brentq on quad": {"marker": "v", "color": RULE},
    "find_root": {"marker": "*", "color": OURS, "markersize": 8, "zorder": 6},
    "linear table": {"marker": "o", "color": FORMULA},
    "cubic table": {"marker": "D", "color": FORMULA},
    "event-driven": {"marker": "*", "color": OURS, "markersize": 8, "zorder": 6},
    "time-stepping": {"marker": "o", "color": FORMULA},
    "ellipsoid": {"marker": "o", "color": GRAY, **_MODEL},
    "convex quartic": {"marker": "d", "color": DARK, **_MODEL},
}

#: Values at which relative errors of zero and NaN are marked.
LIMITS = (1e-19, 1e4)
#: Panel titles by spin ratio.
TITLES = {
    1e-8: r"$k = 10^{-8}$, almost a translation",
    0.1: r"$k = 0.1$",
    0.9: r"$k = 0.9$",
    1 - 1e-3: r"$k = 1 - 10^{-3}$",
    1 - 1e-9: r"$k = 1 - 10^{-9}$",
    1.0: r"$k = 1$, center on the ring",
    1 + 1e-9: r"$k = 1 + 10^{-9}$",
    3.0: r"$k = 3$",
    1e8: r"$k = 10^{8}$, almost a spin in place",
}
#: Spin ratios of a row of panels: regular, close to the ring, on the ring, a spin.
SHOWN = (0.1, 1 - 1e-9, 1.0, 1e8)

#: Factor by which the error axis extends beyond its limits, to keep marks there inside.
MARGIN = 6.0


def best(times: xr.DataArray) -> Array:
    """Shortest of the repeated times."""
    return np.asarray(times.min("repeat").values)


def row_of_panels(
    figure: Figure, data: xr.Dataset, costs: str, draw: Callable[[Axes, xr.Dataset], Array]
) -> None:
    """Draw a panel for each spin ratio of `SHOWN`, with one legend.

    `draw` draws the errors for one spin ratio and returns the costs at the markers, shape (point,);
    `costs` names the costs.
    """
    narrow = is_column(figure)
    axes = figure.subplots(*((2, 2) if narrow else (1, len(SHOWN))), sharey=True).ravel()
    edges = {"left": 0.16, "bottom": 0.13, "top": 0.78, "hspace": 0.38} if narrow else {
        "left": 0.085, "bottom": 0.15, "top": 0.77}  # fmt: skip
    figure.subplots_adjust(right=0.985, wspace=0.09, **edges)
    for ax, spin_ratio in zip(axes, SHOWN, strict=True):
        one = data.sel(spin_ratio=spin_ratio)
        mark_errors(ax, draw(ax, one), one.error.values)
        ax.set_title(TITLES[spin_ratio].partition(",")[0])
    for ax in axes[::2] if narrow else axes[:1]:
        ax.set_ylabel("relative error")
    figure.supxlabel(costs, fontsize=8.5, y=0.01)
    room: dict[str, Any] = (
        {"ncols": 3, "columnspacing": 0.8} if narrow else {"ncols": 5, "fontsize": 8}
    )
    figure.legend(handles=handles(methods(data)), loc="upper center", **room)


def mark_errors(ax: Axes, costs: Array, errors: Array) -> None:
    """Mark the rounding error of a double, the positions of zero and NaN, and each result of NaN."""
    ax.axhline(np.finfo(float).eps, color=GRAY, linewidth=0.6, linestyle=":")
    name_limits(ax, LIMITS)
    for row in np.flatnonzero(~np.isfinite(errors)):
        place = float(costs[row]), LIMITS[1]
        ax.annotate("NaN", place, (6, -3), textcoords="offset points", fontsize=NOTE)


def methods(data: xr.Dataset) -> list[str]:
    """Names of the methods in the order of the dataset."""
    return list(dict.fromkeys(map(str, data.method.values)))


def work_precision(
    ax: Axes, names: Array, times: xr.DataArray, errors: Array, limits: tuple[float, float]
) -> None:
    """Draw errors of shape (point,) against times of shape (point, repeat).

    A marker is at the shortest time, and a hair extends to the median.
    """
    low, middle = best(times), np.asarray(times.median("repeat").values)
    shown = within(errors, limits)
    for name in dict.fromkeys(names):
        rows = np.flatnonzero(names == name)
        color = LOOKS[str(name)]["color"]
        ax.hlines(shown[rows], low[rows], middle[rows], color=color, linewidth=0.6)
    curves(ax, names, low, errors, limits)


def within(errors: Array, limits: tuple[float, float]) -> Array:
    """Errors with zero at the lower limit and NaN at the upper limit."""
    return np.asarray(np.clip(np.nan_to_num(errors, nan=limits[1], posinf=limits[1]), *limits))


def name_limits(ax: Axes, limits: tuple[float, float]) -> None:
    """Label the positions of zero and NaN on the axis of relative errors."""
    ticks = 10.0 ** np.arange(-16, 1, 4)
    names = [f"$10^{{{power}}}$" for power in range(-16, 1, 4)]
    ax.set_yticks([limits[0], *ticks, limits[1]], ["0", *names, "NaN"])


def curves(ax: Axes, names: Array, x: Array, errors: Array, limits: tuple[float, float]) -> None:
    """Draw errors against costs of shape (point,), with a line per method and logarithmic axes."""
    shown = within(errors, limits)
    for name in dict.fromkeys(names):
        rows = np.flatnonzero(names == name)
        look = {"markersize": 4.0, "linewidth": 0.9, "clip_on": False, **LOOKS[str(name)]}
        ax.plot(x[rows], shown[rows], **look)
    ax.set(xscale="log", yscale="log", ylim=(limits[0] / MARGIN, limits[1] * MARGIN))
    ax.minorticks_off()
    ax.grid(True)
    ax.set_axisbelow(True)


def handles(names: list[str]) -> list[Line2D]:
    """Legend entries of methods."""
    options = {"markersize": 4.5, "linewidth": 0.9}
    return [Line2D([], [], label=name, **{**options, **LOOKS[name]}) for name in names]


def count_text(value: float) -> str:
    """Whole number with separated thousands."""
    return f"{value:,.0f}".replace(",", "\N{THIN SPACE}")


def setting_text(value: float) -> str:
    """Setting of a method: a count, or a tolerance as a power of ten."""
    if value >= 1:
        return count_text(value)
    mantissa, power = f"{value:.0e}".split("e")
    factor = "" if mantissa == "1" else rf"{mantissa} \times "
    return rf"${factor}10^{{{int(power)}}}$"


def name_ends(
    ax: Axes, data: xr.Dataset, quantity: str, named: Mapping[str, tuple[str, str]]
) -> None:
    """Write the first and the last setting of some methods beside their markers.

    `named` gives, for each method, the format of a setting and the horizontal alignment of the text.
    """
    for name, (words, side) in named.items():
        for row in np.flatnonzero(data.method.values == name)[[0, -1]]:
            times = data[f"{quantity}_seconds"][row]
            place, away = (times.min(), -8) if side == "right" else (times.median(), 8)
            ax.annotate(
                words.format(setting_text(float(data.setting[row]))),
                (float(place), float(data[f"{quantity}_error"][row])), (away, 0),
                textcoords="offset points", ha=side, va="center", color=GRAY, fontsize=NOTE - 1,
            )  # fmt: skip


def note(ax: Axes, x: float, y: float, text: str, **options: Any) -> None:
    """Write a small note at data coordinates."""
    ax.text(x, y, text, fontsize=NOTE, color=DARK, **options)
