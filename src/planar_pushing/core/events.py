"""The event-driven integrator: integration from event to event, with a choice of mode at each event.

A mode is integrated until one of its guards signals its end. Then the consistent modes are enumerated and
the policy chooses one. The guards are followed along the dense output of each step. Each has a sign: a
guard that begins at zero has none until it has left zero, and is then watched. The integrator works in
phases, so that it can return rows of the log and continue at any time.
"""

from __future__ import annotations

from math import fabs, sqrt

from planar_pushing.core.equations import Instant, motion_in_mode, write_guards, write_rates
from planar_pushing.core.explicit import (
    MIDDLE_PART,
    attempt_step,
    first_size,
    interpolate_state,
    next_size,
    smaller_size,
    smallest_size,
)
from planar_pushing.core.fence import end_of_fence, fence_displacement, policy_at, span_at
from planar_pushing.core.log import end_log, has_room_for_rows, next_log_row, write_instant
from planar_pushing.core.numbers import INFINITY, Numbers
from planar_pushing.core.rest import (
    change_state,
    count_quasi_static,
    enter_span,
    note_slip,
    write_candidates,
)
from planar_pushing.core.roots import (
    ITERATIONS,
    SECTIONS,
    Dip,
    best_number,
    is_narrow,
    narrow_bracket,
    narrow_dip,
    next_number,
    open_bracket,
    section_of,
)
from planar_pushing.core.run import (
    IN_GAP,
    IN_TIMES,
    IN_TOLERANCE,
    LOG_EVENT,
    RUN_AT_ONCE,
    RUN_BEFORE,
    RUN_CAUSE,
    RUN_CHANGES,
    RUN_CHECKED,
    RUN_CHOSEN,
    RUN_COUNT,
    RUN_ENDED,
    RUN_EVENT,
    RUN_EVENTS,
    RUN_FRESH,
    RUN_KINK,
    RUN_LAST_ERROR,
    RUN_LAST_SIZE,
    RUN_MODE,
    RUN_NEXT,
    RUN_PARTED,
    RUN_PHASE,
    RUN_PIECE,
    RUN_PLANNED,
    RUN_PREPARED,
    RUN_ROWS,
    RUN_SIDE,
    RUN_SOLUTIONS,
    RUN_STEPS,
    RUN_STOPPED,
    RUN_TIME,
    RUN_UNTIL,
)
from planar_pushing.core.shapes import (
    clearance_of,
    confine_finger,
    has_outline,
    longest_step,
    put_initial_state,
    room_on_side,
)
from planar_pushing.core.system import (
    ALONG,
    CANDIDATE,
    CAUSES,
    CENTER_DOWN,
    END_OF_SIDE,
    END_VALUES,
    FIRST_RATES,
    GAP,
    GOES_ON,
    INCONSISTENT,
    KINK,
    LAID_DOWN,
    LAST_RATES,
    LATER_GUARDS,
    MET_OUTLINE,
    MIDDLE_VALUES,
    NO_MODE,
    NO_PROGRESS,
    PASSING,
    PENETRATES,
    REACHED,
    SIDE_ENDED,
    SIGNS,
    SINGULAR_MOTION,
    STATE,
    TOO_MANY_EVENTS,
    TOUCHES,
    TRIAL,
    TRIAL_GUARDS,
    VALUES,
    WATCHES,
    Mode,
    System,
    candidate_at,
    contact_mode_of,
    copy_numbers,
    guards_of,
    is_massive,
    pace_of,
    prepare_system,
    rank_of,
    scale_state,
    system_of,
    vector_of,
)
from planar_pushing.core.tolerances import AT_REST, HAS_LEFT, NEAR_ZERO, NO_TREND, RESOLVED, SLACK

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
#: Number of steps in which a run must advance by at least this fraction of the duration.
PATIENCE = 5000
SMALLEST_PROGRESS = 1e-6
#: Fraction of the tolerance allowed for one step, since the errors of steps add up; and its minimum.
PART_OF_STEP = 0.02
FINEST = 2.3e-14
#: Above this error, in units of the tolerance, a trial step gives no information.
WILD = 1e5
#: Time over which the trend of a margin is evaluated, as a fraction of that in which the pusher moves by
#: one length.
AHEAD = 1e-5
#: Number of nodes of a step, at equal distances, at which the guards are evaluated if it may contain an
#: event.
STEP_NODES = 4
#: Maximum number of halvings in the search for a time at which a margin that starts at zero is positive.
RISE_HALVINGS = 20
#: A margin may vanish between the nodes if its parabola falls below this fraction of the smallest value.
DIP_PART = 0.2
#: Accuracy of the time of a kink as a fraction of the step, and its distance after the kink, so that the
#: step to it contains the kink as an event. The nonsmooth remainder changes the motion by less than 1e-12.
BEHIND_KINK = 1e-5
#: Results of the search of a step other than the cause of an event.
NOTHING = -1
MISJUDGED = -2


def run_events(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """Continue each run from event to event, until it ends, its log is full, or many steps are done.

    Rows of inputs and of results are described in the module `run`.
    """
    phases = 0
    for i in range(count):
        system = system_of(data, rows[i * columns :], results[i * width :], 1)
        system.run[RUN_ROWS] = 0.0
        while (
            phases < PHASES and system.run[RUN_ENDED] == 0.0 and has_room_for_rows(system, 1, width)
        ):
            _take_phase(system)
            phases += 1


def _take_phase(system: System) -> None:
    """Do what a run does next."""
    phase = int(system.run[RUN_PHASE])
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
    put_initial_state(system, vector_of(system, STATE))
    run = system.run
    run[RUN_PHASE], run[RUN_CHOSEN], run[RUN_MODE] = float(ENTERS), -1.0, float(NO_MODE)
    run[RUN_CAUSE] = float(NOTHING)


def _current_mode(system: System) -> Mode:
    """The chosen mode."""
    return candidate_at(system, int(system.run[RUN_CHOSEN]), int(system.run[RUN_PIECE]))


def _policy_of(system: System) -> int:
    """The policy in the current span of the pusher's motion."""
    return policy_at(system.fence, int(system.run[RUN_PIECE]))


def _stop(run: Numbers, reason: int) -> None:
    """Log the current instant and end the run."""
    run[RUN_STOPPED], run[RUN_PHASE] = float(reason), float(LOGS)


# The log


def _log_now(system: System) -> None:
    """Log the current instant, and end the run or take the next step."""
    run, state, time = system.run, vector_of(system, STATE), system.run[RUN_TIME]
    _log_instant(system, time, state, max(int(run[RUN_CAUSE]), NOTHING))
    # Samples at this time are done.
    number, times = int(run[RUN_NEXT]), int(system.scene[IN_TIMES])
    while number < times and system.times[number] <= time:
        number += 1
    run[RUN_NEXT], run[RUN_CAUSE], run[RUN_PHASE] = float(number), float(NOTHING), float(TAKES_STEP)
    if run[RUN_STOPPED] != float(GOES_ON) or int(run[RUN_PIECE]) == system.fence.number:
        run[RUN_PHASE], run[RUN_ENDED] = float(ENDED), 1.0
        end_log(system)


def _log_next_time(system: System) -> None:
    """Log the next time within a step; if there is none, go to the end of the step or to its event."""
    run, number = system.run, int(system.run[RUN_NEXT])
    if number < int(system.scene[IN_TIMES]) and system.times[number] < run[RUN_EVENT]:
        time, state = system.times[number], vector_of(system, PASSING)
        interpolate_state(system, _current_mode(system), time, state)
        _log_instant(system, time, state, NOTHING)
        run[RUN_NEXT] = float(number + 1)
    elif int(run[RUN_CAUSE]) == NOTHING:
        _go_to_end_of_step(system)
    else:
        _go_to_event(system)


def _log_instant(system: System, time: float, state: Numbers, event: int) -> None:
    """Store an instant in the log."""
    mode, row, contact = _current_mode(system), next_log_row(system, time), NO_MODE
    now, solutions = motion_in_mode(system, mode, time, state), int(system.run[RUN_SOLUTIONS])
    if system.run[RUN_CHOSEN] >= 0.0:  # the mode may have been chosen long before
        contact = int(system.run[RUN_MODE])
        solutions = _count_modes(system, mode, now, time, state)
    x, y = fence_displacement(system.fence, mode.during, time)
    write_instant(system, now, contact, time, state, x, y - system.scene[IN_GAP], solutions, row)
    row[LOG_EVENT] = float(event)


# Phases


def _enter(system: System) -> None:
    """Enter the next span of the pusher's motion, or end the run if there is none."""
    run, index = system.run, int(system.run[RUN_PIECE])
    run[RUN_PHASE] = float(LOGS)
    if index < system.fence.number:
        state, current = vector_of(system, STATE), int(run[RUN_MODE])
        reason = enter_span(system, index, state, current, _policy_of(system))
        if reason != GOES_ON:
            _stop(run, reason)
        else:
            _begin_mode(system, NO_MODE)


def _change_mode(system: System) -> None:
    """Choose the mode that follows an event."""
    run = system.run
    excluded = int(run[RUN_MODE]) if int(run[RUN_CAUSE]) == MISJUDGED else NO_MODE
    _count_event(system)
    if run[RUN_AT_ONCE] > MOST_AT_ONCE or run[RUN_EVENTS] > MOST_EVENTS:
        _stop(run, TOO_MANY_EVENTS)
    elif int(run[RUN_PHASE]) == CHANGES:
        _begin_mode(system, excluded)


def _begin_mode(system: System, excluded: int) -> None:
    """Choose a mode and begin it, or stop if none is consistent."""
    run = system.run
    run[RUN_PHASE] = float(LOGS)
    confine_finger(system, vector_of(system, STATE))
    if not _choose_mode(system, excluded):
        run[RUN_STOPPED] = float(INCONSISTENT)
        return
    run[RUN_BEFORE], run[RUN_FRESH] = run[RUN_TIME], 1.0
    # The motion is not smooth after a kink.
    run[RUN_KINK], run[RUN_SIDE] = run[RUN_TIME], (1.0 if int(run[RUN_CAUSE]) == KINK else 0.0)
    values, signs = guards_of(system, VALUES), guards_of(system, SIGNS)
    write_guards(system, _current_mode(system), run[RUN_TIME], vector_of(system, STATE), values)
    for cause in range(CAUSES):
        signs[cause] = _sign_of(cause, values[cause])


def _take_step(system: System) -> None:
    """Take one step, and search it for an event."""
    run, mode = system.run, _current_mode(system)
    if not _makes_progress(system):
        _stop(run, NO_PROGRESS)
    elif _advance(system, mode, max(PART_OF_STEP * system.scene[IN_TOLERANCE], FINEST)):
        cause = _first_event(system, mode)
        run[RUN_CAUSE] = float(cause)
        run[RUN_PHASE] = float(CHANGES if cause == MISJUDGED else SAMPLES)
    else:
        _stop(run, SINGULAR_MOTION)


def _makes_progress(system: System) -> bool:
    """Whether the run has advanced since the last check."""
    run = system.run
    run[RUN_STEPS] += 1.0
    if run[RUN_STEPS] < float(PATIENCE):
        return True
    elapsed = run[RUN_TIME] - run[RUN_CHECKED]
    run[RUN_STEPS], run[RUN_CHECKED] = 0.0, run[RUN_TIME]
    return elapsed > SMALLEST_PROGRESS * end_of_fence(system.fence)


def _advance(system: System, mode: Mode, tolerance: float) -> bool:
    """Take one step, with a size at which the error is small; return whether there is one."""
    run, end = system.run, mode.during.end
    if run[RUN_SIDE] < 0.0 and run[RUN_TIME] >= run[RUN_KINK]:
        run[RUN_SIDE] = 1.0
    rates, smallest = vector_of(system, FIRST_RATES), smallest_size(run[RUN_TIME])
    if run[RUN_FRESH] != 0.0:
        write_rates(system, mode, run[RUN_TIME], vector_of(system, STATE), rates)
        run[RUN_PLANNED] = first_size(system, mode, end, tolerance)
        run[RUN_LAST_SIZE], run[RUN_FRESH] = 0.0, 0.0
    else:
        copy_numbers(rates, vector_of(system, LAST_RATES), system.entries)
    size, last_size, last_error = max(run[RUN_PLANNED], smallest), 0.0, 0.0
    speed = sqrt(rates[ALONG] * rates[ALONG] + rates[GAP] * rates[GAP])
    longest = longest_step(system, mode, guards_of(system, VALUES)[PENETRATES], speed)
    end = min(end, run[RUN_TIME] + max(longest, smallest))
    while size >= smallest:
        bound = min(end, run[RUN_KINK]) if run[RUN_SIDE] < 0.0 else end
        run[RUN_UNTIL], run[RUN_PREPARED] = min(run[RUN_TIME] + size, bound), 0.0
        size = run[RUN_UNTIL] - run[RUN_TIME]
        error = attempt_step(system, mode, tolerance)
        if error < 1.0:
            planned = next_size(run, size, error)
            run[RUN_PLANNED] = min(planned, size) if last_size > 0.0 else planned
            run[RUN_LAST_SIZE], run[RUN_LAST_ERROR] = size, error
            return True
        if run[RUN_SIDE] >= 0.0 and error < WILD:
            _look_for_kink(system, mode)
        smaller = smaller_size(size, error, last_size, last_error)
        last_size, last_error, size = size, error, smaller
    return False


def _go_to_end_of_step(system: System) -> None:
    """Advance to the end of a step."""
    run, state = system.run, vector_of(system, STATE)
    run[RUN_TIME] = run[RUN_UNTIL]
    copy_numbers(state, vector_of(system, REACHED), system.entries)
    mode = _current_mode(system)
    note_slip(system, run[RUN_TIME], state, int(run[RUN_CHOSEN]), mode)
    run[RUN_PHASE] = float(TAKES_STEP)
    if run[RUN_TIME] >= mode.during.end:
        _count_event(system)


def _count_event(system: System) -> None:
    """Count the event that ended a mode, and set the next phase."""
    run, during = system.run, span_at(system.fence, int(system.run[RUN_PIECE]))
    run[RUN_EVENTS] += 1.0
    passes: bool = run[RUN_TIME] - run[RUN_BEFORE] > NO_TIME * end_of_fence(system.fence)
    run[RUN_AT_ONCE] = 0.0 if passes else run[RUN_AT_ONCE] + 1.0
    run[RUN_PHASE] = float(CHANGES)
    if run[RUN_TIME] >= during.end:
        run[RUN_PIECE], run[RUN_PHASE] = float(during.last), float(ENTERS)


def _go_to_event(system: System) -> None:
    """Advance to an event and apply its change of state."""
    run, state, mode = system.run, vector_of(system, STATE), _current_mode(system)
    cause, reason = int(run[RUN_CAUSE]), GOES_ON
    interpolate_state(system, mode, run[RUN_EVENT], vector_of(system, PASSING))
    copy_numbers(state, vector_of(system, PASSING), system.entries)
    run[RUN_TIME] = run[RUN_EVENT]
    # A finger leaves its side, or passes beside it.
    passes: bool = cause == TOUCHES and room_on_side(system, state[ALONG]) < 0.0
    if cause == END_OF_SIDE or passes:
        run[RUN_PARTED] = 0.0 if has_outline(system) else 1.0
        reason = SIDE_ENDED if has_outline(system) else GOES_ON
    else:
        time, reason = change_state(system, cause, mode, run[RUN_EVENT], state, _policy_of(system))
        run[RUN_TIME] = time
    if cause == CENTER_DOWN:
        reason = LAID_DOWN
    elif cause == PENETRATES:
        reason = MET_OUTLINE
    run[RUN_PHASE] = float(CHANGES)
    if reason != GOES_ON:
        _stop(run, reason)


# The choice of a mode


def _is_watched(cause: int) -> bool:
    """Whether any change of a guard's sign is an event; other guards are positive while a mode lasts."""
    return WATCHES[cause] != 0.0


def _holds(system: System, mode: Mode, time: float, state: Numbers) -> bool:
    """Whether the margins of a mode are positive, or zero and not decreasing."""
    now, later = guards_of(system, TRIAL_GUARDS), guards_of(system, LATER_GUARDS)
    write_guards(system, mode, time, state, now)
    near: bool = False
    for cause in range(CAUSES):
        if WATCHES[cause] == 0.0:
            if now[cause] < -NEAR_ZERO:
                return False
            near = near or now[cause] <= NEAR_ZERO
    if not near:
        return True
    _look_ahead(system, mode, time, state)
    for cause in range(CAUSES):
        margin: bool = WATCHES[cause] == 0.0 and now[cause] <= NEAR_ZERO
        if margin and not later[cause] >= now[cause] - NO_TREND:
            return False
    return True


def _will_hold(system: System, mode: Mode, time: float, state: Numbers) -> bool:
    """Whether the margins of a mode are positive a moment later, for forces that jump at the instant."""
    later, lowest = guards_of(system, LATER_GUARDS), INFINITY
    _look_ahead(system, mode, time, state)
    for cause in range(CAUSES):
        if WATCHES[cause] == 0.0:
            lowest = min(lowest, later[cause])  # without the causes that have no guard
    return lowest >= -NEAR_ZERO


def _look_ahead(system: System, mode: Mode, time: float, state: Numbers) -> None:
    """Store the guards of a mode a moment later."""
    during, trial = mode.during, vector_of(system, TRIAL)
    ahead = AHEAD * min(during.end - during.start, pace_of(system, during, time))
    write_rates(system, mode, time, state, trial)
    for k in range(system.entries):
        trial[k] = state[k] + ahead * trial[k]
    write_guards(system, mode, time + ahead, trial, guards_of(system, LATER_GUARDS))


def _choose_mode(system: System, excluded: int) -> bool:
    """Choose a consistent mode other than `excluded` by the policy; return whether there is one."""
    run, state, piece = system.run, vector_of(system, STATE), int(system.run[RUN_PIECE])
    current, policy, time = int(run[RUN_MODE]), _policy_of(system), run[RUN_TIME]
    during, count = span_at(system.fence, piece), 0
    chosen, contact, lowest, solutions = -1, NO_MODE, 0, 0
    for attempt in range(2):
        if chosen >= 0:
            break
        # Where forces jump, a mode begins just after them.
        slowest = AT_REST if attempt == 0 else HAS_LEFT
        count = write_candidates(system, during, time, state, slowest)
        for i in range(count):
            mode = candidate_at(system, i, piece)
            candidate = contact_mode_of(mode)
            if mode.contact == NO_MODE or candidate == excluded:
                system.candidates[i * CANDIDATE] = float(NO_MODE)
                continue
            holds: bool = attempt == 0 and _holds(system, mode, time, state)
            if holds or (attempt == 1 and _will_hold(system, mode, time, state)):
                rank = rank_of(policy, current, candidate)
                if chosen < 0 or rank < lowest:
                    chosen, contact, lowest = i, candidate, rank
                solutions += 1
    run[RUN_COUNT], run[RUN_CHOSEN], run[RUN_MODE] = float(count), float(chosen), float(contact)
    run[RUN_SOLUTIONS] = float(solutions)
    if contact != current and current != NO_MODE:
        run[RUN_CHANGES] += 1.0
    return chosen >= 0


def _count_modes(system: System, mode: Mode, now: Instant, time: float, state: Numbers) -> int:
    """Number of consistent modes at an instant within a step; one if the contact is open."""
    count, run = 1, system.run
    if clearance_of(system, state) > SLACK:
        return count
    if not is_massive(system):
        solutions = count_quasi_static(system, mode, now, state)
        if solutions > 0:
            return solutions
    for i in range(int(run[RUN_COUNT])):
        other = candidate_at(system, i, int(run[RUN_PIECE]))
        known: bool = i == int(run[RUN_CHOSEN]) or other.contact == NO_MODE
        if not known and _holds(system, other, time, state):
            count += 1
    return count


# Events


def _guard_at(system: System, mode: Mode, cause: int, time: float) -> float:
    """A guard at a time of the step, positive before its event."""
    trial, guards = vector_of(system, TRIAL), guards_of(system, TRIAL_GUARDS)
    interpolate_state(system, mode, time, trial)
    write_guards(system, mode, time, trial, guards)
    return -guards[cause] if guards_of(system, SIGNS)[cause] < 0.0 else guards[cause]


def _sign_of(cause: int, value: float) -> float:
    """Sign of a watch that is not near zero; for a margin, 1 if it is positive; 0 otherwise."""
    if value > SLACK:
        return 1.0
    return -1.0 if _is_watched(cause) and value < -SLACK else 0.0


def _first_event(system: System, mode: Mode) -> int:
    """Store the time of the first event of a step; return its cause, `NOTHING`, or `MISJUDGED`.

    A mode is misjudged if a margin is negative from its start.
    """
    system.run[RUN_EVENT], cause = system.run[RUN_UNTIL], NOTHING
    if _may_contain_event(system):
        cause = _search_step(system, mode)
    copy_numbers(guards_of(system, VALUES), guards_of(system, END_VALUES), CAUSES)
    return cause


def _look_for_kink(system: System, mode: Mode) -> None:
    """Find a time at which the motion is not smooth in a trial step, and grade the steps toward it."""
    run, end = system.run, guards_of(system, END_VALUES)[KINK]
    if guards_of(system, SIGNS)[KINK] * end < -SLACK:
        slack = BEHIND_KINK * (run[RUN_UNTIL] - run[RUN_TIME])
        first, last = fabs(guards_of(system, VALUES)[KINK]), -fabs(end)
        resolution = slack / (4.0 * run[RUN_UNTIL])
        kink = _root_of_guard(
            system, mode, KINK, run[RUN_TIME], run[RUN_UNTIL], first, last, resolution
        )
        run[RUN_KINK], run[RUN_SIDE] = kink + slack, -1.0


def _root_of_guard(
    system: System, mode: Mode, cause: int,
    low: float, high: float, at_low: float, at_high: float, resolution: float,
) -> float:  # fmt: skip
    """Time at which a guard vanishes between two times with values of opposite signs."""
    bracket = open_bracket(low, high, at_low, at_high, resolution)
    for _ in range(ITERATIONS):
        time = next_number(bracket)
        bracket = narrow_bracket(bracket, time, _guard_at(system, mode, cause, time))
        if is_narrow(bracket):
            return best_number(bracket)
    return bracket.a


def _may_contain_event(system: System) -> bool:
    """Whether a step may contain an event, judged by its guards at the ends and near the middle."""
    signs, values = guards_of(system, SIGNS), guards_of(system, VALUES)
    middles, ends = guards_of(system, MIDDLE_VALUES), guards_of(system, END_VALUES)
    for cause in range(CAUSES):
        sign, middle, end = signs[cause], middles[cause], ends[cause]
        if sign == 0.0 and (fabs(middle) > SLACK or fabs(end) > SLACK):
            return True
        if sign * middle < -SLACK or sign * end < -SLACK:
            return True
        if not _is_watched(cause) and _dips(values[cause], middle, end, MIDDLE_PART):
            return True
    return False


def _dips(a: float, b: float, c: float, part: float) -> bool:
    """Whether the parabola through values at 0, `part` and 1 falls below a part of the smallest value."""
    bend = ((c - a) - (b - a) / part) / (1.0 - part)
    slope = (c - a) - bend
    if not 0.0 < -slope < 2.0 * bend:
        return False
    return a - slope * slope / (4.0 * bend) < DIP_PART * min(min(a, b), c)


def _search_step(system: System, mode: Mode) -> int:
    """As `_first_event`, using the guards at the nodes of the dense output."""
    trial, first, cause = vector_of(system, TRIAL), INFINITY, NOTHING
    for j in range(1, STEP_NODES):
        time = _node_time(system.run, j)
        interpolate_state(system, mode, time, trial)
        write_guards(system, mode, time, trial, guards_of(system, VALUES + j))
    for i in range(CAUSES):
        value = guards_of(system, VALUES)[i]
        if value == value:  # it is guarded
            time = _event_of_cause(system, mode, i)
            if time < 0.0:
                return MISJUDGED
            if time < first:
                first, cause = time, i
    system.run[RUN_EVENT] = min(first, system.run[RUN_UNTIL])
    return cause


def _node_time(run: Numbers, j: int) -> float:
    """Time of a node; node 0 is the start of the step."""
    if j == STEP_NODES:
        return run[RUN_UNTIL]
    return run[RUN_TIME] + float(j) / float(STEP_NODES) * (run[RUN_UNTIL] - run[RUN_TIME])


def _event_of_cause(system: System, mode: Mode, cause: int) -> float:
    """Time of the first event of one cause in a step, infinite if there is none, -1 if misjudged."""
    run, signs = system.run, guards_of(system, SIGNS)
    watched: bool = _is_watched(cause)
    for j in range(1, STEP_NODES + 1):
        low, high, sign = _node_time(run, j - 1), _node_time(run, j), signs[cause]
        before, value = (
            guards_of(system, VALUES + j - 1)[cause],
            guards_of(system, VALUES + j)[cause],
        )
        if sign * value < -SLACK:
            return _crossing(system, mode, cause, low, high, sign * before, sign * value)
        if sign == 0.0:
            signs[cause] = _sign_of(cause, value)
            if value < -SLACK and not watched:
                rise = _time_of_rise(system, mode, cause, low, high)
                return rise if rise < 0.0 else _crossing_within(system, mode, cause, rise, high)
    return INFINITY if watched else _time_of_dip(system, mode, cause)


def _time_of_rise(system: System, mode: Mode, cause: int, start: float, end: float) -> float:
    """A time after `start` at which a margin that began at zero is positive, -1 if there is none."""
    part = 1.0
    for _ in range(1, RISE_HALVINGS):
        part /= 2.0
        time = start + (end - start) * part
        if _guard_at(system, mode, cause, time) > SLACK:
            guards_of(system, SIGNS)[cause] = 1.0
            return time
    return -1.0


def _time_of_dip(system: System, mode: Mode, cause: int) -> float:
    """Time at which a margin vanishes between nodes at which it is positive, infinite if it does not."""
    run = system.run
    for j in range(1, STEP_NODES):
        a = guards_of(system, VALUES + j - 1)[cause]
        b = guards_of(system, VALUES + j)[cause]
        c = guards_of(system, VALUES + j + 1)[cause]
        if min(min(a, b), c) > 0.0 and _dips(a, b, c, 0.5):
            low = _node_time(run, j - 1)
            dip = Dip(low, _node_time(run, j), _node_time(run, j + 1), b)
            for _ in range(SECTIONS):
                time = section_of(dip)
                dip = narrow_dip(dip, time, _guard_at(system, mode, cause, time))
                if dip.value < -SLACK:
                    return _crossing_within(system, mode, cause, low, dip.middle)
    return INFINITY


def _crossing_within(system: System, mode: Mode, cause: int, low: float, high: float) -> float:
    """As `_crossing`, between times at which the guard has not been evaluated."""
    at_low = _guard_at(system, mode, cause, low)
    return _crossing(
        system, mode, cause, low, high, at_low, _guard_at(system, mode, cause, high)
    )  # fmt: skip


def _crossing(
    system: System, mode: Mode, cause: int, low: float, high: float, at_low: float, at_high: float
) -> float:
    """Time at which a guard vanishes between two times; if it jumps, a time after the jump."""
    if at_low <= 0.0:
        return low
    time = _root_of_guard(system, mode, cause, low, high, at_low, at_high, RESOLVED)
    step = RESOLVED * time
    while step > 0.0 and time < high and _guard_at(system, mode, cause, time) > SLACK:
        time, step = min(time + step, high), 2.0 * step
    return time
