"""Contacts on the outline of an object: the side that each touches, its normal, and whole sides."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.outline import DRAWN, KEPT, Corners, read_drawing
from planar_pushing.mechanics.plane import Array, Placement
from planar_pushing.objects.boundary import Sides, nearest_unsigned, sides_between
from planar_pushing.objects.many import Contacts
from planar_pushing.terms.caches import cache_results
from planar_pushing.terms.domain import Number
from planar_pushing.terms.errors import InvalidValue

#: Largest angle, in radians, between a given normal and that of its side.
ALIGNED = 1e-3
#: Number of sides up to which one contact is compared with floats faster than with arrays.
FEW = 128


def on_outline(contacts: Contacts, corners: Corners) -> tuple[Placement, tuple[Number, Number]]:
    """The placements of contacts, and the ends of their sides relative to them.

    A point is moved onto the outline, and onto a corner that is within the tolerance of drawings. Away from
    corners, the normal is replaced by that of the side. At a corner it is replaced if with it a side lies
    on the fence, which then ends at the contact; otherwise the side has no length.

    Raises
    ------
    InvalidValue
        If a point is not on the outline or is at an inner corner, or a fence with its normal would pass
        through the object. The error names the first contact that the failing check refuses.
    """
    if not contacts.shape and (answer := _on_one_side(contacts, corners)) is not None:
        return answer
    points, sides = contacts.points, sides_between(corners)
    spot = nearest_unsigned(sides, points)
    along, inward = spot.position, sides.normal[spot.side]
    _require_on(contacts, spot.gap <= DRAWN * sides.scale, spot.point)
    away = points[:, None] - sides.start
    distance = np.hypot(away[..., 0], away[..., 1])
    is_near = np.asarray(distance <= DRAWN * sides.scale)
    at_corner = np.asarray(is_near.any(axis=1))
    pushes_corner = bool(at_corner.any())
    if pushes_corner:
        _require_outer(contacts, is_near, sides)
    _require_aligned(contacts, ~at_corner, inward)
    height = ((points - sides.start[spot.side]) * inward).sum(axis=1)
    points = points - height[:, None] * inward
    ends = np.array([-along, sides.length[spot.side] - along]).T
    normals = inward
    if pushes_corner:
        # Without normals, no contact is at a corner.
        normals = np.where(at_corner[:, None], contacts.normals, inward)
        pushed, corner = np.flatnonzero(at_corner), _corners(contacts, sides, distance, is_near)
        points[pushed] = sides.start[corner]
        normals[pushed], ends[pushed] = _at_corner(sides, corner, normals[pushed])
    return Placement(contacts.pair(points), contacts.pair(normals)), contacts.pair(ends)


def _on_one_side(
    contacts: Contacts, corners: Corners
) -> tuple[Placement, tuple[float, float]] | None:
    """As `on_outline`, for one contact clearly on one side: the same numbers, in a tenth of the time.

    None for any other contact, for one that is refused, and for an outline with many corners.
    """
    (x, y), (n_x, n_y) = contacts.placement.point, contacts.placement.normal
    tolerance, sides = _numbers_of_sides(corners)
    near, touching = 4.0 * tolerance * tolerance, []
    for side in sides:
        start_x, start_y, t_x, t_y, *_, length = side
        away_x, away_y = x - start_x, y - start_y
        if away_x * away_x + away_y * away_y <= near:
            return None
        along = min(max(away_x * t_x + away_y * t_y, 0.0), length)
        off_x, off_y = away_x - along * t_x, away_y - along * t_y
        square = off_x * off_x + off_y * off_y
        if square <= near:
            touching.append((square, along, away_x, away_y, side))
    if len(touching) != 1 or touching[0][0] > near / 16.0:
        return None
    _, along, away_x, away_y, (*_, in_x, in_y, length) = touching[0]
    if contacts.normal is not None and np.hypot(n_x - in_x, n_y - in_y) > ALIGNED:
        return None
    height = away_x * in_x + away_y * in_y
    point = x - height * in_x, y - height * in_y
    return Placement(point, (in_x, in_y)), (-along, length - along)


@cache_results(KEPT)
def _numbers_of_sides(corners: Corners) -> tuple[float, list[list[float]]]:
    """The tolerance of an outline, and start, tangent, normal and length of its sides; none of many."""
    sides = sides_between(corners)
    columns = sides.start, sides.tangent, sides.normal, sides.length
    few = np.column_stack(columns).tolist() if len(corners) <= FEW else []
    return DRAWN * sides.scale, few


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
    drawing = read_drawing(outline)
    count, sides = len(drawing.vertices), sides_between(drawing.corners)
    if isinstance(side, bool) or not isinstance(side, (int, np.integer)) or not 0 <= side < count:
        raise InvalidValue(
            "side", side, f"a whole number from 0 to {count - 1}",
            "give the number of the corner at which the side begins, in the order of the outline",
        )  # fmt: skip
    tolerance = DRAWN * sides.scale
    _require_long(int(side), drawing.vertices, sides.start, tolerance)
    number = int(drawing.side[side])
    tangent, normal = sides.tangent[number], sides.normal[number]
    origin = sides.start[number] + sides.length[number] / 2.0 * tangent
    heights = (sides.start - origin) @ normal
    if heights.min() < -tolerance:
        raise InvalidValue(
            "side", side, "a side with the whole object on one side of its line",
            "the fence would pass through the object; push the side at a point, with a finger",
        )  # fmt: skip
    # The fence's +x is along the side, because the object is to the left of it.
    along = ((sides.start - origin) @ tangent)[heights <= tolerance]
    start, end = float(along.min()), float(along.max())
    placement = Placement(
        (float(origin[0]), float(origin[1])), (float(normal[0]), float(normal[1]))
    )
    return placement, (start, end), drawing.corners


def _require_long(side: int, vertices: Array, corners: Array, tolerance: float) -> None:
    """Refuse a side between two vertices that are drawn for one corner."""
    start, end = vertices[side], vertices[(side + 1) % len(vertices)]
    if np.hypot(*(end - start)) > tolerance:
        return
    if (np.hypot(*(corners - (start + end) / 2.0).T) <= 2.0 * tolerance).any():
        raise InvalidValue(
            "side", side, "a side longer than a millionth of the size of the outline",
            "its ends are one corner; give the number of the side before it or behind it",
        )  # fmt: skip


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


def _require_outer(contacts: Contacts, is_near: npt.NDArray[np.bool_], sides: Sides) -> None:
    """Refuse a contact at an inner corner, and one at an outer corner without a normal."""
    is_inner = (is_near & ~sides.convex).any(axis=1)
    if is_inner.any():
        raise InvalidValue(
            "point", contacts.original("point", int(is_inner.argmax())),
            "a point that is not at an inner corner",
            "a pusher there touches two sides; move the contact off the corner",
        )  # fmt: skip
    if contacts.normal is None and is_near.any():
        raise InvalidValue(
            "normal", None, "the normal of the fence at a corner",
            "give it: a corner touches a fence at any angle between those of its sides",
        )  # fmt: skip


def _corners(
    contacts: Contacts, sides: Sides, distance: Array, is_near: npt.NDArray[np.bool_]
) -> npt.NDArray[np.intp]:
    """The corners at which contacts are: the nearest with its normal between those of its sides.

    A normal that would leave a side of the object beyond the fence is refused.
    """
    number, corner = np.nonzero(is_near)
    leans = np.minimum(*_leans(sides, corner, contacts.normals[number]))
    is_refused = leans < -ALIGNED
    order = np.lexsort([distance[number, corner], is_refused, number])
    contact, first = np.unique(number[order], return_index=True)
    chosen = order[first]
    if is_refused[chosen].any():
        i = int(contact[is_refused[chosen].argmax()])
        raise InvalidValue(
            "normal", tuple(contacts.normals[i].tolist()),
            "a normal between those of the corner's sides",
            "with this one the fence would pass through the object",
        )  # fmt: skip
    return corner[chosen]


def _at_corner(sides: Sides, corner: npt.NDArray[np.intp], normals: Array) -> tuple[Array, Array]:
    """Normals of contacts at corners, and ends of their sides, which are points at tilted normals."""
    ends = np.zeros((len(corner), 2))
    leans = _leans(sides, corner, normals)
    # Of both sides, the one closer to the fence; the second one begins at the corner.
    for lean, other, side, end, sign in (
        (leans[0], leans[1], corner - 1, 0, -1.0), (leans[1], leans[0], corner, 1, 1.0),
    ):  # fmt: skip
        length = sides.length[side]
        lies = (lean < ALIGNED) & (length * lean <= DRAWN * sides.scale)
        lies &= (lean < other) if end else (lean <= other)
        normals = np.where(lies[:, None], sides.normal[side], normals)
        ends[lies, end] = sign * length[lies]
    return normals, ends


def _leans(sides: Sides, corner: npt.NDArray[np.intp], normals: Array) -> tuple[Array, Array]:
    """Sines of the angles between fences at corners and the sides that end there and that begin there."""
    before, behind = -sides.tangent[corner - 1], sides.tangent[corner]
    return (before * normals).sum(axis=1), (behind * normals).sum(axis=1)
