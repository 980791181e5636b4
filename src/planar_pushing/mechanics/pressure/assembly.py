"""Centers, extents and rows of numbers, from the pieces of one or many supports."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.core.supports.multipole import ROWS
from planar_pushing.core.supports.pieces import COLUMNS
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
from planar_pushing.terms.caches import cache_results

#: For each kind of piece, the columns in which its extreme points begin, or its center.
EXTREMES = (
    (ATOMS, 0), (SEGMENTS, 0), (SEGMENTS, 2), (EDGES, 0), (EDGES, 2), (RINGS, 0), (DISCS, 0),
)  # fmt: skip
#: Plates per block of terms: a few milliseconds of work.
BLOCK = 512
#: Number of supports whose measures are kept.
KEPT = 16
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

    @property
    def lengths(self) -> Any:
        """Numbers of edges of the plates, shape (plates,)."""
        return self.first[1:] - self.first[:-1]


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
    if len(supports) == 1:
        (pieces,) = supports
        edges = np.concatenate([np.empty((0, 5)), *pieces.plates])
        owners, lengths = _order_of_one(
            tuple(map(len, pieces[:PLATES])), tuple(map(len, pieces.plates))
        )
        return measure_pieces(list(map(np.asarray, pieces[:PLATES])), edges, owners, lengths, 1)
    rows = [np.concatenate([pieces[kind] for pieces in supports]) for kind in range(PLATES)]
    counts = [[len(pieces[kind]) for pieces in supports] for kind in range(PLATES + 1)]
    owners = [np.repeat(np.arange(len(supports)), count) for count in counts]
    plates = [edges for pieces in supports for edges in pieces.plates]
    lengths = np.array([len(edges) for edges in plates], dtype=np.int64)
    edges = np.concatenate([np.empty((0, 5)), *plates])
    owners += [np.repeat(owners[PLATES], lengths)]
    return measure_pieces(rows, edges, owners, lengths, len(supports))


@cache_results(KEPT)
def _order_of_one(counts: tuple[int, ...], lengths: tuple[int, ...]) -> tuple[list[Any], Any]:
    """Owners of the pieces of one support, and numbers of edges of its plates; not to be written to."""
    sizes = (*counts, len(lengths), sum(lengths))
    return [np.zeros(size, np.int64) for size in sizes], np.array(lengths, dtype=np.int64)


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
    first = np.zeros(len(lengths) + 1, np.int64)
    np.cumsum(lengths, out=first[1:])
    rows = [*rows, _places(edges, lengths, first[:-1]), edges]
    centers = _centers(rows, owners, count)
    extents, moments = _extents(rows, owners, centers), spreads(rows, owners, centers)
    return Gathered(rows, owners, first, centers, extents, moments)


def _places(edges: Array, lengths: Any, first: Any) -> Array:
    """Center of pressure, largest distance from it, and share of plates, by triangles over their edges."""
    places = np.empty((len(first), 4))
    if not len(first):
        return places
    starts, ends = edges[:, :2], edges[:, :4].reshape(-1, 2, 2)
    middle = (np.minimum.reduceat(starts, first) + np.maximum.reduceat(starts, first)) / 2
    away = ends - middle.repeat(lengths, axis=0)[:, None]
    start, end = away[:, 0], away[:, 1]
    loads = (start[:, 0] * end[:, 1] - start[:, 1] * end[:, 0]) / 2 * edges[:, 4]
    share = np.add.reduceat(loads, first)
    weighted = np.add.reduceat(loads[:, None] * (start + end), first)
    center = middle + weighted / (3 * share)[:, None]
    away = ends - center.repeat(lengths, axis=0)[:, None]
    reach = np.hypot(away[..., 0], away[..., 1]).max(axis=1)
    places[:, :2], places[:, 2], places[:, 3] = center, np.maximum.reduceat(reach, first), share
    return places


def _distance(points: Array, center: Array) -> Array:
    away = points - center
    return np.asarray(np.hypot(away[:, 0], away[:, 1]))


def _centers(rows: list[Array], owners: list[Any], count: int) -> Array:
    """Centers of pressure."""
    present = [kind for kind in range(EDGES) if len(rows[kind])]
    owner = np.concatenate([owners[kind] for kind in present])
    x, y, share = np.concatenate([_positions(kind, rows[kind]) for kind in present]).T
    total = np.bincount(owner, share, count)
    centers = np.empty((count, 2))
    centers[:, 0] = np.bincount(owner, share * x, count) / total
    centers[:, 1] = np.bincount(owner, share * y, count) / total
    return centers


def _positions(kind: int, rows: Array) -> Array:
    """Centers and shares of pieces of a kind, shape (n, 3)."""
    if kind == ATOMS:
        return rows
    if kind == SEGMENTS:
        return np.column_stack([(rows[:, :2] + rows[:, 2:4]) / 2, rows[:, 4]])
    return rows[:, [0, 1, 3]]


def _extents(rows: list[Array], owners: list[Any], centers: Array) -> Array:
    """Largest distances of supports from their centers of pressure."""
    extents = np.zeros(len(centers))
    for kind, column in EXTREMES:
        if not len(rows[kind]):
            continue
        reach = _distance(rows[kind][:, column : column + 2], centers[owners[kind]])
        if kind in (RINGS, DISCS):
            reach += rows[kind][:, 2]
        np.maximum.at(extents, owners[kind], reach)
    return extents


@cache_results(KEPT)
def measure_support(support: Any) -> Gathered:
    """The pieces of one support, with its center and extent."""
    return gather_pieces([support.pieces()])


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
    rows = np.zeros((sum(map(len, owners)), COLUMNS))
    counts, end = np.zeros((count, EDGES + 1), np.int64), 0
    for kind, scaled in kinds.items():
        first, end = end, end + len(scaled)
        rows[first:end, : scaled.shape[1]] = scaled
        counts[:, kind] = np.bincount(owners[kind], minlength=count)
    if count > 1:
        rows = rows[np.argsort(np.concatenate(owners), kind="stable")]
    starts = (counts.cumsum() - counts.ravel()).reshape(counts.shape)
    first_plates = counts[:, PLATES].cumsum() - counts[:, PLATES]
    # The edges of all supports follow the order of the plates, and so do these two arrays.
    lengths, owner = group.lengths, owners[PLATES]
    inside = group.first[:-1] - (counts[:, EDGES].cumsum() - counts[:, EDGES])[owner]
    begin = starts[owner, EDGES] + inside
    plates = starts[owner, PLATES] + np.arange(len(owner)) - first_plates[owner]
    rows[plates, COLUMNS - 2], rows[plates, COLUMNS - 1] = begin, begin + lengths
    return Stack(np.concatenate([starts, first_plates[:, None]], axis=1), rows, plates)


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
        edges = rows[plates[part]][:, [2, COLUMNS - 2, COLUMNS - 1]]
        edges[:, 1:] *= COLUMNS
        terms[part] = run("plate_terms", rows, edges, 2 * ROWS)

    starts = range(0, len(plates), BLOCK)
    if len(starts) > 1:
        in_threads(block, starts)
    elif len(starts):
        block(0)


def _scaled_rows(group: Gathered, radii: Array) -> tuple[dict[int, Array], list[Any]]:
    """Rows of each kind that is present, in units of the radii, and the owners of all kinds.

    Rows of plates lack their edge numbers.
    """
    owners, kinds = list(group.owners), {}
    for kind, rows in enumerate(group.rows):
        if not len(rows):
            continue
        unit = radii[owners[kind], None]
        if kind == ATOMS:
            kinds[kind], owners[kind] = _atoms(group, rows[:, :2] / unit, radii)
        elif kind == SEGMENTS:
            kinds[kind] = _lines(rows[:, :2] / unit, rows[:, 2:4] / unit, rows[:, 4])
        elif kind == EDGES:
            plates = group.rows[PLATES].repeat(group.lengths, axis=0)
            middle = plates[:, :2]
            start, end = (rows[:, :2] - middle) / unit, (rows[:, 2:4] - middle) / unit
            kinds[kind] = _lines(start, end, rows[:, 4] * unit[:, 0] ** 2 / plates[:, 3])
        else:
            kinds[kind] = rows.copy()
            kinds[kind][:, :3] /= unit
    return kinds, owners


def _atoms(group: Gathered, places: Array, radii: Array) -> tuple[Array, Any]:
    """Atoms in their order, and their owners; atoms of one support at the same place are merged."""
    owner: Any = group.owners[ATOMS]
    shares: Any = group.rows[ATOMS][:, 2]
    by_place = np.lexsort((places[:, 1], places[:, 0], owner))
    keys = np.column_stack([owner, places])[by_place]
    if (keys[1:] == keys[:-1]).all(axis=1).any():
        merged, first, which = np.unique(
            np.column_stack([owner, places]), axis=0, return_index=True, return_inverse=True
        )
        shares = np.bincount(which.ravel(), shares, len(merged))
        order = np.argsort(first)
        owner, places, shares = owner[first[order]], merged[order, 1:], shares[order]
    size = (group.extents / radii)[owner] + np.abs(places).sum(axis=1)
    return np.column_stack([places, shares, (ROUNDING * size) ** 2]), owner


def _lines(start: Array, end: Array, shares: Array) -> Array:
    """Midpoint, unit tangent and half length of lines, and their shares or jumps."""
    lines = np.empty((len(start), 6))
    along = end - start
    length = np.hypot(along[:, 0], along[:, 1])
    lines[:, :2], lines[:, 2:4] = (start + end) / 2, along / length[:, None]
    lines[:, 4], lines[:, 5] = length / 2, shares
    return lines
