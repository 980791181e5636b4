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
from planar_pushing.evidence.claims.proofs.verdicts import Verdict
from planar_pushing.evidence.claims.table import (
    below,
    complaint,
    csv_text,
    digits,
    json_text,
)

KEYS = [
    *("id", "section", "equation", "figure", "origin", "statement", "verdict", "value", "radius"),
    *("unit", "claimed", "margin", "points", "method", "reason"),
]


def test_every_verdict_is_the_expected_one():
    assert complaint(judged()) == ""


def test_the_table_in_json():
    table = json.loads(json_text(judged()))
    assert [row["id"] for row in table["claims"]] == [claim.id for claim in ledger().claims]
    assert sum(table["counts"].values()) == len(table["claims"])
    assert set(table["counts"]) <= {str(verdict) for verdict in Verdict} - {"undecided"}
    for row in table["claims"]:
        assert list(row) == KEYS
        assert row["value"] is None or len(row["value"].strip("-").replace(".", "")) <= 24
        assert (row["value"] is None) == (row["radius"] is None) == (row["unit"] is None)
        if row["verdict"] == "proved" and row["margin"] is not None:
            assert row["margin"] >= 0


def test_the_table_in_csv_has_the_same_rows():
    rows = list(csv.DictReader(io.StringIO(csv_text(judged()))))
    table = json.loads(json_text(judged()))["claims"]
    assert [row["id"] for row in rows] == [row["id"] for row in table]
    assert [row["value"] or None for row in rows] == [row["value"] for row in table]


def test_the_bytes_are_the_same_every_time():
    again = judged.__wrapped__()
    assert json_text(again) == json_text(judged())
    assert csv_text(again) == csv_text(judged())


def test_a_verdict_that_is_not_expected_is_named():
    first, second, *rest = judged()
    evidence = replace(first.evidence, verdict=Verdict.REFUTED, reason="off by 1")
    changed = replace(first, evidence=evidence)
    said = complaint([changed, second, *rest])
    assert said == (
        "1 claims have another verdict than the ledger expects\n"
        f"{first.claim.id}: refuted, expected proved; off by 1"
    )


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
