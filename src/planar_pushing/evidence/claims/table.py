"""The verdict on every claim, as a table: JSON, CSV and text."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Any

from flint import arb, fmpq

from planar_pushing.certified.balls import precise
from planar_pushing.evidence import writing
from planar_pushing.evidence.claims.ledger import NO_CHECK, Claim, Ledger
from planar_pushing.evidence.claims.proofs.registry import CHECKS
from planar_pushing.evidence.claims.proofs.verdicts import Evidence, Verdict
from planar_pushing.terms.errors import InvalidFile

#: Correct digits of an enclosure that the table prints.
DIGITS = 20

Row = dict[str, Any]


@dataclass(frozen=True, slots=True, kw_only=True)
class Judged:
    """A claim and the evidence that its check found."""

    claim: Claim
    evidence: Evidence

    @property
    def as_expected(self) -> bool:
        """Whether the verdict is the one that the ledger expects."""
        return self.evidence.verdict is self.claim.expected


def judge(claim: Claim) -> Judged:
    """Run the check of a claim on the numbers that it names.

    Raises
    ------
    InvalidFile
        Where the check is not defined for these numbers, as for a rod of infinite length.
    """
    if claim.check == NO_CHECK:
        evidence = Evidence(verdict=Verdict.NOT_REPRODUCIBLE, method="none", reason=claim.reason)
    else:
        evidence = _checked(claim)
        if claim.reason and evidence.verdict is claim.expected:
            evidence = replace(evidence, reason=claim.reason)
    return Judged(claim=claim, evidence=evidence)


def _checked(claim: Claim) -> Evidence:
    try:
        return CHECKS[claim.check](**claim.claimed)
    except (ArithmeticError, ValueError) as error:
        raise InvalidFile(
            f"{claim.id}.claimed: {claim.claimed!r} given; allowed: numbers that the check "
            f"{claim.check} is defined for ({error}); change them"
        ) from None


def judge_all(ledger: Ledger) -> list[Judged]:
    """Run every check, in the order of the ledger."""
    return [judge(claim) for claim in ledger.claims]


def json_text(judged: Iterable[Judged]) -> str:
    """The table as JSON: counts of the verdicts, and a row for each claim."""
    rows = [_row(each) for each in judged]
    counts = Counter(row["verdict"] for row in rows)
    found = {str(verdict): counts[verdict] for verdict in Verdict if counts[verdict]}
    return writing.json_text({"counts": found, "claims": rows})


def csv_text(judged: Iterable[Judged]) -> str:
    """The table as CSV, one line for each claim."""
    return writing.csv_text([_row(each) for each in judged])


def complaint(judged: Iterable[Judged]) -> str:
    """What differs from the ledger's expectations; empty where nothing does."""
    wrong = [each for each in judged if not each.as_expected]
    lines = [
        f"{each.claim.id}: {each.evidence.verdict}, expected {each.claim.expect}"
        + (f"; {each.evidence.reason}" if each.evidence.reason else "")
        for each in wrong
    ]
    head = [f"{len(wrong)} claims have another verdict than the ledger expects"] if wrong else []
    return "\n".join(head + lines)


@precise
def _row(judged: Judged) -> Row:
    claim, evidence = judged.claim, judged.evidence
    text, radius = digits(evidence.value)
    return {
        "id": claim.id,
        "section": claim.section,
        "equation": claim.equation,
        "figure": claim.figure,
        "origin": claim.origin,
        "statement": claim.statement,
        "verdict": str(evidence.verdict),
        "value": text,
        "radius": radius,
        "unit": evidence.unit if text is not None else None,
        "claimed": _plain(evidence.claimed),
        "margin": None if evidence.margin is None else below(evidence.margin),
        "points": evidence.points,
        "method": evidence.method,
        "reason": evidence.reason,
    }


@precise
def digits(ball: arb | None) -> tuple[str | None, float | None]:
    """Correct digits of an enclosure, at most `DIGITS`, and a radius about them that holds it."""
    if ball is None or not ball.is_finite():
        return None, None
    text = ball.str(DIGITS, radius=False)
    mantissa, _, exponent = text.partition("e")
    whole, _, part = mantissa.partition(".")
    shift = int(exponent or 0) - len(part)
    printed = fmpq(int(whole + part)) * fmpq(10) ** shift
    gap = (ball - printed).abs_upper()
    return (text if printed else "0"), _rounded(gap, math.inf)


@precise
def below(ball: arb) -> float | None:
    """Double below every number of the ball."""
    return _rounded(ball.lower(), -math.inf) if ball.is_finite() else None


def _rounded(exact: arb, towards: float) -> float:
    """Double next to an exact number, on the given side of it."""
    number = float(exact)
    beyond = arb(number) < exact if towards > 0 else arb(number) > exact
    return math.nextafter(number, towards) if beyond else number


def _plain(number: float | None) -> float | None:
    return number if number is not None and math.isfinite(number) else None
