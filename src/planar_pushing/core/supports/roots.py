"""Roots and minima of functions of one variable, which the caller evaluates."""

from __future__ import annotations

from math import fabs
from typing import NamedTuple

from planar_pushing.core.numbers import EPSILON, Numbers, zeros
from planar_pushing.core.supports.tolerances import ROUNDING, SHARE

#: Newton steps converge quadratically once they are below NEAR_ROOT, relative to the root, and shrink by at
#: least QUADRATIC. The next step is then estimated as the cube of this one over the square of the last, or,
#: if larger, as the square of this one, because a single step can be small by chance. The iteration ends
#: when the next step is below rounding or a step is below `SHARE`. Near an infinite slope steps shrink
#: slowly.
NEAR_ROOT = 0.1
QUADRATIC = 0.02
#: More steps than bisection needs to reach zero through all binary exponents.
ITERATIONS = 2000
#: Maximum degree of a polynomial.
MOST_ROOTS = 4
#: Golden section, and the number of sections for the minimum of a dip: they reduce its width to 1e-7, which
#: gives the value to 1e-14 of its depth.
SECTION = 0.3819660112501051
SECTIONS = 34


def is_last(size: float, before: float) -> bool:
    """Whether a Newton step leaves only rounding error, given its relative size and that of the last."""
    if size <= SHARE:
        return True
    if before > NEAR_ROOT or size > QUADRATIC * before or size * size > EPSILON:
        return False
    return size * size * size <= EPSILON * (before * before)


def positive_roots(coefficients: Numbers, degree: int, roots: Numbers) -> int:
    """Store the positive roots of a polynomial in increasing order, without those of even multiplicity.

    The coefficients are in the order of the powers, of which the highest is not zero. Between the roots of
    its derivative a polynomial is monotone. Returns the number of roots.
    """
    derivative = zeros(MOST_ROOTS + 1)
    walls = zeros(MOST_ROOTS + 1)
    number = 0
    for order in range(degree - 1, -1, -1):
        power = degree - order
        for k in range(power + 1):
            derivative[k] = coefficients[k + order]
            for j in range(order):
                derivative[k] *= float(k + order - j)
        farthest = 0.0
        for k in range(power):
            farthest = max(farthest, fabs(derivative[k] / derivative[power]))
        walls[number] = 1.0 + farthest
        count, low = 0, 0.0
        for i in range(number + 1):
            high = walls[i]
            positive: bool = value_of_polynomial(derivative, power, high) > 0.0
            if (value_of_polynomial(derivative, power, low) > 0.0) != positive:
                roots[count] = _bisect_polynomial(derivative, power, low, high, positive)
                count += 1
            low = high
        number = count
        for i in range(number):
            walls[i] = roots[i]
    return number


def value_of_polynomial(coefficients: Numbers, degree: int, x: float) -> float:
    """The value of a polynomial (Horner's scheme)."""
    value = 0.0
    for k in range(degree, -1, -1):
        value = value * x + coefficients[k]
    return value


def _bisect_polynomial(
    coefficients: Numbers, degree: int, low: float, high: float, positive: bool
) -> float:
    """The root between two numbers, of a polynomial that is positive, or not, at the second one."""
    for _ in range(ITERATIONS):
        x = (low + high) / 2.0
        if (value_of_polynomial(coefficients, degree, x) > 0.0) == positive:
            high = x
        else:
            low = x
        if high - low <= ROUNDING * high:
            break
    return (low + high) / 2.0


class Bracket(NamedTuple):
    """Two numbers at which a function has opposite signs, the previous number, and the values there.

    `part` is the fraction of the way from a, the latest one, to b at which to evaluate next. The search
    ends when the root is known to within `resolution`, relative to its magnitude.
    """

    a: float
    b: float
    c: float
    at_a: float
    at_b: float
    at_c: float
    part: float
    resolution: float


def open_bracket(
    low: float, high: float, at_low: float, at_high: float, resolution: float
) -> Bracket:
    """A bracket between two numbers at which the values have opposite signs."""
    return Bracket(
        a=high,
        b=low,
        c=high,
        at_a=at_high,
        at_b=at_low,
        at_c=at_high,
        part=0.5,
        resolution=resolution,
    )


def next_number(bracket: Bracket) -> float:
    """The number at which the function is to be evaluated next."""
    return bracket.a + bracket.part * (bracket.b - bracket.a)


def narrow_bracket(bracket: Bracket, x: float, value: float) -> Bracket:
    """The bracket narrowed by the value at a number in it.

    Chandrupatla's method (Advances in Engineering Software 28, 1997): inverse quadratic interpolation where
    the function is smooth enough, bisection elsewhere.
    """
    a, at_a = bracket.a, bracket.at_a
    b, c, at_b, at_c = bracket.b, bracket.a, bracket.at_b, bracket.at_a
    if (value > 0.0) != (at_a > 0.0):
        b, c, at_b, at_c = a, bracket.b, at_a, bracket.at_b
    a, at_a = x, value
    width, best = fabs(b - a), fabs(a if fabs(at_a) < fabs(at_b) else b)
    limit = bracket.resolution * best / width if width > 0.0 else 0.5
    part = min(max(_interpolate(a, b, c, at_a, at_b, at_c), limit), 1.0 - limit)
    return Bracket(a, b, c, at_a, at_b, at_c, part, bracket.resolution)


def best_number(bracket: Bracket) -> float:
    """The end of the bracket at which the function is closer to zero."""
    return bracket.a if fabs(bracket.at_a) < fabs(bracket.at_b) else bracket.b


def is_narrow(bracket: Bracket) -> bool:
    """Whether the root is known to the resolution."""
    if bracket.at_a == 0.0 or bracket.at_b == 0.0:
        return True
    size = fabs(best_number(bracket))
    return fabs(bracket.b - bracket.a) <= 2.0 * bracket.resolution * size


def _interpolate(a: float, b: float, c: float, at_a: float, at_b: float, at_c: float) -> float:
    """Fraction of the bracket from a to b at which inverse quadratic interpolation has its root, or 1/2."""
    part = 0.5
    if c != b and at_c != at_a and at_c != at_b:
        x, height = (a - b) / (c - b), (at_a - at_b) / (at_c - at_b)
        if height * height < x and (1.0 - height) * (1.0 - height) < 1.0 - x:
            part = at_a / (at_b - at_a) * at_c / (at_b - at_c)
            part += (c - a) / (b - a) * at_a / (at_c - at_a) * at_b / (at_c - at_b)
    return part


class Dip(NamedTuple):
    """Three numbers, of which the middle one has the smallest value of a function, and this value."""

    low: float
    middle: float
    high: float
    value: float


def section_of(dip: Dip) -> float:
    """The number at which the function is to be evaluated next, in the longer part (golden section)."""
    if dip.middle - dip.low > dip.high - dip.middle:
        return dip.middle - SECTION * (dip.middle - dip.low)
    return dip.middle + SECTION * (dip.high - dip.middle)


def narrow_dip(dip: Dip, x: float, value: float) -> Dip:
    """The dip narrowed by the value at a number in it."""
    left: bool = dip.middle - dip.low > dip.high - dip.middle
    if value < dip.value:
        return Dip(dip.low, x, dip.middle, value) if left else Dip(dip.middle, x, dip.high, value)
    return (
        Dip(x, dip.middle, dip.high, dip.value) if left else Dip(dip.low, dip.middle, x, dip.value)
    )
