"""Centers, extents and rows of numbers, from the pieces of one or many supports."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.core.supports.measures import MeasureRow, PlateEdges, PressureRow
from planar_pushing.core.supports.multipole import ROWS, PlateTerms
from planar_pushing.core.supports.piece_rows import (
    CIRCLE,
    COLUMNS,
    EDGE_LOAD,
    HEAD,
    LINE,
    MEASURED,
    PLATE,
    POINT,
    REACH,
    LineRow,
    PlateRow,
    PlateSums,
    ReachRow,
    StoredPlate,
    SupportMeasures,
)
from planar_pushing.mechanics.kernels.arrays import in_threads
from planar_pushing.mechanics.kernels.calls import run_into
from planar_pushing.mechanics.kernels.columns import Columns, row_of
from planar_pushing.mechanics.pressure.pieces import (
    ATOMS,
    DISCS,
    EDGES,
    PLATES,
    RINGS,
    SEGMENTS,
    Array,
    Pieces,
)
from planar_pushing.terms.caches import cache_results

#: Numbers of a piece in the data of `core.supports.measures`, and of its extreme points, by kind.
WIDTHS = np.array([POINT, LINE, CIRCLE, CIRCLE, PLATE, LINE])
EXTREMES = np.array([1, 2, 1, 1, 0, 2])
#: Plates per block of terms: a few milliseconds of work.
BLOCK = 512
#: Columns of a plate that `plate_terms` reads, and first column of measures in a row of `store_pressures`.
READ = np.array([StoredPlate.places[name] for name in PlateTerms.places])
#: Number of supports whose measures are kept.
KEPT = 16


class Layout(NamedTuple):
    """Where the pieces of supports are in arrays of numbers; it must not be written to.

    Attributes
    ----------
    counts : ndarray of int, shape (supports, 6)
        Numbers of pieces of each kind.
    lengths, first : ndarray of int, shape (plates,)
        Numbers of edges of the plates, and index at which those of each begin.
    ends : ndarray of int, shape (supports,)
        Index at which the extreme points of each support begin, behind the two ends of each edge.
    kinds : list of slice
        For each kind, the part of the data.
    results : int
        How many numbers of `measure_supports` follow in the data.
    loads, measures, pressures : ndarray
        Rows of `plate_loads` and `measure_supports`, and those of `store_pressures` without measures.
    lines : slice, or ndarray of int
        The rows of lines in the table.
    plates : ndarray of int, shape (plates, 3)
        Places in the table at which the row of a plate has what `plate_terms` reads: its radius, and the
        places of its edges.
    terms : int
        Place in the table at which the terms of plates begin.
    """

    counts: Any
    lengths: Any
    first: Any
    ends: Any
    kinds: list[slice]
    results: int
    loads: Array
    measures: Array
    pressures: Array
    lines: Any
    plates: Any
    terms: int


class Gathered(NamedTuple):
    """Pieces of several supports, grouped by kind.

    Attributes
    ----------
    data : ndarray
        As in `core.supports.measures`.
    layout : Layout
    measured : ndarray, shape (supports, MEASURED)
        Of the supports: centers of pressure and second moments.
    extents : ndarray, shape (supports,)
        Largest distances from the centers of pressure.
    write_terms : callable, optional
        Writes the terms of the plates into an array of shape (plates, 2 * ROWS), if they are known.
    """

    data: Array
    layout: Layout
    measured: Array
    extents: Array
    write_terms: Callable[[Array], None] | None = None

    @property
    def centers(self) -> Array:
        """Centers of pressure, shape (supports, 2)."""
        centers: Array = Columns(SupportMeasures, self.measured).center
        return centers

    @property
    def spreads(self) -> Array:
        """Means of x x, x y and y y about the centers of pressure, shape (supports, 3)."""
        spreads: Array = Columns(SupportMeasures, self.measured).spread
        return spreads

    def rows(self, kind: int) -> Array:
        """The rows of a kind: as in `Pieces`, and for plates center, extent, share and number of edges."""
        return self.data[self.layout.kinds[kind]].reshape(-1, WIDTHS[kind])

    @property
    def share(self) -> float:
        """Sum of the shares of all pieces, which is that of the supports."""
        kinds = (ATOMS, SEGMENTS, RINGS, DISCS)
        shares = sum(float(self.rows(kind)[:, -1].sum()) for kind in kinds)
        return shares + float(Columns(PlateRow, self.rows(PLATES)).share.sum())


def scale_shares(pieces: Pieces, share: float) -> Pieces:
    """Pieces with their shares multiplied by a factor."""
    atoms, segments, rings, discs = (_scale_last_column(rows, share) for rows in pieces[:4])
    plates = tuple(_scale_last_column(rows, share) for rows in pieces.plates)
    return Pieces(atoms, segments, rings, discs, plates)


def _scale_last_column(rows: Array, share: float) -> Array:
    """Rows with their last column multiplied by a factor."""
    scaled = np.array(rows, dtype=float)
    scaled[:, -1] *= share
    return scaled


def join_pieces(parts: Sequence[Pieces]) -> Pieces:
    """All pieces of several supports."""
    columns = zip(*(part[:4] for part in parts), strict=True)
    atoms, segments, rings, discs = map(np.concatenate, columns)
    plates = tuple(plate for part in parts for plate in part.plates)
    return Pieces(atoms, segments, rings, discs, plates)


def gather_pieces(supports: Sequence[Pieces]) -> Gathered:
    """Pieces of supports, with centers and extents.

    Raises
    ------
    ValueError
        If rows do not have the columns of `Pieces`, or a plate has no edges.
    """
    if len(supports) == 1:
        (pieces,) = supports
        rows, lengths = blocks_of(pieces)
        counts = len(rows[0]), len(rows[1]), len(rows[2]), len(rows[3]), len(lengths), len(rows[4])
        return measure_pieces(rows, _layout_of_one(counts, lengths))
    parts = [blocks_of(pieces) for pieces in supports]
    several = [np.concatenate(blocks) for blocks in zip(*(rows for rows, _ in parts), strict=True)]
    plates = [length for _, lengths in parts for length in lengths]
    every = [[*map(len, rows[:PLATES]), len(lengths), len(rows[-1])] for rows, lengths in parts]
    return measure_pieces(several, lay_out(np.array(every), np.array(plates, dtype=np.int64)))


def blocks_of(pieces: Pieces) -> tuple[list[Array], tuple[int, ...]]:
    """The rows of each kind but plates, with all edges last, and the numbers of edges of plates."""
    plates = [np.asarray(edges, dtype=float) for edges in pieces.plates]
    edges = plates[0] if len(plates) == 1 else np.concatenate([np.empty((0, 5)), *plates])
    rows = [*(np.asarray(block, dtype=float) for block in pieces[:PLATES]), edges]
    lengths = tuple(map(len, plates))
    columns = [block.shape[1:] for block in rows]
    if columns != [(3,), (5,), (4,), (4,), (5,)] or 0 in lengths:
        raise ValueError("rows of pieces have other columns than those of Pieces")
    return rows, lengths


@cache_results(KEPT)
def _layout_of_one(counts: tuple[int, ...], lengths: tuple[int, ...]) -> Layout:
    """`lay_out` of one support."""
    return lay_out(np.array([counts]), np.array(lengths, dtype=np.int64))


def lay_out(counts: Any, lengths: Any) -> Layout:
    """`Layout` of supports with so many pieces of each kind, and plates with so many edges."""
    count, before = len(counts), counts.cumsum(axis=0) - counts
    sizes = WIDTHS * counts.sum(axis=0)
    begin = sizes.cumsum() - sizes
    ends = counts @ EXTREMES
    first_end = ends.cumsum() - ends
    plates, edges = before[:, PLATES], before[:, EDGES]
    # The data end with the results of `measure_supports`: supports, ends of edges, extreme points.
    begin_results = int(sizes.sum())
    behind = begin_results + MEASURED * count
    measures = np.empty((count, MeasureRow.size))
    pieces = np.concatenate([begin + WIDTHS * before, counts], axis=1)
    measures[:, : pieces.shape[1]] = pieces
    fields = Columns(MeasureRow, measures)
    fields.measured = begin_results + MEASURED * np.arange(count)
    fields.plate_reach = behind + 2 * REACH * edges
    first_end += 2 * int(lengths.sum())
    fields.reach = behind + REACH * first_end
    results = behind - begin_results + REACH * int(2 * lengths.sum() + ends.sum())
    first = lengths.cumsum() - lengths
    edges_of = {"edges": begin[EDGES] + WIDTHS[EDGES] * first, "count": lengths, "first": first}
    loads = np.column_stack(row_of(PlateEdges, **edges_of)).astype(float)
    # The table: heads, rows, and terms.
    rows = counts.sum(axis=1)
    first_row = rows.cumsum() - rows
    terms = HEAD * count + COLUMNS * int(rows.sum())
    pressures = np.empty((count, PressureRow.size))
    pressures[:, : pieces.shape[1]] = pieces
    stored = Columns(PressureRow, pressures)
    stored.head, stored.first = HEAD * np.arange(count), HEAD * count + COLUMNS * first_row
    stored.series = terms + 2 * ROWS * plates
    stored.end = np.append(stored.first[1:], terms)
    # Within a support the kinds are in their order.
    kinds = first_row[:, None] + counts.cumsum(axis=1) - counts
    every = [_numbers(kinds[:, kind], counts[:, kind]) for kind in (PLATES, SEGMENTS, EDGES)]
    lines: Any = np.concatenate(every[1:])
    if len(lines) and lines[-1] - lines[0] == len(lines) - 1:
        lines = slice(int(lines[0]), int(lines[-1]) + 1)
    return Layout(
        counts=counts, lengths=lengths, first=first, ends=first_end,
        kinds=[slice(start, start + size) for start, size in zip(begin, sizes, strict=True)],
        results=results, loads=loads, measures=measures, pressures=pressures, lines=lines,
        plates=(HEAD * count + COLUMNS * every[0])[:, None] + READ, terms=terms,
    )  # fmt: skip


def _numbers(first: Any, counts: Any) -> Any:
    """Successive numbers from each first one, one sequence after the other."""
    return np.repeat(first - (counts.cumsum() - counts), counts) + np.arange(counts.sum())


def measure_pieces(rows: list[Array], layout: Layout) -> Gathered:
    """`Gathered` from the rows of each kind but plates, with the edges last.

    Parameters
    ----------
    rows : list of ndarray
        As of `blocks_of`, kind by kind and within a kind one support after the other.
    layout : Layout
    """
    lengths, count = layout.lengths, len(layout.counts)
    room = np.empty(PLATE * len(lengths)), rows[-1], np.empty(layout.results)
    data = np.concatenate([*rows[:PLATES], *room], axis=None)
    plates = data[layout.kinds[PLATES]].reshape(-1, PLATE)
    if len(lengths):
        loads = np.empty((len(rows[-1]), EDGE_LOAD))
        run_into("plate_loads", data, layout.loads, loads)
        plates[:, :EDGE_LOAD] = np.add.reduceat(loads, layout.first)
        Columns(PlateSums, plates).edges = lengths
    column = data[:, None]
    run_into("measure_supports", data, layout.measures, column)
    results = data[len(data) - layout.results :]
    vectors = results[MEASURED * count :].reshape(-1, REACH)
    ends = Columns(ReachRow, vectors)
    reach = np.hypot(ends.x, ends.y) + ends.more
    extents = np.maximum.reduceat(reach, layout.ends)
    if len(lengths):
        radii = np.maximum.reduceat(reach[: layout.ends[0]], 2 * layout.first)
        Columns(PlateRow, plates).radius = radii
    return Gathered(data, layout, results[: MEASURED * count].reshape(count, MEASURED), extents)


@cache_results(KEPT)
def measure_support(support: Any) -> Gathered:
    """The pieces of one support, with its center and extent."""
    return gather_pieces([support.pieces()])


class Stack(NamedTuple):
    """Pressures of several supports, as in `core.pieces`, one support after the other.

    Attributes
    ----------
    memory, data : ndarray
        The array, and its part with the pressures: heads, rows, and terms of the plates.
    terms : ndarray, shape (plates, 2 * ROWS)
        The terms in the data.
    most_atoms : int
        Maximum number of atoms of a support.
    """

    memory: Array
    data: Array
    terms: Array
    most_atoms: int


def stack(group: Gathered, radii: Array, front: int = 0) -> Stack:
    """Pressures of supports, each in units of its own radius, with room for numbers in front of them."""
    group = _merge_atoms(group, radii)
    layout = group.layout
    count, end = len(radii), layout.terms
    memory = np.empty(front + end + 2 * ROWS * len(layout.lengths))
    data = memory[front:]
    rows = layout.pressures.copy()
    stored = Columns(PressureRow, rows)
    stored.measures, stored.extent, stored.unit = group.measured, group.extents, radii
    run_into("store_pressures", group.data, rows, data[:, None])
    pieces = data[HEAD * count : end].reshape(-1, COLUMNS)
    lines = pieces[layout.lines]
    if len(lines):
        line = Columns(LineRow, lines)
        length = np.hypot(line.t_x, line.t_y)
        line.t_x, line.t_y, line.half = line.t_x / length, line.t_y / length, length / 2
        if type(layout.lines) is not slice:  # else these are views
            pieces[layout.lines] = lines
    terms = data[end:].reshape(-1, 2 * ROWS)
    write_terms(group, data, terms)
    return Stack(memory, data, terms, int(layout.counts[:, ATOMS].max()))


def write_terms(group: Gathered, data: Array, terms: Array) -> None:
    """Write the multipole terms of plates, which are known or computed on all cores.

    Parameters
    ----------
    group : Gathered
    data : ndarray
        The heads and rows of the pressures.
    terms : ndarray, shape (plates, 2 * ROWS)
        The array to which the terms are written.
    """
    if group.write_terms is not None:
        group.write_terms(terms)
        return
    plates = group.layout.plates

    def block(start: int) -> None:
        part = slice(start, start + BLOCK)
        run_into("plate_terms", data, data[plates[part]], terms[part])

    starts = range(0, len(plates), BLOCK)
    if len(starts) > 1:
        in_threads(block, starts)
    elif len(starts):
        block(0)


def _merge_atoms(group: Gathered, radii: Array) -> Gathered:
    """Pieces in which atoms of one support at the same place are one atom."""
    atoms, counts = group.rows(ATOMS), group.layout.counts
    if len(atoms) < 2:
        return group
    owner = np.repeat(np.arange(len(radii)), counts[:, ATOMS])
    places = atoms[:, :2] / radii[owner, None]
    if len(radii) == 1:
        is_double = len({*map(tuple, places.tolist())}) < len(atoms)
    else:
        by_place = np.lexsort((places[:, 1], places[:, 0], owner))
        sorted_places = np.column_stack([owner, places])[by_place]
        is_double = bool((sorted_places[1:] == sorted_places[:-1]).all(axis=1).any())
    if not is_double:
        return group
    keys = list(zip(owner.tolist(), *places.T.tolist(), strict=True))
    shares: dict[tuple[int, float, float], float] = {}
    first: list[int] = []
    for i, (key, share) in enumerate(zip(keys, atoms[:, 2].tolist(), strict=True)):
        if key not in shares:
            first.append(i)
        shares[key] = shares.get(key, 0.0) + share
    merged = np.column_stack([atoms[first, :2], list(shares.values())])
    fewer = counts.copy()
    fewer[:, ATOMS] = np.bincount(owner[first], minlength=len(radii))
    data = np.concatenate([merged.ravel(), group.data[group.layout.kinds[ATOMS].stop :]])
    return group._replace(data=data, layout=lay_out(fewer, group.layout.lengths))
