"""Roots in brackets against ones that are known, and against SciPy's."""

from __future__ import annotations

from math import inf, log, sin, sqrt
from typing import NamedTuple

import numba
import numpy as np
import pytest
from scipy.optimize import elementwise

from planar_pushing.mechanics.compiled import compiled, kernel
from planar_pushing.mechanics.numerics.root import EQUATIONS, STEPS, excess, root

RATIOS = 10.0 ** np.random.default_rng(8).uniform(-8, 8, 1000)


class Power(NamedTuple):
    """``(x / r)^p - 1``."""

    scale: float
    power: float


class Kepler(NamedTuple):
    """``x - e sin x - M``."""

    eccentricity: float
    anomaly: float


class Jump(NamedTuple):
    """A step of the value, and a slope that says nothing of it."""

    place: float
    below: float
    above: float
    slope: float


class Kink(NamedTuple):
    """Slope 1 below a place, another above it."""

    place: float
    steepness: float


class Cusp(NamedTuple):
    """The signed square root of the distance, whose slope is infinite at its root."""

    place: float


class Tangent(NamedTuple):
    """``g (1 - log |g|)`` of the distance g: like the ring's torque next to k = 1."""

    place: float


class Line(NamedTuple):
    """A straight line that writes down where it is evaluated."""

    place: float
    slope: float
    seen: np.ndarray


@compiled
def power(of, x):
    value = (x / of.scale) ** of.power
    return value - 1.0, of.power * value / x


@compiled
def kepler(of, x):
    return x - of.eccentricity * sin(x) - of.anomaly, 1.0 - of.eccentricity * np.cos(x)


@compiled
def jump(of, x):
    return (of.below if x < of.place else of.above), of.slope


@compiled
def kink(of, x):
    steep = 1.0 if x < of.place else of.steepness
    return (x - of.place) * steep, steep


@compiled
def cusp(of, x):
    gap = x - of.place
    size = sqrt(abs(gap))
    return (size if gap > 0.0 else -size), (0.5 / size if size > 0.0 else inf)


@compiled
def tangent(of, x):
    gap = x - of.place
    if gap == 0.0:
        return 0.0, inf
    return gap * (1.0 - log(abs(gap))), -log(abs(gap))


@compiled
def line(of, x):
    count = int(of.seen[0]) + 1
    of.seen[0], of.seen[count] = count, x
    return of.slope * (x - of.place), of.slope


EQUATIONS.update({Power: power, Kepler: kepler, Jump: jump, Kink: kink, Cusp: cusp, Line: line})
EQUATIONS[Tangent] = tangent


@kernel
@compiled
def roots_of_powers(scales, exponent, found, sure):
    for i in range(len(scales)):
        found[i], sure[i] = root(Power(scales[i], exponent), 1e-9, 1e9, 1.0)


@kernel
@compiled
def roots_of_kepler(eccentricities, found, sure):
    for i in range(len(eccentricities)):
        found[i], sure[i] = root(Kepler(eccentricities[i], 0.3), 0.0, np.pi, 1.0)


@kernel
@compiled
def solved(equation, low, high, start):
    return root(equation, low, high, start)


def ulps(value, exact):
    return np.max(np.abs(value - exact) / np.spacing(np.abs(exact)))


@pytest.mark.parametrize("exponent", [0.2, 1.0, 3.0, 9.0])
def test_roots_of_powers_over_sixteen_decades(exponent):
    found, sure = np.empty(RATIOS.shape), np.empty(RATIOS.shape, bool)
    roots_of_powers(RATIOS, exponent, found, sure)
    assert sure.all()
    assert ulps(found, RATIOS) <= 4 + 2 / exponent


def test_roots_agree_with_scipy_where_a_function_is_steep_or_flat():
    e = np.append(np.linspace(0, 0.999, 500), 1 - 10.0 ** -np.arange(4.0, 16.0))
    found, sure = np.empty(e.shape), np.empty(e.shape, bool)
    roots_of_kepler(e, found, sure)
    bracket = np.zeros(e.shape), np.full(e.shape, np.pi)
    theirs = elementwise.find_root(lambda x, e: x - e * np.sin(x) - 0.3, bracket, args=(e,)).x
    np.testing.assert_allclose(found, theirs, rtol=2e-15)
    assert sure.all()


@pytest.mark.parametrize("place", [1e-9, 0.3, 1.0, 7.0, 1e6])
@pytest.mark.parametrize("steepness", [1e-6, 0.1, 30.0, 1e9])
def test_a_kink_at_the_root(place, steepness):
    found, sure = solved(Kink(place, steepness), 1e-10, 1e7, 2.0)
    assert sure
    assert found == pytest.approx(place, rel=1e-15, abs=0)


@pytest.mark.parametrize("place", [1e-9, 0.3, 1.0, 7.0])
@pytest.mark.parametrize("start", [1e-9, 2.0, 9.0])
def test_an_infinite_slope_at_the_root(place, start):
    found, sure = solved(Cusp(place), 1e-10, 1e2, start)
    assert sure
    assert found == pytest.approx(place, rel=1e-15, abs=0)


@pytest.mark.parametrize("place", [1.0, 0.7, 2.3])
def test_steps_that_shrink_slowly_beside_a_logarithm_go_on_to_the_last_places(place):
    """The first step below 1e-12 may leave two hundred units in the last place."""
    for start in place + 0.4 * np.random.default_rng(1).uniform(-1, 1, 40):
        found, sure = solved(Tangent(place), place - 0.45, place + 0.45, float(start))
        assert sure
        assert abs(found - place) <= 8 * np.spacing(place)


@pytest.mark.parametrize("slope", [1e-9, 1.0, inf, -1.0, 0.0])
@pytest.mark.parametrize(("low", "high"), [(0.0, 2.0), (1e-9, 1e9), (0.4999, 0.5001), (-3.0, 1.0)])
def test_a_jump_is_enclosed_whatever_the_slope_says(low, high, slope):
    found, sure = solved(Jump(0.5, -1.0, 1.0, slope), low, high, (low + high) / 2)
    assert sure
    assert found == pytest.approx(0.5, rel=1e-15, abs=0)


@pytest.mark.parametrize("start", [1.0, 2.0, 3.0])
@pytest.mark.parametrize("place", [1.0, 3.0])
def test_a_root_at_an_end_of_the_bracket_is_found(place, start):
    found, sure = solved(Line(place, 1.0, np.zeros(STEPS + 9)), 1.0, 3.0, start)
    assert sure
    assert found == pytest.approx(place, rel=1e-15, abs=0)


@pytest.mark.parametrize("start", [1.0, 2.0, 3.0])
@pytest.mark.parametrize(("place", "end"), [(0.5, 1.0), (3.5, 3.0), (-1e9, 1.0), (1e9, 3.0)])
def test_a_bracket_without_a_change_of_sign_says_so_and_gives_the_nearer_end(place, end, start):
    found, sure = solved(Line(place, 1.0, np.zeros(STEPS + 9)), 1.0, 3.0, start)
    assert not sure
    assert found == pytest.approx(end, rel=1e-15, abs=0)


@pytest.mark.parametrize(("below", "above"), [(1.0, 1.0), (-1.0, -1.0)])
def test_a_value_of_one_sign_is_no_root(below, above):
    assert not solved(Jump(2.0, below, above, 1.0), 1.0, 3.0, 1.5)[1]


def test_steps_stay_in_the_bracket_and_are_few():
    seen = np.zeros(STEPS + 9)
    found, _ = solved(Line(2.5, 1.0, seen), 1.0, 3.0, 1.2)
    assert found == 2.5
    assert 1 <= seen[0] <= 3
    assert np.all((seen[1 : int(seen[0]) + 1] >= 1.0) & (seen[1 : int(seen[0]) + 1] <= 3.0))


@pytest.mark.parametrize(("low", "high"), [(1e-300, 1e300), (1e-12, 1e12)])
def test_a_bracket_that_spans_sizes_is_halved_in_sizes(low, high):
    """Until Newton's steps stay in it: where the bracket is far above the root they are all rounding."""
    place, seen = low * 1e3, np.zeros(STEPS + 9)
    found, sure = solved(Line(place, 1.0, seen), low, high, 1.0)
    assert sure
    assert found == pytest.approx(place, rel=1e-15, abs=0)
    assert seen[0] <= 8


def test_an_equation_is_evaluated_in_both_modes():
    assert excess(Power(2.0, 3.0), 2.0) == (0.0, 1.5)
    assert hasattr(solved, "py_func") != numba.config.DISABLE_JIT
