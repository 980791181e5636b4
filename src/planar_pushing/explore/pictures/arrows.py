"""Arrows and cones of the page: filled heads for forces, open ones for motions, as in the figures.

In the figures matplotlib makes the points of both: heads in points of the paper, arcs as Bezier curves.
On the page heads keep their part of an arrow at every size of the window, and areas are polygons.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from planar_pushing.explore.pictures.columns import Marks
from planar_pushing.figures.parts.drawing import tint
from planar_pushing.figures.style import FORCE, MOTION
from planar_pushing.mechanics.plane import direction

#: Length and half the width of a head, in units of the reach of arrows.
HEAD = 0.13, 0.05
#: Distance between an arrow's tip and its letter, pixels.
AWAY = 19.0


def arrow(
    marks: Marks,
    tail: npt.ArrayLike,
    vector: npt.ArrayLike,
    reach: float,
    text: str = "",
    *,
    color: str,
    filled: bool,
    width: float = 2.4,
    alpha: float = 1.0,
    at: float = 1.0,
    aside: float = 0.0,
) -> None:
    """Arrow from a tail along a vector; its letter stands ahead of the tip, or aside at a fraction."""
    start, along = np.asarray(tail, dtype=float), np.asarray(vector, dtype=float)
    length = float(np.hypot(*along))
    if not length:
        return
    ahead = along / length
    across = np.array([-ahead[1], ahead[0]])
    deep, half = (min(part * reach, 0.5 * length * part / HEAD[0]) for part in HEAD)
    tip, neck = start + along, start + along - deep * ahead
    end = neck if filled else tip
    marks.line([start, end], color, width, alpha=alpha)
    marks.head([neck + half * across, tip, neck - half * across], color, filled=filled, alpha=alpha)
    if text:
        wide = np.array([1.0 + 0.16 * len(text), 1.0])
        offset = AWAY * wide * (across * aside if aside else ahead)
        marks.label(start + at * along, text, color, offset)


def force_arrow(
    marks: Marks,
    tail: npt.ArrayLike,
    vector: npt.ArrayLike,
    reach: float,
    text: str = "",
    *,
    alpha: float = 1.0,
) -> None:
    """Arrow of a force."""
    arrow(marks, tail, vector, reach, text, color=FORCE, filled=True, width=3.2, alpha=alpha)


def motion_arrow(
    marks: Marks,
    tail: npt.ArrayLike,
    vector: npt.ArrayLike,
    reach: float,
    text: str = "",
    *,
    color: str = MOTION,
    alpha: float = 1.0,
) -> None:
    """Arrow of a velocity or an acceleration."""
    arrow(marks, tail, vector, reach, text, color=color, filled=False, alpha=alpha)


def cone(
    marks: Marks, right: float, left: float, radius: float, color: str, strength: float = 0.16
) -> None:
    """Cone of directions between two angles in radians, from the contact."""
    turns = np.linspace(right, left, 2 + int((left - right) / 0.05))
    rim = radius * np.asarray(direction(turns))
    marks.area([np.vstack([[(0.0, 0.0)], rim])], tint(color, strength))
    if left - right < 2 * np.pi - 1e-9:
        for edge in (rim[0], rim[-1]):
            marks.line([(0.0, 0.0), edge], color, 1.1)
