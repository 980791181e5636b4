"""Methods for the edges of a motion cone; all but ours turn a moment arm into a spin ratio first."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq, elementwise

from planar_pushing.evidence.costs.methods.base import BATCH, CLOSED, Method, Run
from planar_pushing.evidence.costs.methods.models import fitted_quartic
from planar_pushing.evidence.costs.methods.quadrature import adaptive
from planar_pushing.mechanics.cones import motion_angle
from planar_pushing.mechanics.contact import InfiniteFriction
from planar_pushing.mechanics.effects import RingFriction
from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.scene import Scene, Slider
from planar_pushing.mechanics.wrench import ring_profile

#: Cones whose edges are computed: every rod length with every coefficient of friction. With the last four
#: the edges' lines of force almost touch the ring.
NEAR_TANGENT = np.sqrt(2) * (1 + np.array([-1e-3, -1e-6, 1e-6, 1e-3]))
ROD_LENGTHS = np.append(np.geomspace(0.2, 10, 14), NEAR_TANGENT)
FRICTION_COEFFICIENTS = np.array([0.5, 2.0, np.inf])
ROD_ANGLE = np.pi / 4

TOLERANCES = (1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14)
SIZES = tuple(2.0**n for n in range(4, 17, 2))
#: Spin ratios for positive moment arms, and evaluations for each: of an integrand for `brentq on quad`,
#: of the wrench for the others.
Ratios = tuple[Array, Array]
Inverse = Callable[[Array, float], Ratios]


def edges() -> tuple[Array, Array]:
    """Rod length and force angle of both edges of every cone, radians, shape (2 cones,)."""
    half = np.arctan(FRICTION_COEFFICIENTS)
    angles = np.concatenate([np.pi / 2 - half, np.pi / 2 + half])
    length, angle = np.meshgrid(ROD_LENGTHS, angles, indexing="ij")
    return length.ravel(), angle.ravel()


def _ours(length: Array, angle: Array, setting: float) -> Ratios:
    slider = Slider(rod_length=length, rod_angle=ROD_ANGLE)
    scene = Scene(slider=slider, contact=InfiniteFriction(), effects=(RingFriction(),))
    return motion_angle(scene, angle), np.ones(angle.shape, dtype=int)


def _arms(length: Array, angle: Array) -> Array:
    """Moment arms, Eq. (10); next to a tangent to the ring what the subtraction rounds off counts."""
    lean = ROD_ANGLE - angle
    back = lean - ROD_ANGLE
    rounding = (ROD_ANGLE - (lean - back)) - (angle + back)
    force = direction(angle)
    across = np.sin(ROD_ANGLE) * force[:, 0]
    return length * np.where(force[:, 1] == 0, across, np.sin(lean) + rounding * np.cos(lean))


def _through(inverse: Inverse) -> Run:
    """Motion angles by an inverse, from Eqs. (10)-(12) as the paper has them."""

    def run(length: Array, angle: Array, setting: float) -> Ratios:
        lean, arm = ROD_ANGLE - angle, _arms(length, angle)
        ratio, evaluations = inverse(np.abs(arm), setting)
        pull = np.copysign(ratio, arm) * length
        return angle - np.arctan2(pull * np.cos(lean), 1 + pull * np.sin(lean)), evaluations

    return run


def _brentq(arm: Array, tolerance: float) -> Ratios:
    found = [_brentq_one(float(each), tolerance) for each in arm]
    return np.array([k for k, _ in found]), np.array([count for _, count in found])


def _brentq_one(arm: float, tolerance: float) -> tuple[float, int]:
    evaluations = 0

    def excess(k: float) -> float:
        nonlocal evaluations
        force, torque, count = adaptive(np.array([k]), tolerance)
        evaluations += int(count[0])
        return float(torque[0] - arm * force[0])

    # H(k) lies between k / 2 and 2 k; a coarse quadrature may move the ends of that.
    low, high = arm / 2.2, arm * 2.2
    relative = max(tolerance, 4 * np.finfo(float).eps)
    return float(brentq(excess, low, high, xtol=1e-300, rtol=relative)), evaluations


def _find_root(arm: Array, tolerance: float) -> Ratios:
    def excess(k: Array, h: Array) -> Array:
        force, torque = ring_profile(k)
        return np.asarray(torque - h * force)

    limits = {
        "xatol": 0.0,
        "xrtol": max(tolerance, 4 * np.finfo(float).eps),
        "fatol": 0.0,
        "frtol": 0.0,
    }
    found = elementwise.find_root(excess, (arm / 2.01, arm * 2.01), args=(arm,), tolerances=limits)
    return np.asarray(found.x), np.asarray(found.nfev)


def _folded(table: Callable[[int], Callable[[Array], Array]]) -> Inverse:
    """Look up arms in [0, 1] and, since H is self-dual, all others."""

    def run(arm: Array, size: float) -> Ratios:
        inner = table(int(size))(np.minimum(arm, 1 / arm))
        return np.where(arm > 1, 1 / inner, inner), np.zeros(arm.shape, dtype=int)

    return run


def _nodes(size: int) -> tuple[Array, Array]:
    k = np.linspace(0, 1, size)
    force, torque = ring_profile(k)
    return torque / force, k


@lru_cache
def _linear(size: int) -> Callable[[Array], Array]:
    arms, ratios = _nodes(size)
    return lambda arm: np.interp(arm, arms, ratios)


@lru_cache
def _cubic(size: int) -> Callable[[Array], Array]:
    spline: Callable[[Array], Array] = CubicSpline(*_nodes(size))
    return spline


def _model(spin_ratio: Callable[[Array], Array]) -> Inverse:
    def run(arm: Array, setting: float) -> Ratios:
        return spin_ratio(arm), np.zeros(arm.shape, dtype=int)

    return run


def cone_methods() -> tuple[Method, ...]:
    """The methods for the motion cone, our own first; a budget is how often a call repeats the cones."""
    copies = max(1, BATCH // (2 * ROD_LENGTHS.size * FRICTION_COEFFICIENTS.size))

    def fast(name: str, inverse: Inverse, settings: tuple[float, ...] = CLOSED) -> Method:
        return Method(name=name, settings=settings, run=_through(inverse), budget=copies)

    slow = TOLERANCES[:-1]
    return (
        Method(name="closed form", settings=CLOSED, run=_ours, budget=copies),
        Method(name="brentq on quad", settings=slow, run=_through(_brentq), budget=1),
        fast("find_root", _find_root, TOLERANCES),
        fast("linear table", _folded(_linear), SIZES),
        fast("cubic table", _folded(_cubic), SIZES),
        fast("ellipsoid", _model(lambda arm: arm)),
        fast("convex quartic", _model(fitted_quartic().spin_ratio)),
    )
