"""Between two places of other signs: the first guess of a slip."""

import pytest

from planar_pushing.mechanics.reduced.pressed.places import Place
from planar_pushing.mechanics.reduced.pressed.sliding import _part

#: The zero of the cubic that a place is of the force across the edge.
ZERO = 0.3


def place(force, side=1.0):
    x = ZERO + 2.0 * force + 0.4 * force**2 + 0.7 * force**3
    slope = 1.0 / (2.0 + 0.8 * force + 2.1 * force**2)
    return Place(side * x, force, side * slope, 0.0, 0.0)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_the_guess_is_exact_for_an_inverse_cubic(side):
    low, high = place(side * -0.5, side), place(side * 0.9, side)
    part = (side * ZERO - low.x) / (high.x - low.x)
    assert _part(low, high) == pytest.approx(part, rel=1e-14, abs=0)


@pytest.mark.parametrize("slope", [0.0, -3.0])
def test_it_is_the_secant_where_a_slope_points_elsewhere(slope):
    one, other = place(-0.5), place(0.9)._replace(slope=slope)
    assert _part(one, other) == pytest.approx(0.5 / 1.4, rel=1e-14, abs=0)
