"""Roots of scalar functions, one at a time: safeguarded Newton and a bracketed secant."""

from __future__ import annotations

from collections.abc import Callable

from scipy.optimize import brentq

ITERATIONS = 100
#: After a Newton step of this relative size the error is rounding.
SETTLED = 1e-11
EPS = 2.220446049250313e-16


def safe_newton(
    function: Callable[[float], tuple[float, float]], low: float, high: float, start: float
) -> float:
    """Root in [low, high] of a function that is negative before it and positive after it.

    Parameters
    ----------
    function : callable
        Value and slope.
    low, high, start : float
        A bracket, whose ends stand in for a root that rounding put outside, and a first guess.

    Notes
    -----
    Newton steps; a step that leaves the bracket is replaced by half of it.
    """
    x = start
    for _ in range(ITERATIONS):
        value, slope = function(x)
        if value == 0.0:
            return x
        if value > 0.0:
            high = min(high, x)
        else:
            low = max(low, x)
        new = x - value / slope if slope > 0.0 else low
        if not low < new < high:
            new = (low + high) / 2
        if abs(new - x) <= SETTLED * abs(x) or high - low <= 2 * EPS * max(abs(low), abs(high)):
            return new
        x = new
    return x


def bracketed(
    function: Callable[[float], float], low: float, high: float, f_low: float, f_high: float
) -> float:
    """Root between two values of opposite sign, by Brent's method to a few places of rounding.

    The values at the ends are taken as they are given: a function that starts from its last root may
    differ in the last place when it is called again.
    """
    ends = {low: f_low, high: f_high}
    if f_low == 0.0 or not low < high:
        return low
    if f_high == 0.0:
        return high
    root: float = brentq(
        lambda x: ends[x] if x in ends else function(x),
        low,
        high,
        xtol=1e-300,
        rtol=4 * EPS,
        maxiter=2000,  # a root at zero is approached through all the exponents
    )
    return root
