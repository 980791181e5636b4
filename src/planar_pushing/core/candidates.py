"""The modes that can follow an instant, also from rest."""

from __future__ import annotations

from math import copysign, fabs, sqrt

from planar_pushing.core.drag import (
    depends_on_speed,
    friction_effects,
    problem_effects,
    put_loads_at,
    scale_films,
)
from planar_pushing.core.equations import motion_in_mode, path_along_fence
from planar_pushing.core.feet import slowest_foot_at, speed_at_center
from planar_pushing.core.fence import Span
from planar_pushing.core.flush_force import FLUSH_SOLUTION, FlatSide
from planar_pushing.core.flush_solutions import MOST_ON_SIDE, SIDE_SOLUTION, side_modes
from planar_pushing.core.free import free_twist
from planar_pushing.core.inertia import motion_beside_push, push_in_mode, slowest_motion
from planar_pushing.core.instant import Instant
from planar_pushing.core.numbers import Numbers, zeros
from planar_pushing.core.path import is_flat, sample_path
from planar_pushing.core.posing import modes_of_push, pose_at_start, prepare_start, pusher_along
from planar_pushing.core.rows import NO_POINT, Vector, foot_position
from planar_pushing.core.run import (
    IN_MASS,
    IN_SLIPS,
    IN_WEIGHT,
    RUN_FORCE,
    RUN_OTHER_END,
    RUN_POINT,
    RUN_SPEED,
)
from planar_pushing.core.shapes import (
    Pose,
    center_motion,
    clearance_of,
    pose_of,
    pusher_acceleration,
    pusher_velocity,
    size_of_twist,
    to_contact,
)
from planar_pushing.core.side import MOST_OF_SIDE, flush_or_free_modes, offset_in_solution
from planar_pushing.core.solution import (
    FORCE,
    MODE,
    MOST_SOLUTIONS,
    MOTION,
    PIVOT,
    SEPARATE,
    SLIP_LEFT,
    SLIP_RIGHT,
    SOLUTION,
    STICK,
    TWIST,
    Push,
)
from planar_pushing.core.system import (
    ANGLE,
    BARELY_LEAVES,
    CANDIDATE,
    ELSEWHERE,
    MOST_CANDIDATES,
    NORMAL_SPEED,
    REST,
    SLIP_SPEED,
    SPIN,
    Mode,
    System,
    candidate_at,
    copy_numbers,
    is_loaded,
    is_massive,
    law_of,
    pace_of,
    slip_side,
    vector_of,
    write_candidate,
)
from planar_pushing.core.tolerances import (
    AT_REST,
    NEAR_ZERO,
    NO_DIRECTION,
    PASSES,
    PUSHER_AT_REST,
    SLACK,
)
from planar_pushing.core.touch import (
    hold_contact,
    is_flush,
    leave_side,
    put_contact,
    side_length,
    side_on_fence,
)

#: Tangential acceleration, in units of the normal one, that represents a fence already slipping at a
#: contact.
ALREADY_SLIPS = 1e6
#: The same, in units of the fastest slip that this fence causes.
FASTER = 4.0


def write_candidates(system: System, during: Span, time: float, state: Numbers) -> int:
    """Store the modes that can follow an instant; return their number."""
    if is_massive(system):
        return _write_with_inertia(system, during, time, state)
    return _write_quasi_static(system, during, time, state)


def _write_rest(
    system: System, index: int, touches: bool, contact: int, f_x: float, f_y: float
) -> None:
    write_candidate(system, index, REST, NO_POINT, False, touches, f_x, f_y, float(contact))


def _write_contact(system: System, index: int, contact: int, x: float, y: float) -> None:
    write_candidate(system, index, contact, NO_POINT, False, False, x, y, 0.0)


def _write_ends(
    system: System, during: Span, time: float, state: Numbers, count: int, starts: bool
) -> int:
    """Store, after other candidates, the modes at either end of a side that lift its other end.

    The modes of a slider at rest are starts.
    """
    run, there = system.run, vector_of(system, ELSEWHERE)
    point, other_end, length = (
        int(run[RUN_POINT]),
        int(run[RUN_OTHER_END]),
        side_length(system, state),
    )
    for i in range(2):
        copy_numbers(there, state, system.entries)
        hold_contact(system, there, point if i == 0 else other_end, NO_POINT)
        first = count
        if starts:
            count = _write_starts_at_contact(system, during, time, there, count)
        elif is_massive(system):
            count = _write_in_motion(system, during, time, there, STICK, SLIP_LEFT, count)
        else:
            count = _write_quasi_static_at_contact(system, during, time, there, count)
        count = _keep_leaving(system, during, time, there, length, first, count)
        length = -length
    put_contact(system, point, other_end)
    return count


def _keep_leaving(
    system: System, during: Span, time: float, state: Numbers, length: float, first: int, count: int
) -> int:
    """Keep those of the last candidates that lift the other end of a side of a signed length."""
    kept, slack, massive = first, SLACK * system.run[RUN_SPEED], is_massive(system)
    if massive:
        slack = SLACK * system.run[RUN_FORCE] / system.scene[IN_MASS]
    for i in range(first, count):
        mode = candidate_at(system, i, during.first)
        instant = motion_in_mode(system, mode, time, state)
        lift = (instant.turn if massive else instant.spin) * length
        system.candidates[i * CANDIDATE + BARELY_LEAVES] = 1.0 if lift <= slack else 0.0
        if mode.contact != SEPARATE and lift >= -slack:
            copy_numbers(
                system.candidates[kept * CANDIDATE :], system.candidates[i * CANDIDATE :], CANDIDATE
            )
            kept += 1
    return kept


# Without inertia


def _write_quasi_static(system: System, during: Span, time: float, state: Numbers) -> int:
    if clearance_of(system, state) > SLACK:
        _write_rest(system, 0, False, SEPARATE, 0.0, 0.0)
        return 1
    _write_rest(system, 0, True, SEPARATE, 0.0, 0.0)
    x, y = pusher_velocity(system, during, time, state)
    if x == 0.0 and y == 0.0 and during.constant:
        return 1
    count = _write_quasi_static_at_contact(system, during, time, state, 1)
    if is_flush(system):
        count = _write_ends(system, during, time, state, count, False)
    return count


def _write_quasi_static_at_contact(
    system: System, during: Span, time: float, state: Numbers, count: int
) -> int:
    """Store the stick and the slips of the contact after the candidates so far."""
    x, y = pusher_velocity(system, during, time, state)
    _write_contact(system, count, STICK, 0.0, 0.0)
    count += 1
    if system.scene[IN_SLIPS] == 0.0:
        return count
    if depends_on_speed(system):
        count = _write_slips_at_speed(system, state, x, y, count)
    # Slips that begin at the stick.
    for contact in range(SLIP_RIGHT, SLIP_LEFT + 1):
        _write_contact(system, count, contact, x, y)
        count += 1
    return count


def _write_slips_at_speed(system: System, state: Numbers, x: float, y: float, count: int) -> int:
    """Store each slip as a candidate, for forces that depend on the speed."""
    solutions = zeros(MOST_OF_SIDE * FLUSH_SOLUTION)
    size, width = sqrt(x * x + y * y), FLUSH_SOLUTION if is_flush(system) else SOLUTION
    for i in range(_solve_at_speed(system, state, x, y, solutions)):
        solution = solutions[i * width :]
        contact = int(solution[MODE])
        if slip_side(contact) != 0.0 and count < MOST_CANDIDATES - 2:
            _write_contact(system, count, contact, size * solution[MOTION], y)
            count += 1
    return count


def _solve_at_speed(system: System, state: Numbers, x: float, y: float, solutions: Numbers) -> int:
    """Store the contact modes of a pusher's motion without inertia, in its units; return their number."""
    size = sqrt(x * x + y * y)
    scale_films(system, size if size > 0.0 else 1.0)
    put_loads_at(system, state[ANGLE])
    pose, part, count = pose_at_start(system, state), 1.0 if size > 0.0 else 0.0, 0
    if is_flush(system):
        unit = size if size > 0.0 else 1.0
        count = flush_or_free_modes(
            system, pose, side_length(system, state), x / unit, y / unit, 0.0, solutions
        )
    else:
        count, _ = modes_of_push(system, pose, x, y, part, solutions)
    scale_films(system, 1.0)
    return count


def count_quasi_static(system: System, mode: Mode, instant: Instant, state: Numbers) -> int:
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
            system, problem_effects(system), pose_of(system, state), mode.contact, y, 1.0
        )
        sample = sample_path(path, x + instant.slip, instant.spin, instant.pivot)
        if not is_flat(path, sample, size + fabs(instant.slip)):
            return 1
    solutions = zeros(MOST_SOLUTIONS * SOLUTION)
    return _solve_at_speed(system, state, x, y, solutions)


def _count_at_side(
    system: System, state: Numbers, left: int, right: int, x: float, y: float
) -> int:
    """Number of contact modes of a side on the fence and of its ends; `UNSOLVED` if it is not known."""
    run, there = system.run, vector_of(system, ELSEWHERE)
    point, other_end = int(run[RUN_POINT]), int(run[RUN_OTHER_END])
    copy_numbers(there, state, system.entries)
    hold_contact(system, there, left, right)
    pose, size = pose_at_start(system, there), sqrt(x * x + y * y)
    scale_films(system, size if size > 0.0 else 1.0)
    put_loads_at(system, there[ANGLE])
    solutions = zeros(MOST_ON_SIDE * SIDE_SOLUTION)
    push = Push(problem_effects(system), pose.contact, pose.rod.x, -pose.rod.y)
    count = side_modes(
        push, FlatSide(0.0, side_length(system, there)), law_of(system, pose.rod),
        pusher_along(pose, x, y, 1.0 if size > 0.0 else 0.0), solutions,
    )  # fmt: skip
    scale_films(system, 1.0)
    put_contact(system, point, other_end)
    return count


def note_slip(system: System, time: float, state: Numbers, index: int, mode: Mode) -> None:
    """Store the slip at the end of a step, from which the next step follows it."""
    if not is_massive(system) and depends_on_speed(system) and slip_side(mode.contact) != 0.0:
        instant = motion_in_mode(system, mode, time, state)
        _write_contact(system, index, mode.contact, instant.fence_x + instant.slip, instant.fence_y)


# With inertia


def _write_with_inertia(system: System, during: Span, time: float, state: Numbers) -> int:
    pose, speed = pose_of(system, state), system.run[RUN_SPEED]
    fence_x, fence_y = pusher_velocity(system, during, time, state)
    v_x, v_y = center_motion(
        pose, fence_x + state[SLIP_SPEED], fence_y + state[NORMAL_SPEED], state[SPIN]
    )
    clear: bool = clearance_of(system, state) > SLACK or fabs(state[NORMAL_SPEED]) > SLACK * speed
    contact = SLIP_LEFT if fabs(state[SLIP_SPEED]) > SLACK * speed else STICK
    pushed = push_in_mode(SEPARATE if clear else contact, fence_x, fence_y)
    size = motion_beside_push(system, size_of_twist(v_x, v_y, state[SPIN]), pushed)
    # A slider this slow is about to stop; above it, its guard is positive.
    rests: bool = size <= (slowest_motion(system) + 2.0 * SLACK) * speed
    rests = rests and system.scene[IN_WEIGHT] > 0.0
    if clear:
        if rests:
            return _write_clear(system, state)
        return _write_in_motion(system, during, time, state, SEPARATE, SEPARATE, 0)
    if rests:
        return write_starts(system, during, time, state)
    count = _write_in_motion(system, during, time, state, SEPARATE, SLIP_LEFT, 0)
    if is_flush(system):
        count = _write_ends(system, during, time, state, count, False)
    return count


def _write_in_motion(
    system: System, during: Span, time: float, state: Numbers, first: int, last: int, count: int
) -> int:
    """Store the candidates of a moving slider, from one contact mode to another, after those so far."""
    slack, slip, pose = SLACK * system.run[RUN_SPEED], state[SLIP_SPEED], pose_of(system, state)
    fence_x, fence_y = pusher_velocity(system, during, time, state)
    v_x, v_y = center_motion(pose, fence_x + slip, fence_y + state[NORMAL_SPEED], state[SPIN])
    foot = slowest_foot_at(system, pose, v_x, v_y, state[SPIN])
    slowest = speed_at_center(system, size_of_twist(v_x, v_y, state[SPIN]))
    near = foot.number if foot.speed <= slowest else NO_POINT
    for contact in range(first, last + 1):
        mode = Mode(contact, near, True, False, 0.0, 0.0, 0.0, 0.0, during)
        hinged: bool = near >= 0 and contact != STICK
        if hinged:
            hinged = motion_in_mode(system, mode, time, state).hold > SLACK
        mode = Mode(contact, near, hinged, False, 0.0, 0.0, 0.0, 0.0, during)
        fits: bool = system.scene[IN_SLIPS] != 0.0 and slip_side(contact) * slip >= -slack
        if contact == SEPARATE:
            fits = last == SEPARATE
            if not fits:
                lift = motion_in_mode(system, mode, time, state).lift
                fits = lift >= -NEAR_ZERO * system.run[RUN_FORCE] / system.scene[IN_MASS]
        elif contact == STICK:
            fits = fabs(slip) <= slack
        if fits:
            write_candidate(system, count, contact, near, hinged, False, 0.0, 0.0, 0.0)
            if contact == SEPARATE:
                leave_side(system, count)
            count += 1
    return count


def _write_clear(system: System, state: Numbers) -> int:
    """Store the mode of a slider at rest above the fence: friction holds it, or loads set it in motion."""
    size = system.run[RUN_FORCE] / system.scene[IN_MASS]
    prepare_start(system, state, size)
    start = free_twist(problem_effects(system), Vector(0.0, 0.0, 0.0))
    _write_rest(system, 0, False, SEPARATE, 0.0, 0.0)
    if start.x != 0.0 or start.y != 0.0 or start.spin != 0.0:
        pose = pose_of(system, state)
        x, y = to_contact(pose.rod, size * start.x, size * start.y)
        _write_start(system, pose, 0, SEPARATE, NO_POINT, x, y, size * start.spin)
    return 1


def write_starts(system: System, during: Span, time: float, state: Numbers) -> int:
    """Store all modes in which a slider at rest on the fence can start."""
    _, _, unit = _push_at_start(system, during, time, state)
    if unit == 0.0:
        _write_rest(system, 0, True, SEPARATE, 0.0, 0.0)
        return 1
    count = _write_starts_at_contact(system, during, time, state, 0)
    if is_flush(system):
        count = _write_ends(system, during, time, state, count, True)
    return count


def _push_at_start(
    system: System, during: Span, time: float, state: Numbers
) -> tuple[float, float, float]:
    """Acceleration of a pusher that meets a slider at rest, and the unit of accelerations, 0 at rest."""
    slip, unit = state[SLIP_SPEED], 0.0
    x, y, moves = _pusher_at_start(system, during, time, state)
    if not moves and not is_loaded(system):
        return 0.0, 0.0, 0.0
    if not moves:
        x, y = 0.0, 0.0
    if is_loaded(system):
        unit = system.run[RUN_FORCE] / system.scene[IN_MASS]
    if _slides(system, slip):
        # The fence already slips at the contact, so only its normal motion matters.
        fast = ALREADY_SLIPS * max(fabs(y), unit)
        x = -fast if slip > 0.0 else fast
    return x, y, max(sqrt(x * x + y * y), unit)


def _slides(system: System, slip: float) -> bool:
    """Whether the pusher already slips at a slider at rest."""
    return fabs(slip) > AT_REST * system.run[RUN_SPEED]


def _write_starts_at_contact(
    system: System, during: Span, time: float, state: Numbers, count: int
) -> int:
    """Store, after other candidates, the modes in which a slider at rest can start at the contact."""
    slip, pose = state[SLIP_SPEED], pose_at_start(system, state)
    x, y, unit = _push_at_start(system, during, time, state)
    solutions = zeros(MOST_OF_SIDE * FLUSH_SOLUTION)
    width = FLUSH_SOLUTION if is_flush(system) else SOLUTION
    length = side_length(system, state) if is_flush(system) else 0.0
    number = _solve_start(system, state, pose, x, y, unit, solutions)
    if _slides(system, slip):
        # In units of a pusher this fast the slips have lost digits. A slower one has the same slips.
        slowest = unit / ALREADY_SLIPS
        fastest = unit * _fastest_slip(slip, number, width, solutions)
        x = -copysign(FASTER * (fastest if fastest > 0.0 else slowest), slip)
        unit = max(sqrt(x * x + y * y), slowest)
        number = _solve_start(system, state, pose, x, y, unit, solutions)
    for i in range(number):
        solution = solutions[i * width :]
        contact, point = int(solution[MODE]), int(solution[PIVOT])
        # A start has the same direction of slip, or no contact force.
        if _slides(system, slip) and contact != SEPARATE and slip_side(contact) * slip <= 0.0:
            continue
        if solution[TWIST] == 0.0 and solution[TWIST + 1] == 0.0 and solution[TWIST + 2] == 0.0:
            f_x, f_y = solution[FORCE], solution[FORCE + 1]
            _write_rest(system, count, True, contact, f_x, f_y)
            if is_flush(system):
                numbers = system.candidates[count * CANDIDATE :]
                numbers[9] = offset_in_solution(solution, length)
        else:
            _write_start(
                system, pose, count, contact, point,
                unit * solution[TWIST], unit * solution[TWIST + 1], unit * solution[TWIST + 2],
            )  # fmt: skip
            if contact == SEPARATE:
                leave_side(system, count)
        count += 1
    return count


def _solve_start(
    system: System, state: Numbers, pose: Pose, x: float, y: float, unit: float, solutions: Numbers
) -> int:
    """Store the contact modes of a slider at rest, for an acceleration of the pusher, in a unit."""
    prepare_start(system, state, unit)
    if is_flush(system):
        return flush_or_free_modes(
            system, pose, side_length(system, state), x / unit, y / unit, 0.0, solutions
        )
    number, _ = modes_of_push(system, pose, x, y, sqrt(x * x + y * y) / unit, solutions)
    return number


def _fastest_slip(slip: float, number: int, width: int, solutions: Numbers) -> float:
    """Largest component of the contact's motion in those solutions that slip in the direction of `slip`."""
    fastest = 0.0
    for i in range(number):
        solution = solutions[i * width :]
        contact = int(solution[MODE])
        if contact != SEPARATE and slip_side(contact) * slip > 0.0:
            fastest = max(fastest, max(fabs(solution[MOTION]), fabs(solution[MOTION + 1])))
    return fastest


def _write_start(
    system: System,
    pose: Pose,
    index: int,
    contact: int,
    point: int,
    x: float,
    y: float,
    spin: float,
) -> None:
    """Store the start of a slider with an acceleration; one about a support point begins about it."""
    foot = slowest_foot_at(system, pose, x, y, spin)
    if contact != STICK and not is_flush(system) and foot.number >= 0:
        size = foot.speed * max(size_of_twist(x, y, spin), NO_DIRECTION * system.run[RUN_SPEED])
        if size <= PASSES * size_of_twist(x, y, spin):
            position = foot_position(friction_effects(system), foot.number)
            f_x, f_y = to_contact(pose.rod, position.x, position.y)
            x, y, point = spin * f_y, -spin * f_x, foot.number
    hinged: bool = point >= 0 and contact != STICK
    write_candidate(system, index, contact, point, hinged, False, x, y, spin)


def _pusher_at_start(
    system: System, during: Span, time: float, state: Numbers
) -> tuple[float, float, bool]:
    """Acceleration of the pusher, and whether the pusher moves."""
    b_x, b_y = pusher_acceleration(system, during, time, state)
    w_x, w_y = pusher_velocity(system, during, time, state)
    size = sqrt(b_x * b_x + b_y * b_y)
    slowest = PUSHER_AT_REST * system.run[RUN_SPEED]
    if sqrt(w_x * w_x + w_y * w_y) > slowest:
        return b_x, b_y, size > 0.0
    moves: bool = size > slowest / pace_of(system, during, time)
    return b_x, 0.0 if fabs(b_y) <= AT_REST * size else b_y, moves
