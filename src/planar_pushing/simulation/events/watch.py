"""Where a mode ends: its guards followed along the dense output of each step."""

from __future__ import annotations

from math import inf

from planar_pushing.mechanics.compiled import compiled, inlined
from planar_pushing.simulation.events.explicit import interpolate
from planar_pushing.simulation.events.locate import crossing, least, value_at
from planar_pushing.simulation.events.run import (
    NODE,
    NODES,
    NOW,
    REACHED,
    SIGNS,
    STATE,
    TRIAL,
    VALUES,
)
from planar_pushing.simulation.systems.base import CAUSES, SLACK, WATCHES, guards

#: Halvings that look for the moment in which a margin that starts at zero is positive.
HALVINGS = 20
#: What a step holds, besides the cause of an event.
NOTHING, MISJUDGED = -1, -2


@inlined
def start_watch(system, mode, run):
    """Look at the guards at the start of a mode."""
    guards(system, mode, run.time, run.vectors[STATE], run.guards[VALUES])
    for cause in range(CAUSES):
        run.guards[SIGNS, cause] = _sign(cause, run.guards[VALUES, cause])


@compiled
def _sign(cause, value):
    """Sign of a watch that is away from zero; of a margin 1 where it is positive; 0 until then."""
    if value > SLACK:
        return 1.0
    return -1.0 if WATCHES[cause] and value < -SLACK else 0.0


@inlined
def first_event(system, mode, run):
    """Write down the first event of a step; its cause, `NOTHING`, or `MISJUDGED`.

    A mode is misjudged where a margin is negative from its start on.
    """
    nodes = run.guards[NODE:NOW]
    last = len(NODES) - 1
    for j in range(last):
        time = run.time + NODES[j] * (run.until - run.time)
        interpolate(run, time, run.vectors[TRIAL])
        guards(system, mode, time, run.vectors[TRIAL], nodes[j])
    guards(system, mode, run.until, run.vectors[REACHED], nodes[last])
    first, found = inf, NOTHING
    for cause in range(CAUSES):
        if run.guards[VALUES, cause] == run.guards[VALUES, cause]:  # it is guarded
            time = _event(system, mode, run, cause)
            if time < 0.0:
                return MISJUDGED
            if time < first:
                first, found = time, cause
            run.guards[VALUES, cause] = nodes[last, cause]
    run.event = first
    return found


@inlined
def _node(run, j):
    """Time of a node, where 0 is the start of the step."""
    if j == len(NODES):
        return run.until
    return run.time + (NODES[j - 1] * (run.until - run.time) if j else 0.0)


@compiled
def _event(system, mode, run, cause):
    """Time of the first event of one cause in a step, infinite where there is none, -1 where misjudged."""
    for j in range(1, len(NODES) + 1):
        value = run.guards[NODE + j - 1, cause]
        if run.guards[SIGNS, cause] == 0.0:
            run.guards[SIGNS, cause] = _sign(cause, value)
            if value < -SLACK and not WATCHES[cause]:
                rise = _rise(system, mode, run, cause, _node(run, j - 1), _node(run, j))
                if rise < 0.0:
                    return rise
                return crossing(system, mode, run, cause, rise, _node(run, j))
        elif run.guards[SIGNS, cause] * value < -SLACK:
            return crossing(system, mode, run, cause, _node(run, j - 1), _node(run, j))
    return inf if WATCHES[cause] else _dip(system, mode, run, cause)


@inlined
def _rise(system, mode, run, cause, start, end):
    """A moment after `start` in which a margin that began at zero is positive, -1 where there is none."""
    part = 1.0
    for _ in range(1, HALVINGS):
        part /= 2.0
        time = start + (end - start) * part
        if value_at(system, mode, run, cause, time) > SLACK:
            run.guards[SIGNS, cause] = 1.0
            return time
    return -1.0


@inlined
def _dip(system, mode, run, cause):
    """Time at which a margin vanishes between nodes at which it is positive, infinite where it does not."""
    a, b = run.guards[VALUES, cause], run.guards[NODE, cause]
    for j in range(1, len(NODES)):
        c = run.guards[NODE + j, cause]
        bend = a - 2.0 * b + c
        if min(a, b, c) > 0.0 and b <= min(a, c) and bend > 0.0:
            low, high = _node(run, j - 1), _node(run, j + 1)
            time, value = low, b
            # The parabola through the three falls below a fifth of the middle one.
            if b - (c - a) * (c - a) / (8.0 * bend) < 0.2 * b:
                time, value = least(system, mode, run, cause, low, high)
            if value < -SLACK:
                return crossing(system, mode, run, cause, low, time)
        a, b = b, c
    return inf
