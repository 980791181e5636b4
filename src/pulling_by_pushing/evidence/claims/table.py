"""The verdict on every claim and on each of its checks, as JSON, CSV and text."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable
from typing import Any

from flint import arb, fmpq

from planar_pushing.terms.errors import InvalidResult
from planar_pushing.terms.replacing import PathLike
from pulling_by_pushing.evidence import writing
from pulling_by_pushing.evidence.claims.ledger import (
    CheckEntry,
    Judged,
    Ledger,
    judge_all,
    load_ledger,
)
from pulling_by_pushing.evidence.proofs.verdicts import Evidence, Verdict
from pulling_by_pushing.oracle.balls import precise

#: Columns of a check.
COLUMNS = (
    *("name", "statement", "verdict", "how", "value", "radius", "unit"),
    *("claimed", "margin", "points", "means", "reason"),
)
#: Correct digits of an enclosure that the table prints.
PRINTED_DIGITS = 20

Row = dict[str, Any]


def write_table(json: PathLike, csv: PathLike, *, ledger: str) -> None:
    """Judge the claims of the ledger, and write the table.

    Raises
    ------
    InvalidResult
        If a verdict is not the one that the ledger expects; nothing is written.
    """
    content = load_ledger(ledger)
    judged = judge_all(content)
    if problem := complaint(judged):
        raise InvalidResult(problem)
    claims = rows(content, judged)
    writing.write_text(json_text(claims), json)
    writing.write_text(csv_text(claims), csv)


def rows(ledger: Ledger, judged: Iterable[Judged]) -> list[Row]:
    """Every claim as a row, with the rows of its checks."""
    return [_claim(entry) | {"checks": _checks(ledger, entry)} for entry in judged]


def json_text(claims: list[Row]) -> str:
    """The table as JSON: counts of the verdicts, and each claim with its checks."""
    counts = Counter(row["verdict"] for row in claims)
    by_verdict = {str(verdict): counts[verdict] for verdict in Verdict if counts[verdict]}
    return writing.json_text({"counts": by_verdict, "claims": claims})


def csv_text(claims: list[Row]) -> str:
    """The table as CSV, with one line for each check and for each claim without checks.

    Formulas are in the syntax of Typst, as in the ledger.
    """
    lines = []
    for claim in claims:
        first = {key: _cell(value) for key, value in claim.items() if key != "checks"}
        lines += [
            first | {f"check_{key}" if key in first else key: _cell(check[key]) for key in COLUMNS}
            for check in claim["checks"] or [dict.fromkeys(COLUMNS)]
        ]
    return writing.csv_text(lines)


def _cell(value: Any) -> Any:
    return " ".join(map(str, value)) if isinstance(value, tuple) else value


def complaint(judged: Iterable[Judged]) -> str:
    """Differences from the ledger's expectations; empty if there are none."""
    wrong = [entry for entry in judged if entry.verdict != entry.claim.expect]
    head = [f"claims whose verdict is not the expected one: {len(wrong)}"] if wrong else []
    return "\n".join(head + [_difference(entry) for entry in wrong])


def _difference(judged: Judged) -> str:
    reasons = [
        f"; {entry.title}: {evidence.reason}"
        for entry, evidence in zip(judged.claim.checks, judged.evidence, strict=True)
        if evidence.verdict is judged.verdict and evidence.reason
    ]
    return f"{judged.claim.id}: {judged.verdict}, expected {judged.claim.expect}{''.join(reasons)}"


def _claim(judged: Judged) -> Row:
    row = judged.claim.model_dump(exclude={"expect", "reason", "checks"})
    return row | {"verdict": str(judged.verdict), "reason": judged.claim.reason}


def _checks(ledger: Ledger, judged: Judged) -> list[Row]:
    pairs = zip(judged.claim.checks, judged.evidence, strict=True)
    return [_check(entry, evidence, ledger.arguments[entry.argument]) for entry, evidence in pairs]


@precise
def _check(entry: CheckEntry, evidence: Evidence, argument: str) -> Row:
    text, radius = digits(evidence.value)
    claimed = evidence.claimed
    return {
        "name": entry.title,
        "statement": entry.statement,
        "verdict": str(evidence.verdict),
        "how": argument,
        "value": text,
        "radius": radius,
        "unit": evidence.unit if text is not None else None,
        "claimed": claimed if claimed is not None and math.isfinite(claimed) else None,
        "margin": None if evidence.margin is None else double_below(evidence.margin),
        "points": evidence.points,
        "means": ", ".join(evidence.means),
        "reason": evidence.reason,
    }


@precise
def digits(ball: arb | None) -> tuple[str | None, float | None]:
    """Correct digits of an enclosure, up to `PRINTED_DIGITS`, and a radius about them that contains it."""
    if ball is None or not ball.is_finite():
        return None, None
    text = ball.str(PRINTED_DIGITS, radius=False)
    mantissa, _, exponent = text.partition("e")
    integer, _, decimals = mantissa.partition(".")
    shift = int(exponent or 0) - len(decimals)
    printed = fmpq(int(integer + decimals)) * fmpq(10) ** shift
    gap = (ball - printed).abs_upper()
    return (text if printed else "0"), _round_toward(gap, math.inf)


@precise
def double_below(ball: arb) -> float | None:
    """A double below every number of the ball."""
    return _round_toward(ball.lower(), -math.inf) if ball.is_finite() else None


def _round_toward(exact: arb, toward: float) -> float:
    """Double next to an exact number, on the given side of it."""
    number = float(exact)
    beyond = arb(number) < exact if toward > 0 else arb(number) > exact
    return math.nextafter(number, toward) if beyond else number
