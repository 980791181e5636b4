"""`simulate`: the motion of a pushed slider over time, recorded in a log."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from planar_pushing.core.motion.kinematics.run import LogRow
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.scene import Scene, require_scene, require_single
from planar_pushing.simulation.early_end import warn_of_early_end
from planar_pushing.simulation.log import dataset, without_fill_values
from planar_pushing.simulation.problem import Problem, warn_of_doubts
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.simulation.runs import Run, progress_bar
from planar_pushing.simulation.until import Until, UntilRun, require_condition
from planar_pushing.simulation.walls import Wall, require_walls
from planar_pushing.terms.domain import DURATION, GAP, SAMPLE_COUNT
from planar_pushing.terms.errors import (
    InvalidValue,
    has_entries,
    require_flag,
    require_kind,
    require_number,
    require_option,
    require_path,
)
from planar_pushing.terms.locks import PathLike, regular_file
from planar_pushing.terms.netcdf import write_dataset
from planar_pushing.terms.numbers import Array
from planar_pushing.terms.options import Event, Method, MethodName, Policy, PolicyName

if TYPE_CHECKING:
    from planar_pushing.simulation.several.continued import ContinuedRun
    from planar_pushing.simulation.several.rows import SeveralRows

    AnyRun = Run | UntilRun | SeveralRows | ContinuedRun


@warn_of_early_end
def simulate(
    scene: Scene,
    pusher: Pusher,
    *,
    duration: float,
    method: MethodName = Method.EVENT_DRIVEN,
    rtol: float = 1e-10,
    on_ambiguity: PolicyName | Sequence[tuple[float, PolicyName]] = Policy.KEEP_CONTACT,
    twist: Sequence[float] = (0.0, 0.0, 0.0),
    gap: float = 0.0,
    samples: int = 101,
    step: float | None = None,
    until: Event | ContactMode | str | Until | Callable[[dict[str, Any]], bool] | None = None,
    object_pose: Sequence[float] | None = None,
    walls: Sequence[Wall] = (),
    path: PathLike | None = None,
    progress: bool = False,
) -> xr.Dataset:
    """Simulate the slider under a moving pusher, and log its motion.

    Parameters
    ----------
    scene : Scene
        Scene with the initial rod angle; without a gap, the contact starts on the fence, at the origin. An
        outline must not penetrate the pusher initially.
    pusher : Pusher
        A fence or a finger, and its velocity over time; the second argument, or by name.
    duration : float
        Maximum time to simulate, > 0.
    method : {"event-driven", "time-stepping"}
        Integration from event to event by DOP853 within the tolerance, or first-order steps, which pass
        through configurations in which the equations of motion have no solution.
    rtol : float
        Relative tolerance of the motion, for the event-driven method.
    on_ambiguity : {"keep-contact", "separate", "stay-in-mode", "stick", "slip-right", "slip-left"}
        Which mode is chosen if several are consistent. "keep-contact": sticking before slip, separation
        last; "separate": separation first; "stay-in-mode": the current mode while it is consistent;
        "stick", "slip-right", "slip-left": this mode if it is consistent, otherwise as "keep-contact".
        Alternatively, a sequence of (start_time, policy) that begins at time 0: each policy lasts until the
        next one starts, and the mode is chosen again at these times.
    twist : (v_x, v_y, omega)
        Initial twist at the slider's center, with omega in radians per time, for a scene with inertia.
    gap : float
        Initial height of the contact above the fence; of several points that can touch the fence, the log
        has the height of the lowest.
    samples : int
        Number of evenly spaced instants in the log, >= 2; every event is also logged.
    step : float, optional
        Maximum step of the time-stepping method, by default 1/1000 of the duration.
    until : Event, ContactMode, str, Until or callable, optional
        Condition that stops the run at the first instant at which it holds: an event or a contact mode,
        also by name (a flag meaning of `event` or `mode` in the log), a rotation or distance to reach, or a
        function of an instant that returns True. The function receives the log's variables at the instant
        and `time`, by name and in the log's units. It is evaluated at every entry of the log, and then
        between the two entries where its result changes, until the time is known to rounding error. With
        time-stepping, the run stops at the end of a step, and events are not located.
    object_pose : (x, y, angle), optional
        Pose of the object's frame in the world at time 0, the angle in radians. With it, the log contains
        `object_position`, `object_angle` in degrees, and `pusher_position`, the position of the finger's
        center or of the point of the fence that is under the contact at time 0. The object's frame is that
        of `Scene.placement`, by default the body frame.
    walls : sequence of Wall
        Straight walls at rest in the world, for an object with an outline, without inertia, and with an
        `object_pose`. The log then also holds `wall_mode`, `wall_force`, with the axes of `force`,
        `wall_gap` and `wall_slip` over time and walls. The motion is that of the contacts with the pusher
        and the walls, at most four at once; where they jam or wedge the object, the run ends.
    path : path, optional
        File to which the log is streamed. Memory use is then bounded, and the returned dataset reads from
        the file. An older log of this name is replaced at the start; a run that is interrupted leaves its
        log up to that time, with the attribute `finished` equal to 0.
    progress : bool
        Whether to show a progress bar.

    Returns
    -------
    xarray.Dataset
        Log with one entry of each variable for each instant; angles are in degrees. Its attributes describe
        the run, with the center of mass in the object's frame if the scene has inertia. If the motion ended
        early, the attribute `stopped` gives the reason: the motion could not continue, or `until` holds
        ("until: ..."). Otherwise it is empty. A fence touches every corner of an outline, within a
        billionth of the outline's extent: a side that arrives on it continues in a consistent mode, with
        inertia after an impact at both ends or at one of them. `flush` is true while a side lies on the
        fence, and `contact_position` is the place of the force along the fence, or of the contact's point
        without a force. With inertia, `impulse` is that of the impacts at the instant, along the axes of
        `force`, and zero elsewhere: where the pusher meets the slider, a side arrives, or the pusher's
        velocity jumps, also at the start; the force of a step of time-stepping includes it. Without an
        outline only the contact, or the given side, touches a fence, and the run ends when the slider's
        center reaches it. A finger goes round an outline, over its corners and arcs, leaves it and meets
        it again. Without inertia it goes into inner corners and notches, where a disc touches two places:
        `force` is then the sum of both forces, `slip` the mean, and the contact that of the inner corner,
        with the bisector as its normal. With inertia, the run ends there. Without an outline, the contact
        ends permanently where it leaves the side at its end, and `parted` is true from then on.

    Warns
    -----
    SceneWarning
        If a fence pushes at an inner point of a side, all of which lies on it; if a finger pushes an object
        that `scene_at` made without an outline, whose wall is then straight and without ends; or if the
        finger's radius is larger than the object.
    EarlyEndWarning
        If the motion could not continue until the end of the duration, or until `until` holds.

    Raises
    ------
    InvalidValue
        If a value is not allowed.
    InvalidFile
        If `path` cannot be written, or another process is writing it.
    """
    require_single(require_scene(scene))
    require_kind("pusher", pusher, Pusher)
    pose: Any = object_pose if has_entries(object_pose) else ()
    poses = any(map(np.ndim, pose))
    given = ("velocity", pusher.arrays), ("radius", np.ndim(pusher.radius)), ("object_pose", poses)
    for name, several in given:
        if several:
            raise InvalidValue(
                name, "arrays", f"one {name}", "simulate them one by one, or call simulate_batch"
            )
    for name, number, value in (("duration", DURATION, duration), ("gap", GAP, gap)):
        require_number(name, number.require(name, value), math.isfinite, "one number", "give one")
    problem = Problem(
        scene=scene, pusher=pusher, duration=duration, twist=twist, gap=gap,
        on_ambiguity=on_ambiguity, rtol=rtol, object_pose=object_pose,
    )  # fmt: skip
    warn_of_doubts(problem)
    if path is not None:
        regular_file(require_path("path", path))
    require_flag("progress", progress)
    chosen = require_option("method", method, Method, "name one of these methods")
    times = np.linspace(0.0, float(problem.duration), int(SAMPLE_COUNT.require("samples", samples)))
    walls = require_walls(walls)
    run = _run(problem, chosen, times, step, until, walls)
    if walls:
        log = _with_walls(run, problem, chosen)
        if path is None:
            return log
        write_dataset(log, Path(path))
        return without_fill_values(xr.open_dataset(path, engine="h5netcdf"))
    if path is None:
        return dataset(problem, chosen, np.concatenate(list(_rows(run, progress))), run.stopped)
    from planar_pushing.simulation.storage.stream import streaming

    with streaming(path, problem, chosen) as stream:
        for rows in _rows(run, progress):
            stream.append(rows)
        stream.end(run.stopped, rows[-1, LogRow.places["time"]])
    return without_fill_values(xr.open_dataset(path, engine="h5netcdf"))


def _run(
    problem: Problem,
    method: Method,
    times: Array,
    step: float | None,
    until: Any,
    walls: Sequence[Wall],
) -> AnyRun:
    """Create a run, which has not begun."""
    if step is not None and method != Method.TIME_STEPPING:
        raise InvalidValue(
            "step", step, "a number for the time-stepping method only",
            "leave it out, since rtol controls the steps of the event-driven method",
        )  # fmt: skip
    start = partial(_start, problem, method, step, _in_fence_frame(walls, problem))
    run = start(times)
    if until is None:
        return run
    return UntilRun(start, times, require_condition(until, problem, method), problem, method)


def _start(
    problem: Problem, method: Method, step: float | None, walls: Sequence[Wall], times: Array
) -> AnyRun:
    """A run that has not begun, with walls or without."""
    if walls:
        from planar_pushing.simulation.several.rows import SeveralRows

        rows = SeveralRows(problem, walls, times, method, step)
        rows.require_apart()
        return rows
    if problem.passes_inner_corners:
        from planar_pushing.simulation.several.continued import ContinuedRun

        return ContinuedRun(problem, times, method=method, step=step)
    return Run(problem, times, method=method, step=step)


def _with_walls(run: Any, problem: Problem, method: Method) -> xr.Dataset:
    """The log of a run with walls."""
    from planar_pushing.simulation.several.rows import wall_variables

    log = dataset(problem, method, np.concatenate(list(run)), run.stopped)
    several = run.last if isinstance(run, UntilRun) else run
    variables = wall_variables(several, log.sizes["time"], problem.scene.units)
    return log.assign(variables)


def _in_fence_frame(walls: Sequence[Wall], problem: Problem) -> list[Wall]:
    """Walls in the fence frame at time 0."""
    if not walls:
        return []
    scene, world = problem.scene, problem.world
    for name, given, allowed, remedy in (
        ("object_pose", world is None, "the pose of the object in the world",
         "give object_pose, because walls are in the world"),
        ("outline", scene.slider.outline is None, "the outline of the object",
         "give scene_at the outline, so that it can touch a wall"),
        ("effects", scene.stores_energy, "a scene without inertia",
         "leave Inertia out: with walls, the motion is quasi-static"),
    ):  # fmt: skip
        if given:
            raise InvalidValue(name, None if name != "effects" else "inertia", allowed, remedy)
    fence = world.fence  # type: ignore[union-attr]
    return [
        Wall(fence.point_in(wall.point).tolist(), fence.vector_in(wall.normal).tolist(), wall.law)
        for wall in walls
    ]


def _rows(run: AnyRun, progress: bool) -> Iterator[Array]:
    """Yield the rows of a run, with a progress bar over the simulated time."""
    with progress_bar(float(run.problem.duration), "time", progress) as bar:
        for rows in run:
            bar.update(rows[-1, LogRow.places["time"]] - bar.n)
            yield rows
