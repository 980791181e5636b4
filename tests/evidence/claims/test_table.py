"""The table: every verdict as expected, in the agreed form, the same bytes every time."""

import csv
import io
import json
from dataclasses import replace
from fractions import Fraction

import pytest
from flint import arb, ctx, fmpq

from evidence.claims.ledgers import judged, ledger
from planar_pushing.certified.balls import PRECISION
from planar_pushing.evidence.claims.table import (
    COLUMNS,
    below,
    complaint,
    csv_text,
    digits,
    json_text,
)
from planar_pushing.evidence.claims.verdicts import Verdict

KEYS = [
    *(
        "id",
        "section",
        "equations",
        "figures",
        "origin",
        "statement",
        "verdict",
        "reason",
        "checks",
    ),
]


def test_every_verdict_is_the_expected_one():
    assert complaint(judged()) == ""


def test_the_table_in_json():
    table = json.loads(json_text(judged()))
    assert [row["id"] for row in table["claims"]] == [claim.id for claim in ledger().claims]
    assert sum(table["counts"].values()) == len(table["claims"])
    assert set(table["counts"]) == {str(verdict) for verdict in Verdict} - {"undecided"}
    for row in table["claims"]:
        assert list(row) == KEYS
        for check in row["checks"]:
            assert list(check) == list(COLUMNS)
            assert check["how"]
            assert check["value"] is None or len(check["value"].strip("-").replace(".", "")) <= 24
            assert (check["value"] is None) == (check["radius"] is None) == (check["unit"] is None)
            if check["verdict"] != "refuted" and check["margin"] is not None:
                assert check["margin"] >= 0


def test_the_table_in_csv_has_a_line_for_each_check():
    rows = list(csv.DictReader(io.StringIO(csv_text(judged()))))
    table = json.loads(json_text(judged()))["claims"]
    checks = [(row["id"], check) for row in table for check in row["checks"] or [{}]]
    assert [row["id"] for row in rows] == [name for name, _ in checks]
    for row, (_, check) in zip(rows, checks, strict=True):
        assert (row["value"] or None) == check.get("value")
        assert (row["check_verdict"] or None) == check.get("verdict")
    figures = {row["id"]: row["figures"] for row in rows}
    assert figures["pulling-is-ambiguous"] == "3 6 9 11"


def test_the_bytes_are_the_same_every_time():
    again = judged.__wrapped__()
    assert json_text(again) == json_text(judged())
    assert csv_text(again) == csv_text(judged())


def changed(one, **values):
    first, *rest = one.checks
    return replace(one, checks=(replace(first, evidence=replace(first.evidence, **values)), *rest))


def test_a_verdict_that_is_not_expected_is_named():
    first, second, *rest = judged()
    said = complaint([changed(first, verdict=Verdict.REFUTED, reason="off by 1"), second, *rest])
    assert said == (
        "claims whose verdict is not the expected one: 1\n"
        f"{first.claim.id}: refuted, expected proved; {first.checks[0].entry.title}: off by 1"
    )
    weaker = changed(first, verdict=Verdict.ENCLOSED)
    assert f"{first.claim.id}: enclosed, expected proved" in complaint([weaker])


def test_the_weakest_check_decides():
    (one,) = (each for each in judged() if each.claim.id == "exact-cone-of-figure-12")
    assert one.checks[0].evidence.verdict is Verdict.PROVED
    assert one.verdict is Verdict.ENCLOSED
    assert changed(one, verdict=Verdict.SAMPLED).verdict is Verdict.SAMPLED


@pytest.mark.parametrize(
    "ball",
    [
        arb(1) / 3,
        arb(-20.04, 1e-12),
        arb(2) / 3 * 10**-9,
        arb(180),
        arb(0),
        arb(0, 1e-40),
        arb(1e30),
    ],
)
def test_digits_and_radius_enclose(ball):
    with ctx.workprec(PRECISION):
        text, radius = digits(ball)
        printed = Fraction(text)
        found = arb(fmpq(printed.numerator, printed.denominator))
        assert arb(found, radius).contains(ball)


def test_margins_are_rounded_down():
    with ctx.workprec(PRECISION):
        for ball in (arb(1) / 3, arb(-1) / 3, arb(1), arb(2, 1e-3)):
            assert not arb(below(ball)) > ball
        assert below(arb(1)) == 1
        assert below(arb.nan()) is None
