"""The sides of an object's outline."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.outline import required_outline
from planar_pushing.mechanics.plane import Array


class Side(NamedTuple):
    """A side of an outline.

    Attributes
    ----------
    start, end : ndarray, shape (2,)
        Its corners; the object is on the left when going from start to end.
    tangent, normal : ndarray, shape (2,)
        Unit vectors from start to end, and into the object.
    length : float
    """

    start: Array
    end: Array
    tangent: Array
    normal: Array
    length: float


def sides(outline: Any) -> list[Side]:
    """Sides of an outline, in order; adjacent sides on one straight line count as one.

    Raises
    ------
    InvalidValue
        If the outline is not a simple polygon.
    """
    corners = np.array(required_outline(outline))
    return [_side(*ends) for ends in zip(corners, np.roll(corners, -1, axis=0), strict=True)]


def _side(start: Array, end: Array) -> Side:
    along = end - start
    length = float(np.hypot(*along))
    tangent = along / length
    # Without negative zeros, which would be printed.
    normal = np.array([-tangent[1], tangent[0]]) + 0.0
    return Side(start, end, tangent, normal, length)
