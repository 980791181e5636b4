"""The ring's wrench and its inverse on whole arrays: 4 ulp everywhere, in blocks of any shape."""

import numpy as np
import pytest
from flint import arb, ctx

from planar_pushing.certified import ring
from planar_pushing.mechanics.effects.ring_inverse import ring_spin_ratio
from planar_pushing.mechanics.effects.ring_profile import BLOCK, NEAR_RING, ring_profile

LONG = np.longdouble
HALF_PI = LONG("1.57079632679489661923132169163975144")
RANDOM = np.random.default_rng(1)
BITS = 200

longer = pytest.mark.skipif(
    np.finfo(LONG).eps > 2e-19, reason="the platform has no floating point longer than double"
)


def long_profile(k):
    """f and t by the arithmetic-geometric mean (DLMF 19.8(i)) in extended precision, k > 0, not 1."""
    k = k.astype(LONG)
    outside = k > 1
    inner = np.where(outside, 1 / k, k)
    m, x = inner * inner, np.abs(1 - k) * (1 + k) * (inner / k)
    mean, root = (1 + np.sqrt(x)) / 2, np.sqrt(np.sqrt(x))
    gap = m / (16 * mean * mean)
    total, weight = gap, 1
    for _ in range(9):
        mean, root = (mean + root) / 2, np.sqrt(mean * root)
        gap, weight = m * (gap / (4 * mean)) ** 2, 2 * weight
        total = total + weight * gap
    first = HALF_PI / mean
    torque = inner * first * (LONG(0.5) - total) / HALF_PI
    force = x * first / HALF_PI + inner * torque
    return np.where(outside, torque, force), np.where(outside, force, torque)


def long_ulps(value, exact):
    unit = np.spacing(np.abs(exact.astype(float))).astype(LONG)
    return float((np.abs(value - exact) / unit).max())


def certified_ulps(value, exact):
    with ctx.workprec(BITS):
        return abs(float((arb(float(value)) - exact) / arb(float(np.spacing(abs(float(exact)))))))


def neighbours(center, count):
    return center * (1 + np.arange(-count, count + 1) * np.finfo(float).eps)


ADVERSARIAL = np.concatenate(
    [
        *(neighbours(center, 20) for center in (NEAR_RING, 1.0, 1 / NEAR_RING)),
        1 - 10 ** RANDOM.uniform(-16, -1, 200),
        1 + 10 ** RANDOM.uniform(-15, -1, 200),
        10 ** RANDOM.uniform(-300, 300, 200),
        [5e-324, 2.0**-1022, 1e308, np.finfo(float).max],
    ]
)


def test_wrench_to_4_ulp_against_certified_values():
    force, torque = ring_profile(ADVERSARIAL)
    with ctx.workprec(BITS):
        exact = [ring.profile(arb(float(k))) for k in ADVERSARIAL]
    assert max(certified_ulps(f, e[0]) for f, e in zip(force, exact, strict=True)) <= 4
    assert max(certified_ulps(t, e[1]) for t, e in zip(torque, exact, strict=True)) <= 4


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
    for values, part in zip(long_profile(k), (0, 1), strict=True):
        for each, value in zip(k, values, strict=True):
            with ctx.workprec(BITS):
                high = float(value)
                exact = ring.profile(arb(float(each)))[part]
                gap = arb(high) + arb(float(value - LONG(high))) - exact
                assert abs(float(gap)) <= 0.02 * np.spacing(high)


@pytest.mark.parametrize("shape", [(), (0,), (1,), (3, 2), (BLOCK + 7,)])
def test_blocks_and_shapes_leave_the_values_alone(shape):
    k = RANDOM.normal(size=shape) * 2
    force, torque = ring_profile(k)
    assert force.shape == torque.shape == ring_spin_ratio(k).shape == shape
    for index in list(np.ndindex(shape))[:: max(1, k.size // 20)]:
        one = ring_profile(k[index])
        assert (force[index], torque[index]) == (one[0][()], one[1][()])
        assert ring_spin_ratio(k)[index] == ring_spin_ratio(k[index])[()]


def test_no_number_stays_none():
    k = np.array([np.nan, 0.5])
    for values in (*ring_profile(k), ring_spin_ratio(k)):
        assert np.array_equal(np.isnan(values), [True, False])


def test_inverse_brings_the_spin_ratio_back_on_whole_arrays():
    """Away from k = 1, where H is too steep for its double to name k."""
    k = np.concatenate([RANDOM.uniform(0, 0.999, 50_000), RANDOM.uniform(1.001, 50, 50_000)])
    force, torque = ring_profile(k)
    assert np.abs(ring_spin_ratio(torque / force) / k - 1).max() <= 24 * np.finfo(float).eps
