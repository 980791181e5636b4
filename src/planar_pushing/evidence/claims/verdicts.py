"""Verdicts, the evidence for them, and the derivation of evidence from balls.

A margin is the distance of an enclosure from the boundary of the claim, in the unit of the claim, and
positive if it supports the claim. A claim whose margin contains zero is undecided, never guessed.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import reduce
from typing import Any

from flint import arb

from planar_pushing.certified.balls import Exact, Undecided, rational, sign

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


def weakest(verdicts: Iterable[Verdict]) -> Verdict:
    """Return the verdict that decides."""
    return max(verdicts, key=list(Verdict).index)


@dataclass(frozen=True, slots=True, kw_only=True)
class Evidence:
    """Verdict and the numbers that support it.

    Parameters
    ----------
    verdict : Verdict
    value : arb, optional
        Enclosure of the number that the claim is about, in `unit`.
    claimed : float, optional
        The number that the claim gives for it.
    margin : arb, optional
        Distance from the boundary of the claim, in `unit`, > 0 if it supports the claim.
    points : int, optional
        Points, boxes or identities that were evaluated.
    reason : str, optional
        Why the claim does not hold or cannot be decided.
    """

    verdict: Verdict
    value: arb | None = None
    unit: str | None = None
    claimed: float | None = None
    margin: arb | None = None
    points: int | None = None
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
    return Evidence(
        verdict=verdict,
        value=margin if value is None else value,
        unit=unit,
        claimed=claimed,
        margin=margin,
        points=points,
        reason=reason,
    )


def near(value: arb, claimed: float, within: float, unit: str = "1") -> Evidence:
    """Evidence for a number, to within the accuracy with which it is stated."""
    margin = arb(rational(within)) - abs(value - rational(claimed))
    return inequality(margin, value=value, unit=unit, claimed=claimed)


def equal(value: arb, claimed: float, exact: Exact | None = None, unit: str = "1") -> Evidence:
    """Evidence for a number that is claimed exactly; `exact` is the number in exact arithmetic."""
    goal = rational(claimed)
    try:
        apart = sign(value - goal, None if exact is None else lambda: exact - goal)
    except Undecided as error:
        return Evidence(verdict=Verdict.UNDECIDED, value=value, unit=unit, reason=str(error))
    return Evidence(
        verdict=Verdict.REFUTED if apart else Verdict.PROVED,
        value=value,
        unit=unit,
        claimed=claimed,
        margin=-abs(value - goal) if apart else arb(0),
        points=1,
        reason=f"the number is {value.str(12, radius=False)}" if apart else None,
    )


def identity(differences: Mapping[str, Identity]) -> Evidence:
    """Evidence for polynomial identities: each difference vanishes in normal form."""
    wrong = {name: each for name, each in differences.items() if each != 0}
    reason = "; ".join(f"{name} is off by {each}" for name, each in wrong.items())
    return Evidence(
        verdict=Verdict.REFUTED if wrong else Verdict.PROVED,
        points=len(differences),
        reason=reason or None,
    )


def facts(found: Mapping[str, bool], **numbers: Any) -> Evidence:
    """Evidence for decided facts, by name."""
    wrong = [name for name, holds in found.items() if not holds]
    return Evidence(
        verdict=Verdict.REFUTED if wrong else Verdict.PROVED,
        points=len(found),
        reason=f"false: {', '.join(wrong)}" if wrong else None,
        **numbers,
    )


def at_points(wrong: Sequence[str], points: int) -> Evidence:
    """Evidence for a statement at each of some points; `wrong` names the points where it fails."""
    verdict = Verdict.REFUTED if wrong else Verdict.SAMPLED
    reason = f"fails at {len(wrong)} points, first {wrong[0]}" if wrong else None
    return Evidence(verdict=verdict, points=points, reason=reason)


def together(main: Evidence, *others: Evidence) -> Evidence:
    """Evidence for several statements together: the numbers of the first, the weakest verdict."""
    every = (main, *others)
    verdict = weakest(each.verdict for each in every)
    points = sum(each.points or 0 for each in every)
    reason = next(each.reason for each in every if each.verdict is verdict)
    return replace(main, verdict=verdict, reason=reason, points=points)


def least(margins: Iterable[arb]) -> arb:
    """Smallest of several margins."""
    return reduce(arb.min, margins)
