"""The result of `solve` for an array of pushing problems: arrays, or a dataset."""

from __future__ import annotations

from collections.abc import Hashable, Mapping, Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.contact import ContactMode, Outcome, Status
from planar_pushing.mechanics.force.derivatives import Derivatives
from planar_pushing.mechanics.kernels.arrays import component_labels, dataset, label_result, same
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.solutions import Solution, Solutions, field_values, outcome_of
from planar_pushing.terms.errors import InvalidValue, number_of
from planar_pushing.terms.options import BEHIND

if TYPE_CHECKING:
    import xarray as xr

#: Variables with one value per problem, and dimension of the components of a vector; all other variables
#: have one value per solution.
COUNTS = ("solutions", "status")
PARTS = {
    **dict.fromkeys(("force", "force_end", "contact_motion", "center"), ("xy",)),
    "twist": ("twist_component",),
    "end_forces": ("end", "bound", "xy"),
}


class ProblemArrays:
    """What results have in common that hold the solutions of an array of problems of shape S."""

    __slots__ = ()
    solutions: npt.NDArray[np.int8]
    status: npt.NDArray[np.int8]

    @property
    def outcome(self) -> npt.NDArray[np.int8]:
        """Values of `Outcome`, shape S."""
        outcomes: npt.NDArray[np.int8] = outcome_of(self.solutions, self.status).astype(np.int8)
        return outcomes

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape S."""
        return self.solutions.shape

    def __len__(self) -> int:
        return len(self.solutions)

    def _pick(self, values: Mapping[str, Any], places: Any) -> dict[str, Any]:
        """Arrays at places among the problems, whose axes are merged into one."""
        size, axes = self.solutions.size, len(self.shape)
        return {
            name: value.reshape(size, *value.shape[axes:])[places] for name, value in values.items()
        }


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class SolutionArrays(ProblemArrays):
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

    def __getitem__(self, index: Any) -> Any:
        if isinstance(index, ContactMode):  # also an integer, which would pick a problem
            raise InvalidValue(
                "index", index, "numbers, slices and masks over the problems",
                "find a mode with arrays.mode == mode",
            )  # fmt: skip
        places = np.arange(self.solutions.size).reshape(self.shape)[index]
        values = self._pick(self._fields(), places)
        by = self.derivatives and self.derivatives[np.unravel_index(places, self.shape)]
        return (
            SolutionArrays(**values, derivatives=by)
            if np.ndim(places)
            else solutions_from(values, None, by)
        )

    def __repr__(self) -> str:
        outcomes, modes = (
            count_members(Outcome, self.outcome),
            count_members(ContactMode, self.mode),
        )
        status = count_members(Status, self.status)
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
                name: label_result(name, xr.DataArray(value, dims=[*axes, *_tail(name)]))
                for name, value in self._fields().items()
            }
        )

    def _fields(self) -> dict[str, Any]:
        values = field_values(self)
        del values["derivatives"]
        return {name: value for name, value in values.items() if value is not None}


def _tail(name: str) -> list[str]:
    """Dimensions of a variable after those of the problems."""
    if name in COUNTS:
        return []
    return ["solution", *PARTS.get(name, ())]


def count_members(kind: type[IntEnum], values: Any) -> str:
    """Number of occurrences of each member, as text."""
    counts = {member.name: int(np.count_nonzero(values == member)) for member in kind}
    return ", ".join(f"{count} {name}" for name, count in counts.items() if count) or "none"


def solutions_from(
    values: Mapping[str, Any],
    problem: tuple[Any, float, float] | None = None,
    derivatives: Derivatives | None = None,
) -> Solutions:
    """The solutions of one problem, from the variables of `SolutionArrays` without the axes of S."""
    entries = entries_of_solutions(values)
    count = int(values["solutions"])
    entries["mode"] = list(map(ContactMode, entries["mode"][:count]))
    return Solutions(
        tuple(
            Solution(
                **{name: entry[i] for name, entry in entries.items()},
                derivatives=derivatives and derivatives[i],
            )
            for i in range(count)
        ),
        Status(int(values["status"])),
        problem,
    )


def entries_of_solutions(values: Mapping[str, Any]) -> dict[str, Any]:
    """The variables of one problem with an entry for each solution, numbers as those of Python."""
    return {
        name: value if value.ndim > 1 else value.tolist()
        for name, value in values.items()
        if np.ndim(value) > 0
    }


def as_dataset(values: Mapping[str, Any]) -> xr.Dataset:
    """The solutions of labeled problems, from the labeled variables of `SolutionArrays`."""
    mode, count = values["mode"], values["solutions"]
    consistent = label_result("consistent", mode >= 0)
    outcome = label_result("outcome", outcome_of(count, values["status"]).astype(np.int8))
    commented = {**values, "mode": mode.assign_attrs(comment=BEHIND)}
    merged: xr.Dataset = dataset([*commented.values(), consistent, outcome])
    labels = component_labels()
    if "end_forces" in values:
        labels |= {"end": ["start", "end"], "bound": ["low", "high"]}
    return merged.assign_coords(labels)
