"""Edges of motion cones, by our inverse of the moment arm, Eqs. (7) and (10)-(12), and by others."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

import numpy as np
from scipy.optimize import brentq, elementwise

from planar_pushing.evidence.costs.quadrature import adaptive
from planar_pushing.mechanics.cones import motion_angle
from planar_pushing.mechanics.contact import InfiniteFriction
from planar_pushing.mechanics.effects import RingFriction
from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.scene import Scene, Slider
from planar_pushing.mechanics.wrench import ring_profile

#: Cones whose edges are computed: every rod length with every coefficient of friction. For the last four
#: lengths the edges' lines of force are almost tangent to the ring.
NEAR_TANGENT = np.sqrt(2) * (1 + np.array([-1e-3, -1e-6, 1e-6, 1e-3]))
ROD_LENGTHS = np.append(np.geomspace(0.2, 10, 14), NEAR_TANGENT)
FRICTION_COEFFICIENTS = np.array([0.5, 2.0, np.inf])
ROD_ANGLE = np.pi / 4
EPS = float(np.finfo(float).eps)

#: Spin ratios, or motion angles, and the evaluations for each, of shape (n,).
Ratios = tuple[Array, Array]
#: Maps positive moment arms and a setting to spin ratios.
Inverse = Callable[[Array, float], Ratios]


def edges() -> tuple[Array, Array]:
    """Rod length and force angle of both edges of every cone, radians, shape (2 cones,)."""
    half = np.arctan(FRICTION_COEFFICIENTS)
    angles = np.concatenate([np.pi / 2 - half, np.pi / 2 + half])
    length, angle = np.meshgrid(ROD_LENGTHS, angles, indexing="ij")
    return length.ravel(), angle.ravel()


def ours(length: Array, angle: Array, setting: float) -> Ratios:
    """Motion angles from the mechanics, whose inverse evaluates the ring's wrench once."""
    slider = Slider(rod_length=length, rod_angle=ROD_ANGLE)
    scene = Scene(slider=slider, contact=InfiniteFriction(), effects=(RingFriction(),))
    return motion_angle(scene, angle), np.ones(angle.shape, dtype=int)


def through(inverse: Inverse) -> Callable[[Array, Array, float], Ratios]:
    """Motion angles from an inverse, by Eqs. (10)-(12) as in the paper."""

    def run(length: Array, angle: Array, setting: float) -> Ratios:
        lean, arm = ROD_ANGLE - angle, _arms(length, angle)
        ratio, evaluations = inverse(np.abs(arm), setting)
        pull = np.copysign(ratio, arm) * length
        return angle - np.arctan2(pull * np.cos(lean), 1 + pull * np.sin(lean)), evaluations

    return run


def _arms(length: Array, angle: Array) -> Array:
    """Moment arms, Eq. (10); near a tangent to the ring the rounding error of the subtraction matters."""
    lean = ROD_ANGLE - angle
    back = lean - ROD_ANGLE
    rounding = (ROD_ANGLE - (lean - back)) - (angle + back)
    force = direction(angle)
    across = np.sin(ROD_ANGLE) * force[:, 0]
    return length * np.where(force[:, 1] == 0, across, np.sin(lean) + rounding * np.cos(lean))


def bracketed(arm: Array, tolerance: float) -> Ratios:
    """`brentq` with adaptive quadrature, one arm at a time; evaluations of the integrand."""
    found = [_bracketed(float(each), tolerance) for each in arm]
    return np.array([k for k, _ in found]), np.array([count for _, count in found])


def _bracketed(arm: float, tolerance: float) -> tuple[float, int]:
    evaluations = 0

    def excess(k: float) -> float:
        nonlocal evaluations
        force, torque, count = adaptive(np.array([k]), tolerance)
        evaluations += int(count[0])
        return float(torque[0] - arm * force[0])

    # H(k) lies between k / 2 and 2 k; a coarse quadrature can shift these bounds.
    limits = {"xtol": 1e-300, "rtol": max(tolerance, 4 * EPS)}
    return float(brentq(excess, arm / 2.2, arm * 2.2, **limits)), evaluations


def found_root(arm: Array, tolerance: float) -> Ratios:
    """`scipy.optimize.elementwise.find_root` on the closed form; evaluations of the wrench."""

    def excess(k: Array, h: Array) -> Array:
        force, torque = ring_profile(k)
        return np.asarray(torque - h * force)

    limits = {"xatol": 0.0, "xrtol": max(tolerance, 4 * EPS), "fatol": 0.0, "frtol": 0.0}
    found = elementwise.find_root(excess, (arm / 2.01, arm * 2.01), args=(arm,), tolerances=limits)
    return np.asarray(found.x), np.asarray(found.nfev)


def tabulated(interpolation: Callable[[Array, Array], Callable[[Array], Array]]) -> Inverse:
    """Look up arms in [0, 1] and, since H is self-dual, all others; nothing is evaluated."""

    @lru_cache
    def table(size: int) -> Callable[[Array], Array]:
        ratios = np.linspace(0, 1, size)
        force, torque = ring_profile(ratios)
        return interpolation(torque / force, ratios)

    def run(arm: Array, size: float) -> Ratios:
        inner = table(int(size))(np.minimum(arm, 1 / arm))
        return np.where(arm > 1, 1 / inner, inner), np.zeros(arm.shape, dtype=int)

    return run


def linear(arms: Array, ratios: Array) -> Callable[[Array], Array]:
    """Linear interpolation."""
    return lambda arm: np.interp(arm, arms, ratios)


def explicit(spin_ratio: Callable[[Array], Array]) -> Inverse:
    """Spin ratios by the explicit formula of a model; nothing is evaluated."""
    return lambda arm, setting: (spin_ratio(arm), np.zeros(arm.shape, dtype=int))
