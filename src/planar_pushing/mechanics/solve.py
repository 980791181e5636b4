"""Every consistent solution of a pushing problem, and its status (Secs. 2-5)."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import TYPE_CHECKING, Any, overload

import numpy as np
import numpy.typing as npt

from planar_pushing.core.kernels import RESULT
from planar_pushing.core.solution import (
    CONTINUUM,
    FORCE,
    FORCE_END,
    MODE,
    MOTION,
    PIVOT,
    SOLUTION,
    TWIST,
)
from planar_pushing.mechanics.derivatives import require_unlabeled, solution_derivatives
from planar_pushing.mechanics.held import require_held
from planar_pushing.mechanics.numerics.arrays import Output, elementwise, is_labeled, mapped
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.rows import Entry, Rows, in_units, strengths_of
from planar_pushing.mechanics.scene import Scene, required_scene
from planar_pushing.mechanics.solutions import SolutionArrays, Solutions, as_dataset, listed
from planar_pushing.terms.domain import Number, Numbers, Scalar, required, required_ratio
from planar_pushing.terms.errors import InvalidValue, require_flag
from planar_pushing.terms.units import named_units

if TYPE_CHECKING:
    import xarray as xr

#: Length of the axis `solution`, by whether all potentials have one degree.
SOLUTIONS = {True: 4, False: 8}
XY = ("xy", 2)


@cache
def outputs(steady: bool) -> tuple[Output, ...]:
    """The results of each scene; `steady` if all potentials have one degree."""
    many = ("solution", SOLUTIONS[steady])
    return (
        Output("solutions", (), "i1"),
        Output("status", (), "i1"),
        Output("mode", (many,), "i1"),
        Output("force", (many, XY)),
        Output("force_end", (many, XY)),
        Output("twist", (many, ("twist_component", 3))),
        Output("contact_motion", (many, XY)),
        Output("spin_ratio", (many,)),
        Output("center", (many, XY)),
        Output("pivot", (many,), "i4"),
        Output("continuum", (many,), "?"),
    )


def _decode(results: Array, columns: Sequence[Any]) -> list[Any]:
    """The outputs in the units of the scene; the last columns of a row are its units."""
    size, unit, radius = (np.asarray(each)[..., None] for each in columns[-3:])
    solutions = results[:, 2:].reshape(len(results), -1, RESULT)
    size, unit, radius = size[..., None], unit[..., None], radius[..., None]
    twist = size * solutions[..., TWIST:MOTION]
    twist[..., 2:] /= radius
    return [
        results[:, 0], results[:, 1], _integers(solutions[..., MODE]),
        unit * solutions[..., FORCE:FORCE_END], unit * solutions[..., FORCE_END:PIVOT], twist,
        size * solutions[..., MOTION:FORCE], solutions[..., SOLUTION],
        radius * solutions[..., SOLUTION + 1 :], _integers(solutions[..., PIVOT]),
        solutions[..., CONTINUUM] == 1.0,
    ]  # fmt: skip


def _integers(numbers: Array) -> Array:
    """Integers, -1 where there is none."""
    return np.where(np.isnan(numbers), -1.0, numbers)


def _require_ratio(entries: Sequence[Entry], columns: Sequence[Any], size: Any) -> None:
    """Refuse friction and inertia out of proportion under a moving pusher; loads can have any magnitude."""
    by_degree: dict[int, Any] = {}
    for entry, strength in zip(entries, strengths_of(entries, columns), strict=True):
        if entry.resists:
            by_degree[entry.degree] = by_degree.get(entry.degree, 0.0) + strength
    if len(by_degree) == 2:
        ratio = by_degree[2] * size / by_degree[1]
        required_ratio("force_ratio", np.where(np.asarray(size) > 0, ratio, 1.0)[()])


def solve_arrays(rows: Rows, *given: npt.ArrayLike) -> list[npt.NDArray[Any]]:
    """Every consistent solution of arrays of scenes, with broadcasting.

    Parameters
    ----------
    rows : Rows
    *given : array_like
        Columns of the entries; length of the rod in radii, its angle, and the radius; the five entries of
        `Law`; angle and magnitude of the pusher's motion, all within their ranges.

    Returns
    -------
    list of ndarray
        As `outputs`; places without a solution hold NaN.
    """
    *columns, length, angle, radius, right, left, slips, closed, rough, toward, size = given
    _require_ratio(rows.entries, columns, size)
    moves = np.asarray(size) > 0
    size = np.where(moves, size, 1.0)
    unit, scaled = in_units(rows.entries, columns, size)
    scaled += [length, angle, right, left, slips, closed, rough, toward, moves, size, unit, radius]
    width = 2 + SOLUTIONS[rows.is_steady] * RESULT
    return mapped("solve", rows.data, scaled, outputs(rows.is_steady), width, _decode)


@overload
def solve(
    scene: Scene,
    pusher_angle: Scalar | None = None,
    pusher_magnitude: Scalar | None = None,
    *,
    derivatives: bool = False,
) -> Solutions: ...
@overload
def solve(
    scene: Scene,
    pusher_angle: Numbers,
    pusher_magnitude: Scalar | Numbers | None = None,
    *,
    derivatives: bool = False,
) -> SolutionArrays: ...
@overload
def solve(
    scene: Scene,
    pusher_angle: Scalar | None,
    pusher_magnitude: Numbers,
    *,
    derivatives: bool = False,
) -> SolutionArrays: ...
@overload
def solve(
    scene: Scene, pusher_angle: xr.DataArray,
    pusher_magnitude: Scalar | Numbers | xr.DataArray | None = None,
) -> xr.Dataset: ...  # fmt: skip
@overload
def solve(
    scene: Scene, pusher_angle: Scalar | Numbers | None, pusher_magnitude: xr.DataArray
) -> xr.Dataset: ...
def solve(
    scene: Scene,
    pusher_angle: Number | None = None,
    pusher_magnitude: Number | None = None,
    *,
    derivatives: bool = False,
) -> Any:
    """Every consistent solution of the pushing problem from rest (Sec. 2).

    Parameters
    ----------
    scene : Scene
        Its parameters can be arrays.
    pusher_angle : float or array, optional
        Angle of the pusher's velocity or initial acceleration, radians counterclockwise from the fence
        (the scene's +x); pi / 2 is into the slider. By default the push of the scene's file.
    pusher_magnitude : float or array, optional
        Its magnitude, >= 0, by default 1. It affects the modes only if the scene has both friction and
        inertia.
    derivatives : bool
        Whether to compute the `Derivatives` of each solution: of twist and force with respect to the
        pusher's motion, the contact point, mu, and the strengths of the effects.

    Returns
    -------
    Solutions, SolutionArrays or xarray.Dataset
        `Solutions` for numbers, `SolutionArrays` for arrays, and a dataset if an argument is a DataArray,
        with the variables of `SolutionArrays`, units, `consistent` and `outcome`. An array of scenes counts
        as an array, and a labeled scene as a DataArray, whatever the angle is.

    Raises
    ------
    InvalidValue
        If a value, or m a / W with friction and inertia, is out of its range, or derivatives are requested
        with a DataArray. An angle beyond 4 pi is refused because it is most likely in degrees, and a tuple
        because it is most likely a velocity.
    """
    rows = required_scene(scene).rows
    require_held(scene)
    push = _push(scene, pusher_angle, pusher_magnitude)
    given, results = [*rows.columns, *rows.body, *rows.law, *push], outputs(rows.is_steady)
    if require_flag("derivatives", derivatives):
        require_unlabeled(given)
    found = elementwise(lambda *each: solve_arrays(rows, *each), given, results)
    by_name = {output.name: each for output, each in zip(results, found, strict=True)}
    if is_labeled(found[0]):
        return named_units(as_dataset(by_name), scene.units, inertia=scene.stores_energy)
    by = solution_derivatives(scene, given, by_name) if derivatives else None
    if np.ndim(found[0]):
        return SolutionArrays(**by_name, derivatives=by)
    angle, magnitude = map(float, push)
    return listed(by_name, (scene, angle, magnitude), by)


def _push(scene: Scene, angle: Number | None, magnitude: Number | None) -> tuple[Number, Number]:
    """Angle and magnitude of a push, by default those of the scene's file."""
    own = scene.push if angle is None else (angle, 1.0)
    if own is None:
        raise InvalidValue(
            "pusher_angle", None, "radians, for a scene whose file holds no push",
            "give the angle of the push, np.deg2rad(90) for one into the slider",
        )  # fmt: skip
    return (
        required("pusher_angle", own[0]),
        required("pusher_magnitude", own[1] if magnitude is None else magnitude),
    )
