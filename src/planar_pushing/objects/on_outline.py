"""Contacts on the outline of an object: the side that each touches, its normal, and whole sides."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.outline import (
    DRAWN,
    KEPT,
    Corners,
    Outline,
    outline_of_corners,
    read_drawing,
    require_outline,
)
from planar_pushing.mechanics.outline.chains import BEFORE, BETA0, BETA1, LENGTH, NEXT, RHO, wrap
from planar_pushing.mechanics.outline.places import nearest_place
from planar_pushing.mechanics.outline.plate import extreme_points
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


def on_outline(contacts: Contacts, outline: Outline) -> tuple[Placement, tuple[Number, Number]]:
    """The placements of contacts, and the ends of their sides relative to them.

    A point is moved onto the outline, and onto a corner that is within the tolerance of drawings. Away from
    corners, the normal is replaced by that of the side or of the arc. At a corner it is replaced if with it
    a side lies on the fence, which then ends at the contact; otherwise, and on an arc, the side has no
    length. An instant depends on an arc by its normal alone.

    Raises
    ------
    InvalidValue
        If a point is not on the outline or is at an inner corner, or a fence with its normal would pass
        through the object. The error names the first contact that the failing check refuses.
    """
    corners = outline.corners
    if corners is None:
        return _on_chain(contacts, outline)
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
        _require_outer(contacts, is_near, sides.convex)
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


def _on_chain(contacts: Contacts, outline: Outline) -> tuple[Placement, tuple[Number, Number]]:
    """As `on_outline`, for an outline with arcs or holes."""
    points, pieces, tolerance = contacts.points, outline.pieces, outline.tolerance
    spot = nearest_place(outline, points)
    _require_on(contacts, np.abs(spot.gap) <= tolerance, spot.point)
    rows = pieces[spot.piece]
    corner = np.flatnonzero(pieces[:, RHO] == 0.0)
    away = points[:, None] - pieces[corner, :2]
    distance = np.hypot(away[..., 0], away[..., 1])
    is_near = np.asarray(distance <= tolerance)
    at_corner = np.asarray(is_near.any(axis=1))
    convex = pieces[corner, BETA1] > pieces[corner, BETA0]
    if at_corner.any():
        _require_outer(contacts, is_near, convex)
    normals = spot.normal + 0.0
    _require_aligned(contacts, ~at_corner, normals)
    is_side = np.isinf(rows[:, RHO])
    lengths = np.where(is_side, rows[:, LENGTH] - spot.position, 0.0)
    ends = np.stack([np.where(is_side, -spot.position, 0.0), lengths], axis=-1)
    points = spot.point.copy()
    for i in np.flatnonzero(at_corner):
        nearest_corner = int(corner[distance[i].argmin()])
        points[i] = pieces[nearest_corner, :2]
        normals[i], ends[i] = _at_joint(outline, nearest_corner, contacts.normals[i])
    return Placement(contacts.pair(points), contacts.pair(normals)), contacts.pair(ends)


def _at_joint(outline: Outline, corner: int, normal: Array) -> tuple[Array, Array]:
    """Normal of a contact at a corner of an outline with arcs, and the ends of its side."""
    pieces, ends = outline.pieces, np.zeros(2)
    beta0, beta1 = pieces[corner, [BETA0, BETA1]]
    middle = (beta0 + beta1) / 2.0
    beta = middle + float(wrap(np.arctan2(-normal[0], normal[1]) - middle))
    if not beta0 - ALIGNED <= beta <= beta1 + ALIGNED:
        raise InvalidValue(
            "normal", tuple(normal.tolist()), "a normal between those of the corner's sides",
            "with this one the fence would pass through the object",
        )  # fmt: skip
    sides = (
        (beta - beta0, int(pieces[corner, BEFORE]), 0, -1.0),
        (beta1 - beta, int(pieces[corner, NEXT]), 1, 1.0),
    )
    lean, side, end, sign = min(sides)
    length, rho = pieces[side, LENGTH], pieces[side, RHO]
    if np.isinf(rho) and lean < ALIGNED and length * lean <= outline.tolerance:
        direction = pieces[side, BETA0]
        ends[end] = sign * length
        return np.array([-np.sin(direction), np.cos(direction)]) + 0.0, ends
    return normal, ends


def side_on_fence(side: Any, outline: Any) -> tuple[Placement, tuple[float, float], Outline]:
    """The placement of a fence along a side of an outline, the ends of the contact, and the outline.

    Parameters
    ----------
    side : int
        Number of the side, which goes from the corner with this number to the next one, counted from 0 in
        the order of the outline. A side that is a part of a longer straight side stands for all of it. In
        an `Outline` with arcs, the sides of the exterior are counted.
    outline : sequence of pairs, Polygon, Outline, or an object with `coords` or `exterior`

    Returns
    -------
    placement : Placement
        At the midpoint of the side.
    ends : (start, end)
        Of all points of the outline on the fence, along it from the midpoint: those of the side, unless
        another part of the outline is on the same line.
    outline : Outline

    Raises
    ------
    InvalidValue
        If there is no such side, or the fence would pass through the object.
    """
    whole = require_outline(outline)
    corners = whole.exterior.corners
    if corners is None:
        start, tangent, length = _side_of_chain(side, whole.exterior)
        points = extreme_points(whole.exterior.pieces, float(np.arctan2(tangent[0], -tangent[1])))
    else:
        number = _side_of_drawing(side, corners if isinstance(outline, Outline) else outline)
        sides = sides_between(corners)
        start, tangent, length = sides.start[number], sides.tangent[number], sides.length[number]
        points = sides.start
    normal = np.array([-tangent[1], tangent[0]]) + 0.0
    origin = start + length / 2.0 * tangent
    heights = (points - origin) @ normal
    if heights.min() < -whole.tolerance:
        raise InvalidValue(
            "side", side, "a side with the whole object on one side of its line",
            "the fence would pass through the object; push the side at a point, with a finger",
        )  # fmt: skip
    # The fence's +x is along the side, because the object is to the left of it.
    along = ((points - origin) @ tangent)[heights <= whole.tolerance]
    ends = float(along.min()), float(along.max())
    placement = Placement(
        (float(origin[0]), float(origin[1])), (float(normal[0]), float(normal[1]))
    )
    return placement, ends, whole


def _side_of_drawing(side: Any, outline: Any) -> int:
    """The side of an outline for that of its drawing."""
    drawing = read_drawing(outline)
    _require_number(side, len(drawing.vertices))
    corners = np.array(drawing.corners)
    _require_long(
        int(side), drawing.vertices, corners, outline_of_corners(drawing.corners).tolerance
    )
    return int(drawing.side[side])


def _side_of_chain(side: Any, outline: Outline) -> tuple[Array, Array, float]:
    """Start, tangent and length of a side of an outline with arcs."""
    rows = outline.pieces[np.isinf(outline.pieces[:, RHO])]
    if not len(rows):
        raise InvalidValue(
            "side", side, "an outline with sides", "push a round object at a point of its wall"
        )
    _require_number(side, len(rows), "count the sides from 0, without the arcs, in order")
    row = rows[int(side)]
    return row[:2], np.array([np.cos(row[BETA0]), np.sin(row[BETA0])]), float(row[LENGTH])


def _require_number(
    side: Any,
    count: int,
    remedy: str = "give the number of the corner at which the side begins, in the order of the outline",
) -> None:
    """Refuse what is not the number of a side."""
    if isinstance(side, bool) or not isinstance(side, (int, np.integer)) or not 0 <= side < count:
        raise InvalidValue("side", side, f"a whole number from 0 to {count - 1}", remedy)


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


def _require_outer(
    contacts: Contacts, is_near: npt.NDArray[np.bool_], convex: npt.NDArray[np.bool_]
) -> None:
    """Refuse a contact at an inner corner, and one at an outer corner without a normal."""
    is_inner = (is_near & ~convex).any(axis=1)
    if is_inner.any():
        raise InvalidValue(
            "point", contacts.original("point", int(is_inner.argmax())),
            "a point that is not at an inner corner",
            "a pusher there touches two sides; move the contact off the corner, "
            "or give solve_contacts a Contact for each side",
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
