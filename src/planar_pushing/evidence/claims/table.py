"""The verdict on every claim and on each of its checks, as JSON, CSV and text."""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from flint import arb, fmpq

from planar_pushing.certified.balls import precise
from planar_pushing.evidence import writing
from planar_pushing.evidence.claims.ledger import CheckEntry, Claim, Ledger
from planar_pushing.evidence.claims.verdicts import Evidence, Verdict, weakest
from planar_pushing.terms.errors import InvalidFile

#: Columns of a check.
COLUMNS = (
    *("name", "statement", "verdict", "how", "value", "radius", "unit"),
    *("claimed", "margin", "points", "reason"),
)
#: Correct digits of an enclosure that the table prints.
DIGITS = 20
#: Marks of Typst in a formula, and how plain text writes them.
_PLAIN = {
    r"\b(?:thin |bold\(([^()]*)\))": r"\1",
    r'"': "",
    r"_\((\S+?)(?: (\S+))?\)": r"_\1\2",
    r"\babs\(((?:[^()]|\([^()]*\))*)\)": r"|\1|",
    r" dot ": " . ",
    r" times ": " x ",
    r"\bdif ": "d ",
    r"\boo\b": "inf",
}

Row = dict[str, Any]


@dataclass(frozen=True, slots=True, kw_only=True)
class Found:
    """A check and the evidence that it found."""

    entry: CheckEntry
    evidence: Evidence


@dataclass(frozen=True, slots=True, kw_only=True)
class Judged:
    """A claim and the findings of its checks."""

    claim: Claim
    checks: tuple[Found, ...]

    @property
    def verdict(self) -> Verdict:
        """The verdict of the weakest check."""
        found = [each.evidence.verdict for each in self.checks]
        return weakest(found) if found else Verdict.OPEN


def judge(claim: Claim) -> Judged:
    """Run the checks of a claim.

    Raises
    ------
    InvalidFile
        If a check is not defined for the given numbers, for example a rod of infinite length.
    """
    return Judged(claim=claim, checks=tuple(judge_check(claim.id, each) for each in claim.checks))


def judge_check(claim: str, entry: CheckEntry) -> Found:
    """Run one check of the claim with this id; raises the errors of `judge`."""
    try:
        evidence = entry.resolved().run()
    except (ArithmeticError, ValueError) as error:
        raise InvalidFile(
            f"{claim}.{entry.title}: {entry.claimed or entry.at} given; allowed: numbers for which the "
            f"check is defined ({error}); change them"
        ) from None
    return Found(entry=entry, evidence=evidence)


def judge_all(ledger: Ledger) -> list[Judged]:
    """Run every check, in the order of the ledger."""
    return [judge(claim) for claim in ledger.claims]


def json_text(judged: Iterable[Judged]) -> str:
    """The table as JSON: counts of the verdicts, and each claim with its checks."""
    listed = list(judged)
    counts = Counter(each.verdict for each in listed)
    found = {str(verdict): counts[verdict] for verdict in Verdict if counts[verdict]}
    rows = [_claim(each) | {"checks": [_check(one) for one in each.checks]} for each in listed]
    return writing.json_text({"counts": found, "claims": rows})


def csv_text(judged: Iterable[Judged]) -> str:
    """The table as CSV, with one line for each check and for each claim without checks."""
    rows = []
    for each in judged:
        listed = {key: _plain(value) for key, value in _claim(each).items()}
        checks = [_check(found) for found in each.checks] or [dict.fromkeys(COLUMNS)]
        rows += [
            listed | {f"check_{key}" if key in listed else key: _plain(one[key]) for key in COLUMNS}
            for one in checks
        ]
    return writing.csv_text(rows)


def plain(text: str) -> str:
    """A text of the ledger without the marks of its formulas and of its references to entries."""
    parts = re.sub(r"@(?=[a-z])", "", text).split("$")
    for mark, written in _PLAIN.items():
        parts[1::2] = [re.sub(mark, written, part) for part in parts[1::2]]
    return "".join(parts)


def complaint(judged: Iterable[Judged]) -> str:
    """Differences from the ledger's expectations; empty if there are none."""
    wrong = [each for each in judged if each.verdict is not each.claim.expected]
    head = [f"claims whose verdict is not the expected one: {len(wrong)}"] if wrong else []
    return "\n".join(head + [_difference(each) for each in wrong])


def _difference(judged: Judged) -> str:
    reasons = [
        f"; {each.entry.title}: {each.evidence.reason}"
        for each in judged.checks
        if each.evidence.verdict is judged.verdict and each.evidence.reason
    ]
    return f"{judged.claim.id}: {judged.verdict}, expected {judged.claim.expect}{''.join(reasons)}"


def _claim(judged: Judged) -> Row:
    row = judged.claim.model_dump(exclude={"expect", "reason", "checks"})
    return row | {"verdict": str(judged.verdict), "reason": judged.claim.reason}


@precise
def _check(found: Found) -> Row:
    evidence = found.evidence
    text, radius = digits(evidence.value)
    return {
        "name": found.entry.title,
        "statement": found.entry.statement,
        "verdict": str(evidence.verdict),
        "how": found.entry.resolved().how,
        "value": text,
        "radius": radius,
        "unit": evidence.unit if text is not None else None,
        "claimed": _plain(evidence.claimed),
        "margin": None if evidence.margin is None else below(evidence.margin),
        "points": evidence.points,
        "reason": evidence.reason,
    }


@precise
def digits(ball: arb | None) -> tuple[str | None, float | None]:
    """Correct digits of an enclosure, at most `DIGITS`, and a radius about them that contains it."""
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
    """A double below every number of the ball."""
    return _rounded(ball.lower(), -math.inf) if ball.is_finite() else None


def _rounded(exact: arb, towards: float) -> float:
    """Double next to an exact number, on the given side of it."""
    number = float(exact)
    beyond = arb(number) < exact if towards > 0 else arb(number) > exact
    return math.nextafter(number, towards) if beyond else number


def _plain(value: Any) -> Any:
    """A value as a cell: a list of numbers becomes text, and an infinite number is left out."""
    if isinstance(value, tuple):
        return " ".join(map(str, value))
    if isinstance(value, str):
        return plain(value)
    return None if isinstance(value, float) and not math.isfinite(value) else value
