"""Sticking motions of any support: no torque about the contact, and the force that follows.

A motion is about the center ``c = P + J u / omega``. Its torque about the contact is that about the center
of pressure, which falls with the distance, and that of the force at the center of pressure.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from flint import arb, ctx

from planar_pushing.certified.balls import cosine_sine, rational
from planar_pushing.certified.supports.pressure.moments import Moments, Vector, moments
from planar_pushing.evidence.golden.residual.contact_modes.push import MODES
from planar_pushing.evidence.golden.residual.finding import DEGREE, EPSILON
from planar_pushing.evidence.golden.residual.sliders.gallery import Rod
from planar_pushing.evidence.golden.residual.sliders.pivoting import pivot
from planar_pushing.evidence.golden.residual.sliders.table import Tables, turned

#: Roundings of a balance of torques, and of an angle in radians.
BALANCE, ANGLE = 64, 32
PLACE = MODES.index("STICK")
#: log(1 / EPSILON): next to a line of pressure the force changes by the logarithm of the distance.
ON_LINE = 36.0
#: A slower rotation is about a center so far away that the torque takes more bits.
SLOW, FAR = 1e-6, 640
#: A rotation that moves nothing by a rounding: a translation.
STILL = 1e-30


class Residual:
    """Residual of a motion about no support point.

    Attributes
    ----------
    error, allowed : float
        Of the rotation.
    angle, rounding : float
        Angle of the force in degrees from the rod, and what rounding the rotation explains.
    """

    __slots__ = ("allowed", "angle", "error", "rounding")

    def __init__(self, error: float, allowed: float, angle: float, rounding: float) -> None:
        self.error, self.allowed, self.angle, self.rounding = error, allowed, angle, rounding


class Sticks:
    """Sticking motions of one support on one rod; those of several laws are evaluated once.

    Parameters
    ----------
    rod : Rod
    pushers : array
        Angles of the pusher's motion, degrees.
    """

    def __init__(self, rod: Rod, pushers: Any) -> None:
        self.rod = rod
        self.angles = [float(each) for each in pushers]
        self.motions = [cosine_sine(rational(each) - rod.angle) for each in pushers]
        self.pivots = [pivot(rod, motion) for motion in self.motions]
        self.found: dict[tuple[int, float], Residual] = {}

    def check(self, tables: Tables, at: tuple[int, ...], j: int, friction: float) -> None:
        """Check the values of the stick under one law and one motion of the pusher."""
        place = (*at, j, PLACE)
        moves = turned(tables.values["motion_angle"][place], self.angles[j])
        tables.put("motion_angle", place, moves, ANGLE * EPSILON * DEGREE)
        number, here = tables.pivot[place], self.pivots[j]
        tables.put("pivot", place, 0.0 if here.allows(number) else np.inf, 0.0)
        if number >= 0:
            here.check(tables, place, friction)
        else:
            self._check(tables, place, j)

    def _check(self, tables: Tables, place: tuple[int, ...], j: int) -> None:
        stored = {name: float(values[place]) for name, values in tables.values.items()}
        found = self._residual(j, stored["spin"])
        tables.put("spin", place, found.error, found.allowed)
        angle = found.angle + float(self.rod.angle)
        for name in ("force_angle", "force_angle_end"):
            tables.put(name, place, turned(stored[name], angle), found.rounding * DEGREE)

    def _residual(self, j: int, spin: float) -> Residual:
        if (j, spin) not in self.found:
            with ctx.workprec(FAR if abs(spin) < SLOW else ctx.prec):
                self.found[j, spin] = residual(self.rod, self.motions[j], spin)
        return self.found[j, spin]


def residual(rod: Rod, motion: Vector, spin: float) -> Residual:
    """Put a rotation, times the extent, into the balance of torques."""
    reach = 1 + float(rod.length)
    x, y = rod.support.center
    arm = motion[0] * y - motion[1] * (x + rod.length)
    if abs(spin) < STILL:
        error, turn = abs(float(arm)), arb.atan2(motion[1], motion[0])
        return Residual(error, ANGLE * EPSILON * reach, _degrees(turn), ANGLE * EPSILON)
    omega, sense = arb(spin) / rod.support.extent, 1 if spin > 0 else -1
    c = -rod.length - motion[1] / omega, motion[0] / omega
    now = moments(rod.support, c)
    own, carried = now.torque(c, (x, y)), (x + rod.length) * now.x + y * now.y
    stiff, bend = _slopes(now, (c[0] + rod.length, c[1]))
    size = abs(float(own)) + abs(float(carried))
    allowed = BALANCE * EPSILON * (size + stiff) + 4 * EPSILON * reach
    turn = arb.atan2(sense * now.x, -sense * now.y)
    force = np.hypot(float(now.x), float(now.y))
    rounding = ANGLE * EPSILON * (1 + bend / force * (1 + reach / max(stiff, EPSILON)))
    return Residual(abs(float(own + carried)), allowed, _degrees(turn), rounding)


def _slopes(now: Moments, r: Vector) -> tuple[float, float]:
    """How much a relative change of the rotation changes the torque, and the force per weight."""
    bent = now.xx * r[0] + now.xy * r[1], now.xy * r[0] + now.yy * r[1]
    stiff = abs(float(bent[0] * r[0] + bent[1] * r[1]))
    if np.isfinite(stiff):
        return stiff, float(np.hypot(float(bent[0]), float(bent[1])))
    reach = float(np.hypot(float(r[0]), float(r[1])))
    return reach, reach * ON_LINE


def _degrees(turn: arb) -> float:
    return float(turn * 180 / arb.pi())
