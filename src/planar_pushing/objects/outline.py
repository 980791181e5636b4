"""The sides of an object's outline."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.supports import Polygon
from planar_pushing.terms.errors import InvalidValue

#: Sine of the angle at a corner below which two sides are one.
STRAIGHT = 1e-12


class Side(NamedTuple):
    """A side of an outline.

    Attributes
    ----------
    start, end : ndarray, shape (2,)
        Its corners, the object on the left of the way from one to the other.
    tangent, normal : ndarray, shape (2,)
        Unit vectors from the start to the end, and into the object.
    length : float
    """

    start: Array
    end: Array
    tangent: Array
    normal: Array
    length: float


def sides(outline: Any) -> list[Side]:
    """Sides of an outline; two that are one straight line count as one.

    Raises
    ------
    InvalidValue
        Where the outline is not a simple polygon.
    """
    try:
        polygon = outline if isinstance(outline, Polygon) else Polygon(outline)
    except InvalidValue as error:
        name = error.name.replace("vertices", "outline")
        raise InvalidValue(name, error.given, error.allowed, error.remedy) from None
    corners = _corners(np.array(polygon.vertices, dtype=float))
    return [_side(*ends) for ends in zip(corners, np.roll(corners, -1, axis=0), strict=True)]


def _corners(vertices: Array) -> Array:
    """Vertices at which the outline turns, counter-clockwise."""
    after = np.roll(vertices, -1, axis=0) - vertices
    # Relative to a vertex: the area of a small outline far from the origin would cancel.
    local = vertices - vertices[0]
    if (local[:, 0] * after[:, 1] - local[:, 1] * after[:, 0]).sum() < 0:
        return _corners(vertices[::-1])
    before = np.roll(after, 1, axis=0)
    turn = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
    sizes = np.hypot(*before.T) * np.hypot(*after.T)
    return np.asarray(vertices[np.abs(turn) > STRAIGHT * sizes])


def _side(start: Array, end: Array) -> Side:
    along = end - start
    length = float(np.hypot(*along))
    tangent = along / length
    # Without negative zeros, which would be printed.
    normal = np.array([-tangent[1], tangent[0]]) + 0.0
    return Side(start, end, tangent, normal, length)
