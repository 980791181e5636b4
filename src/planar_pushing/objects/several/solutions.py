"""The result of `solve_contacts`: the solutions of one problem, or of an array of problems."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.contact import ContactMode, Outcome, Status
from planar_pushing.mechanics.kernels.arrays import (
    component_labels,
    dataset,
    flag_attributes,
    label_result,
    same,
)
from planar_pushing.mechanics.solution_arrays import (
    ProblemArrays,
    count_members,
    entries_of_solutions,
)
from planar_pushing.mechanics.solutions import (
    SolutionSequence,
    drop_rounding,
    field_values,
    outcome_of,
    plain,
)
from planar_pushing.terms.numbers import Array
from planar_pushing.terms.options import Reason


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
        values = field_values(self)
        modes = [mode.name for mode in values.pop("modes")]
        return {"modes": modes, **{name: plain(value) for name, value in values.items()}}


@dataclass(frozen=True, slots=True, repr=False)
class ContactsSolutions(SolutionSequence[ContactsSolution]):
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
    def modes(self) -> tuple[tuple[ContactMode, ...], ...]:
        """The modes of each solution."""
        return tuple(solution.modes for solution in self.solutions)

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

    def __repr__(self) -> str:
        title = self._title_with("" if self.reason is None else f", {self.reason.name}")
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
    return f"({', '.join(f'{number:.6g}' for number in drop_rounding(vector, size))})"


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class ContactsSolutionArrays(ProblemArrays):
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

    def __getitem__(self, index: Any) -> Any:
        places = np.arange(self.solutions.size).reshape(self.shape)[index]
        values = self._pick(field_values(self), places)
        return ContactsSolutionArrays(**values) if np.ndim(places) else solutions_of(values)

    def __repr__(self) -> str:
        outcomes = count_members(Outcome, self.outcome)
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
    entries, reason = entries_of_solutions(values), int(values["reason"])
    count = int(values["solutions"])
    entries["modes"] = [
        tuple(map(ContactMode, modes)) for modes in entries["modes"][:count].tolist()
    ]
    solutions = (
        ContactsSolution(**{name: entry[k] for name, entry in entries.items()})
        for k in range(count)
    )
    return ContactsSolutions(
        tuple(solutions), Status(int(values["status"])), Reason(reason) if reason else None
    )
