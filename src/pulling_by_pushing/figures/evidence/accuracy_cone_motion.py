"""Accuracy against time: both edges of a motion cone, and motion over time by both methods."""

from __future__ import annotations

from typing import Any

import numpy as np

from planar_pushing.drawing.canvas.style import PAGE
from pulling_by_pushing.figures.figure import Data, Figure
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
#: Titles of the panels of motions, by scene.
TITLES = {"slipping": "a slip in one mode", "pulling": "a pull, the fence turns"}
#: Format and alignment of the labels of a method's settings.
NAMED = {
    "brentq on quad": ("tolerance {}", "right"),
    "event-driven": ("tolerance {}", "left"),
    "time-stepping": ("{} steps", "left"),
}


def caption(data: Data) -> str:
    """Caption of the figure."""
    return (
        "Left: largest error of the edges of motion cones against the time for both edges of a cone. "
        "Middle and right: error of the last rod angle against the time for a run, for the scenes of "
        "Fig. 15 and of Fig. 14 (a). Markers and hairs are those of the previous figure; stars are "
        "methods of this work."
    )


def draw(figure: Any, data: Data) -> None:
    """Draw the diagram of cones and those of the scenes, with one legend."""
    cone, motion = (with_times(data, quantity) for quantity in ("cone", "motion"))
    parts = [("both edges of a motion cone", "cone", cone)]
    parts += [(title, "motion", motion.sel(scene=scene)) for scene, title in TITLES.items()]
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
    listed = [*methods(cone), *methods(motion)]
    figure.legend(handles=handles(listed), loc="upper center", ncols=len(listed), fontsize=8)
