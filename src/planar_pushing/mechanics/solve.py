"""Every consistent solution of a pushing problem, and its status (Secs. 2-5)."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from math import hypot, inf, nan
from typing import TYPE_CHECKING, Any, NamedTuple, overload

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.compiled import compiled, kernel, owning
from planar_pushing.mechanics.contact import Status
from planar_pushing.mechanics.contact.laws import Law
from planar_pushing.mechanics.core import Entry
from planar_pushing.mechanics.derivatives import (
    require_unlabeled,
    solution_derivatives,
)
from planar_pushing.mechanics.effects.base import count_fields, made
from planar_pushing.mechanics.held import require_held
from planar_pushing.mechanics.modes import MOST, SOLUTION, Push, contact_modes
from planar_pushing.mechanics.numerics.arrays import (
    Output,
    elementwise,
    is_labeled,
    mapped,
)
from planar_pushing.mechanics.plane import motion_center, rod, toward
from planar_pushing.mechanics.reduced.psi import contact_at
from planar_pushing.mechanics.reduced.slips import ENTRIES, SLIPS
from planar_pushing.mechanics.scene import Scene, required_scene
from planar_pushing.mechanics.solutions import SolutionArrays, Solutions, as_dataset, listed
from planar_pushing.terms.domain import Number, Numbers, Scalar, required, required_ratio
from planar_pushing.terms.errors import InvalidValue, require_flag
from planar_pushing.terms.units import named_units

if TYPE_CHECKING:
    import xarray as xr

#: Length of the axis `solution`, by whether all potentials have one degree.
SOLUTIONS = {True: 4, False: 8}
NO_MODE, NO_PIVOT = -1, -1
NONE, CONSISTENT, PIVOTS = int(Status.NONE), int(Status.CONSISTENT), int(Status.PIVOTS)
CONTINUUM, UNSOLVED = int(Status.CONTINUUM), int(Status.UNSOLVED)
XY = ("xy", 2)


class Given(NamedTuple):
    """A push, in the columns of a row after those of the effects."""

    length: float
    angle: float
    right: float
    left: float
    slips: float
    closed: float
    rough: float
    toward: float
    size: float
    unit: float
    radius: float


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


@compiled
def given_in(row, i):
    """The push in the columns of a row, starting at i."""
    return Given(
        row[i], row[i + 1], row[i + 2], row[i + 3], row[i + 4], row[i + 5], row[i + 6], row[i + 7],
        row[i + 8], row[i + 9], row[i + 10],
    )  # fmt: skip


@compiled
def spin_ratio(speed, spin):
    """R omega / v, 0 at rest."""
    if spin == 0.0:
        return 0.0
    return spin / speed if speed > 0.0 else inf if spin > 0.0 else -inf


@compiled
def _write(own, given, found, force, end, twist, contact, center):
    """Write one solution in the units of the scene, with no center at rest; return its spin ratio."""
    size, unit, radius = given.size, given.unit, given.radius
    v_x, v_y, spin = found.twist[0], found.twist[1], found.twist[2]
    for k in range(2):
        force[k], end[k] = unit * found.force[k], unit * found.force_end[k]
        contact[k] = size * found.motion[k]
    twist[0], twist[1], twist[2] = size * v_x, size * v_y, size * spin / radius
    x, y = motion_center(own, v_x, v_y, spin)
    center[0], center[1] = radius * x, radius * y
    if twist[0] == 0.0 and twist[1] == 0.0 and twist[2] == 0.0:
        center[0], center[1] = nan, nan
    return spin_ratio(hypot(v_x, v_y), spin)


@kernel
@owning
def _modes(
    kinds,
    rows,
    counts,
    status,
    modes,
    forces,
    ends,
    twists,
    contacts,
    ratios,
    centers,
    pivots,
    continua,
):
    scratch, solutions = np.empty((SLIPS, ENTRIES)), np.empty(MOST, SOLUTION)
    for i in range(len(rows)):
        given = given_in(rows[i], count_fields(kinds))
        own = rod(given.length, given.angle)
        law = Law(
            given.right, given.left, given.slips != 0.0, given.closed != 0.0, given.rough != 0.0
        )
        push = Push(made(kinds, rows[i], 0), contact_at(-given.length, 0.0), own.x, -own.y)
        edges = toward(own, law.right), toward(own, law.left)
        pusher = toward(own, given.toward)
        count, flat = contact_modes(push, law, edges, pusher, given.size > 0.0, scratch, solutions)
        fits = count <= modes.shape[1]
        status[i] = CONTINUUM if flat else NONE if count == 0 else CONSISTENT
        if count < 0 or not fits:
            count, status[i] = 0, UNSOLVED
        counts[i], modes[i], pivots[i], continua[i] = count, NO_MODE, NO_PIVOT, False
        forces[i], ends[i], twists[i], contacts[i] = nan, nan, nan, nan
        ratios[i], centers[i] = nan, nan
        for j in range(count):
            found = solutions[j]
            modes[i, j], pivots[i, j], continua[i, j] = found.mode, found.pivot, found.continuum
            if found.continuum:
                status[i] = CONTINUUM
            elif found.pivot >= 0 and status[i] == CONSISTENT:
                status[i] = PIVOTS
            ratios[i, j] = _write(
                own,
                given,
                found,
                forces[i, j],
                ends[i, j],
                twists[i, j],
                contacts[i, j],
                centers[i, j],
            )


def _in_units(entries: Sequence[Entry], columns: Sequence[Any], size: Any) -> tuple[Any, list[Any]]:
    """Unit of force, and the columns of the effects for motions in units of `size` and forces in that unit.

    For a pusher at rest the unit of motion is 1.
    """
    moves = np.asarray(size) > 0
    size = np.where(moves, size, 1.0)
    left, strengths, found = list(columns), [], []
    for entry in entries:
        own = [left.pop(0) * size ** (entry.degree - 1) for _ in entry.forces]
        found.append([*own, *(left.pop(0) for _ in entry.others)])
        strengths.append(np.abs(own[0]) if len(own) == 1 else np.hypot(own[0], own[1]))
    unit = strengths[0]
    for strength in strengths[1:]:
        unit = np.maximum(unit, strength)
    _require_ratio(entries, strengths, moves)
    for entry, numbers in zip(entries, found, strict=True):
        for i in range(len(entry.forces)):
            numbers[i] = numbers[i] / unit
    return unit, [each for numbers in found for each in numbers]


def _require_ratio(entries: Sequence[Entry], strengths: Sequence[Any], moves: Any) -> None:
    """Refuse friction and inertia out of proportion under a moving pusher; loads can have any magnitude."""
    by_degree: dict[int, Any] = {}
    for entry, strength in zip(entries, strengths, strict=True):
        if len(entry.forces) == 1:
            by_degree[entry.degree] = by_degree.get(entry.degree, 0.0) + strength
    if len(by_degree) == 2:
        required_ratio("force_ratio", np.where(moves, by_degree[2] / by_degree[1], 1.0)[()])


def solve_arrays(entries: Sequence[Entry], *given: npt.ArrayLike) -> list[npt.NDArray[Any]]:
    """Every consistent solution of arrays of scenes, with broadcasting.

    Parameters
    ----------
    entries : sequence of Entry
        The effects.
    *given : array_like
        Columns of the entries; length and angle of the rod, radius; the five entries of `Law`; angle and
        magnitude of the pusher's motion, all within their ranges.

    Returns
    -------
    list of ndarray
        As `outputs`; places without a solution hold NaN.
    """
    count = sum(len(entry.columns) for entry in entries)
    length, angle, radius, *law, towards, size = given[count:]
    unit, columns = _in_units(entries, given[:count], size)
    ratio = required_ratio("length_ratio", np.divide(length, radius))
    columns += [ratio, angle, *law, towards, size, unit, radius]
    kinds = tuple(entry.kind for entry in entries)
    return mapped(_modes, kinds, columns, outputs(is_steady(entries)))


def is_steady(entries: Sequence[Entry]) -> bool:
    """Whether all potentials have one degree."""
    return len({entry.degree for entry in entries}) == 1


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
    entries, slider = required_scene(scene).from_rest, scene.slider
    require_held(scene)
    push = _push(scene, pusher_angle, pusher_magnitude)
    body = slider.rod_length, slider.rod_angle, slider.radius
    columns = [each for entry in entries for each in entry.columns]
    given, results = [*columns, *body, *scene.law, *push], outputs(is_steady(entries))
    if require_flag("derivatives", derivatives):
        require_unlabeled(given)
    found = elementwise(lambda *each: solve_arrays(entries, *each), given, results)
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
