"""Roots and minima of functions in brackets; importing SciPy's takes longer than most scenes.

Roots by the method of Chandrupatla (1997), inverse quadratic interpolation where it can be trusted and
bisection elsewhere: T. R. Chandrupatla, A new hybrid quadratic/bisection algorithm for finding the zero of
a nonlinear function without using derivatives, Advances in Engineering Software 28(3), 145-149.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from planar_pushing.mechanics.planar import Array

#: A bracket of a few ulp cannot shrink further.
TOLERANCE = 4 * np.finfo(float).eps
#: Bisection alone takes a bracket of doubles to its end in fewer steps.
STEPS = 2200
#: The golden section, and the sections after which a minimum's bracket has the width of its rounding.
GOLDEN = (np.sqrt(5) - 1) / 2
SECTIONS = 40


def bracketed_root(
    function: Callable[..., Array], low: Array, high: Array, args: tuple[Array, ...] = ()
) -> Array:
    """Root of ``function(x, *args)`` between low and high, for arrays of one shape.

    Where the sign does not change, an end, as of an increasing function: low where it is positive there.
    """
    shape = low.shape
    rest: tuple[Array, ...] = tuple(each.ravel() for each in args)
    # `a` is the latest point, `b` the one across the root, `c` the one before.
    a, b = low.ravel(), high.ravel()
    fa, fb = function(a, *rest), function(b, *rest)
    found = np.where((fa >= 0) & (fb != 0), a, b)
    active = np.flatnonzero(np.sign(fa) * np.sign(fb) < 0)
    a, b, fa, fb = a[active], b[active], fa[active], fb[active]
    rest = tuple(each[active] for each in rest)
    part = np.full(active.size, 0.5)
    for _ in range(STEPS):
        if not active.size:
            break
        x = a + part * (b - a)
        # Next to 0 a part of the way may be too small to be a step.
        x = np.where((x == a) | (x == b), a + 0.5 * (b - a), x)
        moved = (x != a) & (x != b)  # neighbours enclose the root as closely as doubles can
        fx = function(x, *rest)
        same = np.sign(fx) == np.sign(fa)
        c, fc = np.where(same, a, b), np.where(same, fa, fb)
        b, fb = np.where(same, b, a), np.where(same, fb, fa)
        a, fa = x, fx
        best = np.where(np.abs(fa) < np.abs(fb), a, b)
        found[active] = best
        width, least = np.abs(b - a), TOLERANCE * np.abs(best)
        going = (width > least) & (fa != 0) & moved
        active, rest = active[going], tuple(each[going] for each in rest)
        a, b, c, fa, fb, fc = (each[going] for each in (a, b, c, fa, fb, fc))
        margin = 0.5 * least[going] / width[going]
        part = np.clip(_interpolated(a, b, c, fa, fb, fc), margin, 1 - margin)
    return found.reshape(shape)


def _interpolated(a: Array, b: Array, c: Array, fa: Array, fb: Array, fc: Array) -> Array:
    """Part of the way from a to b at which inverse quadratic interpolation sees the root, or a half."""
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        xi, phi = (a - b) / (c - b), (fa - fb) / (fc - fb)
        trusted = (phi**2 < xi) & ((1 - phi) ** 2 < 1 - xi)
        along = fa / (fb - fa) * (fc / (fb - fc))
        across = (c - a) / (b - a) * (fa / (fc - fa)) * (fb / (fc - fb))
    return np.where(trusted, along + across, 0.5)


def bracketed_minimum(function: Callable[[Array], Array], low: float, high: float) -> float:
    """Where a function that falls and then rises in [low, high] is least, by golden sections.

    A minimum is flat: its place is known to the square root of the precision, its value to rounding.
    """
    for _ in range(SECTIONS):
        reach = GOLDEN * (high - low)
        left, right = function(np.array([high - reach, low + reach]))
        low, high = (low, low + reach) if left < right else (high - reach, high)
    return (low + high) / 2
