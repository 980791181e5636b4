"""What `solve` finds: the consistent solutions of one pushing problem, or of an array of them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.angles import RESOLUTION
from planar_pushing.mechanics.contact import ContactMode, Outcome, Status
from planar_pushing.mechanics.derivatives import Derivatives
from planar_pushing.mechanics.numerics.arrays import same
from planar_pushing.mechanics.pictures import picture
from planar_pushing.mechanics.plane import Array
from planar_pushing.terms.errors import InvalidValue

#: Numbers of a solution in the table that is printed; vectors by their components.
NUMBERS = {
    "force": ("force x", "force y"),
    "contact_motion": ("motion x", "motion y"),
    "twist": ("v_x", "v_y", "omega"),
    "spin_ratio": ("spin ratio",),
    "center": ("center x", "center y"),
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Solution:
    """One consistent solution.

    Attributes
    ----------
    mode : ContactMode
    force : ndarray, shape (2,)
        Force of the pusher on the slider.
    force_end : ndarray, shape (2,)
        The same; but a pivot leaves forces between two open, and this is the other one.
    contact_motion : ndarray, shape (2,)
        Velocity or initial acceleration of the slider at the contact.
    twist : ndarray, shape (3,)
        (v_x, v_y, omega) at the ring center, omega in radians per unit of time.
    spin_ratio : float
        k = R omega / v; 0 at rest.
    center : ndarray, shape (2,)
        Motion center relative to the contact; infinite for a translation and at rest.
    pivot : int
        Number of the support point about which the slider pivots, -1 without one.
    continuum : bool
        Whether each motion from this one to the other end of a continuum is a solution too: to another
        slip, to the sticking motion, or to rest.
    derivatives : Derivatives, optional
        Those of twist and force, where `solve` was asked for them.
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
    derivatives: Derivatives | None = None

    def __eq__(self, other: object) -> Any:
        return same(self, other)

    @property
    def adhesive(self) -> bool:
        """Whether the fence pulls on the slider, as only a perfectly rough contact can."""
        return bool(self.force[1] < -RESOLUTION * np.hypot(*self.force))


def _numbers(solution: Solution) -> Array:
    """The numbers of the table; adding 0 leaves no negative zeros."""
    return np.hstack([getattr(solution, name) for name in NUMBERS]) + 0.0


@dataclass(frozen=True, slots=True, repr=False)
class Solutions:
    """All consistent solutions of one pushing problem, in the order of `ContactMode`.

    Slips of the same mode are ordered by speed. ``solutions[0]`` is the first solution; printing shows one
    column per solution, and a notebook a picture too. `problem` holds the scene, the direction of the push
    in radians, and its magnitude.
    """

    solutions: tuple[Solution, ...]
    status: Status = Status.CONSISTENT
    problem: tuple[Any, float, float] | None = field(default=None, compare=False)

    @property
    def outcome(self) -> Outcome:
        return Outcome(min(len(self.solutions), 2))

    @property
    def modes(self) -> tuple[ContactMode, ...]:
        return tuple(solution.mode for solution in self.solutions)

    def __iter__(self) -> Iterator[Solution]:
        return iter(self.solutions)

    def __len__(self) -> int:
        return len(self.solutions)

    def __getitem__(self, index: Any) -> Any:
        if isinstance(index, ContactMode):  # a number too, which would pick some other solution
            raise InvalidValue(
                "index", index, "the number of a solution, or a slice",
                "pick a mode with [each for each in solutions if each.mode is mode]",
            )  # fmt: skip
        return self.solutions[index]

    def __repr__(self) -> str:
        return f"{self._title}\n{self._table().to_string()}" if self.solutions else self._title

    def _repr_html_(self) -> str:
        """The picture and the table in a notebook."""
        drawn = picture("push_svg", *self.problem, self) if self.problem else None
        title = f"{drawn or ''}<p>{self._title}</p>"
        return f"{title}\n{self._table().to_html()}" if self.solutions else title

    @property
    def _title(self) -> str:
        count = len(self.solutions)
        return f"{self.outcome}: {count} consistent solution{'' if count == 1 else 's'}"

    def _table(self) -> Any:
        """A pandas table: a row for each number, a column for each solution."""
        import pandas as pd

        words = [word for each in NUMBERS.values() for word in each]
        columns = [[f"{x:.6g}" for x in _numbers(each)] for each in self.solutions]
        return pd.DataFrame(dict(enumerate(columns)), words).set_axis(
            list(map(str, self.modes)), axis=1
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class SolutionArrays:
    """All consistent solutions of an array of pushing problems of shape S, padded along one axis.

    Attributes
    ----------
    solutions : ndarray of int, shape S
        How many there are.
    mode : ndarray of int, shape S + (solutions,)
        Values of `ContactMode`, in their order; -1 behind the last solution, where the rest is NaN.
    force, force_end, contact_motion, center : ndarray, shape S + (solutions, 2)
    twist : ndarray, shape S + (solutions, 3)
        omega in radians per unit of time.
    status : ndarray of int, shape S
        Values of `Status`.
    spin_ratio, pivot, continuum : ndarray, shape S + (solutions,)
        As in `Solution`.
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
        return np.minimum(self.solutions, np.int8(Outcome.AMBIGUOUS))
