"""Verdicts, the evidence for them, and how evidence follows from balls.

A margin is the distance of an enclosure from the boundary of the claim, in the unit of the claim,
positive where it supports the claim. A claim whose margin contains zero is undecided, never guessed.
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


class Verdict(StrEnum):
    """Verdict of a check; of several the last in this order decides."""

    PROVED = "proved"
    VERIFIED = "verified on the grid"
    NOT_REPRODUCIBLE = "not reproducible"
    UNDECIDED = "undecided"
    REFUTED = "refuted"


@dataclass(frozen=True, slots=True, kw_only=True)
class Evidence:
    """Verdict and what it rests on.

    Parameters
    ----------
    verdict : Verdict
    method : str
        How the verdict was reached.
    value : arb, optional
        Enclosure of the number that the claim is about, in `unit`.
    claimed : float, optional
        The number that the claim gives for it.
    margin : arb, optional
        Distance from the boundary of the claim, in `unit`, > 0 where it supports the claim.
    points : int, optional
        Points or boxes that were evaluated.
    reason : str, optional
        Why the claim does not hold or cannot be decided.
    """

    verdict: Verdict
    method: str
    value: arb | None = None
    unit: str | None = None
    claimed: float | None = None
    margin: arb | None = None
    points: int | None = None
    reason: str | None = None


def inequality(
    margin: arb,
    method: str,
    *,
    value: arb | None = None,
    unit: str = "1",
    claimed: float | None = None,
    points: int = 1,
    holds: Verdict = Verdict.PROVED,
) -> Evidence:
    """Evidence for ``margin > 0``; `holds` is the verdict where it is so."""
    verdict, reason = holds, None
    if margin < 0:
        verdict, reason = Verdict.REFUTED, f"off by {(-margin).mid().str(6, radius=False)} {unit}"
    elif not margin > 0:
        verdict, reason = Verdict.UNDECIDED, f"the margin {margin.str(6)} contains zero"
    return Evidence(
        verdict=verdict,
        method=method,
        value=margin if value is None else value,
        unit=unit,
        claimed=claimed,
        margin=margin,
        points=points,
        reason=reason,
    )


def near(
    value: arb,
    claimed: float,
    within: float,
    method: str,
    unit: str = "1",
    holds: Verdict = Verdict.PROVED,
) -> Evidence:
    """Evidence for a number to within the accuracy that it is given with."""
    margin = arb(rational(within)) - abs(value - rational(claimed))
    return inequality(margin, method, value=value, unit=unit, claimed=claimed, holds=holds)


def equal(
    value: arb, claimed: float, method: str, exact: Exact | None = None, unit: str = "1"
) -> Evidence:
    """Evidence for a number that is claimed exactly; `exact` is the number in exact arithmetic."""
    goal = rational(claimed)
    try:
        apart = sign(value - goal, None if exact is None else lambda: exact - goal)
    except Undecided as error:
        return Evidence(
            verdict=Verdict.UNDECIDED, method=method, value=value, unit=unit, reason=str(error)
        )
    verdict = Verdict.REFUTED if apart else Verdict.PROVED
    reason = f"the number is {value.str(12, radius=False)}" if apart else None
    margin = -abs(value - goal) if apart else arb(0)
    return Evidence(
        verdict=verdict,
        method=method,
        value=value,
        unit=unit,
        claimed=claimed,
        margin=margin,
        points=1,
        reason=reason,
    )


def identity(differences: Mapping[str, Identity], method: str) -> Evidence:
    """Evidence for polynomial identities: each difference vanishes in normal form."""
    wrong = {name: each for name, each in differences.items() if each != 0}
    reason = "; ".join(f"{name} is off by {each}" for name, each in wrong.items())
    return Evidence(
        verdict=Verdict.REFUTED if wrong else Verdict.PROVED,
        method=method,
        points=len(differences),
        reason=reason or None,
    )


def facts(found: Mapping[str, bool], method: str, **numbers: Any) -> Evidence:
    """Evidence for decided facts; each is named."""
    wrong = [name for name, holds in found.items() if not holds]
    return Evidence(
        verdict=Verdict.REFUTED if wrong else Verdict.PROVED,
        method=method,
        points=len(found),
        reason=f"not so: {', '.join(wrong)}" if wrong else None,
        **numbers,
    )


def on_grid(wrong: Sequence[str], points: int, method: str) -> Evidence:
    """Evidence for a statement at every point of a grid or sample; `wrong` names where it fails."""
    verdict = Verdict.REFUTED if wrong else Verdict.VERIFIED
    reason = f"fails at {len(wrong)} points, first {wrong[0]}" if wrong else None
    return Evidence(verdict=verdict, method=method, points=points, reason=reason)


def together(main: Evidence, *others: Evidence) -> Evidence:
    """Evidence for several statements at once: the numbers of the first, the weakest verdict."""
    every = (main, *others)
    weakest = max(every, key=lambda each: list(Verdict).index(each.verdict))
    points = sum(each.points or 0 for each in every)
    if weakest is main or weakest.verdict is main.verdict:
        return replace(main, points=points)
    return replace(main, verdict=weakest.verdict, reason=weakest.reason, points=points)


def least(margins: Iterable[arb]) -> arb:
    """Smallest of several margins."""
    return reduce(arb.min, margins)
