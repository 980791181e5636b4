"""One run of the event-driven integrator: what it is asked for, and where it is."""

from __future__ import annotations

from functools import cache
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.modes import MOST
from planar_pushing.mechanics.plane import Array
from planar_pushing.simulation.events.tableau import STAGES
from planar_pushing.simulation.fence import span
from planar_pushing.simulation.systems import base

#: Parts of a step at which the guards are evaluated where an event may lie in it.
NODES = (0.25, 0.5, 0.75, 1.0)


class Task(NamedTuple):
    """The task of a run: a relative tolerance, and samples at these times."""

    rtol: float
    times: Array


#: Vectors of a run, each with the entries of the state: the state, that at the end of the step, two on
#: which functions work, typical sizes; rates at the start and at the end of a step; changes in its stages,
#: and coefficients of the dense output.
STATE, REACHED, TRIAL, PASSING, SCALES, FIRST, LAST, SLOPES = range(8)
DENSE = SLOPES + STAGES
VECTORS = DENSE + 7
#: Guards of a run by cause: their signs, zero until a guard was away from zero; values at the start of the
#: step and at its nodes, about its middle, and two sets on which functions work.
SIGNS, VALUES = range(2)
END = VALUES + len(NODES)
ABOUT, NOW, LATER = range(END + 1, END + 4)


@cache
def run_type(entries: int) -> np.dtype[Any]:
    """A run whose state has so many entries.

    `phase` of `driver`; `time` of the state, `until` at the end of the step that is examined, and `event`
    in it, with its `cause`; `before` when the mode was chosen; `planned` size of the next step, `prepared`
    where the dense output of this one is known; `pivot` is a time at which the motion is not smooth, and
    `side` 1 behind it, -1 before it and 0 where there is none. `chosen` of the `count` modes that might be,
    -1 where none is consistent.
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
    """One of the modes that might be, or the state without a contact force where there is none."""
    during = span(system.fence, min(run.span, len(system.fence) - 1))
    if index < 0:
        return base.Mode(0, -1, False, 0.0, 0.0, 0.0, during)
    start, foot = run.starts[index], run.feet[index]
    hinged = run.hinged[index] != 0
    return base.Mode(run.kinds[index], foot, hinged, start[0], start[1], start[2], during)
