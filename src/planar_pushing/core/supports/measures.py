"""From the pieces of supports, in a unit of length of the user, to pressures as `pieces` describes them.

`data` holds the pieces of all supports, kind by kind and within a kind one support after the other: atoms
as `PointRow`, segments as `EndsRow`, rings and discs as `CircleRow`, plates as `PlateSums` of what
`plate_loads` stores, and the edges of the plates as `EndsRow`. `measure_supports` replaces the sums by a
`PlateRow`, whose radius is left to the caller.

Distances are left to the caller, since a compiled square root of a sum of squares is not the function
`hypot` of a library: `measure_supports` stores the vectors, and `store_pressures` stores those along lines
in place of their tangents.
"""

from __future__ import annotations

from math import fabs

from planar_pushing.core._record import Record
from planar_pushing.core.numbers import UNKNOWN, Numbers
from planar_pushing.core.supports.piece_rows import (
    CIRCLE,
    COLUMNS,
    LINE,
    PLATE,
    POINT,
    REACH,
    AtomRow,
    CircleRow,
    EdgeLoad,
    EndsRow,
    LineRow,
    PlateRow,
    PlateSums,
    PointRow,
    PressureHead,
    ReachRow,
    Spread,
    StoredPlate,
    SupportMeasures,
)

#: Mean square of a coordinate from the center of a ring and of a disc, in squares of the radius.
RING_SPREAD, DISC_SPREAD = 1 / 2, 1 / 4
#: A center of rotation closer to an atom than this, relative to the numbers in its computation, counts as
#: on it.
ATOM_ROUNDING = 1e-15


class PlateEdges(Record):
    """Edges of a plate: place in the data, number, and the row of results of the first one."""

    edges: int
    count: int
    first: int


class PieceRows(Record):
    """Places in the data at which the pieces of a support begin, and their numbers.

    Attributes
    ----------
    atoms, segments, rings, discs, plates, edges : int
    atom_count, segment_count, ring_count, disc_count, plate_count, edge_count : int
    """

    atoms: int
    segments: int
    rings: int
    discs: int
    plates: int
    edges: int
    atom_count: int
    segment_count: int
    ring_count: int
    disc_count: int
    plate_count: int
    edge_count: int


class MeasureRow(PieceRows):
    """A support to be measured, with the places of its results.

    Attributes
    ----------
    measured : int
        `SupportMeasures`.
    plate_reach, reach : int
        A `ReachRow` of each end of an edge, from the center of its plate; and of each extreme point,
        from the center of pressure.
    """

    measured: int
    plate_reach: int
    reach: int


class PressureRow(PieceRows):
    """A support to be stored as a pressure.

    Attributes
    ----------
    measures : SupportMeasures
    extent : float
        In the unit of the data, as the measures.
    unit : float
        The unit of the pressure.
    head, first, series, end : int
        Places in the results of its head, its rows and the terms of its plates, and of the end of its rows.
    """

    measures: SupportMeasures
    extent: float
    unit: float
    head: int
    first: int
    series: int
    end: int


def plate_loads(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """For each edge of plates, the load of its triangle about the middle of the plate, and its moments.

    Parameters
    ----------
    data : array
    rows : array
        As `PlateEdges`.
    results : array
        An `EdgeLoad` for each edge.
    """
    for i in range(count):
        row = PlateEdges(rows[i * columns :])
        edges, length, first = data[row.edges :], row.count, row.first
        middle_x, middle_y = middle_of(edges, length)
        for j in range(length):
            edge, result = EndsRow(edges[LINE * j :]), EdgeLoad(results[(first + j) * width :])
            x, y = edge.x - middle_x, edge.y - middle_y
            end_x, end_y = edge.end_x - middle_x, edge.end_y - middle_y
            load = (x * end_y - y * end_x) / 2.0 * edge.share
            result.load = load
            result.load_x, result.load_y = load * (x + end_x), load * (y + end_y)


def middle_of(edges: Numbers, count: int) -> tuple[float, float]:
    """Middle of the rectangle around the starts of edges."""
    edge = EndsRow(edges)
    low_x, low_y, high_x, high_y = edge.x, edge.y, edge.x, edge.y
    for j in range(1, count):
        edge = EndsRow(edges[LINE * j :])
        x, y = edge.x, edge.y
        low_x, low_y, high_x, high_y = min(low_x, x), min(low_y, y), max(high_x, x), max(high_y, y)
    return (low_x + high_x) / 2.0, (low_y + high_y) / 2.0


def measure_supports(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """Centers and second moments of supports and their plates, and the vectors to their extreme points.

    Parameters
    ----------
    data : array
    rows : array
        As `MeasureRow`.
    results : array
        The data, too, with the results at the places that the rows name.
    """
    for i in range(count):
        row = MeasureRow(rows[i * columns :])
        measures = SupportMeasures(results[row.measured :])
        measure_plates(results, row, results[row.plate_reach :])
        store_center(results, row, measures)
        store_spread(results, row, measures)
        store_reach(results, row, measures, results[row.reach :])


def measure_plates(data: Numbers, row: MeasureRow, reach: Numbers) -> None:
    """Store centers and shares of the plates, and the vectors to the ends of their edges."""
    edges = row.edges
    for i in range(row.plate_count):
        place = row.plates + PLATE * i
        sums, plate = PlateSums(data[place:]), PlateRow(data[place:])
        length, share = sums.edges, sums.load
        x, y = middle_of(data[edges:], length)
        if share == 0.0:
            x, y = UNKNOWN, UNKNOWN
        else:
            x, y = x + sums.load_x / (3.0 * share), y + sums.load_y / (3.0 * share)
        plate.x, plate.y, plate.share = x, y, share
        for j in range(length):
            store_ends(reach, EndsRow(data[edges + LINE * j :]), x, y)
            reach = reach[2 * REACH :]
        edges += LINE * length


def store_vector(reach: Numbers, x: float, y: float, more: float) -> None:
    """Store a vector, and what is added to its length."""
    row = ReachRow(reach)
    row.x, row.y, row.more = x, y, more


def store_center(data: Numbers, row: MeasureRow, measures: SupportMeasures) -> None:
    """Store the center of pressure of a support, kind by kind as sums in their order."""
    x, y, total = 0.0, 0.0, 0.0
    for i in range(row.atom_count):
        atom = PointRow(data[row.atoms + POINT * i :])
        share = atom.share
        x, y, total = x + share * atom.x, y + share * atom.y, total + share
    for i in range(row.segment_count):
        line = EndsRow(data[row.segments + LINE * i :])
        share = line.share
        x += share * ((line.x + line.end_x) / 2.0)
        y += share * ((line.y + line.end_y) / 2.0)
        total += share
    for i in range(row.ring_count + row.disc_count):
        circle = circle_at(data, row, i)
        share = circle.share
        x, y, total = x + share * circle.x, y + share * circle.y, total + share
    for i in range(row.plate_count):
        plate = PlateRow(data[row.plates + PLATE * i :])
        share = plate.share
        x, y, total = x + share * plate.x, y + share * plate.y, total + share
    if total == 0.0:
        measures.center.x, measures.center.y = UNKNOWN, UNKNOWN
        return
    measures.center.x, measures.center.y = x / total, y / total


def circle_at(data: Numbers, row: MeasureRow, number: int) -> CircleRow:
    """A ring or, after all rings of the support, a disc."""
    if number < row.ring_count:
        return CircleRow(data[row.rings + CIRCLE * number :])
    return CircleRow(data[row.discs + CIRCLE * (number - row.ring_count) :])


def store_spread(data: Numbers, row: MeasureRow, measures: SupportMeasures) -> None:
    """Store the means of x x, x y and y y about the center of pressure."""
    x, y, spread = measures.center.x, measures.center.y, measures.spread
    spread.xx, spread.xy, spread.yy = 0.0, 0.0, 0.0
    for i in range(row.atom_count):
        atom = PointRow(data[row.atoms + POINT * i :])
        a, b = atom.x - x, atom.y - y
        add_line(spread, share=atom.share, a=a, b=b, c=a, d=b, more=0.0)
    for i in range(row.segment_count):
        line = EndsRow(data[row.segments + LINE * i :])
        a, b, c, d = line.x - x, line.y - y, line.end_x - x, line.end_y - y
        add_line(spread, share=line.share, a=a, b=b, c=c, d=d, more=0.0)
    for i in range(row.ring_count):
        add_circle(spread, CircleRow(data[row.rings + CIRCLE * i :]), x, y, part=RING_SPREAD)
    for i in range(row.disc_count):
        add_circle(spread, CircleRow(data[row.discs + CIRCLE * i :]), x, y, part=DISC_SPREAD)
    for i in range(row.edge_count):
        edge = EndsRow(data[row.edges + LINE * i :])
        a, b, c, d = edge.x - x, edge.y - y, edge.end_x - x, edge.end_y - y
        # Moments of the triangle from the center to the edge, weighted by its share of the pressure.
        share = edge.share * (a * d - b * c) / 4.0
        add_line(spread, share=share, a=a, b=b, c=c, d=d, more=0.0)


def add_circle(spread: Spread, circle: CircleRow, x: float, y: float, part: float) -> None:
    """Add a ring or a disc to second moments about (x, y)."""
    a, b = circle.x - x, circle.y - y
    more = part * (circle.radius * circle.radius)
    add_line(spread, share=circle.share, a=a, b=b, c=a, d=b, more=more)


def add_line(
    spread: Spread, share: float, a: float, b: float, c: float, d: float, more: float
) -> None:
    """Add a uniform line from (a, b) to (c, d) to second moments; `more` is that of its width."""
    xx, yy = (a * a + a * c + c * c) / 3.0, (b * b + b * d + d * d) / 3.0
    xy = (2.0 * a * b + a * d + b * c + 2.0 * c * d) / 6.0
    spread.xx += share * (xx + more)
    spread.xy += share * xy
    spread.yy += share * (yy + more)


def store_reach(data: Numbers, row: MeasureRow, measures: SupportMeasures, reach: Numbers) -> None:
    """Store the vectors from the center of pressure to the extreme points of a support."""
    x, y = measures.center.x, measures.center.y
    for i in range(row.atom_count):
        atom = PointRow(data[row.atoms + POINT * i :])
        store_vector(reach, atom.x - x, atom.y - y, 0.0)
        reach = reach[REACH:]
    for i in range(row.segment_count):
        store_ends(reach, EndsRow(data[row.segments + LINE * i :]), x, y)
        reach = reach[2 * REACH :]
    for i in range(row.ring_count + row.disc_count):
        circle = circle_at(data, row, i)
        store_vector(reach, circle.x - x, circle.y - y, circle.radius)
        reach = reach[REACH:]
    for i in range(row.edge_count):
        store_ends(reach, EndsRow(data[row.edges + LINE * i :]), x, y)
        reach = reach[2 * REACH :]


def store_ends(reach: Numbers, line: EndsRow, x: float, y: float) -> None:
    """Store the vectors from (x, y) to both ends of a line."""
    store_vector(reach, line.x - x, line.y - y, 0.0)
    store_vector(reach[REACH:], line.end_x - x, line.end_y - y, 0.0)


def store_pressures(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """Heads and rows of pressures, except tangents and half lengths of lines, and terms of plates.

    Parameters
    ----------
    data : array
    rows : array
        As `PressureRow`.
    results : array
        The pressures. The row of a line has the vector along it in place of its tangent.
    """
    for i in range(count):
        row = PressureRow(rows[i * columns :])
        head, unit = PressureHead(results[row.head :]), row.unit
        measures, square = row.measures, unit * unit
        head.center.x, head.center.y = measures.center.x / unit, measures.center.y / unit
        spread, stored = measures.spread, head.spread
        stored.xx, stored.xy = spread.xx / square, spread.xy / square
        stored.yy = spread.yy / square
        k = row.first
        head.atoms = k
        k = store_atoms(data, row, results, k)
        head.segments = k
        for j in range(row.segment_count):
            line = EndsRow(data[row.segments + LINE * j :])
            store_line(results[k:], line, 0.0, 0.0, unit, share=line.share)
            k += COLUMNS
        head.rings = k
        k = store_circles(data[row.rings :], row.ring_count, unit, results, k)
        head.discs = k
        k = store_circles(data[row.discs :], row.disc_count, unit, results, k)
        head.plates, head.edges = k, k + COLUMNS * row.plate_count
        store_plates(data, row, results, k)
        head.series, head.end = row.series, row.end


def store_atoms(data: Numbers, row: PressureRow, results: Numbers, k: int) -> int:
    """Store the atoms of a support; the place after them is returned."""
    extent = row.extent / row.unit
    for i in range(row.atom_count):
        clear_row(results[k:])
        atom, stored = PointRow(data[row.atoms + POINT * i :]), AtomRow(results[k:])
        x, y = atom.x / row.unit, atom.y / row.unit
        blur = ATOM_ROUNDING * (extent + (fabs(x) + fabs(y)))
        stored.x, stored.y, stored.share, stored.square = x, y, atom.share, blur * blur
        k += COLUMNS
    return k


def clear_row(stored: Numbers) -> None:
    """Store zeros in the row of a piece."""
    for j in range(COLUMNS):
        stored[j] = 0.0


def store_circles(circles: Numbers, count: int, unit: float, results: Numbers, k: int) -> int:
    """Store rings or discs; the place after them is returned."""
    for i in range(count):
        clear_row(results[k:])
        circle, stored = CircleRow(circles[CIRCLE * i :]), CircleRow(results[k:])
        stored.x, stored.y = circle.x / unit, circle.y / unit
        stored.radius, stored.share = circle.radius / unit, circle.share
        k += COLUMNS
    return k


def store_plates(data: Numbers, row: PressureRow, results: Numbers, k: int) -> None:
    """Store the plates of a support, and their edges behind all of them."""
    unit, begin, edges = row.unit, k + COLUMNS * row.plate_count, row.edges
    for i in range(row.plate_count):
        plate, stored = PlateRow(data[row.plates + PLATE * i :]), StoredPlate(results[k:])
        length, end = plate.edges, begin
        for j in range(length):
            edge = EndsRow(data[edges + LINE * j :])
            jump = edge.share * (unit * unit) / plate.share
            store_line(results[end:], edge, plate.x, plate.y, unit, share=jump)
            end += COLUMNS
        stored.x, stored.y, stored.radius = plate.x / unit, plate.y / unit, plate.radius / unit
        stored.share, stored.first, stored.last = plate.share, begin, end
        begin, edges = end, edges + LINE * length
        k += COLUMNS


def store_line(
    numbers: Numbers, line: EndsRow, x: float, y: float, unit: float, share: float
) -> None:
    """Store the midpoint of a line from (x, y), the vector along it, and its share or jump."""
    start_x, start_y = (line.x - x) / unit, (line.y - y) / unit
    end_x, end_y = (line.end_x - x) / unit, (line.end_y - y) / unit
    stored = LineRow(numbers)
    stored.x, stored.y = (start_x + end_x) / 2.0, (start_y + end_y) / 2.0
    stored.t_x, stored.t_y = end_x - start_x, end_y - start_y
    stored.half, stored.share = 0.0, share
