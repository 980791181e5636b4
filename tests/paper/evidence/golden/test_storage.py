"""Numbers in a double and a byte: what is read contains the ball and what roundings allow."""

import math

import numpy as np
import pytest
from flint import arb, ctx

from pulling_by_pushing.evidence.golden.enclosures import EXACT, radii
from pulling_by_pushing.evidence.golden.grid import LARGEST_EXPONENT, store
from pulling_by_pushing.oracle.balls import ROUNDINGS, UNIT, Number, Undecided, precise

NOTHING = arb(0)


def enclosure(number):
    middle, exponent = store(number)
    with ctx.workprec(800):
        return arb(middle, float(radii(np.array(exponent, np.int8))))


@pytest.mark.parametrize("size", [1e-30, 1e-17, 0.3, 1.0, 7.5, 1e16])
@pytest.mark.parametrize("rounding", [0, 1, 1000])
@precise
def test_the_stored_radius_is_what_roundings_allow(size, rounding):
    ball = arb(size) / 3 * arb.pi() + arb(0, size * 1e-40)
    number = Number(ball, rounding * arb(size))
    radius = enclosure(number)
    assert radius.contains(ball + number.allowance)
    assert radius.contains(ball - number.allowance)
    allowed = float(ROUNDINGS * UNIT) * rounding * size
    assert radius.rad() <= max(2 * (2.0**-52 * size + allowed), 2.0**-126)


def test_exact_numbers_have_no_radius():
    assert store(0.5) == (0.5, EXACT)
    assert store(True) == (True, EXACT)
    assert store(Number(arb(0.5), NOTHING)) == (0.5, EXACT)
    assert radii(np.array([EXACT], np.int8))[0] == 0


def test_a_zero_by_symmetry_is_zero():
    middle, exponent = store(Number(arb(1e-60, 1e-50), NOTHING))
    assert middle == 0
    assert exponent < -100


def test_an_infinite_number_has_the_size_from_which_on_others_are_infinite_too():
    assert store(Number(arb.pos_inf(), NOTHING)) == (math.inf, EXACT)
    assert store(Number(arb.neg_inf(), arb(1e15))) == (-math.inf, 49)


def test_a_number_that_roundings_do_not_determine_may_be_any():
    assert store(Number(arb(1), arb.pos_inf())) == (1.0, LARGEST_EXPONENT)


def test_a_wide_ball_is_refused():
    with pytest.raises(Undecided, match="too wide"):
        store(Number(arb(1, 1e-9), NOTHING))


@pytest.mark.parametrize("number", [Number(arb.nan(), NOTHING), Number(arb(1), arb.nan())])
def test_a_number_without_an_enclosure_or_a_condition_is_refused(number):
    with pytest.raises(Undecided, match="no enclosure"):
        store(number)
