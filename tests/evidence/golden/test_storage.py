"""Balls in a double and a byte: the enclosure that is read holds the ball."""

import math

import numpy as np
import pytest
from flint import arb, ctx

from planar_pushing.certified.balls import Undecided, precise
from planar_pushing.certified.storage import EXACT, stored
from planar_pushing.evidence.golden.enclosures import apart, radii


def enclosure(ball):
    middle, exponent = stored(ball)
    with ctx.workprec(800):
        return arb(middle, float(radii(np.array(exponent, np.int8))))


@pytest.mark.parametrize("size", [1e-300, 3e-40, 1e-17, 0.3, 1.0, 7.5, 1e16])
@precise
def test_the_stored_enclosure_holds_the_ball(size):
    ball = arb(size) / 3 * arb.pi() + arb(0, size * 1e-40)
    found = enclosure(ball)
    assert found.contains(ball)
    assert found.rad() <= max(2.0**-52 * size, 2.0**-126)


def test_exact_numbers_have_no_radius():
    assert stored(arb(0.5)) == (0.5, EXACT)
    assert stored(True) == (True, EXACT)
    assert radii(np.array([EXACT], np.int8))[0] == 0


def test_a_zero_by_symmetry_is_zero():
    middle, exponent = stored(arb(1e-60, 1e-50))
    assert middle == 0
    assert exponent < -100


def test_what_is_not_finite_is_stored_as_it_is():
    assert stored(arb.pos_inf())[0] == math.inf
    assert math.isnan(stored(arb.nan())[0])


def test_a_wide_ball_is_refused():
    with pytest.raises(Undecided, match="too wide"):
        stored(arb(1, 1e-9))


def test_enclosures_that_overlap_are_not_apart():
    one, other = np.array([1.0, np.inf, np.nan, 1.0]), np.array([1.5, np.inf, np.nan, 1.5])
    wide, narrow = np.full(4, 0.3), np.full(4, 0.1)
    assert apart(one, wide, other, wide).tolist() == [False] * 4
    assert apart(one, wide, other, narrow).tolist() == [True, False, False, True]
