"""The inverse: between its pure values, odd in the arm, and exact where it is known."""

import pytest
from flint import arb, ctx, fmpq

from planar_pushing.certified.balls import PRECISION
from planar_pushing.certified.integrals import printed
from planar_pushing.certified.inverse import spin_of_arm, sticking_rotation
from planar_pushing.certified.setting import FRICTION, INERTIA

HALF = fmpq(1, 2)


@pytest.fixture(autouse=True)
def _precision():
    with ctx.workprec(PRECISION):
        yield


@pytest.mark.parametrize("share", [fmpq(1, 100), HALF, fmpq(99, 100)])
@pytest.mark.parametrize("arm", [0.01, 0.9, 1.1, 7.0])
def test_mixed_roots_lie_between_the_pure_ones(share, arm):
    ends = [spin_of_arm(arb(arm), fmpq(1), each) for each in (FRICTION, INERTIA)]
    k = spin_of_arm(arb(arm), fmpq(1), share)
    assert min(ends, key=float) < k < max(ends, key=float)
    force, torque = printed(k.mid())
    residual = (1 - share) * (torque - arm * force) + share * (k.mid() - arm)
    assert abs(residual) < arb(10) ** -28


@pytest.mark.parametrize("share", [FRICTION, HALF, INERTIA])
def test_the_inverse_is_odd_and_vanishes_at_the_center(share):
    arm, gyration = arb(1.75), fmpq(9, 4)
    assert spin_of_arm(arb(0), gyration, share) == 0
    found = spin_of_arm(-arm, gyration, share) + spin_of_arm(arm, gyration, share)
    assert found.contains(0)
    assert found.rad() < arb(10) ** -36


def test_an_arm_of_the_radius_turns_about_the_ring():
    assert spin_of_arm(arb(1), fmpq(9, 4), FRICTION) == 1
    assert spin_of_arm(arb(1), fmpq(1), HALF) == 1


@pytest.mark.parametrize("ratio", [fmpq(0), fmpq(3)])
def test_sticking_leaves_no_torque_about_the_contact(ratio):
    along, aside, length, gyration = arb(0.5), arb(-0.75), fmpq(2), fmpq(9, 4)
    omega = sticking_rotation(along, aside, length, gyration, ratio)
    across = abs(aside) - length * abs(omega)
    speed = (along**2 + across**2).sqrt()
    force, torque = printed((abs(omega) / speed).mid())
    friction = torque - length * across / speed * force
    residual = friction + ratio * (gyration * abs(omega) - length * across)
    assert omega < 0
    assert abs(residual) < arb(10) ** -28
