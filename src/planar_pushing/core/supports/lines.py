"""Means over uniform straight lines, for any center of rotation: segments, and the edges of plates.

A plate is an area with uniform pressure between straight edges: a polygon, or cells of a pressure map. By
the divergence theorem, the means over the area are sums over the edges of the mean distance along each edge
times the jump of the pressure across it (manual: theory, any support).
"""

from __future__ import annotations

from math import fabs, log, sqrt

from planar_pushing.core.numbers import Numbers
from planar_pushing.core.supports.piece_rows import COLUMNS, LineRow
from planar_pushing.core.supports.ring import polynomial
from planar_pushing.core.supports.sums import Piece

#: Smallest product of distances, used on the line itself, where second derivatives are infinite.
SMALLEST_PRODUCT = 1e-300
#: Below this ratio of the length to the sum of the distances of the ends, the torque is a power series.
SHORT_LINE = 0.1
#: ``(z / (1 - z^2) - atanh z) / z^3`` in powers of z^2, to 1e-17 below SHORT_LINE: (2 k + 2) / (2 k + 3).
LINE_TORQUE = (
    0.6666666666666666, 0.8, 0.8571428571428571, 0.8888888888888888, 0.9090909090909091,
    0.9230769230769231, 0.9333333333333333, 0.9411764705882353, 0.9473684210526315,
)  # fmt: skip


def distance_to_end(s: float, h: float) -> float:
    """Distance to a line's end at (s, h), in coordinates along and across the line."""
    return sqrt(s * s + h * h)


def mean_inverse(s: float, h: float, half: float, one: float, other: float) -> float:
    """Mean of 1 / rho, ``L / l``, from the distances of the ends."""
    excess = excess_distance(s=fabs(s), h=h, half=half, near=min(one, other), far=max(one, other))
    return log_of_one_plus(4.0 * half / max(excess, SMALLEST_PRODUCT)) / (2.0 * half)


def log_of_one_plus(x: float) -> float:
    """``log(1 + x)``, x >= 0, to 3e-16 by Kahan's formula, in half the time of the library function."""
    above = 1.0 + x
    return log(above) * (x / (above - 1.0)) if above > 1.0 else x


def excess_distance(s: float, h: float, half: float, near: float, far: float) -> float:
    """Distances of both ends minus the length, ``rho1 + rho2 - l``, without cancellation; s >= 0."""
    square, before, after = h * h, s - half, s + half
    beyond = near + before if before >= 0.0 else square / (near - before)
    return beyond + square / (far + after)


def mean_distance(s: float, h: float, both: float, inverse: float) -> float:
    """Mean of rho, ``I / l``, from the sum of the distances of the ends and the mean of 1 / rho."""
    return both / 4.0 + s * (s / both) + h * h * inverse / 2.0


def segment_piece(s: float, h: float, half: float) -> Piece:
    """The piece of a segment with its midpoint at (s, h), in coordinates along and across it."""
    one, other = distance_to_end(s - half, h), distance_to_end(s + half, h)
    both = one + other
    inverse = mean_inverse(s, h, half, one, other)
    distance, torque = mean_distance(s, h, both, inverse), line_torque(s, h, half, both, inverse)
    product = max(one * other, SMALLEST_PRODUCT)
    tt, tn = line_bend(fabs(s), h, half, one, other) / product, -2.0 * (s / both) * h / product
    return Piece(
        distance,
        unit_x=2.0 * (s / both),
        unit_y=h * inverse,
        torque=torque,
        xx=tt,
        xy=tn,
        yy=inverse - tt,
    )


def line_torque(s: float, h: float, half: float, both: float, inverse: float) -> float:
    """``h^2 (z / (1 - z^2) - atanh z) / l`` with z = l / (rho1 + rho2), about the midpoint."""
    z, x = 2.0 * half / both, fabs(s)
    if z < SHORT_LINE:
        series = polynomial(LINE_TORQUE, len(LINE_TORQUE), z * z)
        return h * (h / both) * (z * z) * series
    return (both / 2.0 - x) * (both / 2.0 + x) / both - h * h * inverse / 2.0


def line_bend(s: float, h: float, half: float, one: float, other: float) -> float:
    """``(s2 rho1 - s1 rho2) / l`` of the ends, without cancellation; s >= 0."""
    before, after = s - half, s + half
    near, far = min(one, other), max(one, other)
    if before > 0.0:
        return 2.0 * s * h * h / (after * near + before * far)
    return (after * near - before * far) / (2.0 * half)


def turn_piece(piece: Piece, t_x: float, t_y: float) -> Piece:
    """Rotate a piece from the axes of a segment to those of the body; the normal is (t_y, -t_x)."""
    t, n, tt, tn, nn = piece.unit_x, piece.unit_y, piece.xx, piece.xy, piece.yy
    xx = tt * t_x * t_x + 2.0 * tn * t_x * t_y + nn * t_y * t_y
    xy = (tt - nn) * t_x * t_y + tn * (t_y * t_y - t_x * t_x)
    yy = tt * t_y * t_y - 2.0 * tn * t_x * t_y + nn * t_x * t_x
    unit_x, unit_y = t * t_x + n * t_y, t * t_y - n * t_x
    return Piece(piece.distance, unit_x, unit_y, piece.torque, xx, xy, yy)


def plate_piece(data: Numbers, first: int, last: int, x: float, y: float) -> Piece:
    """The piece of a plate with edges from `first` to `last`; (x, y) is relative to the plate's center.

    Far from the plate these sums lose digits to cancellation, and multipoles are used instead.
    """
    distance, g_x, g_y, xx, xy, yy = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    i = first
    while i < last:
        line = LineRow(data[i:])
        t_x, t_y, half = line.t_x, line.t_y, line.half
        r_x, r_y, weight = line.x - x, line.y - y, 2.0 * half * line.share
        s, h = r_x * t_x + r_y * t_y, r_x * t_y - r_y * t_x
        one, other = distance_to_end(s - half, h), distance_to_end(s + half, h)
        both, inverse = one + other, mean_inverse(s, h, half, one, other)
        mean, along, across = mean_distance(s, h, both, inverse), 2.0 * (s / both), h * inverse
        distance += weight * h * mean / 3.0
        g_x += weight * mean * t_y
        g_y -= weight * mean * t_x
        xx += weight * t_y * (across * t_y + along * t_x)
        xy += weight * t_y * (along * t_y - across * t_x)
        yy += weight * t_x * (across * t_x - along * t_y)
        i += COLUMNS
    return Piece(
        distance, unit_x=g_x, unit_y=g_y, torque=distance + (x * g_x + y * g_y), xx=xx, xy=xy, yy=yy
    )
