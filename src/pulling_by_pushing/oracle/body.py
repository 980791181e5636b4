"""The wrench that sustains a motion: gradient of the effects' potential, and its Hessian.

A motion is ``q = (u_x, u_y, omega)``, the velocity (or acceleration from rest) of the contact and the
rotation. The wrench is the force, and the torque about the contact.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from flint import arb, fmpq

from pulling_by_pushing.oracle.balls import ZERO, Position, Undecided, Vector, cross, dot, remember
from pulling_by_pushing.oracle.support import Support

ORIGIN: Position = (ZERO, ZERO)
Row = list[arb]
Matrix = list[Row]


class Wrench(NamedTuple):
    """Force and torque about the contact, their Jacobian, and the magnitudes of their terms."""

    value: Row
    jacobian: Matrix
    size: Row


@dataclass(frozen=True, kw_only=True, eq=False)
class Body:
    """Effects that resist the motion.

    Attributes
    ----------
    length : fmpq
        The contact is at (-length, 0).
    support : Support or None
    weight : fmpq or arb
        Friction force of the support in a translation; 0 without friction.
    mass : fmpq or arb
    gyration : fmpq
        Square of the radius of gyration.
    mass_center : tuple of fmpq
    viscous : fmpq
        Viscous friction force of the support per velocity in a translation.
    load : tuple
        A force, and its torque about the contact, that act on the slider.
    """

    length: fmpq
    support: Support | None = None
    weight: fmpq | arb = ZERO
    mass: fmpq | arb = ZERO
    gyration: fmpq = ZERO
    mass_center: Position = ORIGIN
    viscous: fmpq = ZERO
    load: tuple[fmpq | arb, ...] = (ZERO, ZERO, ZERO)

    @cached_property
    def pressure(self) -> Position:
        """Center of pressure relative to the contact."""
        assert self.support is not None
        return self.support.center[0] + self.length, self.support.center[1]

    @cached_property
    def second_moments(self) -> tuple[fmpq, fmpq, fmpq]:
        """Second moments xx, xy, yy of the pressure about the contact."""
        assert self.support is not None
        (x, y), (xx, xy, yy), length = self.support.center, self.support.second, self.length
        return xx + 2 * length * x + length * length, xy + length * y, yy

    @property
    @remember(1 << 10)
    def lever(self) -> arb:
        """Root mean square distance of the pressure from the contact."""
        return arb(self.second_moments[0] + self.second_moments[2]).sqrt()

    @property
    @remember(1 << 10)
    def matrix(self) -> Matrix:
        """The part of the wrench that is linear in the motion: inertia, or viscous friction."""
        x, y = self.mass_center[0] + self.length, self.mass_center[1]
        inertia = _linear(self.mass, (x, y), self.gyration + x * x + y * y)
        if not self.viscous:
            return inertia
        viscous = _linear(
            self.viscous, self.pressure, self.second_moments[0] + self.second_moments[2]
        )
        return [
            [a + b for a, b in zip(*rows, strict=True)]
            for rows in zip(inertia, viscous, strict=True)
        ]

    def foot(self, index: int) -> Position:
        """A point of the support relative to the contact."""
        assert self.support is not None
        x, y = self.support.points[index].position
        return x + self.length, y

    def share(self, index: int) -> fmpq | arb:
        """Largest friction force of a point of the support."""
        assert self.support is not None
        return self.weight * self.support.points[index].share

    def wrench(self, q: Sequence[arb], skip: int = -1) -> Wrench:
        """The wrench of a motion, without the friction of the point with the index `skip`.

        Raises
        ------
        Undecided
            If the motion is a ball around a point of the support, or around rest.
        """
        value = [dot(row, q) - load for row, load in zip(self.matrix, self.load, strict=True)]
        jacobian = self.matrix
        size = [
            dot(map(abs, row), map(abs, q)) + abs(arb(load))
            for row, load in zip(self.matrix, self.load, strict=True)
        ]
        if self.weight != 0:
            force, slope = (
                self._straight(q) if q[2].contains(0) else self._derivatives_in_rotation(q, skip)
            )
            value = [a + self.weight * b for a, b in zip(value, force, strict=True)]
            jacobian = [
                [a + self.weight * b for a, b in zip(*rows, strict=True)]
                for rows in zip(jacobian, slope, strict=True)
            ]
            levers = arb(1), arb(1), self.lever
            size = [a + self.weight * b for a, b in zip(size, levers, strict=True)]
        return Wrench(value, jacobian, size)

    def _derivatives_in_rotation(self, q: Sequence[arb], skip: int) -> tuple[Row, Matrix]:
        """Gradient and Hessian of ``|omega| D(c)``, where c is J u / omega from the contact."""
        assert self.support is not None
        x, y, omega = -q[1] / q[2], q[0] / q[2], q[2]
        distance, gx, gy, xx, xy, yy = self.support.dgh((x - self.length, y), skip)
        px, py, side, speed = xx * x + xy * y, xy * x + yy * y, omega.sgn(), abs(omega)
        force = [side * gy, -side * gx, side * (distance - x * gx - y * gy)]
        slope = [[yy, -xy, -py], [-xy, xx, px], [-py, px, x * px + y * py]]
        return force, [[part / speed for part in row] for row in slope]

    def _straight(self, q: Sequence[arb]) -> tuple[Row, Matrix]:
        """The same near a translation: moments of the pressure, and a bound on the change of directions."""
        assert self.support is not None
        speed = (q[0] * q[0] + q[1] * q[1]).sqrt()
        ex, ey, omega = q[0] / speed, q[1] / speed, q[2]
        (x, y), (xx, xy, yy) = self.pressure, self.second_moments
        reach = self.support.extent + arb(x * x + y * y).sqrt()
        turn = 2 * abs(omega) * reach / speed
        if not turn < 0.1:
            raise Undecided("a motion next to rest")
        change = arb(0, (4 * turn).upper())
        across, square = ex * x + ey * y, ex * ex * xx + 2 * ex * ey * xy + ey * ey * yy
        slope = [
            [ey * ey, -ex * ey, -ey * across],
            [-ex * ey, ex * ex, ex * across],
            [-ey * across, ex * across, square],
        ]
        size = [arb(1), arb(1), reach]
        slope = [
            [(slope[i][k] + size[i] * size[k] * change) / speed for k in range(3)] for i in range(3)
        ]
        force = [ex, ey, x * ey - y * ex]
        if not omega.is_zero():  # the mean value theorem
            force = [a + row[2] * omega for a, row in zip(force, slope, strict=True)]
        return force, slope


def _linear(mass: fmpq | arb, center: tuple[fmpq, fmpq], second: fmpq) -> Matrix:
    """Inertia of a mass about the contact; `second` is its mean square distance."""
    x, y = center
    rows = ((fmpq(1), ZERO, -y), (ZERO, fmpq(1), x), (-y, x, second))
    return [[arb(mass * part) for part in row] for row in rows]


def holding_force(wrench: Row, e: Vector, r: Position) -> Vector:
    """The force at r from the contact with which the whole force is along e, without torque."""
    f_x, f_y, moment = wrench
    bent, lever = cross(e, (f_x, f_y)), cross(e, r)
    return (moment * e[0] - r[0] * bent) / lever, (moment * e[1] - r[1] * bent) / lever
