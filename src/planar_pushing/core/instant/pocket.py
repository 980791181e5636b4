"""The contact modes of a point at an inner corner, where it touches two sides.

The force of a contact that sticks there is the sum of two forces, one in the friction cone of each
side. It is in the cone between their outer edges, about the bisector of the normals. If these edges are
more than 180 degrees apart, every force can occur. A contact that slips leaves the corner along one of
the sides, and opens at the other: to the right (`SLIP_RIGHT`) along the side before the corner, whose
normal is on the left of the bisector, and to the left along the side after it. A contact separates if
it can at both sides.
"""

from __future__ import annotations

from math import cos, sin, sqrt

from planar_pushing.core.instant.cone import Law
from planar_pushing.core.instant.directions import QUARTER_TURN, Direction, Rod, direction_at
from planar_pushing.core.instant.modes import contact_modes, drop_solution
from planar_pushing.core.instant.solution import (
    MOST_SOLUTIONS,
    SEPARATE,
    SLIP_LEFT,
    SLIP_RIGHT,
    SOLUTION,
    UNSOLVED,
    Pair,
    Push,
    Solution,
    copy_solution,
)
from planar_pushing.core.numbers import Numbers, zeros


def modes_in_pocket(
    push: Push, rod: Rod, law: Law, pusher: Direction, half: float, solutions: Numbers
) -> tuple[int, bool]:
    """Write every consistent solution at an inner corner; the results are those of `contact_modes`.

    Parameters
    ----------
    push, rod : Push, Rod
        In the contact frame whose normal is the bisector of those of the sides.
    law : Law
        Of each side.
    pusher : Direction
    half : float
        Half of the angle between the normals.
    solutions : Numbers
    """
    right, left = law.right.angle - half, law.left.angle + half
    wide = Law(
        right=direction_at(rod, right),
        left=direction_at(rod, left),
        slips=False,
        closed=law.closed,
        rough=law.rough or left - right > 2.0 * QUARTER_TURN,
    )
    number, flat = contact_modes(push, wide, pusher, solutions)
    if number < 0:
        return UNSOLVED, False
    separates: bool = number > 0 and Solution(solutions[0:]).mode == SEPARATE
    opens: bool = True
    room = zeros(MOST_SOLUTIONS * SOLUTION)
    for i in range(2):
        turn, contact = half if i == 0 else -half, SLIP_RIGHT if i == 0 else SLIP_LEFT
        found, touches = _modes_of_side(push, rod, law, pusher, turn, room)
        if found < 0:
            return UNSOLVED, False
        opens = opens and found > 0 and Solution(room[0:]).mode == SEPARATE
        flat = flat or touches
        for k in range(found):
            solution = Solution(room[k * SOLUTION :])
            if solution.mode == contact:
                _turn_solution(solution, turn)
                copy_solution(solutions[number * SOLUTION :], room[k * SOLUTION :])
                number += 1
    if separates and not opens:
        number = drop_solution(solutions, 0, number)
    return number, flat


def _modes_of_side(
    push: Push, rod: Rod, law: Law, pusher: Direction, turn: float, solutions: Numbers
) -> tuple[int, bool]:
    """The contact modes at a side alone, in its frame, which is turned by an angle."""
    angle = rod.angle - turn
    there = Rod(rod.length, angle, cos(angle), sin(angle))
    part = sqrt(pusher.x * pusher.x + pusher.y * pusher.y)
    toward = direction_at(there, pusher.angle - turn)
    if part != 1.0:
        toward = Direction(
            toward.angle,
            x=part * toward.x,
            y=part * toward.y,
            along=part * toward.along,
            across=part * toward.across,
        )
    seen = Law(
        direction_at(there, law.right.angle),
        direction_at(there, law.left.angle),
        law.slips,
        law.closed,
        law.rough,
    )
    return contact_modes(
        Push(push.effects, push.contact, there.x, -there.y), seen, toward, solutions
    )


def _turn_solution(solution: Solution, turn: float) -> None:
    """Rotate the vectors of a solution by an angle."""
    c, s = cos(turn), sin(turn)
    _turn_vector(solution.twist, c, s)
    _turn_vector(solution.motion, c, s)
    _turn_vector(solution.force, c, s)
    _turn_vector(solution.force_end, c, s)


def _turn_vector(vector: Pair, c: float, s: float) -> None:
    """Rotate a vector by the angle with this cosine and sine."""
    x, y = vector.x, vector.y
    vector.x, vector.y = c * x - s * y, s * x + c * y
