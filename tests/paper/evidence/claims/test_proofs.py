"""Lemmas hold, wrong ones are refuted, and the bounds on boxes hold inside."""

import numpy as np
import pytest
from flint import arb, ctx

from pulling_by_pushing.evidence.proofs import boxes, lemmas
from pulling_by_pushing.evidence.proofs import identities as ids
from pulling_by_pushing.evidence.proofs.boxes import cover
from pulling_by_pushing.evidence.proofs.mechanics import profile
from pulling_by_pushing.evidence.proofs.verdicts import Verdict
from pulling_by_pushing.oracle.balls import PRECISION


@pytest.fixture(autouse=True)
def _precision():
    with ctx.workprec(PRECISION):
        yield


def square_less(amount):
    return lambda low, _: low * low - amount


def test_covers_prove_refute_or_stay_open():
    """x^2 on [0.5, 1]: above 0.2, not above 0.3, and 0.25 is reached at an end."""
    low, high = arb(0.5), arb(1)
    assert cover(square_less(0.2), low, high).evidence().verdict is Verdict.PROVED
    refuted = cover(square_less(0.3), low, high)
    assert refuted.evidence().verdict is Verdict.REFUTED
    assert refuted.failure**2 < 0.3
    touching = cover(square_less(0.25), low, high, most=200).evidence()
    assert touching.verdict is Verdict.UNDECIDED
    assert touching.reason == "undecided after 200 boxes"


@pytest.mark.parametrize("function", [boxes.turn, boxes.loss, boxes.slope])
@pytest.mark.parametrize(("low", "high"), [(0.0, 0.3), (0.3, 0.31), (0.6, 0.999)])
def test_bounds_on_boxes_hold_inside(function, low, high):
    bound = function(arb(low), arb(high))
    for part in (0.0, 0.2, 0.7, 1.0):
        k = arb(low + part * (high - low))
        assert not function(k, k) < bound


def test_the_slope_of_the_arm_against_a_difference_quotient():
    k, step = arb(0.4), arb(2) ** -40
    arms = [boxes.turn(each, each) * each / profile(each)[0] for each in (k - step, k + step)]
    quotient = (arms[1] - arms[0]) / (2 * step)
    assert abs(boxes.arm_slope(k, k) - quotient) < 1e-18


LEMMAS = [
    *(lemmas.rates, lemmas.duality, lemmas.work, lemmas.turning, lemmas.inertial_turning),
    *(lemmas.torque_rate, lemmas.elliptic_rates, lemmas.no_sideways_force),
]


@pytest.mark.parametrize("lemma", LEMMAS, ids=lambda lemma: lemma.__name__)
def test_lemmas_hold(lemma):
    assert lemma().verdict is Verdict.PROVED


def test_a_lemma_with_a_wrong_integrand_is_refuted(monkeypatch):
    monkeypatch.setattr(lemmas, "FORCE", 1 + 2 * ids.k * ids.c)
    for lemma in (lemmas.rates, lemmas.duality, lemmas.torque_rate):
        assert lemma().verdict is Verdict.REFUTED


def test_the_term_of_each_point_in_the_bound_is_not_negative():
    """``(a^2 (c - x) - c (r^2 - c x)) / rho >= (c^2 - a^2) x / sqrt(a^2 + c^2)`` within a, for c > a."""
    random = np.random.default_rng(3)
    a, c = 1.0, 1 + 10 ** random.uniform(-6, 3, (1, 1000))
    r, turn = np.sqrt(random.uniform(0, 1, (1000, 1))), random.uniform(0, 2 * np.pi, (1000, 1))
    r[::2] = a
    x, y = r * np.cos(turn), r * np.sin(turn)
    rho = np.hypot(c - x, y)
    taken = (c**2 - a**2) * x / np.hypot(a, c)
    left = (a**2 * (c - x) - c * (r**2 - c * x)) / rho - taken
    assert left.min() > -1e-9 * c.max()


def test_within_the_disc_the_argument_of_the_bound_fails():
    """A ring is a counterexample there, so the lemma must need c > a."""
    a, c = 1.0, 0.5
    turn = np.linspace(0, 2 * np.pi, 2001)[:-1]
    x, y = a * np.cos(turn), a * np.sin(turn)
    rho = np.hypot(c - x, y)
    assert np.mean((a**2 * (c - x) - c * (a**2 - c * x)) / rho) < 0
