"""The coefficients of the ring's series, computed anew in 60 digits."""

from __future__ import annotations

from functools import cache

import pytest
from mpmath import mp, mpf

from planar_pushing.core.supports import ring

DIGITS = 60
#: What an interpolant's error may move in the result.
ERROR = 1e-16
#: The bound of the ranges, as the decimal that it is written as.
NEAR_RING = str(ring.NEAR_RING)


def chebyshev(function, top, degree):
    """Interpolant at the Chebyshev points of [0, top], in powers of its variable."""
    count = degree + 1
    points = [top / 2 * (1 + mp.cos(mp.pi * (2 * j + 1) / (2 * count))) for j in range(count)]
    powers = mp.matrix(count, count)
    for i, point in enumerate(points):
        for j in range(count):
            powers[i, j] = point**j
    return list(mp.lu_solve(powers, mp.matrix([function(point) for point in points])))


def landen_top():
    """The variable q^2 of the Landen step where the other series takes over."""
    complement = mp.sqrt(1 - mpf(NEAR_RING) ** 2)
    return ((1 - complement) / (1 + complement)) ** 2


def first(y):
    """``(Q - 1) / y``."""
    return (mp.hyp2f1(0.5, 0.5, 1, y) - 1) / y


def second(y):
    """``(Q - P) / y^2``; Q and P agree up to y."""
    return (mp.hyp2f1(0.5, 0.5, 1, y) - mp.hyp2f1(-0.5, -0.5, 1, y)) / y**2


@cache
def terms():
    """Coefficients of the four series of `parts`."""
    found, digamma = [], 2 * mp.log(2)
    for n in range(120):
        if n:
            digamma -= 2 / mpf((2 * n - 1) * (2 * n))
        of_k = (mp.rf(mpf(1) / 2, n) / mp.factorial(n)) ** 2
        of_e = mp.rf(mpf(1) / 2, n) * mp.rf(mpf(3) / 2, n) / mp.rf(2, n) / mp.factorial(n) / 2
        rest_of_e = of_e * (digamma - 1 / mpf((2 * n + 1) * (2 * n + 2)))
        found.append([of_e, rest_of_e, of_e - of_k, rest_of_e - of_k * digamma])
    return found


def parts(x):
    """The four series of E and E - x K in x (DLMF 19.12): coefficients of log x / 2 and the rest."""
    sums = [mpf(0)] * 4
    for term in reversed(terms()):
        sums = [total * x + each for total, each in zip(sums, term, strict=True)]
    return sums


NEAR = ["FORCE_LOG", "FORCE_REST", "TORQUE_LOG", "TORQUE_REST"]


@pytest.mark.parametrize("x", ["1e-20", "0.01", "0.19"])
def test_the_series_are_those_of_the_integrals(x):
    with mp.workdps(DIGITS):
        x = mpf(x)
        half = -mp.log(x) / 2
        e, k = mp.ellipe(1 - x), mp.ellipk(1 - x)
        a, b, c, d = parts(x)
        assert abs(1 + x * (half * a + b) - e) < mpf(10) ** -50
        assert abs(1 + x * (half * c + d) - (e - x * k)) < mpf(10) ** -50


#: Of each series the function, the end of its range, and its factor in the result.
SERIES = {
    "FAR_FIRST": (first, landen_top, lambda y: y),
    "FAR_SECOND": (second, landen_top, lambda y: y**2),
}
for _place, _name in enumerate(NEAR):
    SERIES[_name] = (
        lambda x, place=_place: parts(x)[place],
        lambda: 1 - mpf(NEAR_RING) ** 2,
        (lambda x: -x * mp.log(x) / 2) if _name.endswith("LOG") else (lambda x: x),
    )


@pytest.mark.parametrize("name", SERIES)
def test_coefficients_are_those_of_the_interpolant(name):
    function, top, _ = SERIES[name]
    with mp.workdps(DIGITS):
        exact = chebyshev(function, top(), len(getattr(ring, name)) - 1)
        assert [float(each) for each in exact] == list(getattr(ring, name))


@pytest.mark.parametrize("name", SERIES)
def test_interpolants_are_good_enough_for_the_wrench(name):
    function, top, factor = SERIES[name]
    coefficients = [mpf(each) for each in getattr(ring, name)]
    with mp.workdps(DIGITS):
        for i in range(1, 41):
            x = top() * i / 40
            error = sum(c * x**j for j, c in enumerate(coefficients)) - function(x)
            assert abs(error * factor(x)) <= ERROR
