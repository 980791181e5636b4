"""Contacts on the outline of an object: the side that each touches, its normal, and whole sides."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.outline import Corners, require_outline
from planar_pushing.mechanics.plane import Array, Placement
from planar_pushing.mechanics.supports.polygon import simple_ring
from planar_pushing.objects.boundary import nearest, sides_between
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
    points, sides = contacts.points, sides_between(np.array(corners))
    spot = nearest(sides, points)
    along, inward = spot.position, sides.normal[spot.side]
    target = sides.start[spot.side] + along[:, None] * sides.tangent[spot.side]
    _require_on(contacts, np.abs(spot.gap) <= ON * sides.scale, target)
    away = points[:, None] - sides.start
    near = np.asarray(np.hypot(away[..., 0], away[..., 1]) <= ON * sides.scale)
    at_corner, corner = np.any(near, axis=1), near.argmax(axis=1)
    _require_between(contacts, at_corner, sides.start, corner)
    _require_aligned(contacts, ~at_corner, inward)
    target = np.where(at_corner[:, None], sides.start[corner], target)
    is_exact = np.hypot(*(target - points).T) <= EXACT * sides.scale
    ends = np.column_stack([-along, sides.length[spot.side] - along])
    ends[at_corner] = -np.inf, np.inf
    # Without normals, no contact is at a corner.
    normals = np.where(at_corner[:, None], contacts.normals, inward)
    points = np.where(is_exact[:, None], points, target)
    return Placement(contacts.pair(points), contacts.pair(normals)), contacts.pair(ends)


def side_on_fence(side: Any, outline: Any) -> tuple[Placement, tuple[float, float], Corners]:
    """The placement of a fence along a side of an outline, the ends of the contact, and the corners.

    Parameters
    ----------
    side : int
        Number of the side, which goes from the corner with this number to the next one, counted from 0 in
        the order of the outline. A side that is a part of a longer straight side stands for all of it.
    outline : sequence of pairs, or an object with `coords` or `exterior`

    Returns
    -------
    placement : Placement
        At the midpoint of the side.
    ends : (start, end)
        Of all points of the outline on the fence, along it from the midpoint: those of the side, unless
        another part of the outline is on the same line.
    corners : tuple of pairs
        As of `require_outline`.

    Raises
    ------
    InvalidValue
        If there is no such side, or the fence would pass through the object.
    """
    corners = require_outline(outline)
    vertices = simple_ring("outline", outline)
    if (
        isinstance(side, bool)
        or not isinstance(side, (int, np.integer))
        or not 0 <= side < len(vertices)
    ):
        raise InvalidValue(
            "side", side, f"a whole number from 0 to {len(vertices) - 1}",
            "give the number of the corner at which the side begins, in the order of the outline",
        )  # fmt: skip
    sides = sides_between(np.array(corners))
    middle = (vertices[side] + vertices[(int(side) + 1) % len(vertices)]) / 2.0
    number = int(nearest(sides, middle[None]).side[0])
    tangent, normal = sides.tangent[number], sides.normal[number]
    origin = sides.start[number] + sides.length[number] / 2.0 * tangent
    heights = (sides.start - origin) @ normal
    if heights.min() < -EXACT * sides.scale:
        raise InvalidValue(
            "side", side, "a side with the whole object on one side of its line",
            "the fence would pass through the object; push the side at a point, with a finger",
        )  # fmt: skip
    # The fence's +x is along the side, because the object is to the left of it.
    along = ((sides.start - origin) @ tangent)[heights <= EXACT * sides.scale]
    start, end = float(along.min()), float(along.max())
    placement = Placement(
        (float(origin[0]), float(origin[1])), (float(normal[0]), float(normal[1]))
    )
    return placement, (start, end), corners


def _require_on(contacts: Contacts, touches: npt.NDArray[np.bool_], nearest: Array) -> None:
    """Refuse a point that is not on the outline."""
    if not touches.all():
        i = int(touches.argmin())
        raise InvalidValue(
            "point", contacts.original("point", i), "a point on the outline",
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
            "normal", contacts.original("normal", i),
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
    (a, b), (c, d) = (edge.T / np.hypot(*edge.T) for edge in (before, behind))
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
