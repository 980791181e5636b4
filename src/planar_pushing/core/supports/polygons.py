"""Areas of polygons, and edges that cross or touch.

`data` holds x and y of the vertices of all polygons, one vertex after the other. A row identifies a polygon
by the index of its first vertex and by its number of vertices.
"""

from __future__ import annotations

from planar_pushing.core.numbers import Numbers


def polygon_area(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """Areas of polygons, positive if counterclockwise; accurate even far from the origin."""
    for i in range(count):
        row = rows[i * columns :]
        results[i * width] = area_of(data[2 * int(row[0]) :], int(row[1]))


def crossing_edges(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """Numbers of the first two edges that meet anywhere but at a common vertex, or -1 twice."""
    for i in range(count):
        row = rows[i * columns :]
        one, other = find_crossing(data[2 * int(row[0]) :], int(row[1]))
        results[i * width], results[i * width + 1] = float(one), float(other)


def touching_edges(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """Numbers of an edge of one polygon and one of another that have a point in common, or -1 twice."""
    for i in range(count):
        row = rows[i * columns :]
        vertices, others = data[2 * int(row[0]) :], data[2 * int(row[2]) :]
        one, other = find_touching(vertices, int(row[1]), others, int(row[3]))
        results[i * width], results[i * width + 1] = float(one), float(other)


def area_of(vertices: Numbers, count: int) -> float:
    """Area of a polygon, as a sum over triangles at its first vertex."""
    total, corner_x, corner_y = 0.0, vertices[0], vertices[1]
    for i in range(1, count - 1):
        x, y = vertices[2 * i] - corner_x, vertices[2 * i + 1] - corner_y
        next_x, next_y = vertices[2 * i + 2] - corner_x, vertices[2 * i + 3] - corner_y
        total += x * next_y - y * next_x
    return total / 2.0


def find_crossing(vertices: Numbers, count: int) -> tuple[int, int]:
    """Numbers of two edges of a polygon that meet anywhere but at a common vertex, or -1."""
    meets: bool
    for i in range(count - 1):
        start, end = vertices[2 * i :], vertices[2 * i + 2 :]
        for j in range(i + 1, count):
            k = j + 1 if j + 1 < count else 0
            corner, last = vertices[2 * j :], vertices[2 * k :]
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
        start, end = vertices[2 * i :], vertices[2 * k :]
        for j in range(other_count):
            k = j + 1 if j + 1 < other_count else 0
            if edges_meet(start, end, others[2 * j :], others[2 * k :]):
                return i, j
    return -1, -1


def edges_meet(start: Numbers, end: Numbers, first: Numbers, last: Numbers) -> bool:
    """Whether two edges have a point in common."""
    splits: bool
    for k in range(2):
        if min(first[k], last[k]) > max(start[k], end[k]):
            return False
        if max(first[k], last[k]) < min(start[k], end[k]):
            return False
    splits = side_of(start, end, first) * side_of(start, end, last) <= 0.0
    return splits and side_of(first, last, start) * side_of(first, last, end) <= 0.0


def side_of(start: Numbers, end: Numbers, point: Numbers) -> float:
    """Side of a line on which a point lies: 1 on the left, -1 on the right, 0 on the line."""
    along, across = end[0] - start[0], end[1] - start[1]
    left = along * (point[1] - start[1]) - across * (point[0] - start[0])
    if left > 0.0:
        return 1.0
    return -1.0 if left < 0.0 else 0.0


def edge_folds(first: Numbers, corner: Numbers, last: Numbers) -> bool:
    """Whether an edge runs back along the one before it, or has no length."""
    one_x, one_y = corner[0] - first[0], corner[1] - first[1]
    other_x, other_y = last[0] - corner[0], last[1] - corner[1]
    turn = one_x * other_y - one_y * other_x
    return turn == 0.0 and one_x * other_x + one_y * other_y <= 0.0
