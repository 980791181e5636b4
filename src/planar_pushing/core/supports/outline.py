"""The slider's outline: its distance from a point, and where a disc on a side meets other points of it."""

from __future__ import annotations

from math import sqrt
from typing import NamedTuple

from planar_pushing.core.numbers import INFINITY, Numbers


class Stretch(NamedTuple):
    """An interval of positions along a side, empty if `low` is greater than `high`."""

    low: float
    high: float


def distance_to_outline(corners: Numbers, count: int, x: float, y: float) -> float:
    """The distance of a point from an outline with `count` corners; negative inside."""
    distance = INFINITY
    inside: bool = False
    start_x, start_y = corners[2 * (count - 1)], corners[2 * (count - 1) + 1]
    for k in range(count):
        end_x, end_y = corners[2 * k], corners[2 * k + 1]
        side_x, side_y = end_x - start_x, end_y - start_y
        d_x, d_y = x - start_x, y - start_y
        part = (d_x * side_x + d_y * side_y) / (side_x * side_x + side_y * side_y)
        part = min(max(part, 0.0), 1.0)
        to_x, to_y = d_x - part * side_x, d_y - part * side_y
        distance = min(distance, sqrt(to_x * to_x + to_y * to_y))
        # The number of sides that a ray along +x crosses is odd inside. It meets a rising side if the point
        # is on its left.
        left: bool = side_x * d_y - side_y * d_x > 0.0
        rises: bool = end_y > start_y
        crosses: bool = (start_y > y) != (end_y > y)
        if crosses and left == rises:
            inside = not inside
        start_x, start_y = end_x, end_y
    return -distance if inside else distance


def free_stretch(
    corners: Numbers, count: int, x: float, y: float, t_x: float, t_y: float,
    radius: float, depth: float, position: float,
) -> Stretch:  # fmt: skip
    """The stretch of a side, about a position, on which a disc meets no other point of the outline.

    Positions are measured from the point (x, y) of the side along its tangent, which is the inward normal
    rotated by -90 degrees. The stretch ends where an overlap has the given depth.
    """
    low, high = -INFINITY, INFINITY
    if radius <= depth:
        return Stretch(low, high)
    d_x, d_y = corners[2 * (count - 1)] - x, corners[2 * (count - 1) + 1] - y
    for k in range(count):
        e_x, e_y = corners[2 * k] - x, corners[2 * k + 1] - y
        meets = _overlap(
            x=t_x * d_x + t_y * d_y,
            y=t_x * d_y - t_y * d_x,
            end_x=t_x * e_x + t_y * e_y,
            end_y=t_x * e_y - t_y * e_x,
            height=-radius,
            radius=radius - depth,
        )
        if meets.low <= meets.high and position < (meets.low + meets.high) / 2.0:
            high = min(high, meets.low)
        elif meets.low <= meets.high:
            low = max(low, meets.high)
        d_x, d_y = e_x, e_y
    return Stretch(low, high)


def _overlap(
    x: float, y: float, end_x: float, end_y: float, height: float, radius: float
) -> Stretch:
    """Smallest and greatest x of the centers at a height at which a disc overlaps a line segment."""
    low, high = INFINITY, -INFINITY
    for i in range(2):
        c_x, c_y = (x if i == 0 else end_x), (y if i == 0 else end_y)
        square = (radius - (c_y - height)) * (radius + (c_y - height))
        if square > 0.0:
            low, high = min(low, c_x - sqrt(square)), max(high, c_x + sqrt(square))
    side_x, side_y = end_x - x, end_y - y
    length = sqrt(side_x * side_x + side_y * side_y)
    side_x, side_y = side_x / length, side_y / length
    if side_y != 0.0:
        for i in range(2):
            reach = -radius if i == 0 else radius
            center = x + ((height - y) * side_x + reach) / side_y
            part = (center - x) * side_x + (height - y) * side_y
            if 0.0 <= part <= length:
                low, high = min(low, center), max(high, center)
    return Stretch(low, high)


def outline_distances(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """The distance of each point from an outline.

    A row holds the point, the number of corners, and their place in the data.
    """
    for i in range(count):
        row = rows[i * columns :]
        results[i * width] = distance_to_outline(data[int(row[3]) :], int(row[2]), row[0], row[1])


def free_stretches(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """The stretch of a side on which each disc meets no other point of an outline.

    A row holds the point of the side, its tangent, radius of the disc, depth and position (`free_stretch`),
    the number of corners, and their place in the data.
    """
    for i in range(count):
        row, result = rows[i * columns :], results[i * width :]
        stretch = free_stretch(
            data[int(row[8]) :],
            int(row[7]),
            x=row[0],
            y=row[1],
            t_x=row[2],
            t_y=row[3],
            radius=row[4],
            depth=row[5],
            position=row[6],
        )
        result[0], result[1] = stretch.low, stretch.high
