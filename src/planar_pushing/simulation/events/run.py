"""One run of the event-driven integrator: its task and its current state."""

from __future__ import annotations

from functools import cache
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.plane import Array
from planar_pushing.simulation.events.tableau import STAGES
from planar_pushing.simulation.fence import span
from planar_pushing.simulation.legacy.compiled import compiled
from planar_pushing.simulation.legacy.record import MOST
from planar_pushing.simulation.systems import base

#: Fractions of a step at which the guards are evaluated if it may contain an event.
NODES = (0.25, 0.5, 0.75, 1.0)


class Task(NamedTuple):
    """Task of a run: a relative tolerance, and the times of the samples."""

    rtol: float
    times: Array


#: Vectors of a run, each with the entries of the state: the state, the state at the end of the step, two
#: work vectors, typical magnitudes, rates at the start and at the end of a step, changes in its stages, and
#: coefficients of the dense output.
STATE, REACHED, TRIAL, PASSING, SCALES, FIRST, LAST, SLOPES = range(8)
DENSE = SLOPES + STAGES
VECTORS = DENSE + 7
#: Guards of a run by cause: their signs, zero until a guard has been nonzero; their values at the start of
#: the step, at its nodes, at its end and near its middle; and two work sets.
SIGNS, VALUES = range(2)
END = VALUES + len(NODES)
ABOUT, NOW, LATER = range(END + 1, END + 4)


@cache
def run_type(entries: int) -> np.dtype[Any]:
    """Data type of a run with the given number of state entries.

    `phase` is that of `driver`. `time` is the time of the state, `until` the end of the current step,
    `event` the time of an event in it, and `cause` its cause. `before` is the time when the mode was
    chosen. `planned` is the size of the next step, and `prepared` says whether the dense output of this
    step is known. `pivot` is a time at which the motion is not smooth; `side` is 1 after it, -1 before it,
    and 0 if there is none. `chosen` is the index of the chosen one of the `count` candidate modes, -1 if
    none is consistent.
    """
    return np.dtype(
        [
            ("time", "f8"), ("until", "f8"), ("event", "f8"), ("before", "f8"), ("planned", "f8"),
            ("last_size", "f8"), ("last_error", "f8"), ("pivot", "f8"), ("side", "f8"),
            ("checked", "f8"),
            ("phase", "i8"), ("span", "i8"), ("chosen", "i8"), ("count", "i8"), ("kind", "i8"),
            ("solutions", "i8"), ("sample", "i8"), ("cause", "i8"), ("stopped", "i8"),
            ("events", "i8"), ("at_once", "i8"), ("changes", "i8"), ("steps", "i8"),
            ("fresh", "b1"), ("prepared", "b1"),
            ("vectors", "f8", (VECTORS, entries)), ("guards", "f8", (LATER + 1, base.CAUSES)),
            ("kinds", "i8", (MOST,)), ("feet", "i8", (MOST,)), ("hinged", "i8", (MOST,)),
            ("starts", "f8", (MOST, 3)),
        ],
        align=True,
    )  # fmt: skip


@compiled
def candidate(system, run, index):
    """Candidate mode of this index, or the mode without a contact force for a negative index."""
    during = span(system.fence, min(run.span, len(system.fence) - 1))
    if index < 0:
        return base.Mode(0, -1, False, 0.0, 0.0, 0.0, during)
    start, foot = run.starts[index], run.feet[index]
    hinged = run.hinged[index] != 0
    return base.Mode(run.kinds[index], foot, hinged, start[0], start[1], start[2], during)
