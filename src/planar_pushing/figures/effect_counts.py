"""Counts of the functions and evaluations of each effect, by the effects that a scene lists."""

from __future__ import annotations

from typing import Any

import xarray as xr
from matplotlib.axes import Axes
from matplotlib.patches import Patch

from planar_pushing.figures.axes import is_column
from planar_pushing.figures.colors import DARK
from planar_pushing.figures.figure import COLUMN, PAGE, Figure

FIGURE = Figure(
    title="Counts of the effects",
    reads=("evaluations",),
    size=(PAGE, 2.1),
    column=(COLUMN, 4.0),
)
#: Sets of effects that a scene lists, from the top of a group, and their names.
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
#: Panels: variable, title, and the rows from the top by their labels along the axis of the variable.
PANELS = (
    (
        "functions",
        "functions in machine code",
        {"simulate": "motion\nby events", "simulate by time-stepping": "motion\nby steps"},
    ),
    (
        "evaluations",
        "evaluations in the log of a motion",
        {"event-driven": "motion\nby events", "time-stepping": "motion\nby steps"},
    ),
)
HEIGHT = 0.24


def caption(data: xr.Dataset) -> str:
    """Caption of the figure."""
    return (
        "Only the effects that a scene lists are computed: functions of support friction and of "
        "inertia in the machine code of a simulation, and their evaluations in the log of a "
        "motion over time, for scenes that list support friction, inertia, or both. An effect that "
        "is not listed has none. With both effects the motion under a force depends on its "
        "magnitude as well, and a search for it takes more evaluations."
    )


def draw(figure: Any, data: xr.Dataset) -> None:
    """Draw the counts as bars, a row for each set of effects that a scene lists."""
    narrow = is_column(figure)
    if narrow:
        axes = figure.subplots(2, 1)
        figure.subplots_adjust(left=0.36, right=0.97, bottom=0.03, top=0.86, hspace=0.2)
    else:
        axes = figure.subplots(1, 2)
        figure.subplots_adjust(left=0.175, right=0.98, bottom=0.04, top=0.83, wspace=0.42)
    for ax, (variable, title, rows) in zip(axes, PANELS, strict=True):
        _panel(ax, data[variable], rows)
        ax.set_title(title)
    figure.legend(
        handles=[Patch(color=color, label=name) for name, color, _ in EFFECTS.values()],
        ncols=2,
        loc="upper center",
    )


def _panel(ax: Axes, counts: xr.DataArray, rows: dict[str, str]) -> None:
    """Bars of one variable: a group for each computation, with a bar for each list of effects."""
    axis = str(counts.dims[0])
    places, names = [], []
    for i, operation in enumerate(rows):
        for j, effects in enumerate(LISTS):
            places.append(i + (j - 1) * (HEIGHT + 0.05))
            names.append(LISTS[effects])
            found = counts.sel({axis: operation, "effects": effects})
            _bar(ax, places[-1], [int(found.sel(effect=each)) for each in EFFECTS])
        ax.annotate(
            rows[operation], (0, i), xytext=(-42, 0), textcoords="offset points",
            ha="right", va="center",
        )  # fmt: skip
    ax.set_yticks(places, names, fontsize="small")
    ax.tick_params(axis="y", length=0)
    ax.set(xlim=(0, 1.12 * int(counts.sum("effect").max())), ylim=(len(rows) - 0.5, -0.5))
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
