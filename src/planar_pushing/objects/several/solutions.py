"""The result of `solve_contacts`: the solutions of one problem, or of an array of problems."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.contact import ContactMode, Outcome, Status
from planar_pushing.mechanics.entries import to_json
from planar_pushing.mechanics.kernels.arrays import (
    component_labels,
    dataset,
    flag_attributes,
    label_result,
    same,
)
from planar_pushing.mechanics.solutions import outcome_of
from planar_pushing.terms.numbers import Array
from planar_pushing.terms.options import Reason

#: A number below this fraction of the largest of its kind is rounding error and is printed as 0.
ROUNDING = 1e-12


@dataclass(frozen=True, slots=True, kw_only=True)
class ContactsSolution:
    """One consistent solution with n contacts, in the object's frame.

    Attributes
    ----------
    modes : tuple of ContactMode
        Of each contact. A slip to the right is along the tangent, the normal rotated by -90 degrees.
    twist : ndarray, shape (3,)
        (v_x, v_y, omega), omega in radians per unit of time, about the origin of the object's frame.
    forces : ndarray, shape (n, 2)
        Force of each pusher on the object.
    forces_end : ndarray, shape (n, 2)
        If the forces are not determined, those at the other end of the range of the inner force; otherwise
        `forces`. Components of an end without a bound are infinite, with the signs of `directions`.
    inner_force : ndarray, shape (2,)
        Lower and upper end of the inner force, at `forces` and at `forces_end`: half the difference of the
        forces of the first and of the last closed contact along the line from one to the other. It is
        positive where both press against each other. 0 with fewer than two closed contacts.
    directions : ndarray, shape (2, n, 2)
        How the forces grow toward either end without a bound, per unit of the inner force; NaN for an end
        that has one.
    contact_motions : ndarray, shape (n, 2)
        Velocity, or acceleration from rest, of the object at each contact.
    gap_rates : ndarray, shape (n,)
        How fast the object moves away from each pusher along the normal; 0 for closed contacts.
    pivot : int
        Number of the support point about which the object rotates, -1 without one.
    continuum : bool
        Whether this is an end of a continuum of solutions.
    condition : float
        Sum of the magnitudes of the forces, relative to the load that they balance: how much of the forces
        cancels. Errors of the scene are magnified as much.
    """

    modes: tuple[ContactMode, ...]
    twist: Array
    forces: Array
    forces_end: Array
    inner_force: Array
    directions: Array
    contact_motions: Array
    gap_rates: Array
    pivot: int
    continuum: bool
    condition: float

    def __eq__(self, other: object) -> Any:
        return same(self, other)

    def to_dict(self) -> dict[str, Any]:
        """Plain values by name."""
        values = {part.name: getattr(self, part.name) for part in fields(self)}
        values["modes"] = [mode.name for mode in self.modes]
        return {
            name: value.tolist() if isinstance(value, np.ndarray) else value
            for name, value in values.items()
        }


@dataclass(frozen=True, slots=True, repr=False)
class ContactsSolutions:
    """All consistent solutions of one problem with several contacts, in the order of their modes.

    Attributes
    ----------
    solutions : tuple of ContactsSolution
    status : Status
    reason : Reason, optional
        Why there is no solution, as far as it is known.
    """

    solutions: tuple[ContactsSolution, ...]
    status: Status
    reason: Reason | None = None

    @property
    def outcome(self) -> Outcome:
        """How many solutions there are; a continuum counts as several."""
        return Outcome(int(outcome_of(len(self.solutions), self.status)))

    @property
    def modes(self) -> tuple[tuple[ContactMode, ...], ...]:
        """The modes of each solution."""
        return tuple(solution.modes for solution in self.solutions)

    def __len__(self) -> int:
        return len(self.solutions)

    def __iter__(self) -> Iterator[ContactsSolution]:
        return iter(self.solutions)

    def __getitem__(self, index: Any) -> Any:
        return self.solutions[index]

    def to_dict(self) -> dict[str, Any]:
        """Plain values: the names of outcome, status and reason, and the solutions."""
        return {
            "outcome": self.outcome.name,
            "status": self.status.name,
            "reason": None if self.reason is None else self.reason.name,
            "solutions": [solution.to_dict() for solution in self.solutions],
        }

    def to_json(self) -> str:
        """JSON of `to_dict`; inf, -inf and nan, which JSON lacks, are written as words."""
        return to_json(self.to_dict())

    def __repr__(self) -> str:
        count = len(self.solutions)
        title = f"{self.outcome}: {count} consistent solution{'' if count == 1 else 's'}"
        if self.reason is not None:
            title += f", {self.reason.name}"
        return "\n".join([title, *map(_line_of, self.solutions)])


def _line_of(solution: ContactsSolution) -> str:
    """A solution in one line: modes, twist, and the forces, or both ends of their range."""
    modes = " + ".join(str(mode) for mode in solution.modes)
    pairs = zip(solution.forces, solution.forces_end, strict=True)
    finite = np.abs([solution.forces, solution.forces_end])
    size = finite[np.isfinite(finite)].max(initial=0.0)
    words = []
    for low, high in pairs:
        words.append(_vector(low, size))
        if _vector(high, size) != words[-1]:
            words[-1] += f" to {_vector(high, size)}"
    twist = _vector(solution.twist, np.abs(solution.twist).max())
    return f"{modes}: twist {twist}, forces {', '.join(words)}"


def _vector(vector: Array, size: float) -> str:
    """Components in a printed line, with 0 for rounding errors."""
    numbers = np.where(np.abs(vector) < ROUNDING * size, 0.0, vector) + 0.0
    return f"({', '.join(f'{number:.6g}' for number in numbers)})"


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class ContactsSolutionArrays:
    """All consistent solutions of an array of problems of shape S, padded along one axis.

    An index over S picks problems, as in `SolutionArrays`.

    Attributes
    ----------
    solutions, status, reason : ndarray of int, shape S
        Number of solutions, and values of `Status` and `Reason`, 0 without a reason.
    modes : ndarray of int, shape S + (solutions, n)
        Values of `ContactMode`; -1 after the last solution, where all other values are NaN.
    twist : ndarray, shape S + (solutions, 3)
        omega in radians per unit of time.
    forces, forces_end, contact_motions : ndarray, shape S + (solutions, n, 2)
    inner_force : ndarray, shape S + (solutions, 2)
    directions : ndarray, shape S + (solutions, 2, n, 2)
    gap_rates : ndarray, shape S + (solutions, n)
    pivot, continuum, condition : ndarray, shape S + (solutions,)
        As in `ContactsSolution`.
    """

    solutions: npt.NDArray[np.int8]
    status: npt.NDArray[np.int8]
    reason: npt.NDArray[np.int8]
    modes: npt.NDArray[np.int8]
    twist: Array
    forces: Array
    forces_end: Array
    inner_force: Array
    directions: Array
    contact_motions: Array
    gap_rates: Array
    pivot: npt.NDArray[np.int32]
    continuum: npt.NDArray[np.bool_]
    condition: Array

    def __eq__(self, other: object) -> Any:
        return same(self, other)

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape S."""
        return self.solutions.shape

    @property
    def outcome(self) -> npt.NDArray[np.int8]:
        """Values of `Outcome`, shape S."""
        outcomes: npt.NDArray[np.int8] = outcome_of(self.solutions, self.status).astype(np.int8)
        return outcomes

    def __len__(self) -> int:
        return len(self.solutions)

    def __getitem__(self, index: Any) -> Any:
        values = {part.name: getattr(self, part.name) for part in fields(self)}
        places = np.arange(self.solutions.size).reshape(self.shape)[index]
        flat = {
            name: value.reshape(self.solutions.size, *value.shape[len(self.shape) :])[places]
            for name, value in values.items()
        }
        return ContactsSolutionArrays(**flat) if np.ndim(places) else solutions_of(flat)

    def __repr__(self) -> str:
        outcomes = ", ".join(
            f"{count} {member.name}"
            for member in Outcome
            if (count := int(np.count_nonzero(self.outcome == member)))
        )
        return f"contacts: {self.modes.shape[-1]}\nproblems: {self.shape}\noutcomes: {outcomes}"


def as_labeled(values: dict[str, Any]) -> Any:
    """The dataset of labeled problems, from labeled variables of `ContactsSolutionArrays`."""
    outcome = label_result(
        "outcome", outcome_of(values["solutions"], values["status"]).astype(np.int8)
    )
    for name, kind in (("modes", ContactMode), ("reason", Reason)):
        flags: dict[str, Any] = flag_attributes(dict(kind.__members__))
        values[name] = values[name].assign_attrs(flags)
    labels = component_labels() | {"bound": ["low", "high"]}
    return dataset([*values.values(), outcome]).assign_coords(labels)


def solutions_of(values: dict[str, Any]) -> ContactsSolutions:
    """The solutions of one problem, from the arrays of `ContactsSolutionArrays` without the axes of S."""
    solutions = []
    for k in range(int(values["solutions"])):
        entries = {
            part.name: values[part.name][k]
            for part in fields(ContactsSolution)
            if part.name not in ("modes", "pivot", "continuum", "condition")
        }
        solutions.append(
            ContactsSolution(
                **entries,
                modes=tuple(ContactMode(int(mode)) for mode in values["modes"][k]),
                pivot=int(values["pivot"][k]),
                continuum=bool(values["continuum"][k]),
                condition=float(values["condition"][k]),
            )
        )
    reason = int(values["reason"])
    return ContactsSolutions(
        tuple(solutions), Status(int(values["status"])), Reason(reason) if reason else None
    )
