"""The ledger file: an entry for each statement, with its checks, and clear errors."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from functools import partial
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field

from planar_pushing.certified.setting import Effects
from planar_pushing.evidence.claims import checks as checks  # registers its checks and numbers
from planar_pushing.evidence.claims import samples as samples  # registers those of the library
from planar_pushing.evidence.claims.checks import generic
from planar_pushing.evidence.claims.registry import CHECKS, QUANTITIES, Check, arguments
from planar_pushing.evidence.claims.verdicts import Verdict
from planar_pushing.study.files.fields import FileModel, NotEmpty, Number, refuse
from planar_pushing.study.files.replacing import PathLike
from planar_pushing.study.files.scenes import load_model
from planar_pushing.terms.errors import InvalidFile, suggestion

_KEBAB = frozenset("abcdefghijklmnopqrstuvwxyz0123456789-")
#: Words that an argument accepts as its value.
_WORDS = {"effects": tuple(map(str, Effects)), "law": tuple(generic.LAWS)}
#: Kinds of a check, with the names that each accepts, and relations of a number to the claimed one.
_OPTIONS: dict[str, dict[str, Any]] = {
    "check": CHECKS, "number": QUANTITIES, "modes": generic.MODES
}  # fmt: skip
_RELATIONS = ("near", "equals", "above", "below")


def _kebab(given: object) -> object:
    if not isinstance(given, str) or not given or not set(given) <= _KEBAB:
        raise refuse("a name of small letters, digits and dashes")
    return given


def _value(given: object) -> object:
    if isinstance(given, str):
        return given
    if isinstance(given, bool) or not isinstance(given, (int, float)) or math.isnan(given):
        raise refuse("a number, inf, or the name of effects or of a contact law")
    return float(given)


Kebab = Annotated[str, BeforeValidator(_kebab)]
Text = Annotated[str, Field(min_length=1)]
Places = tuple[Annotated[int, Field(ge=1, le=13)], ...]
Values = dict[str, Annotated[Any, BeforeValidator(_value)]]


class CheckEntry(FileModel):
    """A check of a statement: one by name, a number, or the modes of a push.

    The arguments of a check are the numbers in `claimed`; those of a number or a push are given in
    `at`. A number is near (`within` an accuracy), equal to, above or below the claimed one.
    """

    name: Kebab | None = None
    statement: Text | None = None
    check: str | None = None
    claimed: Values = Field(default_factory=dict)
    number: str | None = None
    modes: tuple[str, ...] | None = None
    at: Values = Field(default_factory=dict)
    near: Number | None = None
    within: Number | None = None
    equals: Number | None = None
    above: Number | None = None
    below: Number | None = None

    @property
    def title(self) -> str:
        """The name of the check, or else that of its kind."""
        return self.name or self.check or self.number or "modes"

    @property
    def relations(self) -> dict[str, float]:
        """Relations of the number to the claimed one."""
        found = {each: getattr(self, each) for each in _RELATIONS}
        return {each: claimed for each, claimed in found.items() if claimed is not None}

    def resolved(self) -> Check:
        """Return the check; its function takes no arguments."""
        if self.check is not None:
            found = CHECKS[self.check]
            return Check(partial(found.function, **self.claimed), found.kind, found.how)
        if self.modes is not None:
            run = partial(generic.modes, self.modes, **self.at)
            return Check(run, Verdict.ENCLOSED, generic.MODES_HOW)
        quantity, ((relation, claimed),) = QUANTITIES[str(self.number)], self.relations.items()
        run = partial(generic.number, quantity, self.at, relation, claimed, self.within or 0.0)
        return Check(run, Verdict.ENCLOSED, quantity.how)


class Claim(FileModel):
    """A statement, its checks, and the expected verdict."""

    id: Kebab
    section: Literal["1", "2", "3", "3.1", "3.2", "4", "5"]
    equations: Places = ()
    figures: Places = ()
    origin: Literal["paper", "ours"]
    statement: Text
    expect: Literal["proved", "enclosed", "sampled", "open", "refuted"]
    reason: Text | None = None
    checks: tuple[CheckEntry, ...] = ()

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
    ids: set[str] = set()
    for index, claim in enumerate(ledger.claims):
        where, names = f"claims[{index}] ({claim.id})", set[str]()
        yield from _twice(claim.id, ids, f"{where}.id")
        yield from _of_claim(claim, where)
        for place, entry in enumerate(claim.checks):
            yield from _twice(entry.title, names, f"{where}.checks[{place}].name")
            yield from _of_check(entry, f"{where}.checks[{place}]")


def _twice(name: str, seen: set[str], where: str) -> Iterator[str]:
    if name in seen:
        yield f"{where}: {name!r} given twice; allowed: a unique name; rename it"
    seen.add(name)


def _of_claim(claim: Claim, where: str) -> Iterator[str]:
    is_open = claim.expected is Verdict.OPEN
    if not claim.reason and (is_open or claim.expected is Verdict.REFUTED):
        yield f"{where}.reason: missing; allowed: why the claim is {claim.expect}; add it"
    if is_open == bool(claim.checks):
        given = f"{len(claim.checks)} given" if is_open else "missing"
        allowed = "none where nothing can be checked" if is_open else "at least one"
        yield f"{where}.checks: {given}; allowed: {allowed}; {'remove them' if is_open else 'add it'}"


def _of_check(entry: CheckEntry, where: str) -> Iterator[str]:
    kinds = [kind for kind in _OPTIONS if getattr(entry, kind) is not None]
    if len(kinds) != 1:
        given = " and ".join(kinds) or "none"
        yield f"{where}: {given} given; allowed: one of {', '.join(_OPTIONS)}; give one"
        return
    if len(entry.relations) != (kinds[0] == "number"):
        given, allowed = " and ".join(entry.relations) or "none", ", ".join(_RELATIONS)
        yield f"{where}: {given} given; allowed: for a number one of {allowed}; give one"
    if (entry.within is None) != (entry.near is None):
        yield f"{where}.within: {entry.within} given; allowed: an accuracy with near; change it"
    yield from _of_kind(entry, kinds[0], where)


def _of_kind(entry: CheckEntry, kind: str, where: str) -> Iterator[str]:
    """Problems with the names of a check, a number or modes, and with the arguments."""
    given, options = getattr(entry, kind), _OPTIONS[kind]
    unknown = [
        name for name in ([given] if isinstance(given, str) else given) if name not in options
    ]
    for name in unknown:
        remedy = suggestion(name, options, "give an existing name")
        yield f"{where}.{kind}: {name!r} given; allowed: the {kind} of the package; {remedy}"
    if not unknown:
        function = generic.modes if kind == "modes" else options[given].function
        used, unused = ("claimed", "at") if kind == "check" else ("at", "claimed")
        if values := getattr(entry, unused):
            yield f"{where}.{unused}: {values!r} given; allowed: none; give it as {used}"
        yield from _arguments(function, getattr(entry, used), f"{where}.{used}")


def _arguments(function: Callable[..., Any], given: Values, where: str) -> Iterator[str]:
    takes = {name: needed for name, needed in arguments(function).items() if name != "expected"}
    allowed = f"the arguments {', '.join(takes)}" if takes else "no arguments"
    for name in takes:
        if takes[name] and name not in given:
            yield f"{where}.{name}: missing; allowed: {allowed}; add it"
    for name, value in given.items():
        words = _WORDS.get(name, ())
        if name not in takes:
            yield f"{where}.{name}: {value!r} given; allowed: {allowed}; remove it"
        elif value not in words and (isinstance(value, str) or name == "effects"):
            allowed = ", ".join(words) or "a number"
            yield f"{where}.{name}: {value!r} given; allowed: {allowed}; change it"
