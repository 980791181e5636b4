"""The places of an outline nearest to given points, and those of contacts."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from planar_pushing.core.supports.chain import CHAIN_PIECE, ChainPiece
from planar_pushing.mechanics.kernels.columns import Columns
from planar_pushing.mechanics.outline.chains import BETA0, BETA1, LENGTH, RHO, Piece, wrap
from planar_pushing.mechanics.outline.drawing import KEPT
from planar_pushing.mechanics.outline.outline import Outline
from planar_pushing.mechanics.plane import direction
from planar_pushing.terms.caches import cache_results
from planar_pushing.terms.numbers import Array

#: Allowed depth of the outline in the pusher, in extents of the outline. It is far above rounding error, so
#: that a side lying on the fence does not end a run without rotation.
DEPTH = 1e-9


class Places(NamedTuple):
    """Places on the pieces of an outline, as arrays over points.

    Attributes
    ----------
    piece : ndarray of int, shape (n,)
        Row of the piece.
    beta : ndarray, shape (n,)
        Direction of the tangent, in radians, between those of the piece's ends.
    position : ndarray, shape (n,)
        Arc length from the start of the piece.
    point : ndarray, shape (n, 2)
    gap : ndarray, shape (n,)
        Signed distance to the outline, negative inside of the object.
    """

    piece: npt.NDArray[np.intp]
    beta: Array
    position: Array
    point: Array
    gap: Array

    @property
    def tangent(self) -> Array:
        """Unit tangents, shape (n, 2), with the object on the left."""
        return np.stack([np.cos(self.beta), np.sin(self.beta)], axis=-1)

    @property
    def normal(self) -> Array:
        """Unit normals, shape (n, 2), into the object."""
        return np.stack([-np.sin(self.beta), np.cos(self.beta)], axis=-1)


class _Pieces(NamedTuple):
    """Sides, arcs and corners of an outline as arrays, each with its row."""

    rows: Array
    tangent: Array
    is_side: npt.NDArray[np.bool_]
    is_corner: npt.NDArray[np.bool_]
    low: Array
    high: Array


@cache_results(KEPT)
def _pieces_of(outline: Outline) -> _Pieces:
    rows = outline.pieces
    rho, beta = rows[:, RHO], rows[:, BETA0]
    ends = rows[:, [BETA0, BETA1]]
    tangent = np.stack([np.cos(beta), np.sin(beta)], axis=-1)
    return _Pieces(rows, tangent, np.isinf(rho), rho == 0.0, ends.min(axis=1), ends.max(axis=1))


def nearest_place(outline: Outline, points: Array) -> Places:
    """The places of an outline nearest to points of shape (n, 2)."""
    pieces = _pieces_of(outline)
    beta, position, spots = _on_pieces(pieces, points)
    apart = points[:, None] - spots
    distance = np.hypot(apart[..., 0], apart[..., 1])
    # A side that ends in a corner is as near as the corner, which alone knows inside from outside.
    best = distance.min(axis=1, keepdims=True)
    slack = 1e-12 * (best + outline.size)
    at_corner = pieces.is_corner & (distance <= best + slack)
    choice = np.where(at_corner.any(axis=1), at_corner.argmax(axis=1), distance.argmin(axis=1))
    rank = np.arange(len(points))
    places = Places(
        choice,
        beta[rank, choice],
        position[rank, choice],
        spots[rank, choice],
        distance[rank, choice],
    )
    return places._replace(
        gap=np.where(_are_inside(pieces, places, points), -1.0, 1.0) * places.gap
    )


def normals_within(
    outline: Outline, points: Array, normals: Array, distance: float
) -> npt.NDArray[np.bool_]:
    """Whether normals at points of shape (n, 2) point into the object at a piece within a distance."""
    pieces = _pieces_of(outline)
    beta, _, spots = _on_pieces(pieces, points)
    apart = points[:, None] - spots
    is_near = np.hypot(apart[..., 0], apart[..., 1]) <= distance
    into = normals[:, :1] * -np.sin(beta) + normals[:, 1:] * np.cos(beta)
    return np.asarray((is_near & ~pieces.is_corner & (into > 0.0)).any(axis=1))


def _on_pieces(pieces: _Pieces, points: Array) -> tuple[Array, Array, Array]:
    """The nearest place of each piece: direction, arc length from its start, and point."""
    rows = pieces.rows
    away = points[:, None] - rows[:, :2]
    along = np.clip((away * pieces.tangent).sum(axis=-1), 0.0, rows[:, LENGTH])
    rho = np.where(pieces.is_side, 0.0, rows[:, RHO])
    sign = np.where(rho < 0.0, -1.0, 1.0)
    middle = (pieces.low + pieces.high) / 2.0
    beta = middle + wrap(np.arctan2(sign * away[..., 0], -sign * away[..., 1]) - middle)
    beta = np.where(pieces.is_side, rows[:, BETA0], np.clip(beta, pieces.low, pieces.high))
    position = np.where(pieces.is_side, along, rho * (beta - rows[:, BETA0]))
    offset = rho[:, None] * np.stack([np.sin(beta), -np.cos(beta)], axis=-1)
    on_side = along[..., None] * pieces.tangent
    return beta, position, rows[:, :2] + np.where(pieces.is_side[:, None], on_side, offset)


def _are_inside(pieces: _Pieces, places: Places, points: Array) -> npt.NDArray[np.bool_]:
    """Whether points are inside: on the inner side of a piece, or nearest to an inner corner."""
    rows = pieces.rows[places.piece]
    heights = ((points - places.point) * places.normal).sum(axis=1)
    return np.asarray(
        np.where(pieces.is_corner[places.piece], rows[:, BETA1] < rows[:, BETA0], heights > 0.0)
    )


def places_with_normals(outline: Outline, points: Array, normals: Array) -> Places:
    """The places of contacts that are on an outline, with the pieces that have their normals.

    Parameters
    ----------
    outline : Outline
    points, normals : ndarray, shape (n, 2)
        Of the placements of `scene_at`. At a corner whose side lies on the fence, the piece is the side.
    """
    pieces = _pieces_of(outline)
    _, position, spots = _on_pieces(pieces, points)
    apart = points[:, None] - spots
    distance = np.hypot(apart[..., 0], apart[..., 1])
    middle = (pieces.low + pieces.high) / 2.0
    direction = np.arctan2(-normals[:, 0], normals[:, 1])
    beta = middle + wrap(direction[:, None] - middle)
    turned = np.clip(beta, pieces.low, pieces.high)
    # Sides before arcs before corners, where all have the normal.
    order = np.where(pieces.is_side, 0.0, np.where(pieces.is_corner, 2.0, 1.0))
    misfit = np.maximum(np.abs(beta - turned) - 1e-9, 0.0) + 1e-12 * order
    misfit += np.where(distance <= 2.0 * outline.tolerance, 0.0, 1.0 + distance / outline.size)
    choice, rank = misfit.argmin(axis=1), np.arange(len(points))
    turned, rows = turned[rank, choice], pieces.rows[choice]
    on_arc = np.where(pieces.is_side[choice], 0.0, rows[:, RHO]) * (turned - rows[:, BETA0])
    along = np.where(pieces.is_side[choice], position[rank, choice], on_arc)
    return Places(choice, turned, along, spots[rank, choice], distance[rank, choice])


def lowest_heights(outline: Outline, normals: Array) -> Array:
    """The smallest component of positions on an outline along each of the unit vectors, shape (n,)."""
    piece = Piece(*outline.pieces.T)
    is_side = np.isinf(piece.rho)
    radius = np.where(is_side, 0.0, piece.rho)
    # Every end of an arc is the start of the next piece.
    x = piece.x + radius * np.sin(piece.beta0)
    y = piece.y - radius * np.cos(piece.beta0)
    heights = normals @ np.stack([x, y])
    middle = (piece.beta0 + piece.beta1) / 2.0
    direction = np.arctan2(-normals[:, 0], normals[:, 1])
    apart = np.abs(wrap(direction[:, None] - middle))
    lies = (radius > 0.0) & (apart <= np.abs(piece.beta1 - piece.beta0) / 2.0)
    bottoms = normals @ np.stack([piece.x, piece.y]) - radius
    return np.asarray(np.where(lies, bottoms, heights).min(axis=1))


def depth_tolerance(outline: Outline) -> float:
    """Allowed depth of the outline in the pusher, in the outline's unit."""
    return DEPTH * outline.size


def chain_rows(outline: Outline) -> Array:
    """The pieces of an outline in the form of the core: `ChainPiece`, in units of the allowed depth."""
    piece, unit = Piece(*outline.pieces.T), depth_tolerance(outline)
    rows = np.empty((len(outline.pieces), CHAIN_PIECE))
    row = Columns(ChainPiece, rows)
    row.x, row.y, row.radius = piece.x / unit, piece.y / unit, piece.rho / unit
    row.first, row.last = piece.beta0, piece.beta1
    row.length, row.start = piece.length / unit, piece.start / unit
    row.next, row.before = piece.next, piece.before
    row.along_x, row.along_y = direction(piece.beta0).T
    return rows
