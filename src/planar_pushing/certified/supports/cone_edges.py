"""Edges of the motion cone of a slider with any support, enclosed."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

from flint import arb, fmpq

from planar_pushing.certified.balls import in_degrees, precise, rational
from planar_pushing.certified.supports.moving import Moved, moved
from planar_pushing.certified.supports.pressure.pieces import Pieces
from planar_pushing.certified.supports.push import on_edge


class Edge(NamedTuple):
    """The motion at an edge of a friction cone; angles in degrees.

    Attributes
    ----------
    force_angle : arb
    low, high : arb
        Ends of the angles of the contact's motion, the same but at a corner.
    moved : Moved
    """

    force_angle: arb
    low: arb
    high: arb
    moved: Moved

    @property
    def angle(self) -> arb:
        """Angle of the contact's motion; of a corner the middle."""
        return self.low if self.low is self.high else (self.low + self.high) / 2

    def rotation(self, length: fmpq) -> arb:
        """Rotation while the contact moves by one unit."""
        if self.moved.center is None:
            return arb(0)
        x, y = self.moved.center
        return self.moved.sense / ((x + length) ** 2 + y * y).sqrt()


@lru_cache(maxsize=1 << 15)
@precise
def edge(support: Pieces, length: fmpq, angle: fmpq, friction: float, side: int) -> Edge:
    """The motion at an edge, 1 for the right and -1 for the left one, of a rod at an angle in degrees."""
    found = moved(lambda: on_edge(support, length, angle, friction, side))
    # Of infinite friction exactly along the fence.
    half = arb(90) if math.isinf(friction) else in_degrees(arb(rational(friction)).atan())
    force = 90 - side * half
    if found.pivot >= 0 and not support.points[found.pivot].place[1]:
        exact = _across_rod(
            support.points[found.pivot].place[0] + length, found.sense, angle, force
        )
        return Edge(force, exact, exact, found)
    low, high = (force + turn for turn in found.turns)
    return Edge(force, low, low if found.turns[0] is found.turns[1] else high, found)


def _across_rod(reach: fmpq, sense: int, angle: fmpq, force: arb) -> arb:
    """Angle of a motion about a point on the rod's line, within 90 degrees of the force; exact."""
    degrees = angle - 90 * (sense if reach > 0 else -sense)
    return arb(degrees + 360 * round(float(force - degrees) / 360))
