"""Centers, extents and rows of numbers, from the pieces of one or many supports."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.core.multipole import ROWS
from planar_pushing.core.pieces import COLUMNS
from planar_pushing.mechanics.kernels.arrays import in_threads
from planar_pushing.mechanics.kernels.calls import run
from planar_pushing.mechanics.pressure.pieces import (
    ATOMS,
    DISCS,
    EDGES,
    PLATES,
    RINGS,
    SEGMENTS,
    Array,
    Pieces,
    spreads,
)

#: Plates per block of terms: a few milliseconds of work.
BLOCK = 512
#: A center of rotation closer to an atom than this, relative to the numbers in its computation, counts as
#: on it.
ROUNDING = 1e-15


class Gathered(NamedTuple):
    """Pieces of several supports, grouped by kind.

    Attributes
    ----------
    rows, owners : list of ndarray
        For each kind: rows as in `Pieces`, with center, extent and share for plates; and the number of the
        support to which each row belongs.
    first : ndarray of int, shape (plates + 1,)
        Index at which the edges of each plate begin, then the total number of edges.
    centers, extents, spreads : ndarray
        Of the supports: centers of pressure, largest distances from them, second moments.
    write_terms : callable, optional
        Writes the terms of the plates into an array of shape (plates, 2 * ROWS), if they are known.
    """

    rows: list[Array]
    owners: list[Any]
    first: Any
    centers: Array
    extents: Array
    spreads: Array
    write_terms: Callable[[Array], None] | None = None


def scale_shares(pieces: Pieces, share: float) -> Pieces:
    """Pieces with their shares multiplied by a factor."""
    atoms, segments, rings, discs = (_scale_last_column(rows, share) for rows in pieces[:4])
    plates = tuple(_scale_last_column(rows, share) for rows in pieces.plates)
    return Pieces(atoms, segments, rings, discs, plates)


def _scale_last_column(rows: Array, share: float) -> Array:
    """Rows with their last column multiplied by a factor."""
    return np.column_stack([rows[:, :-1], rows[:, -1] * share])


def join_pieces(parts: Sequence[Pieces]) -> Pieces:
    """All pieces of several supports."""
    columns = zip(*(part[:4] for part in parts), strict=True)
    atoms, segments, rings, discs = map(np.concatenate, columns)
    plates = tuple(plate for part in parts for plate in part.plates)
    return Pieces(atoms, segments, rings, discs, plates)


def gather_pieces(supports: Sequence[Pieces]) -> Gathered:
    """Pieces of supports, with centers and extents."""
    rows = [np.concatenate([pieces[kind] for pieces in supports]) for kind in range(PLATES)]
    counts = [[len(pieces[kind]) for pieces in supports] for kind in range(PLATES + 1)]
    owners = [np.repeat(np.arange(len(supports)), count) for count in counts]
    plates = [edges for pieces in supports for edges in pieces.plates]
    lengths = np.array([len(edges) for edges in plates], dtype=np.int64)
    edges = np.concatenate([np.empty((0, 5)), *plates])
    owners += [np.repeat(owners[PLATES], lengths)]
    return measure_pieces(rows, edges, owners, lengths, len(supports))


def measure_pieces(
    rows: list[Array], edges: Array, owners: list[Any], lengths: Any, count: int
) -> Gathered:
    """`Gathered` from the rows of each kind before the plates, the plates' edges, and the owners of all.

    Parameters
    ----------
    rows, owners : list of ndarray
        As in `Gathered`; for plates and edges, only the owners.
    edges : ndarray, shape (m, 5)
    lengths : ndarray of int, shape (plates,)
        Number of edges of each plate.
    count : int
        Number of supports.
    """
    first = np.concatenate([[0], lengths.cumsum()])
    rows = [*rows, _places(edges, lengths, first[:-1]), edges]
    centers = _centers(rows, owners, count)
    extents, moments = _extents(rows, owners, centers), spreads(rows, owners, centers)
    return Gathered(rows, owners, first, centers, extents, moments)


def _places(edges: Array, lengths: Any, first: Any) -> Array:
    """Center of pressure, largest distance from it, and share of plates, by triangles over their edges."""
    if not len(first):
        return np.empty((0, 4))
    ends = edges[:, :2]
    middle = (np.minimum.reduceat(ends, first) + np.maximum.reduceat(ends, first)) / 2
    about = np.repeat(middle, lengths, axis=0)
    start, end = edges[:, :2] - about, edges[:, 2:4] - about
    loads = (start[:, 0] * end[:, 1] - start[:, 1] * end[:, 0]) / 2 * edges[:, 4]
    share = np.add.reduceat(loads, first)
    weighted = np.add.reduceat(loads[:, None] * (start + end), first)
    center = middle + weighted / (3 * share)[:, None]
    around = np.repeat(center, lengths, axis=0)
    away = np.maximum(_distance(edges[:, :2], around), _distance(edges[:, 2:4], around))
    return np.column_stack([center, np.maximum.reduceat(away, first), share])


def _distance(points: Array, center: Array) -> Array:
    return np.hypot(points[:, 0] - center[:, 0], points[:, 1] - center[:, 1])


def _centers(rows: list[Array], owners: list[Any], count: int) -> Array:
    """Centers of pressure."""
    atoms, segments, rings, discs, plates, _ = rows
    lines = np.column_stack([(segments[:, :2] + segments[:, 2:4]) / 2, segments[:, 4]])
    round_ones = [kind[:, [0, 1, 3]] for kind in (rings, discs, plates)]
    x, y, share = np.concatenate([atoms, lines, *round_ones]).T
    owner = np.concatenate(owners[:EDGES])
    total = np.bincount(owner, share, count)
    return np.column_stack(
        [np.bincount(owner, share * coordinate, count) / total for coordinate in (x, y)]
    )


def _extents(rows: list[Array], owners: list[Any], centers: Array) -> Array:
    """Largest distances of supports from their centers of pressure."""
    ends = (
        (ATOMS, 0),
        (SEGMENTS, 0),
        (SEGMENTS, 2),
        (EDGES, 0),
        (EDGES, 2),
        (RINGS, 0),
        (DISCS, 0),
    )
    extents = np.zeros(len(centers))
    for kind, column in ends:
        reach = _distance(rows[kind][:, column : column + 2], centers[owners[kind]])
        if kind in (RINGS, DISCS):
            reach += rows[kind][:, 2]
        np.maximum.at(extents, owners[kind], reach)
    return extents


def center(pieces: Pieces) -> tuple[float, float]:
    """Center of pressure."""
    x, y = gather_pieces([pieces]).centers[0]
    return float(x), float(y)


def extent(pieces: Pieces) -> float:
    """Largest distance of the pieces from the center of pressure."""
    return float(gather_pieces([pieces]).extents[0])


class Stack(NamedTuple):
    """Rows of the pieces of several supports, one support after the other.

    Attributes
    ----------
    starts : ndarray of int, shape (supports, 7)
        First row of each kind of piece, `ATOMS` to `EDGES`, and number of the support's first plate.
    rows : ndarray, shape (n, COLUMNS)
        As in `core.pieces`, except that plates have the numbers of the rows at which their edges begin and
        end.
    plates : ndarray of int
        Numbers of the rows of plates.
    """

    starts: Any
    rows: Array
    plates: Any


def stack(group: Gathered, radii: Array) -> Stack:
    """Rows of supports, each in units of its own radius."""
    kinds, owners = _scaled_rows(group, radii)
    count = len(radii)
    order = np.argsort(np.concatenate(owners), kind="stable")
    rows = np.concatenate([np.pad(kind, ((0, 0), (0, COLUMNS - kind.shape[1]))) for kind in kinds])
    counts = np.column_stack([np.bincount(owner, minlength=count) for owner in owners])
    starts = (counts.cumsum() - counts.ravel()).reshape(counts.shape)
    first_plates = counts[:, PLATES].cumsum() - counts[:, PLATES]
    rows = np.ascontiguousarray(rows[order])
    # The edges of all supports follow the order of the plates, and so do these two arrays.
    lengths, owner = np.diff(group.first), owners[PLATES]
    inside = group.first[:-1] - (counts[:, EDGES].cumsum() - counts[:, EDGES])[owner]
    begin = starts[owner, EDGES] + inside
    plates = starts[owner, PLATES] + np.arange(len(owner)) - first_plates[owner]
    rows[plates, COLUMNS - 2], rows[plates, COLUMNS - 1] = begin, begin + lengths
    return Stack(np.column_stack([starts, first_plates]), rows, plates)


def stack_with_terms(group: Gathered, radii: Array) -> tuple[Any, Array, Array]:
    """Starts and rows as in `Stack`, and terms of the plates, shape (plates, ROWS, 2)."""
    starts, rows, plates = stack(group, radii)
    terms = np.empty((len(plates), 2 * ROWS))
    write_terms(group, rows, plates, terms)
    return starts, rows, terms.reshape(-1, ROWS, 2)


def write_terms(group: Gathered, rows: Array, plates: Any, terms: Array) -> None:
    """Write the multipole terms of plates, which are known or computed on all cores.

    Parameters
    ----------
    group : Gathered
    rows, plates : ndarray
        As in `Stack`.
    terms : ndarray, shape (plates, 2 * ROWS)
        The array to which the terms are written.
    """
    if group.write_terms is not None:
        group.write_terms(terms)
        return

    def block(start: int) -> None:
        part = slice(start, start + BLOCK)
        _, _, radius, _, first, last = rows[plates[part]].T
        edges = np.column_stack([radius, COLUMNS * first, COLUMNS * last])
        terms[part] = run("plate_terms", rows, edges, 2 * ROWS)

    starts = range(0, len(plates), BLOCK)
    if len(starts) > 1:
        in_threads(block, starts)
    elif len(starts):
        block(0)


def _scaled_rows(group: Gathered, radii: Array) -> tuple[list[Array], list[Any]]:
    """Rows of each kind in units of the radii, and their owners; rows of plates lack their edge numbers."""
    owners, unit = list(group.owners), [radii[owner, None] for owner in group.owners]
    atoms, segments, rings, discs, plates, edges = group.rows
    atoms, owners[ATOMS] = _atoms(group, atoms[:, :2] / unit[ATOMS], radii)
    lines = _lines(segments[:, :2] / unit[SEGMENTS], segments[:, 2:4] / unit[SEGMENTS])
    plate = np.repeat(np.arange(len(plates)), np.diff(group.first))
    middle, size = plates[plate, :2], unit[EDGES]
    sides = _lines((edges[:, :2] - middle) / size, (edges[:, 2:4] - middle) / size)
    jumps = edges[:, 4] * size[:, 0] ** 2 / plates[plate, 3]
    round_ones = [
        np.column_stack([kind[:, :3] / radii[owner, None], kind[:, 3]])
        for kind, owner in zip((rings, discs, plates), group.owners[RINGS:EDGES], strict=True)
    ]
    kinds = [
        atoms, np.column_stack([lines, segments[:, 4]]), *round_ones, np.column_stack([sides, jumps]),
    ]  # fmt: skip
    return kinds, owners


def _atoms(group: Gathered, places: Array, radii: Array) -> tuple[Array, Any]:
    """Atoms in their order, and their owners; atoms of one support at the same place are merged."""
    owner: Any = group.owners[ATOMS]
    shares: Any = group.rows[ATOMS][:, 2]
    keys = np.column_stack([owner, places])
    merged, first, which = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    shares = np.bincount(which.ravel(), shares, len(merged))
    order = np.argsort(first)
    merged_owner = owner[first[order]]
    places, shares = merged[order, 1:], shares[order]
    size = (group.extents / radii)[merged_owner] + np.abs(places).sum(axis=1)
    return np.column_stack([places, shares, (ROUNDING * size) ** 2]), merged_owner


def _lines(start: Array, end: Array) -> Array:
    """Midpoint, unit tangent and half length of lines."""
    along = end - start
    length = np.hypot(along[:, 0], along[:, 1])
    return np.column_stack([(start + end) / 2, along / length[:, None], length / 2])
