"""Bracketed roots and minima of functions of one number, ``function(arguments, x)``."""

from __future__ import annotations

from math import sqrt

from planar_pushing.simulation.legacy.compiled import compiled

EPSILON = 2.220446049250313e-16
#: Newton steps converge quadratically once they are below NEAR, relative to the root, and shrink by at
#: least QUADRATIC. The next step is then estimated as the cube of this one over the square of the last, or,
#: if larger, as the square of this one, because a single step can be small by chance. The iteration ends
#: when the next step is below rounding or a step is below SETTLED. Near an infinite slope steps shrink
#: slowly.
NEAR, QUADRATIC, SETTLED = 0.1, 0.02, 1e-13
#: Relative resolution of a root, a few units in the last place.
RESOLUTION = 1e-15
#: More steps than bisection takes to reach zero through all exponents.
ITERATIONS = 2000
#: Golden section, and the number of sections for the minimum of a dip: they reduce its width to 1e-7, which
#: gives the value to 1e-14 of its depth.
SECTION, SECTIONS = (3.0 - sqrt(5.0)) / 2.0, 34


@compiled
def is_last(size, before):
    """Whether only rounding error is left after a Newton step, given its relative size and the last one."""
    quadratic = before <= NEAR and size <= QUADRATIC * before and size * size <= EPSILON
    return size <= SETTLED or (quadratic and size**3 <= EPSILON * before**2)


@compiled
def _part(a, b, c, at_a, at_b, at_c):
    """Fraction of the bracket from a to b at which inverse quadratic interpolation has its root, or 1/2."""
    part = 0.5
    if c != b and at_c != at_a and at_c != at_b:
        place, height = (a - b) / (c - b), (at_a - at_b) / (at_c - at_b)
        if height * height < place and (1.0 - height) * (1.0 - height) < 1.0 - place:
            part = at_a / (at_b - at_a) * at_c / (at_b - at_c)
            part += (c - a) / (b - a) * at_a / (at_c - at_a) * at_b / (at_c - at_b)
    return part


@compiled
def root(function, arguments, low, high, at_low, at_high, resolution=RESOLUTION):
    """Root between two numbers at which the values have opposite signs.

    Chandrupatla's method (Advances in Engineering Software 28, 1997): inverse quadratic interpolation where
    the function is smooth enough, bisection elsewhere.
    """
    a, b, c = high, low, high
    at_a, at_b, at_c = at_high, at_low, at_high
    part = 0.5
    for _ in range(ITERATIONS):
        x = a + part * (b - a)
        value = function(arguments, x)
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
def dip(function, arguments, low, middle, high, at_middle, bound=0.0):
    """A place in a dip where a function is below a bound, or else its minimum; and the value there.

    Golden-section search about the middle of three places, where the function is smallest.
    """
    place, value = middle, at_middle
    for _ in range(SECTIONS):
        left = place - low > high - place
        other = place - SECTION * (place - low) if left else place + SECTION * (high - place)
        at_other = function(arguments, other)
        if at_other < value:
            low, high = (low, place) if left else (place, high)
            place, value = other, at_other
        else:
            low, high = (other, high) if left else (low, other)
        if value < bound:
            break
    return place, value
