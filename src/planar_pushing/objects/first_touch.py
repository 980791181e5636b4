"""First contact of a disc that moves in a straight line with an object at rest."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.kernels.arrays import same
from planar_pushing.mechanics.outline import DRAWN
from planar_pushing.mechanics.plane import Array
from planar_pushing.objects.boundary import Sides, nearest, sides_of
from planar_pushing.terms.errors import InvalidValue, require_number
from planar_pushing.terms.numbers import require_array

#: Rounding error of positions, relative to the numbers from which they are computed.
ROUNDING = 64.0 * float(np.finfo(float).eps)


@dataclass(frozen=True, slots=True, kw_only=True)
class Touch:
    """First touches of a moving disc, as arrays over the pushes.

    Attributes
    ----------
    contact : ndarray, shape S + (2,)
        Touched point of the outline; NaN where the disc does not touch.
    normal : ndarray, shape S + (2,)
        Unit vector into the object, from the disc's center to the contact. For a disc of radius 0, the
        inward normal of the side, or at a corner the bisector of the normals of its sides.
    side : ndarray of int, shape S
        Number of the side, which goes from corner `side` of the counterclockwise outline to the next one.
        At a corner, the side that ends there; -1 where the disc does not touch.
    corner : ndarray of bool, shape S
        Whether the contact is at a convex corner.
    fraction : ndarray, shape S
        Fraction of the displacement before the touch; NaN where the disc does not touch.
    overlap : ndarray, shape S
        Depth of the overlap of disc and object at the start; 0 for a disc that starts outside.
    """

    contact: Array
    normal: Array
    side: npt.NDArray[np.intp]
    corner: npt.NDArray[np.bool_]
    fraction: Array
    overlap: Array

    def __eq__(self, other: object) -> Any:
        return same(self, other)


def first_touch(
    outline: Any,
    position: npt.ArrayLike,
    displacement: npt.ArrayLike,
    radius: npt.ArrayLike = 0.0,
    *,
    tolerance: float = 0.0,
) -> Touch:
    """First contact of a disc that moves in a straight line with an object at rest.

    Parameters
    ----------
    outline : array_like, shape (n, 2), or an object with `coords` or `exterior`
        Corners of a simple polygon, in order.
    position : array_like, shape S + (2,)
        Center of the disc at its start, in the frame of the outline.
    displacement : array_like, shape S + (2,)
        Motion of the disc along a straight line.
    radius : float or array_like of shape S
        Radius of the disc, >= 0; 0 for a point.
    tolerance : float
        Maximum overlap at the start, as in measured poses, with which a disc touches the object at once, at
        the nearest point of the outline.

    Returns
    -------
    Touch
        Its `fraction` is NaN where the disc does not touch, starts deeper in the object than the tolerance
        (see `overlap`), or moves away from it. A disc that only grazes the object does not touch it.

    Raises
    ------
    InvalidValue
        If the outline is not a simple polygon, a number is not finite, or a radius is negative.

    Notes
    -----
    At the touch, the center reaches the boundary of the object grown by the radius: sides moved outward by
    the radius, and circles about the convex corners. At a reflex corner the disc reaches one of the two
    sides first. As a drawing is, it is exact to a millionth of the outline's size: a disc that close to the
    object touches it, a contact that close to a convex corner is at the corner, and a disc no larger is a
    point.
    """
    sides = sides_of(outline)
    start, motion = _vectors("position", position), _vectors("displacement", displacement)
    reach = _not_negative("radius", radius)
    slack = require_number(
        "tolerance", tolerance, lambda x: 0.0 <= x < math.inf, "numbers >= 0", "give a length"
    )
    try:
        shape = np.broadcast_shapes(start.shape[:-1], motion.shape[:-1], reach.shape)
    except ValueError:
        shapes = start.shape, motion.shape, reach.shape
        raise InvalidValue(
            "position", shapes, "shapes that broadcast together", "give one of each per push"
        ) from None
    places, motions = (
        np.broadcast_to(array, (*shape, 2)).reshape(-1, 2) for array in (start, motion)
    )
    touches = _touch(sides, places, motions, np.broadcast_to(reach, shape).ravel(), slack)
    return Touch(
        **{name: values.reshape(shape + values.shape[1:]) for name, values in touches.items()}
    )


def _touch(
    sides: Sides, start: Array, motion: Array, radius: Array, slack: float
) -> dict[str, Any]:
    """Attributes of `Touch` for pushes of shape (n, 2)."""
    error = DRAWN * sides.scale + ROUNDING * np.abs(start).max(axis=1, initial=0.0)
    near = nearest(sides, start)
    gap = near.gap - radius
    side, position, fraction = _first_meeting(sides, start, motion, radius, error)
    # A disc that starts in contact, or within the tolerance, and moves into the object touches at once.
    normal = _contact(sides, start, near.side, near.position, radius, error)["normal"]
    into = (normal * motion).sum(axis=1) > 0.0
    at_once = into & (gap <= error) & (gap >= -slack - error)
    side, position = np.where(at_once, near.side, side), np.where(at_once, near.position, position)
    fraction = np.where(at_once, 0.0, np.where(gap < -slack - error, np.nan, fraction))
    contact = _contact(
        sides, start + np.nan_to_num(fraction)[:, None] * motion, side, position, radius, error
    )
    missed = np.isnan(fraction) | ((contact["normal"] * motion).sum(axis=1) <= 0.0)
    return {
        "contact": np.where(missed[:, None], np.nan, contact["contact"]),
        "normal": np.where(missed[:, None], np.nan, contact["normal"]),
        "side": np.where(missed, -1, contact["side"]),
        "corner": contact["corner"] & ~missed,
        "fraction": np.where(missed, np.nan, fraction),
        "overlap": np.where(gap < -error, -gap, 0.0),
    }


def _first_meeting(
    sides: Sides, start: Array, motion: Array, radius: Array, error: Array
) -> tuple[npt.NDArray[np.intp], Array, Array]:
    """Side, place on it, and fraction of the motion at which the center first reaches the grown object."""
    fractions, places = _fractions_to_sides(sides, start, motion, radius, error)
    every = np.concatenate([fractions, _fractions_to_corners(sides, start, motion, radius)], axis=1)
    rows, which = np.arange(len(start)), np.where(np.isnan(every), np.inf, every).argmin(axis=1)
    count = len(sides.length)
    at_circle = which >= count
    side = np.where(at_circle, which - count, which)
    return side, np.where(at_circle, 0.0, places[rows, side]), every[rows, which]


def _fractions_to_sides(
    sides: Sides, start: Array, motion: Array, radius: Array, error: Array
) -> tuple[Array, Array]:
    """Fractions of the motion at which the center crosses each moved side, or NaN, and the places there."""
    away = start[:, None] - sides.start
    height, along = ((away * direction).sum(axis=-1) for direction in (sides.normal, sides.tangent))
    rate, speed = motion @ sides.normal.T, motion @ sides.tangent.T
    with np.errstate(divide="ignore", invalid="ignore"):
        slack, ahead = error[:, None], -(height + radius[:, None])
        fraction = np.where(np.abs(ahead) <= slack, 0.0, ahead) / rate
        position = along + fraction * speed
        meets = (rate > 0.0) & (fraction >= 0.0) & (fraction <= 1.0)
        meets &= (position >= -slack) & (position <= sides.length + slack)
    return np.where(meets, fraction, np.nan), np.clip(np.nan_to_num(position), 0.0, sides.length)


def _fractions_to_corners(sides: Sides, start: Array, motion: Array, radius: Array) -> Array:
    """Fractions of the motion at which the center enters the circle about each convex corner, or NaN."""
    away = start[:, None] - sides.start
    square = (motion * motion).sum(axis=1)[:, None]
    middle = (away * motion[:, None]).sum(axis=-1)
    # Distance of the circle's center from the line of motion, without a difference of large squares.
    across = away[..., 0] * motion[:, None, 1] - away[..., 1] * motion[:, None, 0]
    root = square * (radius * radius)[:, None] - across * across
    outside = (away * away).sum(axis=-1) - (radius * radius)[:, None]
    with np.errstate(divide="ignore", invalid="ignore"):
        # The smaller root, as a ratio without cancellation.
        fraction = outside / (np.sqrt(root) - middle)
    enters = sides.convex & (root > 0.0) & (middle < 0.0) & (fraction >= 0.0) & (fraction <= 1.0)
    return np.where(enters, fraction, np.nan)


def _contact(
    sides: Sides, center: Array, side: npt.NDArray[np.intp], position: Array, radius: Array,
    error: Array,
) -> dict[str, Any]:  # fmt: skip
    """Contact and normal of a disc that touches a side at a given place."""
    after = (side + 1) % len(sides.length)
    at_start, at_end = position <= error, position >= sides.length[side] - error
    vertex = np.where(at_end, after, side)
    corner = (at_start | at_end) & sides.convex[vertex]
    point = sides.start[side] + position[:, None] * sides.tangent[side]
    # A disc that meets a side near its end has the normal of the side, to the digits of its position.
    offset = np.where((radius > error)[:, None], point - center, 0.0)
    return {
        "contact": np.where(corner[:, None], sides.start[vertex], point),
        "normal": _normal(sides, offset, side, vertex, corner),
        "side": np.where(corner, (vertex - 1) % len(sides.length), side),
        "corner": corner,
    }


def _normal(sides: Sides, offset: Array, side: Any, vertex: Any, corner: Any) -> Array:
    """Normals of the side; at a corner, along the offset from the disc's center, else the bisector."""
    after, before = sides.normal[vertex], sides.normal[vertex - 1]
    middle = after + before
    outside = (offset * middle).sum(axis=1) > 0.0
    from_center = np.where(outside[:, None], offset, middle)
    normals = np.where(corner[:, None], from_center, sides.normal[side])
    return np.asarray(normals / np.hypot(*normals.T)[:, None])


def _vectors(name: str, value: Any) -> Array:
    """Finite vectors of shape S + (2,), or `InvalidValue`."""
    vectors = _finite(name, value)
    if vectors.shape[-1:] != (2,):
        raise InvalidValue(
            name, vectors.shape, "shape S + (2,)", "give x and y along the last axis"
        )
    return vectors


def _not_negative(name: str, value: Any) -> Array:
    """Finite numbers >= 0, or `InvalidValue`."""
    numbers = _finite(name, value)
    if (numbers < 0.0).any():
        raise InvalidValue(name, float(numbers.min()), "numbers >= 0", "give 0 for a point")
    return numbers


def _finite(name: str, value: Any) -> Array:
    numbers = require_array(name, value, "finite numbers", "give floats")
    if not np.isfinite(numbers).all():
        wrong = float(numbers[~np.isfinite(numbers)][0])
        raise InvalidValue(name, wrong, "finite numbers", "leave out what was not measured")
    return numbers
