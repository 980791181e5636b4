"""Roots and dips of functions of one number whose slope is not known."""

from __future__ import annotations

from math import sqrt

from planar_pushing.mechanics.compiled import compiled, inlined
from planar_pushing.mechanics.numerics.root import excess

#: Relative resolution of a root, some units in the last place.
RESOLUTION = 1e-15
#: More than bisection needs to come to zero through all the exponents.
ITERATIONS = 2000
#: Golden section, and the number of sections for the least value of a dip: to 1e-7 of its width, where the
#: value is known to 1e-14 of its depth.
SECTION, SECTIONS = (3.0 - sqrt(5.0)) / 2.0, 34


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


@compiled
def dip(equation, low, middle, high, at_middle, bound=0.0):
    """A place in a dip where an equation is below a bound, and the value there; the least one without any.

    Golden sections about the middle one of three places, at which the equation is least.
    """
    place, value = middle, at_middle
    for _ in range(SECTIONS):
        left = place - low > high - place
        other = place - SECTION * (place - low) if left else place + SECTION * (high - place)
        at_other = excess(equation, other)[0]
        if at_other < value:
            low, high = (low, place) if left else (place, high)
            place, value = other, at_other
        else:
            low, high = (other, high) if left else (low, other)
        if value < bound:
            break
    return place, value
