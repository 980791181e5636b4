"""Impacts of a slider with inertia.

They are inelastic. Support friction is finite and therefore contributes no impulse.
"""

from __future__ import annotations

from math import fabs, sqrt

from planar_pushing.core.fence import Span
from planar_pushing.core.flush_force import END_FORCE, FlatSide
from planar_pushing.core.flush_solutions import (
    MOST_ON_SIDE,
    SIDE_END,
    SIDE_SOLUTION,
    SIDE_START,
    TOUCHES_AT,
    WHOLE_SIDE,
    side_modes,
)
from planar_pushing.core.modes import contact_modes
from planar_pushing.core.numbers import Numbers, zeros
from planar_pushing.core.posing import momentum_over, pusher_along
from planar_pushing.core.rows import ENTRY, LAST, LOAD, MASS, NO_POINT, Vector, read_effects
from planar_pushing.core.run import (
    IN_MASS,
    IN_MASS_X,
    IN_MASS_Y,
    RUN_IMPULSE,
    RUN_MOMENT,
    RUN_SPEED,
)
from planar_pushing.core.shapes import center_motion, pose_of, pusher_velocity, to_world
from planar_pushing.core.solution import (
    FORCE,
    MODE,
    MOTION,
    SEPARATE,
    SOLUTION,
    STICK,
    TWIST,
    Push,
)
from planar_pushing.core.system import (
    ANGLE,
    GOES_ON,
    LOST,
    NO_IMPULSE,
    NO_MODE,
    NORMAL_SPEED,
    SLIP_SPEED,
    SPIN,
    WORK,
    System,
    is_preferred,
    law_of,
)
from planar_pushing.core.tolerances import SLACK
from planar_pushing.core.touch import hold_contact, offset_of, side_on_fence

#: Number of columns of a mass and of a load.
MASS_COLUMNS, LOAD_COLUMNS = 4, 3


def add_impulse(system: System, state: Numbers, p_x: float, p_y: float) -> None:
    """Add an impulse at the contact to those that the next row of the log contains."""
    x, y = to_world(system, state[ANGLE], p_x, p_y)
    system.run[RUN_IMPULSE] += x
    system.run[RUN_IMPULSE + 1] += y


def collide(
    system: System, during: Span, time: float, state: Numbers, current: int, policy: int
) -> int:
    """Change the twist by the impulse that the policy prefers; return why there is none, or `GOES_ON`.

    An impact is a push from rest that inertia alone resists, with the momentum as the load. Of equal modes
    of a side, both ends come first, then the end that arrives faster.
    """
    left, right = side_on_fence(system, state)
    length = 0.0
    if left >= 0:
        hold_contact(system, state, left, NO_POINT)
        length = offset_of(system, state, right).x
    first, last = state[NORMAL_SPEED], state[NORMAL_SPEED] + state[SPIN] * length
    slack = SLACK * system.run[RUN_SPEED]
    if max(max(fabs(state[SLIP_SPEED]), fabs(first)), fabs(last)) <= slack:
        state[SLIP_SPEED], state[NORMAL_SPEED] = 0.0, 0.0
        if left >= 0:
            state[SPIN] = 0.0
        return GOES_ON
    data, row = zeros(3 * ENTRY), zeros(MASS_COLUMNS + LOAD_COLUMNS)
    solutions = zeros(MOST_ON_SIDE * SIDE_SOLUTION)
    fence_x, fence_y = pusher_velocity(system, during, time, state)
    pose, size = pose_of(system, state), sqrt(fence_x * fence_x + fence_y * fence_y)
    u_x, u_y = fence_x + state[SLIP_SPEED], fence_y + first
    unit = max(max(size, sqrt(u_x * u_x + u_y * u_y)), fabs(state[SPIN]))
    v_x, v_y = center_motion(pose, u_x, u_y, state[SPIN])
    momentum = momentum_over(system, pose.rod, v_x, v_y, state[SPIN], unit)
    _write_inertia(system, momentum, data, row)
    push = Push(read_effects(data, row), pose.contact, pose.rod.x, -pose.rod.y)
    law, pusher = law_of(system, pose.rod), pusher_along(pose, fence_x, fence_y, size / unit)
    width = SIDE_SOLUTION
    if left >= 0:
        number = side_modes(push, FlatSide(0.0, length), law, pusher, solutions)
    else:
        width = SOLUTION
        number, _ = contact_modes(push, law, pusher, solutions)
    # Without an approach, to rounding, the contact can open.
    best, chosen = -1, SEPARATE if min(first, last) >= -slack else NO_MODE
    faster = SIDE_START if first <= last else SIDE_END
    for rank in range(3 if left >= 0 else 1):
        touches = (
            WHOLE_SIDE if rank == 0 else faster if rank == 1 else SIDE_START + SIDE_END - faster
        )
        for i in range(number):
            solution = solutions[i * width :]
            contact = int(solution[MODE])
            there: bool = left < 0 or int(solution[TOUCHES_AT]) == touches
            if there and is_preferred(policy, current, contact, chosen):
                best, chosen = i, contact
    if chosen == NO_MODE:
        return NO_IMPULSE
    if chosen != SEPARATE:
        solution, torque = solutions[best * width :], 0.0
        if left >= 0 and int(solution[TOUCHES_AT]) == SIDE_END:
            hold_contact(system, state, right, NO_POINT)
        elif left >= 0 and int(solution[TOUCHES_AT]) == WHOLE_SIDE:
            torque = unit * solution[END_FORCE] * length
        _strike(system, state, solution, unit, torque, fence_x, fence_y)
    return GOES_ON


def _write_inertia(system: System, momentum: Vector, data: Numbers, row: Numbers) -> None:
    """Write the effects of an impact: a mass, and its momentum as a load."""
    scene = system.scene
    data[0], data[1] = float(MASS), 0.0
    data[ENTRY], data[ENTRY + 1] = float(LOAD), float(MASS_COLUMNS)
    data[2 * ENTRY], data[2 * ENTRY + 1] = float(LAST), float(MASS_COLUMNS + LOAD_COLUMNS)
    row[0], row[1] = scene[IN_MASS], system.run[RUN_MOMENT] / scene[IN_MASS]
    row[2], row[3] = scene[IN_MASS_X], scene[IN_MASS_Y]
    row[4], row[5], row[6] = momentum.x, momentum.y, momentum.spin


def _strike(
    system: System, state: Numbers, solution: Numbers, unit: float, torque: float,
    fence_x: float, fence_y: float,
) -> None:  # fmt: skip
    """Change the twist to that of a solution, by its impulse and a torque about the contact."""
    p_x, p_y = unit * solution[FORCE], unit * solution[FORCE + 1]
    x, y, spin = state[SLIP_SPEED], state[NORMAL_SPEED], state[SPIN]
    add_impulse(system, state, p_x, p_y)
    sticks: bool = int(solution[MODE]) == STICK
    state[SLIP_SPEED] = 0.0 if sticks else unit * solution[MOTION] - fence_x
    state[NORMAL_SPEED], state[SPIN] = 0.0, unit * solution[TWIST + 2]
    state[WORK] += p_x * fence_x + p_y * fence_y
    twice = p_x * (x + state[SLIP_SPEED]) + p_y * y + torque * (spin + state[SPIN])
    state[LOST] -= twice / 2.0
