"""Verdicts, the evidence for them, and the derivation of evidence from balls.

A margin is the distance of an enclosure from the boundary of the claim, in the unit of the claim, and
positive if it supports the claim. A claim whose margin contains zero is undecided, never guessed.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import reduce
from typing import Any

from flint import arb

from pulling_by_pushing.oracle.balls import Exact, Undecided, rational, sign

Identity = Any  # fmpq_mpoly in normal form


class Fails(ArithmeticError):
    """A claim about a number that does not exist; the message is the reason."""


class Verdict(StrEnum):
    """Verdict on a claim, from the strongest to the weakest; the weakest of several decides."""

    PROVED = "proved"
    ENCLOSED = "enclosed"
    SAMPLED = "sampled"
    #: No computation can decide it.
    OPEN = "open"
    UNDECIDED = "undecided"
    REFUTED = "refuted"


class Means(StrEnum):
    """Work of a program that checks the argument of a claim."""

    #: Polynomials vanish in normal form.
    IDENTITIES = "identities"
    #: Exact arithmetic decides truths about finitely many things.
    FACTS = "exact facts"
    #: Ball arithmetic decides the sign of a number.
    INEQUALITIES = "inequalities"
    #: Ball arithmetic decides the sign of a function on intervals that cover its whole domain.
    COVER = "an interval cover"


def weakest(verdicts: Iterable[Verdict]) -> Verdict:
    """The verdict of a claim with several checks: the weakest of them."""
    return max(verdicts, key=list(Verdict).index)


@dataclass(frozen=True, slots=True, kw_only=True)
class Evidence:
    """Verdict and the numbers that support it; numbers are in `unit`.

    The margin is the distance of the `value` from the boundary of the claim, > 0 if it supports it;
    `points` counts points, boxes or identities; `means` are those of the program, in the order of `Means`;
    `reason` says why a claim does not hold or is undecided.
    """

    verdict: Verdict
    value: arb | None = None
    unit: str | None = None
    claimed: float | None = None
    margin: arb | None = None
    points: int | None = None
    means: tuple[Means, ...] = ()
    reason: str | None = None

    def at_most(self, kind: Verdict) -> Evidence:
        """Return the evidence with a verdict no stronger than the kind of its check."""
        return replace(self, verdict=weakest((self.verdict, kind)))


def inequality(
    margin: arb,
    *,
    value: arb | None = None,
    unit: str = "1",
    claimed: float | None = None,
    points: int = 1,
) -> Evidence:
    """Evidence for ``margin > 0``."""
    verdict, reason = Verdict.PROVED, None
    if margin < 0:
        verdict, reason = Verdict.REFUTED, f"off by {(-margin).mid().str(6, radius=False)} {unit}"
    elif not margin > 0:
        verdict, reason = Verdict.UNDECIDED, f"the margin {margin.str(6)} contains zero"
    value = margin if value is None else value
    numbers: dict[str, Any] = {"value": value, "unit": unit, "claimed": claimed, "margin": margin}
    means = (Means.INEQUALITIES,)
    return Evidence(verdict=verdict, points=points, means=means, reason=reason, **numbers)


def near(value: arb, claimed: float, within: float, unit: str = "1") -> Evidence:
    """Evidence for a number, to within the accuracy with which it is stated."""
    margin = arb(rational(within)) - abs(value - rational(claimed))
    return inequality(margin, value=value, unit=unit, claimed=claimed)


def equal(value: arb, claimed: float, exact: Exact | None = None, unit: str = "1") -> Evidence:
    """Evidence for a number that is claimed exactly; `exact` is the number in exact arithmetic."""
    goal = rational(claimed)
    try:
        side = sign(value - goal, None if exact is None else lambda: exact - goal)
    except Undecided as error:
        return Evidence(verdict=Verdict.UNDECIDED, value=value, unit=unit, reason=str(error))
    numbers: dict[str, Any] = {"value": value, "unit": unit, "claimed": claimed, "points": 1}
    numbers["means"] = (Means.FACTS,)
    if not side:
        return Evidence(verdict=Verdict.PROVED, margin=arb(0), **numbers)
    reason = f"the number is {value.str(12, radius=False)}"
    return Evidence(verdict=Verdict.REFUTED, margin=-abs(value - goal), reason=reason, **numbers)


def identity(differences: Mapping[str, Identity]) -> Evidence:
    """Evidence for polynomial identities: each difference vanishes in normal form."""
    wrong = [f"{name} is off by {rest}" for name, rest in differences.items() if rest != 0]
    return _decide("; ".join(wrong), len(differences), Means.IDENTITIES)


def facts(holds: Mapping[str, bool], **numbers: Any) -> Evidence:
    """Evidence for decided facts, by name."""
    wrong = ", ".join(name for name, is_so in holds.items() if not is_so)
    return replace(_decide(wrong and f"false: {wrong}", len(holds), Means.FACTS), **numbers)


def _decide(wrong: str, points: int, means: Means) -> Evidence:
    verdict = Verdict.REFUTED if wrong else Verdict.PROVED
    return Evidence(verdict=verdict, points=points, means=(means,), reason=wrong or None)


def together(main: Evidence, *others: Evidence) -> Evidence:
    """Evidence for statements together: numbers of the first, the weakest verdict, all means."""
    parts = (main, *others)
    used = {means for part in parts for means in part.means}
    verdict = weakest(part.verdict for part in parts)
    points = sum(part.points or 0 for part in parts)
    reason = next(part.reason for part in parts if part.verdict is verdict)
    means = tuple(each for each in Means if each in used)
    return replace(main, verdict=verdict, reason=reason, points=points, means=means)


def smallest(margins: Iterable[arb]) -> arb:
    """Smallest of several margins."""
    return reduce(arb.min, margins)
