"""Event location: the guards of a mode are followed along the dense output of each step.

Each guard has a sign. One that begins at zero has none until it has left zero, and is then watched.
"""

from __future__ import annotations

from math import fabs

from planar_pushing.core.instant.solution import SEPARATE
from planar_pushing.core.motion.integration.explicit import MIDDLE_PART
from planar_pushing.core.motion.integration.integrator import interpolate_state
from planar_pushing.core.motion.kinematics.mode import Mode
from planar_pushing.core.motion.kinematics.run import Run
from planar_pushing.core.motion.kinematics.system import (
    CAUSES,
    CENTER_AT_POINT,
    END_OF_SIDE,
    END_VALUES,
    FIRST_RATES,
    KINK,
    MIDDLE_VALUES,
    SIGNS,
    TOUCHES,
    TRIAL,
    TRIAL_GUARDS,
    VALUES,
    WATCHES,
    System,
    copy_numbers,
    guards_of,
    is_massive,
    vector_of,
)
from planar_pushing.core.motion.modes.feet import leaving_speed
from planar_pushing.core.motion.modes.guards import write_guards
from planar_pushing.core.numbers import INFINITY
from planar_pushing.core.supports.roots import (
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
from planar_pushing.core.supports.tolerances import RESOLVED, SLACK

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
#: Cause of an event in flight, such as the end of a side beside a finger, which is not in the log.
UNNOTICED = -3


def _guard_at(system: System, mode: Mode, cause: int, time: float) -> float:
    """A guard at a time of the step, positive before its event."""
    trial, guards = vector_of(system, TRIAL), guards_of(system, TRIAL_GUARDS)
    interpolate_state(system, mode, time, trial)
    write_guards(system, mode, time, trial, guards)
    return -guards[cause] if guards_of(system, SIGNS)[cause] < 0.0 else guards[cause]


def sign_of_guard(cause: int, value: float) -> float:
    """Sign of a watch that is not near zero; for a margin, 1 if it is positive; 0 otherwise."""
    if value > SLACK:
        return 1.0
    return -1.0 if WATCHES[cause] == 1.0 and value < -SLACK else 0.0


def first_event(system: System, mode: Mode) -> int:
    """Store the time of the first event of a step; return its cause, `NOTHING`, or `MISJUDGED`.

    A mode is misjudged if a margin is negative from its start.
    """
    system.run.event_time, cause = system.run.until, NOTHING
    if _may_contain_event(system):
        cause = _search_step(system, mode)
    copy_numbers(guards_of(system, VALUES), guards_of(system, END_VALUES), CAUSES)
    return cause


def look_for_kink(system: System, mode: Mode) -> None:
    """Find a time at which the motion is not smooth in a trial step, and grade the steps toward it."""
    run, end = system.run, guards_of(system, END_VALUES)[KINK]
    if guards_of(system, SIGNS)[KINK] * end < -SLACK:
        slack = BEHIND_KINK * (run.until - run.time)
        first, last = fabs(guards_of(system, VALUES)[KINK]), -fabs(end)
        resolution = slack / (4.0 * run.until)
        kink = _root_of_guard(
            system,
            mode,
            KINK,
            low=run.time,
            high=run.until,
            at_low=first,
            at_high=last,
            resolution=resolution,
        )
        run.kink, run.kink_side = kink + slack, -1


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
        if WATCHES[cause] == 0.0 and _dips(values[cause], middle, end, MIDDLE_PART):
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
    """Store the time of the first event of a step, from the guards at nodes; return its cause."""
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
    system.run.event_time = min(first, system.run.until)
    return cause


def _node_time(run: Run, j: int) -> float:
    """Time of a node; node 0 is the start of the step."""
    if j == STEP_NODES:
        return run.until
    return run.time + float(j) / float(STEP_NODES) * (run.until - run.time)


def _event_of_cause(system: System, mode: Mode, cause: int) -> float:
    """Time of the first event of one cause in a step, infinite if there is none, -1 if misjudged."""
    run, signs = system.run, guards_of(system, SIGNS)
    watched: bool = WATCHES[cause] != 0.0
    for j in range(1, STEP_NODES + 1):
        low, high, sign = _node_time(run, j - 1), _node_time(run, j), signs[cause]
        before = guards_of(system, VALUES + j - 1)[cause]
        value = guards_of(system, VALUES + j)[cause]
        if sign * value < -SLACK:
            time = _crossing(
                system, mode, cause, low, high, at_low=sign * before, at_high=sign * value
            )
            farthest = leaving_speed(system, run.speed)
            if cause != CENTER_AT_POINT or fabs(_guard_at(system, mode, cause, time)) <= farthest:
                return time
            signs[cause] = -sign  # another point is the slowest, or the center is far from it
        if sign == 0.0:
            if cause == END_OF_SIDE and value < -SLACK:
                return _end_of_side_within(system, mode, low, high)
            signs[cause] = sign_of_guard(cause, value)
            if value < -SLACK and not watched:
                start = _time_of_rise(system, mode, cause, start=low, end=high)
                if start < 0.0 and mode.touches:
                    return INFINITY  # the pusher has not left the slider at rest
                if start < 0.0 and cause == TOUCHES and _opens(system, mode):
                    return _time_of_touch(system, mode, high)
                return start if start < 0.0 else _crossing_within(system, mode, cause, start, high)
    return INFINITY if watched else _time_of_dip(system, mode, cause)


def _end_of_side_within(system: System, mode: Mode, low: float, high: float) -> float:
    """When a finger that is at an end of its side leaves it: at once, or after it has moved inward."""
    start = _time_of_rise(system, mode, END_OF_SIDE, start=low, end=high)
    return low if start < 0.0 else _crossing_within(system, mode, END_OF_SIDE, start, high)


def _opens(system: System, mode: Mode) -> bool:
    """Whether the contact opens at the start of a step."""
    rates = vector_of(system, FIRST_RATES)
    if mode.contact != SEPARATE or not is_massive(system):
        return False
    return rates.gap > 0.0 or (rates.gap == 0.0 and rates.normal_speed > 0.0)


def _time_of_touch(system: System, mode: Mode, end: float) -> float:
    """A time at which a contact that opens by less than the tolerance has closed again."""
    low, high = system.run.time, end
    for _ in range(ITERATIONS):
        time = (low + high) / 2.0
        if not low < time < high:
            break
        if _guard_at(system, mode, TOUCHES, time) < -SLACK:
            high = time
        else:
            low = time
    return high


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
    """Time at which a guard vanishes between two times, at which it is evaluated here."""
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
