"""Where a guard along the dense output of a step vanishes, or is least."""

from __future__ import annotations

from math import sqrt
from typing import Any, NamedTuple

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.numerics.bracket import RESOLUTION, bracketed
from planar_pushing.mechanics.numerics.root import EQUATIONS
from planar_pushing.simulation.events.explicit import interpolate
from planar_pushing.simulation.events.run import NOW, SIGNS, TRIAL
from planar_pushing.simulation.systems.base import SLACK, Mode, guards

#: Golden section, and the part of a bracket to which the least value is sought.
SECTION, PART = (3.0 - sqrt(5.0)) / 2.0, 1e-5


@compiled
def value_at(system, mode, run, cause, time):
    """A guard at a time of the step, positive before its event."""
    interpolate(run, time, run.vectors[TRIAL])
    found = run.guards[NOW]
    guards(system, mode, time, run.vectors[TRIAL], found)
    return -found[cause] if run.guards[SIGNS, cause] < 0.0 else found[cause]


class Guarded(NamedTuple):
    """A guard over the time of a step."""

    system: Any
    mode: Mode
    run: Any
    cause: int


@compiled
def _guarded(of, time):
    return value_at(of.system, of.mode, of.run, of.cause, time), 0.0


EQUATIONS[Guarded] = _guarded


@compiled
def crossing(system, mode, run, cause, low, high):
    """Time at which a guard vanishes between two times; where it jumps, beyond the jump."""
    equation = Guarded(system, mode, run, cause)
    at_low = value_at(system, mode, run, cause, low)
    if at_low <= 0.0:
        return low
    time = bracketed(equation, low, high, at_low, value_at(system, mode, run, cause, high))
    step = RESOLUTION * time
    while step > 0.0 and time < high and value_at(system, mode, run, cause, time) > SLACK:
        time, step = min(time + step, high), 2.0 * step
    return time


@compiled
def least(system, mode, run, cause, low, high):
    """Time and value of a dip between two times, by golden sections."""
    a, b, width = low, high, high - low
    c, d = a + SECTION * (b - a), b - SECTION * (b - a)
    at_c = value_at(system, mode, run, cause, c)
    at_d = value_at(system, mode, run, cause, d)
    while b - a > PART * width and min(at_c, at_d) >= -SLACK:
        if at_c <= at_d:
            b, d, at_d = d, c, at_c
            c = a + SECTION * (b - a)
            at_c = value_at(system, mode, run, cause, c)
        else:
            a, c, at_c = c, d, at_d
            d = b - SECTION * (b - a)
            at_d = value_at(system, mode, run, cause, d)
    return (c, at_c) if at_c <= at_d else (d, at_d)
