"""The ledger: complete, honest in its wording, and judged as it expects; its tables enclose."""

import csv
import io
import json
import re
from dataclasses import replace
from fractions import Fraction

import pytest
from evidence.claims.ledgers import LEDGER, entries, judged, ledger
from flint import arb, ctx, fmpq

from planar_pushing.terms.errors import InvalidFile
from pulling_by_pushing.evidence.claims.ledger import load_ledger
from pulling_by_pushing.evidence.claims.table import (
    COLUMNS,
    complaint,
    csv_text,
    digits,
    double_below,
    json_text,
    rows,
)
from pulling_by_pushing.evidence.proofs.registry import CHECKS, NUMBERS
from pulling_by_pushing.evidence.proofs.verdicts import Verdict
from pulling_by_pushing.oracle.balls import PRECISION

#: Words of a statement about more than the instances that it names.
GENERAL = re.compile(r"\b(every|any|all|always|never|whatever)\b")


def of_paper():
    return [claim for claim in ledger().claims if claim.origin == "paper"]


def test_every_formula_section_and_figure_has_an_entry():
    assert {number for claim in of_paper() for number in claim.equations} == set(range(1, 14))
    assert {claim.section for claim in of_paper()} == {"1", "2", "3", "3.1", "3.2", "4", "5"}
    drawn = {number for claim in of_paper() for number in claim.figures}
    assert drawn == set(range(1, 13)) - {1, 4}  # the setting, and the coordinates
    assert len(of_paper()) == 40


def test_every_check_number_argument_and_support_is_used():
    listed = entries().values()
    assert {entry.check for entry in listed} - {None} == set(CHECKS)
    used = {entry.number.partition(".")[0] for entry in listed if entry.number}
    assert used == {name.partition(".")[0] for name in NUMBERS}
    assert {entry.argument for entry in listed} == set(ledger().arguments)
    assert {entry.at["support"] for entry in listed if "support" in entry.at} == set(
        ledger().supports
    )


def test_no_statement_and_no_number_twice():
    statements = [claim.statement for claim in ledger().claims]
    assert len(set(statements)) == len(statements)
    numbers = [(entry.number, str(entry.at)) for entry in entries().values() if entry.number]
    assert len(set(numbers)) == len(numbers)


def test_every_verdict_is_the_expected_one():
    assert complaint(judged()) == ""


def test_an_entry_that_is_proved_rests_on_no_instance():
    for one in judged():
        if one.verdict is Verdict.PROVED:
            for check in one.claim.checks:
                assert CHECKS[check.check].kind is Verdict.PROVED, one.claim.id


def test_no_statement_of_the_paper_is_only_sampled():
    """The abstract counts those that are proved, enclosed, refuted and open."""
    assert {one.expect for one in of_paper()} == {"proved", "enclosed", "refuted", "open"}


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
    for name, argument in ledger().arguments.items():
        assert argument.endswith("."), name
        assert name not in CHECKS or argument.count(". ") >= 1, name


@pytest.mark.parametrize(
    ("right", "wrong", "says"),
    [
        ("check: unique-center", "check: unique-centre", "a check or a number of the package"),
        ("near: 0.4693, within: 5.0e-5", "near: 0.4693", "an accuracy, within"),
        ("equals: 180}", "equals: 180, above: 0}", "one of check, number and modes"),
        ("support: tripod", "support: tripods", "one of the supports"),
        ("  fence-frame: >-", "  fence: >-", "an argument for fence-frame"),
        ("id: drawn-centers", "id: perfectly-rough", "a name for each claim"),
        ("expect: refuted", "expect: proved", "a reason for a claim that is open or refuted"),
    ],
)
def test_a_wrong_file_is_refused(tmp_path, right, wrong, says):
    text = LEDGER.read_text(encoding="utf-8")
    assert right in text
    (tmp_path / "claims.yaml").write_text(text.replace(right, wrong), encoding="utf-8")
    with pytest.raises(InvalidFile, match=says):
        load_ledger(tmp_path / "claims.yaml")


def changed(one, **values):
    first, *rest = one.evidence
    return replace(one, evidence=(replace(first, **values), *rest))


def test_a_verdict_that_is_not_expected_is_named():
    first, second, *rest = judged()
    said = complaint([changed(first, verdict=Verdict.REFUTED, reason="off by 1"), second, *rest])
    assert said == (
        "claims whose verdict is not the expected one: 1\n"
        f"{first.claim.id}: refuted, expected proved; {first.claim.checks[0].title}: off by 1"
    )


def test_the_weakest_check_decides():
    (one,) = (each for each in judged() if each.claim.id == "exact-cone-of-figure-12")
    assert [each.verdict for each in one.evidence] == [Verdict.PROVED, *[Verdict.ENCLOSED] * 2]
    assert one.verdict is Verdict.ENCLOSED
    assert changed(one, verdict=Verdict.SAMPLED).verdict is Verdict.SAMPLED


def test_the_tables_have_every_check():
    listed = rows(ledger(), judged())
    table = json.loads(json_text(listed))
    assert sum(table["counts"].values()) == len(table["claims"]) == len(ledger().claims)
    checks = [(row["id"], check) for row in table["claims"] for check in row["checks"] or [{}]]
    lines = list(csv.DictReader(io.StringIO(csv_text(listed))))
    assert [line["id"] for line in lines] == [name for name, _ in checks]
    for line, (_, check) in zip(lines, checks, strict=True):
        assert list(check) in ([], list(COLUMNS))
        assert (line["value"] or None) == check.get("value")
        assert (line["check_verdict"] or None) == check.get("verdict")


BALLS = [arb(1) / 3, arb(-20.04, 1e-12), arb(180), arb(0), arb(0, 1e-40), arb(1e30)]


@pytest.mark.parametrize("ball", BALLS)
def test_what_is_printed_encloses(ball):
    with ctx.workprec(PRECISION):
        text, radius = digits(ball)
        printed = Fraction(text)
        found = arb(fmpq(printed.numerator, printed.denominator))
        assert arb(found, radius).contains(ball)
        assert not arb(double_below(ball)) > ball
