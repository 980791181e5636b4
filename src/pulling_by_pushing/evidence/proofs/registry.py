"""The checks and the numbers that the ledger can name."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from typing import Any, NamedTuple, TypeVar

from pulling_by_pushing.evidence.proofs.mechanics import Mechanics
from pulling_by_pushing.evidence.proofs.verdicts import Evidence, Verdict

Function = TypeVar("Function", bound=Callable[..., Any])


class Check(NamedTuple):
    """A function of the claimed numbers, and possibly of a mechanics, and the verdict if it holds."""

    function: Callable[..., Evidence]
    kind: Verdict

    @property
    def asks(self) -> bool:
        """Whether the check asks a mechanics; otherwise it is a matter of algebra."""
        return "mechanics" in inspect.signature(self.function).parameters

    def run(self, mechanics: Mechanics, **claimed: Any) -> Evidence:
        """Evidence, with a verdict no stronger than the kind."""
        arguments = (mechanics,) if self.asks else ()
        return self.function(*arguments, **claimed).at_most(self.kind)


class Number(NamedTuple):
    """A function of a mechanics and a scene, the index of the number in its result, and the unit."""

    function: Callable[..., Any]
    component: int | None
    unit: str


CHECKS: dict[str, Check] = {}
NUMBERS: dict[str, Number] = {}


def check(kind: Verdict) -> Callable[[Function], Function]:
    """Register a check by the name of its function."""

    def register(function: Function) -> Function:
        CHECKS[function.__name__.replace("_", "-")] = Check(function, kind)
        return function

    return register


#: Checks that cover everything that their statement is about, and checks at the points of a grid.
proof, sample = check(Verdict.PROVED), check(Verdict.SAMPLED)


def number(unit: str | None = None, **units: str) -> Callable[[Function], Function]:
    """Register a number by its unit, or several numbers of one function, in order, by name."""

    def register(function: Function) -> Function:
        if unit is not None:
            NUMBERS[function.__name__] = Number(function, None, unit)
        for component, part in enumerate(units):
            NUMBERS[f"{function.__name__}.{part}"] = Number(function, component, units[part])
        return function

    return register
