"""An assessment of a push in three panels: effects, methods, inputs."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.ticker import LogLocator, NullLocator

from planar_pushing.drawing.canvas.colors import DARK, FORCE, GRAY, LIGHT, MOTION
from planar_pushing.drawing.canvas.marks import NOTE
from planar_pushing.drawing.canvas.style import PAGE, paper_style
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.numbers import Array
from planar_pushing.terms.options import Method

#: Width and height of the figure, inches; left edges and widths of the axes, and their bottom and height,
#: as fractions.
SIZE = (PAGE, 2.3)
LEFT, WIDTH, BOTTOM, HEIGHT = (0.125, 0.42, 0.815), (0.19, 0.19, 0.175), 0.19, 0.66
#: Colors and markers of the methods.
METHODS = {Method.EVENT_DRIVEN: (MOTION, "o"), Method.TIME_STEPPING: (FORCE, "s")}
#: Changes below this part of the tolerance are drawn at the edge.
SMALL = 1e-4


def plot_assessment(
    effects: xr.Dataset,
    methods: xr.Dataset,
    inputs: xr.Dataset,
    tolerance: float,
    unit: tuple[float, str],
    axes: Sequence[Axes] | None = None,
) -> list[Axes]:
    """Draw what effects change, what accuracy costs, and how sure the pose is.

    Parameters
    ----------
    effects, methods, inputs : xarray.Dataset
        Those of a `PushAssessment`.
    tolerance : float
        In the scene's unit of length.
    unit : (factor, name)
        Unit of lengths in the picture, and its factor.
    axes : sequence of three matplotlib.axes.Axes, optional
        By default those of a new figure.

    Returns
    -------
    list of matplotlib.axes.Axes

    Raises
    ------
    InvalidValue
        If the number of axes is wrong.
    """
    with paper_style():
        three = _new_axes() if axes is None else _require_axes(axes)
        limit = tolerance * unit[0]
        _draw_effects(three[0], effects, limit, unit)
        _draw_methods(three[1], methods, limit, unit)
        _draw_inputs(three[2], inputs, limit, unit)
    return three


def _draw_effects(ax: Axes, effects: xr.Dataset, limit: float, unit: tuple[float, str]) -> None:
    """A row for each effect: the change of the pose without it, and its estimate."""
    names = [str(name).replace("_", " ") for name in effects["effect"].values]
    change = effects["pose_change_near"].values * unit[0]
    estimate = effects["estimate"].values * unit[0]
    known = np.concatenate([change, estimate, [limit]])
    known = known[np.isfinite(known) & (known > SMALL * limit)]
    low, high = known.min() / 3.0, known.max() * 3.0
    for row, needed in enumerate(effects["needed"].values):
        color = FORCE if needed else GRAY
        end = float(np.clip(change[row], low, high))
        ax.plot([low, end], [row, row], color=color, lw=1.6, solid_capstyle="butt")
        ax.plot(end, row, "o" if np.isfinite(change[row]) else ">", color=color, clip_on=False)
        if np.isfinite(estimate[row]) and estimate[row] > low:
            ax.plot(estimate[row], row, "|", color=DARK, ms=9, mew=1.2)
        verdict = "list it" if needed else "leave it out"
        ax.annotate(verdict, (1.0, row), (0, 4), xycoords=("axes fraction", "data"),
                    textcoords="offset points", fontsize=NOTE - 0.5, color=color, ha="right")  # fmt: skip
    ax.axvline(limit, color=GRAY, lw=0.8, ls=":")
    ax.set(xscale="log", xlim=(low, high), ylim=(len(names) - 0.4, -0.7))
    ax.set_yticks(range(len(names)), names)
    ax.tick_params(axis="y", length=0)
    _few_ticks(ax, "x")
    ax.set_xlabel(f"pose without it ({unit[1]}); | estimate")
    ax.set_title("(a) effects", loc="left")


def _draw_methods(ax: Axes, methods: xr.Dataset, limit: float, unit: tuple[float, str]) -> None:
    """Error over the time of a run, for both methods."""
    milliseconds = np.maximum(methods["seconds"].values * 1e3, 1e-3)
    error = np.maximum(methods["error"].values * unit[0], SMALL**2 * limit)
    kinds = methods["method"].values
    for kind, (color, marker) in METHODS.items():
        rows = kinds == str(kind)
        ax.plot(milliseconds[rows], error[rows], marker + "-", color=color, lw=0.8, ms=3.2)
        first = int(np.flatnonzero(rows)[0])
        above = kind == Method.TIME_STEPPING
        ax.annotate(str(kind), (milliseconds[first], error[first]), (5, 3 if above else -2),
                    textcoords="offset points", fontsize=NOTE - 0.5, color=color,
                    va="bottom" if above else "center")  # fmt: skip
    best = int(methods.attrs["cheapest"])
    if best >= 0:
        ax.plot(milliseconds[best], error[best], "o", mfc="none", mec=DARK, ms=8, mew=0.8)
    log = methods.attrs["log_seconds"] * 1e3
    ax.axvline(log, color=LIGHT, lw=1.6)
    ax.axhline(limit, color=GRAY, lw=0.8, ls=":")
    right = max(log, *milliseconds) * 3.0
    ax.set(xscale="log", yscale="log", xlim=(min(milliseconds) / 2.0, right))
    ax.annotate("its log", (log, 0.02), (2, 0), xycoords=("data", "axes fraction"), rotation=90,
                textcoords="offset points", fontsize=NOTE - 0.5, color=GRAY, va="bottom")  # fmt: skip
    _few_ticks(ax, "x")
    _few_ticks(ax, "y")
    ax.set(xlabel="time of a run (ms)", ylabel=f"error ({unit[1]})")
    ax.set_title("(b) methods", loc="left")


def _draw_inputs(ax: Axes, inputs: xr.Dataset, limit: float, unit: tuple[float, str]) -> None:
    """A row for each input: the change of the pose if it is off to either side."""
    names = [str(name) for name in inputs["input"].values]
    change: Array = inputs["change"].values * unit[0]
    for row, sides in enumerate(change):
        for side, offset in zip(sides, (-0.16, 0.16), strict=True):
            ax.barh(row + offset, np.nan_to_num(side), 0.26, color=MOTION if offset < 0 else LIGHT)
    ax.axvline(limit, color=GRAY, lw=0.8, ls=":")
    high = 1.1 * max(float(np.nanmax(change)), limit)
    ax.set(xlim=(0.0, high), ylim=(len(names) - 0.4, -0.7))
    ax.set_yticks(range(len(names)), names)
    ax.tick_params(axis="y", length=0)
    ax.locator_params(axis="x", nbins=4)
    part = f"{inputs.attrs['change_of_inputs'] * 100:g} %"
    ax.set_xlabel(f"final pose ({unit[1]}), {part} off")
    ax.set_title("(c) inputs", loc="left")


def _few_ticks(ax: Axes, axis: str) -> None:
    """Few ticks on a logarithmic axis."""
    of = ax.xaxis if axis == "x" else ax.yaxis
    of.set_major_locator(LogLocator(numticks=5))
    of.set_minor_locator(NullLocator())


def _new_axes() -> list[Axes]:
    """Axes side by side on a figure that notebooks and windows display."""
    import matplotlib.pyplot as plt

    figure = plt.figure(figsize=SIZE)
    return [
        figure.add_axes((left, BOTTOM, width, HEIGHT))
        for left, width in zip(LEFT, WIDTH, strict=True)
    ]


def _require_axes(axes: Any) -> list[Axes]:
    """Return the given axes, or raise `InvalidValue`."""
    three = list(np.ravel(np.asarray(axes, dtype=object)))
    if len(three) != len(LEFT) or not all(isinstance(axis, Axes) for axis in three):
        raise InvalidValue("axes", f"{len(three)} axes", "three axes of matplotlib", "or give none")
    return three
