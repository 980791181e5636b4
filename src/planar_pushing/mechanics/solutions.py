"""The result of `solve` for one pushing problem: its consistent solutions, and how they are printed."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, fields
from enum import IntEnum
from typing import Any, Generic, SupportsIndex, TypeVar, overload

import numpy as np

from planar_pushing.mechanics.angles import RESOLUTION
from planar_pushing.mechanics.contact import ContactMode, Outcome, Status
from planar_pushing.mechanics.entries import to_json
from planar_pushing.mechanics.force.derivatives import Derivatives
from planar_pushing.mechanics.kernels.arrays import same
from planar_pushing.mechanics.pictures import picture
from planar_pushing.mechanics.plane import Array
from planar_pushing.terms.errors import InvalidValue

#: Numbers of a solution in the printed table; vectors by component.
NUMBERS = {
    "force": ("force x", "force y"),
    "contact_motion": ("motion x", "motion y"),
    "twist": ("v_x", "v_y", "omega"),
    "spin_ratio": ("spin ratio",),
    "center": ("center x", "center y"),
}
#: A number below this fraction of the largest of its kind is rounding error and is printed as 0.
ROUNDING = 1e-12
#: Numbers of a solution of a side on the fence, in the table of all solutions.
ON_SIDE = ("force_position", "end_forces")
ON_SIDE_WORDS = ("flush", "force at", "start x", "start y", "end x", "end y")


@dataclass(frozen=True, slots=True, kw_only=True)
class Solution:
    """One consistent solution, in the fence frame: +x along the fence, +y its normal into the slider.

    Attributes
    ----------
    mode : ContactMode
    force : ndarray, shape (2,)
        Force of the pusher on the slider.
    force_end : ndarray, shape (2,)
        Other end of the range of forces if a pivot leaves the force undetermined; otherwise `force`. The
        range of a slip begins at its smaller end. If that is zero, the motion without a contact force is
        the same, and is not listed besides.
    contact_motion : ndarray, shape (2,)
        Velocity or initial acceleration of the slider at the contact; of a side, at the end that touches
        the fence, or at its origin.
    twist : ndarray, shape (3,)
        (v_x, v_y, omega) at the slider's center, omega in radians per unit of time.
    spin_ratio : float
        k = R omega / v; 0 at rest.
    center : ndarray, shape (2,)
        Motion center relative to the contact, or to the origin of a side; infinite for a translation, NaN
        at rest.
    pivot : int
        Number of the support point about which the slider pivots, -1 without one.
    continuum : bool
        Whether this is one of a continuum of motions, all of which are solutions. It is an end of them, and
        the other end is another slip, the sticking motion, or rest; or, if the support is on one line
        through the contact that moves across itself, only the rotation is undetermined: the center can be
        anywhere on that line between the two neighboring points of the support, and `twist` is the limit
        for a motion slightly aside.
    flush : bool
        Whether the side of the slider lies on the fence; False also for a contact at one point.
    force_position : float, optional
        For a scene with a flush side: where the line of action of the force crosses the fence, from the
        origin of the side; NaN without a force, or for a force along the fence.
    end_forces : ndarray, shape (end, bound, xy) = (2, 2, 2), optional
        For a scene with a flush side: the forces at the start and the end of the side to which the pressure
        along it is equivalent, each by its lower and upper bounds. The tangential forces of a sticking side
        are only known in sum, so they have a range, which is infinite under infinite friction.
    derivatives : Derivatives, optional
        Derivatives of twist and force, if requested from `solve`.
    """

    mode: ContactMode
    force: Array
    force_end: Array
    contact_motion: Array
    twist: Array
    spin_ratio: float
    center: Array
    pivot: int
    continuum: bool
    flush: bool = False
    force_position: float | None = None
    end_forces: Array | None = None
    derivatives: Derivatives | None = None

    def __eq__(self, other: object) -> Any:
        return same(self, other)

    @property
    def adhesive(self) -> bool:
        """Whether the fence pulls on the slider, as only a perfectly rough contact can."""
        normal = self.force[1] if self.end_forces is None else self.end_forces[..., 1].min()
        return bool(normal < -RESOLUTION * np.hypot(*self.force))

    def to_dict(self) -> dict[str, Any]:
        """Plain values by name: the name of the mode, numbers, lists of numbers, and any derivatives."""
        values = {
            name: plain(value) for name, value in field_values(self).items() if value is not None
        }
        if self.end_forces is None:
            del values["flush"]
        return values | {"adhesive": self.adhesive}

    def to_json(self) -> str:
        """JSON of `to_dict`; inf, -inf and nan, which JSON lacks, are written as words."""
        return to_json(self.to_dict())


def outcome_of(count: Any, status: Any) -> Any:
    """`Outcome` of pushes with a number of solutions and a status; a continuum is several solutions."""
    several = int(Outcome.AMBIGUOUS)
    return np.maximum(np.minimum(count, several), several * (status == int(Status.CONTINUUM)))


def field_values(instance: Any) -> dict[str, Any]:
    """Values of the fields of a dataclass by name, unlike those of `asdict` not copied."""
    return {part.name: getattr(instance, part.name) for part in fields(instance)}


def plain(value: Any) -> Any:
    """A value without numpy types, enumerations and negative zeros."""
    if isinstance(value, Derivatives):
        return {name: plain(part) for name, part in field_values(value).items()}
    if isinstance(value, IntEnum):
        return value.name
    if isinstance(value, (bool, np.bool_)):
        return bool(value)
    return (np.asarray(value) + 0).tolist()


One = TypeVar("One")


class SolutionSequence(ABC, Generic[One]):
    """What results have in common that hold all consistent solutions of one problem."""

    __slots__ = ()
    solutions: tuple[One, ...]
    status: Status

    @property
    def outcome(self) -> Outcome:
        """How many solutions there are; a continuum counts as several."""
        return Outcome(int(outcome_of(len(self.solutions), self.status)))

    def __iter__(self) -> Iterator[One]:
        return iter(self.solutions)

    def __len__(self) -> int:
        return len(self.solutions)

    @abstractmethod
    def to_dict(self) -> dict[str, Any]:
        """Plain values by name."""

    def to_json(self) -> str:
        """JSON of `to_dict`; inf, -inf and nan, which JSON lacks, are written as words."""
        return to_json(self.to_dict())

    def _title_with(self, ending: str) -> str:
        """Outcome and number of solutions in words, with an ending."""
        count = len(self.solutions)
        return f"{self.outcome}: {count} consistent solution{'' if count == 1 else 's'}{ending}"


@dataclass(frozen=True, slots=True, repr=False)
class Solutions(SolutionSequence[Solution]):
    """All consistent solutions of one pushing problem, in the order of `ContactMode`.

    Of one mode, flush solutions of a side come first, then contacts at its start, then at its end. Slips
    of the same mode are ordered by speed. ``solutions[0]`` is the first solution. Printing shows one column
    per solution; a notebook also shows a picture. `problem` holds the scene, the direction of the push in
    radians, and its magnitude.
    """

    solutions: tuple[Solution, ...]
    status: Status = Status.CONSISTENT
    problem: tuple[Any, float, float] | None = field(default=None, compare=False)

    @property
    def modes(self) -> tuple[ContactMode, ...]:
        return tuple(solution.mode for solution in self.solutions)

    @overload
    def __getitem__(self, index: SupportsIndex) -> Solution: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[Solution, ...]: ...
    def __getitem__(self, index: Any) -> Any:
        if isinstance(index, ContactMode):  # also an integer, which would pick another solution
            raise InvalidValue(
                "index", index, "the number of a solution, or a slice",
                "pick the solutions of a mode with solutions.of(mode)",
            )  # fmt: skip
        return self.solutions[index]

    def of(self, mode: ContactMode) -> tuple[Solution, ...]:
        """The solutions of a contact mode."""
        return tuple(solution for solution in self.solutions if solution.mode is mode)

    def to_dict(self) -> dict[str, Any]:
        """Plain values: the names of outcome and status, and the solutions as in `Solution.to_dict`."""
        return {
            "outcome": self.outcome.name,
            "status": self.status.name,
            "solutions": [solution.to_dict() for solution in self.solutions],
        }

    def __repr__(self) -> str:
        return f"{self._title}\n{self._table().to_string()}" if self.solutions else self._title

    def _repr_html_(self) -> str:
        """Picture and table for a notebook."""
        drawn = picture("push", *self.problem, self) if self.problem else None
        title = f"{drawn or ''}<p>{self._title}</p>"
        return f"{title}\n{self._table().to_html()}" if self.solutions else title

    @property
    def _title(self) -> str:
        return self._title_with(", of a continuum" if self.status is Status.CONTINUUM else "")

    def _table(self) -> Any:
        """A pandas table with one row per number and one column per solution."""
        import pandas as pd

        words = [word for components in NUMBERS.values() for word in components]
        rows = printed_numbers(self)
        columns = [[_short(x) for x in np.hstack([row[name] for name in NUMBERS])] for row in rows]
        if self.solutions[0].end_forces is not None:
            words += ON_SIDE_WORDS
            for solution, row, column in zip(self, rows, columns, strict=True):
                bounds = row["end_forces"].transpose(0, 2, 1).reshape(4, 2)
                column += ["yes" if solution.flush else "no", _short(row["force_position"].item())]
                column += [_range(*pair) for pair in bounds]
        return pd.DataFrame(dict(enumerate(columns)), words).set_axis(
            list(map(str, self.modes)), axis=1
        )


def _short(number: float) -> str:
    """Text of a number in the table; a slider at rest has no center."""
    return "none" if np.isnan(number) else f"{number:.6g}"


def _range(low: float, high: float) -> str:
    """Text of a range of forces in the table, or of the only force in it."""
    return _short(low) if low == high else f"{_short(low)} to {_short(high)}"


def printed_numbers(solutions: Solutions) -> list[dict[str, Array]]:
    """The numbers of each solution by name, with 0 for rounding errors and negative zeros.

    Forces are compared with the largest force of the solutions, motions with the largest motion, rotations
    with that motion divided by the slider's reach, and coordinates of the center with the reach or, if
    larger, with the other coordinate.
    """
    on_side = ON_SIDE if any(one.end_forces is not None for one in solutions) else ()
    names = (*NUMBERS, "force_end", *on_side)
    rows = [{name: np.asarray(getattr(one, name)) for name in names} for one in solutions]
    force = _largest(row[name] for row in rows for name in ("force", "force_end"))
    motion = _largest(part for row in rows for part in (row["contact_motion"], row["twist"][:2]))
    reach = _reach(solutions.problem)
    turn = motion / reach if reach else 0.0
    scales: dict[str, Any] = {
        "force": force, "force_end": force, "end_forces": force, "contact_motion": motion,
        "spin_ratio": 1.0,
        "twist": np.array([motion, motion, turn]),
    }  # fmt: skip
    for row in rows:
        for name, value in row.items():
            scale = scales.get(name, max(reach, _largest([value])))
            row[name] = drop_rounding(value, scale)
    return rows


def drop_rounding(value: Array, scale: Any) -> Array:
    """Numbers to print, with 0 for negative zeros and for rounding errors of numbers of a scale."""
    kept: Array = np.where(np.abs(value) < ROUNDING * scale, 0.0, value) + 0.0
    return kept


def _largest(vectors: Iterable[Array]) -> float:
    """The largest finite component."""
    finite = (np.abs(vector[np.isfinite(vector)]).max(initial=0.0) for vector in vectors)
    return float(max(finite, default=0.0))


def _reach(problem: tuple[Any, float, float] | None) -> float:
    """Size of a slider including its rod; 0 if unknown."""
    if problem is None:
        return 0.0
    slider = problem[0].slider
    return float(max(slider.rod_length, slider.radius))
