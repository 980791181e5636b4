"""The twists at the end of a time step, and the one that the policy prefers.

A slider over a fence can touch it at several points. No point may be below the fence at the end of the
step, to first order. The lowest ones form a chain, convex downward: at a point of the chain the rotation is
limited by the next points on both sides, and at a limit the side between two points closes. From the
contact, the points and sides of the chain are visited toward those that would be below the fence, and
those that touch it.
"""

from __future__ import annotations

from math import fabs, sqrt
from typing import NamedTuple

from planar_pushing.core.instant.solution import (
    MOST_SOLUTIONS,
    SEPARATE,
    SOLUTION,
    STICK,
    UNSOLVED,
    Solution,
)
from planar_pushing.core.motion.kinematics.drag import (
    load_at,
    put_load,
    put_loads_at,
    put_mass,
    scale_films,
)
from planar_pushing.core.motion.kinematics.mode import NO_MODE, is_preferred
from planar_pushing.core.motion.kinematics.posing import momentum_over
from planar_pushing.core.motion.kinematics.shapes import (
    Pose,
    contact_motion,
    from_world,
    pose_of,
    size_of_twist,
)
from planar_pushing.core.motion.kinematics.system import (
    ELSEWHERE,
    STATE,
    RunState,
    System,
    copy_numbers,
    is_massive,
    vector_of,
)
from planar_pushing.core.motion.kinematics.touch import (
    can_touch,
    count_points,
    fence_line,
    hold_end_of_arc,
    move_contact,
    offset_of,
    offset_over,
    put_contact,
    renew_contact,
    side_on_fence,
    take_lowest_point,
    touch_tolerance,
)
from planar_pushing.core.motion.kinematics.wall import clearance_of
from planar_pushing.core.motion.modes.side import (
    MOST_OF_SIDE,
    add_motion_with_fence,
    modes_at_contact,
    offset_in_solution,
)
from planar_pushing.core.numbers import INFINITY, Numbers, zeros
from planar_pushing.core.supports.rows import NO_POINT, Vector
from planar_pushing.core.supports.tolerances import COINCIDENT, SHARE, SLACK

#: Numbers of a choice: its solution, and whether the last side has a stick, a slip to the right, and one to
#: the left.
CHOSEN = SOLUTION + 3
#: After a finger has left the side permanently, the pusher recedes at this multiple of the typical speed.
RECEDES = 1e3


class Choice(NamedTuple):
    """The preferred twist at the end of a step.

    Attributes
    ----------
    number : int
        Number of possible twists, `UNSOLVED` if an iteration has not converged.
    contact, point, other_end : int
        Contact mode, the contact's point, and the other end of a side on the fence, -1 without one.
    unit, offset : float
        Unit of its twist, and place of the force from the contact.
    sinks_left, sinks_right : bool
        Whether another point on this side would be below the fence with a twist of the last contact.
    """

    number: int
    contact: int
    point: int
    other_end: int
    unit: float
    offset: float
    sinks_left: bool
    sinks_right: bool


def choose_twist(system: System, current: int, policy: int, chosen: Numbers) -> Choice:
    """Choose a twist at the end of the step, the first if several have the same mode; store its solution.

    Its contact becomes the contact.
    """
    state, there = vector_of(system, STATE), vector_of(system, ELSEWHERE)
    take_lowest_point(system, state)
    point = system.run.point
    renew_contact(system, state)
    copy_numbers(there, state, system.entries)
    left, right = side_on_fence(system, there)
    choice = Choice(
        number=0,
        contact=NO_MODE,
        point=point,
        other_end=NO_POINT,
        unit=0.0,
        offset=0.0,
        sinks_left=False,
        sinks_right=False,
    )
    if left < 0:
        left, right = point, point
        choice = _add_point(system, there, choice, True, current, policy, chosen)
        first = choice
    else:
        move_contact(system, there, right if point == right else left)
        other_end = left if point == right else right
        choice = _add_side(system, there, choice, other_end, True, current, policy, chosen)
        move_contact(system, there, left)
        choice = _add_point(system, there, choice, False, current, policy, chosen)
        first = choice
        move_contact(system, there, right)
        choice = _add_point(system, there, choice, False, current, policy, chosen)
    if choice.number >= 0:
        sinks: bool = choice.sinks_right
        choice = _follow_chain(system, there, choice, 1.0, sinks, current, policy, chosen)
        move_contact(system, there, left)
        sinks = first.sinks_left
        choice = _follow_chain(system, there, choice, -1.0, sinks, current, policy, chosen)
    put_contact(system, point, NO_POINT)
    hold_end_of_arc(system, state)
    if choice.number > 0:
        move_contact(system, state, choice.point)
        system.run.other_end = choice.other_end
    return choice


def _follow_chain(
    system: System, state: RunState, choice: Choice, sense: float, sinks: bool,
    current: int, policy: int, chosen: Numbers,
) -> Choice:  # fmt: skip
    """Add the twists of the sides and points next to the contact, as far as the next point would sink."""
    for _ in range(count_points(system)):
        following = _next_of_chain(system, state, sense) if sinks else NO_POINT
        if following < 0:
            break
        choice = _add_side(system, state, choice, following, False, current, policy, chosen)
        move_contact(system, state, following)
        choice = _add_point(system, state, choice, False, current, policy, chosen)
        sinks = choice.sinks_right if sense > 0.0 else choice.sinks_left
    return choice


def _next_of_chain(system: System, state: RunState, sense: float) -> int:
    """The next point of the chain on the right (1) or on the left (-1), -1 without one."""
    following, steepest, slack = NO_POINT, INFINITY, touch_tolerance(system)
    fence = fence_line(system, state)
    for point in range(count_points(system)):
        if not can_touch(system, point, state):
            continue
        offset = offset_over(system, fence, point, state)
        if sense * offset.x > slack and offset.y / (sense * offset.x) < steepest:
            following, steepest = point, offset.y / (sense * offset.x)
    return following


def _add_point(
    system: System, state: RunState, choice: Choice, is_first: bool,
    current: int, policy: int, chosen: Numbers,
) -> Choice:  # fmt: skip
    """Add the possible twists with a point as the contact to those so far.

    Without a contact force there is one twist, which belongs to the first contact. For an open contact that
    does not close in the step, it is the only one.
    """
    solutions = zeros(MOST_SOLUTIONS * SOLUTION)
    pose, point = pose_of(system, state), system.run.point
    number, unit = _solve_step(system, pose, state, length=0.0, spin=0.0, solutions=solutions)
    count, contact, best = choice.number, choice.contact, -1
    left: bool = False
    right: bool = False
    if number < 0 and is_first:
        return Choice(
            number=UNSOLVED,
            contact=NO_MODE,
            point=point,
            other_end=NO_POINT,
            unit=unit,
            offset=0.0,
            sinks_left=False,
            sinks_right=False,
        )
    for i in range(number):
        solution = Solution(solutions[i * SOLUTION :])
        mode = solution.mode
        if mode == SEPARATE and not is_first:
            continue
        side = _sinking_side(system, pose, state, unit, solution)
        left = left or side < 0.0
        right = right or side > 0.0
        if side != 0.0 or _is_on_side(solution, mode, chosen):
            continue
        count += 1
        if is_preferred(policy, current, mode, contact):
            best, contact = i, mode
        if mode == SEPARATE and clearance_of(system, state) > SLACK:
            break
    if best < 0:
        return Choice(
            count,
            contact,
            choice.point,
            choice.other_end,
            choice.unit,
            choice.offset,
            sinks_left=left,
            sinks_right=right,
        )
    solution = Solution(solutions[best * SOLUTION :])
    for k in range(SOLUTION):
        chosen[k] = solution[k]
    return Choice(
        number=count,
        contact=contact,
        point=point,
        other_end=NO_POINT,
        unit=unit,
        offset=0.0,
        sinks_left=left,
        sinks_right=right,
    )


def _is_on_side(solution: Solution, mode: int, chosen: Numbers) -> bool:
    """Whether a twist is that of a side on the fence, which is among those so far."""
    if mode == SEPARATE or chosen[SOLUTION + (mode - STICK)] == 0.0:
        return False
    speed = fabs(solution.motion.x) + fabs(solution.motion.y)
    return fabs(solution.twist.spin) <= COINCIDENT * speed


def _add_side(
    system: System, state: RunState, choice: Choice, other_end: int, is_first: bool,
    current: int, policy: int, chosen: Numbers,
) -> Choice:  # fmt: skip
    """Add the twists that close a side between the contact and another point.

    `chosen` also stores which modes the side has.
    """
    solutions = zeros(MOST_OF_SIDE * SOLUTION)
    pose, end = pose_of(system, state), offset_of(system, state, other_end)
    # The rotation that brings both ends as close to the fence.
    spin = 0.0
    if fabs(end.y) > SHARE:
        spin = -end.y / ((system.run.until - system.run.time) * end.x)
    number, unit = _solve_step(system, pose, state, end.x, spin, solutions)
    count, contact, best = choice.number, choice.contact, -1
    for k in range(3):
        chosen[SOLUTION + k] = 0.0
    for i in range(number):
        solution = Solution(solutions[i * SOLUTION :])
        mode = solution.mode
        if mode == SEPARATE and not is_first:
            continue
        if _sinking_side(system, pose, state, unit, solution) != 0.0:
            continue
        count += 1
        if mode != SEPARATE:
            chosen[SOLUTION + (mode - STICK)] = 1.0
        if is_preferred(policy, current, mode, contact):
            best, contact = i, mode
    if best < 0:
        return choice
    solution = Solution(solutions[best * SOLUTION :])
    for k in range(SOLUTION):
        chosen[k] = solution[k]
    if contact == SEPARATE:
        other_end = NO_POINT
    return Choice(
        count,
        contact,
        system.run.point,
        other_end,
        unit,
        offset_in_solution(solution, end.x),
        sinks_left=False,
        sinks_right=False,
    )


def _sinking_side(
    system: System, pose: Pose, state: RunState, unit: float, solution: Solution
) -> float:
    """On which side of the contact a point would be below the fence after the step, 0 if none is."""
    run = system.run
    h, spin = run.until - run.time, unit * solution.twist.spin
    side, lowest = 0.0, -SLACK
    fence = fence_line(system, state)
    for point in range(count_points(system)):
        if not can_touch(system, point, state):
            continue
        offset = offset_over(system, fence, point, state)
        across = h * (unit * solution.twist.y + spin * (offset.x - pose.x)) - run.path.y
        if state.gap + offset.y + across < lowest:
            side, lowest = offset.x, state.gap + offset.y + across
    return side


def _solve_step(
    system: System, pose: Pose, state: RunState, length: float, spin: float, solutions: Numbers
) -> tuple[int, float]:
    """Store the possible twists with a contact at a point, or on a side with a rotation.

    Returns their number and unit.
    """
    run = system.run
    h, gap = run.until - run.time, state.gap
    v_x, v_y = from_world(system, state, run.twist.x, run.twist.y)
    x, y = from_world(system, state, run.path.x, run.path.y)
    if count_points(system) > 0 and fabs(gap) <= SHARE:
        gap = 0.0
    x, y = x / h, (y - gap) / h
    if run.parted:
        y = -RECEDES * (run.speed + size_of_twist(v_x, v_y, run.twist.spin))
    u_x, u_y = contact_motion(pose, v_x, v_y, run.twist.spin)
    size = sqrt(x * x + y * y)
    before = max(sqrt(u_x * u_x + u_y * u_y), fabs(run.twist.spin))
    unit = _prepare_step(system, pose, h, size, before)
    run.evaluations += 1
    count = modes_at_contact(system, pose, length, x, y, spin, unit, solutions)
    if count == 0 and length == 0.0 and unit > 0.0:
        count = add_motion_with_fence(
            system, pose, length=0.0, x=x / unit, y=y / unit, spin=0.0, solutions=solutions
        )
    return count, unit


def _prepare_step(system: System, pose: Pose, h: float, size: float, before: float) -> float:
    """Store the effects of a step of length h; return the unit of motion.

    `size` is the speed of the pusher and `before` that of the contact. Inertia acts toward the previous
    twist: the momentum is a load.
    """
    scene, run, state = system.scene, system.run, vector_of(system, STATE)
    if not is_massive(system):
        scale_films(system, size)
        put_loads_at(system, state.angle)
        return size
    load = load_at(system, state.angle)
    v_x, v_y = from_world(system, state, run.twist.x, run.twist.y)
    momentum = momentum_over(system, pose.rod, v_x, v_y, run.twist.spin, h)
    push = h * sqrt(load.x * load.x + load.y * load.y) / scene.mass
    unit = max(max(size, before), push)
    scale_films(system, unit)
    put_mass(system, unit * scene.mass / h)
    put_load(
        system, Vector(load.x + momentum.x, load.y + momentum.y, load.spin + momentum.spin)
    )  # fmt: skip
    return unit
