"""First contact of a disc that moves in a straight line with an object at rest."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.kernels.arrays import same
from planar_pushing.mechanics.outline import DRAWN, KEPT, Outline, require_outline
from planar_pushing.mechanics.outline.chains import (
    BEFORE,
    BETA0,
    BETA1,
    LENGTH,
    NEXT,
    RHO,
    X,
    Y,
    wrap,
)
from planar_pushing.mechanics.outline.places import nearest_place
from planar_pushing.mechanics.plane import Array
from planar_pushing.terms.caches import cache_results
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
        inward normal of the side or arc, or at a corner the bisector of the normals of its sides.
    side : ndarray of int, shape S
        Number of the side, which goes from corner `side` of the counterclockwise outline to the next one;
        in an outline with arcs or holes, its number among the sides, in order. At a corner, the side that
        ends there. It is -1 on an arc, at a corner at which an arc ends, and where the disc does not touch.
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
    outline : array_like, shape (n, 2), Polygon, Disc, Outline, or an object with `coords` or `exterior`
        Corners of a simple polygon, in order, or an outline with arcs and holes.
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
        If the outline is not one, a number is not finite, or a radius is negative.

    Notes
    -----
    At the touch, the center reaches the boundary of the object grown by the radius: sides moved outward by
    the radius, circles about the convex corners, and the arcs with their radii larger by the radius. It
    enters the circle of an outward arc, and leaves that of a hollow arc, which a larger disc cannot reach.
    Each of these meetings is the root of a linear or quadratic equation. At a reflex corner the disc
    reaches one of the two sides first. As a drawing is, it is exact to a millionth of the outline's size:
    a disc that close to the object touches it, a contact that close to a convex corner is at the corner,
    and a disc no larger is a point.
    """
    whole = require_outline(outline)
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
    # Pieces that are parallel to the motion, or as far away as numbers go, are not met.
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        touches = _touch(whole, places, motions, np.broadcast_to(reach, shape).ravel(), slack)
    return Touch(
        **{name: values.reshape(shape + values.shape[1:]) for name, values in touches.items()}
    )


class _Walls(NamedTuple):
    """Pieces of an outline, as arrays over its rows.

    Attributes
    ----------
    rows : ndarray, shape (n, 9)
    tangent, normal : ndarray, shape (n, 2)
        Of sides.
    normals : ndarray, shape (n, 2, 2)
        At the starts and ends of pieces.
    before, after : ndarray of int, shape (n,)
    outer : ndarray of bool, shape (n,)
        Whether the piece is a convex corner.
    number : ndarray of int, shape (n,)
        Number of a side among the sides; -1 for an arc, and for a corner that of the side that ends there.
    scale : float
    """

    rows: Array
    tangent: Array
    normal: Array
    normals: Array
    before: npt.NDArray[np.intp]
    after: npt.NDArray[np.intp]
    outer: npt.NDArray[np.bool_]
    number: npt.NDArray[np.intp]
    scale: float


@cache_results(KEPT)
def _walls_of(outline: Outline) -> _Walls:
    """The walls of an outline; they must not be written to."""
    rows = outline.pieces
    before, after = rows[:, BEFORE].astype(int), rows[:, NEXT].astype(int)
    is_side, is_corner = np.isinf(rows[:, RHO]), rows[:, RHO] == 0.0
    tangent = np.stack([np.cos(rows[:, BETA0]), np.sin(rows[:, BETA0])], axis=-1)
    # Between two corners the direction is that of the drawn corners, without the rounding of an angle.
    drawn = is_side & is_corner[after]
    chord = rows[after[drawn], :2] - rows[drawn, :2]
    tangent[drawn] = chord / np.hypot(*chord.T)[:, None]
    normal = np.stack([-tangent[:, 1], tangent[:, 0]], axis=-1) + 0.0
    ends = rows[:, [BETA0, BETA1]]
    normals = np.where(
        is_side[:, None, None], normal[:, None], np.stack([-np.sin(ends), np.cos(ends)], axis=-1)
    )
    number = np.where(is_side, np.cumsum(is_side) - 1, -1)
    number = np.where(is_corner, number[before], number)
    outer = is_corner & (rows[:, BETA1] > rows[:, BETA0])
    return _Walls(rows, tangent, normal, normals, before, after, outer, number, outline.size)


def _touch(
    outline: Outline, start: Array, motion: Array, radius: Array, slack: float
) -> dict[str, Any]:
    """Attributes of `Touch` for pushes of shape (n, 2)."""
    walls = _walls_of(outline)
    error = DRAWN * walls.scale + ROUNDING * np.abs(start).max(axis=1, initial=0.0)
    near = nearest_place(outline, start)
    gap = near.gap - radius
    piece, position, fraction = _first_meeting(walls, start, motion, radius, error)
    # A disc that starts in contact, or within the tolerance, and moves into the object touches at once.
    beside, along = _beside_inner_corners(walls, near.piece, near.position, motion)
    normal = _contact(walls, start, beside, along, radius, error)["normal"]
    into = (normal * motion).sum(axis=1) > 0.0
    at_once = into & (gap <= error) & (gap >= -slack - error)
    piece, position = np.where(at_once, beside, piece), np.where(at_once, along, position)
    fraction = np.where(at_once, 0.0, np.where(gap < -slack - error, np.nan, fraction))
    contact = _contact(
        walls, start + np.nan_to_num(fraction)[:, None] * motion, piece, position, radius, error
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


def _beside_inner_corners(
    walls: _Walls, piece: npt.NDArray[np.intp], position: Array, motion: Array
) -> tuple[npt.NDArray[np.intp], Array]:
    """Places at inner corners on the neighbor that the motion meets more directly; others stay."""
    rates = (walls.normals[piece] * motion[:, None]).sum(axis=-1)
    neighbor = np.where(rates[:, 0] >= rates[:, 1], walls.before[piece], walls.after[piece])
    end = np.where(neighbor == walls.before[piece], walls.rows[neighbor, LENGTH], 0.0)
    is_inner = (walls.rows[piece, RHO] == 0.0) & ~walls.outer[piece]
    return np.where(is_inner, neighbor, piece), np.where(is_inner, end, position)


def _first_meeting(
    walls: _Walls, start: Array, motion: Array, radius: Array, error: Array
) -> tuple[npt.NDArray[np.intp], Array, Array]:
    """Piece, place on it, and fraction of the motion at which the center first reaches the grown object."""
    is_straight = np.isinf(walls.rows[:, RHO])
    straight = np.flatnonzero(is_straight)
    bent = np.flatnonzero(~is_straight & ((walls.rows[:, RHO] != 0.0) | walls.outer))
    on_sides = _fractions_to_sides(walls, straight, start, motion, radius, error)
    on_circles = _fractions_to_circles(walls, bent, start, motion, radius, error)
    fractions, positions = (
        np.concatenate(pair, axis=1) for pair in zip(on_sides, on_circles, strict=True)
    )
    pushes, first = np.arange(len(start)), np.where(np.isnan(fractions), np.inf, fractions)
    which = first.argmin(axis=1)
    piece = np.concatenate([straight, bent])[which]
    return piece, positions[pushes, which], fractions[pushes, which]


def _fractions_to_sides(
    walls: _Walls, piece: npt.NDArray[np.intp], start: Array, motion: Array, radius: Array,
    error: Array,
) -> tuple[Array, Array]:  # fmt: skip
    """Fractions of the motion at which the center crosses each moved side, or NaN, and the places there."""
    normal, tangent, length = walls.normal[piece], walls.tangent[piece], walls.rows[piece, LENGTH]
    away = start[:, None] - walls.rows[piece, :2]
    height, along = ((away * direction).sum(axis=-1) for direction in (normal, tangent))
    rate, speed = motion @ normal.T, motion @ tangent.T
    slack, ahead = error[:, None], -(height + radius[:, None])
    fraction = np.where(np.abs(ahead) <= slack, 0.0, ahead) / rate
    position = along + fraction * speed
    meets = (rate > 0.0) & (fraction >= 0.0) & (fraction <= 1.0)
    meets &= (position >= -slack) & (position <= length + slack)
    return np.where(meets, fraction, np.nan), np.clip(np.nan_to_num(position), 0.0, length)


def _fractions_to_circles(
    walls: _Walls, piece: npt.NDArray[np.intp], start: Array, motion: Array, radius: Array,
    error: Array,
) -> tuple[Array, Array]:  # fmt: skip
    """Fractions at which the center meets the circles about corners and arcs, or NaN, and the places.

    The center meets the circle of a corner or of an outward arc from outside, and that of a hollow arc from
    inside. On an arc, the contact must be between its ends; beyond those of a corner, a neighbor is met
    first.
    """
    rho, slack = walls.rows[piece, RHO], error[:, None]
    away = start[:, None] - walls.rows[piece, :2]
    reach = rho + radius[:, None]
    is_hollow = rho < 0.0
    square = (motion * motion).sum(axis=1)[:, None]
    middle = (away * motion[:, None]).sum(axis=-1)
    # Distance of the circle's center from the line of motion, without a difference of large squares.
    across = away[..., 0] * motion[:, None, 1] - away[..., 1] * motion[:, None, 0]
    root = square * reach * reach - across * across
    outside = (away * away).sum(axis=-1) - reach * reach
    half = np.sqrt(root)
    # Each root as a sum or as a ratio without cancellation.
    enters = outside / (half - middle)
    leaves = np.where(middle < 0.0, (half - middle) / square, -outside / (half + middle))
    inward = np.where(is_hollow, middle > 0.0, middle < 0.0)
    touches = np.abs(np.hypot(away[..., 0], away[..., 1]) - np.abs(reach)) <= slack
    fraction = np.where(is_hollow, leaves, enters)
    fraction = np.where(touches & inward & (rho != 0.0), 0.0, fraction)
    meets = (root > 0.0) & ((reach < 0.0) == is_hollow) & (is_hollow | inward)
    meets &= (fraction >= 0.0) & (fraction <= 1.0)
    center = away + np.where(meets, fraction, 0.0)[..., None] * motion[:, None]
    position, is_between = _places_on_arcs(walls, piece, center, reach, slack)
    meets &= is_between | (rho == 0.0)
    return np.where(meets, fraction, np.nan), position


def _places_on_arcs(
    walls: _Walls, piece: npt.NDArray[np.intp], away: Array, reach: Array, slack: Array
) -> tuple[Array, npt.NDArray[np.bool_]]:
    """Places on arcs toward discs at offsets from their centers, and whether the arcs extend to them."""
    rows = walls.rows[piece]
    beta0, beta1 = rows[:, BETA0], rows[:, BETA1]
    sign = np.where(reach < 0.0, -1.0, 1.0)
    middle, half = (beta0 + beta1) / 2.0, np.abs(beta1 - beta0) / 2.0
    turn = wrap(np.arctan2(sign * away[..., 0], -sign * away[..., 1]) - middle)
    beta = middle + np.clip(turn, -half, half)
    return rows[:, RHO] * (beta - beta0), (np.abs(turn) - half) * np.abs(reach) <= slack


def _contact(
    walls: _Walls, center: Array, piece: npt.NDArray[np.intp], position: Array, radius: Array,
    error: Array,
) -> dict[str, Any]:  # fmt: skip
    """Contact and normal of a disc that touches a piece at a given place."""
    is_corner = walls.rows[piece, RHO] == 0.0
    before, after = walls.before[piece], walls.after[piece]
    at_start = ~is_corner & (position <= error) & walls.outer[before]
    at_end = ~is_corner & (position >= walls.rows[piece, LENGTH] - error) & walls.outer[after]
    piece = np.where(at_end, after, np.where(at_start, before, piece))
    rows = walls.rows[piece]
    is_side, is_corner = np.isinf(rows[:, RHO]), rows[:, RHO] == 0.0
    rho = np.where(is_side, 0.0, rows[:, RHO])
    beta = rows[:, BETA0] + np.where(rho != 0.0, position / np.where(rho != 0.0, rho, 1.0), 0.0)
    upward = np.stack([-np.sin(beta), np.cos(beta)], axis=-1) + 0.0
    along = np.where(is_side, position, 0.0)[:, None] * walls.tangent[piece]
    point = rows[:, [X, Y]] + along - rho[:, None] * upward
    # A disc that meets a side near its end has the normal of the side, to the digits of its position.
    offset = np.where((radius > error)[:, None], point - center, 0.0)
    normal = np.where(is_side[:, None], walls.normal[piece], upward)
    at_corner = _normals_at_corners(walls.normals[piece], offset)
    return {
        "contact": point,
        "normal": np.where(is_corner[:, None], at_corner, normal),
        "side": walls.number[piece],
        "corner": is_corner,
    }


def _normals_at_corners(ends: Array, offset: Array) -> Array:
    """Normals along offsets from the disc's centers, or else the bisectors of those of the sides."""
    bisector = ends.sum(axis=1)
    outside = (offset * bisector).sum(axis=1) > 0.0
    normals = np.where(outside[:, None], offset, bisector)
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
