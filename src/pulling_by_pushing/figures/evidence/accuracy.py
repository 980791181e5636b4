"""Accuracy against time: the friction wrench above, motion cones and motion over time below."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes

from planar_pushing.drawing.canvas.colors import DARK, GRAY
from planar_pushing.drawing.canvas.marks import NOTE
from planar_pushing.drawing.canvas.style import PAGE
from planar_pushing.mechanics.plane import Array
from pulling_by_pushing.figures.figure import Data, Figure
from pulling_by_pushing.figures.parts.methods import (
    Label,
    handles,
    label_settings,
    mark_calls,
    methods,
    with_times,
    work_precision,
)
from pulling_by_pushing.figures.studies import NUMBERS

QUANTITIES = ("wrench", "cone", "motion")
FIGURE = Figure(
    title="What accuracy costs in time",
    reads=tuple(f"{stem}/{name}" for name in QUANTITIES for stem in ("accuracy", "accuracy_time")),
    size=(PAGE, 4.1),
)
#: Spin ratios of the panels: nearly a translation, regular, close to the ring, on the ring.
SPIN_RATIOS = {
    1e-8: "$k = 10^{-8}$",
    0.1: "$k = 0.1$",
    1 - 1e-9: "$k = 1 - 10^{-9}$",
    1.0: "$k = 1$",
}
#: Largest error of the ring's ellipsoid at an edge of a cone of any rod, degrees; it is not attained.
ELLIPSOID_LIMIT = float(np.rad2deg(np.arcsin(1 / 3)))
#: Titles of the panels of motions, by scene.
SCENES = {"slipping": "motion: a slip in one mode", "pulling": "motion: a pull, the fence turns"}
#: Values at which errors of zero and NaN are drawn: relative ones, and those in degrees.
RELATIVE, DEGREES = (1e-18, 1e3), (1e-15, 1e2)
#: Factors by which the axes of times extend beyond the fastest and the slowest method, for a wrench, a cone
#: and a run; those of a run leave room for labels.
BEYOND = {"wrench": (2.5, 2.5), "cone": (2.5, 4.0), "motion": (40.0, 8.0)}
#: Lower and upper ends of the rows, as fractions of the figure's height.
ROWS = ((0.6, 0.885), (0.095, 0.425))
#: Names of methods and of their settings in the lower row.
LABELS = {
    "closed form": (Label(0, "closed form", (-8, 9)),),
    "ellipsoid": (Label(0, "ellipsoid", (7, -6)),),
    "brentq on quad": (Label(2, "brentq on quad", (-7, 0), "right"),
                       Label(0, "tolerance {}", (-7, 0), "right"), Label(-1, "{}", (-7, 0), "right")),
    "event-driven": (Label(0, "tolerance {}", (-7, 0), "right"), Label(-1, "{}", (-7, 0), "right"),
                     Label(0, "event-driven", (-7, 9), "right")),
    "time-stepping": (Label(0, "time-stepping", (-4, 8)), Label(0, "{} steps", (9, 0)),
                      Label(-1, "{}", (9, 0))),
}  # fmt: skip


def caption(data: Data) -> str:
    """Caption of the figure."""
    return (
        "Error against computing time for each setting of a method. Top: the friction wrench, from "
        "nearly a translation, k = 1e-8, to a rotation about a point of the ring, k = 1; dotted: "
        "rounding error of a double. Bottom: edges of motion cones, dashed the limit for the "
        f"ellipsoid, and the last rod angle of a slip (Fig. {NUMBERS['slip_over_time']}) and of a pull "
        "by a fence that turns from 10° to −10°; dotted: a call for a run without duration. Filled "
        "stars are this work in arrays or batches, hollow ones a call for one result; quad, brentq "
        "and time stepping are calls, other methods arrays. Hairs extend to medians of repeated runs."
    )


def draw(figure: Any, data: Data) -> None:
    """Draw the panels of the wrench with a legend, and below those of cones and motions."""
    wrench, cone, motion = (with_times(data, quantity) for quantity in QUANTITIES)
    _draw_wrenches(
        _row(figure, len(SPIN_RATIOS), *ROWS[0]), wrench.sel(spin_ratio=list(SPIN_RATIOS))
    )
    columns = _row(figure, 1 + len(SCENES), *ROWS[1])
    _draw_degrees(columns[0], cone, cone.cone_seconds, "cone", "both edges of a motion cone")
    for ax, (scene, title) in zip(columns[1:], SCENES.items(), strict=True):
        part = motion.sel(scene=scene)
        _draw_degrees(ax, part, motion.motion_seconds, "motion", title)
        ax.axvline(
            float(part.log_seconds.min()), color=GRAY, linewidth=0.8, linestyle=":", zorder=1
        )
    _mark_limit(columns[0])
    columns[0].set_ylabel("error (degrees)")
    columns[0].set_xlabel("time for a cone (s)")
    for ax in columns[1:]:
        ax.set_xlabel("time for a run (s)")
    middle = figure.subplotpars.left / 2 + figure.subplotpars.right / 2
    figure.text(middle, ROWS[0][0] - 0.085, "time for a wrench (s)", ha="center", fontsize=8.5)
    entries = handles(methods(wrench))
    figure.legend(handles=entries, loc="upper center", ncols=len(entries), handlelength=1.8,
                  handletextpad=0.4, columnspacing=0.9)  # fmt: skip


def _row(figure: Any, count: int, low: float, high: float) -> Array:
    """Panels side by side, with one axis of errors."""
    grid = figure.add_gridspec(1, count, left=0.085, right=0.985, bottom=low, top=high, wspace=0.09)
    row: Array = grid.subplots(sharey=True)
    return row


def _draw_wrenches(row: Array, data: xr.Dataset) -> None:
    """Draw a panel for each spin ratio."""
    for ax, (spin_ratio, title) in zip(row, SPIN_RATIOS.items(), strict=True):
        part = data.sel(spin_ratio=spin_ratio)
        errors, times = part.wrench_error.values, part.wrench_seconds
        work_precision(ax, part.method.values, times, errors, RELATIVE)
        mark_calls(ax, part, "wrench", RELATIVE)
        ax.axhline(np.finfo(float).eps, color=GRAY, linewidth=0.6, linestyle=":")
        _name_nans(ax, times.min("repeat").values, errors)
        ax.set_title(title)
        ax.set(
            xticks=10.0 ** np.arange(-7, -2, 2), xlim=_time_limits(data.wrench_seconds, "wrench")
        )
    powers = range(-16, 1, 4)
    zero = {RELATIVE[0]: "0"} if (data.wrench_error == 0).any() else {}
    ticks = zero | {10.0**power: f"$10^{{{power}}}$" for power in powers}
    row[0].set_yticks(list(ticks), list(ticks.values()))
    row[0].set_ylabel("relative error")


def _name_nans(ax: Axes, times: Array, errors: Array) -> None:
    """Write NaN beside the markers without a value."""
    for row in np.flatnonzero(~np.isfinite(errors)):
        marker = float(times[row]), RELATIVE[1]
        ax.annotate("NaN", marker, (6, -3), textcoords="offset points", fontsize=NOTE)


def _draw_degrees(
    ax: Axes, part: xr.Dataset, times: xr.DataArray, quantity: str, title: str
) -> None:
    """Draw a panel with errors in degrees, over the range of some times, with labeled methods."""
    errors = part[f"{quantity}_error"].values
    work_precision(ax, part.method.values, part[f"{quantity}_seconds"], errors, DEGREES)
    mark_calls(ax, part, quantity, DEGREES)
    ax.set_title(title)
    ax.set_xlim(_time_limits(times, quantity))
    ax.set_yticks(10.0 ** np.arange(-14, 3, 4))
    label_settings(ax, part, quantity, {name: LABELS[name] for name in methods(part)})


def _mark_limit(ax: Axes) -> None:
    """Mark the largest error of the ellipsoid at an edge of a cone."""
    ax.axhline(ELLIPSOID_LIMIT, color=GRAY, linewidth=0.8, linestyle=(0, (5, 2)), zorder=1)
    ax.annotate(
        r"$\arcsin(1/3)$", (1.0, ELLIPSOID_LIMIT), (-3, -2), xycoords=("axes fraction", "data"),
        textcoords="offset points", ha="right", va="top", fontsize=NOTE, color=DARK,
    )  # fmt: skip


def _time_limits(times: xr.DataArray, quantity: str) -> tuple[float, float]:
    low, high = BEYOND[quantity]
    return float(times.min()) / low, float(times.median("repeat").max()) * high
