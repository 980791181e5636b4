"""Event location: the guards of a mode are followed along the dense output of each step."""

from __future__ import annotations

from math import inf
from typing import Any, NamedTuple

from planar_pushing.simulation.copying import copy
from planar_pushing.simulation.events import run as at
from planar_pushing.simulation.events.explicit import PART, interpolate
from planar_pushing.simulation.legacy.compiled import compiled, inlined
from planar_pushing.simulation.legacy.root import RESOLUTION, dip, root
from planar_pushing.simulation.systems import base, equations

#: Maximum number of halvings in the search for a time at which a margin that starts at zero is positive.
HALVINGS = 20
#: A margin may vanish between the nodes if its parabola falls below this fraction of the smallest value.
DIP = 0.2
#: Accuracy of a pivot time as a fraction of the step, and its distance after the kink, so that the step to
#: it contains the kink as an event. The nonsmooth remainder changes the motion by less than 1e-12.
BEHIND = 1e-5
#: Results of the search of a step other than the cause of an event.
NOTHING, MISJUDGED = -1, -2


class Guarded(NamedTuple):
    """A guard as a function of the time within a step."""

    system: Any
    mode: base.Mode
    run: Any
    cause: int


@compiled
def _value(of, time):
    """Value of a guard at a time of the step, positive before its event."""
    run, trial, found = of.run, of.run.vectors[at.TRIAL], of.run.guards[at.NOW]
    interpolate(of.system, of.mode, run, time, trial)
    equations.guards(of.system, of.mode, time, trial, found)
    return -found[of.cause] if run.guards[at.SIGNS, of.cause] < 0.0 else found[of.cause]


@inlined
def start_watch(system, mode, run):
    """Evaluate the guards at the start of a mode."""
    equations.guards(system, mode, run.time, run.vectors[at.STATE], run.guards[at.VALUES])
    for cause in range(base.CAUSES):
        run.guards[at.SIGNS, cause] = _sign(cause, run.guards[at.VALUES, cause])


@compiled
def _sign(cause, value):
    """Sign of a watch that is not near zero; for a margin, 1 if it is positive; 0 otherwise."""
    if value > base.SLACK:
        return 1.0
    return -1.0 if base.WATCHES[cause] and value < -base.SLACK else 0.0


@inlined
def first_event(system, mode, run):
    """Store the first event of a step; return its cause, `NOTHING`, or `MISJUDGED`.

    A mode is misjudged if a margin is negative from its start.
    """
    run.event, found = run.until, NOTHING
    if _may_end(run):
        found = _search(system, mode, run)
    copy(run.guards[at.VALUES], run.guards[at.END])
    return found


@inlined
def look_for_pivot(system, mode, run):
    """Find a time at which the motion is not smooth in a trial step, and grade the steps toward it."""
    sign, end = run.guards[at.SIGNS, base.KINK], run.guards[at.END]
    if sign * end[base.KINK] < -base.SLACK:
        equation, slack = Guarded(system, mode, run, base.KINK), BEHIND * (run.until - run.time)
        at_start, at_end = abs(run.guards[at.VALUES, base.KINK]), -abs(end[base.KINK])
        low, high, fine = run.time, run.until, slack / (4.0 * run.until)
        run.pivot = root(_value, equation, low, high, at_start, at_end, fine) + slack
        run.side = -1.0


@inlined
def _may_end(run):
    """Whether a step may contain an event, judged by its guards at the ends and near the middle."""
    for cause in range(base.CAUSES):
        sign, end = run.guards[at.SIGNS, cause], run.guards[at.END, cause]
        middle = run.guards[at.ABOUT, cause]
        if sign == 0.0 and (abs(middle) > base.SLACK or abs(end) > base.SLACK):
            return True
        if sign * middle < -base.SLACK or sign * end < -base.SLACK:
            return True
        if not base.WATCHES[cause] and _dips(run.guards[at.VALUES, cause], middle, end, PART):
            return True
    return False


@compiled
def _dips(a, b, c, part):
    """Whether the parabola through values at 0, `part` and 1 falls below a fifth of the smallest value."""
    bend = ((c - a) - (b - a) / part) / (1.0 - part)
    slope = (c - a) - bend
    return 0.0 < -slope < 2.0 * bend and a - slope * slope / (4.0 * bend) < DIP * min(a, b, c)


@compiled
def _search(system, mode, run):
    """As `first_event`, using the guards at the nodes of the dense output."""
    for j in range(len(at.NODES) - 1):
        interpolate(system, mode, run, _node(run, j + 1), run.vectors[at.TRIAL])
        equations.guards(
            system, mode, _node(run, j + 1), run.vectors[at.TRIAL], run.guards[at.VALUES + j + 1]
        )
    first, found = inf, NOTHING
    for cause in range(base.CAUSES):
        value = run.guards[at.VALUES, cause]
        if value == value:  # it is guarded
            time = _event(Guarded(system, mode, run, cause))
            if time < 0.0:
                return MISJUDGED
            if time < first:
                first, found = time, cause
    run.event = min(first, run.until)
    return found


@inlined
def _node(run, j):
    """Time of a node; node 0 is the start of the step."""
    if j == len(at.NODES):
        return run.until
    return run.time + (at.NODES[j - 1] * (run.until - run.time) if j else 0.0)


@compiled
def _event(of):
    """Time of the first event of one cause in a step, infinite if there is none, -1 if misjudged."""
    run, cause, watched = of.run, of.cause, base.WATCHES[of.cause]
    for j in range(1, len(at.NODES) + 1):
        low, high, sign = _node(run, j - 1), _node(run, j), run.guards[at.SIGNS, cause]
        before, value = run.guards[at.VALUES + j - 1, cause], run.guards[at.VALUES + j, cause]
        if sign * value < -base.SLACK:
            return _crossing(of, low, high, sign * before, sign * value)
        if sign == 0.0:
            run.guards[at.SIGNS, cause] = _sign(cause, value)
            if value < -base.SLACK and not watched:
                rise = _rise(of, low, high)
                return rise if rise < 0.0 else _within(of, rise, high)
    return inf if watched else _dip(of)


@inlined
def _rise(of, start, end):
    """A time after `start` at which a margin that began at zero is positive, -1 if there is none."""
    part = 1.0
    for _ in range(1, HALVINGS):
        part /= 2.0
        time = start + (end - start) * part
        if _value(of, time) > base.SLACK:
            of.run.guards[at.SIGNS, of.cause] = 1.0
            return time
    return -1.0


@inlined
def _dip(of):
    """Time at which a margin vanishes between nodes at which it is positive, infinite if it does not."""
    run = of.run
    for j in range(1, len(at.NODES)):
        a, b = run.guards[at.VALUES + j - 1, of.cause], run.guards[at.VALUES + j, of.cause]
        c = run.guards[at.VALUES + j + 1, of.cause]
        if min(a, b, c) > 0.0 and _dips(a, b, c, 0.5):
            low, middle, high = _node(run, j - 1), _node(run, j), _node(run, j + 1)
            time, least = dip(_value, of, low, middle, high, b, -base.SLACK)
            if least < -base.SLACK:
                return _within(of, low, time)
    return inf


@compiled
def _within(of, low, high):
    """As `_crossing`, between times at which the guard has not been evaluated."""
    return _crossing(of, low, high, _value(of, low), _value(of, high))


@compiled
def _crossing(of, low, high, at_low, at_high):
    """Time at which a guard vanishes between two times; if it jumps, a time after the jump."""
    if at_low <= 0.0:
        return low
    time = root(_value, of, low, high, at_low, at_high, RESOLUTION)
    step = RESOLUTION * time
    while step > 0.0 and time < high and _value(of, time) > base.SLACK:
        time, step = min(time + step, high), 2.0 * step
    return time
