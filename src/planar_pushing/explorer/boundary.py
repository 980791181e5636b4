"""Places on the boundary of an object, at which its contact can be, by their arc length."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from planar_pushing.mechanics.outline import Outline
from planar_pushing.mechanics.outline.chains import (
    BEFORE,
    BETA0,
    LENGTH,
    NEXT,
    RHO,
    START,
    X,
    Y,
)
from planar_pushing.mechanics.outline.places import nearest_place
from planar_pushing.mechanics.plane import Array

#: Least distance of a contact from the ends of its side or arc, in units of its length: at a corner, the
#: normal would have to be chosen.
FROM_END = 0.004
#: Least height of a unit normal that points upward.
UPWARD = 0.7


class Place(NamedTuple):
    """A place on the exterior of an outline; lengths in the unit of the scene.

    Attributes
    ----------
    piece : int
        Row of the side or of the arc.
    position : float
        Arc length from the start of the piece.
    length : float
        Arc length from the start of the outline.
    point, normal : (x, y)
        In the frame of the outline; the normal points into the object.
    """

    piece: int
    position: float
    length: float
    point: tuple[float, float]
    normal: tuple[float, float]


def perimeter(outline: Outline) -> float:
    """Length of the exterior of an outline, in the unit of the scene."""
    return float(outline.exterior.pieces[:, LENGTH].sum())


def place_on(outline: Outline, piece: int, position: float) -> Place:
    """Place on a side or an arc, at a distance from its start, and at least a little from both its ends."""
    rows = outline.exterior.pieces
    row = rows[piece]
    length = float(row[LENGTH])
    if len(rows) > 1:
        margin = FROM_END * length
        position = min(max(position, margin), length - margin)
    rho, beta = float(row[RHO]), float(row[BETA0])
    x, y = float(row[X]), float(row[Y])
    if math.isinf(rho):
        x, y = x + position * math.cos(beta), y + position * math.sin(beta)
    else:
        beta += position / rho
        x, y = x + rho * math.sin(beta), y - rho * math.cos(beta)
    normal = -math.sin(beta), math.cos(beta)
    return Place(piece, position, float(row[START]) + position, (x, y), normal)


def nearest_to(outline: Outline, point: Array) -> Place:
    """Place on the exterior nearest to a point; beside a corner, on the nearer one of its pieces."""
    exterior = outline.exterior
    spot = nearest_place(exterior, np.asarray(point, dtype=float)[None])
    piece, position = int(spot.piece[0]), float(spot.position[0])
    rows = exterior.pieces
    if rows[piece, RHO] != 0.0:
        return place_on(outline, piece, position)
    before, after = int(rows[piece, BEFORE]), int(rows[piece, NEXT])
    ends = place_on(outline, before, float(rows[before, LENGTH])), place_on(outline, after, 0.0)
    return min(ends, key=lambda place: math.dist(place.point, point))


def place_at(outline: Outline, length: float) -> Place:
    """Place at an arc length from the start of the exterior, which is closed."""
    rows = outline.exterior.pieces
    along = length % perimeter(outline)
    smooth = np.flatnonzero(rows[:, RHO] != 0.0)
    piece = int(smooth[np.searchsorted(rows[smooth, START], along, side="right") - 1])
    return place_on(outline, piece, along - float(rows[piece, START]))


def lowest_place(outline: Outline) -> Place:
    """Middle of the lowest side or arc that can be pushed upward, or the lowest place of a disc."""
    rows = outline.exterior.pieces
    if len(rows) == 1:
        x, y = outline.centroid
        return nearest_to(outline, np.array([x, y - outline.size]))
    smooth = np.flatnonzero(rows[:, RHO] != 0.0)
    middles = [place_on(outline, int(piece), float(rows[piece, LENGTH]) / 2.0) for piece in smooth]
    upward = [place for place in middles if place.normal[1] > UPWARD]
    if not upward:
        return max(middles, key=lambda place: place.normal[1])
    return min(upward, key=lambda place: place.point[1])
