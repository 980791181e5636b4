"""Cost of effects in time: by the effects that a scene lists, and by their number."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.ticker import LogLocator

from planar_pushing.drawing.canvas.colors import CENTER, GRAY, MOTION
from planar_pushing.drawing.canvas.marks import NOTE
from planar_pushing.drawing.canvas.style import PAGE
from pulling_by_pushing.figures.figure import Data, Figure

FIGURE = Figure(
    title="Cost of the effects in time",
    reads=("effects",),
    size=(PAGE, 2.2),
)
#: Sets of effects that a scene lists, from the top of a row: name, color, marker and its face.
LISTS = {
    "support_friction": ("support friction", MOTION, "o", MOTION),
    "inertia": ("inertia", "#8F6400", "s", "white"),
    "support_friction+inertia": ("both", CENTER, "D", CENTER),
}
#: Names of the timed computations, from the top.
COMPUTATIONS = {
    "motion cone": "motion cone",
    "contact modes": "contact modes of a push",
    "limit curve": "limit curve, 361 points",
    "event-driven": "run, event-driven",
    "time-stepping": "run, time-stepping",
}
#: Distance of the marks in a row, in rows.
SPACING = 0.26


def caption(data: Data) -> str:
    """Caption of the figure."""
    return (
        "What effects cost. Left: shortest time of repeated calls for a scene that lists support friction, "
        "inertia, or both; an effect that is not listed is never evaluated. Right: time of a time-stepping "
        "run whose support friction is divided among equal effects, against their number; dotted: "
        "proportional to the number."
    )


def draw(figure: Any, data: Data) -> None:
    """Draw times by the listed effects as marks, and times by their number as a line."""
    costs = data["effects"]
    left, right = figure.subplots(1, 2, width_ratios=(1.35, 1))
    figure.subplots_adjust(left=0.19, right=0.98, bottom=0.175, top=0.89, wspace=0.22)
    _draw_times(left, costs.computation_seconds.min("repeat"))
    _draw_times_by_number(right, costs.supports_seconds.min("repeat"))


def _draw_times(ax: Axes, times: xr.DataArray) -> None:
    """Draw a row for each computation, with a mark for each list of effects."""
    rows = np.arange(len(COMPUTATIONS))
    for i, (effects, (name, color, marker, face)) in enumerate(LISTS.items()):
        durations = 1e3 * times.sel(effects=effects, computation=list(COMPUTATIONS)).values
        ax.plot(durations, rows + (i - 1) * SPACING, marker, color=color, markerfacecolor=face,
                markersize=4.0, label=name)  # fmt: skip
    ax.set_yticks(rows, list(COMPUTATIONS.values()))
    ax.tick_params(axis="y", length=0)
    ax.set(xscale="log", xlabel="time (ms)", ylim=(len(rows) - 0.5, -0.5))
    ax.xaxis.set_major_formatter("{x:g}")
    ax.grid(True, axis="x")
    for row in rows[1:]:
        ax.axhline(row - 0.5, color="#D0D0D0", linewidth=0.4, zorder=0)
    ax.set_axisbelow(True)
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 0.99), ncols=len(LISTS), handletextpad=0.2)


def _draw_times_by_number(ax: Axes, times: xr.DataArray) -> None:
    """Draw the times by the number of effects, and those that would be proportional to it."""
    numbers, milliseconds = times.supports.values, 1e3 * times.values
    ax.plot(numbers, milliseconds[0] * numbers / numbers[0], ":", color=GRAY)
    ax.plot(numbers, milliseconds, "o-", color=MOTION, markersize=4.0)
    ax.annotate("proportional", (numbers[-1], milliseconds[0] * numbers[-1] / numbers[0]), (-8, -2),
                textcoords="offset points", ha="right", va="center", color=GRAY, fontsize=NOTE)  # fmt: skip
    ax.set_xscale("log", base=2)
    ax.set_xticks(numbers, [f"{number}" for number in numbers])
    ax.set_yscale("log")
    ax.yaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    ax.minorticks_off()
    ax.yaxis.set_major_formatter("{x:g}")
    ax.set(xlabel="number of listed effects", ylabel="time for a run (ms)")
    ax.grid(True)
    ax.set_axisbelow(True)
