"""The rows of an outline: closed chains of sides, arcs and corners, with the object on the left.

A piece has the radius of curvature rho of the boundary: infinite on a side, 0 at a corner, negative where
an arc is hollow. With beta the direction of the tangent, n = (-sin beta, cos beta) is the inward normal,
and the points of an arc about B are B - rho n(beta). The directions of consecutive pieces join.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.plane import Frame
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.numbers import Array


class Piece(NamedTuple):
    """The columns of the rows of an outline.

    Attributes
    ----------
    x, y : float
        Start of a side, center of an arc, or the corner.
    rho : float
        Radius of curvature: infinite on a side, 0 at a corner, negative for a hollow arc.
    beta0, beta1 : float
        Direction of the tangent at the start and at the end, radians, cumulative along the chain;
        beta1 < beta0 at an inner corner and on a hollow arc.
    length : float
        Arc length.
    start : float
        Arc length along the chain at the piece's start.
    next, before : float
        Rows of the neighbors.
    """

    x: float
    y: float
    rho: float
    beta0: float
    beta1: float
    length: float
    start: float
    next: float
    before: float


#: Places of the columns.
X, Y, RHO, BETA0, BETA1, LENGTH, START, NEXT, BEFORE = range(len(Piece._fields))
#: Number of columns that describe a piece without its neighbors.
OWN = START
TURN = 2.0 * math.pi
#: Largest gap between pieces that join, in sizes of the outline, and between their directions.
JOINED = 2e-6


def wrap(angles: Array) -> Array:
    """Angles in (-pi, pi]."""
    return np.asarray(math.pi - np.mod(math.pi - angles, TURN))


def number_chains(chains: Sequence[Array]) -> Array:
    """Rows of chains, shape (n, 9), from their own columns, shape (pieces, 6) each."""
    rows, first = [], 0
    for chain in chains:
        count = len(chain)
        start = np.concatenate([[0.0], np.cumsum(chain[:-1, LENGTH])])
        numbers = np.arange(count)
        neighbors = first + np.roll(numbers, -1), first + np.roll(numbers, 1)
        rows.append(np.column_stack([chain, start, *neighbors]))
        first += count
    return np.concatenate(rows)


def split_chains(pieces: Array) -> list[Array]:
    """The chains of rows, shape (pieces, 9) each; the exterior comes first."""
    # The last row of a chain leads back to its first one.
    ends = np.flatnonzero(pieces[:, NEXT] <= np.arange(len(pieces))) + 1
    return np.split(pieces, ends[:-1])


def polygon_chain(corners: Array) -> Array:
    """Own columns of the sides and corners of a ring, shape (2 n, 6), object on the left."""
    along = np.roll(corners, -1, axis=0) - corners
    beta = np.arctan2(along[:, 1], along[:, 0])
    turn = wrap(np.roll(beta, -1) - beta)
    total = TURN * round(float(turn.sum()) / TURN)
    cumulative = beta[0] + np.concatenate([[0.0], np.cumsum(turn[:-1])])
    # The sums, without their rounding errors.
    beta = beta + TURN * np.round((cumulative - beta) / TURN)
    rows = np.zeros((2 * len(corners), OWN))
    rows[0::2, :2], rows[1::2, :2] = corners, np.roll(corners, -1, axis=0)
    rows[0::2, RHO] = math.inf
    rows[0::2, BETA0] = rows[0::2, BETA1] = rows[1::2, BETA0] = beta
    rows[1::2, BETA1] = np.append(beta[1:], beta[0] + total)
    rows[0::2, LENGTH] = np.hypot(along[:, 0], along[:, 1])
    return rows


def circle(x: float, y: float, radius: float) -> Array:
    """Own columns of a whole circle, shape (1, 6); a negative radius is that of a hole."""
    return np.array([[x, y, radius, 0.0, math.copysign(TURN, radius), TURN * abs(radius)]])


def points_at(pieces: Array, beta: Array) -> Array:
    """Points of arcs at directions of the tangent; of a corner, the corner."""
    rho = pieces[..., RHO]
    points: Array = pieces[..., :2] + rho[..., None] * np.stack(
        [np.sin(beta), -np.cos(beta)], axis=-1
    )
    return points


def starts_of(pieces: Array) -> Array:
    """First points of pieces, shape (n, 2)."""
    return _ends(pieces, np.zeros(len(pieces)), pieces[:, BETA0])


def ends_of(pieces: Array) -> Array:
    """Last points of pieces, shape (n, 2)."""
    return _ends(pieces, pieces[:, LENGTH], pieces[:, BETA1])


def _ends(pieces: Array, along: Array, beta: Array) -> Array:
    is_side = np.isinf(pieces[:, RHO])
    rho = np.where(is_side, 0.0, pieces[:, RHO])
    on_side = along[:, None] * np.stack([np.cos(beta), np.sin(beta)], axis=-1)
    on_arc = rho[:, None] * np.stack([np.sin(beta), -np.cos(beta)], axis=-1)
    return np.asarray(pieces[:, :2] + np.where(is_side[:, None], on_side, on_arc))


def join_pieces(smooth: Array, tolerance: float) -> Array:
    """Own columns of a closed chain from those of its sides and arcs, with the corners between them.

    Parameters
    ----------
    smooth : ndarray, shape (n, 6)
        Sides and arcs in order. Their directions need not be cumulative.
    tolerance : float
        Sides and arcs that are shorter are left out. Arcs of one circle are joined, and neighbors whose
        directions differ by less than the tolerance have no corner.

    Returns
    -------
    ndarray, shape (m, 6)
    """
    smooth = smooth[smooth[:, LENGTH] > tolerance]
    if not len(smooth):
        return smooth
    smooth = _join_arcs(smooth, tolerance)
    if len(smooth) == 1 and math.isfinite(smooth[0, RHO]):
        return circle(*smooth[0, :3].tolist())
    after = np.roll(smooth, -1, axis=0)
    turn = wrap(after[:, BETA0] - smooth[:, BETA1])
    is_corner = _bends(smooth, after, turn, tolerance)
    change = smooth[:, BETA1] - smooth[:, BETA0]
    first = smooth[0, BETA0] + np.concatenate([[0.0], np.cumsum(change + turn)])
    begin, end = first[:-1], first[:-1] + change
    total = TURN * round(float(first[-1] - first[0]) / TURN)
    begin_after = np.append(begin[1:], begin[0] + total)
    # Where there is no corner, both directions are that of the side, or the mean of those of two arcs.
    straight = np.isinf(smooth[:, RHO]), np.isinf(after[:, RHO])
    middle = np.select(straight, (end, begin_after), (end + begin_after) / 2.0)
    end = np.where(is_corner, end, middle)
    begin_after = np.where(is_corner, begin_after, middle)
    begin = np.append(begin_after[-1] - total, begin_after[:-1])
    rows, points = [], starts_of(after)
    for k, piece in enumerate(smooth):
        x, y, rho, _, _, length = piece.tolist()
        if math.isfinite(rho):
            length = rho * (end[k] - begin[k])
        rows.append((x, y, rho, begin[k], end[k], length))
        if is_corner[k]:
            rows.append((*points[k].tolist(), 0.0, end[k], begin_after[k], 0.0))
    return np.array(rows)


def _join_arcs(smooth: Array, tolerance: float) -> Array:
    """Sides and arcs, of which consecutive arcs of one circle are one."""
    rows = [smooth[0]]
    for piece in smooth[1:]:
        if _are_one_circle(rows[-1], piece, tolerance):
            rows[-1] = _union_of_arcs(rows[-1], piece)
        else:
            rows.append(piece)
    if len(rows) > 1 and _are_one_circle(rows[-1], rows[0], tolerance):
        rows[0] = _union_of_arcs(rows.pop(), rows[0])
    return np.array(rows)


def _union_of_arcs(one: Array, other: Array) -> Array:
    """The arc of two consecutive arcs of one circle."""
    arc = one.copy()
    arc[BETA1] += other[BETA1] - other[BETA0]
    arc[LENGTH] += other[LENGTH]
    return arc


def _are_one_circle(one: Array, other: Array, tolerance: float) -> bool:
    """Whether the second of two arcs goes on on the circle of the first."""
    if not (math.isfinite(one[RHO]) and math.isfinite(other[RHO])):
        return False
    turn = abs(math.remainder(float(other[BETA0] - one[BETA1]), TURN)) * abs(one[RHO])
    apart = np.hypot(*(one[:2] - other[:2])) + abs(one[RHO] - other[RHO])
    return bool(max(turn, apart) <= tolerance)


def _bends(one: Array, other: Array, turn: Array, tolerance: float) -> npt.NDArray[np.bool_]:
    """Whether there are corners between pieces: a piece with both directions leaves the tolerance."""
    harmonic = one[:, LENGTH] * other[:, LENGTH] / (one[:, LENGTH] + other[:, LENGTH])
    arcs = [np.where(np.isinf(part[:, RHO]), 0.0, np.abs(part[:, RHO])) for part in (one, other)]
    return np.asarray(np.abs(turn) * np.maximum(harmonic, np.maximum(*arcs)) > tolerance)


def has_needless(chain: Array, tolerance: float, rounding: float) -> bool:
    """Whether a chain has pieces without length or turn, or neighbors that are one side, arc or corner.

    Parameters
    ----------
    chain : ndarray, shape (n, 9)
    tolerance : float
        Lengths up to it, and turns that bend the neighbors no farther, count as none.
    rounding : float
        Largest difference between two arcs of one circle.
    """
    is_corner = chain[:, RHO] == 0.0
    if len(chain) == 1:
        return False
    if (is_corner & np.roll(is_corner, -1)).any() or (chain[~is_corner, LENGTH] <= tolerance).any():
        return True
    smooth = chain[~is_corner]
    after = np.roll(smooth, -1, axis=0)
    bends = _bends(smooth, after, wrap(after[:, BETA0] - smooth[:, BETA1]), tolerance)
    is_side = np.isinf(smooth[:, RHO])
    if (np.roll(is_corner, -1)[~is_corner] & ~bends).any():
        return True
    pairs = zip(smooth, after, strict=True)
    return bool(
        (is_side & np.isinf(after[:, RHO]) & ~bends).any()
        or any(_are_one_circle(one, other, rounding) for one, other in pairs)
    )


def reverse_chain(chain: Array) -> Array:
    """Own columns of a chain in the other order: the boundary of a hole in the shape of an object."""
    rows = chain[::-1, :OWN].copy()
    is_side = np.isinf(rows[:, RHO])
    rows[is_side, :2] = ends_of(chain[::-1])[is_side]
    rows[:, RHO] = np.where(is_side, math.inf, 0.0 - rows[:, RHO])
    rows[:, BETA0], rows[:, BETA1] = chain[::-1, BETA1] + math.pi, chain[::-1, BETA0] + math.pi
    if len(rows) == 1:
        rows[0, BETA0], rows[0, BETA1] = 0.0, math.copysign(TURN, rows[0, RHO])
    if not rows[0, LENGTH]:  # a corner, which goes to the end
        turn = rows[-1, BETA1] - rows[0, BETA0]
        rows = np.roll(rows, -1, axis=0)
        rows[-1, [BETA0, BETA1]] += turn
    return upright_first(rows)


def upright_first(chain: Array) -> Array:
    """A chain whose first direction is in (-pi, pi]; that of a circle is 0."""
    rows = chain.copy()
    if len(rows) > 1:
        shift = TURN * math.ceil((rows[0, BETA0] - math.pi) / TURN)
        rows[:, [BETA0, BETA1]] -= shift
    return rows


def move_chain(chain: Array, frame: Frame) -> Array:
    """Own columns of a chain in another frame."""
    rows = chain[:, :OWN].copy()
    rows[:, :2] = frame.point_in(rows[:, :2])
    if len(rows) > 1:
        rows[:, [BETA0, BETA1]] -= math.atan2(float(frame.axis[1]), float(frame.axis[0]))
    return upright_first(rows)


def sample_chain(chain: Array, tolerance: float) -> Array:
    """Vertices of a polygon within the tolerance of a chain, shape (n, 2); all corners are among them."""
    points = []
    for piece in chain:
        x, y, rho, beta0, beta1 = piece[:5].tolist()
        if math.isinf(rho):
            points.append(np.array([[x, y]]))
        elif rho:
            step = 2.0 * math.acos(max(1.0 - tolerance / abs(rho), 0.5))
            count = max(math.ceil(abs(beta1 - beta0) / step), 3 if len(chain) < 3 else 1)
            beta = beta0 + (beta1 - beta0) / count * np.arange(count)
            points.append(points_at(piece, beta))
    return np.concatenate(points)


def require_chains(rows: Array) -> None:
    """Refuse rows whose neighbors, points or directions do not join."""
    count = len(rows)
    numbers = rows[:, NEXT:]
    is_whole = np.isfinite(numbers).all() and (numbers == np.round(numbers)).all()
    if not is_whole or not ((numbers >= 0) & (numbers < count)).all() or np.isnan(rows).any():
        raise _refusal("rows of neighbors from 0 on, in order along each chain")
    chains = split_chains(rows)
    again = number_chains([chain[:, :OWN] for chain in chains])
    size = float((np.ptp(starts_of(rows), axis=0)).max()) or float(np.abs(rows[0, RHO]))
    turns = rows[rows[:, NEXT].astype(int), BETA0] - rows[:, BETA1]
    apart = starts_of(rows)[rows[:, NEXT].astype(int)] - ends_of(rows)
    joins = np.abs(turns - 2.0 * math.pi * np.round(turns / (2.0 * math.pi))) <= JOINED
    joins &= np.hypot(apart[:, 0], apart[:, 1]) <= JOINED * size
    if not np.allclose(again, rows, rtol=1e-9, atol=JOINED * size) or not joins.all():
        raise _refusal("closed chains whose points and directions join")
    if (rows[:, LENGTH] < 0.0).any():
        raise _refusal("lengths that are not negative")


def _refusal(allowed: str) -> InvalidValue:
    return InvalidValue(
        "pieces", "rows that are no outline", allowed, "copy them from Outline.pieces"
    )
