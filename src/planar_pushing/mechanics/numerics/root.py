"""Roots and dips of functions of one number, ``function(arguments, x)``, in brackets."""

from __future__ import annotations

from math import sqrt

from planar_pushing.mechanics.compiled import compiled

EPSILON = 2.220446049250313e-16
#: Newton steps below this part of the root that shrink by more than this factor converge quadratically:
#: the next one is the cube of this one over the square of the last, or the square of this one, where that
#: is more: one step may be small by chance. Where the next one is below rounding, or a step is this small
#: relative to the root, the iteration ends. Beside an infinite slope steps shrink slowly.
NEAR, QUADRATIC, SETTLED = 0.1, 0.02, 1e-13
#: Relative resolution of a root, some units in the last place.
RESOLUTION = 1e-15
#: More than bisection needs to come to zero through all the exponents.
ITERATIONS = 2000
#: Steps out to a bracket, each eight times the last.
DOUBLINGS = 60
#: Golden section, and the number of sections for the least value of a dip: to 1e-7 of its width, where the
#: value is known to 1e-14 of its depth.
SECTION, SECTIONS = (3.0 - sqrt(5.0)) / 2.0, 34


@compiled
def is_last(size, before):
    """Whether only rounding is left after a Newton step of a relative size, and one before."""
    quadratic = before <= NEAR and size <= QUADRATIC * before and size * size <= EPSILON
    return size <= SETTLED or (quadratic and size**3 <= EPSILON * before**2)


@compiled
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
def root(function, arguments, low, high, at_low, at_high, resolution=RESOLUTION):
    """Root between two numbers at which the values have opposite signs.

    Chandrupatla's method (Advances in Engineering Software 28, 1997): inverse quadratic interpolation where
    the function is smooth enough for it, bisection elsewhere.
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
    """A place in a dip where a function is below a bound, and the value there; the least one without any.

    Golden sections about the middle one of three places, at which the function is least.
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


@compiled
def increasing_root(function, arguments, start, step):
    """Root of a function that increases, from a first guess and the size of a first step across it."""
    low, at_low = start, function(arguments, start)
    sense = -1.0 if at_low > 0.0 else 1.0
    for _ in range(DOUBLINGS):
        high = start + sense * step
        at_high = function(arguments, high)
        if at_low == 0.0 or (at_high > 0.0) != (at_low > 0.0):
            break
        low, at_low, step = high, at_high, 8.0 * step
    if at_low == 0.0:
        return low
    return root(function, arguments, low, high, at_low, at_high)
