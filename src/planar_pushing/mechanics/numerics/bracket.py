"""Roots of functions of one number whose slope is not known."""

from __future__ import annotations

from planar_pushing.mechanics.compiled import compiled, inlined
from planar_pushing.mechanics.numerics.root import excess

#: Relative resolution of a root, some units in the last place.
RESOLUTION = 1e-15
#: More than bisection needs to come to zero through all the exponents.
ITERATIONS = 2000


@inlined
def _part(a, b, c, at_a, at_b, at_c):
    """Part of the bracket from a to b where inverse quadratic interpolation has the root, or half."""
    part = 0.5
    if c != b and at_c != at_a and at_c != at_b:
        place, height = (a - b) / (c - b), (at_a - at_b) / (at_c - at_b)
        if height * height < place and (1.0 - height) * (1.0 - height) < 1.0 - place:
            part = at_a / (at_b - at_a) * at_c / (at_b - at_c)
            part += (c - a) / (b - a) * at_a / (at_c - at_a) * at_b / (at_c - at_b)
    return part


@compiled
def bracketed(equation, low, high, at_low, at_high, resolution=RESOLUTION):
    """Root of an equation of `mechanics.root` between two values of opposite sign.

    Chandrupatla's method (Advances in Engineering Software 28, 1997): inverse quadratic interpolation where
    the function is smooth enough for it, bisection elsewhere.
    """
    a, b, c = high, low, high
    at_a, at_b, at_c = at_high, at_low, at_high
    part = 0.5
    for _ in range(ITERATIONS):
        x = a + part * (b - a)
        value = excess(equation, x)[0]
        if (value > 0.0) == (at_a > 0.0):
            c, at_c = a, at_a
        else:
            c, b, at_c, at_b = b, a, at_b, at_a
        a, at_a = x, value
        best, least = (a, at_a) if abs(at_a) < abs(at_b) else (b, at_b)
        if least == 0.0 or abs(b - a) <= 2.0 * resolution * abs(best):
            return best
        limit = resolution * abs(best) / abs(b - a)
        part = min(max(_part(a, b, c, at_a, at_b, at_c), limit), 1.0 - limit)
    return a
