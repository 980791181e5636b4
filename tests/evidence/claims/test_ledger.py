"""The ledger file: complete, and clear about what is wrong in it."""

import pytest

from evidence.claims.ledgers import LEDGER, ledger
from planar_pushing.evidence.claims.ledger import NO_CHECK, load_ledger
from planar_pushing.evidence.claims.proofs.registry import CHECKS
from planar_pushing.terms.errors import InvalidFile

GOOD = """claims:
  - id: a-claim
    section: "3"
    origin: paper
    statement: A statement.
    claimed: {cross_term: 2}
    check: force-integral
    expect: proved
"""


def test_every_formula_has_an_entry():
    found = {claim.equation for claim in ledger().claims if claim.origin == "paper"}
    assert found >= set(range(1, 14))


def test_every_section_has_an_entry():
    found = {claim.section for claim in ledger().claims if claim.origin == "paper"}
    assert found == {"1", "2", "3", "3.1", "3.2", "4", "5"}


def test_the_seven_geometric_facts_have_entries():
    facts = [claim.id for claim in ledger().claims if claim.id.startswith("fact-")]
    assert [name.split("-")[1] for name in facts] == list("1234567")


def test_every_check_is_used_and_every_claim_has_one():
    assert {claim.check for claim in ledger().claims} == set(CHECKS) | {NO_CHECK}


def test_no_statement_twice():
    statements = [claim.statement for claim in ledger().claims]
    assert len(set(statements)) == len(statements)


def test_wrong_statements_and_undecidable_ones_say_why():
    for claim in ledger().claims:
        assert (claim.expect in ("refuted", "not reproducible")) == (claim.reason is not None)


def test_a_good_file_loads(tmp_path):
    path = tmp_path / "claims.yaml"
    path.write_text(GOOD, encoding="utf-8")
    assert load_ledger(path).claims[0].claimed == {"cross_term": 2.0}


def doubled(text):
    return text + text.partition("claims:\n")[2]


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (doubled, "claims[1] (a-claim).id: 'a-claim' given twice; allowed: an id of its own"),
        (
            lambda text: text.replace("force-integral", "force-integrals"),
            "claims[0] (a-claim).check: 'force-integrals' given; allowed: a check of the package; "
            "did you mean force-integral?",
        ),
        (
            lambda text: text.replace('"3"', '"7"'),
            "claims[0].section: '7' given; allowed: '1', '2'",
        ),
        (
            lambda text: text.replace("{cross_term: 2}", "{}"),
            "claims[0] (a-claim).claimed.cross_term: missing; allowed: the numbers cross_term",
        ),
        (
            lambda text: text.replace("cross_term: 2", "cross_term: 2, l: 3"),
            "claims[0] (a-claim).claimed.l: 3.0 given; allowed: the numbers cross_term; remove it",
        ),
        (
            lambda text: text.replace("cross_term: 2", "cross_term: two"),
            "claims[0].claimed.cross_term: 'two' given; allowed: a number, or inf",
        ),
        (
            lambda text: text.replace("force-integral", NO_CHECK),
            "claims[0] (a-claim).reason: missing; allowed: why the claim cannot be checked",
        ),
        (
            lambda text: text.replace("a-claim", "A claim"),
            "claims[0].id: 'A claim' given; allowed: a name of small letters, digits and dashes",
        ),
        (
            lambda text: text.replace("expect: proved", "expect: undecided"),
            "claims[0].expect: 'undecided' given; allowed: 'proved', 'verified on the grid'",
        ),
        (
            lambda text: text.replace("origin: paper", "origin: paper\n    equation: 14"),
            "claims[0].equation: 14 given; allowed: ",
        ),
        (
            lambda text: text.replace("    origin: paper\n", ""),
            "claims[0].origin: missing; allowed: a value for this key; add it",
        ),
        (lambda _: "claims: []\n", "claims: [] given; allowed: a list with at least one entry"),
    ],
)
def test_what_is_wrong_is_named(tmp_path, change, message):
    path = tmp_path / "claims.yaml"
    path.write_text(change(GOOD), encoding="utf-8")
    with pytest.raises(InvalidFile) as raised:
        load_ledger(path)
    assert f"{path}: {message}" in str(raised.value)


def test_a_missing_file_is_named(tmp_path):
    with pytest.raises(InvalidFile, match="no such file"):
        load_ledger(tmp_path / LEDGER.name)
