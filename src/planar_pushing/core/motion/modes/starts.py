"""The modes in which a slider at rest can start: pushes from rest, by the acceleration of the pusher."""

from __future__ import annotations

from math import copysign, fabs, sqrt

from planar_pushing.core.instant.solution import (
    SEPARATE,
    SOLUTION,
    STICK,
    Solution,
)
from planar_pushing.core.motion.kinematics.drag import friction_effects, problem_effects
from planar_pushing.core.motion.kinematics.fence import Span
from planar_pushing.core.motion.kinematics.mode import REST, slip_side
from planar_pushing.core.motion.kinematics.posing import pose_at_start, prepare_start
from planar_pushing.core.motion.kinematics.shapes import (
    Pose,
    pose_of,
    pusher_acceleration,
    pusher_velocity,
    size_of_twist,
    to_contact,
)
from planar_pushing.core.motion.kinematics.system import (
    RunState,
    System,
    candidate_of,
    is_loaded,
    pace_of,
    write_candidate,
)
from planar_pushing.core.motion.kinematics.touch import is_flush, leave_side, side_length
from planar_pushing.core.motion.modes.feet import slowest_foot_at
from planar_pushing.core.motion.modes.side import MOST_OF_SIDE, modes_at_contact, offset_in_solution
from planar_pushing.core.numbers import Numbers, zeros
from planar_pushing.core.supports.free import free_twist
from planar_pushing.core.supports.rows import NO_POINT, Vector, foot_position
from planar_pushing.core.supports.tolerances import AT_REST, NO_DIRECTION, PASSES, PUSHER_AT_REST

#: Tangential acceleration, in units of the normal one, that represents a fence already slipping at a
#: contact.
ALREADY_SLIPS = 1e6
#: The same, in units of the fastest slip that this fence causes.
FASTER = 4.0


def write_rest(
    system: System, index: int, touches: bool, contact: int, f_x: float, f_y: float
) -> None:
    """Store a slider at rest, with a force of the pusher in a contact mode, as a candidate."""
    candidate = write_candidate(system, index, REST)
    candidate.touches, candidate.rests_in = touches, contact
    candidate.force.x, candidate.force.y = f_x, f_y


def write_free_start(system: System, state: RunState) -> int:
    """Store the mode of a slider at rest above the fence: friction holds it, or loads set it in motion."""
    size = system.run.force / system.scene.mass
    prepare_start(system, state, size)
    start = free_twist(problem_effects(system), Vector(0.0, 0.0, 0.0))
    write_rest(system, index=0, touches=False, contact=SEPARATE, f_x=0.0, f_y=0.0)
    if start.x != 0.0 or start.y != 0.0 or start.spin != 0.0:
        pose = pose_of(system, state)
        x, y = to_contact(pose.rod, size * start.x, size * start.y)
        _write_start(
            system,
            pose,
            index=0,
            contact=SEPARATE,
            point=NO_POINT,
            x=x,
            y=y,
            spin=size * start.spin,
        )
    return 1


def push_at_start(
    system: System, during: Span, time: float, state: RunState
) -> tuple[float, float, float]:
    """Acceleration of a pusher that meets a slider at rest, and the unit of accelerations, 0 at rest."""
    slip, unit = state.slip_speed, 0.0
    x, y, moves = _pusher_at_start(system, during, time, state)
    if not moves and not is_loaded(system):
        return 0.0, 0.0, 0.0
    if not moves:
        x, y = 0.0, 0.0
    if is_loaded(system):
        unit = system.run.force / system.scene.mass
    if _slides(system, slip):
        # The fence already slips at the contact, so only its normal motion matters.
        fast = ALREADY_SLIPS * max(fabs(y), unit)
        x = -fast if slip > 0.0 else fast
    return x, y, max(sqrt(x * x + y * y), unit)


def _slides(system: System, slip: float) -> bool:
    """Whether the pusher already slips at a slider at rest."""
    return fabs(slip) > AT_REST * system.run.speed


def write_starts_at_contact(
    system: System, during: Span, time: float, state: RunState, count: int
) -> int:
    """Store, after other candidates, the modes in which a slider at rest can start at the contact."""
    slip, pose = state.slip_speed, pose_at_start(system, state)
    x, y, unit = push_at_start(system, during, time, state)
    solutions = zeros(MOST_OF_SIDE * SOLUTION)
    length = side_length(system, state)
    prepare_start(system, state, unit)
    number = modes_at_contact(system, pose, length, x, y, 0.0, unit, solutions)
    if _slides(system, slip):
        # In units of a pusher this fast the slips have lost digits. A slower one has the same slips.
        slowest = unit / ALREADY_SLIPS
        fastest = unit * _fastest_slip(slip, number, solutions)
        x = -copysign(FASTER * (fastest if fastest > 0.0 else slowest), slip)
        unit = max(sqrt(x * x + y * y), slowest)
        prepare_start(system, state, unit)
        number = modes_at_contact(system, pose, length, x, y, 0.0, unit, solutions)
    for i in range(number):
        solution = Solution(solutions[i * SOLUTION :])
        contact, point = solution.mode, solution.pivot
        # A start has the same direction of slip, or no contact force.
        if _slides(system, slip) and contact != SEPARATE and slip_side(contact) * slip <= 0.0:
            continue
        if solution.twist.x == 0.0 and solution.twist.y == 0.0 and solution.twist.spin == 0.0:
            f_x, f_y = solution.force.x, solution.force.y
            write_rest(system, count, True, contact, f_x, f_y)
            candidate_of(system, count).offset = offset_in_solution(solution, length)
        else:
            _write_start(
                system,
                pose,
                count,
                contact,
                point,
                x=unit * solution.twist.x,
                y=unit * solution.twist.y,
                spin=unit * solution.twist.spin,
            )
            if contact == SEPARATE:
                leave_side(system, count)
        count += 1
    return count


def _fastest_slip(slip: float, number: int, solutions: Numbers) -> float:
    """Largest component of the contact's motion in those solutions that slip in the direction of `slip`."""
    fastest = 0.0
    for i in range(number):
        solution = Solution(solutions[i * SOLUTION :])
        contact = solution.mode
        if contact != SEPARATE and slip_side(contact) * slip > 0.0:
            fastest = max(fastest, max(fabs(solution.motion.x), fabs(solution.motion.y)))
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
    foot = slowest_foot_at(system, pose, v_x=x, v_y=y, spin=spin)
    if contact != STICK and not is_flush(system) and foot.number >= 0:
        size = foot.speed * max(size_of_twist(x, y, spin), NO_DIRECTION * system.run.speed)
        if size <= PASSES * size_of_twist(x, y, spin):
            position = foot_position(friction_effects(system), foot.number)
            f_x, f_y = to_contact(pose.rod, position.x, position.y)
            x, y, point = spin * f_y, -spin * f_x, foot.number
    candidate = write_candidate(system, index, contact)
    candidate.foot, candidate.hinged = point, point >= 0 and contact != STICK
    candidate.start.x, candidate.start.y, candidate.start.spin = x, y, spin


def _pusher_at_start(
    system: System, during: Span, time: float, state: RunState
) -> tuple[float, float, bool]:
    """Acceleration of the pusher, and whether the pusher moves."""
    b_x, b_y = pusher_acceleration(system, during, time, state)
    w_x, w_y = pusher_velocity(system, during, time, state)
    size = sqrt(b_x * b_x + b_y * b_y)
    slowest = PUSHER_AT_REST * system.run.speed
    if sqrt(w_x * w_x + w_y * w_y) > slowest:
        return b_x, b_y, size > 0.0
    moves: bool = size > slowest / pace_of(system, during, time)
    return b_x, 0.0 if fabs(b_y) <= AT_REST * size else b_y, moves
