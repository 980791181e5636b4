"""`simulate`: the motion of a pushed slider over time, as a log."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from typing import Any

import numpy as np
import xarray as xr
from tqdm import tqdm

from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene, required_scene, required_single
from planar_pushing.simulation.events.integrate import EventDriven
from planar_pushing.simulation.log.disk import PathLike
from planar_pushing.simulation.log.stream import streaming
from planar_pushing.simulation.log.variables import dataset
from planar_pushing.simulation.problem import Problem, sample_count
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.simulation.steps.integrate import TimeStepping
from planar_pushing.simulation.until import Until, UntilRun, required_condition
from planar_pushing.terms.domain import required
from planar_pushing.terms.errors import (
    InvalidValue,
    require_kind,
    require_number,
    require_option,
    require_path,
)
from planar_pushing.terms.options import Event, Method, MethodName, Policy, PolicyName


def simulate(
    scene: Scene,
    *,
    pusher: Pusher,
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
    path: PathLike | None = None,
    progress: bool = False,
) -> xr.Dataset:
    """Simulate the slider under a moving fence, and log its motion.

    Parameters
    ----------
    scene : Scene
        Its rod angle is the initial one; the contact starts on the fence, at the origin. An outline may not
        begin through the fence.
    pusher : Pusher
        A fence or a finger, and its velocity over time.
    duration : float
        Time to simulate at most, > 0.
    method : {"event-driven", "time-stepping"}
        DOP853 from event to event to the tolerance, or steps of first order, which survive
        configurations in which the equations of motion have no solution.
    rtol : float
        Relative tolerance of the motion, for the event-driven method.
    on_ambiguity : {"keep-contact", "separate", "stay-in-mode", "stick", "slip-right", "slip-left"}
        Which mode is taken where several are consistent. "keep-contact": sticking before slip, separation
        last; "separate": separation first; "stay-in-mode": the mode so far while it is consistent; "stick",
        "slip-right", "slip-left": that mode where it is consistent, else as "keep-contact". Or a sequence
        of (start_time, policy), which begins at 0: each policy holds until the next starts, and at these
        times the mode is chosen anew.
    twist : (v_x, v_y, omega)
        Initial twist at the slider's center, omega in radians per time, for a scene with inertia.
    gap : float
        Initial height of the contact above the fence.
    samples : int
        Number of evenly spaced instants in the log, >= 2; every event is logged besides.
    step : float, optional
        Greatest step of the time-stepping method, by default a thousandth of the duration.
    until : Event, ContactMode, str, Until or callable, optional
        The run stops at the first instant at which this holds: the event or the contact mode of this name
        (a flag meaning of `event` or `mode` in the log), a rotation or a distance that is reached, or a
        function of an instant that returns True. The function is given the log's variables at the instant
        by name, in the log's units, and `time`; its answer is looked at in every entry of the log, and then
        between the two entries where it changes, to rounding of the time. By time-stepping the run stops at
        the end of a step, and events are not located.
    object_pose : (x, y, angle), optional
        Pose of the object's frame in the world at time 0, the angle in radians. With it the log holds
        `object_pose`, whose angles are degrees, and `pusher_position`, the place of the finger's center or
        of the point of the fence that is under the contact at time 0. The object's frame is that of
        `Scene.placement`, by default the body frame.
    path : path, optional
        A file to which the log is streamed; memory then stays bounded, and the dataset that is returned
        reads from the file.
    progress : bool
        Whether to show a progress bar.

    Returns
    -------
    xarray.Dataset
        One entry of each variable for each instant; angles in degrees. Where the motion ended before the
        duration the attribute `stopped` says why: it could not go on, or `until` holds ("until: ..."). It
        is empty otherwise. A finger that leaves the side at its end ends the contact for good: `parted` is
        true from then on. A slider with an outline ends the run there, and where another point of the
        outline meets the fence, to a billionth of the outline's extent.

    Raises
    ------
    InvalidValue
        Where a value is not allowed.
    InvalidFile
        Where `path` cannot be written.
    """
    required_single(required_scene(scene))
    require_kind("pusher", pusher, Pusher)
    for name, several in (("velocity", pusher.arrays), ("radius", np.ndim(pusher.radius))):
        if several:
            raise InvalidValue(
                name, "arrays", f"one {name}", "take the pushers one by one, or call simulate_batch"
            )
    for name, given in (("duration", duration), ("gap", gap)):
        require_number(name, required(name, given), math.isfinite, "one number", "give one")
    problem = Problem(
        scene=scene, pusher=pusher, duration=duration, twist=twist, gap=gap,
        on_ambiguity=on_ambiguity, rtol=rtol, object_pose=object_pose,
    )  # fmt: skip
    if path is not None:
        require_path("path", path)
    require_option("method", method, Method, "name one of these methods")
    run = _run(problem, method, np.linspace(0.0, duration, sample_count(samples)), step, until)
    if path is None:
        rows = np.concatenate(list(_shown(run, duration, progress)))
        return dataset(problem, method, rows, run.stopped)
    with streaming(path, problem, method) as stream:
        for rows in _shown(run, duration, progress):
            stream.append(rows)
        stream.end(run.stopped, rows["time"][-1])
    return xr.open_dataset(path, engine="h5netcdf")


def _run(problem: Problem, method: str, times: Array, step: float | None, until: Any) -> Any:
    """A run that has not begun."""
    start: Callable[[Array], Any]
    if method == Method.TIME_STEPPING:
        start = partial(TimeStepping, problem, step=step)
    elif step is not None:
        raise InvalidValue(
            "step", step, "a number for the time-stepping method only",
            "leave it out: the event-driven method takes its steps by rtol",
        )  # fmt: skip
    else:
        start = partial(EventDriven, problem)
    run = start(times)
    if until is None:
        return run
    return UntilRun(start, times, required_condition(until, problem, method), problem)


def _shown(batches: Iterable[Any], duration: float, progress: bool) -> Iterator[Any]:
    """The same batches of rows, with a progress bar over the simulated time."""
    with tqdm(total=duration, disable=not progress, unit="time", leave=False) as bar:
        for rows in batches:
            bar.update(rows["time"][-1] - bar.n)
            yield rows
