"""Accuracy against time: both edges of a motion cone, and motion over time by both methods."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.drawing.canvas.style import PAGE
from pulling_by_pushing.figures.figure import Figure, Sources
from pulling_by_pushing.figures.parts.methods import (
    handles,
    methods,
    name_ends,
    with_times,
    work_precision,
)

FIGURE = Figure(
    title="What the accuracy of cones and motions costs",
    reads=("accuracy/cone", "accuracy_time/cone", "accuracy/motion", "accuracy_time/motion"),
    size=(PAGE, 2.6),
)
LIMITS = (1e-15, 1e2)
#: Variables along `point` that the cone has as well as the motions.
SHARED = ("point", "method", "setting")
#: Titles of the panels of motions, by scene.
TITLES = {"slipping": "a slip in one mode", "pulling": "a pull, the fence turns"}
#: Format and alignment of the labels of a method's settings.
NAMED = {
    "brentq on quad": ("tolerance {}", "right"),
    "event-driven": ("tolerance {}", "left"),
    "time-stepping": ("{} steps", "left"),
}


def select(sources: Sources, settings: Any) -> xr.Dataset:
    """Errors and times of cones, whose points, methods and settings begin with `cone_`, and of motions."""
    *cone, errors, times = sources.values()
    named = with_times(*cone).rename({name: f"cone_{name}" for name in SHARED})
    return with_times(errors, times).assign(named.variables)


def caption(data: xr.Dataset) -> str:
    """Caption of the figure."""
    return (
        "Left: largest error of the edges of motion cones against the time for both edges of a cone. "
        "Middle and right: error of the last rod angle against the time for a run, for the scenes of "
        "Fig. 15 and of Fig. 14 (a). Markers and hairs are those of the previous figure; stars are "
        "methods of this work."
    )


def draw(figure: Any, data: xr.Dataset) -> None:
    """Draw the diagram of cones and those of the scenes, with one legend."""
    names = ["cone_method", "cone_setting", "cone_error", "cone_seconds"]
    cone = data[names].rename({f"cone_{name}": name for name in SHARED})
    parts = [("both edges of a motion cone", "cone", cone)]
    parts += [(title, "motion", data.sel(scene=scene)) for scene, title in TITLES.items()]
    axes = figure.subplots(1, len(parts), sharey=True)
    figure.subplots_adjust(left=0.085, right=0.985, bottom=0.17, top=0.82, wspace=0.09)
    for ax, (title, quantity, part) in zip(axes, parts, strict=True):
        times, errors = part[f"{quantity}_seconds"], part[f"{quantity}_error"].values
        work_precision(ax, part.method.values, times, errors, LIMITS)
        ax.set_title(title)
        name_ends(
            ax, part, quantity, {name: NAMED[name] for name in methods(part) if name in NAMED}
        )
    axes[0].set(xlabel="time for a cone, seconds", ylabel="error, degrees")
    for ax in axes[1:]:
        ax.set_xlabel("time for a run, seconds")
        ax.margins(x=0.7)  # room for the labels of settings
    axes[0].set_yticks(10.0 ** np.arange(-14, 3, 4))
    listed = [*methods(cone), *methods(data)]
    figure.legend(handles=handles(listed), loc="upper center", ncols=len(listed), fontsize=8)
