"""The checks and the numbers that the ledger can name.

The body of a function's docstring is the argument that the report prints: for a check, its proof. Its
formulas are between dollar signs, in the syntax of Typst, with vectors in bold; @id refers to an entry.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeVar

from flint import arb

from planar_pushing.certified.balls import Undecided, precise
from planar_pushing.evidence.claims.verdicts import Evidence, Fails, Verdict

Function = TypeVar("Function", bound=Callable[..., Any])


@dataclass(frozen=True, slots=True)
class Check:
    """A function that returns evidence, the verdict if it holds, and its argument."""

    function: Callable[..., Evidence]
    kind: Verdict
    how: str

    def run(self, **given: Any) -> Evidence:
        """Evidence at the working precision, with a verdict no stronger than the kind of the check.

        If balls do not decide a sign, the claim is undecided; a number that does not exist refutes it.
        """
        try:
            return precise(self.function)(**given).at_most(self.kind)
        except Undecided as error:
            return Evidence(verdict=Verdict.UNDECIDED, reason=str(error))
        except Fails as error:
            return Evidence(verdict=Verdict.REFUTED, reason=str(error))


@dataclass(frozen=True, slots=True)
class Quantity:
    """A function that encloses one number or several, the index of this one, its unit, and the argument."""

    function: Callable[..., Any]
    place: int | None
    unit: str
    how: str

    def value(self, **given: Any) -> arb:
        """Enclose the number."""
        found: Any = self.function(**given)
        number: arb = found if self.place is None else found[self.place]
        return number


CHECKS: dict[str, Check] = {}
QUANTITIES: dict[str, Quantity] = {}


def proof(function: Function) -> Function:
    """Register a check that covers everything that its statement is about."""
    return _registered(function, Verdict.PROVED)


def sample(function: Function) -> Function:
    """Register a check at the points of a grid or of a random sample."""
    return _registered(function, Verdict.SAMPLED)


def _registered(function: Function, kind: Verdict) -> Function:
    CHECKS[function.__name__.replace("_", "-")] = Check(function, kind, _how(function))
    return function


def quantity(unit: str | None = None, **units: str) -> Callable[[Function], Function]:
    """Register a number by its unit, or several numbers of one function, in order, by name."""

    def register(function: Function) -> Function:
        name, how = function.__name__, _how(function)
        if unit is not None:
            QUANTITIES[name] = Quantity(function, None, unit, how)
        for place, (part, own) in enumerate(units.items()):
            QUANTITIES[f"{name}.{part}"] = Quantity(function, place, own, how)
        return function

    return register


def _how(function: Callable[..., Any]) -> str:
    summary, _, body = inspect.cleandoc(function.__doc__ or "").partition("\n\n")
    return " ".join((body or summary).split())


def arguments(function: Callable[..., Any]) -> dict[str, bool]:
    """Names of a function's arguments, and whether each is required."""
    listed = inspect.signature(function).parameters.items()
    return {name: each.default is each.empty for name, each in listed}
