"""The choice of a mode: the consistent modes at an instant, and the one that the policy prefers."""

from __future__ import annotations

from planar_pushing.core.candidates import count_quasi_static, write_candidates
from planar_pushing.core.equations import write_guards, write_rates
from planar_pushing.core.fence import policy_at, span_at
from planar_pushing.core.instant import Instant
from planar_pushing.core.numbers import INFINITY, Numbers
from planar_pushing.core.run import (
    RUN_CHANGES,
    RUN_CHOSEN,
    RUN_COUNT,
    RUN_MODE,
    RUN_PIECE,
    RUN_SOLUTIONS,
    RUN_TIME,
)
from planar_pushing.core.shapes import clearance_of
from planar_pushing.core.system import (
    CANDIDATE,
    CAUSES,
    LATER_GUARDS,
    NO_MODE,
    STATE,
    TRIAL,
    TRIAL_GUARDS,
    WATCHES,
    Mode,
    System,
    candidate_at,
    contact_mode_of,
    guards_of,
    is_massive,
    is_preferred,
    pace_of,
    vector_of,
)
from planar_pushing.core.tolerances import NEAR_ZERO, NO_TREND, SLACK

#: Time over which the trend of a margin is evaluated, as a fraction of that in which the pusher moves by
#: one length.
AHEAD = 1e-5


def current_mode(system: System) -> Mode:
    """The chosen mode."""
    return candidate_at(system, int(system.run[RUN_CHOSEN]), int(system.run[RUN_PIECE]))


def current_policy(system: System) -> int:
    """The policy in the current span of the pusher's motion."""
    return policy_at(system.fence, int(system.run[RUN_PIECE]))


def _holds(system: System, mode: Mode, time: float, state: Numbers) -> bool:
    """Whether the margins of a mode are positive, or zero and not decreasing."""
    guards, later = guards_of(system, TRIAL_GUARDS), guards_of(system, LATER_GUARDS)
    write_guards(system, mode, time, state, guards)
    near: bool = False
    for cause in range(CAUSES):
        if WATCHES[cause] == 0.0:
            if guards[cause] < -NEAR_ZERO:
                return False
            near = near or guards[cause] <= NEAR_ZERO
    if not near:
        return True
    _look_ahead(system, mode, time, state)
    for cause in range(CAUSES):
        margin: bool = WATCHES[cause] == 0.0 and guards[cause] <= NEAR_ZERO
        if margin and not later[cause] >= guards[cause] - NO_TREND:
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


def choose_mode(system: System, excluded: int) -> bool:
    """Choose a consistent mode other than `excluded` by the policy; return whether there is one."""
    run, state, piece = system.run, vector_of(system, STATE), int(system.run[RUN_PIECE])
    current, time = int(run[RUN_MODE]), run[RUN_TIME]
    count = write_candidates(system, span_at(system.fence, piece), time, state)
    for i in range(count):
        if contact_mode_of(candidate_at(system, i, piece)) == excluded:
            system.candidates[i * CANDIDATE] = float(NO_MODE)
    run[RUN_COUNT] = float(count)
    chosen, solutions = _preferred_of_lasting(system, current, time, state, False)
    if chosen < 0:
        chosen, solutions = _preferred_of_lasting(system, current, time, state, True)
    contact = NO_MODE if chosen < 0 else contact_mode_of(candidate_at(system, chosen, piece))
    run[RUN_CHOSEN], run[RUN_MODE], run[RUN_SOLUTIONS] = (
        float(chosen),
        float(contact),
        float(solutions),
    )
    if contact != current and current != NO_MODE:
        run[RUN_CHANGES] += 1.0
    return chosen >= 0


def _preferred_of_lasting(
    system: System, current: int, time: float, state: Numbers, later: bool
) -> tuple[int, int]:
    """The candidate that the policy prefers among those that hold, or will hold later; their number.

    The candidate is -1 without any.
    """
    run, policy = system.run, current_policy(system)
    chosen, contact, count = -1, NO_MODE, 0
    for i in range(int(run[RUN_COUNT])):
        mode = candidate_at(system, i, int(run[RUN_PIECE]))
        lasts: bool = mode.contact != NO_MODE
        if lasts and later:
            lasts = _will_hold(system, mode, time, state)
        elif lasts:
            lasts = _holds(system, mode, time, state)
        if lasts:
            count += 1
            if is_preferred(policy, current, contact_mode_of(mode), contact):
                chosen, contact = i, contact_mode_of(mode)
    return chosen, count


def count_modes(system: System, mode: Mode, instant: Instant, time: float, state: Numbers) -> int:
    """Number of consistent modes at an instant within a step; one if the contact is open."""
    count, run = 1, system.run
    if clearance_of(system, state) > SLACK:
        return count
    if not is_massive(system):
        solutions = count_quasi_static(system, mode, instant, state)
        if solutions > 0:
            return solutions
    for i in range(int(run[RUN_COUNT])):
        other = candidate_at(system, i, int(run[RUN_PIECE]))
        known: bool = i == int(run[RUN_CHOSEN]) or other.contact == NO_MODE
        if not known and _holds(system, other, time, state):
            count += 1
    return count
