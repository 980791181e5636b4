"""The bound of the seven cases, also where a line of force along the fence is tangent to the ring."""

import math

import pytest
from flint import arb, ctx, fmpq
from oracle.sliders import BOTH, slider

import planar_pushing as pp
from pulling_by_pushing.oracle.balls import PRECISION
from pulling_by_pushing.oracle.bounds import conservative_cone


@pytest.fixture(autouse=True)
def _precision():
    with ctx.workprec(PRECISION):
        yield


@pytest.mark.parametrize("length", [0.0, 0.5, 1.0, 2.0, 5.0])
@pytest.mark.parametrize("rod_angle", [30, 45, 90, 137, 150])
def test_the_cone_is_that_of_the_library(length, rod_angle):
    rod = pp.Slider(rod_length=length, rod_angle=math.radians(rod_angle))
    effects = pp.RingFriction(), pp.Inertia()
    cone = pp.conservative_motion_cone(
        pp.Scene(slider=rod, contact=pp.InfiniteFriction(), effects=effects)
    )
    edges = conservative_cone(slider(length, rod_angle, BOTH), fmpq(1))
    for number, edge in zip(edges, (cone.right, cone.left), strict=True):
        assert abs(number.ball - math.degrees(edge)) < number.allowance + arb(edge) * 1e-14 + 1e-13


def test_a_tangent_along_the_fence_has_one_side():
    """l = 2, psi = 30 degrees: the bound jumps by 41 degrees next to it."""
    right, left = conservative_cone(slider(2, 30, BOTH), fmpq(1))
    assert float(left.ball) == pytest.approx(139.1066053508691)
    assert float(right.ball) == pytest.approx(-40.893394649130915)
