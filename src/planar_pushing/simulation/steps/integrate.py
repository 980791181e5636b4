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

#: Default number of steps of a run.
STEPS = 1000
#: Maximum number of rows returned at once.
BATCH = 256
#: Times that differ by less than this fraction of the elapsed time are treated as equal.
APART = 1e-12


class TimeStepping:
    """One run with steps of equal length between recorded times; iteration yields its rows.

    Parameters
    ----------
    problem : Problem
        Problem to solve; its tolerance is not used.
    times : array_like
        Increasing times within the duration. The rows contain these times and every change of the mode or
        of the number of consistent modes.
    step : float, optional
        Maximum length of a step, > 0, by default 1/1000 of the duration. The error is proportional to it.

    Notes ----- `force` is the mean over the step that ends at the instant or, at a change of mode, starts
    there. The work of the fence equals the change of kinetic energy plus the dissipated energy, to rounding
    error. The numerical dissipation, of the order of the step, is attributed to the contact or, in flight,
    to friction.
    """

    def __init__(self, problem: Problem, times: npt.ArrayLike, step: float | None = None) -> None:
        duration, self.shape = float(problem.duration), problem.shape
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
        """Ends of the steps strictly between two instants."""
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
        """Reason why the run ended early; empty otherwise."""
        return reason(self.run.stopped, self.shape)


def _plan(fence: Any, wanted: Array, size: float) -> Plan:
    """Intervals between recorded times and jumps of the fence, divided into equal steps."""
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
