"""First touch of a disc that moves straight towards an object at rest."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.numerics.arrays import same
from planar_pushing.mechanics.plane import Array
from planar_pushing.objects.boundary import Sides, nearest, sides_of
from planar_pushing.terms.errors import InvalidValue

#: Rounding errors of positions, relative to the numbers that they are computed from.
ROUNDING = 1e-12


@dataclass(frozen=True, slots=True, kw_only=True)
class Touch:
    """First touches of a moving disc, arrays over the pushes.

    Attributes
    ----------
    contact : ndarray, shape S + (2,)
        The point of the outline; NaN where the disc does not touch.
    normal : ndarray, shape S + (2,)
        Unit vector into the object: from the disc's center to the contact, of a point the inward normal of
        the side, or at a corner the bisector of the normals of its sides.
    side : ndarray of int, shape S
        Number of the side, which goes from corner `side` of the counter-clockwise outline to the next; at a
        corner the side that ends there. -1 where the disc does not touch.
    corner : ndarray of bool, shape S
        Whether the contact is at a convex corner.
    way : ndarray, shape S
        Fraction of the displacement before the touch; NaN where the disc does not touch.
    overlap : ndarray, shape S
        Depth at which the disc overlaps the object at its start; 0 for one that begins outside.
    """

    contact: Array
    normal: Array
    side: npt.NDArray[np.intp]
    corner: npt.NDArray[np.bool_]
    way: Array
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
    """Where a disc that moves straight first touches an object at rest.

    Parameters
    ----------
    outline : array_like, shape (n, 2), or an object with `coords` or `exterior`
        Corners of a simple polygon, in order.
    position : array_like, shape S + (2,)
        Center of the disc at its start, in the frame of the outline.
    displacement : array_like, shape S + (2,)
        Its motion, straight.
    radius : float or array_like of shape S
        Radius of the disc, >= 0; of a point 0.
    tolerance : float
        A disc that overlaps the object by at most this at its start, as measured poses have it, touches at
        once, at the nearest point of the outline.

    Returns
    -------
    Touch
        Its `way` is NaN where the disc does not touch, and where it begins deeper in the object than the
        tolerance (`overlap`) or leaves it. A disc that only grazes the object does not touch it.

    Raises
    ------
    InvalidValue
        If the outline is not a simple polygon, a number is not finite, or a radius is negative.

    Notes
    -----
    The center meets the boundary of the object grown by the radius: sides moved outward by the radius, and
    circles about the convex corners. At a reflex corner the disc reaches one of the two sides first.
    """
    sides = sides_of(outline)
    start, motion = _vectors("position", position), _vectors("displacement", displacement)
    reach = _not_negative("radius", radius)
    slack = float(_not_negative("tolerance", tolerance))
    try:
        shape = np.broadcast_shapes(start.shape[:-1], motion.shape[:-1], reach.shape)
    except ValueError:
        given = start.shape, motion.shape, reach.shape
        raise InvalidValue(
            "position", given, "shapes that fit", "give one of each for each push"
        ) from None
    places, motions = (
        np.broadcast_to(each, (*shape, 2)).reshape(-1, 2) for each in (start, motion)
    )
    found = _touch(sides, places, motions, np.broadcast_to(reach, shape).ravel(), slack)
    return Touch(**{name: each.reshape(shape + each.shape[1:]) for name, each in found.items()})


def _touch(
    sides: Sides, start: Array, motion: Array, radius: Array, slack: float
) -> dict[str, Any]:
    """The attributes of `Touch` for pushes of shape (n, 2)."""
    error = ROUNDING * (
        sides.scale + np.abs(sides.start).max() + np.abs(start).max(axis=1, initial=0.0)
    )
    near = nearest(sides, start)
    gap = near.gap - radius
    side, place, way = _first_meeting(sides, start, motion, radius, error)
    # One that begins in touch, or within the tolerance, and moves into the object touches at once.
    normal = _contact(sides, start, near.side, near.place, error)["normal"]
    into = (normal * motion).sum(axis=1) > 0.0
    at_once = into & (gap <= error) & (gap >= -slack - error)
    side, place = np.where(at_once, near.side, side), np.where(at_once, near.place, place)
    way = np.where(at_once, 0.0, np.where(gap < -slack - error, np.nan, way))
    found = _contact(sides, start + np.nan_to_num(way)[:, None] * motion, side, place, error)
    missed = np.isnan(way) | ((found["normal"] * motion).sum(axis=1) <= 0.0)
    return {
        "contact": np.where(missed[:, None], np.nan, found["contact"]),
        "normal": np.where(missed[:, None], np.nan, found["normal"]),
        "side": np.where(missed, -1, found["side"]),
        "corner": found["corner"] & ~missed,
        "way": np.where(missed, np.nan, way),
        "overlap": np.where(gap < -error, -gap, 0.0),
    }


def _first_meeting(
    sides: Sides, start: Array, motion: Array, radius: Array, error: Array
) -> tuple[npt.NDArray[np.intp], Array, Array]:
    """Side, place on it, and fraction of the motion at which the center first meets the grown object."""
    ways, places = _ways_to_sides(sides, start, motion, radius, error)
    every = np.concatenate([ways, _ways_to_corners(sides, start, motion, radius)], axis=1)
    rows, which = np.arange(len(start)), np.where(np.isnan(every), np.inf, every).argmin(axis=1)
    count = len(sides.length)
    at_circle = which >= count
    side = np.where(at_circle, which - count, which)
    return side, np.where(at_circle, 0.0, places[rows, side]), every[rows, which]


def _ways_to_sides(
    sides: Sides, start: Array, motion: Array, radius: Array, error: Array
) -> tuple[Array, Array]:
    """Fractions of the motion at which the center enters each moved side, else NaN, and places there."""
    away = start[:, None] - sides.start
    height, along = ((away * each).sum(axis=-1) for each in (sides.normal, sides.tangent))
    rate, speed = motion @ sides.normal.T, motion @ sides.tangent.T
    with np.errstate(divide="ignore", invalid="ignore"):
        slack, ahead = error[:, None], -(height + radius[:, None])
        way = np.where(np.abs(ahead) <= slack, 0.0, ahead) / rate
        place = along + way * speed
        meets = (rate > 0.0) & (way >= 0.0) & (way <= 1.0)
        meets &= (place >= -slack) & (place <= sides.length + slack)
    return np.where(meets, way, np.nan), np.clip(np.nan_to_num(place), 0.0, sides.length)


def _ways_to_corners(sides: Sides, start: Array, motion: Array, radius: Array) -> Array:
    """Fractions of the motion at which the center enters the circle about each convex corner, else NaN."""
    away = start[:, None] - sides.start
    square = (motion * motion).sum(axis=1)[:, None]
    middle = (away * motion[:, None]).sum(axis=-1)
    # The circle's distance from the line of the motion, without a difference of large squares.
    aside = away[..., 0] * motion[:, None, 1] - away[..., 1] * motion[:, None, 0]
    root = square * (radius * radius)[:, None] - aside * aside
    outside = (away * away).sum(axis=-1) - (radius * radius)[:, None]
    with np.errstate(divide="ignore", invalid="ignore"):
        # The smaller root, as a ratio that does not cancel.
        way = outside / (np.sqrt(root) - middle)
    enters = sides.convex & (root > 0.0) & (middle < 0.0) & (way >= 0.0) & (way <= 1.0)
    return np.where(enters, way, np.nan)


def _contact(
    sides: Sides, center: Array, side: npt.NDArray[np.intp], place: Array, error: Array
) -> dict[str, Any]:
    """Contact and normal of a disc at its touch, on a side at a place of it."""
    after = (side + 1) % len(sides.length)
    at_start, at_end = place <= error, place >= sides.length[side] - error
    vertex = np.where(at_end, after, side)
    corner = (at_start | at_end) & sides.convex[vertex]
    point = sides.start[side] + place[:, None] * sides.tangent[side]
    point = np.where(corner[:, None], sides.start[vertex], point)
    return {
        "contact": point,
        "normal": _normal(sides, center, point, side, vertex, corner, error),
        "side": np.where(corner, (vertex - 1) % len(sides.length), side),
        "corner": corner,
    }


def _normal(
    sides: Sides, center: Array, point: Array, side: Any, vertex: Any, corner: Any, error: Array
) -> Array:
    """Normals: of the side, of a point at a corner the bisector, of a disc there from center to corner."""
    own, before = sides.normal[vertex], sides.normal[vertex - 1]
    middle = own + before
    way = point - center
    length = np.hypot(*way.T)
    outside = (length > 1e3 * error) & ((way * middle).sum(axis=1) > 0.0)
    from_center = np.where(outside[:, None], way, middle)
    found = np.where(corner[:, None], from_center, sides.normal[side])
    return np.asarray(found / np.hypot(*found.T)[:, None])


def _vectors(name: str, given: Any) -> Array:
    """Finite vectors of shape S + (2,), or `InvalidValue`."""
    found = _finite(name, given)
    if found.shape[-1:] != (2,):
        raise InvalidValue(name, found.shape, "shape S + (2,)", "give x and y along the last axis")
    return found


def _not_negative(name: str, given: Any) -> Array:
    """Finite numbers >= 0, or `InvalidValue`."""
    found = _finite(name, given)
    if (found < 0.0).any():
        raise InvalidValue(name, float(found.min()), "numbers >= 0", "give 0 for a point")
    return found


def _finite(name: str, given: Any) -> Array:
    try:
        found = np.asarray(given, dtype=float)
    except (TypeError, ValueError):
        raise InvalidValue(name, given, "finite numbers", "give floats") from None
    if not np.isfinite(found).all():
        wrong = float(found[~np.isfinite(found)][0])
        raise InvalidValue(name, wrong, "finite numbers", "leave out what was not measured")
    return found
