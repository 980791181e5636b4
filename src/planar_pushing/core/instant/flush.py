"""The modes of a flat side on the fence: flush contact, between the two ends of the side.

The side stays on the fence, so the slider does not rotate freely. Flush contact is therefore the contact at
a point whose rotation is given, with a force that crosses the fence between the ends.
"""

from __future__ import annotations

from math import fabs

from planar_pushing.core.instant.directions import Direction
from planar_pushing.core.instant.flush_at_rest import write_side_at_rest
from planar_pushing.core.instant.flush_force import (
    FlushPush,
    SideForce,
    is_between_ends,
    translation_force,
    write_flush,
)
from planar_pushing.core.instant.modes import contact_modes
from planar_pushing.core.instant.solution import (
    MOST_SOLUTIONS,
    SLIP_LEFT,
    SLIP_RIGHT,
    SOLUTION,
    STICK,
    UNSOLVED,
    Push,
    Solution,
)
from planar_pushing.core.numbers import Numbers, zeros
from planar_pushing.core.supports.contact import hold_rotation, resistance_about
from planar_pushing.core.supports.free import free_twist
from planar_pushing.core.supports.rows import Vector


def flush_modes(flush: FlushPush, solutions: Numbers) -> int:
    """Write every solution with the side on the fence, in the order of the modes, and return their number.

    Parameters
    ----------
    flush : FlushPush
        In a rotation a support point exactly at the center of rotation has no friction.
    solutions : Numbers
        Room for `MOST_FLUSH` solutions of `SOLUTION` columns.

    Returns
    -------
    int
        `UNSOLVED` if there are more slips than fit.

    Notes
    -----
    Slips of one mode are in the order of their speed. If fence and slider are at rest although friction
    alone holds the loads, there is no solution: they count as separate.
    """
    push, law, w_x, w_y, spin = flush.push, flush.law, flush.w_x, flush.w_y, flush.spin
    points = zeros(MOST_SOLUTIONS * SOLUTION)
    t_x, t_y, count = push.t_x, push.t_y, 0
    held = Push(push.effects, hold_rotation(push.contact, spin), t_x, t_y)
    fence = Direction(
        angle=0.0, x=w_x, y=w_y, along=t_x * w_x - t_y * w_y, across=-(t_x * w_y + t_y * w_x)
    )
    number, _ = contact_modes(held, law, fence, points)
    if number < 0:
        return UNSOLVED
    falls: bool = w_y == 0.0 and spin == 0.0 and _falls(flush)
    for mode in range(STICK, SLIP_LEFT + 1):
        for i in range(number):
            point = Solution(points[i * SOLUTION :])
            moves: bool = point.motion.x != 0.0 or point.motion.y != 0.0 or spin != 0.0
            if mode == STICK:
                moves = w_x != 0.0 or w_y != 0.0 or spin != 0.0
            if point.mode == mode and moves:
                count = _keep_between_ends(flush, mode, point, solutions, count)
        edge, rests = law.left, w_x == 0.0
        if mode == SLIP_RIGHT:
            rests = law.slips and w_x < 0.0
        elif mode == SLIP_LEFT:
            edge, rests = law.right, law.slips and w_x > 0.0
        if falls and rests:
            count = write_side_at_rest(flush, mode, edge, solutions, count)
    return count


def _falls(flush: FlushPush) -> bool:
    """Whether loads move the slider without a contact, because friction does not hold them."""
    load = flush.translation.load
    if load.x == 0.0 and load.y == 0.0 and load.spin == 0.0:
        return False
    twist = free_twist(flush.push.effects, Vector(0.0, 0.0, 0.0))
    return twist.x != 0.0 or twist.y != 0.0 or twist.spin != 0.0


def _keep_between_ends(
    flush: FlushPush, mode: int, point: Solution, solutions: Numbers, count: int
) -> int:
    """Write a motion if its force crosses the side between its ends; return the number of solutions."""
    push, still, law = flush.push, flush.translation, flush.law
    x, y = point.motion.x, point.motion.y
    if flush.spin == 0.0:
        torque = translation_force(still, x, y).torque
    else:
        v_x = push.t_x * point.twist.x - push.t_y * point.twist.y
        v_y = push.t_x * point.twist.y + push.t_y * point.twist.x
        torque = resistance_about(
            push.effects, push.contact, x=v_x, y=v_y, spin=flush.spin, blur=0.0
        ).torque
    moved = fabs(x) + fabs(y) + fabs(flush.spin) * still.lever
    size = still.weight + still.mass * moved + fabs(still.load.x) + fabs(still.load.y)
    force = SideForce(s=x, f_x=point.force.x, f_y=point.force.y, torque=torque, size=size)
    if not (law.rough and mode == STICK) and not is_between_ends(flush, force):
        return count
    return write_flush(flush, mode, force, point.continuum, solutions, count)
