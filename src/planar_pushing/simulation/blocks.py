"""Many scenes at once: a loop of the event-driven integrator over rows of numbers, mapped by threads."""

from __future__ import annotations

from typing import Any

import numpy as np
from tqdm import tqdm

from planar_pushing.mechanics.compiled import inlined, kernel, owning
from planar_pushing.mechanics.effects.base import made
from planar_pushing.mechanics.numerics.arrays import in_threads
from planar_pushing.mechanics.plane import Array
from planar_pushing.simulation.events.driver import ENDED, advance, begin
from planar_pushing.simulation.events.run import RUNS, STATE, Task
from planar_pushing.simulation.parameters import Scenes
from planar_pushing.simulation.problem import Problem
from planar_pushing.simulation.rows import ROW, records
from planar_pushing.simulation.systems.base import BODY, Inertial, QuasiStatic
from planar_pushing.simulation.systems.setup import PUSHERS, fill, put, shape_of

#: Scenes of a block: some milliseconds of work, so that Ctrl-C is heard.
BLOCK = 128
#: Rows that the integrator hands on at once.
ROWS = 64


@inlined
def _follow(system, row, task, run, rows, found):
    """Run one scene; `found` takes its row at each of the task's times, the last one where it ends before.

    Returns the number of changes of mode.
    """
    times, place = task.times, 0
    fill(row, system.fence, system.body)
    put(system, row, run.vectors[STATE])
    begin(system, run)
    while run.phase != ENDED:
        count = advance(system, task, run, rows)
        for i in range(count):
            while place < len(times) - 1 and rows[i].time > times[place]:
                place += 1
            found[place] = rows[i]
        if count > 0 and run.phase == ENDED:
            last = rows[count - 1]
            for j in range(place + (0 if last.time < times[place] else 1), len(times)):
                found[j] = last
    return run.changes


# Two kernels and no layer above them: the compiler optimises each layer with all that it calls.
@kernel
@owning
def _quasi_static(
    kinds, shape, scenes, fences, counts, times, rtol, body, run, rows, found, changes
):
    """Run a block of scenes whose effects are all friction."""
    for i in range(len(scenes)):
        row, fence, task = scenes[i], fences[i, : counts[i]], Task(rtol, times[i])
        system = QuasiStatic(made(kinds, row), body, fence, shape_of(shape, row))
        changes[i] = _follow(system, row, task, run, rows, found[i])


@kernel
@owning
def _inertial(kinds, shape, scenes, fences, counts, times, rtol, body, run, rows, found, changes):
    """Run a block of scenes with inertia."""
    for i in range(len(scenes)):
        row, fence, task = scenes[i], fences[i, : counts[i]], Task(rtol, times[i])
        system = Inertial(made(kinds, row), body, fence, shape_of(shape, row))
        changes[i] = _follow(system, row, task, run, rows, found[i])


def run_scenes(
    problem: Problem, scenes: Scenes, times: Array, progress: bool = False
) -> tuple[Any, Any]:
    """Rows of the scenes of a problem at these times, shape (scenes, samples), and their mode changes.

    The last row of a scene that stops before stands for the times after.
    """
    size, kinds, shape = len(times), problem.scene.kinds, PUSHERS[problem.shape]
    block = 1 if problem.follows_function else BLOCK
    moves = problem.scene.stores_energy
    kernel = _inertial if moves else _quasi_static
    found = records(ROW, times.size).reshape(times.shape)
    changes = np.zeros(size, np.int64)

    def run(start: int) -> None:
        part = slice(start, min(start + block, size))
        body, state, rows = records(BODY, 1)[0], records(RUNS[moves], 1)[0], records(ROW, ROWS)
        kernel(
            kinds, shape, scenes.rows[part], *scenes.fences(part), times[part].copy(), problem.rtol,
            body, state, rows, found[part], changes[part],
        )  # fmt: skip
        bar.update(part.stop - start)

    with tqdm(total=size, disable=not progress, unit="scene", leave=False) as bar:
        run(0)  # which compiles where it must, before the threads do
        in_threads(run, range(block, size, block))
    return found, changes
