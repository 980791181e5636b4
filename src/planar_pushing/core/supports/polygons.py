"""Areas of polygons, and edges that cross or touch.

`data` holds x and y of the vertices of all polygons, one vertex after the other. A row is a `PolygonRow`.
"""

from __future__ import annotations

from planar_pushing.core._record import Record
from planar_pushing.core.numbers import Numbers


class PolygonRow(Record):
    """A polygon: index of its first vertex, and number of vertices."""

    first: int
    count: int


class PolygonPair(PolygonRow):
    """Two polygons."""

    other_first: int
    other_count: int


class EdgePair(Record):
    """Numbers of two edges, or -1 twice."""

    one: int
    other: int


class Vertex(Record):
    """A vertex of a polygon."""

    x: float
    y: float


def polygon_area(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """Areas of polygons, positive if counterclockwise; accurate even far from the origin."""
    for i in range(count):
        row = PolygonRow(rows[i * columns :])
        results[i * width] = area_of(data[2 * row.first :], row.count)


def crossing_edges(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """Numbers of the first two edges that meet anywhere but at a common vertex, or -1 twice."""
    for i in range(count):
        row, result = PolygonRow(rows[i * columns :]), EdgePair(results[i * width :])
        result.one, result.other = find_crossing(data[2 * row.first :], row.count)


def touching_edges(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """Numbers of an edge of one polygon and one of another that have a point in common, or -1 twice."""
    for i in range(count):
        row, result = PolygonPair(rows[i * columns :]), EdgePair(results[i * width :])
        vertices, others = data[2 * row.first :], data[2 * row.other_first :]
        result.one, result.other = find_touching(vertices, row.count, others, row.other_count)


def area_of(vertices: Numbers, count: int) -> float:
    """Area of a polygon, as a sum over triangles at its first vertex."""
    total, corner = 0.0, Vertex(vertices)
    for i in range(1, count - 1):
        here, there = Vertex(vertices[2 * i :]), Vertex(vertices[2 * i + 2 :])
        x, y = here.x - corner.x, here.y - corner.y
        next_x, next_y = there.x - corner.x, there.y - corner.y
        total += x * next_y - y * next_x
    return total / 2.0


def find_crossing(vertices: Numbers, count: int) -> tuple[int, int]:
    """Numbers of two edges of a polygon that meet anywhere but at a common vertex, or -1."""
    meets: bool
    for i in range(count - 1):
        start, end = Vertex(vertices[2 * i :]), Vertex(vertices[2 * i + 2 :])
        for j in range(i + 1, count):
            k = j + 1 if j + 1 < count else 0
            corner, last = Vertex(vertices[2 * j :]), Vertex(vertices[2 * k :])
            # The first and the last edge also have a common vertex.
            if j == i + 1:
                meets = edge_folds(start, corner, last)
            elif i == 0 and j == count - 1:
                meets = edge_folds(corner, last, end)
            else:
                meets = edges_meet(start, end, corner, last)
            if meets:
                return i, j
    return -1, -1


def find_touching(
    vertices: Numbers, count: int, others: Numbers, other_count: int
) -> tuple[int, int]:
    """Numbers of an edge of one polygon and one of another that have a point in common, or -1."""
    for i in range(count):
        k = i + 1 if i + 1 < count else 0
        start, end = Vertex(vertices[2 * i :]), Vertex(vertices[2 * k :])
        for j in range(other_count):
            k = j + 1 if j + 1 < other_count else 0
            if edges_meet(start, end, Vertex(others[2 * j :]), Vertex(others[2 * k :])):
                return i, j
    return -1, -1


def edges_meet(start: Vertex, end: Vertex, first: Vertex, last: Vertex) -> bool:
    """Whether two edges have a point in common."""
    splits: bool
    for k in range(2):
        if min(first[k], last[k]) > max(start[k], end[k]):
            return False
        if max(first[k], last[k]) < min(start[k], end[k]):
            return False
    splits = side_of(start, end, first) * side_of(start, end, last) <= 0.0
    return splits and side_of(first, last, start) * side_of(first, last, end) <= 0.0


def side_of(start: Vertex, end: Vertex, point: Vertex) -> float:
    """Side of a line on which a point lies: 1 on the left, -1 on the right, 0 on the line."""
    along, across = end.x - start.x, end.y - start.y
    left = along * (point.y - start.y) - across * (point.x - start.x)
    if left > 0.0:
        return 1.0
    return -1.0 if left < 0.0 else 0.0


def edge_folds(first: Vertex, corner: Vertex, last: Vertex) -> bool:
    """Whether an edge runs back along the one before it, or has no length."""
    one_x, one_y = corner.x - first.x, corner.y - first.y
    other_x, other_y = last.x - corner.x, last.y - corner.y
    turn = one_x * other_y - one_y * other_x
    return turn == 0.0 and one_x * other_x + one_y * other_y <= 0.0
