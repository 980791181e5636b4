"""Enumeration of the contact modes of one push from rest (Secs. 2-5).

The force of the sticking motion is evaluated once. Its sign across each edge of the friction cone decides
whether the contact sticks. The sticking motion is also the end of the path on which the slips under that
edge are searched for. Psi is convex. With effects of one degree, a push into the slider therefore has
exactly one of stick and slip, and with several degrees the sign gives the parity of the number of slips.
"""

from __future__ import annotations

from math import fabs, sqrt

from planar_pushing.core.instant.cone import (
    BEYOND,
    JUST_WITHIN,
    WITHIN,
    Law,
    hold_at_rest,
    position_in_cone,
    settle_pivot,
)
from planar_pushing.core.instant.directions import Direction
from planar_pushing.core.instant.edge_slips import Count, Search, write_slips
from planar_pushing.core.instant.force import (
    ContactMotion,
    sticking_motion,
)
from planar_pushing.core.instant.solution import (
    SEPARATE,
    SLIP_LEFT,
    SLIP_RIGHT,
    SOLUTION,
    STICK,
    UNSOLVED,
    Push,
    Solution,
    copy_solution,
    write_solution,
)
from planar_pushing.core.numbers import Numbers
from planar_pushing.core.supports.contact import is_held
from planar_pushing.core.supports.free import foot_at_center, free_twist
from planar_pushing.core.supports.psi import guess_spin, psi
from planar_pushing.core.supports.resistance import load_wrench, rough_mass
from planar_pushing.core.supports.rows import NO_POINT, Vector, scale_effects
from planar_pushing.core.supports.tolerances import (
    ALIGNED,
    ROUNDING,
)


def _free_motion(push: Push) -> Vector:
    """The twist without a contact force; of a side that stays on the fence, a translation."""
    effects, load = push.effects, load_wrench(push.effects)
    if not is_held(push.contact):
        return free_twist(effects, Vector(0.0, 0.0, 0.0))
    weight = rough_mass(scale_effects(effects, 1.0, 0.0), 1.0, 0.0, 0.0).mass
    mass = rough_mass(scale_effects(effects, 0.0, 1.0), 1.0, 0.0, 0.0).mass
    size = sqrt(load.x * load.x + load.y * load.y)
    part = (size - weight) / (mass * size) if mass > 0.0 and size > weight else 0.0
    return Vector(part * load.x, part * load.y, 0.0)


def _write_separation(push: Push, solution: Solution) -> None:
    """Write the motion without a contact force."""
    rest, contact = _free_motion(push), push.contact
    u_x, u_y = rest.x - rest.spin * contact.y, rest.y + rest.spin * contact.x
    motion = ContactMotion(
        u_x,
        u_y,
        v_x=rest.x,
        v_y=rest.y,
        spin=rest.spin,
        f_x=0.0,
        f_y=0.0,
        half_x=0.0,
        half_y=0.0,
        point=foot_at_center(push.effects, rest),
        continuum=False,
        noise_x=0.0,
        noise_y=0.0,
        converged=True,
    )
    write_solution(push, SEPARATE, motion, solution)


def contact_modes(push: Push, law: Law, pusher: Direction, solutions: Numbers) -> tuple[int, bool]:
    """Write every consistent solution, in units of the pusher's motion.

    Parameters
    ----------
    push : Push
    law : Law
    pusher : Direction
        Direction of the pusher's motion, which has unit magnitude; all components are zero for a pusher at
        rest.
    solutions : Numbers
        Room for `MOST_SOLUTIONS` solutions, which are written in the order of the modes.

    Returns
    -------
    count : int
        Number of solutions, `UNSOLVED` if an iteration has not converged.
    continuum : bool
        Whether a continuum of slips touches the stick.

    Notes
    -----
    A contact whose force is within rounding of an edge sticks unless a slip is found. A slip of zero speed
    is the stick. If pusher and slider are both at rest, so that the force is undetermined, they count as
    separate. If the slider pivots, and its motion is the same with and without a force of the contact, it
    is the slip or the stick whose interval of forces begins at zero.
    """
    separation = Solution(solutions[0:])
    _write_separation(push, separation)
    rest_x, rest_y = separation.motion.x, separation.motion.y
    speed = 1.0 if pusher.x != 0.0 or pusher.y != 0.0 else 0.0
    scale = max(speed, max(fabs(rest_x), fabs(rest_y)))
    if scale == 0.0 and separation.twist.spin == 0.0:
        return 1, False
    turn = fabs(separation.twist.spin) * (1.0 + push.contact.reach)
    slack = ALIGNED * (fabs(rest_x) + fabs(rest_y) + turn) if turn > 0.0 else 0.0
    # Index of the stick, which precedes the slips.
    stick_index = 1 if pusher.y <= rest_y + slack else 0
    x, y = pusher.along, -pusher.across
    guess = guess_spin(push.effects, push.contact, x, y)
    root = psi(push.effects, push.contact, x, y, guess, NO_POINT, ROUNDING)
    if not root.converged:
        return UNSOLVED, False
    stick = settle_pivot(push, law, sticking_motion(x, y, root))
    if x == 0.0 and y == 0.0 and stick.spin == 0.0:
        stick = hold_at_rest(push, law, stick, scale)
    search = Search(
        push, pusher, rest_x, rest_y, separation.twist.spin, scale, root, stick.f_x, stick.f_y,
        stick_index,
    )  # fmt: skip
    slips = Count(stick_index + 1, False, False, False)
    if law.slips:
        slips = write_slips(search, law.left, SLIP_RIGHT, solutions, slips)
        slips = write_slips(search, law.right, SLIP_LEFT, solutions, slips)
        if slips.number < 0:
            return UNSOLVED, False
    slides: bool = slips.number > stick_index + 1
    force_position = position_in_cone(push, law, stick)
    sticks: bool = law.rough or slips.sticks or force_position == WITHIN
    if law.closed and force_position != BEYOND and (slips.flat or not slides):
        sticks = True
    if law.closed and law.slips and force_position == JUST_WITHIN:
        sticks = True
    number, opens = slips.number, slips.open
    if sticks:
        # A slip that is the stick has its force exactly on the edge. That of a pivot can be on both edges.
        pivots: bool = force_position != BEYOND and (stick.half_x != 0.0 or stick.half_y != 0.0)
        hinged: bool = slips.sticks and Solution(solutions[stick_index * SOLUTION :]).pivot >= 0
        settles: bool = force_position >= JUST_WITHIN and not hinged
        if not slips.sticks or settles or pivots:
            write_solution(push, STICK, stick, Solution(solutions[stick_index * SOLUTION :]))
        opens = opens or (pivots and _can_be_open(stick))
        if slips.flat:
            Solution(solutions[stick_index * SOLUTION :]).continuum = True
    else:
        number = drop_solution(solutions, stick_index, number)
    if opens and stick_index == 1:
        number = drop_solution(solutions, 0, number)
    return number, slips.flat


def _can_be_open(pivot: ContactMotion) -> bool:
    """Whether the interval of forces of a pivot contains zero, to rounding."""
    f_x, f_y, half_x, half_y = pivot.f_x, pivot.f_y, pivot.half_x, pivot.half_y
    part = -(f_x * half_x + f_y * half_y) / (half_x * half_x + half_y * half_y)
    part = min(max(part, -1.0), 1.0)
    return fabs(f_x + part * half_x) <= pivot.noise_x and fabs(f_y + part * half_y) <= pivot.noise_y


def drop_solution(solutions: Numbers, index: int, number: int) -> int:
    """Remove one of several solutions, and return how many are left."""
    for i in range(index, number - 1):
        copy_solution(solutions[i * SOLUTION :], solutions[(i + 1) * SOLUTION :])
    return number - 1
