"""Roots and minima in brackets against ones that are known, and against SciPy's."""

import numpy as np
import pytest
from planar_pushing.mechanics.roots import bracketed_minimum, bracketed_root
from scipy.optimize import elementwise

RATIOS = 10.0 ** np.random.default_rng(8).uniform(-8, 8, (40, 25))


def ulps(value, exact):
    return np.max(np.abs(value - exact) / np.spacing(np.abs(exact)))


@pytest.mark.parametrize("power", [0.2, 1.0, 3.0, 9.0])
def test_roots_of_powers_over_sixteen_decades(power):
    low, high = np.full(RATIOS.shape, 1e-9), np.full(RATIOS.shape, 1e9)
    found = bracketed_root(lambda x, r: (x / r) ** power - 1, low, high, (RATIOS,))
    assert found.shape == RATIOS.shape
    assert ulps(found, RATIOS) <= 4 + 2 / power


def test_roots_agree_with_scipy_where_a_function_is_steep_or_flat():
    def kepler(x, e):
        return x - e * np.sin(x) - 0.3

    e = np.append(np.linspace(0, 0.999, 500), 1 - 10.0 ** -np.arange(4.0, 16.0))
    low, high = np.zeros(e.shape), np.full(e.shape, np.pi)
    theirs = elementwise.find_root(kepler, (low, high), args=(e,)).x
    np.testing.assert_allclose(bracketed_root(kepler, low, high, (e,)), theirs, rtol=2e-15)


def test_fewer_calls_than_bisection():
    calls = []

    def function(x):
        calls.append(x.size)
        return np.exp(x) - 2

    found = bracketed_root(function, np.zeros(3), np.full(3, 10.0))
    assert ulps(found, np.log(2.0)) <= 4
    assert len(calls) <= 15


def test_what_is_found_is_left_alone():
    seen = []

    def function(x, root):
        seen.append(root)
        return x - root

    bracketed_root(function, np.zeros(2), np.full(2, 10.0), (np.array([5.0, 3.7]),))
    assert [each.tolist() for each in seen[-1:]] == [[3.7]]


def test_brackets_of_any_order_size_and_sign():
    roots = np.array([-1e300, -2.0, -5e-324, 0.0, 5e-324, 1e-200, 1.0, 1e300])
    for low, high in ((-1.5e300, 1.5e300), (1.5e300, -1.5e300)):
        found = bracketed_root(
            lambda x, r: x / 4 - r / 4, np.full(8, low), np.full(8, high), (roots,)
        )
        np.testing.assert_allclose(found, roots, rtol=1e-15, atol=2e-323)


def test_a_root_between_neighbours_takes_no_more_steps_than_bisection():
    calls = []

    def function(x):
        calls.append(x)
        return np.where(x > 0, 1.0, -1.0)

    assert bracketed_root(function, np.array([-1.0]), np.array([1.0])) in (0.0, 5e-324)
    assert len(calls) <= 1100


def test_an_increasing_function_without_a_root_inside_has_an_end():
    ends = np.array([0.0, 1.0]), np.array([3.0, 4.0])
    np.testing.assert_array_equal(bracketed_root(lambda x: x + 1, *ends), ends[0])
    np.testing.assert_array_equal(bracketed_root(lambda x: x - 9, *ends), ends[1])
    np.testing.assert_array_equal(bracketed_root(lambda x: x, *ends), ends[0])
    np.testing.assert_array_equal(bracketed_root(lambda x: x - ends[1], *ends), ends[1])
    np.testing.assert_array_equal(bracketed_root(lambda x: 0 * x, *ends), ends[1])
    # Rounding leaves it negative at its root, the high end, by more than at the low one.
    np.testing.assert_array_equal(
        bracketed_root(lambda x: np.where(x < ends[1], -1e-29, -1e-17), *ends), ends[1]
    )


def test_a_jump_and_a_pole_are_enclosed():
    low, high = np.array([-1.0]), np.array([2.0])
    for function in (lambda x: np.where(x < 0.5, -1.0, 1.0), lambda x: 1 / (x - 0.5)):
        with np.errstate(divide="ignore", invalid="ignore"):
            assert bracketed_root(function, low, high) == pytest.approx(0.5, rel=1e-15)


@pytest.mark.parametrize("place", [0.0, 1e-3, 0.4, 0.999, 1.0])
def test_minima_to_the_square_root_of_the_precision(place):
    found = bracketed_minimum(lambda x: (x - place) ** 2 * (1 + x / 3) - 2, 0.0, 1.0)
    assert found == pytest.approx(place, abs=3e-8)
