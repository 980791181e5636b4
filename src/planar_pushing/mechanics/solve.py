"""Every consistent solution of a pushing problem, and the outcome (Secs. 2-5)."""

from __future__ import annotations

from typing import Any

import numpy as np

from planar_pushing.mechanics.contact import ContactMode, Outcome
from planar_pushing.mechanics.numerics.arrays import dataset, elementwise, is_labelled
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.push import outputs, solve_arrays
from planar_pushing.mechanics.scene import Scene, required_scene
from planar_pushing.mechanics.solutions import Solution, SolutionArrays, Solutions
from planar_pushing.terms.domain import Number
from planar_pushing.terms.quantities import MECHANICS, attributes


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
    kinds = required_scene(scene).kinds
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
