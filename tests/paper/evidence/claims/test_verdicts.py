"""Evidence from balls: claims that hold, that are refuted, and neither."""

import pytest
from evidence.claims.ledgers import judged, ledger
from flint import arb, ctx

from pulling_by_pushing.evidence.claims.table import rows
from pulling_by_pushing.evidence.proofs import identities as ids
from pulling_by_pushing.evidence.proofs.boxes import Cover
from pulling_by_pushing.evidence.proofs.verdicts import (
    Verdict,
    equal,
    facts,
    identity,
    inequality,
    near,
    together,
)
from pulling_by_pushing.oracle.balls import PRECISION


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
    found = inequality(margin)
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
    assert near(arb(1.5, radius), claimed, 1e-5).verdict is verdict


def test_an_exact_number_needs_more_than_a_ball_that_contains_it():
    assert equal(arb(2), 2.0).verdict is Verdict.PROVED
    assert equal(arb(2, 1e-30), 2.0).verdict is Verdict.UNDECIDED
    assert equal(arb(2, 1e-30), 3.0).verdict is Verdict.REFUTED


def test_identities():
    assert identity({"1": ids.normal(ids.s**2 + ids.c**2 - 1)}).verdict is Verdict.PROVED
    wrong = identity({"sum": ids.normal(ids.s**2 + ids.c - 1)})
    assert wrong.verdict is Verdict.REFUTED
    assert wrong.reason == "sum is off by -c^2 + c"


def test_facts_name_what_fails():
    assert facts({"one": True, "two": False}).reason == "false: two"


@pytest.mark.parametrize("kind", [Verdict.PROVED, Verdict.ENCLOSED, Verdict.SAMPLED])
def test_a_verdict_is_no_stronger_than_the_kind_of_its_check(kind):
    good, unknown, bad = (inequality(arb(x, r)) for x, r in ((1, 0), (0, 1), (-1, 0)))
    assert good.at_most(kind).verdict is kind
    assert unknown.at_most(kind).verdict is Verdict.UNDECIDED
    assert bad.at_most(kind).verdict is Verdict.REFUTED


def test_the_weakest_verdict_decides():
    good, unknown, bad = (inequality(arb(x, r)) for x, r in ((1, 0), (0, 1), (-1, 0)))
    some = good.at_most(Verdict.SAMPLED)
    assert together(good, some).verdict is Verdict.SAMPLED
    assert together(good, some, unknown).verdict is Verdict.UNDECIDED
    found = together(good, bad, unknown)
    assert found.verdict is Verdict.REFUTED
    assert found.reason == bad.reason
    assert found.margin == good.margin
    assert together(good, some).points == 2


def test_evidence_says_by_which_means_a_program_checks():
    cover = Cover(arb(1), 3).evidence()
    parts = together(cover, identity({"zero": ids.k - ids.k}), facts({"so": True}))
    assert parts.means == ("identities", "exact facts", "an interval cover")
    assert inequality(arb(1)).means == ("inequalities",)


@pytest.mark.parametrize(
    ("claim", "means"),
    [
        ("ring-is-self-dual", "identities, inequalities"),
        ("motion-of-the-ellipsoid", "identities, inequalities, an interval cover"),
        ("pulls-where-it-slips", "identities, exact facts"),
    ],
)
def test_the_ledger_says_which_of_them(claim, means):
    (row,) = (row for row in rows(ledger(), judged()) if row["id"] == claim)
    assert [check["means"] for check in row["checks"]] == [means] * len(row["checks"])


def test_every_proof_of_the_ledger_is_checked_by_some_means():
    for row in rows(ledger(), judged()):
        assert all(check["means"] for check in row["checks"]), row["id"]
