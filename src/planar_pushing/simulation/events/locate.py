"""Where a guard along the dense output of a step vanishes, or is least."""

from __future__ import annotations

from math import sqrt

from planar_pushing.mechanics.compiled import compiled, inlined
from planar_pushing.simulation.events.explicit import interpolate
from planar_pushing.simulation.events.run import NOW, SIGNS, TRIAL
from planar_pushing.simulation.systems.base import SLACK, guards

#: Relative resolution of times, some units in the last place.
RESOLUTION = 1e-15
#: More than bisection needs.
ITERATIONS = 500
#: Golden section, and the part of a bracket to which the least value is sought.
SECTION, PART = (3.0 - sqrt(5.0)) / 2.0, 1e-5


@compiled
def value_at(system, mode, run, cause, time):
    """A guard at a time of the step, positive before its event."""
    interpolate(run, time, run.vectors[TRIAL])
    found = run.guards[NOW]
    guards(system, mode, time, run.vectors[TRIAL], found)
    return -found[cause] if run.guards[SIGNS, cause] < 0.0 else found[cause]


@compiled
def crossing(system, mode, run, cause, low, high):
    """Time at which a guard vanishes between two times; where it jumps, beyond the jump.

    Chandrupatla's method: inverse quadratic interpolation where it is safe, bisection elsewhere.
    """
    a, b = high, low
    at_a = value_at(system, mode, run, cause, a)
    at_b = value_at(system, mode, run, cause, b)
    if at_b <= 0.0:
        return low
    c, at_c, part = a, at_a, 0.5
    for _ in range(ITERATIONS):
        time = a + part * (b - a)
        value = value_at(system, mode, run, cause, time)
        if (value > 0.0) == (at_a > 0.0):
            c, at_c = a, at_a
        else:
            c, b, at_c, at_b = b, a, at_b, at_a
        a, at_a = time, value
        best, least = (a, at_a) if abs(at_a) < abs(at_b) else (b, at_b)
        limit = RESOLUTION * abs(best) / abs(b - a) if b != a else 1.0
        if least == 0.0 or limit >= 0.5:
            return _beyond(system, mode, run, cause, best, high)
        part = _interpolated(a, b, c, at_a, at_b, at_c)
        part = min(max(part, limit), 1.0 - limit)
    return _beyond(system, mode, run, cause, a, high)


@inlined
def _interpolated(a, b, c, at_a, at_b, at_c):
    """Part of the bracket from a to b in which the root lies by inverse quadratic interpolation."""
    if c == b or at_c == at_a or at_c == at_b:
        return 0.5
    xi, phi = (a - b) / (c - b), (at_a - at_b) / (at_c - at_b)
    if phi * phi >= xi or (1.0 - phi) * (1.0 - phi) >= 1.0 - xi:
        return 0.5
    return at_a / (at_b - at_a) * at_c / (at_b - at_c) + (c - a) / (b - a) * at_a / (
        at_c - at_a
    ) * at_b / (at_c - at_b)


@inlined
def _beyond(system, mode, run, cause, time, high):
    """The first time from which on a guard is not positive: where it jumps, on the far side."""
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
