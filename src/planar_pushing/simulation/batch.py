"""`simulate_batch`: the motion of many scenes, given as one scene with array parameters."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
import xarray as xr

from planar_pushing.mechanics.arrays import is_labeled
from planar_pushing.mechanics.contact.laws import friction_coefficient
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene, required_scene
from planar_pushing.simulation.blocks import Fences, Scenes, run_scenes
from planar_pushing.simulation.log.variables import FINGER, complete, described, variables
from planar_pushing.simulation.policies import marked, starts_of
from planar_pushing.simulation.problem import Problem, sample_count
from planar_pushing.simulation.pusher import Pusher, constant_fences
from planar_pushing.simulation.rows import in_units
from planar_pushing.simulation.systems.setup import columns
from planar_pushing.terms import quantities
from planar_pushing.terms.errors import InvalidValue, require_flag, require_kind
from planar_pushing.terms.options import Policy, PolicyName, Shape

#: Variables of the dataset that are fields of a row.
SAMPLED = (
    "time", "position", "rod_angle", "slip", "gap", "force", "mode", "solutions", "pivot", "stopped",
)  # fmt: skip
#: Types of the variables that are not in a log.
TYPES = {"time": "f8", "stopped": "i1"}


def simulate_batch(
    scene: Scene,
    pusher: Pusher,
    *,
    duration: npt.ArrayLike,
    twist: Sequence[npt.ArrayLike] = (0.0, 0.0, 0.0),
    gap: npt.ArrayLike = 0.0,
    rtol: float = 1e-10,
    on_ambiguity: PolicyName | Sequence[tuple[float, PolicyName]] = Policy.KEEP_CONTACT,
    samples: int | None = None,
    progress: bool = False,
) -> xr.Dataset:
    """Simulate many scenes, given as one scene with array parameters, each as `simulate` does.

    Parameters
    ----------
    scene : Scene
        Parameters of slider, law and effects can be arrays of shape (scenes,) or labeled arrays.
    pusher : Pusher
        Pusher of all scenes. The components of its velocity, also in each piece, and the radius of a finger
        can be arrays. Scenes under a pusher that follows a function of time are simulated one by one.
    duration, gap : array_like
        As in `simulate`. All arrays are broadcast against each other, labeled arrays by name.
    twist : (v_x, v_y, omega)
        As in `simulate`, omega in radians per time; numbers or arrays.
    rtol, on_ambiguity
        As in `simulate`.
    samples : int, optional
        Number of evenly spaced instants, including the first and the last; by default only the last.
    progress : bool
        Whether to show a progress bar.

    Returns
    -------
    xarray.Dataset
        Dataset over `scene`, or the dimensions of the labeled arrays, and over `part` of the duration if
        `samples` is given; angles are in degrees. The numbers are equal to those of `simulate`; `force` is
        the force at the instant.

    Raises
    ------
    InvalidValue
        If a value is not allowed, or shapes do not match.
    """
    require_kind("pusher", pusher, Pusher)
    require_flag("progress", progress)
    problem = Problem(
        scene=required_scene(scene), pusher=pusher, duration=duration, twist=twist, gap=gap,
        rtol=rtol, on_ambiguity=on_ambiguity,
    )  # fmt: skip
    given = _given(problem)
    _require_free(given)
    parts = np.ones(1) if samples is None else np.linspace(0.0, 1.0, sample_count(samples))
    ends = given.scenes.ends
    # Bit for bit the times of `simulate`.
    times = np.linspace(0.0, ends, len(parts), axis=-1) if samples else ends[:, None]
    rows, changes = run_scenes(problem, given.scenes, np.ascontiguousarray(times), progress)
    found = _variables(problem, in_units(rows, given.scenes.radius), samples is None)
    found["mode_changes"] = ("scene",), changes
    found["evaluations"] = ("scene",), np.array(rows["evaluations"][:, -1])
    found = {name: _unflat(value, given) for name, value in found.items()}
    coordinates = _coordinates(problem, given) | ({"part": ("part", parts)} if samples else {})
    dataset = xr.Dataset(found, coordinates)
    for label, variable in dataset.variables.items():
        if label not in given.own:
            about = described(quantities.BATCH, str(label), problem.scene.units)
            variable.attrs = about or variable.attrs
    return complete(dataset)


class Given(NamedTuple):
    """The scenes of a problem, and the dimensions, shape and coordinates of its arrays."""

    scenes: Scenes
    dims: tuple[str, ...]
    shape: tuple[int, ...]
    own: dict[str, Any]


def _given(problem: Problem) -> Given:
    """Scenes from arrays that are broadcast against each other."""
    scene, pusher = problem.scene, problem.pusher
    velocities = [part for _, velocity in pusher.arrays for part in velocity]
    numbers = columns(scene, problem.twist, problem.gap, pusher.radius)
    flat, dims, shape, own = _broadcast(
        [*numbers, scene.slider.radius, problem.duration, *velocities]
    )
    count = len(numbers)
    rows, (radius, ends), parts = flat[:count], flat[count : count + 2], flat[count + 2 :]
    moves = np.stack(parts, axis=-1).reshape(len(ends), -1, 2) if parts else None
    fences = _fences(problem, ends, radius, moves)
    return Given(Scenes(np.stack(rows, axis=-1), ends, radius, fences), dims, shape, own)


def _require_free(given: Given) -> None:
    """Reject dimensions and coordinates with names of results."""
    taken = {*SAMPLED, *FINGER, "mode_changes", "evaluations", "part", "piece", "xy"}
    for name in (*given.dims, *map(str, given.own)):
        if name in taken:
            raise InvalidValue(
                "dimensions", name, "names that no result has", "rename it, or drop the coordinate"
            )


def _broadcast(
    given: list[Any],
) -> tuple[list[Array], tuple[str, ...], tuple[int, ...], dict[str, Any]]:
    """Flat arrays, and the dimensions, shape and coordinates of the given values."""
    if any(map(is_labeled, given)):
        loose = [each for each in given if np.ndim(each) and not is_labeled(each)]
        if loose:
            raise InvalidValue(
                "shapes", np.shape(loose[0]), "labeled arrays, or arrays of one shape",
                "also give this array as an xarray.DataArray",
            )  # fmt: skip
        every = xr.broadcast(*(each if is_labeled(each) else xr.DataArray(each) for each in given))
        dims = tuple(map(str, every[0].dims))
        arrays, own = [each.values for each in every], dict(every[0].coords)
    else:
        arrays, dims, own = [np.asarray(each, float) for each in given], ("scene",), {}
    shapes = {np.shape(each) for each in arrays}
    try:
        shape = np.broadcast_shapes((1,) * len(dims), *shapes)
    except ValueError:
        shape = ()
    if len(shape) != len(dims) or 0 in shape:
        raise InvalidValue(
            "shapes", sorted(shapes), "() or (scenes,)", "give one number for each scene"
        )
    flat = [np.broadcast_to(np.asarray(each, float), shape).reshape(-1) for each in arrays]
    return flat, dims, shape, own


def _fences(problem: Problem, ends: Array, radius: Array, moves: Any) -> Fences:
    """Motions of the fences of scenes; functions of time are converted for one scene at a time."""
    pusher, policies = problem.pusher, problem.on_ambiguity
    if problem.follows_function:

        def function(part: slice) -> tuple[Any, Array]:
            fence = problem.fence(float(ends[part.start]), float(radius[part.start]))
            return fence[None], np.array([len(fence)])

        return function
    times = np.array([time for time, _ in pusher.arrays])
    starts, velocities = pusher.steps if moves is None else (times, moves)
    every = np.broadcast_to(velocities, (len(ends), len(starts), 2)) / radius[:, None, None]

    def constant(part: slice) -> tuple[Any, Array]:
        fences, counts = constant_fences(starts, every[part], ends[part], starts_of(policies))
        return marked(fences, policies), counts

    return constant


def _variables(problem: Problem, rows: Any, only_last: bool) -> dict[str, Any]:
    """Variables of rows, with dimensions and types as in a log."""
    over, rows = (("scene",), rows[:, -1]) if only_last else (("scene", "part"), rows)
    logged = {name: ((), dtype) for name, dtype in TYPES.items()} | variables(problem)
    found: dict[str, Any] = {}
    for name in (*SAMPLED, *(FINGER if problem.shape == Shape.FINGER else ())):
        dims, dtype = logged[name]
        found[name] = (*over, *dims), rows[name].astype(dtype)
    found["rod_angle"] = over, np.rad2deg(rows["rod_angle"])
    return found


def _unflat(value: Any, given: Given) -> Any:
    """Reshape a variable over the scenes to their dimensions."""
    dims, array = value
    return (*given.dims, *dims[1:]), np.asarray(array).reshape(*given.shape, *array.shape[1:])


def _coordinates(problem: Problem, given: Given) -> dict[str, Any]:
    """Coordinates that describe each scene."""
    slider, contact = problem.scene.slider, problem.scene.contact
    laws = np.asarray(contact, dtype=object)
    mu = [friction_coefficient(law) for law in laws.ravel()] if laws.ndim else None
    every = {
        "rod_length": slider.rod_length, "initial_rod_angle": np.rad2deg(slider.rod_angle),
        "duration": problem.duration,
        "friction_coefficient": _coefficients(contact) if mu is None else _like(contact, mu),
    }  # fmt: skip
    found: dict[str, Any] = {"xy": ("xy", ["x", "y"])} | given.own
    for name, each in every.items():
        if name not in found:
            found[name] = _over(each, given)
    if np.ndim(problem.pusher.radius) and "pusher_radius" not in found:
        found["pusher_radius"] = _over(problem.pusher.radius, given)
    if problem.pusher.arrays and "velocity" not in found:
        found |= _velocities(problem.pusher, given)
    return found


def _velocities(pusher: Pusher, given: Given) -> dict[str, Any]:
    """Velocities of the pushers, over their pieces if there are several."""
    parts = [[_over(part, given)[1] for part in velocity] for _, velocity in pusher.arrays]
    every = np.moveaxis(np.array(parts), (0, 1), (-2, -1))
    if len(parts) == 1:
        return {"velocity": ((*given.dims, "xy"), every[..., 0, :])}
    starts = [time for time, _ in pusher.arrays]
    return {
        "piece": ("piece", starts), "velocity": ((*given.dims, "piece", "xy"), every),
    }  # fmt: skip


def _coefficients(law: Any) -> Any:
    return getattr(law, "friction_coefficient", np.inf)


def _like(contact: Any, mu: list[float]) -> Any:
    array = np.reshape(mu, np.shape(contact))
    return contact.copy(data=array) if is_labeled(contact) else array


def _over(value: Any, given: Given) -> Any:
    """Expand a number or an array to the dimensions of the scenes."""
    if is_labeled(value):
        value = value.broadcast_like(xr.DataArray(np.zeros(given.shape), dims=given.dims))
        value = value.transpose(*given.dims).values
    return given.dims, np.array(np.broadcast_to(np.asarray(value, float), given.shape))
