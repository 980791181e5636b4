"""Lemmas on any support: they hold, wrong ones are refuted, and numbers agree with their arguments."""

import numpy as np
import pytest
from flint import ctx

from planar_pushing.certified.balls import PRECISION
from planar_pushing.evidence.claims.proofs import any_support
from planar_pushing.evidence.claims.proofs import identities as ids
from planar_pushing.evidence.claims.proofs.verdicts import Verdict

LEMMAS = [
    *(any_support.power, any_support.monotone, any_support.reversal, any_support.mirror),
    any_support.spread,
]


@pytest.fixture(autouse=True)
def _precision():
    with ctx.workprec(PRECISION):
        yield


@pytest.mark.parametrize("lemma", LEMMAS, ids=lambda lemma: lemma.__name__)
def test_lemmas_hold(lemma):
    assert lemma().verdict is Verdict.PROVED


@pytest.mark.parametrize(
    ("slide", "lemmas"),
    [
        ((ids.a + ids.k * any_support.POINT[1], ids.b + ids.k * any_support.POINT[0]), (0, 1)),
        ((ids.a - any_support.POINT[1], ids.b + any_support.POINT[0]), (0, 1, 2, 3)),
    ],
    ids=["not a rotation", "not of the motion"],
)
def test_lemmas_of_a_wrong_motion_are_refuted(monkeypatch, slide, lemmas):
    monkeypatch.setattr(any_support, "SLIDE", slide)
    for i in lemmas:
        assert LEMMAS[i]().verdict is Verdict.REFUTED


def test_what_is_left_at_each_point_of_the_bound_is_not_negative():
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
