"""The time-stepping integration of one problem."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.plane import Array
from planar_pushing.simulation.problem import Problem
from planar_pushing.simulation.rows import NO_MODE, in_units, reason, records, row_type
from planar_pushing.simulation.steps.clock import clock_type
from planar_pushing.simulation.steps.driver import Plan, advance, ended
from planar_pushing.simulation.systems import setup
from planar_pushing.terms.errors import InvalidValue, require_positive
from planar_pushing.terms.options import MOST_STEPS

#: Steps of a run whose step is not given.
STEPS = 1000
#: Rows handed on at once.
BATCH = 256
#: Times closer than this part of the time that has passed are one time.
APART = 1e-12


class TimeStepping:
    """One run by steps of equal length between the times to be recorded; iterating hands on its rows.

    Parameters
    ----------
    problem : Problem
        Its tolerance has no part in this method.
    times : array_like
        Increasing, within the duration. The rows hold these and every change of mode or of their number.
    step : float, optional
        Greatest length of a step, > 0; a thousandth of the duration by default. The error is
        proportional to it.

    Notes
    -----
    `force` is the mean over the step that ends or, at a change of mode, starts there. The work of
    the fence equals the change of kinetic energy plus what is dissipated, to rounding; the scheme's
    own loss, of the order of the step, counts as the contact's, or as friction's in flight.
    """

    def __init__(self, problem: Problem, times: npt.ArrayLike, step: float | None = None) -> None:
        duration = float(problem.duration)
        size = require_positive(
            "step", duration / STEPS if step is None else step,
            "give the length of a step in the unit of the duration",
        )  # fmt: skip
        if duration / MOST_STEPS > size:
            raise InvalidValue("step", step, f"at most {MOST_STEPS:g} steps", "take longer steps")
        self.radius = float(problem.scene.slider.radius)
        fence = problem.fence(duration, self.radius)
        row = setup.row_of(problem)
        self.system = setup.system_of(problem, row, fence)
        self.plan = _plan(fence, np.asarray(times, float), size)
        entries, self.effects = setup.size_of(problem.scene), len(self.system.effects)
        self.run = records(clock_type(entries), 1)[0]
        numbers = row[-setup.NUMBERS :]
        self.run.kind, self.run.fence[1] = NO_MODE, -numbers[setup.GAP]
        self.run.twist[:] = numbers[setup.V_X : setup.GAP]
        setup.put(self.system, numbers, self.run.state)

    def __iter__(self) -> Iterator[Any]:
        while not ended(self.plan, self.run):
            rows = records(row_type(self.effects), BATCH)
            count = advance(self.system, self.plan, self.run, rows)
            if count:
                yield in_units(rows[:count], self.radius)

    def between(self, low: float, high: float) -> Array:
        """The ends of the steps strictly between two instants."""
        ends, counts = self.plan.ends, self.plan.counts
        starts = np.concatenate([[0.0], ends[:-1]])
        met = np.flatnonzero((ends > low) & (starts < high))
        found = [
            starts[i] + (ends[i] - starts[i]) * (np.arange(1, counts[i] + 1) / counts[i])
            for i in met
        ]
        steps = np.concatenate([*found, []])
        return steps[(steps > low) & (steps < high)]

    @property
    def stopped(self) -> str:
        """Why the run ended before its time; empty otherwise."""
        return reason(self.run.stopped)


def _plan(fence: Any, wanted: Array, size: float) -> Plan:
    """Intervals between the times wanted and the jumps of the fence, cut into equal steps."""
    ends, counts, pieces = [], [], []
    for piece in np.unique(fence["first"]):
        start, end = fence["start"][piece], fence["end"][fence["last"][piece] - 1]
        within = wanted[(wanted > start + APART * end) & (wanted < end - APART * end)]
        marks = np.append(within, end)
        lengths = np.diff(marks, prepend=start)
        ends.append(marks)
        counts.append(np.maximum(np.ceil(lengths / size * (1 - 1e-9)), 1).astype(np.int64))
        pieces.append(np.full(len(marks), piece))
    return Plan(*map(np.concatenate, (ends, counts, pieces)))
