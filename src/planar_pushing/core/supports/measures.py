"""From the pieces of supports, in a unit of length of the user, to pressures as `pieces` describes them.

`data` holds the pieces of all supports, kind by kind and within a kind one support after the other: atoms
x, y, share; segments x and y of both ends, share; rings and discs x and y of the center, radius, share;
plates; and the edges of the plates, x and y of both ends and the jump of the pressure. The five numbers of
a plate are the sums over its edges of what `plate_loads` stores, an unused one, and its number of edges.
`measure_supports` replaces them by its center of pressure, room for the largest distance from it, its
share, and the same.

Distances are left to the caller, since a compiled square root of a sum of squares is not the function
`hypot` of a library: `measure_supports` stores the vectors, and `store_pressures` stores those along lines
in place of their tangents.
"""

from __future__ import annotations

from math import fabs

from planar_pushing.core._record import Record
from planar_pushing.core.numbers import UNKNOWN, Numbers
from planar_pushing.core.supports.pieces import (
    ATOMS,
    CENTER,
    COLUMNS,
    DISCS,
    EDGES,
    END,
    HEAD,
    PLATES,
    RINGS,
    SEGMENTS,
    SERIES,
    SPREAD,
)

#: Numbers of an atom, a line and a circle, of a plate, and of an edge in the sums of plates.
ATOM, LINE, CIRCLE, PLATE, EDGE_LOAD = 3, 5, 4, 5, 3
#: Mean square of a coordinate from the center of a ring and of a disc, in squares of the radius.
RING_SPREAD, DISC_SPREAD = 1 / 2, 1 / 4
#: A center of rotation closer to an atom than this, relative to the numbers in its computation, counts as
#: on it.
ATOM_ROUNDING = 1e-15
#: Numbers of a support in the results of `measure_supports`, the center and its second moments; and of a
#: vector there, x, y and what is added to the length.
MEASURED, REACH = 5, 3


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
        `MEASURED` numbers of the support.
    plate_reach, reach : int
        `REACH` numbers of each end of an edge, from the center of its plate; and of each extreme point,
        from the center of pressure.
    """

    measured: int
    plate_reach: int
    reach: int


class PressureRow(PieceRows):
    """A support to be stored as a pressure.

    Attributes
    ----------
    center_x, center_y, xx, xy, yy, extent : float
        Its measures, in the unit of the data.
    unit : float
        The unit of the pressure.
    head, first, series, end : int
        Places in the results of its head, its rows and the terms of its plates, and of the end of its rows.
    """

    center_x: float
    center_y: float
    xx: float
    xy: float
    yy: float
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
        For each plate: place of its edges in the data, their number, and the row of results of the first.
    results : array
        For each edge the load, and the load times the sums of x and of y of its ends.
    """
    for i in range(count):
        row = rows[i * columns :]
        edges, length, k = data[int(row[0]) :], int(row[1]), int(row[2]) * width
        middle_x, middle_y = middle_of(edges, length)
        for j in range(length):
            edge = edges[LINE * j :]
            x, y = edge[0] - middle_x, edge[1] - middle_y
            end_x, end_y = edge[2] - middle_x, edge[3] - middle_y
            load = (x * end_y - y * end_x) / 2.0 * edge[4]
            results[k], results[k + 1], results[k + 2] = (
                load,
                load * (x + end_x),
                load * (y + end_y),
            )
            k += width


def middle_of(edges: Numbers, count: int) -> tuple[float, float]:
    """Middle of the rectangle around the starts of edges."""
    low_x, low_y, high_x, high_y = edges[0], edges[1], edges[0], edges[1]
    for j in range(1, count):
        x, y = edges[LINE * j], edges[LINE * j + 1]
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
        measured = results[row.measured :]
        measure_plates(results, row, results[row.plate_reach :])
        store_center(results, row, measured)
        store_spread(results, row, measured)
        store_reach(results, row, measured, results[row.reach :])


def measure_plates(data: Numbers, row: MeasureRow, reach: Numbers) -> None:
    """Store centers and shares of the plates, and the vectors to the ends of their edges."""
    edges = row.edges
    for i in range(row.plate_count):
        plate = data[row.plates + PLATE * i :]
        length, share = int(plate[4]), plate[0]
        x, y = middle_of(data[edges:], length)
        if share == 0.0:
            x, y = UNKNOWN, UNKNOWN
        else:
            x, y = x + plate[1] / (3.0 * share), y + plate[2] / (3.0 * share)
        plate[0], plate[1], plate[3] = x, y, share
        for j in range(length):
            place = edges + LINE * j
            store_vector(reach, data[place] - x, data[place + 1] - y, 0.0)
            reach = reach[REACH:]
            store_vector(reach, data[place + 2] - x, data[place + 3] - y, 0.0)
            reach = reach[REACH:]
        edges += LINE * length


def store_vector(reach: Numbers, x: float, y: float, more: float) -> None:
    """Store a vector, and what is added to its length."""
    reach[0], reach[1], reach[2] = x, y, more


def store_center(data: Numbers, row: MeasureRow, measured: Numbers) -> None:
    """Store the center of pressure of a support, kind by kind as sums in their order."""
    x, y, total = 0.0, 0.0, 0.0
    for i in range(row.atom_count):
        k = row.atoms + ATOM * i
        share = data[k + 2]
        x, y, total = x + share * data[k], y + share * data[k + 1], total + share
    for i in range(row.segment_count):
        k = row.segments + LINE * i
        share = data[k + 4]
        x += share * ((data[k] + data[k + 2]) / 2.0)
        y += share * ((data[k + 1] + data[k + 3]) / 2.0)
        total += share
    for i in range(row.ring_count):
        k = row.rings + CIRCLE * i
        share = data[k + 3]
        x, y, total = x + share * data[k], y + share * data[k + 1], total + share
    for i in range(row.disc_count):
        k = row.discs + CIRCLE * i
        share = data[k + 3]
        x, y, total = x + share * data[k], y + share * data[k + 1], total + share
    for i in range(row.plate_count):
        k = row.plates + PLATE * i
        share = data[k + 3]
        x, y, total = x + share * data[k], y + share * data[k + 1], total + share
    if total == 0.0:
        measured[0], measured[1] = UNKNOWN, UNKNOWN
        return
    measured[0], measured[1] = x / total, y / total


def store_spread(data: Numbers, row: MeasureRow, measured: Numbers) -> None:
    """Store the means of x x, x y and y y about the center of pressure."""
    x, y = measured[0], measured[1]
    measured[2], measured[3], measured[4] = 0.0, 0.0, 0.0
    spread = measured[2:]
    for i in range(row.atom_count):
        atom = data[row.atoms + ATOM * i :]
        a, b = atom[0] - x, atom[1] - y
        add_line(spread, share=atom[2], a=a, b=b, c=a, d=b, more=0.0)
    for i in range(row.segment_count):
        line = data[row.segments + LINE * i :]
        a, b, c, d = line[0] - x, line[1] - y, line[2] - x, line[3] - y
        add_line(spread, share=line[4], a=a, b=b, c=c, d=d, more=0.0)
    for i in range(row.ring_count):
        add_circle(spread, data[row.rings + CIRCLE * i :], x, y, part=RING_SPREAD)
    for i in range(row.disc_count):
        add_circle(spread, data[row.discs + CIRCLE * i :], x, y, part=DISC_SPREAD)
    for i in range(row.edge_count):
        edge = data[row.edges + LINE * i :]
        a, b, c, d = edge[0] - x, edge[1] - y, edge[2] - x, edge[3] - y
        # Moments of the triangle from the center to the edge, weighted by its share of the pressure.
        add_line(spread, share=edge[4] * (a * d - b * c) / 4.0, a=a, b=b, c=c, d=d, more=0.0)


def add_circle(spread: Numbers, circle: Numbers, x: float, y: float, part: float) -> None:
    """Add a ring or a disc to second moments about (x, y)."""
    a, b = circle[0] - x, circle[1] - y
    more = part * (circle[2] * circle[2])
    add_line(spread, share=circle[3], a=a, b=b, c=a, d=b, more=more)


def add_line(
    spread: Numbers, share: float, a: float, b: float, c: float, d: float, more: float
) -> None:
    """Add a uniform line from (a, b) to (c, d) to second moments; `more` is that of its width."""
    xx, yy = (a * a + a * c + c * c) / 3.0, (b * b + b * d + d * d) / 3.0
    xy = (2.0 * a * b + a * d + b * c + 2.0 * c * d) / 6.0
    spread[0] += share * (xx + more)
    spread[1] += share * xy
    spread[2] += share * (yy + more)


def store_reach(data: Numbers, row: MeasureRow, measured: Numbers, reach: Numbers) -> None:
    """Store the vectors from the center of pressure to the extreme points of a support."""
    x, y = measured[0], measured[1]
    for i in range(row.atom_count):
        k = row.atoms + ATOM * i
        store_vector(reach, data[k] - x, data[k + 1] - y, 0.0)
        reach = reach[REACH:]
    for i in range(row.segment_count):
        store_ends(reach, data[row.segments + LINE * i :], x, y)
        reach = reach[2 * REACH :]
    for i in range(row.ring_count):
        k = row.rings + CIRCLE * i
        store_vector(reach, data[k] - x, data[k + 1] - y, data[k + 2])
        reach = reach[REACH:]
    for i in range(row.disc_count):
        k = row.discs + CIRCLE * i
        store_vector(reach, data[k] - x, data[k + 1] - y, data[k + 2])
        reach = reach[REACH:]
    for i in range(row.edge_count):
        store_ends(reach, data[row.edges + LINE * i :], x, y)
        reach = reach[2 * REACH :]


def store_ends(reach: Numbers, line: Numbers, x: float, y: float) -> None:
    """Store the vectors from (x, y) to both ends of a line."""
    store_vector(reach, line[0] - x, line[1] - y, 0.0)
    store_vector(reach[REACH:], line[2] - x, line[3] - y, 0.0)


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
        head, unit = results[row.head :], row.unit
        for j in range(HEAD):
            head[j] = 0.0
        head[CENTER], head[CENTER + 1] = row.center_x / unit, row.center_y / unit
        square = unit * unit
        head[SPREAD], head[SPREAD + 1] = row.xx / square, row.xy / square
        head[SPREAD + 2] = row.yy / square
        k = row.first
        head[ATOMS] = float(k)
        k = store_atoms(data, row, results, k)
        head[SEGMENTS] = float(k)
        for j in range(row.segment_count):
            line = data[row.segments + LINE * j :]
            store_line(results[k:], line, 0.0, 0.0, unit, share=line[4])
            k += COLUMNS
        head[RINGS] = float(k)
        k = store_circles(data[row.rings :], row.ring_count, unit, results, k)
        head[DISCS] = float(k)
        k = store_circles(data[row.discs :], row.disc_count, unit, results, k)
        head[PLATES] = float(k)
        head[EDGES] = float(k + COLUMNS * row.plate_count)
        store_plates(data, row, results, k)
        head[SERIES], head[END] = float(row.series), float(row.end)


def store_atoms(data: Numbers, row: PressureRow, results: Numbers, k: int) -> int:
    """Store the atoms of a support; the place after them is returned."""
    extent = row.extent / row.unit
    for i in range(row.atom_count):
        atom, stored = data[row.atoms + ATOM * i :], results[k:]
        x, y = atom[0] / row.unit, atom[1] / row.unit
        blur = ATOM_ROUNDING * (extent + (fabs(x) + fabs(y)))
        stored[0], stored[1], stored[2], stored[3] = x, y, atom[2], blur * blur
        stored[4], stored[5] = 0.0, 0.0
        k += COLUMNS
    return k


def store_circles(circles: Numbers, count: int, unit: float, results: Numbers, k: int) -> int:
    """Store rings or discs; the place after them is returned."""
    for i in range(count):
        circle, stored = circles[CIRCLE * i :], results[k:]
        stored[0], stored[1] = circle[0] / unit, circle[1] / unit
        stored[2], stored[3], stored[4], stored[5] = circle[2] / unit, circle[3], 0.0, 0.0
        k += COLUMNS
    return k


def store_plates(data: Numbers, row: PressureRow, results: Numbers, k: int) -> None:
    """Store the plates of a support, and their edges behind all of them."""
    unit, begin, edges = row.unit, k + COLUMNS * row.plate_count, row.edges
    for i in range(row.plate_count):
        plate, stored = data[row.plates + PLATE * i :], results[k:]
        length, end = int(plate[4]), begin
        for j in range(length):
            edge = data[edges + LINE * j :]
            jump = edge[4] * (unit * unit) / plate[3]
            store_line(results[end:], edge, plate[0], plate[1], unit, share=jump)
            end += COLUMNS
        stored[0], stored[1], stored[2] = plate[0] / unit, plate[1] / unit, plate[2] / unit
        stored[3], stored[4], stored[5] = plate[3], float(begin), float(end)
        begin, edges = end, edges + LINE * length
        k += COLUMNS


def store_line(
    stored: Numbers, line: Numbers, x: float, y: float, unit: float, share: float
) -> None:
    """Store the midpoint of a line from (x, y), the vector along it, and its share or jump."""
    start_x, start_y = (line[0] - x) / unit, (line[1] - y) / unit
    end_x, end_y = (line[2] - x) / unit, (line[3] - y) / unit
    stored[0], stored[1] = (start_x + end_x) / 2.0, (start_y + end_y) / 2.0
    stored[2], stored[3] = end_x - start_x, end_y - start_y
    stored[4], stored[5] = 0.0, share
