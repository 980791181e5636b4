"""Centers, extents, and rows of the compiled core, from the pieces of one or many supports."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.supports.pressure.multipole import of_all
from planar_pushing.mechanics.supports.pressure.record import (
    ATOMS,
    COLUMNS,
    DISCS,
    EDGES,
    PLATES,
    RINGS,
    SEGMENTS,
    Array,
    Pieces,
    Pressure,
)
from planar_pushing.mechanics.supports.pressure.spread import spreads

#: A center of rotation closer to an atom than this, relative to the numbers in its computation, is on it.
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
    terms : ndarray, optional
        Terms of the plates, as `multipole.of_all` computes them, if they are known.
    """

    rows: list[Array]
    owners: list[Any]
    first: Any
    centers: Array
    extents: Array
    spreads: Array
    terms: Array | None = None


def shared(pieces: Pieces, share: float) -> Pieces:
    """Pieces with their shares multiplied by a share."""
    atoms, segments, rings, discs = (_scaled(each, share) for each in pieces[:4])
    plates = tuple(_scaled(each, share) for each in pieces.plates)
    return Pieces(atoms, segments, rings, discs, plates)


def _scaled(rows: Array, share: float) -> Array:
    """Rows with their last column multiplied by a share."""
    return np.column_stack([rows[:, :-1], rows[:, -1] * share])


def joined(parts: Sequence[Pieces]) -> Pieces:
    """All pieces of several supports."""
    columns = zip(*(part[:4] for part in parts), strict=True)
    atoms, segments, rings, discs = map(np.concatenate, columns)
    plates = tuple(plate for part in parts for plate in part.plates)
    return Pieces(atoms, segments, rings, discs, plates)


def gathered(supports: Sequence[Pieces]) -> Gathered:
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
    """`Gathered` from the rows of each kind before the plates, their edges, and the owners of all.

    Parameters
    ----------
    rows, owners : list of ndarray
        As in `Gathered`; of plates and edges the owners only.
    edges : ndarray, shape (m, 5)
    lengths : ndarray of int, shape (plates,)
        Number of edges of each plate.
    count : int
        Number of supports.
    """
    first = np.concatenate([[0], lengths.cumsum()])
    rows = [*rows, _places(edges, lengths, first[:-1]), edges]
    centers = _centers(rows, owners, count)
    extents, found = _extents(rows, owners, centers), spreads(rows, owners, centers)
    return Gathered(rows, owners, first, centers, extents, found)


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
    round_ones = [each[:, [0, 1, 3]] for each in (rings, discs, plates)]
    x, y, share = np.concatenate([atoms, lines, *round_ones]).T
    owner = np.concatenate(owners[:EDGES])
    whole = np.bincount(owner, share, count)
    return np.column_stack([np.bincount(owner, share * each, count) / whole for each in (x, y)])


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
    found = np.zeros(len(centers))
    for kind, column in ends:
        reach = _distance(rows[kind][:, column : column + 2], centers[owners[kind]])
        if kind in (RINGS, DISCS):
            reach += rows[kind][:, 2]
        np.maximum.at(found, owners[kind], reach)
    return found


def center(pieces: Pieces) -> tuple[float, float]:
    """Center of pressure."""
    x, y = gathered([pieces]).centers[0]
    return float(x), float(y)


def extent(pieces: Pieces) -> float:
    """Largest distance of the pieces from the center of pressure."""
    return float(gathered([pieces]).extents[0])


def assembled(pieces: Pieces, radius: float) -> Pressure:
    """`Pressure` of pieces, in units of the slider's radius."""
    found = gathered([pieces])
    starts, rows, multipoles = stacked(found, np.array([radius]))
    (x, y), size = found.centers[0] / radius, found.extents[0] / radius
    xx, xy, yy = (found.spreads[0] / radius**2).tolist()
    first = tuple(starts[0, : EDGES + 1].tolist())
    return Pressure(float(x), float(y), float(size), (xx, xy, yy), first, 0, rows, multipoles)


def stacked(found: Gathered, radii: Array) -> tuple[Any, Array, Array]:
    """Starts, shape (supports, 7), rows and multipoles of supports, each in units of its own radius.

    The starts are those of `Pressure`, followed by the number of the support's first multipoles.
    """
    kinds, owners = _scaled_rows(found, radii)
    count = len(radii)
    order = np.argsort(np.concatenate(owners), kind="stable")
    rows = np.concatenate([np.pad(each, ((0, 0), (0, COLUMNS - each.shape[1]))) for each in kinds])
    counts = np.column_stack([np.bincount(owner, minlength=count) for owner in owners])
    starts = (counts.cumsum() - counts.ravel()).reshape(counts.shape)
    series = counts[:, PLATES].cumsum() - counts[:, PLATES]
    rows = np.ascontiguousarray(rows[order])
    # The edges of all supports follow the order of the plates, and so do these two arrays.
    lengths, owner = np.diff(found.first), owners[PLATES]
    inside = found.first[:-1] - (counts[:, EDGES].cumsum() - counts[:, EDGES])[owner]
    begin = starts[owner, EDGES] + inside
    plates = starts[owner, PLATES] + np.arange(len(owner)) - series[owner]
    rows[plates, COLUMNS - 2], rows[plates, COLUMNS - 1] = begin, begin + lengths
    terms = of_all(rows, plates) if found.terms is None else found.terms
    return np.column_stack([starts, series]), rows, terms


def _scaled_rows(found: Gathered, radii: Array) -> tuple[list[Array], list[Any]]:
    """Rows of each kind in units of the radii, and their owners; rows of plates lack their edge numbers."""
    owners, unit = list(found.owners), [radii[owner, None] for owner in found.owners]
    atoms, segments, rings, discs, plates, edges = found.rows
    atoms, owners[ATOMS] = _atoms(found, atoms[:, :2] / unit[ATOMS], radii)
    lines = _lines(segments[:, :2] / unit[SEGMENTS], segments[:, 2:4] / unit[SEGMENTS])
    plate = np.repeat(np.arange(len(plates)), np.diff(found.first))
    middle, size = plates[plate, :2], unit[EDGES]
    sides = _lines((edges[:, :2] - middle) / size, (edges[:, 2:4] - middle) / size)
    jumps = edges[:, 4] * size[:, 0] ** 2 / plates[plate, 3]
    whole = [
        np.column_stack([each[:, :3] / radii[owner, None], each[:, 3]])
        for each, owner in zip((rings, discs, plates), found.owners[RINGS:EDGES], strict=True)
    ]
    kinds = [
        atoms, np.column_stack([lines, segments[:, 4]]), *whole, np.column_stack([sides, jumps]),
    ]  # fmt: skip
    return kinds, owners


def _atoms(found: Gathered, places: Array, radii: Array) -> tuple[Array, Any]:
    """Atoms in their order, and their owners; atoms of one support at the same place are merged."""
    owner: Any = found.owners[ATOMS]
    shares: Any = found.rows[ATOMS][:, 2]
    keys = np.column_stack([owner, places])
    merged, first, which = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    shares = np.bincount(which.ravel(), shares, len(merged))
    order = np.argsort(first)
    own = owner[first[order]]
    places, shares = merged[order, 1:], shares[order]
    size = (found.extents / radii)[own] + np.abs(places).sum(axis=1)
    return np.column_stack([places, shares, (ROUNDING * size) ** 2]), own


def _lines(start: Array, end: Array) -> Array:
    """Midpoint, unit tangent and half length of lines."""
    along = end - start
    length = np.hypot(along[:, 0], along[:, 1])
    return np.column_stack([(start + end) / 2, along / length[:, None], length / 2])
