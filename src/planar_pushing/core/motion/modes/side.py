"""The modes of a contact during a run: of a point, or of a side that lies on the fence."""

from __future__ import annotations

from math import fabs, sqrt

from planar_pushing.core.instant.flush import flush_modes
from planar_pushing.core.instant.flush_force import (
    MOST_FLUSH,
    FlatSide,
    FlushPush,
    resist_translation,
)
from planar_pushing.core.instant.solution import (
    SEPARATE,
    SOLUTION,
    UNSOLVED,
    Push,
    Solution,
)
from planar_pushing.core.motion.kinematics.drag import problem_effects
from planar_pushing.core.motion.kinematics.posing import modes_of_push
from planar_pushing.core.motion.kinematics.shapes import Pose, to_contact
from planar_pushing.core.motion.kinematics.system import System, law_of
from planar_pushing.core.numbers import Numbers
from planar_pushing.core.supports.free import foot_at_center, free_twist
from planar_pushing.core.supports.rows import Vector
from planar_pushing.core.supports.tolerances import COINCIDENT

#: Maximum number of solutions of a side on the fence.
MOST_OF_SIDE = 1 + MOST_FLUSH


def modes_at_contact(
    system: System, pose: Pose, length: float, x: float, y: float, spin: float, unit: float,
    solutions: Numbers,
) -> int:  # fmt: skip
    """Store every solution of the problem at hand, in a unit of motion; return their number.

    The contact is a point, or one end of a side; the other end is at `length` along the fence. Other
    arguments are those of `flush_or_free_modes`, in the units of the run.
    """
    unit = unit if unit > 0.0 else 1.0
    if length != 0.0:
        return flush_or_free_modes(
            system, pose, length, x=x / unit, y=y / unit, spin=spin / unit, solutions=solutions
        )
    number, _ = modes_of_push(system, pose, x, y, sqrt(x * x + y * y) / unit, solutions)
    return number


def flush_or_free_modes(
    system: System, pose: Pose, length: float, x: float, y: float, spin: float, solutions: Numbers
) -> int:
    """Store every solution of the problem at hand for a side on the fence, the separation first.

    Parameters
    ----------
    system : System
    pose : Pose
        Its contact is one end of the side.
    length : float
        Place of the other end along the fence, from the contact.
    x, y : float
        Motion of the fence along itself, and motion of the contact across the fence.
    spin : float
        Rotation of the side, zero for one that stays on the fence.
    solutions : Numbers
        Room for `MOST_OF_SIDE` solutions of `SOLUTION` columns.

    Returns
    -------
    int
        Number of solutions, `UNSOLVED` if an iteration has not converged.

    Notes
    -----
    `side_modes` answers another question: it also solves for the contacts at one end, and counts those that
    do not turn as flush. During a run such contacts are candidates of their own, and a step may turn the
    side onto the fence. Both routines leave the flush contacts to `flush_modes`.
    """
    push = Push(problem_effects(system), pose.contact, pose.rod.x, -pose.rod.y)
    count, scale = _add_free_motion(push, pose, length, x, y, spin, 0.0, Solution(solutions[0:]))
    if scale == 0.0:
        return count
    flush = FlushPush(
        push,
        FlatSide(min(length, 0.0), max(length, 0.0)),
        law_of(system, pose.rod),
        w_x=x,
        w_y=y,
        spin=spin,
        translation=resist_translation(push),
    )
    number = flush_modes(flush, solutions[count * SOLUTION :])
    if number < 0:
        return UNSOLVED
    if count + number == 0:
        return add_motion_with_fence(system, pose, length, x, y, spin, solutions)
    return count + number


def add_motion_with_fence(
    system: System, pose: Pose, length: float, x: float, y: float, spin: float, solutions: Numbers
) -> int:
    """Store the free motion of a contact that moves with the fence, whose force is only rounding error.

    Returns the number of solutions; the arguments are those of `flush_or_free_modes`, with length 0 for a
    point.
    """
    push = Push(problem_effects(system), pose.contact, pose.rod.x, -pose.rod.y)
    count, _ = _add_free_motion(push, pose, length, x, y, spin, COINCIDENT, Solution(solutions[0:]))
    return count


def _add_free_motion(
    push: Push, pose: Pose, length: float, x: float, y: float, spin: float, slack: float,
    solution: Solution,
) -> tuple[int, float]:  # fmt: skip
    """Store the motion without a contact force if both ends of a side leave the fence, or stay on it.

    Returns the number of solutions, and the magnitude of the motions of fence and slider. The slack is a
    part of it.
    """
    rest = free_twist(push.effects, Vector(0.0, 0.0, 0.0))
    v_x, v_y = to_contact(pose.rod, rest.x, rest.y)
    u_x, u_y = v_x + rest.spin * pose.y, v_y - rest.spin * pose.x
    scale = max(max(sqrt(x * x + y * y), fabs(rest.spin * length)), max(fabs(u_x), fabs(u_y)))
    leaves = min(u_y - y, u_y + rest.spin * length - (y + spin * length))
    if leaves < -slack * scale:
        return 0, scale
    for k in range(SOLUTION):
        solution[k] = 0.0
    solution.mode = SEPARATE
    solution.pivot = foot_at_center(push.effects, rest)
    solution.twist.x, solution.twist.y, solution.twist.spin = v_x, v_y, rest.spin
    solution.motion.x, solution.motion.y = u_x, u_y
    return 1, scale


def offset_in_solution(solution: Solution, length: float) -> float:
    """Place of the force on a side from one end, 0 without a normal force.

    `length` is the place of the other end, and negative on the left.
    """
    normal = solution.force.y
    if solution.mode == SEPARATE:
        return 0.0
    at_other_end = solution.end_force if length > 0.0 else solution.start_force
    return at_other_end * length / normal if normal != 0.0 else 0.0
