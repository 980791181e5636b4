"""Evaluations of each effect in the log of a motion, by the effects that a scene lists."""

from __future__ import annotations

from typing import Any

import xarray as xr
from matplotlib.axes import Axes
from matplotlib.patches import Patch

from planar_pushing.figures.axes import is_column
from planar_pushing.figures.colors import DARK
from planar_pushing.figures.figure import COLUMN, PAGE, Figure

FIGURE = Figure(
    title="Evaluations of the effects",
    reads=("evaluations",),
    size=(PAGE, 1.4),
    column=(COLUMN, 2.6),
)
#: Sets of effects that a scene lists, from the top, and their names.
LISTS = {
    "support_friction": "friction",
    "inertia": "inertia",
    "support_friction+inertia": "both",
}
#: Name, color of the bar, and color of the number of each effect that is counted.
EFFECTS = {
    "support_friction": ("support friction", "#0072B2", "white"),
    "inertia": ("inertia", "#D9A441", DARK),
}
#: Panels by the method of the motion.
PANELS = {"event-driven": "motion by events", "time-stepping": "motion by steps"}
HEIGHT = 0.8


def caption(data: xr.Dataset) -> str:
    """Caption of the figure."""
    return (
        "Only the effects that a scene lists are computed: evaluations of support friction and of inertia "
        "in the log of a motion over time, for scenes that list support friction, inertia, or both. An "
        "effect that is not listed has none. A step evaluates the motion once; the event-driven method "
        "chooses its steps by the motion."
    )


def draw(figure: Any, data: xr.Dataset) -> None:
    """Draw the counts as bars, a panel for each method, a row for each list of effects."""
    narrow = is_column(figure)
    if narrow:
        axes = figure.subplots(2, 1)
        figure.subplots_adjust(left=0.17, right=0.97, bottom=0.04, top=0.79, hspace=0.35)
    else:
        axes = figure.subplots(1, 2)
        figure.subplots_adjust(left=0.08, right=0.98, bottom=0.06, top=0.7, wspace=0.22)
    for ax, (method, title) in zip(axes, PANELS.items(), strict=True):
        _panel(ax, data.evaluations.sel(integrator=method))
        ax.set_title(title)
    figure.legend(
        handles=[Patch(color=color, label=name) for name, color, _ in EFFECTS.values()],
        ncols=2,
        loc="upper center",
    )


def _panel(ax: Axes, counts: xr.DataArray) -> None:
    """Bars of one method, one for each list of effects."""
    for place, effects in enumerate(LISTS):
        _bar(ax, place, [int(counts.sel(effects=effects, effect=each)) for each in EFFECTS])
    ax.set_yticks(range(len(LISTS)), list(LISTS.values()), fontsize="small")
    ax.tick_params(axis="y", length=0)
    ax.set(xlim=(0, 1.05 * int(counts.sum("effect").max())), ylim=(len(LISTS) - 0.5, -0.5))
    ax.set_xticks([])
    for side in ("top", "right", "bottom"):
        ax.spines[side].set_visible(False)


def _bar(ax: Axes, place: float, counts: list[int]) -> None:
    """One bar: the counts of the effects behind one another, each with its number."""
    start = 0
    for (_, color, ink), count in zip(EFFECTS.values(), counts, strict=True):
        ax.barh(place, count, HEIGHT, left=start, color=color)
        if count:
            middle = start + count / 2
            ax.text(
                middle, place, f"{count}", ha="center", va="center_baseline", color=ink, size=6.5
            )
        start += count
