"""Many scenes at once: a loop of the event-driven integrator over rows of numbers, mapped by threads."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.compiled import announced, compiled, generic
from planar_pushing.mechanics.effects.base import made
from planar_pushing.mechanics.effects.inertia import Mass
from planar_pushing.mechanics.numerics.arrays import in_threads
from planar_pushing.mechanics.plane import Array
from planar_pushing.simulation.events.driver import ENDED, advance, begin
from planar_pushing.simulation.events.run import RUNS, STATE, Task
from planar_pushing.simulation.fence import MEAN, PIECE, VELOCITY
from planar_pushing.simulation.rows import ROW, records
from planar_pushing.simulation.systems.base import BODY, Inertial, QuasiStatic
from planar_pushing.simulation.systems.setup import fill, put

#: Scenes of a block: some milliseconds of work, so that Ctrl-C is heard.
BLOCK = 128
#: Rows that the integrator hands on at once.
ROWS = 64


class Desk(NamedTuple):
    """What a loop over scenes works on, one after the other."""

    fence: Any
    body: Any
    run: Any
    rows: Any


@compiled
def _constant_pieces(motion, duration, fence):
    """Write down a piecewise constant motion, rows of start time and velocity; its number of pieces."""
    count, x, y = 0, 0.0, 0.0
    for i in range(len(motion)):
        start, v_x, v_y = motion[i, 0], motion[i, 1], motion[i, 2]
        if start < duration:
            end = min(motion[i + 1, 0], duration) if i + 1 < len(motion) else duration
            piece = fence[i]
            piece.start, piece.end, piece.degree = start, end, 0
            piece.first, piece.last, count = i, i + 1, i + 1
            piece.origin[0], piece.origin[1] = x, y
            piece.series[VELOCITY, 0], piece.series[VELOCITY + 1, 0] = v_x, v_y
            piece.series[MEAN, 0], piece.series[MEAN + 1, 0] = v_x, v_y
            x, y = x + (end - start) * v_x, y + (end - start) * v_y
    return count


@compiled
def _follow(system, row, task, run, rows, found):
    """Run one scene; `found` takes its row at each of the task's times, the last one where it ends before.

    Returns the number of changes of mode.
    """
    times, place = task.times, 0
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


@generic
def _simulated(kinds: Any) -> Callable[..., Any]:
    """Run the scene of a row: kinds, row, fence, body, task, run, rows, found."""
    return _with_inertia if Mass in kinds else _quasi_static


@compiled
def _quasi_static(kinds, row, fence, body, task, run, rows, found):
    fill(row, fence, body)
    return _follow(QuasiStatic(made(kinds, row), body, fence), row, task, run, rows, found)


@compiled
def _with_inertia(kinds, row, fence, body, task, run, rows, found):
    fill(row, fence, body)
    return _follow(Inertial(made(kinds, row), body, fence), row, task, run, rows, found)


@compiled
def _block(kinds, scenes, motions, times, rtol, policy, fence, body, run, rows, found, changes):
    """Run a block of scenes; without motions the fence is that of all of them."""
    for i in range(len(scenes)):
        count = len(fence)
        if motions.shape[1] > 0:
            count = _constant_pieces(motions[i], times[i, times.shape[1] - 1], fence)
        task = Task(rtol, policy, times[i])
        changes[i] = _simulated(kinds, scenes[i], fence[:count], body, task, run, rows, found[i])


def run_scenes(
    kinds: Any, scenes: Array, motions: Any, times: Array, rtol: float, policy: int
) -> tuple[Any, Any]:
    """Run many scenes.

    Parameters
    ----------
    kinds : tuple
        Of effects, as `Scene.kinds`.
    scenes : ndarray, shape (scenes, columns)
        Rows as `systems.setup` has them.
    motions : ndarray, shape (scenes, pieces, 3), or function of a scene's number
        Start times and constant velocities of the fence; or the scene's fence itself. In radii.
    times : ndarray, shape (scenes, samples)
        Up to the duration.
    rtol : float
    policy : int

    Returns
    -------
    rows : array of ROW, shape (scenes, samples)
        The last one of a scene that stops before stands for the times after.
    changes : ndarray of int, shape (scenes,)
        Changes of mode.
    """
    size = len(scenes)
    found = records(ROW, times.size).reshape(times.shape)
    changes = np.zeros(size, np.int64)
    block = 1 if callable(motions) else BLOCK

    def run(start: int) -> None:
        part = slice(start, min(start + block, size))
        given = np.zeros((1, 0, 3)) if callable(motions) else motions[part]
        fence = motions(start) if callable(motions) else records(PIECE, motions.shape[1])
        desk = Desk(
            fence, records(BODY, 1)[0], records(RUNS[_moves(kinds)], 1)[0], records(ROW, ROWS)
        )
        _block(
            kinds, scenes[part], given, times[part], rtol, policy, *desk, found[part], changes[part]
        )

    with announced(_block):
        run(0)
    in_threads(run, range(block, size, block))
    return found, changes


def _moves(kinds: Any) -> bool:
    return any(isinstance(kind, Mass) for kind in kinds)
