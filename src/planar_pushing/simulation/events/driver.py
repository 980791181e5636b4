"""The driver: from event to event, and a choice of mode at each.

A mode is integrated until one of its guards says that it ends; then the modes whose conditions hold are
enumerated and the policy takes one. The driver knows nothing of the equations. It works in phases, so that
it can hand on its rows, and go on, at any time.
"""

from __future__ import annotations

from collections.abc import Callable
from math import inf
from typing import Any

from planar_pushing.mechanics.compiled import compiled, generic, inlined
from planar_pushing.simulation.events import explicit, stiff
from planar_pushing.simulation.events.choice import NO_KIND, choose, solutions_now
from planar_pushing.simulation.events.explicit import interpolate
from planar_pushing.simulation.events.run import PASSING, REACHED, SCALES, STATE, candidate
from planar_pushing.simulation.events.watch import (
    MISJUDGED,
    NOTHING,
    first_event,
    start_watch,
)
from planar_pushing.simulation.fence import displacement, span
from planar_pushing.simulation.rows import NO_MODE, Stop
from planar_pushing.simulation.systems.base import (
    ANGLE,
    GAP,
    LIES,
    LOST,
    RUBBED,
    SLIP,
    WORK,
    after,
    enter,
    scales,
    settling,
    write,
)

#: What comes next: a span of the fence's motion, a step, the samples within it, a choice, a row, nothing.
ENTERS, STEPS, SAMPLES, CHANGES, LOGS, ENDED = range(6)
#: Phases until the driver returns in any case, so that an interrupt is heard.
PHASES_AT_ONCE = 20_000
#: Events of one run, and events in a row between which no time passes, before it is given up.
MOST_EVENTS, MOST_AT_ONCE = 100_000, 25
#: Part of the duration that counts as no time.
NO_TIME = 1e-12
#: Part of the tolerance that one step may use, since the errors of steps add up; and the least one.
STEP_PART, LEAST = 0.02, 2.3e-14
#: Step times Jacobian near the bound of stability (Hairer and Wanner II, Sec. IV.2).
STIFF = 4.0
#: So many steps in a row have to agree before the method changes.
AGREE = 15
GOES_ON, INCONSISTENT, LAY_DOWN = int(Stop.NO), int(Stop.INCONSISTENT), int(Stop.LIES)
SINGULAR, TOO_MANY = int(Stop.SINGULAR), int(Stop.EVENTS)


@compiled
def begin(system, run):
    """Put a run at its beginning; `run.vectors[STATE]` is the state there."""
    run.time, run.phase, run.span, run.sample = 0.0, ENTERS, 0, 0
    run.chosen, run.count, run.kind, run.solutions = -1, 0, NO_KIND, 0
    run.stopped, run.events, run.at_once, run.changes = GOES_ON, 0, 0, 0
    system.body.evaluations = 0
    scales(system, run.vectors[SCALES])


@compiled
def advance(system, task, run, rows):
    """Go on with a run until its rows are full, it has ended, or many steps are done; the rows written."""
    count = 0
    for _ in range(PHASES_AT_ONCE):
        if run.phase == ENDED or count == len(rows):
            break
        if run.phase == STEPS:
            _step(system, task, run)
        elif run.phase == SAMPLES or run.phase == LOGS:
            count += _write(system, task, run, rows[count])
        elif run.phase == CHANGES:
            _change(system, task, run)
        else:
            _enter(system, task, run)
    return count


@inlined
def _write(system, task, run, row):
    """Write down where the run is, or the next sample within a step; how many rows that is."""
    if run.phase == LOGS:
        _row(system, run, run.time, run.vectors[STATE], run.solutions, row)
        # Samples of that time count as done.
        while run.sample < len(task.times) and task.times[run.sample] <= run.time:
            run.sample += 1
        run.phase = ENDED if run.stopped != GOES_ON or run.span == len(system.fence) else STEPS
        return 1
    if run.sample < len(task.times) and task.times[run.sample] < run.event:
        time, state = task.times[run.sample], run.vectors[PASSING]
        interpolate(run, time, state)
        _row(system, run, time, state, solutions_now(system, run, time, state), row)
        run.sample += 1
        return 1
    if run.cause == NOTHING:
        _move_on(system, run)
    else:
        _happen(system, task, run)
    return 0


@compiled
def _row(system, run, time, state, solutions, row):
    """Write down an instant."""
    mode = candidate(system, run, run.chosen)
    row.time, row.rod_angle, row.slip, row.gap = time, state[ANGLE], state[SLIP], state[GAP]
    row.dissipated, row.contact_dissipated, row.work = state[RUBBED], state[LOST], state[WORK]
    row.fence[0], row.fence[1] = displacement(system.fence, mode.during, time)
    row.fence[1] -= system.body.gap
    row.mode = run.kind if run.chosen >= 0 else NO_MODE
    row.solutions, row.stopped = solutions, run.stopped
    write(system, mode, time, state, row)
    row.evaluations = system.body.evaluations


@inlined
def _stop(run, reason):
    run.stopped, run.phase = reason, LOGS


@inlined
def _enter(system, task, run):
    """Take up the motion of a span of the fence, or end where there is none."""
    run.phase = LOGS
    if run.span < len(system.fence):
        reason = enter(system, run.span, run.vectors[STATE], run.kind, task.policy)
        if reason != GOES_ON:
            _stop(run, reason)
        else:
            _begin_mode(system, task, run, NO_KIND)


@inlined
def _change(system, task, run):
    """Choose the mode that follows an event."""
    excluded = run.kind if run.cause == MISJUDGED else NO_KIND
    _count(system, run, span(system.fence, run.span))
    if run.at_once > MOST_AT_ONCE or run.events > MOST_EVENTS:
        _stop(run, TOO_MANY)
    elif run.phase == CHANGES:
        _begin_mode(system, task, run, excluded)


@compiled
def _begin_mode(system, task, run, excluded):
    """Choose a mode and begin it, or stop where none is consistent."""
    if choose(system, run, task.policy, excluded):
        run.before, run.agree, run.stable, run.phase = run.time, 0, inf, LOGS
        run.explicit, run.fresh = True, True
        start_watch(system, candidate(system, run, run.chosen), run)
    else:
        run.stopped, run.phase = INCONSISTENT, LOGS


@generic
def _stiff_step(kinds: Any) -> Callable[..., Any]:
    """One step of the stiff method, which only friction with inertia calls for."""
    return _implicit if len(kinds) > 1 else _none


@compiled
def _implicit(effects, system, mode, run, end, rtol):
    return stiff.step(system, mode, run, end, rtol)


@compiled
def _none(effects, system, mode, run, end, rtol):
    return False


@inlined
def _step(system, task, run):
    """Take one step, and look for an event in it."""
    mode = candidate(system, run, run.chosen)
    rtol, end = max(STEP_PART * task.rtol, LEAST), mode.during.end
    if run.explicit:
        done = explicit.step(system, mode, run, end, rtol)
    else:
        done = _stiff_step(system.effects, system, mode, run, end, rtol)
    if not done:
        _stop(run, SINGULAR)
    else:
        run.cause = first_event(system, mode, run)
        if run.cause == NOTHING:
            run.event = run.until
        run.phase = CHANGES if run.cause == MISJUDGED else SAMPLES


@inlined
def _move_on(system, run):
    """Go to the end of a step, and change the method where steps in a row say so."""
    during = span(system.fence, run.span)
    bound = (run.until - run.time) * settling(system, during, run.until, run.vectors[REACHED])
    changes = bound < run.stable / 2
    if run.explicit:
        changes = bound > 0.0 and explicit.stiffness(run) > STIFF
    run.agree = run.agree + 1 if changes else 0
    run.time, run.phase = run.until, STEPS
    run.vectors[STATE] = run.vectors[REACHED]
    if run.agree == AGREE:
        run.explicit, run.stable = not run.explicit, bound
        run.agree, run.fresh = 0, True
    if run.time >= during.end:
        _count(system, run, during)


@compiled
def _count(system, run, during):
    """Count what ended a mode, and say what comes next."""
    run.events += 1
    passed = run.time - run.before > NO_TIME * system.fence[len(system.fence) - 1].end
    run.at_once = 0 if passed else run.at_once + 1
    run.phase = CHANGES
    if run.time >= during.end:
        run.span, run.phase = during.last, ENTERS


@inlined
def _happen(system, task, run):
    """Go to an event, and to the state just after it."""
    mode, state = candidate(system, run, run.chosen), run.vectors[PASSING]
    interpolate(run, run.event, state)
    run.vectors[STATE] = state
    run.time, reason = after(system, run.cause, mode, run.event, run.vectors[STATE], task.policy)
    if run.cause == LIES:
        reason = LAY_DOWN
    run.phase = CHANGES
    if reason != GOES_ON:
        _stop(run, reason)
