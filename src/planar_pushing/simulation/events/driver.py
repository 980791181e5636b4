"""The driver: integration from event to event, with a choice of mode at each event.

A mode is integrated until one of its guards signals its end. Then the consistent modes are enumerated and
the policy chooses one. The driver is independent of the equations. It works in phases, so that it can
return rows and continue at any time.
"""

from __future__ import annotations

from planar_pushing.simulation.copying import copy
from planar_pushing.simulation.events import choice, step, watch
from planar_pushing.simulation.events import run as at
from planar_pushing.simulation.events.explicit import interpolate
from planar_pushing.simulation.fence import displacement, span
from planar_pushing.simulation.legacy.compiled import compiled, inlined, kernel
from planar_pushing.simulation.rows import NO_MODE, Stop
from planar_pushing.simulation.systems import base
from planar_pushing.simulation.systems.shapes.base import room
from planar_pushing.simulation.systems.written import write

#: Next phase: enter a span of the fence's motion, step, sample within the step, choose, log a row, or end.
ENTERS, STEPS, SAMPLES, CHANGES, LOGS, ENDED = range(6)
#: Maximum number of phases before the driver returns, so that Python can handle an interrupt.
PHASES_AT_ONCE = 5_000
#: Maximum number of events of a run, and of successive events between which no time passes.
MOST_EVENTS, MOST_AT_ONCE = 100_000, 25
#: Fraction of the duration that counts as no time.
NO_TIME = 1e-12
#: Number of steps in which a run must advance by at least this fraction of the duration.
PATIENCE, LEAST_PROGRESS = 5000, 1e-6
#: Fraction of the tolerance allowed for one step, since the errors of steps add up; and its minimum.
STEP_PART, LEAST = 0.02, 2.3e-14
GOES_ON, INCONSISTENT = int(Stop.NO), int(Stop.INCONSISTENT)
LAY_DOWN = int(Stop.SLIDER_CENTER_REACHES_FENCE)
MET, SIDE_ENDED = int(Stop.PENETRATES), int(Stop.END_OF_SIDE)
SINGULAR, TOO_MANY, NO_PROGRESS = int(Stop.SINGULAR), int(Stop.EVENTS), int(Stop.PROGRESS)


@kernel
@compiled
def begin(system, run):
    """Initialize a run; `run.vectors[STATE]` holds the initial state."""
    run.time, run.last_size, run.phase, run.span, run.sample = 0.0, 0.0, ENTERS, 0, 0
    run.chosen, run.count, run.kind, run.solutions = -1, 0, choice.NO_KIND, 0
    run.stopped, run.events, run.at_once, run.changes = GOES_ON, 0, 0, 0
    run.cause, run.steps, run.checked = watch.NOTHING, 0, 0.0
    system.body.evaluations = 0
    base.scales(system, run.vectors[at.SCALES])


@kernel
@compiled
def advance(system, task, run, rows):
    """Continue a run until its rows are full, it ends, or many steps are done; return the row count."""
    count = 0
    for _ in range(PHASES_AT_ONCE):
        if run.phase == ENDED or count == len(rows):
            break
        if run.phase == STEPS:
            _step(system, task, run)
        elif run.phase == SAMPLES:
            count += _sample(system, task, run, rows[count])
        elif run.phase == LOGS:
            count += _log(system, task, run, rows[count])
        elif run.phase == CHANGES:
            _change(system, run)
        else:
            _enter(system, run)
    return count


@inlined
def _log(system, task, run, row):
    """Log the current instant of the run in one row."""
    state, solutions = run.vectors[at.STATE], run.solutions
    if run.chosen >= 0:  # the mode may have been chosen long before
        solutions = choice.solutions_now(system, run, run.time, state)
    _row(system, run, run.time, state, solutions, row)
    # Samples at this time are done.
    while run.sample < len(task.times) and task.times[run.sample] <= run.time:
        run.sample += 1
    row.event, run.cause = max(run.cause, watch.NOTHING), watch.NOTHING
    run.phase = ENDED if run.stopped != GOES_ON or run.span == len(system.fence) else STEPS
    return 1


@inlined
def _sample(system, task, run, row):
    """Log the next sample within a step, or continue if there is none; return the number of rows."""
    if run.sample < len(task.times) and task.times[run.sample] < run.event:
        mode, time = at.candidate(system, run, run.chosen), task.times[run.sample]
        state = run.vectors[at.PASSING]
        interpolate(system, mode, run, time, state)
        solutions = choice.solutions_now(system, run, time, state)
        _row(system, run, time, state, solutions, row)
        row.event = watch.NOTHING
        run.sample += 1
        return 1
    if run.cause == watch.NOTHING:
        _move_on(system, run)
    else:
        _happen(system, run)
    return 0


@compiled
def _row(system, run, time, state, solutions, row):
    """Store an instant in a row."""
    mode = at.candidate(system, run, run.chosen)
    row.time, row.solutions, row.stopped = time, solutions, run.stopped
    row.pusher[0], row.pusher[1] = displacement(system.fence, mode.during, time)
    row.pusher[1] -= system.body.gap
    row.mode = run.kind if run.chosen >= 0 else NO_MODE
    write(system, mode, time, state, row)


@inlined
def _policy(system, run):
    """Policy for the current span of the run."""
    return system.fence[run.span].policy


@inlined
def _stop(run, reason):
    run.stopped, run.phase = reason, LOGS


@inlined
def _enter(system, run):
    """Enter the next span of the fence's motion, or end the run if there is none."""
    run.phase = LOGS
    if run.span < len(system.fence):
        reason = base.enter(system, run.span, run.vectors[at.STATE], run.kind, _policy(system, run))
        if reason != GOES_ON:
            _stop(run, reason)
        else:
            _begin_mode(system, run, choice.NO_KIND)


@inlined
def _change(system, run):
    """Choose the mode that follows an event."""
    excluded = run.kind if run.cause == watch.MISJUDGED else choice.NO_KIND
    _count(system, run, span(system.fence, run.span))
    if run.at_once > MOST_AT_ONCE or run.events > MOST_EVENTS:
        _stop(run, TOO_MANY)
    elif run.phase == CHANGES:
        _begin_mode(system, run, excluded)


@compiled
def _begin_mode(system, run, excluded):
    """Choose a mode and begin it, or stop if none is consistent."""
    run.phase = LOGS
    base.confine(system, run.vectors[at.STATE])
    if choice.choose(system, run, _policy(system, run), excluded):
        run.before = run.time
        step.begin(run)
        watch.start_watch(system, at.candidate(system, run, run.chosen), run)
    else:
        run.stopped = INCONSISTENT


@inlined
def _step(system, task, run):
    """Take one step, and search it for an event."""
    mode = at.candidate(system, run, run.chosen)
    if not _gets_on(system, run):
        _stop(run, NO_PROGRESS)
    elif step.take(system, mode, run, mode.during.end, max(STEP_PART * task.rtol, LEAST)):
        run.cause = watch.first_event(system, mode, run)
        run.phase = CHANGES if run.cause == watch.MISJUDGED else SAMPLES
    else:
        _stop(run, SINGULAR)


@inlined
def _gets_on(system, run):
    """Whether the run has advanced since the last check."""
    run.steps += 1
    if run.steps % PATIENCE != 0:
        return True
    passed, run.checked = run.time - run.checked, run.time
    return passed > LEAST_PROGRESS * system.fence[len(system.fence) - 1].end


@inlined
def _move_on(system, run):
    """Advance to the end of a step."""
    step.move_on(run)
    base.remember(
        system,
        run.time,
        run.vectors[at.STATE],
        at.candidate(system, run, run.chosen),
        run.starts[run.chosen],
    )
    run.phase, during = STEPS, span(system.fence, run.span)
    if run.time >= during.end:
        _count(system, run, during)


@compiled
def _count(system, run, during):
    """Count the event that ended a mode, and set the next phase."""
    run.events += 1
    passed = run.time - run.before > NO_TIME * system.fence[len(system.fence) - 1].end
    run.at_once = 0 if passed else run.at_once + 1
    run.phase = CHANGES
    if run.time >= during.end:
        run.span, run.phase = during.last, ENTERS


@compiled
def _parts(system, cause, along):
    """Whether an event ends the contact permanently: a finger leaves its side, or passes beside it."""
    return cause == base.END_OF_SIDE or (cause == base.TOUCHES and room(system.shape, along) < 0.0)


@inlined
def _happen(system, run):
    """Advance to an event and apply its change of state."""
    mode, state = at.candidate(system, run, run.chosen), run.vectors[at.STATE]
    interpolate(system, mode, run, run.event, run.vectors[at.PASSING])
    copy(state, run.vectors[at.PASSING])
    run.time, reason = run.event, GOES_ON
    if _parts(system, run.cause, state[base.ALONG]):
        if len(system.room.corners) > 0:
            reason = SIDE_ENDED
        else:
            system.body.parted = True
    else:
        policy = _policy(system, run)
        run.time, reason = base.after(system, run.cause, mode, run.event, state, policy)
    if run.cause == base.CENTER_REACHES_FENCE:
        reason = LAY_DOWN
    elif run.cause == base.PENETRATES:
        reason = MET
    run.phase = CHANGES
    if reason != GOES_ON:
        _stop(run, reason)
