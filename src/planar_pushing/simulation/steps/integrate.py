"""The time-stepping integration of one problem."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.compiled import announced
from planar_pushing.simulation.problem import Problem
from planar_pushing.simulation.rows import NO_MODE, ROW, in_units, reason, records
from planar_pushing.simulation.steps import friction, inertia
from planar_pushing.simulation.steps.driver import CLOCK, Plan, advance, ended
from planar_pushing.simulation.steps.trials import INCREMENTS
from planar_pushing.simulation.systems import base, setup
from planar_pushing.terms.errors import InvalidValue, require_positive
from planar_pushing.terms.options import MOST_STEPS

INCREMENTS.update({base.QuasiStatic: friction, base.Inertial: inertia})
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
        row = setup.row_of(problem.scene, problem.twist, problem.gap)
        self.system = setup.system_of(problem, row, fence)
        wanted = sorted({*map(float, np.asarray(times)), 0.0, duration})
        self.plan = _plan(fence, wanted, size)
        self.run = records(CLOCK, 1)[0]
        self.run.kind, self.run.fence[1] = NO_MODE, -row[setup.GAP]
        self.run.twist[:] = row[setup.V_X : setup.GAP]
        base.initial(self.system, row[setup.ANGLE], row[setup.GAP], self.run.twist, self.run.state)

    def __iter__(self) -> Iterator[Any]:
        while not ended(self.plan, self.run):
            rows = records(ROW, BATCH)
            with announced(advance):
                count = advance(self.system, self.plan, self.run, rows)
            if count:
                yield in_units(rows[:count], self.radius)

    @property
    def stopped(self) -> str:
        """Why the run ended before its time; empty otherwise."""
        return reason(self.run.stopped)


def _plan(fence: Any, wanted: list[float], size: float) -> Plan:
    """Intervals between the times wanted and the jumps of the fence, cut into equal steps."""
    ends, counts, pieces = [], [], []
    for piece in np.unique(fence["first"]):
        start, end = fence["start"][piece], fence["end"][fence["last"][piece] - 1]
        for mark in _marks(start, end, wanted):
            ends.append(mark)
            counts.append(max(1, math.ceil((mark - start) / size * (1 - 1e-9))))
            pieces.append(piece)
            start = mark
    return Plan(np.array(ends), np.array(counts, np.int64), np.array(pieces, np.int64))


def _marks(start: float, end: float, wanted: list[float]) -> list[float]:
    """Times wanted between the ends of a span, and its end, without those that rounding doubles."""
    least = APART * end
    marks = [start]
    for time in wanted:
        if marks[-1] + least < time < end - least:
            marks.append(time)
    return [*marks[1:], float(end)]
