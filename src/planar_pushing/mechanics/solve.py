"""Every consistent solution of a pushing problem, and the outcome (Secs. 2-5)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.angles import RESOLUTION
from planar_pushing.mechanics.contact import ContactMode, Outcome
from planar_pushing.mechanics.numerics.arrays import dataset, elementwise, is_labelled
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.push import outputs, solve_arrays
from planar_pushing.mechanics.scene import Scene
from planar_pushing.terms.domain import Number
from planar_pushing.terms.quantities import MECHANICS, attributes


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
        (v_x, v_y, omega) at the ring centre.
    spin_ratio : float
        k = R omega / v; 0 at rest.
    center : ndarray, shape (2,)
        Motion centre relative to the contact; infinite for a translation and at rest.
    pivot : int
        Number of the support point about which the slider pivots, -1 without one.
    """

    mode: ContactMode
    force: Array
    force_end: Array
    contact_motion: Array
    twist: Array
    spin_ratio: float
    center: Array
    pivot: int

    @property
    def adhesive(self) -> bool:
        """Whether the fence pulls on the slider, as only a perfectly rough contact can."""
        return bool(self.force[1] < -RESOLUTION * np.hypot(*self.force))


@dataclass(frozen=True, slots=True)
class Solutions:
    """All consistent solutions of one pushing problem, in the order of `ContactMode`.

    Of several slips of one mode the slower comes first.
    """

    solutions: tuple[Solution, ...]

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
    spin_ratio, pivot : ndarray, shape S + (solutions,)
        As in `Solution`.
    """

    solutions: npt.NDArray[np.int8]
    mode: npt.NDArray[np.int8]
    force: Array
    force_end: Array
    twist: Array
    contact_motion: Array
    spin_ratio: Array
    center: Array
    pivot: npt.NDArray[np.int32]

    @property
    def consistent(self) -> npt.NDArray[np.bool_]:
        """Which places along the axis hold a solution, shape S + (solutions,)."""
        return self.mode >= 0

    @property
    def outcome(self) -> npt.NDArray[np.int8]:
        """Values of `Outcome`, shape S."""
        return np.minimum(self.solutions, np.int8(Outcome.AMBIGUOUS))


def arguments(scene: Scene, pusher_angle: Number, pusher_magnitude: Number) -> list[Number]:
    """The numbers of a scene and of a push, as `solve_arrays` takes them."""
    slider = scene.slider
    effects = [scene.weight, *scene.inertia, *scene.placement]
    rod = [slider.rod_length, slider.rod_angle, slider.radius]
    return [*effects, *rod, *scene.law, pusher_angle, pusher_magnitude]


def solve(scene: Scene, pusher_angle: Number, pusher_magnitude: Number = 1.0) -> Any:
    """Every solution of the pushing problem from rest that is consistent (Sec. 2).

    Parameters
    ----------
    scene : Scene
        Its parameters may be arrays.
    pusher_angle : float or array
        Angle of the pusher's velocity or initial acceleration, radians.
    pusher_magnitude : float or array
        Its magnitude, >= 0. It matters to the modes only where the scene has friction and inertia.

    Returns
    -------
    Solutions, SolutionArrays or xarray.Dataset
        For numbers, for arrays, and where an argument is a DataArray: with the variables of
        `SolutionArrays`, units, `consistent` and `outcome`.

    Raises
    ------
    InvalidValue
        Where a value is out of its range; with friction and inertia also where m a / W is.
    """
    kinds = scene.kinds
    given = arguments(scene, pusher_angle, pusher_magnitude)
    results = outputs(len(kinds))
    if any(map(is_labelled, given)):
        return _dataset(elementwise(lambda *each: solve_arrays(kinds, *each), given, results))
    found = solve_arrays(kinds, *given)
    named = {output.name: each for output, each in zip(results, found, strict=True)}
    return SolutionArrays(**named) if found[0].ndim else _solutions(**named)


def _solutions(solutions: Any, mode: Any, **values: Array) -> Solutions:
    """The solutions of one problem."""
    ratios, pivots = values.pop("spin_ratio").tolist(), values.pop("pivot").tolist()
    return Solutions(
        tuple(
            Solution(
                mode=ContactMode(mode[i]),
                spin_ratio=ratios[i],
                pivot=pivots[i],
                **{name: value[i] for name, value in values.items()},
            )
            for i in range(int(solutions))
        )
    )


def _dataset(found: list[Any]) -> Any:
    merged = dataset(found)
    merged["consistent"] = merged.mode >= 0
    merged["outcome"] = np.minimum(merged.solutions, Outcome.AMBIGUOUS).astype(np.int8)
    for name in ("consistent", "outcome"):
        merged[name].attrs = attributes(MECHANICS, name)
    return merged.assign_coords(xy=["x", "y"], twist_component=["v_x", "v_y", "omega"])
