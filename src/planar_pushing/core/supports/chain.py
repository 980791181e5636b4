"""An outline as a chain of pieces: its place nearest to a point, and where a disc along it meets others.

A piece is a side, an arc or a corner. With the direction b of its tangent, the object on the left, the
inward normal is (-sin b, cos b), and the points of an arc about a center C are C + R (sin b, -cos b), with
a radius R that is negative for a hollow arc and 0 for a corner. An arc and an outer corner have all
directions between those of their ends. At an inner corner the direction decreases; no other piece touches
only there.
"""

from __future__ import annotations

from math import atan2, copysign, cos, fabs, floor, sin, sqrt
from typing import NamedTuple

from planar_pushing.core._record import Record, size_of
from planar_pushing.core.numbers import INFINITY, UNKNOWN, Numbers

#: A full turn.
FULL_TURN = 6.283185307179586


class ChainPiece(Record):
    """A piece of an outline.

    Attributes
    ----------
    x, y : float
        Start of a side, center of an arc, or the corner.
    radius : float
        Of curvature: infinite for a side, 0 for a corner, and negative for a hollow arc.
    first, last : float
        Directions of the tangent at its start and at its end, in radians.
    length, start : float
        Arc length, and that of its chain before it.
    next, before : int
        Numbers of its neighbors.
    along_x, along_y : float
        Unit tangent of a side; at the start of another piece.
    """

    x: float
    y: float
    radius: float
    first: float
    last: float
    length: float
    start: float
    next: int
    before: int
    along_x: float
    along_y: float


CHAIN_PIECE = size_of(ChainPiece)


class NearestPlace(NamedTuple):
    """The place of an outline nearest to a point.

    Attributes
    ----------
    piece : int
    place : float
        Distance from the start of a side, or direction of the tangent.
    distance : float
        Of the point, negative inside.
    """

    piece: int
    place: float
    distance: float


class Stretch(NamedTuple):
    """An interval of places on a piece, empty if `low` is greater than `high`."""

    low: float
    high: float


class Crossings(NamedTuple):
    """Two points at which two lines or circles meet, NaN without them."""

    x: float
    y: float
    other_x: float
    other_y: float


def chain_piece(chain: Numbers, number: int) -> ChainPiece:
    """A piece of a chain."""
    return ChainPiece(chain[number * CHAIN_PIECE :])


def arc_length_at(piece: ChainPiece, place: float) -> float:
    """Arc length of a chain at a place of a piece."""
    if is_side(piece):
        return piece.start + place
    return piece.start + piece.radius * (place - piece.first)


def length_of_chain(chain: Numbers, number: int) -> float:
    """Arc length of the closed chain that has a piece."""
    piece = chain_piece(chain, number)
    length, k = piece.length, piece.next
    while k != number:
        piece = chain_piece(chain, k)
        length, k = length + piece.length, piece.next
    return length


def is_side(piece: ChainPiece) -> bool:
    """Whether a piece is a side."""
    return piece.radius == INFINITY


def is_inner_corner(piece: ChainPiece) -> bool:
    """Whether a piece is an inner corner."""
    return piece.radius == 0.0 and piece.last < piece.first


def turned_after(angle: float, first: float) -> float:
    """An angle, modulo a full turn, that is at least `first` and less than a turn after it."""
    return angle - FULL_TURN * float(floor((angle - first) / FULL_TURN))


def direction_on(piece: ChainPiece, d_x: float, d_y: float) -> float:
    """Direction of the tangent of an arc or corner at its point nearest to one that is d from its center.

    At its ends it is that of the end.
    """
    sign = copysign(1.0, piece.radius)
    low, high = min(piece.first, piece.last), max(piece.first, piece.last)
    angle = turned_after(atan2(sign * d_x, -sign * d_y), low)
    if angle <= high:
        return angle
    return high if angle - high < low + FULL_TURN - angle else low


def nearest_on_chain(chain: Numbers, count: int, x: float, y: float) -> NearestPlace:
    """The place of an outline nearest to a point."""
    nearest = NearestPlace(-1, 0.0, INFINITY)
    for k in range(count):
        piece = chain_piece(chain, k)
        candidate = _nearest_on_side(chain, piece, k, x, y)
        if not is_side(piece):
            candidate = _nearest_on_arc(chain, piece, k, x, y)
        if fabs(candidate.distance) < fabs(nearest.distance):
            nearest = candidate
    return nearest


def _nearest_on_side(
    chain: Numbers, piece: ChainPiece, number: int, x: float, y: float
) -> NearestPlace:
    """The nearest place of a side; infinitely far where it is that of a corner."""
    d_x, d_y = x - piece.x, y - piece.y
    place = d_x * piece.along_x + d_y * piece.along_y
    height = piece.along_x * d_y - piece.along_y * d_x
    if 0.0 <= place <= piece.length:
        return NearestPlace(number, place, -height)
    neighbor = chain_piece(chain, piece.before if place < 0.0 else piece.next)
    if neighbor.radius == 0.0:
        return NearestPlace(number, place, INFINITY)
    place = 0.0 if place < 0.0 else piece.length
    d_x, d_y = d_x - place * piece.along_x, d_y - place * piece.along_y
    return NearestPlace(number, place, copysign(sqrt(d_x * d_x + d_y * d_y), -height))


def _nearest_on_arc(
    chain: Numbers, piece: ChainPiece, number: int, x: float, y: float
) -> NearestPlace:
    """The nearest place of an arc or a corner; infinitely far where it is that of another corner."""
    d_x, d_y = x - piece.x, y - piece.y
    size, sign = sqrt(d_x * d_x + d_y * d_y), copysign(1.0, piece.radius)
    angle = direction_on(piece, d_x, d_y)
    if piece.radius == 0.0:
        return NearestPlace(number, angle, -size if is_inner_corner(piece) else size)
    s, c = sin(angle), cos(angle)
    height = d_x * s - d_y * c
    if sign * height >= size * (1.0 - 1e-12):
        return NearestPlace(number, angle, sign * size - piece.radius)
    is_start: bool = fabs(angle - piece.first) < fabs(angle - piece.last)
    neighbor = chain_piece(chain, piece.before if is_start else piece.next)
    if neighbor.radius == 0.0:
        return NearestPlace(number, angle, INFINITY)
    o_x, o_y = d_x - piece.radius * s, d_y + piece.radius * c
    off = sqrt(o_x * o_x + o_y * o_y)
    return NearestPlace(number, angle, copysign(off, height - piece.radius))


def stretch_of_piece(
    chain: Numbers, count: int, number: int, radius: float, place: float
) -> Stretch:
    """The stretch of a piece, about a place, on which a disc that touches it meets no other piece.

    The center of a disc moves on the outline grown by its radius. The stretch ends where the disc overlaps
    another piece by 1, the unit of length of the outline.
    """
    low, high = -INFINITY, INFINITY
    if radius <= 1.0:
        return Stretch(low, high)
    path = chain_piece(chain, number)
    for k in range(count):
        other = chain_piece(chain, k)
        if k == number or is_inner_corner(other) or not _is_outside(other, radius - 1.0):
            continue
        points = _crossings(path, radius, other, radius - 1.0)
        for i in range(2):
            x, y = (
                (points.x if i == 0 else points.other_x),
                (points.y if i == 0 else points.other_y),
            )
            if x != x or not _is_beside(other, x, y):
                continue
            meeting = _place_beside(path, x, y, low=place - FULL_TURN / 2.0)
            if meeting < place:
                low = max(low, meeting)
            else:
                high = min(high, meeting)
    return Stretch(low, high)


def _is_outside(piece: ChainPiece, depth: float) -> bool:
    """Whether a piece still exists in the outline grown by a depth: a disc fits into a hollow arc."""
    return is_side(piece) or piece.radius >= 0.0 or piece.radius + depth < 0.0


def _is_beside(piece: ChainPiece, x: float, y: float) -> bool:
    """Whether a point of a grown piece, extended to a line or circle, is between its ends."""
    d_x, d_y = x - piece.x, y - piece.y
    if is_side(piece):
        return 0.0 <= d_x * piece.along_x + d_y * piece.along_y <= piece.length
    low, high = min(piece.first, piece.last), max(piece.first, piece.last)
    sign = copysign(1.0, piece.radius)
    return turned_after(atan2(sign * d_x, -sign * d_y), low) <= high


def _place_beside(piece: ChainPiece, x: float, y: float, low: float) -> float:
    """The place of a piece at a point of its grown line or circle; an angle is at least `low`."""
    d_x, d_y = x - piece.x, y - piece.y
    if is_side(piece):
        return d_x * piece.along_x + d_y * piece.along_y
    sign = copysign(1.0, piece.radius)
    return turned_after(atan2(sign * d_x, -sign * d_y), low)


def _crossings(one: ChainPiece, grown: float, other: ChainPiece, depth: float) -> Crossings:
    """Where two pieces, extended to lines or circles and grown by two lengths, meet."""
    if is_side(one) and is_side(other):
        return _crossing_of_lines(one, grown, other, depth)
    if is_side(one):
        return _crossings_of_circle(one, grown, other.x, other.y, other.radius + depth)
    if is_side(other):
        return _crossings_of_circle(other, depth, one.x, one.y, one.radius + grown)
    return _crossings_of_circles(one, one.radius + grown, other, other.radius + depth)


def _crossing_of_lines(one: ChainPiece, grown: float, other: ChainPiece, depth: float) -> Crossings:
    """Where two sides, grown by two lengths, meet."""
    d_x = other.x + depth * other.along_y - (one.x + grown * one.along_y)
    d_y = other.y - depth * other.along_x - (one.y - grown * one.along_x)
    turn = one.along_x * other.along_y - one.along_y * other.along_x
    nowhere = UNKNOWN
    if turn == 0.0:
        return Crossings(nowhere, nowhere, nowhere, nowhere)
    s = (d_x * other.along_y - d_y * other.along_x) / turn
    x = one.x + grown * one.along_y + s * one.along_x
    y = one.y - grown * one.along_x + s * one.along_y
    return Crossings(x, y, nowhere, nowhere)


def _crossings_of_circle(
    side: ChainPiece, depth: float, x: float, y: float, radius: float
) -> Crossings:
    """Where a side, grown by a length, meets a circle."""
    a_x, a_y = side.x + depth * side.along_y, side.y - depth * side.along_x
    d_x, d_y = x - a_x, y - a_y
    height = side.along_x * d_y - side.along_y * d_x
    square = (radius - height) * (radius + height)
    half = sqrt(square) if square > 0.0 else UNKNOWN
    middle = d_x * side.along_x + d_y * side.along_y
    return Crossings(
        a_x + (middle - half) * side.along_x, a_y + (middle - half) * side.along_y,
        a_x + (middle + half) * side.along_x, a_y + (middle + half) * side.along_y,
    )  # fmt: skip


def _crossings_of_circles(
    one: ChainPiece, radius: float, other: ChainPiece, other_radius: float
) -> Crossings:
    """Where two circles about the centers of pieces meet."""
    d_x, d_y = other.x - one.x, other.y - one.y
    square = d_x * d_x + d_y * d_y
    part, across = 0.0, UNKNOWN
    if square > 0.0:
        part = 0.5 + (radius - other_radius) * (radius + other_radius) / (2.0 * square)
        rest = radius * radius / square - part * part
        if rest > 0.0:
            across = sqrt(rest)
    x, y = one.x + part * d_x, one.y + part * d_y
    return Crossings(x - across * d_y, y + across * d_x, x + across * d_y, y - across * d_x)


class StretchRow(Record):
    """A disc that touches a piece of an outline at a place, and the number and the place of its pieces."""

    piece: int
    radius: float
    place: float
    count: int
    first: int


class StretchResult(Record):
    """The places between which the disc meets no other piece."""

    low: float
    high: float


def stretches_of_pieces(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """The stretch of a piece on which each disc meets no other piece: of each `StretchRow`."""
    for i in range(count):
        row, result = StretchRow(rows[i * columns :]), StretchResult(results[i * width :])
        stretch = stretch_of_piece(data[row.first :], row.count, row.piece, row.radius, row.place)
        result.low, result.high = stretch.low, stretch.high
