"""The ring's force and torque: closed forms against the printed integrals, ends, duality, enclosures."""

import pytest
from flint import arb, ctx

from planar_pushing.certified import ring
from planar_pushing.certified.balls import PRECISION
from planar_pushing.certified.integrals import printed

RATIOS = [
    1e-6,
    2**-7,
    2**-6,
    0.1,
    0.3,
    0.5,
    0.9,
    0.99,
    0.9999,
    1 - 1e-12,
    1,
    1 + 1e-12,
    1.0001,
    1.1,
    1.7,
    3,
    10,
    63,
    65,
    1e6,
]


@pytest.fixture(autouse=True)
def _precision():
    with ctx.workprec(PRECISION):
        yield


@pytest.mark.parametrize("k", RATIOS)
def test_closed_forms_overlap_the_printed_integrals(k):
    first, second = ring.profile(arb(k)), printed(arb(k))
    for closed, integral in zip(first, second, strict=True):
        assert closed.overlaps(integral)
        assert closed.rad() < arb(10) ** -40
        assert integral.rad() < arb(10) ** -30


def test_values_on_the_ring_and_in_translation():
    assert all(each.overlaps(2 / arb.pi()) for each in ring.profile(arb(1)))
    assert ring.profile(arb(0)) == (arb(1), arb(0))


@pytest.mark.parametrize("k", [arb(0.3), arb(0.99999), arb(5)])
def test_the_ring_is_self_dual(k):
    (force, torque), (dual_force, dual_torque) = ring.profile(k), ring.profile(1 / k)
    assert force.overlaps(dual_torque)
    assert torque.overlaps(dual_force)


@pytest.mark.parametrize("distance", [-50, -100, -150, -180])
@pytest.mark.parametrize("side", [-1, 1])
def test_accuracy_next_to_the_ring(distance, side):
    """f = t = 2/pi there, and f' = -k t' is of the order of the logarithm of the distance."""
    k = 1 + side * arb(2) ** distance
    force, torque = ring.profile(k)
    assert min(force.rel_accuracy_bits(), torque.rel_accuracy_bits()) >= 150
    gap = (torque - force) / (side * arb(2) ** distance)
    assert 0 < gap < -distance


def test_balls_across_the_ring_are_enclosed():
    force, torque = ring.profile(arb(1, 1e-3))
    for k in (0.9991, 1.0, 1.0009):
        for enclosure, value in zip((force, torque), ring.profile(arb(k)), strict=True):
            assert enclosure.contains(value)
    assert force.rad() < 1e-2


@pytest.mark.parametrize("k", [0.01, 0.4, 0.95, 1.2, 7.0])
def test_slope_against_a_difference_quotient(k):
    step = arb(2) ** -40
    quotient = (ring.profile(k + step)[1] - ring.profile(k - step)[1]) / (2 * step)
    assert abs(ring.slope(arb(k)) - quotient) < 1e-18


@pytest.mark.parametrize(("low", "high"), [(0.2, 0.6), (1.5, 4.0), (0.9, 1.0), (1.0, 1.5)])
def test_bounds_of_the_slope(low, high):
    least, greatest = (
        bound(arb(low), arb(high)) for bound in (ring.least_slope, ring.greatest_slope)
    )
    for part in (0.01, 0.3, 0.7, 0.99):
        assert least <= ring.slope(arb(low + part * (high - low))) <= greatest
    assert greatest.is_finite() == (1.0 not in (low, high))
