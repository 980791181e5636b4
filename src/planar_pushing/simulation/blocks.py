"""Simulation of many scenes: the event-driven integrator loops over blocks of scenes in threads."""

from __future__ import annotations

from collections.abc import Callable
from threading import Event
from typing import Any, NamedTuple

import numpy as np
from tqdm import tqdm

from planar_pushing.mechanics.arrays import in_threads
from planar_pushing.mechanics.plane import Array
from planar_pushing.simulation.events.driver import ENDED, advance, begin
from planar_pushing.simulation.events.run import STATE, Task, run_type
from planar_pushing.simulation.legacy.compiled import inlined, kernel, owning
from planar_pushing.simulation.problem import Problem
from planar_pushing.simulation.rows import records, row_type
from planar_pushing.simulation.systems.base import BODY, Inertial, QuasiStatic
from planar_pushing.simulation.systems.setup import (
    NUMBERS,
    PUSHERS,
    fill,
    kinds_of,
    new_room,
    parts_of,
    put,
    shape_of,
    size_of,
)

#: Scenes in a block.
BLOCK = 128
#: Maximum number of rows that the integrator returns at once.
ROWS = 64
#: Steps after which a block returns to Python to check for Ctrl-C: a fraction of a second of work.
STEPS = 5_000

#: Function from a slice of scenes to their fences, shape (scenes, pieces), and the number of pieces of
#: each.
Fences = Callable[[slice], tuple[Any, Array]]


class Scenes(NamedTuple):
    """Many scenes in units of radii: rows as in `systems.setup`, durations, radii and fences."""

    rows: Array
    ends: Array
    radius: Array
    fences: Fences


@inlined
def _begin(system, numbers, run, at):
    """Begin the next scene of a block, unless it is already in progress."""
    if not at.begun:
        fill(numbers, system.fence, system.body)
        put(system, numbers, run.vectors[STATE])
        begin(system, run)
        at.begun, at.place = True, 0


@inlined
def _follow(system, task, run, rows, found, changes, at):
    """Continue one scene, store its rows at the task's times in `found`, and return the number of steps.

    If the scene ends early, its last row is repeated.
    """
    times, before = task.times, run.steps
    count = advance(system, task, run, rows)
    for i in range(count):
        while at.place < len(times) - 1 and rows[i].time > times[at.place]:
            at.place += 1
        found[at.place] = rows[i]
    if count > 0 and run.phase == ENDED:
        last = rows[count - 1]
        for j in range(at.place + (0 if last.time < times[at.place] else 1), len(times)):
            found[j] = last
    if run.phase == ENDED:
        changes[at.scene] = run.changes
        at.scene, at.begun = at.scene + 1, False
    return 1 + run.steps - before


# These are two kernels because a system contains a record, which a compiled function cannot return.
@kernel
@owning
def _quasi_static(
    kinds, shape, scenes, fences, counts, times, rtol, body, room, run, rows, found, changes, at
):
    """Continue a block of scenes without inertia until it ends or many steps are done."""
    done = 0
    while at.scene < len(scenes) and done < STEPS:
        i = at.scene
        row, fence, numbers = (
            scenes[i],
            fences[i, : counts[i]],
            scenes[i, len(scenes[i]) - NUMBERS :],
        )
        effects, friction, films = parts_of(kinds, row)
        own = shape_of(shape, numbers)
        system = QuasiStatic(effects, friction, films, kinds.loads, body, fence, own, room)
        _begin(system, numbers, run, at)
        done += _follow(system, Task(rtol, times[i]), run, rows, found[i], changes, at)


@kernel
@owning
def _inertial(
    kinds, shape, scenes, fences, counts, times, rtol, body, room, run, rows, found, changes, at
):
    """As `_quasi_static`, for scenes with inertia."""
    done = 0
    while at.scene < len(scenes) and done < STEPS:
        i = at.scene
        row, fence, numbers = (
            scenes[i],
            fences[i, : counts[i]],
            scenes[i, len(scenes[i]) - NUMBERS :],
        )
        effects, friction, films = parts_of(kinds, row)
        own = shape_of(shape, numbers)
        system = Inertial(effects, friction, films, kinds.loads, body, fence, own, room)
        _begin(system, numbers, run, at)
        done += _follow(system, Task(rtol, times[i]), run, rows, found[i], changes, at)


#: Position in a block: the scene, the sample, and whether the scene has begun.
PLACE = np.dtype([("scene", "i8"), ("place", "i8"), ("begun", "b1")], align=True)


def run_scenes(
    problem: Problem, scenes: Scenes, times: Array, progress: bool = False
) -> tuple[Any, Any]:
    """Rows of the scenes of a problem at these times, shape (scenes, samples), and their mode changes.

    For a scene that stops early, the last row is repeated for the later times.
    """
    size, scene, shape = len(times), problem.scene, PUSHERS[problem.shape]
    kinds, entries = kinds_of(scene), size_of(scene)
    block, go_on = (
        1 if problem.follows_function else BLOCK,
        _inertial if scene.stores_energy else _quasi_static,
    )
    rows_as = row_type(len(kinds.effects))
    found = records(rows_as, times.size).reshape(times.shape)
    changes, stop = np.zeros(size, np.int64), Event()

    def run(start: int) -> None:
        part = slice(start, min(start + block, size))
        body, state, at = (records(each, 1)[0] for each in (BODY, run_type(entries), PLACE))
        rows, room, fences = records(rows_as, ROWS), new_room(scene), scenes.fences(part)
        while at.scene < part.stop - start and not stop.is_set():
            before = int(at.scene)
            go_on(
                kinds, shape, scenes.rows[part], *fences, times[part].copy(), problem.rtol,
                body, room, state, rows, found[part], changes[part], at,
            )  # fmt: skip
            bar.update(int(at.scene) - before)

    with tqdm(total=size, disable=not progress, unit="scene", leave=False) as bar:
        try:
            run(0)  # compile before the threads start
            in_threads(run, range(block, size, block))
        except BaseException:
            stop.set()
            raise
    return found, changes
