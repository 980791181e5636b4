"""The picture of a motion at one instant, and its modes over time."""

from __future__ import annotations

from typing import Any

import numpy as np

from planar_pushing.explore.following import Motion, row_at
from planar_pushing.explore.pictures.arrows import force_arrow
from planar_pushing.explore.pictures.columns import Marks
from planar_pushing.explore.pictures.scene import DEPTH, HALF, fence, finger
from planar_pushing.explore.pictures.supports import add_centers, add_support
from planar_pushing.figures.motion.timeline import MODES, contact, rod_end
from planar_pushing.figures.motion.trajectory import FORCE_LENGTH, pose, span
from planar_pushing.figures.parts.bodies import body_of
from planar_pushing.figures.parts.supports import Ink
from planar_pushing.figures.style import CENTER, SLIDER

#: Most points of a path, which is drawn anew for every instant.
POINTS = 160


def picture(motion: Motion, time: float) -> dict[str, Any]:
    """Columns of the picture at a time, by the kind of mark."""
    marks, data, row = Marks(), motion.data, row_at(motion, time)
    touch, here, body = contact(data)[row], pose(data, row), body_of(data)
    size = span(data)
    if "path_side" in data:
        finger(marks, data["path_side"].values[row], touch)
    else:
        middle = data["path_fence"].values[row]
        fence(marks, middle, 0.38 * HALF * size, 0.38 * DEPTH * size)
    add_support(marks, body, here, Ink())
    marks.line([rod_end(data)[row], here.origin], SLIDER, 2.4)
    marks.dot(here.origin, 6.0, SLIDER, SLIDER)
    marks.dot(rod_end(data)[row], 9.0, SLIDER, SLIDER)
    add_centers(marks, body, here)
    _paths(marks, motion, row)
    force = data["path_force"].values[row]
    if np.any(force):
        along = FORCE_LENGTH * size * force / np.hypot(*force)
        force_arrow(marks, touch, along, 0.38 * size, "f")
    center = data["path_center"].values[row]
    if np.isfinite(center).all() and np.hypot(*(center - here.origin)) < 2 * size:
        marks.dot(center, 11.0, "white", CENTER, "circle_dot")
    return marks.columns


def _paths(marks: Marks, motion: Motion, row: int) -> None:
    """Path of the contact up to a row, in the colors of its modes."""
    touch = contact(motion.data)
    step = max(len(touch) // POINTS, 1)
    for run in motion.runs:
        stop = min(run.stop, row)
        if run.start < stop:
            rows = [*range(run.start, stop, step), stop]
            marks.line(touch[rows], MODES[run.mode][0], 3.5)


def mode_bar(motion: Motion) -> dict[str, list[Any]]:
    """Columns of the strip of modes over time; hatched where there was a choice."""
    times = motion.times
    return {
        "left": [float(times[run.start]) for run in motion.runs],
        "right": [float(times[run.stop]) for run in motion.runs],
        "fill": [MODES[run.mode][0] for run in motion.runs],
        "hatch": ["/" if run.several else " " for run in motion.runs],
    }
