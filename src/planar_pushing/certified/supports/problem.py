"""What Newton's method solves: the motion of least potential under a line of force.

The contact moves by ``u = t + a n``, n to the left of the force's direction t, and the slider turns by
omega about ``c = P + J u / omega``; its potential is ``|omega| D(c)``.
"""

from __future__ import annotations

from typing import NamedTuple

from flint import arb, fmpq

from planar_pushing.certified.supports.pressure.moments import Moments, Vector, moments
from planar_pushing.certified.supports.pressure.pieces import Pieces

#: By rows.
Matrix = tuple[arb, arb, arb, arb]


class Motion(NamedTuple):
    """A motion of the contact with unit part along the force: its part across, and the rotation."""

    across: arb
    spin: arb

    def after(self, step: Motion, part: arb) -> Motion:
        """The motion after a part of a step, without a radius."""
        across, spin = self.across + part * step.across, self.spin + part * step.spin
        return Motion(across.mid(), spin.mid())


class Evaluation(NamedTuple):
    """A motion's centre of rotation, the moments there, and its potential without a radius."""

    center: Vector
    moments: Moments
    power: arb


class Problem(NamedTuple):
    """A support, the rod's length, and the direction of the force."""

    support: Pieces
    length: fmpq
    t: Vector

    def evaluate(self, at: Motion) -> Evaluation:
        """Evaluate the potential of a motion.

        Raises
        ------
        Undecided
            Where the slider does not turn.
        """
        (x, y), (a, spin) = self.t, at
        u_x, u_y = x - a * y, y + a * x
        c = -self.length - u_y / spin, u_x / spin
        now = moments(self.support, c)
        return Evaluation(c, now, (abs(spin) * now.distance).mid())

    def equations(self, now: Moments, c: Vector) -> Vector:
        """Part of G along the force, and torque about the contact of a unit rotation."""
        return now.x * self.t[0] + now.y * self.t[1], now.torque(c, (-self.length, fmpq(0)))

    def slopes(self, now: Moments, c: Vector) -> Matrix:
        """Derivatives of the equations by the centre, with their signs changed."""
        first = product(now, self.t)
        second = product(now, (c[0] + self.length, c[1]))
        return (*first, *second)


def product(now: Moments, v: Vector) -> Vector:
    """Second derivatives times a vector."""
    return now.xx * v[0] + now.xy * v[1], now.xy * v[0] + now.yy * v[1]
