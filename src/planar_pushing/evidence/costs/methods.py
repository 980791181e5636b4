"""The methods that work-precision diagrams compare: friction wrench, and edges of motion cones."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.special import ellipe, ellipk, elliprd, hyp2f1

from planar_pushing.evidence.costs import models, quadrature
from planar_pushing.evidence.costs.inverses import (
    bracketed,
    edges,
    explicit,
    found_root,
    linear,
    ours,
    tabulated,
    through,
)
from planar_pushing.evidence.costs.quadrature import Wrenches
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.wrench import ring_profile

#: Maps arguments of shape (n,), followed by a setting, to results, followed by counts of evaluations.
Run = Callable[..., tuple[Array, ...]]
Profile = Callable[[Array], tuple[Array, Array]]
NOTHING, INTEGRAND, WRENCH = "nothing", "integrand", "wrench"
#: Setting of a formula, tolerances, numbers of points of rules, and numbers of entries of tables.
CLOSED = (0.0,)
TOLERANCES = (1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13)
ROOTS = (1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14)
POINTS, NODES = tuple(2.0 ** np.arange(2, 17)), tuple(2.0 ** np.arange(2, 10))
ENTRIES = tuple(2.0 ** np.arange(4, 17, 2))
#: Number of elements in a timed call of a method that takes nanoseconds for each, alone and in units of the
#: edges of all cones; and number of elements times points for which a rule's integrand fits into a cache.
BATCH, IN_CACHE = 4096, 2**15
COPIES = BATCH // edges()[0].size
TINY = np.finfo(float).tiny


class Method(NamedTuple):
    """A way to compute the friction wrench, or the edge of a motion cone.

    Attributes
    ----------
    name : str
    settings : tuple of float
        Numbers of points or of entries, or tolerances, from coarse to fine; a single 0 for a formula.
    run : callable
        For the wrench, force and torque at spin ratios k >= 0; for a cone, the motion angle in radians from
        rod length and force angle; in both cases followed by the evaluations of each. All arguments except
        the setting and all results have shape (n,).
    counted : str
        The function evaluated: "nothing", "integrand", or "wrench" for the wrench in closed form.
    batch : int
        Number of results of a timed call; for a rule, times its number of points; for cones, in units of
        all edges.
    """

    name: str
    settings: tuple[float, ...]
    run: Run
    counted: str
    batch: int


def _formula(profile: Profile) -> Run:
    """A wrench for any k >= 0 from a formula."""
    return lambda k, setting: (*profile(k), np.zeros(k.shape, dtype=int))


def _dual(inner: Profile) -> Run:
    """A wrench for any k >= 0 from a formula for k <= 1: beyond, force and torque are exchanged."""

    def run(k: Array, setting: float) -> Wrenches:
        force, torque = inner(np.minimum(k, 1 / k))
        swapped = np.where(k > 1, torque, force), np.where(k > 1, force, torque)
        return (*swapped, np.zeros(k.shape, dtype=int))

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


def _quartic(k: Array) -> tuple[Array, Array]:
    return models.fitted_quartic().profile(k)


def _quartic_ratio(arm: Array) -> Array:
    return models.fitted_quartic().spin_ratio(arm)


#: Methods by the quantity that they compute; ours comes first.
METHODS: dict[str, tuple[Method, ...]] = {
    "wrench": (
        Method("closed form", CLOSED, _formula(ring_profile), NOTHING, BATCH),
        Method("hyp2f1", CLOSED, _dual(_hypergeometric), NOTHING, BATCH),
        Method("Carlson", CLOSED, _dual(_carlson), NOTHING, BATCH),
        Method("textbook E and K", CLOSED, _dual(_textbook), NOTHING, BATCH),
        Method("trapezoid", POINTS, quadrature.trapezoid, INTEGRAND, IN_CACHE),
        Method("Gauss-Legendre", NODES, quadrature.gauss_legendre, INTEGRAND, IN_CACHE),
        Method("quad", TOLERANCES, quadrature.adaptive, INTEGRAND, 4),
        Method("tanhsinh", TOLERANCES, quadrature.tanh_sinh, INTEGRAND, 64),
        Method("ellipsoid", CLOSED, _formula(models.ellipsoid_profile), NOTHING, BATCH),
        Method("convex quartic", CLOSED, _formula(_quartic), NOTHING, BATCH),
    ),
    "cone": (
        Method("closed form", CLOSED, ours, WRENCH, COPIES),
        Method("brentq on quad", ROOTS[:-1], through(bracketed), INTEGRAND, 1),
        Method("find_root", ROOTS, through(found_root), WRENCH, COPIES),
        Method("linear table", ENTRIES, through(tabulated(linear)), NOTHING, COPIES),
        Method("cubic table", ENTRIES, through(tabulated(CubicSpline)), NOTHING, COPIES),
        Method("ellipsoid", CLOSED, through(explicit(lambda arm: arm)), NOTHING, COPIES),
        Method("convex quartic", CLOSED, through(explicit(_quartic_ratio)), NOTHING, COPIES),
    ),
}


def rows(quantity: str) -> list[tuple[Method, float]]:
    """Every method for "wrench" or "cone" with each of its settings."""
    return [(method, setting) for method in METHODS[quantity] for setting in method.settings]
