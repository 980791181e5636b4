"""Errors of wrenches and of motion angles, against their certified values."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from flint import arb, ctx

from planar_pushing.certified import radians, ring
from planar_pushing.certified.balls import PRECISION, precise
from planar_pushing.mechanics.plane import Array


@lru_cache(maxsize=4096)
@precise
def wrench(spin_ratio: float) -> tuple[arb, arb]:
    """Force and torque of the ring at a spin ratio >= 0."""
    return ring.profile(arb(spin_ratio))


def relative_error(value: float, exact: arb) -> float:
    """``|value - exact| / |exact|``, formed without rounding; infinite where `value` is not finite."""
    if not np.isfinite(value):
        return np.inf
    with ctx.workprec(PRECISION):
        return abs(float((arb(float(value)) - exact) / exact))


@lru_cache(maxsize=4096)
@precise
def motion_angle(rod_length: float, force_angle: float, rod_angle: float) -> arb:
    """Angle of the contact's motion under friction, radians (Eq. 7), for the doubles given."""
    length, psi, phi = map(arb, (rod_length, rod_angle, force_angle))
    return radians.motion_angle(length, psi, phi, share=arb(0), rho=arb(1))


def angle_errors(angles: Array, lengths: Array, forces: Array, rod_angle: float) -> Array:
    """Differences of motion angles from the certified ones, degrees, all of shape (n,)."""
    exact = [
        motion_angle(float(x), float(y), rod_angle) for x, y in zip(lengths, forces, strict=True)
    ]
    with ctx.workprec(PRECISION):
        apart = [abs(float(arb(float(a)) - b)) for a, b in zip(angles, exact, strict=True)]
    return np.asarray(np.rad2deg(apart))
