"""Roots of functions of one number in a bracket."""

from __future__ import annotations

from collections.abc import Callable
from math import inf, sqrt
from typing import Any

from planar_pushing.mechanics.compiled import compiled, generic

#: Of each kind of equation, the function behind `excess`.
EQUATIONS: dict[type, Callable[..., Any]] = {}

EPSILON = 2.220446049250313e-16
#: Newton steps below this part of the root that shrink by more than this factor converge quadratically:
#: the next one is the cube of this one over the square of the last. Where that is below rounding, or two
#: steps in a row are this small relative to the root, the iteration ends. Beside an infinite slope steps
#: shrink slowly.
NEAR, QUADRATIC, SETTLED = 0.1, 0.02, 1e-12
#: More than bisection needs to take a bracket of the domain to its end.
STEPS = 200


@generic
def excess(kind: Any) -> Callable[..., Any]:
    """Value and slope at x of an equation: a named tuple of what it holds besides x."""
    return EQUATIONS[kind]


@compiled
def _middle(low, high):
    """Middle of a bracket; of one that spans sizes, the middle of the sizes."""
    if low > 0.0 and high > 4.0 * low:
        return sqrt(low) * sqrt(high)
    return low + (high - low) / 2


@compiled
def is_last(size, before):
    """Whether only rounding is left after a Newton step of a relative size, and one before."""
    quadratic = before <= NEAR and size <= QUADRATIC * before
    return size <= SETTLED or (quadratic and size**3 <= EPSILON * before**2)


@compiled
def root(equation, low, high, start):
    """Root of an equation whose value increases between low and high.

    Parameters
    ----------
    equation : named tuple
        Of a kind in `EQUATIONS`.
    low, high, start : float
        Bracket, and a first guess in it.

    Returns
    -------
    x : float
    found : bool
        Whether the value changes its sign in the bracket; where it does not, x is the end at which
        it is nearer to a root.

    Notes
    -----
    Newton's method; where a step leaves the bracket, or steps do not shrink, the bracket is halved. The
    ends are not evaluated unless the iteration arrives there.
    """
    x, last, newton = start, high - low, False
    above, below = False, False
    for _ in range(STEPS):
        value, slope = excess(equation, x)
        if value == 0.0:
            return x, True
        if value > 0.0:
            high, above = x, True
        else:
            low, below = x, True
        new = x - value / slope if slope > 0.0 else inf
        step, before = abs(new - x), newton
        newton = low <= new <= high and slope < inf
        newton = newton and (step <= last / 2 or step <= SETTLED * abs(new))
        if newton:
            quadratic = last <= NEAR * abs(new) and step <= QUADRATIC * last
            ends = quadratic and step**3 <= EPSILON * abs(new) * last**2
            if before and (ends or max(step, last) <= SETTLED * abs(new)):
                return new, True
        elif high - low <= 2.0 * EPSILON * max(abs(low), abs(high)):
            return x, _crosses(equation, low, high, above, below)
        else:
            new = _middle(low, high)
            step = abs(new - x)
        x, last = new, step
    return x, _crosses(equation, low, high, above, below)


@compiled
def _crosses(equation, low, high, above, below):
    if not above:
        above = excess(equation, high)[0] >= 0.0
    if not below:
        below = excess(equation, low)[0] <= 0.0
    return above and below
