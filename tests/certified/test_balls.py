"""Signs that are never guessed, and numbers stored as two doubles and a radius."""

import pytest
from flint import arb, ctx, fmpq

from planar_pushing.certified.balls import (
    PRECISION,
    Undecided,
    exact_cosine,
    exact_sine,
    fold,
    rational,
    sign,
)
from planar_pushing.certified.roots import increasing_root


@pytest.fixture(autouse=True)
def _precision():
    with ctx.workprec(PRECISION):
        yield


def test_sign_of_balls():
    assert [sign(arb(x)) for x in (-2, 0, 3)] == [-1, 0, 1]
    with pytest.raises(Undecided):
        sign(arb(0, 1e-30))


def test_a_tie_is_settled_by_exact_arithmetic_only():
    tie, near = arb(0, 1e-30), arb(1e-40, 1e-30)
    assert sign(tie, lambda: exact_sine(fmpq(30)) - fmpq(1, 2)) == 0
    with pytest.raises(Undecided):
        sign(near, lambda: exact_sine(fmpq(30)) - exact_sine(fmpq(31)))


def test_exact_trigonometry_of_degrees():
    for degrees in (fmpq(15), fmpq(45, 2), fmpq(-170), fmpq(359)):
        c, s = exact_cosine(degrees), exact_sine(degrees)
        assert sign(arb(0, 1), lambda c=c, s=s: c * c + s * s - 1) == 0
    with pytest.raises(Undecided, match="half a degree"):
        exact_cosine(fmpq(1, 7))


def test_folded_angles_share_their_sine():
    assert [fold(fmpq(d)) for d in (0, 45, 135, -45, 225, 360, -90)] == [0, 45, 45, 45, 45, 0, 90]


def test_doubles_are_taken_as_exact():
    assert rational(0.1) != fmpq(1, 10)
    assert float(rational(0.1).p) / float(rational(0.1).q) == 0.1


@pytest.mark.parametrize("root", [1e-9, 0.5, 1.0, 1.9])
def test_roots_are_enclosed(root):
    found = increasing_root(lambda x: (x - arb(root)) * (1 + x * x), arb(0), arb(2))
    assert found.contains(arb(root))
    assert found.rad() <= arb(2) ** -120 * root


def test_no_root_without_a_change_of_sign():
    with pytest.raises(Undecided, match="no change of sign"):
        increasing_root(lambda x: x + 1, arb(0), arb(1))
