"""A uniform line of pressure: the edge of a tilted box, a blade."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from planar_pushing.mechanics.compiled import compiled, inlined
from planar_pushing.mechanics.frames import Frame, moved_place
from planar_pushing.mechanics.pictures import Pictured
from planar_pushing.mechanics.supports.base import Position, position, require_size
from planar_pushing.mechanics.supports.pressure.assembly import center, extent
from planar_pushing.mechanics.supports.pressure.edges import (
    LEAST,
    ends,
    mean_distance,
    mean_inverse,
)
from planar_pushing.mechanics.supports.pressure.record import RINGS, SEGMENTS, Pieces
from planar_pushing.mechanics.supports.pressure.sums import added
from planar_pushing.mechanics.supports.ring import polynomial
from planar_pushing.terms.errors import InvalidValue

#: Below this ratio of the length to the sum of the distances of the ends, the torque is a power series.
SHORT = 0.1
#: ``(z / (1 - z^2) - atanh z) / z^3`` in powers of z^2, to 1e-17 below SHORT.
TORQUE = tuple((2 * k + 2) / (2 * k + 3) for k in range(9))


@dataclass(frozen=True, slots=True)
class Segment(Pictured):
    """Support on a straight line, with uniform pressure.

    Parameters
    ----------
    start, end : pair of float
        Ends in the body frame.

    Raises
    ------
    InvalidValue
        If an end is not a pair of finite numbers, or both ends coincide.
    """

    start: Any
    end: Any

    def __post_init__(self) -> None:
        for name in ("start", "end"):
            object.__setattr__(self, name, position(name, getattr(self, name)))
        if self.start == self.end:
            raise InvalidValue(
                "end", self.end, "a position other than the start",
                "use Points for a support on one point",
            )  # fmt: skip
        require_size("end", math.dist(self.start, self.end))

    @property
    def center_of_pressure(self) -> Position:
        return center(self.pieces())

    @property
    def extent(self) -> float:
        return extent(self.pieces())

    def moved(self, frame: Frame) -> Segment:
        """The same line expressed in another frame."""
        return Segment(moved_place(self.start, frame), moved_place(self.end, frame))

    def pieces(self) -> Pieces:
        return Pieces(segments=np.array([[*self.start, *self.end, 1.0]]))


@inlined
def of_segments(total, pressure, x, y):
    """Add the segments to the totals, whose torque is about p."""
    rows, p_x, p_y = pressure.rows, pressure.center_x, pressure.center_y
    for i in range(pressure.starts[SEGMENTS], pressure.starts[RINGS]):
        q_x, q_y, t_x = rows[i, 0], rows[i, 1], rows[i, 2]
        t_y, half, share = rows[i, 3], rows[i, 4], rows[i, 5]
        r_x, r_y = q_x - x, q_y - y
        local = segment(r_x * t_x + r_y * t_y, r_x * t_y - r_y * t_x, half)
        total = added(total, share, _placed(local, t_x, t_y), q_x - p_x, q_y - p_y)
    return total


@compiled
def segment(s, h, half):
    """The piece of a segment with its midpoint at (s, h), in coordinates along and across it."""
    one, other = ends(s, h, half)
    both = one + other
    inverse = mean_inverse(s, h, half, one, other)
    distance, torque = mean_distance(s, h, both, inverse), _torque(s, h, half, both, inverse)
    product = max(one * other, LEAST)
    tt, tn = _bend(abs(s), h, half, one, other) / product, -2.0 * (s / both) * h / product
    return distance, 2.0 * (s / both), h * inverse, torque, tt, tn, inverse - tt


@compiled
def _torque(s, h, half, both, inverse):
    """``h^2 (z / (1 - z^2) - atanh z) / l`` with z = l / (rho1 + rho2), about the midpoint."""
    z, x = 2.0 * half / both, abs(s)
    if z < SHORT:
        return h * (h / both) * (z * z) * polynomial(TORQUE, z * z)
    return (both / 2.0 - x) * (both / 2.0 + x) / both - h * h * inverse / 2.0


@compiled
def _bend(s, h, half, one, other):
    """``(s2 rho1 - s1 rho2) / l`` of the ends, without cancellation; s >= 0."""
    before, after = s - half, s + half
    near, far = min(one, other), max(one, other)
    if before > 0.0:
        return 2.0 * s * h * h / (after * near + before * far)
    return (after * near - before * far) / (2.0 * half)


@compiled
def _placed(local, t_x, t_y):
    """Rotate a piece from the axes of a segment to those of the body; the normal is (t_y, -t_x)."""
    distance, t, n, torque, tt, tn, nn = local
    xx = tt * t_x * t_x + 2.0 * tn * t_x * t_y + nn * t_y * t_y
    xy = (tt - nn) * t_x * t_y + tn * (t_y * t_y - t_x * t_x)
    yy = tt * t_y * t_y - 2.0 * tn * t_x * t_y + nn * t_x * t_x
    return distance, t * t_x + n * t_y, t * t_y - n * t_x, torque, xx, xy, yy
