"""The event-driven integrator: integration from event to event, with a choice of mode at each event.

A mode is integrated until one of its guards signals its end. Then the consistent modes are enumerated and
the policy chooses one. The integrator works in phases, so that it can return rows of the log and continue
at any time.
"""

from __future__ import annotations

from planar_pushing.core.instant.solution import SEPARATE, SLIP_LEFT
from planar_pushing.core.motion.integration.event_search import (
    MISJUDGED,
    NOTHING,
    UNNOTICED,
    first_event,
    sign_of_guard,
)
from planar_pushing.core.motion.integration.integrator import (
    interpolate_state,
    makes_progress,
)
from planar_pushing.core.motion.integration.log import (
    end_log,
    has_room_for_rows,
    next_log_row,
    write_instant,
)
from planar_pushing.core.motion.integration.one_step import take_small_error_step
from planar_pushing.core.motion.kinematics.corner import leave_corner
from planar_pushing.core.motion.kinematics.fence import end_of_fence, fence_displacement, span_at
from planar_pushing.core.motion.kinematics.mode import NO_MODE, Mode, contact_mode_of
from planar_pushing.core.motion.kinematics.rolling import (
    enters_pockets,
    follows_chain,
    has_finger,
    is_in_pocket,
    is_straight,
)
from planar_pushing.core.motion.kinematics.run import (
    Run,
)
from planar_pushing.core.motion.kinematics.shapes import center_height, put_initial_state
from planar_pushing.core.motion.kinematics.system import (
    CAUSES,
    CENTER_DOWN,
    END_OF_SIDE,
    GOES_ON,
    INCONSISTENT,
    KINK,
    LAID_DOWN,
    NO_PROGRESS,
    PASSING,
    PENETRATES,
    PUSH_STARTS,
    REACHED,
    SIGNS,
    SINGULAR_MOTION,
    SLIDER_STOPS,
    STATE,
    TOO_MANY_EVENTS,
    TOO_MUCH_WORK,
    TOUCHES,
    TWO_CONTACTS,
    VALUES,
    RunState,
    System,
    copy_numbers,
    guards_of,
    prepare_system,
    scale_state,
    system_of,
    vector_of,
)
from planar_pushing.core.motion.kinematics.touch import count_points, name_contact
from planar_pushing.core.motion.kinematics.wall import (
    begin_at_wall,
    confine_finger,
    go_to_next_piece,
    is_closed,
    open_wall,
    roll_on_to_next,
    room_on_piece,
    touch_wall,
)
from planar_pushing.core.motion.modes.candidates import note_slip
from planar_pushing.core.motion.modes.changes import (
    change_state,
    close_contact,
    close_on_foot,
    enter_span,
    settle,
)
from planar_pushing.core.motion.modes.choice import (
    choose_mode,
    count_modes,
    current_mode,
    current_policy,
)
from planar_pushing.core.motion.modes.equations import motion_in_mode
from planar_pushing.core.motion.modes.guards import write_guards
from planar_pushing.core.numbers import Numbers
from planar_pushing.core.supports.tolerances import RATTLES, SLACK

#: What a run does next: begin, enter a span of the pusher's motion, take a step, log the times within the
#: step, choose a mode, log the current instant; or it has ended.
BEGINS, ENTERS, TAKES_STEP, SAMPLES, CHANGES, LOGS, ENDED = range(7)
#: Maximum number of phases of a call, so that Python can handle an interrupt.
PHASES = 5000
#: Maximum number of events of a run, and of successive events between which no time passes.
MOST_EVENTS = 100000.0
MOST_AT_ONCE = 25.0
#: Fraction of the duration that counts as no time.
NO_TIME = 1e-12
#: Maximum number of evaluations of the motion in a run: about a minute with inertia.
MOST_EVALUATIONS = 5e7
#: A slider slower than this, in units of the typical speed, can be completed to rest in closed form with an
#: error of the pose of the order of its square: where a support point stays near the center of rotation,
#: friction can make the last part of the motion singular.
NEARLY_STOPPED = 1e-6


def run_events(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """Continue each run from event to event, until it ends, its log is full, or many steps are done.

    Rows of inputs and of results are described in the module `run`.
    """
    phases = 0
    for i in range(count):
        system = system_of(data, rows[i * columns :], results[i * width :], 1)
        system.run.rows = 0
        while phases < PHASES and not system.run.ended and has_room_for_rows(system, 1, width):
            _take_phase(system)
            phases += 1


def _take_phase(system: System) -> None:
    """Do what a run does next."""
    phase = system.run.phase
    if phase == TAKES_STEP:
        _take_step(system)
    elif phase == SAMPLES:
        _log_next_time(system)
    elif phase == LOGS:
        _log_now(system)
    elif phase == CHANGES:
        _change_mode(system)
    elif phase == ENTERS:
        _enter(system)
    elif phase == BEGINS:
        _begin(system)


def _begin(system: System) -> None:
    """Begin a run, with the state at time 0."""
    prepare_system(system)
    scale_state(system)
    begin_at_wall(system)
    put_initial_state(system, vector_of(system, STATE))
    name_contact(system, vector_of(system, STATE))
    run = system.run
    run.phase, run.chosen, run.mode = ENTERS, -1, NO_MODE
    run.cause = NOTHING


def _stop(run: Run, reason: int) -> None:
    """Log the current instant and end the run."""
    run.stopped, run.phase = reason, LOGS


def _log_now(system: System) -> None:
    """Log the current instant, and end the run or take the next step."""
    run, state, time = system.run, vector_of(system, STATE), system.run.time
    # Samples at this time are done.
    number, times = run.next_time, system.scene.times
    while number < times and system.times[number] <= time:
        number += 1
    goes_on: bool = run.stopped == GOES_ON and run.piece != system.fence.number
    if run.cause != UNNOTICED or number != run.next_time or not goes_on:
        _log_instant(system, time, state, max(run.cause, NOTHING))
    run.next_time, run.cause, run.phase = number, NOTHING, TAKES_STEP
    if not goes_on:
        run.phase, run.ended = ENDED, True
        end_log(system)


def _log_next_time(system: System) -> None:
    """Log the next time within a step; if there is none, go to the end of the step or to its event."""
    run, number = system.run, system.run.next_time
    if number < system.scene.times and system.times[number] < run.event_time:
        time, state = system.times[number], vector_of(system, PASSING)
        interpolate_state(system, current_mode(system), time, state)
        _log_instant(system, time, state, NOTHING)
        run.next_time = number + 1
    elif run.cause == NOTHING:
        _go_to_end_of_step(system)
    else:
        _go_to_event(system)


def _log_instant(system: System, time: float, state: RunState, event: int) -> None:
    """Store an instant in the log."""
    mode, row, contact = current_mode(system), next_log_row(system, time), NO_MODE
    instant, solutions = motion_in_mode(system, mode, time, state), system.run.solutions
    if system.run.chosen >= 0:  # the mode may have been chosen long before
        contact = system.run.mode
        solutions = count_modes(system, mode, instant, time, state)
        if system.run.mode_began == time:  # without the mode that ends
            solutions = min(solutions, system.run.solutions)
    x, y = fence_displacement(system.fence, mode.during, time)
    write_instant(system, instant, contact, time, state, x, y - system.scene.gap, solutions, row)
    row.event = event


def _enter(system: System) -> None:
    """Enter the next span of the pusher's motion, or end the run if there is none."""
    run, index = system.run, system.run.piece
    run.phase = LOGS
    if index < system.fence.number:
        state, current = vector_of(system, STATE), run.mode
        reason = enter_span(system, index, state, current, current_policy(system))
        if reason != GOES_ON:
            _stop(run, reason)
        else:
            _begin_mode(system, False)


def _change_mode(system: System) -> None:
    """Choose the mode that follows an event."""
    run = system.run
    misjudged: bool = run.cause == MISJUDGED
    if misjudged:
        _note_misjudged(run)
    _count_event(system)
    if run.at_once > MOST_AT_ONCE or run.events > MOST_EVENTS:
        _stop(run, TOO_MANY_EVENTS)
    elif run.phase == CHANGES:
        _begin_mode(system, misjudged)


def _note_misjudged(run: Run) -> None:
    """Remember that the mode was misjudged, so that it is not chosen again at this instant."""
    if run.time > run.mode_began:
        _forget_misjudged(run)
    run.misjudged[run.mode] = 1.0


def _forget_misjudged(run: Run) -> None:
    """Allow all modes again."""
    for contact in range(SLIP_LEFT + 1):
        run.misjudged[contact] = 0.0


def _settle_and_choose(
    system: System, slack: float, excludes: bool, point: int, other_end: int
) -> int:
    """Settle a side on the fence, and choose a mode; return `GOES_ON` or why there is none.

    The modes that were misjudged at this instant can be excluded at a contact.
    """
    run, state = system.run, vector_of(system, STATE)
    during = span_at(system.fence, run.piece)
    if not excludes:
        _forget_misjudged(run)
    reason = settle(
        system, during, run.time, state, slack, current=run.mode, policy=current_policy(system)
    )
    if reason == GOES_ON and not choose_mode(system, excludes, point, other_end):
        return INCONSISTENT
    return reason


def _begin_mode(system: System, excludes: bool) -> None:
    """Choose a mode and begin it, or stop if none is consistent."""
    run = system.run
    run.phase = LOGS
    if is_in_pocket(system) and not enters_pockets(system):
        run.stopped = TWO_CONTACTS
        return
    state, policy = vector_of(system, STATE), current_policy(system)
    during = span_at(system.fence, run.piece)
    point, other_end = run.point, run.other_end
    touch_wall(system, during, run.time, state)
    reason = _settle_and_choose(system, SLACK, excludes, point, other_end)
    if reason == GOES_ON and leave_corner(system, during, run.time, state, run.mode):
        reason = _settle_and_choose(system, SLACK, False, point, other_end)
    if reason == INCONSISTENT and count_points(system) > 0:
        # The ends of a side can meet the fence in turn, faster and faster, until it lies there.
        reason = _settle_and_choose(system, RATTLES, False, point, other_end)
    if reason == INCONSISTENT and close_on_foot(system, during, run.time, state):
        reason = _settle_and_choose(system, SLACK, False, point, other_end)
    if reason == INCONSISTENT and close_contact(system, during, run.time, state, policy):
        # A contact can open and close, faster and faster, while a support point comes to rest.
        reason = _settle_and_choose(system, SLACK, False, point, other_end)
    if reason == INCONSISTENT and center_height(system, state) <= SLACK:
        reason = LAID_DOWN  # another event comes first, or a fence has passed over a slider at rest
    if reason != GOES_ON:
        run.stopped = reason
        return
    run.mode_began, run.fresh = run.time, True
    separates: bool = contact_mode_of(current_mode(system)) == SEPARATE
    if separates and (is_closed(system, state) or not is_straight(run.wall)):
        open_wall(system, state)
    confine_finger(system, state)
    # The motion is not smooth after a kink.
    run.kink, run.kink_side = run.time, (1 if run.cause == KINK else 0)
    values, signs = guards_of(system, VALUES), guards_of(system, SIGNS)
    write_guards(system, current_mode(system), run.time, vector_of(system, STATE), values)
    for cause in range(CAUSES):
        signs[cause] = sign_of_guard(cause, values[cause])


def _take_step(system: System) -> None:
    """Take one step, and search it for an event."""
    run, mode = system.run, current_mode(system)
    progresses: bool = makes_progress(system)
    if run.evaluations > MOST_EVALUATIONS:
        _stop(run, TOO_MUCH_WORK)
    elif progresses and take_small_error_step(system, mode):
        cause = first_event(system, mode)
        run.cause = cause
        run.phase = CHANGES if cause == MISJUDGED else SAMPLES
    elif guards_of(system, VALUES)[SLIDER_STOPS] < NEARLY_STOPPED:
        _stop_slider(system, mode)
    else:
        _stop(run, SINGULAR_MOTION if progresses else NO_PROGRESS)


def _stop_slider(system: System, mode: Mode) -> None:
    """Complete a motion that comes to rest, from where the integrator does not resolve it."""
    run, state = system.run, vector_of(system, STATE)
    run.time, reason = change_state(
        system,
        cause=SLIDER_STOPS,
        mode=mode,
        time=run.time,
        state=state,
        policy=current_policy(system),
    )
    run.cause, run.phase = SLIDER_STOPS, CHANGES
    if reason != GOES_ON:
        _stop(run, reason)


def _go_to_end_of_step(system: System) -> None:
    """Advance to the end of a step."""
    run, state = system.run, vector_of(system, STATE)
    run.time = run.until
    copy_numbers(state, vector_of(system, REACHED), system.entries)
    mode = current_mode(system)
    note_slip(system, run.time, state, run.chosen, mode)
    run.phase = TAKES_STEP
    if run.time >= mode.during.end:
        _count_event(system)


def _count_event(system: System) -> None:
    """Count the event that ended a mode, and set the next phase."""
    run, during = system.run, span_at(system.fence, system.run.piece)
    run.events += 1
    passes: bool = run.time - run.mode_began > NO_TIME * end_of_fence(system.fence)
    run.at_once = 0 if passes else run.at_once + 1
    run.phase = CHANGES
    if run.time >= during.end:
        run.piece, run.phase = during.last, ENTERS


def _go_to_event(system: System) -> None:
    """Advance to an event and apply its change of state."""
    run, state, mode = system.run, vector_of(system, STATE), current_mode(system)
    cause, reason = run.cause, GOES_ON
    interpolate_state(system, mode, run.event_time, vector_of(system, PASSING))
    copy_numbers(state, vector_of(system, PASSING), system.entries)
    run.time = run.event_time
    if cause == PUSH_STARTS and guards_of(system, SIGNS)[TOUCHES] > 0.0:
        cause = TOUCHES  # the pusher has left the slider at rest before
        run.cause = cause
    # A finger leaves its side, or passes beside it.
    chained: bool = follows_chain(system)
    passes: bool = cause == TOUCHES and not chained and room_on_piece(system, state) < -SLACK
    if cause == END_OF_SIDE and not has_finger(system):
        reason = GOES_ON if roll_on_to_next(system, state) else INCONSISTENT
    elif chained and cause == END_OF_SIDE:
        reason = _pass_end(system, state)
    elif chained and cause == PENETRATES and not is_closed(system, state):
        open_wall(system, state)
        time, reason = change_state(
            system, TOUCHES, mode, run.event_time, state, current_policy(system)
        )
        run.time = time
    elif cause == END_OF_SIDE or passes:
        run.parted = True
        if passes:
            run.cause = NOTHING  # nothing is touched
    else:
        time, reason = change_state(
            system, cause, mode, run.event_time, state, current_policy(system)
        )
        run.time = time
    if cause == CENTER_DOWN:
        reason = LAID_DOWN
    elif cause == PENETRATES and has_finger(system):
        reason = TWO_CONTACTS
    run.phase = CHANGES
    if reason != GOES_ON:
        _stop(run, reason)


def _pass_end(system: System, state: RunState) -> int:
    """Go past the end of a piece; return `GOES_ON` or why the run ends."""
    if not is_closed(system, state):
        open_wall(system, state)
        system.run.cause = UNNOTICED
        return GOES_ON
    return GOES_ON if go_to_next_piece(system, state, state.along) else TWO_CONTACTS
