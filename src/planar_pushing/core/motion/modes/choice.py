"""The choice of a mode: the consistent modes at an instant, and the one that the policy prefers."""

from __future__ import annotations

from planar_pushing.core.motion.kinematics.corner import leave_pocket
from planar_pushing.core.motion.kinematics.fence import policy_at, span_at
from planar_pushing.core.motion.kinematics.instant import Instant
from planar_pushing.core.motion.kinematics.mode import (
    KEEP_CONTACT,
    NO_MODE,
    Mode,
    contact_mode_of,
    is_preferred,
)
from planar_pushing.core.motion.kinematics.rolling import is_in_pocket
from planar_pushing.core.motion.kinematics.system import (
    CANDIDATE,
    CAUSES,
    ELSEWHERE,
    LATER_GUARDS,
    MOST_CANDIDATES,
    STATE,
    TRIAL,
    TRIAL_GUARDS,
    WATCHES,
    RunState,
    System,
    candidate_at,
    candidate_of,
    copy_numbers,
    guards_of,
    is_massive,
    pace_of,
    vector_of,
    with_candidates,
)
from planar_pushing.core.motion.kinematics.touch import count_points, hold_contact, put_contact
from planar_pushing.core.motion.kinematics.wall import clearance_of, put_wall
from planar_pushing.core.motion.modes.candidates import count_quasi_static, write_candidates
from planar_pushing.core.motion.modes.equations import write_rates
from planar_pushing.core.motion.modes.guards import write_guards
from planar_pushing.core.numbers import INFINITY, zeros
from planar_pushing.core.supports.rows import NO_POINT
from planar_pushing.core.supports.tolerances import NEAR_ZERO, NO_TREND, SLACK

#: Time over which the trend of a margin is evaluated, as a fraction of that in which the pusher moves by
#: one length.
AHEAD = 1e-5


def current_mode(system: System) -> Mode:
    """The chosen mode."""
    return candidate_at(system, system.run.chosen, system.run.piece)


def current_policy(system: System) -> int:
    """The policy in the current span of the pusher's motion."""
    return policy_at(system.fence, system.run.piece)


def _holds(system: System, mode: Mode, time: float, state: RunState, later: bool) -> bool:
    """Whether a mode holds at an instant, or a moment later."""
    if later:
        return _will_hold(system, mode, time, state)
    return _holds_at(system, mode, time, state)


def _holds_at(system: System, mode: Mode, time: float, state: RunState) -> bool:
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


def _will_hold(system: System, mode: Mode, time: float, state: RunState) -> bool:
    """Whether the margins of a mode are positive a moment later, for forces that jump at the instant."""
    later, lowest = guards_of(system, LATER_GUARDS), INFINITY
    _look_ahead(system, mode, time, state)
    for cause in range(CAUSES):
        if WATCHES[cause] == 0.0:
            lowest = min(lowest, later[cause])  # without the causes that have no guard
    return lowest >= -NEAR_ZERO


def _look_ahead(system: System, mode: Mode, time: float, state: RunState) -> None:
    """Store the guards of a mode a moment later."""
    during, trial = mode.during, vector_of(system, TRIAL)
    ahead = AHEAD * min(during.end - during.start, pace_of(system, during, time))
    write_rates(system, mode, time, state, trial)
    for k in range(system.entries):
        trial[k] = state[k] + ahead * trial[k]
    write_guards(system, mode, time + ahead, trial, guards_of(system, LATER_GUARDS))


def hold_candidate(system: System, state: RunState, index: int) -> None:
    """Make the contact of a candidate mode the contact."""
    candidate = candidate_of(system, index)
    if count_points(system) > 0:
        hold_contact(system, state, candidate.point, candidate.other_end)
    elif candidate.piece >= 0:
        leave_pocket(system, state, candidate.piece)


def _state_at_candidate(system: System, state: RunState, index: int) -> RunState:
    """The state at the contact of a candidate mode, which becomes the contact; the state is not changed."""
    if count_points(system) == 0:
        hold_candidate(system, state, index)
        return state
    elsewhere = vector_of(system, ELSEWHERE)
    copy_numbers(elsewhere, state, system.entries)
    hold_candidate(system, elsewhere, index)
    return elsewhere


def choose_mode(system: System, excludes: bool, point: int, other_end: int) -> bool:
    """Choose a consistent mode by the policy; return whether there is one.

    The contact modes that were misjudged can be excluded at a contact.
    """
    run, state, piece = system.run, vector_of(system, STATE), system.run.piece
    current, policy, time = run.mode, current_policy(system), run.time
    count = write_candidates(system, span_at(system.fence, piece), time, state)
    for i in range(count):
        candidate = candidate_of(system, i)
        same: bool = candidate.point == point and candidate.other_end == other_end
        contact = contact_mode_of(candidate_at(system, i, piece))
        if excludes and same and run.misjudged[contact] != 0.0:
            candidate.contact = NO_MODE
    chosen, solutions = _preferred_of_lasting(system, count, current, policy, time, state, False)
    if chosen < 0:
        chosen, solutions = _preferred_of_lasting(system, count, current, policy, time, state, True)
    contact = NO_MODE if chosen < 0 else contact_mode_of(candidate_at(system, chosen, piece))
    if chosen >= 0:
        hold_candidate(system, state, chosen)
    run.chosen, run.mode, run.solutions = (
        chosen,
        contact,
        solutions,
    )
    if contact != current and current != NO_MODE:
        run.changes += 1
    return chosen >= 0


def _preferred_of_lasting(
    system: System, candidates: int, current: int, policy: int,
    time: float, state: RunState, later: bool,
) -> tuple[int, int]:  # fmt: skip
    """The candidate that the policy prefers among those that hold, or will hold later; their number.

    The candidate is -1 without any.
    """
    run = system.run
    chosen, contact, count = -1, NO_MODE, 0
    point, other_end, pocket = run.point, run.other_end, NO_POINT
    if is_in_pocket(system):
        pocket = run.wall.piece
    for i in range(candidates):
        mode = candidate_at(system, i, run.piece)
        lasts: bool = mode.contact != NO_MODE
        if lasts:
            there = _state_at_candidate(system, state, i)
            lasts = _holds(system, mode, time, there, later)
            put_contact(system, point, other_end)
            if pocket >= 0 and not is_in_pocket(system):
                put_wall(system, pocket, 0.0, state.along)
        candidate_of(system, i).lasts = lasts
        if lasts and not _repeats(system, i):
            count += 1
            if is_preferred(policy, current, contact_mode_of(mode), contact):
                chosen, contact = i, contact_mode_of(mode)
    return chosen, count


def count_modes(system: System, mode: Mode, instant: Instant, time: float, state: RunState) -> int:
    """Number of consistent modes at an instant within a step; one if the contact is open."""
    if clearance_of(system, state) > SLACK:
        return 1
    if not is_massive(system):
        solutions = count_quasi_static(system, mode, instant, state)
        if solutions > 0:
            return solutions
    candidates = zeros(MOST_CANDIDATES * CANDIDATE)
    there = with_candidates(system, candidates)
    count = write_candidates(there, mode.during, time, state)
    _, number = _preferred_of_lasting(
        there,
        candidates=count,
        current=NO_MODE,
        policy=KEEP_CONTACT,
        time=time,
        state=state,
        later=False,
    )
    return max(number, 1)


def _repeats(system: System, index: int) -> bool:
    """Whether a candidate at an end of a side is the motion of the side, which lasts."""
    candidate = candidate_of(system, index)
    for i in range(index if candidate.barely_leaves else 0):
        other = candidate_of(system, i)
        same: bool = other.contact == candidate.contact and other.other_end >= 0
        if same and other.lasts:
            return True
    return False
