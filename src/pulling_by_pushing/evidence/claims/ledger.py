"""The ledger file: an entry for each statement, with its checks; and their verdicts."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields
from typing import Annotated, Any, Literal, Self

from pydantic import Field, model_validator

from planar_pushing.scenes.entries import SupportEntry
from planar_pushing.scenes.fields import FileModel, NotEmpty, Number, refuse
from planar_pushing.scenes.files import load_model
from planar_pushing.terms.errors import InvalidFile
from planar_pushing.terms.replacing import PathLike
from pulling_by_pushing.evidence.claims import (  # each registers its checks and numbers
    any_pressure as any_pressure,
)
from pulling_by_pushing.evidence.claims import (
    any_support as any_support,
)
from pulling_by_pushing.evidence.claims import (
    cones as cones,
)
from pulling_by_pushing.evidence.claims import (
    dynamics as dynamics,
)
from pulling_by_pushing.evidence.claims import (
    limit_curves as limit_curves,
)
from pulling_by_pushing.evidence.claims import (
    numbers as numbers,
)
from pulling_by_pushing.evidence.claims import (
    ring as ring,
)
from pulling_by_pushing.evidence.proofs.mechanics import Mechanics, Oracle, Scene
from pulling_by_pushing.evidence.proofs.registry import CHECKS, NUMBERS
from pulling_by_pushing.evidence.proofs.verdicts import (
    Evidence,
    Fails,
    Verdict,
    equal,
    facts,
    inequality,
    near,
    weakest,
)
from pulling_by_pushing.oracle.balls import Undecided, precise, rational

Id = Annotated[str, Field(pattern="^[a-z0-9-]+$")]
Text = Annotated[str, Field(min_length=1)]
PaperNumbers = tuple[Annotated[int, Field(ge=1, le=13)], ...]
#: Numbers and words of a statement, or of a scene, by name.
ClaimValues = dict[str, float | str]
_SCENE_KEYS = frozenset(part.name for part in fields(Scene))


class CheckEntry(FileModel):
    """A check of a statement: one by name, a number of a scene, or the contact modes of a push.

    The arguments of a check are in `claimed`; scene and arguments of a number or a push are in `at`.
    A number is near (`within` an accuracy), equal to, above or below the claimed one.
    """

    name: Id | None = None
    statement: Text | None = None
    check: str | None = None
    claimed: ClaimValues = Field(default_factory=dict)
    number: str | None = None
    modes: tuple[str, ...] | None = None
    at: ClaimValues = Field(default_factory=dict)
    near: Number | None = None
    within: Number | None = None
    equals: Number | None = None
    above: Number | None = None
    below: Number | None = None

    @model_validator(mode="after")
    def _is_one_check(self) -> Self:
        kinds = [self.check, self.number, self.modes]
        relations = [self.near, self.equals, self.above, self.below]
        if kinds.count(None) != 2 or 4 - relations.count(None) != (self.number is not None):
            raise refuse(
                "one of check, number and modes, and for a number one of near, equals, above, below"
            )
        if (self.near is None) != (self.within is None):
            raise refuse(
                "an accuracy, within, for a number that is near another one, and for no other"
            )
        if self.check not in {None, *CHECKS} or self.number not in {None, *NUMBERS}:
            raise refuse("a check or a number of the package")
        return self

    @property
    def title(self) -> str:
        """The name of the check, or else that of its kind."""
        return self.name or self.check or self.number or "modes"

    @property
    def argument(self) -> str:
        """Key of `Ledger.arguments`: the check, or the function of the number."""
        return self.check or (self.number or "modes").partition(".")[0]

    @precise
    def judge(self, mechanics: Mechanics, supports: Mapping[str, Any]) -> Evidence:
        """Evidence; raises `Fails` for a number that does not exist, `Undecided` for an undecided sign."""
        if self.check is not None:
            return CHECKS[self.check].run(mechanics, **self.claimed)
        parameters: dict[str, Any] = {key: self.at[key] for key in self.at if key in _SCENE_KEYS}
        if "support" in parameters:
            parameters["support"] = supports[parameters["support"]]
        further = {key: self.at[key] for key in self.at if key not in _SCENE_KEYS}
        ask = self._modes if self.number is None else self._number
        return ask(mechanics, Scene(**parameters), further).at_most(Verdict.ENCLOSED)

    def _number(self, mechanics: Mechanics, scene: Scene, further: ClaimValues) -> Evidence:
        function, component, unit = NUMBERS[str(self.number)]
        numbers = function(mechanics, scene, **further)
        value = numbers if component is None else numbers[component]
        if self.near is not None:
            return near(value, self.near, self.within or 0.0, unit)
        if self.equals is not None:
            return equal(value, self.equals, unit=unit)
        side, bound = (-1, self.below) if self.above is None else (1, self.above)
        return inequality(
            side * (value - rational(bound or 0)), value=value, unit=unit, claimed=bound
        )

    def _modes(self, mechanics: Mechanics, scene: Scene, push: Any) -> Evidence:
        """These modes, each as often as it is listed, are exactly the consistent ones."""
        expected = self.modes or ()
        consistent = [mode for mode, _ in mechanics.modes(scene, **{"magnitude": 1.0} | push)]
        text = f"{', '.join(expected) or 'none'} (there are: {', '.join(consistent) or 'none'})"
        return facts({text: Counter(consistent) == Counter(expected)})


class Claim(FileModel):
    """A statement, in full and in short, its checks, and the expected verdict."""

    id: Id
    section: Literal["1", "2", "3", "3.1", "3.2", "4", "5"]
    equations: PaperNumbers = ()
    figures: PaperNumbers = ()
    origin: Literal["paper", "ours"]
    short: Text
    statement: Text
    expect: Literal["proved", "enclosed", "sampled", "open", "refuted"]
    reason: Text | None = None
    checks: tuple[CheckEntry, ...] = ()

    @model_validator(mode="after")
    def _is_complete(self) -> Self:
        if (self.expect == "open") == bool(self.checks):
            raise refuse("checks for every claim except an open one")
        if (self.expect in ("open", "refuted")) != (self.reason is not None):
            raise refuse("a reason for a claim that is open or refuted, and for no other")
        return self


class Ledger(FileModel):
    """All claims, the supports that their checks name, and the arguments of the checks."""

    supports: dict[Id, SupportEntry]
    arguments: dict[str, Text]
    claims: Annotated[tuple[Claim, ...], NotEmpty]

    @model_validator(mode="after")
    def _names_exist(self) -> Self:
        lists = [[claim.id for claim in self.claims]]
        lists += [[check.title for check in claim.checks] for claim in self.claims]
        if any(len(set(names)) < len(names) for names in lists):
            raise refuse("a name for each claim, and within a claim for each check, only once")
        for claim, check in self.entries():
            if check.argument not in self.arguments:
                raise refuse(f"an argument for {check.argument}, a check of {claim.id}")
            if check.at.get("support") not in {None, *self.supports}:
                raise refuse(f"one of the supports {', '.join(self.supports)} in {claim.id}")
        return self

    def entries(self) -> Iterator[tuple[Claim, CheckEntry]]:
        """Every check with its claim."""
        return ((claim, check) for claim in self.claims for check in claim.checks)

    def judge(
        self, claim: Claim, entry: CheckEntry, mechanics: Mechanics | None = None
    ) -> Evidence:
        """Evidence of a check by the oracle, or by another mechanics.

        A number that does not exist refutes a claim; a sign that balls do not decide leaves it undecided.

        Raises
        ------
        InvalidFile
            If the check does not take these numbers, for example a rod of infinite length.
        """
        supports = {
            name: support.model_dump(exclude_none=True) for name, support in self.supports.items()
        }
        try:
            return entry.judge(mechanics or Oracle(), supports)
        except Undecided as error:
            return Evidence(verdict=Verdict.UNDECIDED, reason=str(error))
        except Fails as error:
            return Evidence(verdict=Verdict.REFUTED, reason=str(error))
        except (ArithmeticError, TypeError, ValueError) as error:
            raise InvalidFile(
                f"{claim.id}.{entry.title}: {entry.claimed or entry.at} given; allowed: numbers for which "
                f"the check is defined ({error}); change them"
            ) from None


@dataclass(frozen=True, slots=True, kw_only=True)
class Judged:
    """A claim, and the evidence of each of its checks."""

    claim: Claim
    evidence: tuple[Evidence, ...]

    @property
    def verdict(self) -> Verdict:
        """The verdict of the weakest check."""
        return weakest(part.verdict for part in self.evidence) if self.evidence else Verdict.OPEN


def load_ledger(path: PathLike) -> Ledger:
    """Read the ledger; an `InvalidFile` names the file, the key, the value and what is allowed."""
    return load_model(path, Ledger)


def judge_all(ledger: Ledger) -> list[Judged]:
    """Run every check, in the order of the ledger."""
    return [
        Judged(claim=claim, evidence=tuple(ledger.judge(claim, entry) for entry in claim.checks))
        for claim in ledger.claims
    ]
