"""`simulate_batch`: the motion of many scenes, given as one scene with array parameters."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields, replace
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
import xarray as xr

from planar_pushing.core.motion.kinematics.run import LogRow
from planar_pushing.mechanics.contact import friction_coefficient
from planar_pushing.mechanics.kernels.arrays import is_labeled
from planar_pushing.mechanics.kernels.columns import Columns
from planar_pushing.mechanics.scene import Scene, require_scene
from planar_pushing.simulation.early_end import warn_of_early_end
from planar_pushing.simulation.fields import FIELDS, Stop, arrays, sampled_fields
from planar_pushing.simulation.inputs import Scenes, numbers_of
from planar_pushing.simulation.log import variable_attributes, without_fill_values
from planar_pushing.simulation.problem import Problem, warn_of_doubts
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.simulation.runs import Ends, run_scenes
from planar_pushing.simulation.world import World, require_one_shape
from planar_pushing.terms import quantities
from planar_pushing.terms.domain import SAMPLE_COUNT
from planar_pushing.terms.errors import (
    InvalidValue,
    require_flag,
    require_kind,
)
from planar_pushing.terms.numbers import Array
from planar_pushing.terms.options import Policy, PolicyName, Shape


@warn_of_early_end
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
    object_pose: Sequence[npt.ArrayLike] | None = None,
    progress: bool = False,
) -> xr.Dataset:
    """Simulate many scenes, given as one scene with array parameters, each as `simulate` does.

    Parameters
    ----------
    scene : Scene
        Parameters of slider, law and effects can be arrays of shape (scenes,) or labeled arrays.
    pusher : Pusher
        Pusher of all scenes; the second argument, or by name, as in `simulate`. The components of its
        velocity, also in each piece, and the radius of a finger can be arrays. Scenes under a pusher that
        follows a function of time are simulated one by one.
    duration, gap : array_like
        As in `simulate`. All arrays are broadcast against each other, labeled arrays by name.
    twist : (v_x, v_y, omega)
        As in `simulate`, omega in radians per time; numbers or arrays.
    rtol, on_ambiguity
        As in `simulate`.
    samples : int, optional
        Number of evenly spaced instants, including the first and the last; by default only the last.
    object_pose : (x, y, angle), optional
        As in `simulate`, the angle in radians; numbers or arrays. With it, the dataset contains
        `object_position`, `object_angle`, `pusher_position` and, with an outline, `contact_normal`, and
        the pusher can move along the axes of the world.
    progress : bool
        Whether to show a progress bar.

    Returns
    -------
    xarray.Dataset
        Dataset over `scene`, or the dimensions of the labeled arrays, and over `part` of the duration if
        `samples` is given; angles are in degrees. The numbers are equal to those of `simulate`; `force` is
        the force at the instant, and `impulse` the sum of those since the instant before, or since the
        start. For a run whose motion could not continue, `stopped`, a text that is empty otherwise, and
        `time` say why and when; its other numbers are the last ones. Runs in which a finger touches two
        places go on one by one, as in `simulate`, which takes longer.

    Warns
    -----
    SceneWarning
        If a fence pushes at an inner point of a side, all of which lies on it; if a finger pushes an object
        that `scene_at` made without an outline, whose wall is then straight and without ends; or if the
        finger's radius is larger than the object.
    EarlyEndWarning
        Once, if the motion of some scenes could not continue.

    Raises
    ------
    InvalidValue
        If a value is not allowed, or shapes do not match.
    """
    require_kind("pusher", pusher, Pusher)
    require_flag("progress", progress)
    problem = Problem(
        scene=require_scene(scene), pusher=pusher, duration=duration, twist=twist, gap=gap,
        rtol=rtol, on_ambiguity=on_ambiguity, object_pose=object_pose,
    )  # fmt: skip
    warn_of_doubts(problem)
    return batch_of(problem, samples, progress)


def batch_of(
    problem: Problem,
    samples: int | None = None,
    progress: bool = False,
    passes_inner_corners: bool = True,
) -> xr.Dataset:
    """The dataset of `simulate_batch`; optionally, a run ends where a finger touches two places."""
    data, numbers = numbers_of(problem)
    columns, over = _broadcast(numbers)
    _require_free_names(over)
    scenes = Scenes.of(problem, data, np.stack(columns, axis=-1))
    parts = (
        np.ones(1)
        if samples is None
        else np.linspace(0.0, 1.0, int(SAMPLE_COUNT.require("samples", samples)))
    )
    last = scenes.ends
    # Bit for bit the times of `simulate`.
    times = last[:, None] if samples is None else np.linspace(0.0, last, len(parts), axis=-1)
    rows, ends = run_scenes(scenes, times, progress)
    if passes_inner_corners and problem.passes_inner_corners:
        _go_on(scenes, over, times, rows, ends)
    variables = _variables(scenes, rows, ends, samples is None)
    unfolded = {name: _unfold(variable, over) for name, variable in variables.items()}
    coordinates = _coordinates(problem, over) | ({"part": ("part", parts)} if samples else {})
    dataset = xr.Dataset(unfolded, coordinates)
    table = quantities.FINGER_BATCH if problem.shape == Shape.FINGER else quantities.BATCH
    for label, variable in dataset.variables.items():
        if label not in over.coordinates:
            attributes = variable_attributes(table, str(label), problem.scene.units)
            variable.attrs = attributes or variable.attrs
    return without_fill_values(dataset)


class Over(NamedTuple):
    """Dimensions, shape and coordinates of the arrays of a problem."""

    dims: tuple[str, ...]
    shape: tuple[int, ...]
    coordinates: dict[Any, Any]


def _require_free_names(over: Over) -> None:
    """Reject dimensions and coordinates with names of results."""
    sampled = (field.name for field in FIELDS if field.sampled)
    names = {*sampled, "stopped", "mode_changes", "evaluations", "part", "piece", "xy"}
    for name in (*over.dims, *map(str, over.coordinates)):
        if name in names:
            raise InvalidValue(
                "dimensions", name, "names that no result has", "rename it, or drop the coordinate"
            )


def _broadcast(values: list[Any]) -> tuple[list[Array], Over]:
    """Flat arrays of values that are broadcast against each other, and what they are over."""
    require_one_shape(values)
    if any(map(is_labeled, values)):
        labeled = (value if is_labeled(value) else xr.DataArray(value) for value in values)
        broadcast = xr.broadcast(*labeled)
        dims = tuple(map(str, broadcast[0].dims))
        arrays = [value.values for value in broadcast]
        coordinates = dict(broadcast[0].coords)
    else:
        arrays, dims, coordinates = [np.asarray(value, float) for value in values], ("scene",), {}
    shapes = {np.shape(array) for array in arrays}
    shape = np.broadcast_shapes((1,) * len(dims), *shapes)
    if len(shape) != len(dims) or 0 in shape:
        raise InvalidValue(
            "shapes", sorted(shapes), "() or (scenes,)", "give one number for each scene"
        )
    flat = [np.broadcast_to(np.asarray(array, float), shape).reshape(-1) for array in arrays]
    return flat, Over(dims, shape, coordinates)


def _go_on(scenes: Scenes, over: Over, times: Array, rows: Array, ends: Ends) -> None:
    """Replace the rows of the runs that have ended where a finger touches two places, as in `simulate`."""
    for i in np.flatnonzero(Columns(LogRow, rows[:, -1]).stopped == Stop.TWO_CONTACTS).tolist():
        problem = _problem_of(scenes, over, i)
        if problem.passes_inner_corners:
            from planar_pushing.simulation.several.continued import ContinuedRun

            run = ContinuedRun(problem, times[i])
            log = np.concatenate(list(run))
            last = np.searchsorted(Columns(LogRow, log).time, times[i], side="right") - 1
            rows[i], ends.reasons[i] = log[last], run.stopped
            ends.changes[i] += run.later_changes


def _problem_of(scenes: Scenes, over: Over, number: int) -> Problem:
    """The problem of one of many scenes, in its fence frame."""
    problem, scene = scenes.problem, scenes.problem.scene

    def of(value: Any) -> Any:
        """The number of the scene, or the law or the support."""
        if isinstance(value, tuple):
            entries = [of(entry) for entry in value]
            return type(value)(*entries) if hasattr(value, "_fields") else tuple(entries)
        if is_labeled(value):
            return (
                value.broadcast_like(_template(over)).transpose(*over.dims).values.ravel()[number]
            )
        if isinstance(value, (list, np.ndarray)):
            values = np.asarray(value, None if isinstance(value, np.ndarray) else object)
            return np.broadcast_to(values, over.shape).ravel()[number]
        return value

    def part(value: Any) -> Any:
        return replace(
            value, **{f.name: of(getattr(value, f.name)) for f in fields(value) if f.init}
        )

    pusher = scenes.pusher_of(number)
    velocity: Any = [(start, of(velocity)) for start, velocity in pusher.velocities]
    return Problem(
        scene=Scene(
            slider=part(scene.slider), contact=of(scene.contact),
            effects=tuple(map(part, scene.effects)), units=scene.units,
        ),
        pusher=Pusher(
            velocity=velocity or pusher.velocity, breakpoints=pusher.breakpoints, shape=pusher.shape,
            radius=float(of(pusher.radius)),
        ),
        duration=float(scenes.ends[number]), gap=float(of(problem.gap)), rtol=problem.rtol,
        on_ambiguity=problem.on_ambiguity,
    )  # fmt: skip


def _template(over: Over) -> xr.DataArray:
    """An array with the dimensions of the scenes."""
    return xr.DataArray(np.zeros(over.shape), dims=over.dims)


def _variables(scenes: Scenes, rows: Array, ends: Ends, only_last: bool) -> dict[str, Any]:
    """Variables of rows, with dimensions and types as in a log, and of the ends of the runs."""
    problem, world = scenes.problem, scenes.world
    evaluations = Columns(LogRow, rows[:, -1]).evaluations.astype(np.int64)
    stops = Columns(LogRow, rows).stopped != Stop.NO
    stopped = np.where(stops, ends.reasons[:, None], "").astype(str)
    dims: tuple[str, ...] = ("scene", "part")
    if only_last:
        dims, rows, stopped = dims[:1], rows[:, -1], stopped[:, -1]
    if world is not None and not only_last:
        world = World.of_numbers([number[:, None] for number in world.numbers])
    fields = sampled_fields(problem)
    values = arrays(rows, problem, fields, world)
    return {
        **{field.name: ((*dims, *field.dims), values[field.name]) for field in fields},
        "stopped": (dims, stopped),
        "mode_changes": (("scene",), ends.changes),
        "evaluations": (("scene",), evaluations),
    }


def _unfold(variable: Any, over: Over) -> Any:
    """Reshape a variable over the scenes to their dimensions."""
    dims, array = variable
    return (*over.dims, *dims[1:]), array.reshape((*over.shape, *array.shape[1:]))


def _coordinates(problem: Problem, over: Over) -> dict[str, Any]:
    """Coordinates that describe each scene; those of the user's arrays have priority."""
    slider, pusher = problem.scene.slider, problem.pusher
    scenes = {
        "rod_length": slider.rod_length, "initial_rod_angle": np.rad2deg(slider.rod_angle),
        "duration": problem.duration, "friction_coefficient": _coefficients(problem.scene.contact),
    }  # fmt: skip
    if np.ndim(pusher.radius):
        scenes["pusher_radius"] = pusher.radius
    coordinates = {name: _expand(value, over) for name, value in scenes.items()}
    if pusher.arrays and "velocity" not in over.coordinates:
        coordinates |= _velocities(pusher, over)
    kept = {
        name: coordinate for name, coordinate in coordinates.items() if name not in over.coordinates
    }
    return {"xy": ("xy", ["x", "y"])} | over.coordinates | kept


def _velocities(pusher: Pusher, over: Over) -> dict[str, Any]:
    """Velocities of the pushers, over their pieces if there are several."""
    components = [
        [_expand(component, over)[1] for component in velocity] for _, velocity in pusher.arrays
    ]
    velocities = np.moveaxis(np.array(components), (0, 1), (-2, -1))
    if len(components) == 1:
        return {"velocity": ((*over.dims, "xy"), velocities[..., 0, :])}
    starts = [time for time, _ in pusher.arrays]
    return {"piece": ("piece", starts), "velocity": ((*over.dims, "piece", "xy"), velocities)}


def _coefficients(contact: Any) -> Any:
    """Friction coefficients of a law, or of an array of laws; infinite for laws without one."""
    laws = np.asarray(contact, dtype=object)
    if not laws.ndim:
        return getattr(contact, "friction_coefficient", np.inf)
    coefficients = np.reshape([friction_coefficient(law) for law in laws.ravel()], laws.shape)
    return contact.copy(data=coefficients) if is_labeled(contact) else coefficients


def _expand(value: Any, over: Over) -> Any:
    """Expand a number or an array to the dimensions of the scenes."""
    if is_labeled(value):
        value = value.broadcast_like(_template(over))
        value = value.transpose(*over.dims).values
    return over.dims, np.array(np.broadcast_to(np.asarray(value, float), over.shape))
