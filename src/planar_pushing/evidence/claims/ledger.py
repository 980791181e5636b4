"""The ledger file: one entry for each claim, read with a clear error for what is wrong in it."""

from __future__ import annotations

import difflib
from collections.abc import Iterator
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field

from planar_pushing.evidence.claims import any_slider as any_slider  # registers its checks
from planar_pushing.evidence.claims import checks as checks  # registers every other
from planar_pushing.evidence.claims.proofs.registry import CHECKS, numbers_of
from planar_pushing.evidence.claims.proofs.verdicts import Verdict
from planar_pushing.study.files.fields import FileModel, NotEmpty, Number, refuse
from planar_pushing.study.files.replacing import PathLike
from planar_pushing.study.files.scenes import load_model
from planar_pushing.terms.errors import InvalidFile

#: Check of a claim that nothing can decide; its entry gives the reason.
NO_CHECK = "not-reproducible"

_KEBAB = frozenset("abcdefghijklmnopqrstuvwxyz0123456789-")
Section = Literal["1", "2", "3", "3.1", "3.2", "4", "5"]
Equation = Annotated[int, Field(ge=1, le=13)]


def _kebab(given: object) -> object:
    if not isinstance(given, str) or not given or not set(given) <= _KEBAB:
        raise refuse("a name of small letters, digits and dashes")
    return given


class Claim(FileModel):
    """A statement, the numbers that it names, its check, and the verdict that is expected."""

    id: Annotated[str, BeforeValidator(_kebab)]
    section: Section
    equation: Equation | None = None
    figure: Equation | None = None
    origin: Literal["paper", "ours"]
    statement: Annotated[str, Field(min_length=1)]
    claimed: dict[str, Number] = Field(default_factory=dict)
    check: str
    expect: Literal["proved", "verified on the grid", "not reproducible", "refuted"]
    reason: str | None = None

    @property
    def expected(self) -> Verdict:
        """The verdict that the entry expects."""
        return Verdict(self.expect)


class Ledger(FileModel):
    """All claims, in the order of the file."""

    claims: Annotated[tuple[Claim, ...], NotEmpty]


def load_ledger(path: PathLike) -> Ledger:
    """Read the ledger.

    Raises
    ------
    InvalidFile
        Naming the file, the key, the value, what is allowed and what to do.
    """
    ledger = load_model(path, Ledger)
    for problem in _problems(ledger):
        raise InvalidFile(f"{path}: {problem}")
    return ledger


def _problems(ledger: Ledger) -> Iterator[str]:
    seen: set[str] = set()
    for index, claim in enumerate(ledger.claims):
        where = f"claims[{index}] ({claim.id})"
        if claim.id in seen:
            yield f"{where}.id: {claim.id!r} given twice; allowed: an id of its own; rename it"
        seen.add(claim.id)
        if claim.check == NO_CHECK:
            yield from _undecidable(claim, where)
        elif claim.check not in CHECKS:
            near = difflib.get_close_matches(claim.check, CHECKS, n=1)
            remedy = f"did you mean {near[0]}?" if near else "write the check"
            yield f"{where}.check: {claim.check!r} given; allowed: a check of the package; {remedy}"
        else:
            yield from _numbers(claim, where)


def _undecidable(claim: Claim, where: str) -> Iterator[str]:
    if not claim.reason:
        yield f"{where}.reason: missing; allowed: why the claim cannot be checked; add it"
    if claim.claimed:
        yield f"{where}.claimed: {claim.claimed!r} given; allowed: nothing; remove it"


def _numbers(claim: Claim, where: str) -> Iterator[str]:
    wanted, given = numbers_of(claim.check), claim.claimed
    for name in wanted:
        if name not in given:
            allowed: Any = ", ".join(wanted)
            yield f"{where}.claimed.{name}: missing; allowed: the numbers {allowed}; add it"
    for name, value in given.items():
        if name not in wanted:
            allowed = ", ".join(wanted) or "none"
            yield f"{where}.claimed.{name}: {value!r} given; allowed: the numbers {allowed}; remove it"
