"""The modes that can follow an instant, also from rest."""

from __future__ import annotations

from math import fabs, sqrt

from planar_pushing.core.instant.flush_force import FlatSide
from planar_pushing.core.instant.flush_solutions import MOST_ON_SIDE, SIDE_SOLUTION, side_modes
from planar_pushing.core.instant.path import is_flat, sample_path
from planar_pushing.core.instant.solution import (
    MOST_SOLUTIONS,
    SEPARATE,
    SLIP_LEFT,
    SLIP_RIGHT,
    SOLUTION,
    STICK,
    Push,
    Solution,
)
from planar_pushing.core.motion.kinematics.corner import side_of_pocket, turn_to_side
from planar_pushing.core.motion.kinematics.drag import (
    depends_on_speed,
    problem_effects,
    put_loads_at,
    scale_films,
)
from planar_pushing.core.motion.kinematics.fence import Span
from planar_pushing.core.motion.kinematics.instant import Instant
from planar_pushing.core.motion.kinematics.mode import Mode, moving_mode, slip_side
from planar_pushing.core.motion.kinematics.posing import pose_at_start, pusher_along
from planar_pushing.core.motion.kinematics.rolling import is_in_pocket
from planar_pushing.core.motion.kinematics.shapes import (
    center_motion,
    pose_of,
    pusher_velocity,
    size_of_twist,
)
from planar_pushing.core.motion.kinematics.system import (
    CANDIDATE,
    ELSEWHERE,
    MOST_CANDIDATES,
    RunState,
    System,
    candidate_at,
    candidate_of,
    copy_numbers,
    is_massive,
    law_of,
    vector_of,
    write_candidate,
)
from planar_pushing.core.motion.kinematics.touch import (
    hold_contact,
    is_flush,
    leave_side,
    put_contact,
    side_length,
    side_on_fence,
)
from planar_pushing.core.motion.kinematics.wall import clearance_of
from planar_pushing.core.motion.modes.equations import motion_in_mode, path_along_fence
from planar_pushing.core.motion.modes.feet import slowest_foot_at, speed_at_center
from planar_pushing.core.motion.modes.inertia import (
    motion_beside_push,
    push_in_mode,
    slowest_motion,
)
from planar_pushing.core.motion.modes.side import MOST_OF_SIDE, modes_at_contact
from planar_pushing.core.motion.modes.starts import (
    push_at_start,
    write_free_start,
    write_rest,
    write_starts_at_contact,
)
from planar_pushing.core.numbers import Numbers, zeros
from planar_pushing.core.supports.roots import MOST_ROOTS
from planar_pushing.core.supports.rows import NO_POINT
from planar_pushing.core.supports.tolerances import (
    NEAR_ZERO,
    SLACK,
)


def write_candidates(system: System, during: Span, time: float, state: RunState) -> int:
    """Store the modes that can follow an instant; return their number."""
    if is_massive(system):
        return _write_with_inertia(system, during, time, state)
    return _write_quasi_static(system, during, time, state)


def _write_slip_candidate(system: System, index: int, contact: int, u_x: float, u_y: float) -> None:
    """Store a slip without inertia, with the motion of the contact.

    At an inner corner, it leaves along a side, and the motion is given in the frame of the corner.
    """
    candidate = write_candidate(system, index, contact)
    if is_in_pocket(system):
        u_x, u_y = turn_to_side(system, contact, u_x, u_y)
        candidate.piece = side_of_pocket(system, contact)
    candidate.motion.x, candidate.motion.y = u_x, u_y


def _write_at_contact(
    system: System, during: Span, time: float, state: RunState, count: int, starts: bool
) -> int:
    """Store, after other candidates, the modes of the contact; those of a slider at rest are starts."""
    if starts:
        return write_starts_at_contact(system, during, time, state, count)
    if is_massive(system):
        return _write_moving(system, during, time, state, count)
    return _write_quasi_static_at_contact(system, during, time, state, count)


def _write_at_side(
    system: System, during: Span, time: float, state: RunState, count: int, starts: bool
) -> int:
    """Store the modes of a point, or of a side and its lifting ends, after other candidates."""
    count = _write_at_contact(system, during, time, state, count, starts)
    if not is_flush(system):
        return count
    run, there = system.run, vector_of(system, ELSEWHERE)
    point, other_end, length = (
        run.point,
        run.other_end,
        side_length(system, state),
    )
    for i in range(2):
        copy_numbers(there, state, system.entries)
        hold_contact(system, there, point if i == 0 else other_end, NO_POINT)
        first = count
        count = _write_at_contact(system, during, time, there, count, starts)
        count = _keep_leaving(system, during, time, there, length, first, count)
        length = -length
    put_contact(system, point, other_end)
    return count


def _keep_leaving(
    system: System,
    during: Span,
    time: float,
    state: RunState,
    length: float,
    first: int,
    count: int,
) -> int:
    """Keep those of the last candidates that lift the other end of a side of a signed length."""
    kept, slack, massive = first, SLACK * system.run.speed, is_massive(system)
    if massive:
        slack = SLACK * system.run.force / system.scene.mass
    for i in range(first, count):
        mode = candidate_at(system, i, during.first)
        instant = motion_in_mode(system, mode, time, state)
        lift = (instant.turn if massive else instant.spin) * length
        candidate_of(system, i).barely_leaves = lift <= slack
        if mode.contact != SEPARATE and lift >= -slack:
            copy_numbers(
                system.candidates[kept * CANDIDATE :], system.candidates[i * CANDIDATE :], CANDIDATE
            )
            kept += 1
    return kept


# Without inertia


def _write_quasi_static(system: System, during: Span, time: float, state: RunState) -> int:
    if clearance_of(system, state) > SLACK:
        write_rest(system, index=0, touches=False, contact=SEPARATE, f_x=0.0, f_y=0.0)
        return 1
    write_rest(system, index=0, touches=True, contact=SEPARATE, f_x=0.0, f_y=0.0)
    x, y = pusher_velocity(system, during, time, state)
    if x == 0.0 and y == 0.0 and during.constant:
        return 1
    return _write_at_side(system, during, time, state, 1, False)


def _write_quasi_static_at_contact(
    system: System, during: Span, time: float, state: RunState, count: int
) -> int:
    """Store the stick and the slips of the contact after the candidates so far."""
    x, y = pusher_velocity(system, during, time, state)
    write_candidate(system, count, STICK)
    count += 1
    if not system.scene.slips:
        return count
    if depends_on_speed(system):
        count = _write_slips_at_speed(system, state, x, y, count)
    # Slips that begin at the stick.
    for contact in range(SLIP_RIGHT, SLIP_LEFT + 1):
        _write_slip_candidate(system, count, contact, x, y)
        count += 1
    return count


def _write_slips_at_speed(system: System, state: RunState, x: float, y: float, count: int) -> int:
    """Store each slip as a candidate, for forces that depend on the speed."""
    solutions = zeros(MOST_OF_SIDE * SOLUTION)
    size = sqrt(x * x + y * y)
    for i in range(_solve_at_speed(system, state, x, y, solutions)):
        solution = Solution(solutions[i * SOLUTION :])
        contact = solution.mode
        if slip_side(contact) != 0.0 and count < MOST_CANDIDATES - 2:
            u_y = size * solution.motion.y if is_in_pocket(system) else y
            _write_slip_candidate(system, count, contact, size * solution.motion.x, u_y)
            count += 1
    return count


def _solve_at_speed(system: System, state: RunState, x: float, y: float, solutions: Numbers) -> int:
    """Store the contact modes of a pusher's motion without inertia, in its units; return their number."""
    size = sqrt(x * x + y * y)
    scale_films(system, size if size > 0.0 else 1.0)
    put_loads_at(system, state.angle)
    pose, length = pose_at_start(system, state), side_length(system, state)
    count = modes_at_contact(system, pose, length, x, y, spin=0.0, unit=size, solutions=solutions)
    scale_films(system, 1.0)
    return count


def count_quasi_static(system: System, mode: Mode, instant: Instant, state: RunState) -> int:
    """Number of contact modes at an instant without inertia, `UNSOLVED` if it is not known.

    With effects of one degree the force across an edge increases along the fence. A slip of a pusher that
    advances is then the only mode, unless this force vanishes on a stretch.
    """
    x, y = instant.fence_x, instant.fence_y
    size, slips = sqrt(x * x + y * y), slip_side(mode.contact) * instant.slip > SLACK * fabs(y)
    left, right = side_on_fence(system, state)
    if left >= 0:
        return _count_at_side(system, state, left, right, x, y)
    if slips and y > 0.0 and not depends_on_speed(system):
        path = path_along_fence(
            system,
            problem_effects(system),
            pose_of(system, state),
            mode.contact,
            normal=y,
            side=1.0,
        )
        sample = sample_path(path, x + instant.slip, instant.spin, instant.pivot)
        if not is_flat(path, sample, size + fabs(instant.slip)):
            return 1
    solutions = zeros(MOST_SOLUTIONS * SOLUTION)
    return _solve_at_speed(system, state, x, y, solutions)


def _count_at_side(
    system: System, state: RunState, left: int, right: int, x: float, y: float
) -> int:
    """Number of contact modes of a side on the fence and of its ends; `UNSOLVED` if it is not known."""
    run, there = system.run, vector_of(system, ELSEWHERE)
    point, other_end = run.point, run.other_end
    copy_numbers(there, state, system.entries)
    hold_contact(system, there, left, right)
    pose, size = pose_at_start(system, there), sqrt(x * x + y * y)
    scale_films(system, size if size > 0.0 else 1.0)
    put_loads_at(system, there.angle)
    solutions = zeros(MOST_ON_SIDE * SIDE_SOLUTION)
    push = Push(problem_effects(system), pose.contact, pose.rod.x, -pose.rod.y)
    count = side_modes(
        push, FlatSide(0.0, side_length(system, there)), law_of(system, pose.rod),
        pusher_along(pose, x, y, 1.0 if size > 0.0 else 0.0), solutions,
    )  # fmt: skip
    scale_films(system, 1.0)
    put_contact(system, point, other_end)
    return count


def note_slip(system: System, time: float, state: RunState, index: int, mode: Mode) -> None:
    """Store the slip at the end of a step, from which the next step follows it."""
    if not is_massive(system) and depends_on_speed(system) and slip_side(mode.contact) != 0.0:
        instant = motion_in_mode(system, mode, time, state)
        u_x = instant.fence_x + instant.slip
        _write_slip_candidate(system, index, mode.contact, u_x, u_y=instant.fence_y)


# With inertia


def _write_with_inertia(system: System, during: Span, time: float, state: RunState) -> int:
    pose, speed = pose_of(system, state), system.run.speed
    fence_x, fence_y = pusher_velocity(system, during, time, state)
    v_x, v_y = center_motion(
        pose, fence_x + state.slip_speed, fence_y + state.normal_speed, state.spin
    )
    clear: bool = clearance_of(system, state) > SLACK or fabs(state.normal_speed) > SLACK * speed
    contact = SLIP_LEFT if fabs(state.slip_speed) > SLACK * speed else STICK
    pushed = push_in_mode(SEPARATE if clear else contact, fence_x, fence_y)
    size = motion_beside_push(system, size_of_twist(v_x, v_y, state.spin), pushed)
    # A slider this slow is about to stop; above it, its guard is positive.
    rests: bool = size <= (slowest_motion(system) + 2.0 * SLACK) * speed
    rests = rests and system.scene.weight > 0.0
    if clear:
        if rests:
            return write_free_start(system, state)
        foot = _foot_at_center(system, during, time, state)
        return _write_in_motion(system, during, time, state, contact=SEPARATE, foot=foot, count=0)
    if rests:
        return write_starts(system, during, time, state)
    return _write_at_side(system, during, time, state, 0, False)


def _write_moving(system: System, during: Span, time: float, state: RunState, count: int) -> int:
    """Store the modes of a moving slider that touches the fence after the candidates so far."""
    slack, slip = SLACK * system.run.speed, state.slip_speed
    foot = _foot_at_center(system, during, time, state)
    if count == 0 and _separates(system, during, time, state, foot):
        count = _write_in_motion(system, during, time, state, SEPARATE, foot, count)
    if fabs(slip) <= slack:
        count = _write_in_motion(system, during, time, state, STICK, foot, count)
    for contact in range(SLIP_RIGHT, SLIP_LEFT + 1):
        if system.scene.slips and slip_side(contact) * slip >= -slack:
            count = _write_in_motion(system, during, time, state, contact, foot, count)
    return count


def _foot_at_center(system: System, during: Span, time: float, state: RunState) -> int:
    """Number of the support point at the center of rotation, -1 without one."""
    fence_x, fence_y = pusher_velocity(system, during, time, state)
    pose, spin = pose_of(system, state), state.spin
    v_x, v_y = center_motion(pose, fence_x + state.slip_speed, fence_y + state.normal_speed, spin)
    foot = slowest_foot_at(system, pose, v_x, v_y, spin)
    slowest = speed_at_center(system, size_of_twist(v_x, v_y, spin))
    return foot.number if foot.speed <= slowest else NO_POINT


def _separates(system: System, during: Span, time: float, state: RunState, foot: int) -> bool:
    """Whether the contact opens without a contact force, or barely does not: then the trend decides."""
    hinged = _is_held(system, during, time, state, SEPARATE, foot)
    mode = moving_mode(SEPARATE, foot, hinged, departure=1, during=during)
    lift = motion_in_mode(system, mode, time, state).lift
    return lift >= -NEAR_ZERO * system.run.force / system.scene.mass


def _is_held(
    system: System, during: Span, time: float, state: RunState, contact: int, foot: int
) -> bool:
    """Whether friction can hold the support point at the center of rotation in a contact mode."""
    if foot < 0 or contact == STICK:
        return False
    mode = moving_mode(contact, foot, hinged=True, departure=1, during=during)
    return motion_in_mode(system, mode, time, state).hold > SLACK


def _write_in_motion(
    system: System, during: Span, time: float, state: RunState, contact: int, foot: int, count: int
) -> int:
    """Store the modes of a moving slider with a contact mode after the candidates so far.

    Friction holds a support point at the center of rotation, or the point leaves; in a slip both can hold.
    """
    first = count
    if _is_held(system, during, time, state, contact, foot):
        candidate = write_candidate(system, count, contact)
        candidate.foot, candidate.hinged = foot, True
        count += 1
    for departure in range(1, MOST_ROOTS + 1 if foot >= 0 and contact != STICK else 2):
        mode = moving_mode(contact, foot, hinged=False, departure=departure, during=during)
        if count == first or motion_in_mode(system, mode, time, state).hold > 0.0:
            candidate = write_candidate(system, count, contact)
            candidate.foot, candidate.departure = foot, departure
            count += 1
    for i in range(first, count if contact == SEPARATE else first):
        leave_side(system, i)
    return count


def write_starts(system: System, during: Span, time: float, state: RunState) -> int:
    """Store all modes in which a slider at rest on the fence can start."""
    _, _, unit = push_at_start(system, during, time, state)
    if unit == 0.0:
        write_rest(system, index=0, touches=True, contact=SEPARATE, f_x=0.0, f_y=0.0)
        return 1
    return _write_at_side(system, during, time, state, 0, True)
