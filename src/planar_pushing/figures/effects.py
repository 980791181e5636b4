"""Cost of each effect: times with friction, inertia, or both, and by the number of effects."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes

from planar_pushing.figures.figure import PAGE, Figure

FIGURE = Figure(
    title="Costs of the effects",
    reads=("effects",),
    size=(PAGE, 3.0),
)
NAMES = {
    "support_friction": ("support friction", "#0072B2", "o"),
    "inertia": ("inertia", "#8F6400", "s"),
    "support_friction+inertia": ("both", "#8A3C70", "D"),
}
#: Scene of each panel and its operations, by rows from the top.
PANELS = {
    "one slider": (
        "one scene",
        {
            "motion_cone": "motion cone",
            "limit_curve": "361 points of\nthe limit curve",
            "solve": "all contact modes\nof one push",
        },
    ),
    "grid": (
        "datasets",
        {
            "limit_curves": "limit curves",
            "motion_cones": "motion cones",
            "contact_modes": "contact modes",
        },
    ),
}
WIDTH = 0.26
#: Scene of the panel by the number of effects.
DIVIDED = "equal supports"


def draw(figure: Any, data: xr.Dataset) -> None:
    """Draw the times as marks, one for each set of effects, and those by the number of effects."""
    *axes, last = figure.subplots(1, len(PANELS) + 1)
    figure.subplots_adjust(left=0.15, right=0.98, bottom=0.16, top=0.8, wspace=0.5)
    for ax, (scene, (title, rows)) in zip(axes, PANELS.items(), strict=True):
        part = data.isel(case=(data.scene == scene).values)
        for i, operation in enumerate(rows):
            _marks(ax, i, part.isel(case=(part.operation == operation).values))
        ax.set_yticks(range(len(rows)), list(rows.values()))
        ax.invert_yaxis()
        ax.set_xscale("log")
        ax.grid(True, axis="x")
        decades = np.log10(ax.get_xlim())
        ax.set_xlim(10.0 ** np.floor(decades[0]), 10.0 ** np.ceil(decades[1]))
        ax.set_xlabel("time (ms)")
        ax.set_title(title)
    handles, labels = axes[0].get_legend_handles_labels()
    known = dict(zip(labels, handles, strict=True))
    figure.legend(known.values(), known.keys(), ncols=3, loc="upper center")
    _by_number(last, data.isel(case=(data.scene == DIVIDED).values))


def _marks(ax: Axes, row: int, part: xr.Dataset) -> None:
    """Draw the marks of one operation, one for each set of effects."""
    for i, effects in enumerate(NAMES):
        case = part.isel(case=np.flatnonzero(part.effects == effects)[0])
        name, color, marker = NAMES[effects]
        place, ms = row + (i - 1) * WIDTH, 1e3 * float(case.time.min())
        ax.plot(ms, place, marker, color=color, markersize=5, label=name)


def _by_number(ax: Axes, part: xr.Dataset) -> None:
    """Draw times by the number of effects in units of the time with one, and what would be proportional."""
    number, times = part.number.values, part.time.min("repeat").values
    ax.plot(number, number / number[0], ":", color="gray", label="proportional")
    ax.plot(number, times / times[0], "o-", color=NAMES["support_friction"][1], markersize=5)
    ax.set_xscale("log", base=2)
    ax.set_yscale("log", base=2)
    ax.set_xticks(number, [f"{each}" for each in number])
    ax.set_yticks(number, [f"{each}" for each in number])
    ax.set(xlabel="number of equal supports", ylabel="time / time with one support")
    ax.grid(True)
    ax.legend()
    ax.set_title("a run by steps")
