"""Evidence from balls: proved, refuted, and what is neither."""

import pytest
from flint import arb, ctx

from planar_pushing.certified.balls import PRECISION
from planar_pushing.evidence.claims.proofs import identities as ids
from planar_pushing.evidence.claims.proofs import lemmas, ring_boxes
from planar_pushing.evidence.claims.proofs.cover import cover
from planar_pushing.evidence.claims.proofs.verdicts import (
    Verdict,
    equal,
    facts,
    identity,
    inequality,
    near,
    on_grid,
    together,
)


@pytest.fixture(autouse=True)
def _precision():
    with ctx.workprec(PRECISION):
        yield


@pytest.mark.parametrize(
    ("margin", "verdict"),
    [
        (arb(1, 0.5), Verdict.PROVED),
        (arb(-1, 0.5), Verdict.REFUTED),
        (arb(1, 2), Verdict.UNDECIDED),
        (arb(0), Verdict.UNDECIDED),
        (arb.nan(), Verdict.UNDECIDED),
    ],
)
def test_inequalities(margin, verdict):
    found = inequality(margin, "balls")
    assert found.verdict is verdict
    assert (found.reason is None) == (verdict is Verdict.PROVED)


@pytest.mark.parametrize(
    ("radius", "claimed", "verdict"),
    [
        (1e-9, 1.5, Verdict.PROVED),
        (1e-9, 1.5001, Verdict.REFUTED),
        (1e-3, 1.5, Verdict.UNDECIDED),
    ],
)
def test_numbers_are_held_to_their_accuracy(radius, claimed, verdict):
    assert near(arb(1.5, radius), claimed, 1e-5, "balls").verdict is verdict


def test_an_exact_number_needs_more_than_a_ball_that_contains_it():
    assert equal(arb(2), 2.0, "balls").verdict is Verdict.PROVED
    assert equal(arb(2, 1e-30), 2.0, "balls").verdict is Verdict.UNDECIDED
    assert equal(arb(2, 1e-30), 3.0, "balls").verdict is Verdict.REFUTED


def test_identities():
    assert identity({"1": ids.normal(ids.s**2 + ids.c**2 - 1)}, "exact").verdict is Verdict.PROVED
    wrong = identity({"sum": ids.normal(ids.s**2 + ids.c - 1)}, "exact")
    assert wrong.verdict is Verdict.REFUTED
    assert wrong.reason == "sum is off by -c^2 + c"


def test_facts_and_grids_name_what_fails():
    assert facts({"one": True, "two": False}, "").reason == "not so: two"
    assert on_grid([], 5, "").verdict is Verdict.VERIFIED
    assert on_grid(["l = 1"], 5, "").reason == "fails at 1 points, first l = 1"


def test_the_weakest_verdict_decides():
    good, open_one, bad = (inequality(arb(x, r), "") for x, r in ((1, 0), (0, 1), (-1, 0)))
    grid = on_grid([], 5, "")
    assert together(good, grid).verdict is Verdict.VERIFIED
    assert together(good, grid, open_one).verdict is Verdict.UNDECIDED
    found = together(good, bad, open_one)
    assert found.verdict is Verdict.REFUTED
    assert found.reason == bad.reason
    assert found.margin == good.margin
    assert together(good, grid).points == 6


def square_less(amount):
    return lambda low, _: low * low - amount


def test_covers_prove_refute_or_stay_open():
    """x^2 on [0.5, 1]: above 0.2, not above 0.3, and 0.25 is reached at an end."""
    low, high = arb(0.5), arb(1)
    assert cover(square_less(0.2), low, high).evidence("").verdict is Verdict.PROVED
    refuted = cover(square_less(0.3), low, high)
    assert refuted.evidence("").verdict is Verdict.REFUTED
    assert refuted.failure**2 < 0.3
    touching = cover(square_less(0.25), low, high, most=200).evidence("")
    assert touching.verdict is Verdict.UNDECIDED
    assert touching.reason == "open after 200 boxes"


@pytest.mark.parametrize("function", [ring_boxes.turn, ring_boxes.loss, ring_boxes.slope])
@pytest.mark.parametrize(("low", "high"), [(0.0, 0.3), (0.3, 0.31), (0.6, 0.999)])
def test_bounds_on_boxes_hold_inside(function, low, high):
    bound = function(arb(low), arb(high))
    for part in (0.0, 0.2, 0.7, 1.0):
        k = arb(low + part * (high - low))
        assert not function(k, k) < bound


def test_the_slope_of_the_arm_against_a_difference_quotient():
    k, step = arb(0.4), arb(2) ** -40
    arms = [
        ring_boxes.turn(each, each) * each / ring_boxes.force(each, each)
        for each in (k - step, k + step)
    ]
    quotient = (arms[1] - arms[0]) / (2 * step)
    assert abs(ring_boxes.arm_slope(k, k) - quotient) < 1e-18


@pytest.mark.parametrize(
    "lemma",
    [
        *(lemmas.rates, lemmas.duality, lemmas.work, lemmas.turning),
        *(lemmas.torque_rate, lemmas.elliptic_rates),
    ],
)
def test_lemmas_hold(lemma):
    assert lemma().verdict is Verdict.PROVED


def test_a_lemma_with_a_wrong_integrand_is_refuted(monkeypatch):
    monkeypatch.setattr(lemmas, "FORCE", 1 + 2 * ids.k * ids.c)
    for lemma in (lemmas.rates, lemmas.duality, lemmas.torque_rate):
        assert lemma().verdict is Verdict.REFUTED
