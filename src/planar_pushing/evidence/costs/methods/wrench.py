"""Methods that work-precision diagrams compare, and closed forms of the wrench other than our own."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.special import ellipe, ellipk, elliprd, hyp2f1

from planar_pushing.evidence.costs.methods import quadrature
from planar_pushing.evidence.costs.methods.base import BATCH, CLOSED, Method, Run
from planar_pushing.evidence.costs.methods.models import ellipsoid_profile, fitted_quartic
from planar_pushing.evidence.costs.methods.quadrature import Wrenches
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.wrench import ring_profile

TINY = np.finfo(float).tiny


def batch(method: Method, setting: float) -> int:
    """Number of elements that a timed call takes, where the budget is elements times points."""
    return max(1, method.budget // max(1, int(setting)))


def _dual(inner: Callable[[Array], tuple[Array, Array]]) -> Run:
    """A wrench for any k >= 0 from one for k <= 1; no integrand is evaluated."""

    def run(k: Array, setting: float) -> Wrenches:
        force, torque = inner(np.minimum(k, 1 / k))
        outside = k > 1
        zero = np.zeros(k.shape, dtype=int)
        return np.where(outside, torque, force), np.where(outside, force, torque), zero

    return run


def _whole(profile: Callable[[Array], tuple[Array, Array]]) -> Run:
    """A wrench for any k >= 0 without a setting; no integrand is evaluated."""

    def run(k: Array, setting: float) -> Wrenches:
        return (*profile(k), np.zeros(k.shape, dtype=int))

    return run


def _hypergeometric(k: Array) -> tuple[Array, Array]:
    m = k * k
    return hyp2f1(-0.5, 0.5, 1, m), k / 2 * hyp2f1(0.5, 0.5, 2, m)


def _carlson(k: Array) -> tuple[Array, Array]:
    """B = x R_D(0, 1, x) / 3 and E = B + x R_D(0, x, 1) / 3 (DLMF 19.25.1): all terms are positive."""
    x = np.maximum((1 - k) * (1 + k), TINY)
    torque = x / 3 * elliprd(0, 1, x)
    return 2 / np.pi * (torque + x / 3 * elliprd(0, x, 1)), 2 / np.pi * k * torque


def _textbook(k: Array) -> tuple[Array, Array]:
    """E and K as handbooks print them: the torque cancels for small k, and K(1) is infinite."""
    m = k * k
    with np.errstate(invalid="ignore"):
        return 2 / np.pi * ellipe(m), 2 / np.pi * (ellipe(m) - (1 - m) * ellipk(m)) / k


TOLERANCES = (1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13)
#: Spin ratios times points for which a rule's integrand fits a cache.
POINTS = 2**15


def wrench_methods() -> tuple[Method, ...]:
    """The methods for the wrench, our own first."""

    def closed(name: str, run: Run) -> Method:
        return Method(name=name, settings=CLOSED, run=run, budget=BATCH)

    return (
        closed("closed form", _whole(ring_profile)),
        closed("hyp2f1", _dual(_hypergeometric)),
        closed("Carlson", _dual(_carlson)),
        closed("textbook E and K", _dual(_textbook)),
        Method(
            name="trapezoid",
            settings=tuple(2.0**n for n in range(2, 17)),
            run=quadrature.trapezoid,
            budget=POINTS,
        ),
        Method(
            name="Gauss-Legendre",
            settings=tuple(2.0**n for n in range(2, 10)),
            run=quadrature.gauss_legendre,
            budget=POINTS,
        ),
        Method(name="quad", settings=TOLERANCES, run=quadrature.adaptive, budget=4),
        Method(name="tanhsinh", settings=TOLERANCES, run=quadrature.tanh_sinh, budget=64),
        closed("ellipsoid", _whole(ellipsoid_profile)),
        closed("convex quartic", _whole(fitted_quartic().profile)),
    )
