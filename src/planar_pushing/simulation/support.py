"""The effects of degree 1 at one motion at a time, and the twists that they sustain.

Lengths are in units of the slider's radius, motions are ``v`` (centre speed) and ``s = R omega``. Every
such effect has the second derivative ``c (s, -v) (s, -v)^T``, since its potential is of degree 1.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import singledispatch

from planar_pushing.mechanics.effects import RingFriction
from planar_pushing.mechanics.effects.base import IsotropicEffect
from planar_pushing.mechanics.effects.ring_point import ring_point

#: Force along the motion, torque and curvature at (v, s).
Point = Callable[[float, float], tuple[float, float, float]]

#: A Newton step this small, relative to the bracket, leaves an error of its square.
SETTLED = 1e-8
ITERATIONS = 100
TURN = 1e-5


@singledispatch
def point(effect: IsotropicEffect) -> Point:
    """An effect at one motion at a time; any effect of degree 1 through its profile."""

    def wrench(speed: float, spin: float) -> tuple[float, float]:
        ratio = spin / speed if speed > 0 else math.copysign(math.inf, spin)
        force, torque = effect.profile(ratio)
        return float(force), float(torque)

    def at(speed: float, spin: float) -> tuple[float, float, float]:
        angle, size = math.atan2(spin, speed), math.hypot(speed, spin)
        low, high = max(angle - TURN, -math.pi / 2), min(angle + TURN, math.pi / 2)
        (f1, t1), (f2, t2) = (wrench(math.cos(a), math.sin(a)) for a in (low, high))
        bend = (math.cos(angle) * (t2 - t1) - math.sin(angle) * (f2 - f1)) / (high - low)
        return *wrench(speed, spin), bend / size**3

    return at


@point.register
def _(effect: RingFriction) -> Point:
    """Fast path of the ring."""
    weight = effect.weight

    def at(speed: float, spin: float) -> tuple[float, float, float]:
        force, torque, curvature = ring_point(speed, spin)
        return weight * force, weight * torque, weight * curvature

    return at


class Support:
    """Friction on the support at one motion at a time, and how often it was evaluated.

    Parameters
    ----------
    effects : sequence of effects of degree 1, lengths scaled by the radius
    """

    __slots__ = ("evaluations", "points")

    def __init__(self, effects: Sequence[IsotropicEffect]) -> None:
        self.points = tuple(point(effect) for effect in effects)
        self.evaluations = 0

    def at(self, speed: float, spin: float) -> tuple[float, float, float]:
        """Force along the motion, torque and curvature at a motion that is not rest."""
        self.evaluations += 1
        if len(self.points) == 1:
            return self.points[0](speed, spin)
        parts = [each(speed, spin) for each in self.points]
        force, torque, curvature = (math.fsum(part) for part in zip(*parts, strict=True))
        return force, torque, curvature

    def powers(self, speed: float, spin: float) -> tuple[float, ...]:
        """Power that each effect dissipates; of degree 1, so it is the potential itself."""
        self.evaluations += 1
        wrenches = (each(speed, spin) for each in self.points)
        return tuple(force * speed + torque * spin for force, torque, _ in wrenches)

    def stick(self, along: float, aside: float, length: float, share: float) -> StickMotion:
        """Twist of least potential whose contact moves by (along, aside) in the rod's axes.

        Parameters
        ----------
        along, aside : float
            The contact's velocity along the rod and along its right-hand normal, not both zero.
        length : float
            Rod length.
        share : float
            Guess of the part of `aside` that the rotation takes, in [0, 1].

        Returns
        -------
        share, spin, force_along, force_aside : float

        Notes
        -----
        The torque about the contact is the slope of a convex potential and increases with the share:
        Newton steps, halved brackets where one leaves. The last step corrects the force through
        the second derivative instead of another evaluation.
        """
        if aside == 0.0 or length < 1e-100:
            speed = math.hypot(along, aside)
            force = self.at(speed, 0.0)[0]
            return 0.0, 0.0, force * along / speed, force * aside / speed
        low, high, lever = 0.0, 1.0, aside / length
        for _ in range(ITERATIONS):
            across, spin = (1.0 - share) * aside, share * lever
            speed = math.sqrt(along * along + across * across)
            if speed == 0.0:
                force, torque, curvature = self.at(0.0, spin)
                return share, spin, 0.0, torque / length
            force, torque, curvature = self.at(speed, spin)
            slant = across / speed
            excess = torque - length * force * slant
            turned = speed + length * slant * spin
            rise = curvature * turned**2 + force * (length * along / speed) ** 2 / speed
            step = -excess / (rise * lever)
            if (excess > 0.0) == (lever > 0.0):
                high = share
            else:
                low = share
            new = share + step
            if abs(step) <= SETTLED * min(new, 1.0 - new):
                return self._corrected(along, aside, length, new, (force, torque, curvature, share))
            share = new if low < new < high else (low + high) / 2
        across, spin = (1.0 - share) * aside, share * lever
        return share, spin, force * along / speed, force * across / speed

    @staticmethod
    def _corrected(
        along: float, aside: float, length: float, share: float, old: tuple[float, ...]
    ) -> StickMotion:
        force, _, curvature, before = old
        across, spin = (1.0 - share) * aside, share * aside / length
        past = (1.0 - before) * aside
        speed, slow = math.hypot(along, across), math.hypot(along, past)
        turn = before * aside / length
        force += curvature * turn * (turn * (speed - slow) - slow * (spin - turn))
        return share, spin, force * along / speed, force * across / speed

    def spin_ratio(self, arm: float, guess: float) -> tuple[float, float]:
        """Motion (v, s) of unit larger part under a force of this moment arm, and its guess.

        Notes
        -----
        Newton on ``T(v, s) = h F(v, s)`` in s / v up to an arm of 1, and in v / s beyond.
        """
        size = abs(arm)
        ratio, low, high = guess, 0.0, math.inf
        for _ in range(ITERATIONS):
            speed, spin = (1.0, ratio) if size <= 1.0 else (ratio, 1.0)
            force, torque, curvature = self.at(speed, spin)
            excess = torque - size * force
            if size <= 1.0:
                step = -excess / (curvature * (1.0 + size * ratio))
            else:
                excess = -excess
                step = -excess / (curvature * (ratio + size))
            if excess > 0.0:
                high = ratio
            else:
                low = ratio
            new = ratio + step
            if abs(step) <= SETTLED * abs(new):
                ratio = new
                break
            inside = low < new < high
            ratio = new if inside else (low + high) / 2 if high < math.inf else 2 * ratio + 1
        return (1.0, math.copysign(ratio, arm)) if size <= 1.0 else (ratio, math.copysign(1.0, arm))


#: Share of the rotation, spin, and the force in the rod's axes.
StickMotion = tuple[float, float, float, float]
