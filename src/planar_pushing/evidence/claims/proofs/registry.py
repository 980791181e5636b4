"""The checks by name. What a claim gives as `claimed` is what its check takes as keywords."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from functools import wraps

from planar_pushing.certified.balls import Undecided, precise
from planar_pushing.evidence.claims.proofs.verdicts import Evidence, Verdict

Check = Callable[..., Evidence]

CHECKS: dict[str, Check] = {}


def check(function: Check) -> Check:
    """Register a check under its name, with dashes for underscores.

    It runs at the working precision; a sign that balls do not settle makes the claim undecided.
    """

    @wraps(function)
    def checked(**claimed: float) -> Evidence:
        try:
            return precise(function)(**claimed)
        except Undecided as error:
            return Evidence(verdict=Verdict.UNDECIDED, method="balls", reason=str(error))

    CHECKS[function.__name__.replace("_", "-")] = checked
    return checked


def numbers_of(name: str) -> tuple[str, ...]:
    """Names of the numbers that a check reads from the ledger."""
    return tuple(inspect.signature(CHECKS[name]).parameters)
