"""Sticking motions about a point of the support, and the forces that it leaves open."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from flint import arb

from planar_pushing.certified.supports.pressure.moments import Vector, moments
from planar_pushing.evidence.golden.residual.finding import DEGREE, EPSILON
from planar_pushing.evidence.golden.residual.sliders.gallery import OPEN, Rod
from planar_pushing.evidence.golden.residual.sliders.table import Tables, turned

#: Roundings of a direction within which a motion is about a point, and beyond which it is not.
SAME, OTHER = 4 * EPSILON, 64 * EPSILON
#: Roundings of a force and of a rotation.
FORCE, SPIN = 64, 8


class Pivot(NamedTuple):
    """A motion about a point of the support, body frame.

    Attributes
    ----------
    number : int
        Of the point, -1 where the motion is about none.
    open : bool
        Whether rounding leaves it open that the motion is about the point.
    spin : float
        Rotation times the extent.
    force, free : tuple of float
        Middle of the forces, and half of what is open.
    angle : float
        Of the rod, degrees.
    """

    number: int = -1
    open: bool = False
    spin: float = 0.0
    force: tuple[float, float] = (0.0, 0.0)
    free: tuple[float, float] = (0.0, 0.0)
    angle: float = 0.0

    def allows(self, stored: int) -> bool:
        """Whether a stored number may be."""
        return stored == self.number or (stored == -1 and self.open)

    def check(self, tables: Tables, place: tuple[int, ...], friction: float) -> None:
        """Check the rotation, and the ends of the forces that the law transmits."""
        values = {name: float(each[place]) for name, each in tables.values.items()}
        error = abs(values["spin"] - self.spin)
        tables.put("spin", place, error, SPIN * EPSILON * (1 + abs(self.spin)))
        for name, part in zip(
            ("force_angle", "force_angle_end"), self._ends(friction), strict=True
        ):
            x, y = (f + part * e for f, e in zip(self.force, self.free, strict=True))
            wanted = np.arctan2(y, x) * DEGREE + self.angle
            rounding = FORCE * EPSILON * (1 + np.hypot(*self.free)) / np.hypot(x, y)
            tables.put(name, place, turned(values[name], wanted), rounding * DEGREE)

    def _ends(self, friction: float) -> tuple[float, float]:
        """Parts of the open interval, from -1 to 1, between the edges of the friction cone."""
        low, high, half = -1.0, 1.0, np.pi / 2 if np.isinf(friction) else np.arctan(friction)
        for side in (1, -1):
            turn = np.pi / 2 - side * half - np.deg2rad(self.angle)
            depth, change = (
                side * (np.cos(turn) * y - np.sin(turn) * x) for x, y in (self.force, self.free)
            )
            if change > 0:
                low = max(low, -depth / change)
            elif change < 0:
                high = min(high, -depth / change)
        return low, high


def pivot(rod: Rod, motion: Vector) -> Pivot:
    """The pivot of a contact that moves by a unit vector in the body frame."""
    for number, point in enumerate(rod.support.points):
        x, y = arb(point.place[0] + rod.length), arb(point.place[1])
        reach = (x * x + y * y).sqrt()
        off = abs(float((motion[0] * x + motion[1] * y) / reach)) if not reach.is_zero() else 1.0
        if off > OTHER:
            continue
        found = _about(rod, number, motion, (x / reach, y / reach), reach)
        if found is not None:
            return found._replace(open=found.open or off > SAME)
    return Pivot()


def _about(rod: Rod, number: int, motion: Vector, along: Vector, reach: arb) -> Pivot | None:
    point = rod.support.points[number]
    c = arb(point.place[0]), arb(point.place[1])
    sense = 1 if motion[0] * along[1] - motion[1] * along[0] > 0 else -1
    rest = moments(rod.support, c)
    part = -sense * rest.torque(c, (-rod.length, 0 * rod.length)) / reach
    over = float(part * part / point.share**2) - 1
    if over > OPEN:
        return None
    f_x, f_y = -sense * rest.y - part * along[1], sense * rest.x + part * along[0]
    free = float(arb.max(point.share**2 - part * part, arb(0)).sqrt())
    return Pivot(
        number,
        abs(over) <= OPEN,
        float(sense * rod.support.extent / reach),
        (float(f_x), float(f_y)),
        (free * float(along[0]), free * float(along[1])),
        float(rod.angle),
    )
