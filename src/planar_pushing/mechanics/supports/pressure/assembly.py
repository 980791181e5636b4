"""From a support's pieces to its centre, its extent, and the record of the compiled core."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from planar_pushing.mechanics.supports.pressure.multipole import TERMS, multipoles
from planar_pushing.mechanics.supports.pressure.record import Array, Pieces, Pressure


def shared(pieces: Pieces, share: float) -> Pieces:
    """Pieces that together carry a share."""
    atoms, segments, rings, discs = (_scaled(each, share) for each in pieces[:4])
    plates = tuple(_scaled(each, share) for each in pieces.plates)
    return Pieces(atoms, segments, rings, discs, plates)


def _scaled(rows: Array, share: float) -> Array:
    """Rows with their last column times a share."""
    return np.column_stack([rows[:, :-1], rows[:, -1] * share])


def joined(parts: Sequence[Pieces]) -> Pieces:
    """All pieces of several supports."""
    columns = zip(*(part[:4] for part in parts), strict=True)
    atoms, segments, rings, discs = map(np.concatenate, columns)
    plates = tuple(plate for part in parts for plate in part.plates)
    return Pieces(atoms, segments, rings, discs, plates)


def center(pieces: Pieces) -> tuple[float, float]:
    """Centre of pressure."""
    middles = (pieces.segments[:, :2] + pieces.segments[:, 2:4]) / 2
    lines = np.column_stack([middles, pieces.segments[:, 4]])
    areas = np.array([_centroid(edges) for edges in pieces.plates]).reshape(-1, 3)
    whole = np.concatenate([pieces.atoms, lines, pieces.rings[:, [0, 1, 3]],
                            pieces.discs[:, [0, 1, 3]], areas])  # fmt: skip
    x, y = whole[:, 2] @ whole[:, :2] / whole[:, 2].sum()
    return float(x), float(y)


def extent(pieces: Pieces) -> float:
    """Largest distance of the pieces from the centre of pressure."""
    corners = [each[:, :4].reshape(-1, 2) for each in (pieces.segments, *pieces.plates)]
    points = np.concatenate([pieces.atoms[:, :2], *corners])
    round_ones = np.concatenate([pieces.rings, pieces.discs])
    here = center(pieces)
    reach = np.linalg.norm(round_ones[:, :2] - here, axis=1) + round_ones[:, 2]
    return float(max(np.r_[np.linalg.norm(points - here, axis=1), reach]))


def assembled(pieces: Pieces, radius: float) -> Pressure:
    """The record of the compiled core, in units of the slider's radius."""
    x, y = center(pieces)
    plates = [_plate(edges, radius) for edges in pieces.plates]
    counts = [len(edges) for _, edges, _ in plates]
    return Pressure(
        x / radius, y / radius, extent(pieces) / radius,
        _atoms(pieces.atoms / [radius, radius, 1.0]),
        _segments(pieces.segments, radius),
        pieces.rings / [radius, radius, radius, 1.0],
        pieces.discs / [radius, radius, radius, 1.0],
        np.array([row for row, _, _ in plates]).reshape(-1, 4),
        np.cumsum([0, *counts], dtype=np.int64),
        np.concatenate([np.empty((0, 6)), *(edges for _, edges, _ in plates)]),
        np.array([terms for _, _, terms in plates]).reshape(-1, TERMS, 2),
    )  # fmt: skip


def _atoms(atoms: Array) -> Array:
    """Atoms in their order; those at the same place are one."""
    places, first, which = np.unique(atoms[:, :2], axis=0, return_index=True, return_inverse=True)
    merged = np.column_stack([places, np.bincount(which.ravel(), atoms[:, 2], len(places))])
    return np.ascontiguousarray(merged[np.argsort(first)])


def _segments(segments: Array, radius: float) -> Array:
    start, end = segments[:, :2] / radius, segments[:, 2:4] / radius
    return np.column_stack([_lines(start, end), segments[:, 4]])


def _lines(start: Array, end: Array) -> Array:
    """Middle, unit tangent and half the length of lines."""
    along = end - start
    length = np.hypot(along[:, 0], along[:, 1])
    return np.column_stack([(start + end) / 2, along / length[:, None], length / 2])


def _plate(edges: Array, radius: float) -> tuple[Array, Array, Array]:
    """Row, edges and multipoles of a plate."""
    x, y, share = _centroid(edges)
    start, end = (edges[:, :2] - (x, y)) / radius, (edges[:, 2:4] - (x, y)) / radius
    reach = max(np.hypot(*start.T).max(), np.hypot(*end.T).max())
    rows = np.column_stack([_lines(start, end), edges[:, 4] * radius**2 / share])
    return np.array([x / radius, y / radius, reach, share]), rows, multipoles(rows, reach)


def _centroid(edges: Array) -> Array:
    """Centre of pressure and share of a plate, from triangles over its edges."""
    corner = edges[0, :2]
    start, end = edges[:, :2] - corner, edges[:, 2:4] - corner
    loads = (start[:, 0] * end[:, 1] - start[:, 1] * end[:, 0]) / 2 * edges[:, 4]
    share = loads.sum()
    return np.append(corner + loads @ (start + end) / (3 * share), share)
