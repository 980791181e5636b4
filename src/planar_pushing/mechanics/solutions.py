"""Results of `solve`: the consistent solutions of one pushing problem, or of an array of problems."""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields
from enum import IntEnum
from typing import TYPE_CHECKING, Any, SupportsIndex, overload

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.angles import RESOLUTION
from planar_pushing.mechanics.arrays import component_labels, dataset, named, same
from planar_pushing.mechanics.contact import ContactMode, Outcome, Status
from planar_pushing.mechanics.entries import to_json
from planar_pushing.mechanics.force.derivatives import Derivatives
from planar_pushing.mechanics.pictures import picture
from planar_pushing.mechanics.plane import Array
from planar_pushing.terms.errors import InvalidValue, number_of
from planar_pushing.terms.options import BEHIND

if TYPE_CHECKING:
    import xarray as xr

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
#: Variables with one value per problem, and dimension of the components of a vector; all other variables
#: have one value per solution.
COUNTS = ("solutions", "status")
PARTS = {
    **dict.fromkeys(("force", "force_end", "contact_motion", "center"), ("xy",)),
    "twist": ("twist_component",),
    "end_forces": ("end", "bound", "xy"),
}
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
        Other end of the range of forces if a pivot leaves the force undetermined; otherwise `force`.
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
        values = {name: _plain(value) for name, value in _values(self).items() if value is not None}
        if self.end_forces is None:
            del values["flush"]
        return values | {"adhesive": self.adhesive}

    def to_json(self) -> str:
        """JSON of `to_dict`; inf, -inf and nan, which JSON lacks, are written as words."""
        return to_json(self.to_dict())


def _outcome(count: Any, status: Any) -> Any:
    """`Outcome` of pushes with a number of solutions and a status; a continuum is several solutions."""
    several = int(Outcome.AMBIGUOUS)
    return np.maximum(np.minimum(count, several), several * (status == int(Status.CONTINUUM)))


def _values(one: Any) -> dict[str, Any]:
    return {each.name: getattr(one, each.name) for each in fields(one)}


def _plain(value: Any) -> Any:
    """A value without numpy types, enumerations and negative zeros."""
    if isinstance(value, Derivatives):
        return {name: _plain(each) for name, each in _values(value).items()}
    if isinstance(value, IntEnum):
        return value.name
    if isinstance(value, (bool, np.bool_)):
        return bool(value)
    return (np.asarray(value) + 0).tolist()


@dataclass(frozen=True, slots=True, repr=False)
class Solutions:
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
    def outcome(self) -> Outcome:
        return Outcome(int(_outcome(len(self.solutions), self.status)))

    @property
    def modes(self) -> tuple[ContactMode, ...]:
        return tuple(solution.mode for solution in self.solutions)

    def __iter__(self) -> Iterator[Solution]:
        return iter(self.solutions)

    def __len__(self) -> int:
        return len(self.solutions)

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
        return tuple(each for each in self.solutions if each.mode is mode)

    def to_dict(self) -> dict[str, Any]:
        """Plain values: the names of outcome and status, and the solutions as in `Solution.to_dict`."""
        return {
            "outcome": self.outcome.name,
            "status": self.status.name,
            "solutions": [each.to_dict() for each in self.solutions],
        }

    def to_json(self) -> str:
        """JSON of `to_dict`; inf, -inf and nan, which JSON lacks, are written as words."""
        return to_json(self.to_dict())

    def __repr__(self) -> str:
        return f"{self._title}\n{self._table().to_string()}" if self.solutions else self._title

    def _repr_html_(self) -> str:
        """Picture and table for a notebook."""
        drawn = picture("push", *self.problem, self) if self.problem else None
        title = f"{drawn or ''}<p>{self._title}</p>"
        return f"{title}\n{self._table().to_html()}" if self.solutions else title

    @property
    def _title(self) -> str:
        count = len(self.solutions)
        title = f"{self.outcome}: {count} consistent solution{'' if count == 1 else 's'}"
        return f"{title}, of a continuum" if self.status is Status.CONTINUUM else title

    def _table(self) -> Any:
        """A pandas table with one row per number and one column per solution."""
        import pandas as pd

        words = [word for each in NUMBERS.values() for word in each]
        rows = printed(self)
        columns = [
            [_short(x) for x in np.hstack([each[name] for name in NUMBERS])] for each in rows
        ]
        if self.solutions[0].end_forces is not None:
            words += ON_SIDE_WORDS
            for one, each, column in zip(self, rows, columns, strict=True):
                bounds = each["end_forces"].transpose(0, 2, 1).reshape(4, 2)
                column += ["yes" if one.flush else "no", _short(each["force_position"].item())]
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


def printed(solutions: Solutions) -> list[dict[str, Array]]:
    """The numbers of each solution by name, with 0 for rounding errors and negative zeros.

    Forces are compared with the largest force of the solutions, motions with the largest motion, rotations
    with that motion divided by the slider's reach, and coordinates of the center with the reach or, if
    larger, with the other coordinate.
    """
    on_side = ON_SIDE if any(one.end_forces is not None for one in solutions) else ()
    names = (*NUMBERS, "force_end", *on_side)
    rows = [{name: np.asarray(getattr(one, name)) for name in names} for one in solutions]
    force = _largest(each[name] for each in rows for name in ("force", "force_end"))
    motion = _largest(part for each in rows for part in (each["contact_motion"], each["twist"][:2]))
    reach = _reach(solutions.problem)
    turn = motion / reach if reach else 0.0
    scales: dict[str, Any] = {
        "force": force, "force_end": force, "end_forces": force, "contact_motion": motion,
        "spin_ratio": 1.0,
        "twist": np.array([motion, motion, turn]),
    }  # fmt: skip
    for each in rows:
        for name, value in each.items():
            scale = scales.get(name, max(reach, _largest([value])))
            each[name] = np.where(np.abs(value) < ROUNDING * scale, 0.0, value) + 0.0
    return rows


def _largest(vectors: Iterable[Array]) -> float:
    """The largest finite component."""
    finite = (np.abs(each[np.isfinite(each)]).max(initial=0.0) for each in vectors)
    return float(max(finite, default=0.0))


def _reach(problem: tuple[Any, float, float] | None) -> float:
    """Size of a slider including its rod; 0 if unknown."""
    if problem is None:
        return 0.0
    slider = problem[0].slider
    return float(max(slider.rod_length, slider.radius))


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class SolutionArrays:
    """All consistent solutions of an array of pushing problems of shape S, padded along one axis.

    An index over S picks problems: with two axes ``arrays[i, j]`` gives `Solutions`; an index that keeps an
    axis, such as a slice or a mask, gives `SolutionArrays`.

    Attributes
    ----------
    solutions : ndarray of int, shape S
        Number of solutions.
    mode : ndarray of int, shape S + (solutions,)
        Values of `ContactMode`, in order; -1 after the last solution, where all other values are NaN.
    force, force_end, contact_motion, center : ndarray, shape S + (solutions, 2)
    twist : ndarray, shape S + (solutions, 3)
        omega in radians per unit of time.
    status : ndarray of int, shape S
        Values of `Status`.
    spin_ratio, pivot, continuum : ndarray, shape S + (solutions,)
        As in `Solution`.
    flush, force_position : ndarray, shape S + (solutions,), optional
        For scenes with a flush side, as in `Solution`.
    end_forces : ndarray, shape S + (solutions, 2, 2, 2), optional
    derivatives : Derivatives, optional
        Of shape S + (solutions,).
    """

    solutions: npt.NDArray[np.int8]
    status: npt.NDArray[np.int8]
    mode: npt.NDArray[np.int8]
    force: Array
    force_end: Array
    twist: Array
    contact_motion: Array
    spin_ratio: Array
    center: Array
    pivot: npt.NDArray[np.int32]
    continuum: npt.NDArray[np.bool_]
    flush: npt.NDArray[np.bool_] | None = None
    force_position: Array | None = None
    end_forces: Array | None = None
    derivatives: Derivatives | None = None

    def __eq__(self, other: object) -> Any:
        return same(self, other)

    @property
    def consistent(self) -> npt.NDArray[np.bool_]:
        """Which places along the axis hold a solution, shape S + (solutions,)."""
        return self.mode >= 0

    @property
    def outcome(self) -> npt.NDArray[np.int8]:
        """Values of `Outcome`, shape S."""
        outcomes: npt.NDArray[np.int8] = _outcome(self.solutions, self.status).astype(np.int8)
        return outcomes

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape S."""
        return self.solutions.shape

    def __len__(self) -> int:
        return len(self.solutions)

    def __getitem__(self, index: Any) -> Any:
        if isinstance(index, ContactMode):  # also an integer, which would pick a problem
            raise InvalidValue(
                "index", index, "numbers, slices and masks over the problems",
                "find a mode with arrays.mode == mode",
            )  # fmt: skip
        places = np.arange(self.solutions.size).reshape(self.shape)[index]
        values = {name: self._flat(value)[places] for name, value in self._fields().items()}
        by = self.derivatives and self.derivatives[np.unravel_index(places, self.shape)]
        return (
            SolutionArrays(**values, derivatives=by)
            if np.ndim(places)
            else listed(values, None, by)
        )

    def __repr__(self) -> str:
        outcomes, modes = _counted(Outcome, self.outcome), _counted(ContactMode, self.mode)
        status = _counted(Status, self.status)
        lines = (f"outcomes: {outcomes}", f"modes: {modes}", f"status: {status}")
        return "\n".join((f"SolutionArrays of shape {self.shape}", *lines))

    def to_dataset(self, dims: Sequence[Hashable] | None = None) -> xr.Dataset:
        """The dataset that `solve` returns for labeled arrays, with units and flags.

        Parameters
        ----------
        dims : sequence of str, optional
            Names of the axes of S, by default dim_0, dim_1, ...

        Raises
        ------
        InvalidValue
            If there are more or fewer names than axes, or a name is not unique.
        """
        import xarray as xr

        axes = [f"dim_{i}" for i in range(len(self.shape))] if dims is None else list(dims)
        tails = list(dict.fromkeys(dim for name in self._fields() for dim in _tail(name)))
        if isinstance(dims, str) or len({*axes, *tails}) != len(self.shape) + len(tails):
            others = f"{', '.join(tails[:-1])} or {tails[-1]}"
            raise InvalidValue(
                "dims", dims,
                f"{number_of(len(self.shape), 'name')}, none of them {others}",
                f"name each axis of the shape {self.shape}",
            )  # fmt: skip
        return as_dataset(
            {
                name: named(name, xr.DataArray(value, dims=[*axes, *_tail(name)]))
                for name, value in self._fields().items()
            }
        )

    def _fields(self) -> dict[str, Any]:
        values = _values(self)
        del values["derivatives"]
        return {name: value for name, value in values.items() if value is not None}

    def _flat(self, value: Any) -> Any:
        """An array with the axes of S merged into one."""
        return value.reshape(self.solutions.size, *value.shape[len(self.shape) :])


def _tail(name: str) -> list[str]:
    """Dimensions of a variable after those of the problems."""
    if name in COUNTS:
        return []
    return ["solution", *PARTS.get(name, ())]


def _counted(kind: type[IntEnum], values: Any) -> str:
    """Number of occurrences of each member, as text."""
    counts = {each.name: int(np.count_nonzero(values == each)) for each in kind}
    return ", ".join(f"{count} {name}" for name, count in counts.items() if count) or "none"


def listed(
    values: Mapping[str, Any],
    problem: tuple[Any, float, float] | None = None,
    derivatives: Derivatives | None = None,
) -> Solutions:
    """The solutions of one problem, from the variables of `SolutionArrays` without the axes of S."""
    own = {name: each for name, each in values.items() if name not in COUNTS}
    entries = {name: each if each.ndim > 1 else each.tolist() for name, each in own.items()}
    count = int(values["solutions"])
    entries["mode"] = list(map(ContactMode, entries["mode"][:count]))
    return Solutions(
        tuple(
            Solution(
                **{name: each[i] for name, each in entries.items()},
                derivatives=derivatives and derivatives[i],
            )
            for i in range(count)
        ),
        Status(int(values["status"])),
        problem,
    )


def as_dataset(values: Mapping[str, Any]) -> xr.Dataset:
    """The solutions of labeled problems, from the labeled variables of `SolutionArrays`."""
    mode, count = values["mode"], values["solutions"]
    consistent = named("consistent", mode >= 0)
    outcome = named("outcome", _outcome(count, values["status"]).astype(np.int8))
    commented = {**values, "mode": mode.assign_attrs(comment=BEHIND)}
    merged: xr.Dataset = dataset([*commented.values(), consistent, outcome])
    labels = component_labels()
    if "end_forces" in values:
        labels |= {"end": ["start", "end"], "bound": ["low", "high"]}
    return merged.assign_coords(labels)
