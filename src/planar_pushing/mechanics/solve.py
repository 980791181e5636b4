"""Every consistent solution of a pushing problem, and its status (Secs. 2-5)."""

from __future__ import annotations

import functools
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, overload

import numpy as np
import numpy.typing as npt

from planar_pushing.core.instant.flush_solutions import SideResult
from planar_pushing.core.instant.kernels import PushResult, PushResults, PushRow
from planar_pushing.mechanics.contact import ContactMode, Law, Status
from planar_pushing.mechanics.force.derivatives import require_unlabeled, solution_derivatives
from planar_pushing.mechanics.force.held import require_held
from planar_pushing.mechanics.kernels.arrays import Output, elementwise, is_labeled, map_kernel
from planar_pushing.mechanics.kernels.calls import run
from planar_pushing.mechanics.kernels.columns import Columns
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.rows import EffectColumns, Rows, in_units, row_of_push, strengths_of
from planar_pushing.mechanics.scene import Scene, require_flat_contact, require_scene
from planar_pushing.mechanics.solution_arrays import SolutionArrays, as_dataset, solutions_from
from planar_pushing.mechanics.solutions import Solution, Solutions
from planar_pushing.terms.domain import Number, Numbers, Scalar, require_in_range, require_ratio
from planar_pushing.terms.errors import InvalidValue, require_flag
from planar_pushing.terms.units import named_units

if TYPE_CHECKING:
    import xarray as xr

#: Length of the axis `solution`, by whether all potentials have one degree; the same for a flush side.
SOLUTIONS = {True: 4, False: 8}
FLUSH_SOLUTIONS = {True: 10, False: 20}
XY = ("xy", 2)
MODES = tuple(ContactMode)
#: Places of the fields of a solution in its columns of results.
PLACES = SideResult.places
PUSHER, MOVES = PushRow.places["pusher"], PushRow.places["moves"]


@functools.cache
def outputs(steady: bool, flush: bool = False) -> tuple[Output, ...]:
    """The results of each scene; `steady` if all potentials have one degree, `flush` for a flush side."""
    many = ("solution", (FLUSH_SOLUTIONS if flush else SOLUTIONS)[steady])
    on_side = (
        Output("flush", (many,), "?"),
        Output("force_position", (many,)),
        Output("end_forces", (many, ("end", 2), ("bound", 2), XY)),
    )
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
        *(on_side if flush else ()),
    )


def _decode(results: Array, columns: Sequence[Any], outputs: Sequence[npt.NDArray[Any]]) -> None:
    """Write the outputs in the units of the scene; the last columns of a row are its units."""
    size, unit, radius = (np.asarray(column)[..., None] for column in columns[-3:])
    counts, status, mode, force, end, twist, motion, ratio, center, pivot, continuum, *on_side = (
        outputs
    )
    head = Columns(PushResults, results)
    counts[:], status[:] = head.count, head.status
    record = SideResult if on_side else PushResult
    rows = results[:, PushResults.size :].reshape(len(results), mode.shape[1], record.size)
    solutions = Columns(record, rows)
    vectors = (
        (force, solutions.force, unit), (end, solutions.force_end, unit),
        (twist, solutions.twist, size), (motion, solutions.motion, size),
        (center, solutions.center, radius),
    )  # fmt: skip
    for output, values, scale in vectors:
        np.multiply(values, scale[..., None], out=output)
    twist[:, :, 2] /= radius
    ratio[:] = solutions.spin_ratio
    for output, numbers in ((mode, solutions.mode), (pivot, solutions.pivot)):
        output[:] = np.where(np.isnan(numbers), -1.0, numbers)
    continuum[:] = solutions.continuum == 1.0
    if on_side:
        flush, position, forces = on_side
        flush[:] = solutions.flush == 1.0
        np.multiply(solutions.position, radius, out=position)
        flat = forces.reshape(*position.shape, -1)
        np.multiply(solutions.end_forces, unit[..., None], out=flat)


def require_proportion(
    entries: Sequence[EffectColumns], strengths: Sequence[Any], size: Any
) -> None:
    """Refuse friction and inertia out of proportion under a moving pusher; loads can have any magnitude."""
    by_degree: dict[int, Any] = {}
    for entry, strength in zip(entries, strengths, strict=True):
        if entry.resists:
            by_degree[entry.degree] = by_degree.get(entry.degree, 0.0) + strength
    if len(by_degree) == 2:
        ratio = by_degree[2] * size / by_degree[1]
        if type(ratio) is not float:
            ratio = np.where(np.asarray(size) > 0, ratio, 1.0)[()]
        elif size == 0.0:
            ratio = 1.0
        require_ratio("force_ratio", ratio)


def size_of_fall(entries: Sequence[EffectColumns], strengths: Sequence[Any]) -> Any:
    """Unit of motion for a pusher at rest: motion of the mass under the loads alone, 1 without loads."""
    load: Any = 0.0
    mass: Any = 0.0
    for entry, strength in zip(entries, strengths, strict=True):
        if not entry.resists:
            load = load + strength
        elif entry.degree == 2:
            mass = mass + strength
    moves = (np.asarray(load) > 0.0) & (np.asarray(mass) > 0.0)
    return np.where(moves, load, 1.0) / np.where(moves, mass, 1.0)


def solve_arrays(rows: Rows, *arguments: npt.ArrayLike) -> list[npt.NDArray[Any]]:
    """Every consistent solution of arrays of scenes, with broadcasting.

    Parameters
    ----------
    rows : Rows
    *arguments : array_like
        Columns of the entries; length of the rod in radii, its angle, and the radius; the ends of a flush
        side, in radii; the five entries of `Law`; `Slider.pocket`; angle and magnitude of the pusher's
        motion, all within their ranges.

    Returns
    -------
    list of ndarray
        As `outputs`; places without a solution hold NaN.
    """
    *columns, right, left, slips, closed, rough, pocket, toward, size = arguments
    first = len(columns) - 3 - len(rows.ends)
    columns, (length, angle, radius, *ends) = columns[:first], columns[first:]
    strengths = strengths_of(rows.entries, columns)
    require_proportion(rows.entries, strengths, size)
    moves = np.asarray(size) > 0
    size = np.where(moves, size, size_of_fall(rows.entries, strengths))
    unit, scaled = in_units(rows.entries, columns, strengths, size)
    law = Law(right, left, slips, closed, rough)
    scaled += row_of_push(length, angle, law, pocket, toward, moves, ends)
    scaled += [size, unit, radius]
    kernel, room, result = _kernel_of(rows)
    width = PushResults.size + room * result.size
    return map_kernel(
        kernel, rows.data, scaled, outputs(rows.is_steady, bool(ends)), width, _decode
    )


def _kernel_of(rows: Rows) -> tuple[str, int, type[PushResult]]:
    """Name of the kernel of a push, room for its solutions, and their form."""
    if rows.ends:
        return "solve_flush", FLUSH_SOLUTIONS[rows.is_steady], SideResult
    return "solve", SOLUTIONS[rows.is_steady], PushResult


def _solve_single(scene: Scene, rows: Rows, angle: float, magnitude: float) -> Solutions:
    """The solutions of one push of one scene: those of `solve_arrays`, in a tenth of the time."""
    require_proportion(rows.entries, rows.strengths, magnitude)
    moves = magnitude > 0.0
    size = magnitude if moves else float(size_of_fall(rows.entries, rows.strengths))
    unit, row = in_units(rows.entries, rows.columns, rows.strengths, size)
    first, radius = len(row), rows.body[2]
    row += rows.push
    row[first + PUSHER], row[first + MOVES] = angle, moves
    kernel, room, result = _kernel_of(rows)
    head, width = PushResults.size, result.size
    results = run(kernel, rows.data, [row], head + room * width)[0].tolist()
    count, status = map(int, results[:head])
    solutions = []
    for first in range(head, head + width * count, width):
        numbers = results[first : first + width]
        v_x, v_y, spin = numbers[PLACES["twist"]]
        solutions.append(
            Solution(
                mode=MODES[int(numbers[PLACES["mode"]])],
                force=_vector(unit, numbers, "force"),
                force_end=_vector(unit, numbers, "force_end"),
                contact_motion=_vector(size, numbers, "motion"),
                twist=np.array([size * v_x, size * v_y, size * spin / radius]),
                spin_ratio=numbers[PLACES["spin_ratio"]],
                center=_vector(radius, numbers, "center"),
                pivot=int(numbers[PLACES["pivot"]]),
                continuum=numbers[PLACES["continuum"]] == 1.0,
                **(_on_side(numbers, unit, radius) if rows.ends else {}),
            )
        )
    return Solutions(tuple(solutions), Status(status), (scene, angle, magnitude))


def _on_side(numbers: Sequence[float], unit: float, radius: float) -> dict[str, Any]:
    """The fields that only solutions of a flush side have."""
    return {
        "flush": numbers[PLACES["flush"]] == 1.0,
        "force_position": radius * numbers[PLACES["position"]],
        "end_forces": _vector(unit, numbers, "end_forces").reshape(2, 2, 2),
    }


def _vector(unit: float, numbers: Sequence[float], field: str) -> Array:
    """The components of a field, multiplied by their unit."""
    return np.array([unit * number for number in numbers[PLACES[field]]])


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
        as an array, and a labeled scene as a DataArray, whatever the angle is. If a side lies on the fence
        (`Slider.flush`), they also hold `flush`, `force_position` and `end_forces`.

    Raises
    ------
    InvalidValue
        If a value, or m a / W with friction and inertia, is out of its range, or derivatives are requested
        with a DataArray or at an inner corner. An angle beyond 4 pi is refused because it is most likely in
        degrees, and a tuple because it is most likely a velocity.

    Notes
    -----
    A point at an inner corner of the outline touches two sides. It sticks if its force is the sum of one in
    the friction cone of each side; it slips along one of the sides and leaves the other, in the modes
    `SLIP_RIGHT` along the side before the corner and `SLIP_LEFT` along the side after it; it separates
    from both. The normal of the contact is then the bisector of those of the sides.

    A side that lies on the fence has flush modes and point contacts. A flush mode is a translation; its
    force, of any pressure between the ends of the side, is in the friction cone and crosses the fence
    between the ends (Lynch and Mason, Stable pushing, International Journal of Robotics Research 15,
    1996). A contact at one end lifts the other end off. It counts as flush if the slider does not rotate.
    At a perfectly rough side, flush sticking is always consistent, with a force that can be adhesive at
    either end; contacts that stick at one end while the other lifts off are listed, too. With a load, a
    side at rest is held if forces of the contact and friction balance the load; the force is then the one
    that needs the smallest share of friction. Solutions of one mode are in the order: flush, at the start
    of the side, at its end.
    """
    rows = require_scene(scene).rows
    require_held(scene)
    push = _push(scene, pusher_angle, pusher_magnitude)
    derivatives = require_flag("derivatives", derivatives)
    # Numbers of numpy, such as those of np.deg2rad, are floats, too.
    single = rows.is_single and isinstance(push[0], float) and isinstance(push[1], float)
    if single and not derivatives:
        return _solve_single(scene, rows, float(push[0]), float(push[1]))
    columns = [*rows.columns, *rows.body, *rows.ends, *rows.law, rows.pocket, *push]
    results = outputs(rows.is_steady, bool(rows.ends))
    if derivatives:
        require_unlabeled(columns)
        require_flat_contact(scene)
    answer = functools.partial(solve_arrays, rows)
    arrays = answer(*columns) if single else elementwise(answer, columns, results)
    by_name = {output.name: array for output, array in zip(results, arrays, strict=True)}
    if is_labeled(arrays[0]):
        return named_units(as_dataset(by_name), scene.units, inertia=scene.stores_energy)
    by = solution_derivatives(scene, columns, by_name) if derivatives else None
    if np.ndim(arrays[0]):
        return SolutionArrays(**by_name, derivatives=by)
    angle, magnitude = map(float, push)
    return solutions_from(by_name, (scene, angle, magnitude), by)


def _push(scene: Scene, angle: Number | None, magnitude: Number | None) -> tuple[Number, Number]:
    """Angle and magnitude of a push, by default those of the scene's file."""
    push = scene.push if angle is None else (angle, 1.0)
    if push is None:
        raise InvalidValue(
            "pusher_angle", None, "radians, for a scene whose file holds no push",
            "give the angle of the push, np.deg2rad(90) for one into the slider",
        )  # fmt: skip
    return (
        require_in_range("pusher_angle", push[0]),
        require_in_range("pusher_magnitude", push[1] if magnitude is None else magnitude),
    )
