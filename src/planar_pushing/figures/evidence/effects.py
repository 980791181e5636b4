"""What each effect costs: time and evaluations of one slider with friction, inertia, or both."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from planar_pushing.figures.style import DARK, NOTE_SIZE

NAMES = {
    "support_friction": ("support friction", "#0072B2"),
    "inertia": ("inertia", "#E69F00"),
    "support_friction+inertia": ("both", "#CC79A7"),
}
#: Operations: what each panel shows, as its scene and its rows from the top.
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


def draw(figure: Figure, data: xr.Dataset) -> None:
    """Draw the times as bars, each with the evaluations of friction and of inertia."""
    axes = figure.subplots(1, len(PANELS))
    figure.subplots_adjust(left=0.14, right=0.99, bottom=0.16, top=0.84, wspace=0.36)
    for ax, (scene, (title, rows)) in zip(axes, PANELS.items(), strict=True):
        part = data.isel(case=(data.scene == scene).values)
        for i, operation in enumerate(rows):
            _bars(ax, i, part.isel(case=(part.operation == operation).values))
        ax.set_yticks(range(len(rows)), list(rows.values()))
        ax.invert_yaxis()
        ax.set_xscale("log")
        low, high = ax.get_xlim()
        ax.set_xlim(low, high * 80)  # room for the evaluations
        ax.set_xlabel("time (ms)")
        ax.set_title(title)
    handles, labels = axes[0].get_legend_handles_labels()
    known = dict(zip(labels, handles, strict=True))
    figure.legend(known.values(), known.keys(), ncols=3, loc="upper center", frameon=False)


def _bars(ax: Axes, row: int, part: xr.Dataset) -> None:
    """Bars of one operation, one for each set of effects."""
    for i, effects in enumerate(NAMES):
        case = part.isel(case=np.flatnonzero(part.effects == effects)[0])
        name, color = NAMES[effects]
        place, ms = row + (i - 1) * WIDTH, 1e3 * float(case.time.min())
        ax.barh(place, ms, height=WIDTH * 0.9, color=color, label=name)
        counts = ", ".join(
            f"{int(case.evaluations.sel(effect=effect)):,} {word}"
            for effect, word in (("support_friction", "friction"), ("inertia", "inertia"))
        )
        ax.text(1.15 * ms, place, counts, va="center", size=NOTE_SIZE - 1, color=DARK)
