"""The ring's wrench, its slope and its inverse: 4 ulp everywhere, in arrays of any shape."""

from __future__ import annotations

import numpy as np
import pytest
from mpmath import mp, mpf

import reference
from planar_pushing.core.supports.ring import (
    NEAR_ARM,
    NEAR_RING,
    SMALL_ARM,
    inner_ring,
    ring_response,
    ring_spin_ratio,
)
from planar_pushing.mechanics.force.wrench import ring_profile, ring_spin_ratios
from planar_pushing.mechanics.kernels.arrays import BLOCK

LONG = np.longdouble
HALF_PI = LONG("1.57079632679489661923132169163975144")
RANDOM = np.random.default_rng(1)
EPS = np.finfo(float).eps

longer = pytest.mark.skipif(
    np.finfo(LONG).eps > 2e-19, reason="the platform has no floating point longer than double"
)


def neighbors(center, count):
    return center * (1 + np.arange(-count, count + 1) * EPS)


#: Spin ratios in (0, 1] where branches meet, next to the ring and far from it.
INNER = np.minimum(
    np.concatenate(
        [
            neighbors(NEAR_RING, 12),
            neighbors(1.0, 12)[:13],
            1 - 10 ** RANDOM.uniform(-16, -1, 60),
            10 ** RANDOM.uniform(-150, 0, 60),
            RANDOM.uniform(0, 1, 200),
            [2.0**-1022, 1e-160, 1e-9, 1e-8, 0.1, 0.5, 0.7],
        ]
    ),
    1.0,
)
ADVERSARIAL = np.concatenate([INNER, 1 / INNER, neighbors(1.0, 12), [1e160, 1e300]])
#: Moment arms likewise, in (0, 1].
ARMS = np.minimum(
    np.concatenate(
        [
            neighbors(NEAR_ARM, 6),
            neighbors(SMALL_ARM, 6),
            neighbors(1.0, 6)[:7],
            1 - 10 ** RANDOM.uniform(-16, -1, 40),
            10 ** RANDOM.uniform(-12, 0, 40),
            RANDOM.uniform(0, 1, 100),
            [1e-300, 1e-12, 1e-8, 1e-3, 0.3, 0.9],
        ]
    ),
    1.0,
)


def ulps(value, exact):
    return float(abs(mpf(float(value)) - exact) / mpf(np.spacing(abs(float(exact)))))


def exact_slope(k):
    """``t' = (2/pi) (K - E) / k^2``; its series where that cancels."""
    if k < mpf("1e-6"):
        return mp.hyp2f1(1.5, 0.5, 2, k**2) / 2
    return 2 / mp.pi * (mp.ellipk(k**2) - mp.ellipe(k**2)) / k**2


def test_wrench_inside_the_ring_to_4_ulp_and_its_slope_to_6():
    """Eqs. (2)-(3) in 60 digits; next to the ring K and E are two terms of the slope."""
    with mp.workdps(60):
        for k in map(float, INNER):
            force, torque, slope = inner_ring(k, 1.0)
            assert ulps(force, reference.ring_force(k)) <= 4, k
            assert ulps(torque, reference.ring_torque(k)) <= 4, k
            assert k == 1 or ulps(slope, exact_slope(mpf(k))) <= 6, k


def test_wrench_to_4_ulp_of_both_signs():
    """Eqs. (2)-(3) in 60 digits; a quotient of two doubles is rounded before it is used."""
    with mp.workdps(60):
        for k in map(float, ADVERSARIAL):
            force, torque = ring_response(1.0, k)[:2]
            assert ulps(force, reference.ring_force(k)) <= 4, k
            assert ulps(torque, reference.ring_torque(k)) <= 4, k
            assert ring_response(1.0, -k)[:2] == (force, -torque)


@pytest.mark.parametrize("size", [1e-300, 1e-160, 1e-3, 40.0, 1e200])
def test_wrench_depends_on_the_ratio_and_its_derivatives_on_the_size(size):
    for k in (0.0, 0.3, 0.95, 1.0, 1.1, 30.0, -0.95, -1.1):
        found = ring_response(1.0, k)
        scaled = ring_response(size, size * k)
        assert scaled[:2] == pytest.approx(found[:2], rel=4 * EPS, abs=0)
        assert np.array(scaled[2:]) * size == pytest.approx(found[2:], rel=1e-13, abs=0)


@pytest.mark.parametrize("spin", [-3.0, -1.6, -1.4, -0.4, 0.4, 1.4, 1.6, 3.0])
def test_derivatives_are_those_of_force_and_torque(spin):
    step, speed = 1e-5, 1.5
    force, torque, vv, vs, ss = ring_response(speed, spin)
    for turn, exact in (((1, 0), (vv, vs)), ((0, 1), (vs, ss))):
        before, after = (
            ring_response(speed + side * turn[0], spin + side * turn[1]) for side in (-step, step)
        )
        slopes = (np.array(after[:2]) - before[:2]) / (2 * step)
        assert slopes == pytest.approx(exact, rel=1e-8)
    assert vv * speed + vs * spin == pytest.approx(0.0, abs=1e-15)
    assert vs * speed + ss * spin == pytest.approx(0.0, abs=1e-15)
    assert force > 0
    assert torque * spin > 0


def test_the_ends():
    assert ring_response(2.0, 0.0)[:2] == (1.0, 0.0)
    assert ring_response(0.0, 2.0)[:2] == (0.0, 1.0)
    assert ring_response(0.0, -2.0)[:2] == (0.0, -1.0)
    assert ring_response(1.0, 1.0)[:2] == pytest.approx([2 / np.pi, 2 / np.pi], rel=2 * EPS, abs=0)
    # The slope is infinite on the ring; what is returned is that of the next double.
    beside = ring_response(1.0, 1.0 - EPS / 2)
    assert ring_response(1.0, 1.0)[2:] == pytest.approx(beside[2:], rel=0.05)
    assert all(abs(each) > 10 for each in beside[2:])
    force, torque = ring_profile([0.0, np.inf, -np.inf])
    assert np.array_equal(force, [1.0, 0.0, 0.0])
    assert np.array_equal(torque, [0.0, 1.0, -1.0])


@pytest.mark.parametrize("found", [ring_spin_ratio, ring_spin_ratios])
def test_inverse_to_4_ulp(found):
    """Eq. (7): k from h, against a root in 50 digits; compiled, products and sums are one step."""
    with mp.workdps(50):
        for arm in map(float, ARMS):
            exact = inverse(arm)
            assert ulps(float(found(arm)), exact) <= 4, arm
            if arm not in (0.0, 1.0):
                outside = 1 / arm
                assert ulps(float(found(outside)), 1 / inverse(1 / mpf(outside))) <= 4, arm
                assert found(-arm) == -found(arm)


def inverse(arm):
    """Root of ``t - h f`` in (0, 1], by Newton from the double next to it."""
    arm = mpf(arm)
    if arm in (0, 1):
        return arm
    if arm < mpf("1e-15"):
        return 2 * arm
    low, high = arm, min(2 * arm, mpf(1))
    k = mpf(ring_spin_ratio(float(arm)))
    for _ in range(200):
        excess = reference.ring_torque(k) - arm * reference.ring_force(k)
        low, high = (k, high) if excess < 0 else (low, k)
        new = k - excess / (exact_slope(k) * (1 + arm * k)) if k < 1 else (low + high) / 2
        new = new if low <= new <= high else (low + high) / 2
        if abs(new - k) <= mpf(10) ** -30 * k:
            return new
        k = new
    raise AssertionError("no root")


def test_inverse_at_the_ends():
    assert ring_spin_ratio(0.0) == 0.0
    assert ring_spin_ratio(1.0) == 1.0
    assert ring_spin_ratio(-1.0) == -1.0


def test_inverse_brings_the_spin_ratio_back_on_whole_arrays():
    """Away from k = 1, where H is too steep for its double to name k."""
    k = np.concatenate([RANDOM.uniform(0, 0.999, 50_000), RANDOM.uniform(1.001, 50, 50_000)])
    force, torque = ring_profile(k)
    assert np.abs(ring_spin_ratios(torque / force) / k - 1).max() <= 24 * EPS


def test_the_moment_arm_of_the_inverse_is_the_moment_arm():
    """H is steep next to the ring: there its rounding is that of k, a few times over."""
    arm = np.concatenate([RANDOM.uniform(0, 1, 50_000), 1 - 10 ** RANDOM.uniform(-16, -1, 20_000)])
    force, torque = ring_profile(ring_spin_ratios(arm))
    assert np.abs(torque / force / arm - 1).max() <= 20 * EPS


def long_profile(k):
    """f and t by the arithmetic-geometric mean (DLMF 19.8(i)) in extended precision, k > 0, not 1."""
    k = k.astype(LONG)
    outside = k > 1
    inside = np.where(outside, 1 / k, k)
    m, x = inside * inside, np.abs(1 - k) * (1 + k) * (inside / k)
    mean, root = (1 + np.sqrt(x)) / 2, np.sqrt(np.sqrt(x))
    gap = m / (16 * mean * mean)
    total, weight = gap, 1
    for _ in range(9):
        mean, root = (mean + root) / 2, np.sqrt(mean * root)
        gap, weight = m * (gap / (4 * mean)) ** 2, 2 * weight
        total = total + weight * gap
    first = HALF_PI / mean
    torque = inside * first * (LONG(0.5) - total) / HALF_PI
    force = x * first / HALF_PI + inside * torque
    return np.where(outside, torque, force), np.where(outside, force, torque)


def long_ulps(value, exact):
    unit = np.spacing(np.abs(exact.astype(float))).astype(LONG)
    return float((np.abs(value - exact) / unit).max())


@longer
@pytest.mark.parametrize(("low", "high"), [(0, 0.9), (0.8, 1), (1, 1.25), (0.9, 40), (-3, 3)])
def test_wrench_to_4_ulp_on_100000_random_ratios(low, high):
    """Uniform over an interval; the last one logarithmic over six decades."""
    k = RANDOM.uniform(low, high, 100_000)
    k = 10**k if low < 0 else k
    exact = long_profile(k)
    assert all(long_ulps(a, b) <= 4 for a, b in zip(ring_profile(k), exact, strict=True))


@longer
def test_the_long_reference_is_right_to_a_hundredth_of_an_ulp():
    k = ADVERSARIAL[(ADVERSARIAL != 1) & (ADVERSARIAL > 1e-100) & (ADVERSARIAL < 1e100)][::7]
    with mp.workdps(60):
        for values, exact in zip(
            long_profile(k), (reference.ring_force, reference.ring_torque), strict=True
        ):
            for each, value in zip(map(float, k), values, strict=True):
                high = float(value)
                gap = mpf(high) + mpf(float(value - LONG(high))) - exact(each)
                assert abs(float(gap)) <= 0.02 * np.spacing(high)


@pytest.mark.parametrize("shape", [(), (0,), (1,), (3, 2), (BLOCK + 7,)])
def test_blocks_and_shapes_leave_the_values_alone(shape):
    k = RANDOM.normal(size=shape) * 2
    (force, torque), ratios = ring_profile(k), ring_spin_ratios(k)
    assert force.shape == torque.shape == ratios.shape == shape
    for index in list(np.ndindex(shape))[:: max(1, k.size // 20)]:
        one = ring_profile(k[index])
        assert (force[index], torque[index]) == (one[0][()], one[1][()])
        assert ratios[index] == ring_spin_ratios(k[index])[()]
