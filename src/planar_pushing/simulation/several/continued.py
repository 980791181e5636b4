"""Runs of a finger that go on, with several contacts, where it touches the object at two places."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import numpy.typing as npt

from planar_pushing.core.motion.kinematics.run import LogRow
from planar_pushing.mechanics.kernels.columns import Columns
from planar_pushing.simulation.fields import Stop
from planar_pushing.simulation.problem import Problem
from planar_pushing.simulation.runs import Run
from planar_pushing.simulation.several.events import EventRun
from planar_pushing.simulation.several.rows import SeveralRows
from planar_pushing.terms.numbers import Array
from planar_pushing.terms.options import Method

TIME = LogRow.places["time"]


class ContinuedRun:
    """A run like `Run`, with the same parameters, that goes on where the finger touches two places.

    Attributes
    ----------
    first, rest : Run, SeveralRows
        The run until then, and from then on, if there is one.
    later_changes : int
        Number of changes of the mode from then on.
    """

    def __init__(
        self,
        problem: Problem,
        times: npt.ArrayLike,
        method: Method = Method.EVENT_DRIVEN,
        step: float | None = None,
    ) -> None:
        self.problem, self.method, self.step = problem, method, step
        self.times = np.asarray(times, float)
        self.first = Run(problem, self.times, method=method, step=step)
        self.rest: SeveralRows | None = None
        self.later_changes = 0

    def __iter__(self) -> Iterator[Array]:
        for rows in self.first:
            meets = self.first.stop == Stop.TWO_CONTACTS
            before = rows[:-1] if meets else rows
            if len(before):
                yield before
            if meets:
                yield self._go_on(rows[-1])

    @property
    def stopped(self) -> str:
        """Reason why the run ended early; empty otherwise."""
        return self.first.stopped if self.rest is None else self.rest.stopped

    def between(self, low: float, high: float) -> Array:
        """Finer instants strictly between two, as of `Run`: the steps go on as they were planned."""
        return self.first.between(low, high)

    def _go_on(self, last: Array) -> Array:
        """The rows from the instant on at which the finger meets the second place."""
        steps = self.method == Method.TIME_STEPPING
        start = self._before(last) if steps else last
        times = [start[TIME], *self.times[self.times > start[TIME]]]
        self.rest = SeveralRows(self.problem, (), times, self.method, self.step, start=start)
        if isinstance(self.rest.run, EventRun):
            self.rest.run.close_contacts()
        else:
            self.rest.run.close_contacts(float(last[TIME]))
        (rows,) = self.rest
        modes = Columns(LogRow, np.stack([last, *rows])).mode
        self.later_changes = int(np.count_nonzero(np.diff(modes)))
        if start is last:
            Columns(LogRow, rows).event[0] = Columns(LogRow, last).event
        # In steps, the first row is that of the run until then, unless it is the end.
        return rows if start is last or len(rows) == 1 else rows[1:]

    def _before(self, last: Array) -> Array:
        """The row of the end of the step before that in which the finger meets the second place."""
        ends = self.first.between(0.0, float(last[TIME]))
        times = np.union1d(self.times, ends[-1:])
        run = Run(self.problem, times, method=self.method, step=self.step)
        rows = np.concatenate(list(run))
        earlier = rows[:-1][rows[:-1, TIME] < last[TIME]]
        return np.asarray(earlier[-1] if len(earlier) else last)
