"""Runs of one or many scenes: one loop calls the kernel of the core until all have ended.

A single run is a batch of one. It logs all events and can be continued after an interrupt; a batch logs the
same times for each of its scenes.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import AbstractContextManager, nullcontext
from threading import Event
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from planar_pushing.core.motion.kinematics.run import LOG_ROW, LogRow, PusherPiece
from planar_pushing.core.motion.kinematics.run import Run as Memory
from planar_pushing.core.motion.kinematics.system import memory_size
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.kernels.arrays import in_threads
from planar_pushing.mechanics.kernels.calls import run_into
from planar_pushing.mechanics.kernels.columns import Columns
from planar_pushing.simulation.early_end import REASONS
from planar_pushing.simulation.fields import Stop, scales_of
from planar_pushing.simulation.inputs import Scenes, numbers_of
from planar_pushing.simulation.problem import Problem
from planar_pushing.terms.errors import InvalidValue, require_positive
from planar_pushing.terms.numbers import Array
from planar_pushing.terms.options import MOST_STEPS, Method

#: Maximum number of rows that a single run writes at once, and number of scenes in a block of a batch.
ROOM, BLOCK = 256, 128
#: Default number of steps of a run by time-stepping.
STEPS = 1000
#: Times that differ by less than this fraction of the elapsed time are treated as equal.
APART = 1e-12
#: Number of equal parts into which the time between two instants is divided to narrow a bracket.
PARTS = 65
KERNELS = {Method.EVENT_DRIVEN: "run_events", Method.TIME_STEPPING: "run_steps"}


class Runs:
    """Runs of scenes that one call of a kernel continues.

    Parameters
    ----------
    scenes : Scenes
    method : Method
    rows : ndarray
        Rows of inputs of some of the scenes.
    part : slice
        Which of the scenes they are.
    room : int
        How many rows of the log each run can write at once.
    """

    def __init__(self, scenes: Scenes, method: Method, rows: Array, part: slice, room: int) -> None:
        resisting, massive = len(scenes.problem.entries), scenes.problem.scene.stores_energy
        self.kernel, self.data, self.rows = KERNELS[method], scenes.data, rows
        self.memory, width = memory_size(resisting, massive), LOG_ROW + resisting
        self.shape = len(rows), room, width
        self.results = np.zeros((len(rows), self.memory + room * width))
        self.scales = scales_of(scenes.radius[part], scenes.force[part], width)[:, None]

    @property
    def has_ended(self) -> npt.NDArray[np.bool_]:
        """Whether each run has ended."""
        ended: npt.NDArray[np.bool_] = np.not_equal(Columns(Memory, self.results).ended, 0.0)
        return ended

    def advance(self) -> None:
        """Continue the runs until their room is full, they have ended, or many steps are done."""
        run_into(self.kernel, self.data, self.rows, self.results)

    def log(self) -> Array:
        """The room for the log in the units of the scenes, shape (runs, room, width)."""
        return self.results[:, self.memory :].reshape(self.shape) * self.scales


class Run:
    """A single run; iteration yields rows of its log in the units of the scene.

    An iteration that is interrupted can be continued by another one.

    Parameters
    ----------
    problem : Problem
        Problem to solve; time-stepping does not use its tolerance.
    times : array_like
        Increasing times within the duration. The rows contain these times, and all events or, with
        time-stepping, every change of the mode or of the number of consistent modes.
    method : Method
    step : float, optional
        Maximum length of a step of time-stepping, > 0, by default 1/1000 of the duration. The error is
        proportional to it.
    room : int
        Maximum number of rows that are yielded at once; at least 2 with time-stepping.

    Notes
    -----
    With time-stepping, `force` is the mean over the step that ends at the instant or, at a change of mode,
    starts there. The work of the fence equals the change of kinetic energy plus the dissipated energy, to
    rounding error. The numerical dissipation, of the order of the step, is attributed to the contact or, in
    flight, to friction.
    """

    def __init__(
        self, problem: Problem, times: npt.ArrayLike, method: Method = Method.EVENT_DRIVEN,
        step: float | None = None, room: int = ROOM,
    ) -> None:  # fmt: skip
        duration = float(problem.duration)
        size = _required_step(step, duration) if method == Method.TIME_STEPPING else 0.0
        data, numbers = numbers_of(problem, method)
        scenes = Scenes.of(problem, data, np.array([[float(number) for number in numbers]]))
        pieces, counts = scenes.pieces(slice(None))
        times = np.asarray(times, float)
        self.plan = plan_of(pieces[0], times, size) if size else times[None]
        rows = scenes.rows(slice(None), pieces, counts, self.plan[None], events=True)
        self.runs, self.problem = Runs(scenes, method, rows, slice(None), room), problem
        self.method, self.stop = method, Stop.NO

    def __iter__(self) -> Iterator[Array]:
        runs = self.runs
        while not runs.has_ended[0]:
            runs.advance()
            count = int(Columns(Memory, runs.results[0]).rows)
            if count:
                rows = runs.log()[0, :count]
                self.stop = Stop(int(Columns(LogRow, rows[-1]).stopped))
                yield rows

    def between(self, low: float, high: float) -> Array:
        """Finer instants strictly between two: the ends of the steps, or a division."""
        if self.method == Method.TIME_STEPPING:
            ends, counts, _ = self.plan
            inner = _ends_of_steps(ends, counts, low, high)
        else:
            inner = np.append(np.linspace(low, high, PARTS + 1), np.nextafter(high, low))
        return np.unique(inner[(inner > low) & (inner < high)])

    @property
    def stopped(self) -> str:
        """Reason why the run ended early; empty otherwise."""
        return _reason(self.stop, self.runs.results[0])


def _reason(stop: Stop, numbers: Array) -> str:
    """Reason why a run with its numbers in memory ended early; empty for one that did not."""
    if stop == Stop.NO:
        return ""
    text, memory = REASONS[stop].text, Columns(Memory, numbers)
    match stop:
        case Stop.SINGULAR:
            return f"{text} {ContactMode(int(memory.mode)).name}"
        case Stop.EVENTS:
            events, at_once = int(memory.events), int(memory.at_once)
            return f"{events} events, {at_once} of them {text}"
    return text


def _required_step(step: float | None, duration: float) -> float:
    """Validate the maximum length of a step of time-stepping."""
    size = require_positive(
        "step", duration / STEPS if step is None else step,
        "give the length of a step in the unit of the duration",
    )  # fmt: skip
    if duration / MOST_STEPS > size:
        raise InvalidValue("step", step, f"at most {MOST_STEPS:g} steps", "take longer steps")
    return size


def plan_of(pieces: Array, times: Array, size: float) -> Array:
    """Intervals between times to log and jumps of the pusher's velocity, divided into equal steps.

    Returns
    -------
    ndarray, shape (3, intervals)
        Ends of the intervals, numbers of steps of at most the given size, and first piece of the span.
    """
    intervals = []
    columns = Columns(PusherPiece, pieces)
    for first in np.unique(columns.first).astype(int):
        last = int(columns.last[first]) - 1
        start, end = columns.start[first], columns.end[last]
        inner = times[(times > start + APART * end) & (times < end - APART * end)]
        ends = np.append(inner, end)
        lengths = np.diff(ends, prepend=start)
        counts = np.maximum(np.ceil(lengths / size * (1 - 1e-9)), 1)
        intervals.append([ends, counts, np.full(len(ends), first)])
    return np.concatenate(intervals, axis=1)


def _ends_of_steps(ends: Array, counts: Array, low: float, high: float) -> Array:
    """Ends of the steps in the intervals that overlap the time from `low` to `high`."""
    starts = np.concatenate([[0.0], ends[:-1]])
    divided = [
        starts[i] + (ends[i] - starts[i]) * (np.arange(1, counts[i] + 1) / counts[i])
        for i in np.flatnonzero((ends > low) & (starts < high))
    ]
    return np.concatenate([*divided, []])


class Ends(NamedTuple):
    """Ends of many runs: their numbers of changes of the mode, and why they ended early.

    Attributes
    ----------
    changes : ndarray of int, shape (scenes,)
    reasons : ndarray of object, shape (scenes,)
        Texts; empty for a run that did not end early.
    """

    changes: npt.NDArray[np.int64]
    reasons: npt.NDArray[np.object_]


def run_scenes(scenes: Scenes, times: Array, progress: bool = False) -> tuple[Array, Ends]:
    """Run many scenes in threads, a block of them at a time.

    Parameters
    ----------
    scenes : Scenes
    times : ndarray, shape (scenes, samples)
        Times to log.
    progress : bool
        Whether to show a progress bar.

    Returns
    -------
    ndarray, shape (scenes, samples, width), and Ends
        Rows in the units of the scenes, and how the runs ended. For a scene that stops early, the last row
        is repeated for the later times.
    """
    count, samples = times.shape
    rows = np.empty((count, samples, LOG_ROW + len(scenes.problem.entries)))
    ends, interrupted = Ends(np.zeros(count, np.int64), np.full(count, "", object)), Event()
    block = 1 if scenes.problem.follows_function else BLOCK

    def run(start: int) -> None:
        part = slice(start, min(start + block, count))
        inputs = scenes.rows(part, *scenes.pieces(part), times[part, None], events=False)
        runs = Runs(scenes, Method.EVENT_DRIVEN, inputs, part, samples)
        finished = 0
        while finished < len(inputs) and not interrupted.is_set():
            runs.advance()
            before, finished = finished, int(runs.has_ended.sum())
            bar.update(finished - before)
        rows[part], ends.changes[part] = runs.log(), Columns(Memory, runs.results).changes
        for i in np.flatnonzero(Columns(LogRow, rows[part, -1]).stopped).tolist():
            stop = Stop(int(Columns(LogRow, rows[start + i, -1]).stopped))
            ends.reasons[start + i] = _reason(stop, runs.results[i])

    with progress_bar(count, "scene", progress) as bar:
        in_threads(run, range(0, count, block), interrupted)
    return rows, ends


class NoBar:
    """A progress bar that is not shown."""

    n = 0

    def update(self, amount: float) -> None:
        """Do nothing."""


def progress_bar(total: float, unit: str, visible: bool) -> AbstractContextManager[Any]:
    """A progress bar, which counts in a unit."""
    if not visible:
        return nullcontext(NoBar())
    from tqdm import tqdm

    bar: AbstractContextManager[Any] = tqdm(total=total, unit=unit, leave=False)
    return bar
