"""The ledger file: complete, honest in its wording, and clear about its errors."""

import re

import pytest

from evidence.claims.ledgers import LEDGER, entries, judged, ledger
from planar_pushing.evidence.claims.ledger import load_ledger
from planar_pushing.evidence.claims.registry import CHECKS, QUANTITIES
from planar_pushing.evidence.claims.verdicts import Verdict
from planar_pushing.terms.errors import InvalidFile

GOOD = """claims:
  - id: a-claim
    section: "3"
    origin: paper
    statement: A statement.
    expect: enclosed
    checks:
      - {check: friction-integrals, claimed: {cross_term: 2}}
      - {name: edge, number: motion_cone.right, at: {rod_length: 2, friction_coefficient: 2}, below: 0}
      - {name: push, modes: [stick], at: {rod_length: 2, law: 2, pusher_angle: 90}}
"""
#: Words of a statement about more than the instances that it names.
GENERAL = re.compile(r"\b(every|any|all|always|never|whatever)\b")


def of_paper():
    return [claim for claim in ledger().claims if claim.origin == "paper"]


def test_every_formula_section_and_figure_has_an_entry():
    assert {number for claim in of_paper() for number in claim.equations} == set(range(1, 14))
    assert {claim.section for claim in of_paper()} == {"1", "2", "3", "3.1", "3.2", "4", "5"}
    drawn = {number for claim in of_paper() for number in claim.figures}
    assert drawn == set(range(1, 13)) - {1, 4}  # the setting, and the coordinates


def test_the_seven_geometric_facts_are_checked():
    names = [name for claim, name in entries() if claim == "geometric-facts"]
    assert names == ["facts-1-to-3", "fact-4", "facts-5-to-7"]


def test_every_check_and_number_is_used():
    listed = entries().values()
    assert {entry.check for entry in listed} - {None} == set(CHECKS)
    used = {entry.number for entry in listed} - {None}
    assert {name.partition(".")[0] for name in used} == {
        name.partition(".")[0] for name in QUANTITIES
    }


def test_no_statement_and_no_number_twice():
    statements = [claim.statement for claim in ledger().claims]
    assert len(set(statements)) == len(statements)
    numbers = [(entry.number, str(entry.at)) for entry in entries().values() if entry.number]
    assert len(set(numbers)) == len(numbers)


def test_an_entry_that_is_proved_rests_on_no_instance():
    for one in judged():
        if one.verdict is Verdict.PROVED:
            for check in one.checks:
                assert CHECKS[check.entry.check].kind is Verdict.PROVED, one.claim.id
        else:
            kinds = {check.evidence.verdict for check in one.checks}
            assert one.verdict in kinds or one.verdict is Verdict.OPEN


def test_no_statement_of_the_paper_is_only_sampled():
    """The abstract counts those that are proved, enclosed, refuted and open."""
    assert {one.expect for one in ledger().claims if one.origin == "paper"} == {
        "proved", "enclosed", "refuted", "open"
    }  # fmt: skip


def test_a_general_wording_has_a_proof_or_is_called_a_sample():
    for claim in ledger().claims:
        if GENERAL.search(claim.statement) and claim.expect == "enclosed":
            kinds = {CHECKS[entry.check].kind for entry in claim.checks if entry.check}
            assert Verdict.PROVED in kinds, claim.id


def test_a_proof_at_one_rod_length_says_so():
    for claim in ledger().claims:
        for entry in claim.checks:
            if "rod_length" in entry.claimed:
                assert f"l = {entry.claimed['rod_length']:g}" in claim.statement, claim.id


def test_every_proof_is_an_argument():
    for name, check in CHECKS.items():
        if check.kind is Verdict.PROVED:
            assert check.how.count(". ") >= 1, name
            assert check.how.endswith("."), name
    for name, quantity in QUANTITIES.items():
        assert quantity.how.endswith("."), name


def test_wrong_statements_and_undecidable_ones_say_why():
    for claim in ledger().claims:
        assert (claim.expect in ("refuted", "open")) == (claim.reason is not None)


def test_a_good_file_loads(tmp_path):
    path = tmp_path / "claims.yaml"
    path.write_text(GOOD, encoding="utf-8")
    (claim,) = load_ledger(path).claims
    assert claim.checks[0].claimed == {"cross_term": 2.0}
    assert [entry.title for entry in claim.checks] == ["friction-integrals", "edge", "push"]


def doubled(text):
    return text + text.partition("claims:\n")[2]


CHECK = "claims[0] (a-claim).checks"
WRONG = [
    (doubled, "claims[1] (a-claim).id: 'a-claim' given twice; allowed: a unique name"),
    ("name: push", "name: edge", f"{CHECK}[2].name: 'edge' given twice; allowed: a unique name"),
    (
        "friction-integrals", "friction-integral",
        f"{CHECK}[0].check: 'friction-integral' given; allowed: the check of the package; "
        "did you mean friction-integrals?",
    ),
    (
        "motion_cone.right", "motion_cone.rigth",
        f"{CHECK}[1].number: 'motion_cone.rigth' given; allowed: the number of the package; "
        "did you mean motion_cone.right?",
    ),
    (
        "[stick]", "[sticks]",
        f"{CHECK}[2].modes: 'sticks' given; allowed: the modes of the package; did you mean stick?",
    ),
    ("modes: [stick], ", "", f"{CHECK}[2]: none given; allowed: one of check, number, modes"),
    (
        "modes: [stick]", "modes: [stick], check: fence-frame",
        f"{CHECK}[2]: check and modes given; allowed: one of check, number, modes; give one",
    ),
    (
        ", below: 0", "",
        f"{CHECK}[1]: none given; allowed: for a number one of near, equals, above, below; give one",
    ),
    ("below: 0", "below: 0, above: 1", f"{CHECK}[1]: above and below given; allowed: for a number one"),
    ("below: 0", "near: 0", f"{CHECK}[1].within: None given; allowed: an accuracy with near"),
    (
        "claimed: {cross_term: 2}", "claimed: {}",
        f"{CHECK}[0].claimed.cross_term: missing; allowed: the arguments cross_term; add it",
    ),
    (
        "cross_term: 2", "cross_term: 2, l: 3",
        f"{CHECK}[0].claimed.l: 3.0 given; allowed: the arguments cross_term; remove it",
    ),
    (
        "cross_term: 2", "cross_term: two",
        f"{CHECK}[0].claimed.cross_term: 'two' given; allowed: a number; change it",
    ),
    (
        "cross_term: 2", "cross_term: [2]",
        "claims[0].checks[0].claimed.cross_term: [2] given; allowed: a number, inf, or the name",
    ),
    (
        "law: 2", "law: coulomb",
        f"{CHECK}[2].at.law: 'coulomb' given; allowed: definition-1, definition-2, perfectly-rough",
    ),
    (
        "law: 2", "law: 2, effects: 1",
        f"{CHECK}[2].at.effects: 1.0 given; allowed: support_friction, inertia, support_friction+inertia",
    ),
    ("law: 2, ", "", f"{CHECK}[2].at.law: missing; allowed: the arguments rod_length, law, pusher_angle"),
    (
        "claimed: {cross_term: 2}", "claimed: {cross_term: 2}, at: {l: 2}",
        f"{CHECK}[0].at: {{'l': 2.0}} given; allowed: none; give it as claimed",
    ),
    (
        "expect: enclosed", "expect: open\n    reason: Why.",
        "claims[0] (a-claim).checks: 3 given; allowed: none where nothing can be checked; remove them",
    ),
    ("expect: enclosed", "expect: refuted", "claims[0] (a-claim).reason: missing; allowed: why the claim"),
    (
        lambda text: text.partition("    checks:")[0],
        "claims[0] (a-claim).checks: missing; allowed: at least one; add it",
    ),
    ('"3"', '"7"', "claims[0].section: '7' given; allowed: '1', '2'"),
    ("a-claim", "A claim", "claims[0].id: 'A claim' given; allowed: a name of small letters, digits"),
    ("enclosed", "undecided", "claims[0].expect: 'undecided' given; allowed: 'proved', 'enclosed'"),
    ("origin: paper", "origin: paper\n    equations: [14]", "claims[0].equations[0]: 14 given; allowed: "),
    ("    origin: paper\n", "", "claims[0].origin: missing; allowed: a value for this key; add it"),
    (lambda _: "claims: []\n", "claims: [] given; allowed: a list with at least one entry"),
]  # fmt: skip


@pytest.mark.parametrize("wrong", WRONG, ids=lambda wrong: wrong[-1][:60])
def test_a_wrong_file_is_told_in_a_line(tmp_path, wrong):
    *change, message = wrong
    path = tmp_path / "claims.yaml"
    text = change[0](GOOD) if callable(change[0]) else GOOD.replace(*change)
    path.write_text(text, encoding="utf-8")
    with pytest.raises(InvalidFile) as raised:
        load_ledger(path)
    assert f"{path}: {message}" in str(raised.value)
    assert "\n" not in str(raised.value)


def test_a_missing_file_is_named(tmp_path):
    with pytest.raises(InvalidFile, match="no such file"):
        load_ledger(tmp_path / LEDGER.name)
