"""Cost of each effect: evaluations in motion over time, and times by the effects and their number."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.patches import Patch

from planar_pushing.drawing.canvas.colors import DARK
from planar_pushing.drawing.canvas.style import PAGE
from pulling_by_pushing.figures.figure import Data, Figure

FIGURE = Figure(
    title="Costs of the effects",
    reads=("effects",),
    size=(PAGE, 3.4),
)
#: Sets of effects that a scene lists, from the top: name, color and marker.
LISTS = {
    "support_friction": ("friction", "#0072B2", "o"),
    "inertia": ("inertia", "#D9A441", "s"),
    "support_friction+inertia": ("both", "#8A3C70", "D"),
}
#: Name, color of the bar, and color of the number of each effect that is counted.
EFFECTS = {
    "support_friction": ("support friction", "#0072B2", "white"),
    "inertia": ("inertia", "#D9A441", DARK),
}
#: Titles of the panels of counts, by the method of the motion.
PANELS = {
    "event-driven": "evaluations, motion by events",
    "time-stepping": "evaluations, motion by steps",
}
#: Names of the timed computations, from the top.
COMPUTATIONS = {
    "motion cone": "motion cone",
    "limit curve": "limit curve, 361 points",
    "contact modes": "contact modes of a push",
    "event-driven": "motion by events",
    "time-stepping": "motion by steps",
}
#: Height of a bar, and distance of the marks in a row.
HEIGHT, APART = 0.8, 0.26


def caption(data: Data) -> str:
    """Caption of the figure."""
    return (
        "Only the effects that a scene lists are computed. Top: evaluations of support friction and of "
        "inertia in the log of a motion over time, for scenes that list support friction, inertia, or "
        "both. An effect that is not listed has none. A step evaluates the motion once; the event-driven "
        "method chooses its steps by the motion. Bottom left: shortest time of repeated runs for the same "
        "three lists. Bottom right: time for a run by steps with friction divided among equal supports, "
        "in units of that with one support; dotted: proportional to the number of supports."
    )


def draw(figure: Any, data: Data) -> None:
    """Draw the counts as bars, the times as marks, and the times by the number of supports as a line."""
    costs = data["effects"]
    grid = figure.add_gridspec(2, 2, height_ratios=(1, 1.7), width_ratios=(1.35, 1))
    figure.subplots_adjust(left=0.19, right=0.98, bottom=0.125, top=0.87, hspace=0.3, wspace=0.25)
    for column, (method, title) in enumerate(PANELS.items()):
        ax = figure.add_subplot(grid[0, column])
        _counts(ax, costs.evaluations.sel(integrator=method))
        ax.set_title(title)
    _times(figure.add_subplot(grid[1, 0]), costs.computation_seconds.min("repeat"))
    _by_number(figure.add_subplot(grid[1, 1]), costs.supports_seconds.min("repeat"))
    figure.legend(
        handles=[Patch(color=color, label=name) for name, color, _ in EFFECTS.values()],
        ncols=2,
        loc="upper center",
    )


def _counts(ax: Axes, counts: xr.DataArray) -> None:
    """Bars of one method, one for each list of effects: their counts behind one another."""
    for row, effects in enumerate(LISTS):
        start = 0
        for effect, (_, color, ink) in EFFECTS.items():
            count = int(counts.sel(effects=effects, effect=effect))
            ax.barh(row, count, HEIGHT, left=start, color=color)
            if count:
                ax.text(
                    start + count / 2, row, f"{count}",
                    ha="center", va="center_baseline", color=ink, size=6.5,
                )  # fmt: skip
            start += count
    ax.set_yticks(range(len(LISTS)), [name for name, _, _ in LISTS.values()], fontsize="small")
    ax.tick_params(axis="y", length=0)
    ax.set(xlim=(0, 1.05 * int(counts.sum("effect").max())), ylim=(len(LISTS) - 0.5, -0.5))
    ax.set_xticks([])
    for side in ("top", "right", "bottom"):
        ax.spines[side].set_visible(False)


def _times(ax: Axes, times: xr.DataArray) -> None:
    """Marks of the times, a row for each computation and a mark for each list of effects."""
    for i, (effects, (name, color, marker)) in enumerate(LISTS.items()):
        durations = 1e3 * times.sel(effects=effects, computation=list(COMPUTATIONS)).values
        rows = np.arange(len(COMPUTATIONS)) + (i - 1) * APART
        ax.plot(durations, rows, marker, color=color, markersize=4.5, label=name)
    ax.set_yticks(range(len(COMPUTATIONS)), list(COMPUTATIONS.values()), fontsize="small")
    ax.set(xscale="log", xlabel="time (ms)", ylim=(len(COMPUTATIONS) - 0.5, -0.5))
    ax.grid(True, axis="x")
    ax.legend(loc="lower right", title="listed", fontsize="small", title_fontsize="small")


def _by_number(ax: Axes, times: xr.DataArray) -> None:
    """Times by the number of supports in units of the time with one, and what would be proportional."""
    number = times.supports.values
    ax.plot(number, number / number[0], ":", color="gray")
    ax.plot(number, times / times[0], "o-", color=EFFECTS["support_friction"][1], markersize=4.5)
    ax.set_xscale("log", base=2)
    ax.set_yscale("log", base=2)
    names = [f"{each}" for each in number]
    ax.set_xticks(number, names)
    ax.set_yticks(number, names)
    ax.set(xlabel="number of equal supports", ylabel="time / time with one")
    ax.grid(True)
