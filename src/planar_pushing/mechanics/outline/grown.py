"""Places at which discs touch an outline, along the outline grown by their radii.

The center of a disc that touches an outline moves on the outline grown by its radius r, whose pieces have
the radius of curvature rho + r. Along it, the disc goes from piece to piece, also around outer corners,
which are arcs of its radius. It stops at an inner corner and at a hollow arc that it fills.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.outline.chains import (
    BEFORE,
    BETA0,
    BETA1,
    LENGTH,
    NEXT,
    RHO,
    START,
    split_chains,
    wrap,
)
from planar_pushing.mechanics.outline.drawing import KEPT
from planar_pushing.mechanics.outline.outline import Outline
from planar_pushing.mechanics.outline.places import Places, nearest_place
from planar_pushing.mechanics.plane import Array
from planar_pushing.terms.caches import cache_results

Index = npt.NDArray[np.intp]


class Seats(NamedTuple):
    """Pieces of an outline that discs touch, and distances along the grown pieces from their starts."""

    piece: Index
    along: Array


def seats_at(places: Places, outline: Outline, radius: Array) -> Seats:
    """The seats of discs that touch an outline at places."""
    turn = places.beta - outline.pieces[places.piece, BETA0]
    return Seats(places.piece, places.position + radius * turn)


def places_of(seats: Seats, outline: Outline, radius: Array) -> Places:
    """The places at which discs touch an outline; their gap is 0.

    Beyond the end of a piece they are on its continuation.
    """
    rows, along = outline.pieces[seats.piece], seats.along
    is_side = np.isinf(rows[:, RHO])
    rho = np.where(is_side, 0.0, rows[:, RHO])
    reach = np.where(is_side, 0.0, rho + radius)
    turn = np.divide(along, reach, out=np.zeros_like(along), where=reach != 0.0)
    beta = rows[:, BETA0] + turn
    tangent = np.stack([np.cos(beta), np.sin(beta)], axis=-1)
    outward = np.stack([tangent[:, 1], -tangent[:, 0]], axis=-1)
    position = np.where(is_side, along, rho * turn)
    point = rows[:, :2] + np.where(
        is_side[:, None], along[:, None] * tangent, rho[:, None] * outward
    )
    return Places(seats.piece, beta, position, point, np.zeros(len(along)))


def roll_on(seats: Seats, outline: Outline, radius: Array) -> Seats:
    """Seats on the pieces at which discs arrive that have change beyond the ends of theirs."""
    rows, (piece, along) = outline.pieces, seats
    for _ in range(len(rows)):
        length = _lengths(rows[piece], radius)
        is_beyond = (along < 0.0) | (along > length)
        if not is_beyond.any():
            break
        after, before = (rows[piece, column].astype(int) for column in (NEXT, BEFORE))
        goes_on = (along > length) & _has_room(rows[after], radius)
        goes_back = (along < 0.0) & _has_room(rows[before], radius)
        if not (goes_on | goes_back).any():
            break
        change = np.where(
            goes_on, -length, np.where(goes_back, _lengths(rows[before], radius), 0.0)
        )
        along = along + change
        piece = np.where(goes_on, after, np.where(goes_back, before, piece))
    return Seats(piece, along)


def are_blocked(seats: Seats, outline: Outline, radius: Array) -> npt.NDArray[np.bool_]:
    """Whether discs are beyond an end where they cannot go on, or touch another piece, too."""
    if _is_convex(outline):
        return np.zeros(len(radius), dtype=bool)
    blocked = (seats.along < 0.0) | (seats.along > _lengths(outline.pieces[seats.piece], radius))
    places = places_of(seats, outline, radius)
    gap = nearest_place(outline, places.point - radius[:, None] * places.normal).gap
    return np.asarray(blocked | (gap < radius - outline.tolerance))


def travel_between(first: Places, last: Places, outline: Outline) -> Array:
    """Distances along the outline from first to last places, by the shorter way round."""
    rows = outline.pieces
    perimeters = [np.full(len(chain), chain[:, LENGTH].sum()) for chain in split_chains(rows)]
    perimeter = np.concatenate(perimeters)[first.piece]
    start, end = (rows[places.piece, START] + places.position for places in (first, last))
    travel = end - start
    return np.asarray(travel - perimeter * np.round(travel / perimeter))


def turn_at_corners(first: Places, last: Places, outline: Outline) -> Array:
    """Angles by which the tangent turns at corners between first and last places, in radians."""
    rows = outline.pieces
    is_corner = rows[:, RHO] == 0.0
    turns = np.where(is_corner, rows[:, BETA1] - rows[:, BETA0], 0.0)
    passed = np.cumsum(turns) - turns

    def angle_at(places: Places) -> Array:
        inside = places.beta - rows[places.piece, BETA0]
        return np.asarray(passed[places.piece] + np.where(is_corner[places.piece], inside, 0.0))

    return wrap(angle_at(last) - angle_at(first))


def _lengths(rows: Array, radius: Array) -> Array:
    """Lengths of grown pieces."""
    return np.asarray(rows[:, LENGTH] + radius * (rows[:, BETA1] - rows[:, BETA0]))


def _has_room(rows: Array, radius: Array) -> npt.NDArray[np.bool_]:
    """Whether discs go on to pieces: not to inner corners, nor to hollow arcs that they fill."""
    is_inner = (rows[:, RHO] == 0.0) & (rows[:, BETA1] < rows[:, BETA0])
    return np.asarray(~is_inner & ((rows[:, RHO] >= 0.0) | (rows[:, RHO] + radius < 0.0)))


@cache_results(KEPT)
def _is_convex(outline: Outline) -> bool:
    """Whether no disc that touches an outline is stopped by it."""
    return bool((outline.pieces[:, BETA1] >= outline.pieces[:, BETA0]).all())
