"""The event-driven integration of one problem."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.plane import Array
from planar_pushing.simulation.events.driver import ENDED, advance, begin
from planar_pushing.simulation.events.run import STATE, Task, run_type
from planar_pushing.simulation.problem import Problem
from planar_pushing.simulation.rows import Stop, in_units, reason, records, row_type
from planar_pushing.simulation.systems.setup import NUMBERS, put, row_of, size_of, system_of

#: Maximum number of rows returned at once.
BATCH = 256
#: Number of equal parts into which the time between two instants is divided to narrow a bracket.
PARTS = 65


class EventDriven:
    """One run; iteration yields its rows and resumes after an interrupt.

    Parameters
    ----------
    problem : Problem
    times : array_like
        Increasing times within the duration; the rows contain these times and all events.
    """

    def __init__(self, problem: Problem, times: npt.ArrayLike) -> None:
        scene, self.shape = problem.scene, problem.shape
        self.radius = float(scene.slider.radius)
        fence = problem.fence(float(problem.duration), self.radius)
        row = row_of(problem)
        self.system = system_of(problem, row, fence)
        self.task = Task(problem.rtol, np.asarray(times, float))
        self.run, self.effects = records(run_type(size_of(scene)), 1)[0], len(self.system.effects)
        put(self.system, row[-NUMBERS:], self.run.vectors[STATE])
        begin(self.system, self.run)

    def __iter__(self) -> Iterator[Any]:
        while self.run.phase != ENDED:
            rows = records(row_type(self.effects), BATCH)
            count = advance(self.system, self.task, self.run, rows)
            if count:
                yield in_units(rows[:count], self.radius)

    @staticmethod
    def between(low: float, high: float) -> Array:
        """Finer instants strictly between two, including the last double before the end."""
        inner = np.append(np.linspace(low, high, PARTS + 1), np.nextafter(high, low))
        return np.unique(inner[(inner > low) & (inner < high)])

    @property
    def stopped(self) -> str:
        """Reason why the run ended early; empty otherwise."""
        run, text = self.run, reason(self.run.stopped, self.shape)
        match Stop(run.stopped):
            case Stop.SINGULAR:
                return f"{text} {ContactMode(run.kind).name}"
            case Stop.EVENTS:
                return f"{run.events} events, {run.at_once} of them {text}"
        return text
