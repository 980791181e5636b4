"""The rotations that are possible for some pressure with a given center, from inside and from outside.

For each pressure the torque about the contact increases with the rotation: it is the derivative of the
potential, which is convex. A rotation is therefore impossible beyond one at which the torque of every
pressure has the same sign. The other way round, the pressure of an extreme torque is in balance at a
rotation that is at least as far out; repeating this converges faster than linearly.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from planar_pushing.mechanics.plane import Array
from planar_pushing.stability.base_region import CLOSE, Base
from planar_pushing.stability.certificates import Bound, proved_maximum
from planar_pushing.stability.linear_program import (
    Candidates,
    Optimum,
    Pressure,
    largest,
    velocities,
)

#: Largest rotation: about the contact itself.
SPIN = math.pi / 2.0
#: Torque, relative to weight and size, that counts as none.
BALANCED = 1e-15
#: Width of the interval between an attained and a proved end that is narrow enough; first step beyond an
#: attained rotation, and the factor to the next one.
NARROW, STEP, LONGER = 4e-10, 2e-10, 4.0
#: Maximum number of linear programs for an end.
PROGRAMS = 80
#: Accuracy of the exchange, after a step of Newton's method within this distance and before.
FINE, COARSE, NEAR = 1e-11, 1e-5, 0.03
#: Speed below which a point is the center of rotation.
RESTING = 1e-11
NO_FORCE = np.zeros(2)


class End(NamedTuple):
    """An end of the interval of eta: one that is attained by a pressure, and one that is proved."""

    attained: float
    proved: float
    pressure: Pressure


def rotation_end(candidates: Candidates, sign: int) -> End:
    """The largest (sign 1) or smallest (-1) possible rotation."""
    base = candidates.base
    if spins_freely(base):
        return End(sign * SPIN, sign * SPIN, Pressure(np.zeros((1, 2)), np.ones(1)))
    pressure = largest(candidates, 0.0, NO_FORCE, -float(sign), COARSE).pressure
    eta, beyond, step = balance_rotation(base, pressure, sign), sign * SPIN, STEP
    probe, open_, enough = (
        eta,
        eta,
        COARSE,
    )  # the rotations up to `open_` are attained, or not decided
    for _ in range(PROGRAMS):
        optimum = largest(candidates, probe, NO_FORCE, -float(sign), enough)
        minimum = -optimum.value
        if optimum.exact:
            reached = [balance_rotation(base, optimum.pressure, sign)] + [probe] * (minimum <= 0.0)
            further = max(reached, key=lambda value: sign * value)
            if sign * (further - eta) > 0.0:
                eta, pressure = further, optimum.pressure
        if minimum > 0.0 and _is_beyond(base, probe, sign, optimum.multiplier):
            beyond = probe
        elif enough <= FINE:
            open_ = max(open_, probe, key=lambda value: sign * value)
        open_ = max(open_, eta, key=lambda value: sign * value)
        if sign * (beyond - eta) <= NARROW or sign * (beyond - open_) <= NARROW:
            break
        newton = probe - optimum.value / _slope(base, probe, sign, optimum)
        enough = FINE if abs(newton - probe) < NEAR else COARSE
        if sign * (newton - open_) > step:
            within = sign * (beyond - newton) > step
            probe = newton if within else (open_ + beyond) / 2.0
        else:
            probe = open_ + sign * min(step, abs(beyond - open_) / 2.0)
            step, enough = LONGER * step, FINE
    return End(eta, beyond, pressure)


def _slope(base: Base, eta: float, sign: int, optimum: Optimum) -> float:
    """Derivative of the largest torque against the sense, by the theorem of the envelope."""
    points, shares = optimum.pressure
    v = velocities(base, eta, points)
    turned = np.stack([-points[:, 1], points[:, 0]], axis=-1)
    v_turn = np.cos(eta) * turned - np.sin(eta) * base.motion
    speed = np.hypot(v[:, 0], v[:, 1])
    moves = speed > RESTING
    across = v[moves, 0] * v_turn[moves, 1] - v[moves, 1] * v_turn[moves, 0]
    arm = v[moves, 0] * turned[moves, 1] - v[moves, 1] * turned[moves, 0]
    slope = -sign * float(shares[moves] @ (across * arm / speed[moves] ** 3))
    held = float(shares[~moves].sum())
    if held:
        gain = math.copysign(1.0, eta) - float(optimum.multiplier[1:3] @ base.path)
        slope -= held * gain / math.sin(eta) ** 2
    return slope if slope else math.nan


def spins_freely(base: Base) -> bool:
    """Whether all weight can rest on the contact, so that every rotation is possible."""
    if np.hypot(*base.center) > CLOSE:
        return False
    _, distance = base.curves.nearest(base.center)
    return bool(distance.min() <= CLOSE or base.areas.contain(base.center[None])[0])


def _is_beyond(base: Base, eta: float, sign: int, multiplier: Array) -> bool:
    """Whether the torque of every pressure is proved to have the sign."""
    bound = Bound(eta, eta, multiplier, multiplier, NO_FORCE)
    return proved_maximum(base, bound, FINE) < 0.0


def balance_rotation(base: Base, pressure: Pressure, sign: int) -> float:
    """The largest (sign 1) or smallest (-1) rotation eta at which the torque of a pressure vanishes."""
    low, high = -SPIN, SPIN
    if sign * torque(base, pressure, sign * SPIN) <= BALANCED:
        return sign * SPIN
    while True:
        middle = (low + high) / 2.0
        if not low < middle < high:
            return low if sign > 0 else high
        if torque(base, pressure, middle) <= sign * BALANCED:
            low = middle
        else:
            high = middle


def torque(base: Base, pressure: Pressure, eta: float) -> float:
    """Torque about the contact; points at rest add none."""
    (a, b), c, s = base.motion.tolist(), math.cos(eta), math.sin(eta)
    total = 0.0
    for (x, y), share in zip(pressure.points.tolist(), pressure.shares.tolist(), strict=True):
        v_x, v_y = c * a - s * y, c * b + s * x
        speed = math.sqrt(v_x * v_x + v_y * v_y)
        if speed:
            total += share * (x * v_y - y * v_x) / speed
    return total
