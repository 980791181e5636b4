"""Contacts on the outline of an object: the side that each touches, and its normal."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.frames import Placement
from planar_pushing.mechanics.outline import Corners, size
from planar_pushing.mechanics.plane import Array
from planar_pushing.objects.many import Contacts
from planar_pushing.terms.domain import Number
from planar_pushing.terms.errors import InvalidValue

#: A point closer to a side than this, relative to the outline's size, counts as on it: drawings are no more
#: precise.
ON = 1e-6
#: A distance below this is rounding. A point farther away is moved onto the side, because a corner below
#: the fence ends a simulation.
EXACT = 1e-12
#: Largest angle, in radians, between a given normal and that of its side.
ALIGNED = 1e-3


class Nearest(NamedTuple):
    """The sides of an outline nearest to points, as arrays over the points.

    Attributes
    ----------
    point, inward : ndarray, shape (n, 2)
        Nearest points of the sides, and inward unit normals.
    before, behind : ndarray, shape (n,)
        Distances along the side to its start and its end.
    distance : ndarray, shape (n,)
    """

    point: Array
    inward: Array
    before: Array
    behind: Array
    distance: Array


def on_outline(contacts: Contacts, corners: Corners) -> tuple[Placement, tuple[Number, Number]]:
    """The placements of contacts, and the ends of their sides relative to them; infinite at a corner.

    A normal within a thousandth of a radian of that of the side is replaced by it. A point closer to the
    side than a millionth of the outline's size is moved onto it.

    Raises
    ------
    InvalidValue
        If a point is not on the outline, or a fence with its normal would pass through the object. The
        error names the first contact that the failing check refuses.
    """
    points, starts = contacts.points, np.array(corners)
    scale, sides = size(starts), _nearest(points, starts)
    _require_on(contacts, sides.distance <= ON * scale, sides.point)
    away = points[:, None] - starts
    near = np.hypot(away[..., 0], away[..., 1]) <= ON * scale
    at_corner, corner = near.any(axis=1), near.argmax(axis=1)
    _require_between(contacts, at_corner, starts, corner)
    _require_aligned(contacts, ~at_corner, sides.inward)
    target = np.where(at_corner[:, None], starts[corner], sides.point)
    is_exact = np.hypot(*(target - points).T) <= EXACT * scale
    ends = np.column_stack([-sides.before, sides.behind])
    ends[at_corner] = -np.inf, np.inf
    # Without normals, no contact is at a corner.
    normals = np.where(at_corner[:, None], contacts.normals, sides.inward)
    points = np.where(is_exact[:, None], points, target)
    return Placement(contacts.pair(points), contacts.pair(normals)), contacts.pair(ends)


def _nearest(points: Array, starts: Array) -> Nearest:
    """The nearest sides of an outline with these corners."""
    along = np.roll(starts, -1, axis=0) - starts
    lengths = np.hypot(*along.T)
    away = points[:, None] - starts
    places = (away * along).sum(axis=-1) / lengths
    across = (along[:, 0] * away[..., 1] - along[:, 1] * away[..., 0]) / lengths
    distances = np.hypot(across, np.maximum(np.maximum(-places, places - lengths), 0.0))
    side = distances.argmin(axis=1)
    chosen = np.arange(len(points)), side
    place, along, length = places[chosen], along[side], lengths[side]
    nearest = starts[side] + (np.clip(place, 0.0, length)[:, None] * along / length[:, None])
    inward = np.column_stack([0.0 - along[:, 1] / length, along[:, 0] / length + 0.0])
    return Nearest(nearest, inward, place, length - place, distances[chosen])


def _require_on(contacts: Contacts, touches: npt.NDArray[np.bool_], nearest: Array) -> None:
    """Refuse a point that is not on the outline."""
    if not touches.all():
        i = int(touches.argmin())
        raise InvalidValue(
            "point", contacts.given("point", i), "a point on the outline",
            f"the nearest one is ({nearest[i, 0]:.6g}, {nearest[i, 1]:.6g})",
        )  # fmt: skip


def _require_aligned(contacts: Contacts, beside: npt.NDArray[np.bool_], inward: Array) -> None:
    """Refuse a normal that is not that of the side, for a contact away from the corners."""
    if contacts.normal is None:
        return
    turn = np.hypot(*(contacts.normals - inward).T)
    refused = np.flatnonzero(beside & (turn > ALIGNED))
    if len(refused):
        i = refused[0]
        raise InvalidValue(
            "normal", contacts.given("normal", i),
            f"the inward normal of the side, ({inward[i, 0]:.6g}, {inward[i, 1]:.6g})",
            "with another one the fence would pass through the object; leave the normal out",
        )  # fmt: skip


def _require_between(
    contacts: Contacts,
    at_corner: npt.NDArray[np.bool_],
    starts: Array,
    corner: npt.NDArray[np.intp],
) -> None:
    """Refuse a normal at a corner that would leave a side of the object beyond the fence."""
    numbers = np.flatnonzero(at_corner)
    if not len(numbers):
        return
    if contacts.normal is None:
        raise InvalidValue(
            "normal", None, "the normal of the fence at a corner",
            "give it: a corner touches a fence at any angle between those of its sides",
        )  # fmt: skip
    corner, normals = corner[numbers], contacts.normals[numbers]
    before = starts[corner - 1] - starts[corner]
    behind = starts[(corner + 1) % len(starts)] - starts[corner]
    (a, b), (c, d) = (each.T / np.hypot(*each.T) for each in (before, behind))
    x, y = normals.T
    # At a reflex corner a finger can push one of the sides.
    aligned = np.maximum(b * x - a * y, c * y - d * x)
    reflex = (a * d - b * c > 0.0) & (aligned > 1.0 - ALIGNED**2)
    refused = (np.minimum(a * x + b * y, c * x + d * y) < -ALIGNED) & ~reflex
    if refused.any():
        i = int(refused.argmax())
        raise InvalidValue(
            "normal", tuple(normals[i].tolist()), "a normal between those of the corner's sides",
            "with this one the fence would pass through the object",
        )  # fmt: skip
