"""Certified references: the ring's wrench and its motion angle in ball arithmetic."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from flint import arb, ctx

from planar_pushing.certified import ring
from planar_pushing.certified.balls import precise
from planar_pushing.certified.roots import increasing_root
from planar_pushing.mechanics.planar import Array

#: Bits of the arithmetic in which errors are formed.
BITS = 192


@lru_cache(maxsize=4096)
@precise
def wrench(spin_ratio: float) -> tuple[arb, arb]:
    """Force and torque of the ring at a spin ratio >= 0."""
    return ring.profile(arb(spin_ratio))


def relative_error(value: float, exact: arb) -> float:
    """``|value - exact| / |exact|``, formed without rounding; infinite where `value` is no number."""
    if not np.isfinite(value):
        return np.inf
    with ctx.workprec(BITS):
        return abs(float((arb(float(value)) - exact) / exact))


@lru_cache(maxsize=4096)
@precise
def motion_angle(rod_length: float, force_angle: float, rod_angle: float) -> arb:
    """Angle of the contact's motion under friction, radians (Eq. 7), for the doubles given."""
    lean, length = arb(rod_angle) - arb(force_angle), arb(rod_length)
    arm = length * lean.sin()
    if arm == 0:
        return arb(force_angle)
    ratio = _spin_ratio(abs(arm)) * (1 if arm > 0 else -1)
    ahead, aside = 1 + ratio * length * lean.sin(), ratio * length * lean.cos()
    return arb(force_angle) - arb.atan2(aside, ahead)


def _spin_ratio(arm: arb) -> arb:
    """Root of t(k) = arm f(k) for arm > 0: it lies between half and twice the arm."""

    def excess(k: arb) -> arb:
        force, torque = ring.profile(k)
        return torque - arm * force

    return increasing_root(excess, (arm / 2.01).mid(), (arm * 2.01).mid())


def angle_errors(angles: Array, lengths: Array, forces: Array, rod_angle: float) -> Array:
    """Differences of motion angles from the certified ones, degrees, all of shape (n,)."""
    exact = [
        motion_angle(float(x), float(y), rod_angle) for x, y in zip(lengths, forces, strict=True)
    ]
    with ctx.workprec(BITS):
        apart = [abs(float(arb(float(a)) - b)) for a, b in zip(angles, exact, strict=True)]
    return np.asarray(np.rad2deg(apart))
