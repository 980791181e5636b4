"""Impacts of a slider with inertia.

They are inelastic. Support friction is finite and therefore contributes no impulse.
"""

from __future__ import annotations

from math import fabs, sqrt

from planar_pushing.core._record import size_of
from planar_pushing.core.instant.flush_force import FlatSide
from planar_pushing.core.instant.flush_solutions import (
    MOST_ON_SIDE,
    SIDE_END,
    SIDE_SOLUTION,
    SIDE_START,
    WHOLE_SIDE,
    SideSolution,
    side_modes,
)
from planar_pushing.core.instant.modes import contact_modes
from planar_pushing.core.instant.solution import (
    SEPARATE,
    SOLUTION,
    Push,
    Solution,
)
from planar_pushing.core.motion.kinematics.fence import Span
from planar_pushing.core.motion.kinematics.mode import NO_MODE, is_preferred
from planar_pushing.core.motion.kinematics.posing import momentum_over, pusher_along
from planar_pushing.core.motion.kinematics.shapes import (
    center_motion,
    pose_of,
    pusher_velocity,
    to_world,
)
from planar_pushing.core.motion.kinematics.system import (
    GOES_ON,
    NO_IMPULSE,
    RunState,
    System,
    law_of,
)
from planar_pushing.core.motion.kinematics.touch import hold_contact, offset_of, side_on_fence
from planar_pushing.core.motion.modes.reaction import moment_of, reaction_of, reaction_of_side
from planar_pushing.core.numbers import Numbers, zeros
from planar_pushing.core.supports.rows import (
    EFFECT,
    LAST,
    LOAD,
    MASS,
    NO_POINT,
    EffectHead,
    LoadRow,
    MassRow,
    Vector,
    read_effects,
)
from planar_pushing.core.supports.tolerances import SLACK

#: Number of columns of a mass and of a load.
MASS_COLUMNS, LOAD_COLUMNS = size_of(MassRow), size_of(LoadRow)


def add_impulse(system: System, state: RunState, p_x: float, p_y: float) -> None:
    """Add an impulse at the contact to those that the next row of the log contains."""
    x, y = to_world(system, state, p_x, p_y)
    system.run.impulse.x += x
    system.run.impulse.y += y


def collide(
    system: System, during: Span, time: float, state: RunState, current: int, policy: int
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
    first, last = state.normal_speed, state.normal_speed + state.spin * length
    slack = SLACK * system.run.speed
    if max(max(fabs(state.slip_speed), fabs(first)), fabs(last)) <= slack:
        state.slip_speed, state.normal_speed = 0.0, 0.0
        if left >= 0:
            state.spin = 0.0
        return GOES_ON
    # Without an approach, to rounding, the contact can open.
    other = SEPARATE if min(first, last) >= -slack else NO_MODE
    fence_x, fence_y = pusher_velocity(system, during, time, state)
    contact, touches = _choose_blow(
        system, state, length, fence_x, fence_y, current, policy, other
    )  # fmt: skip
    if contact == NO_MODE:
        return NO_IMPULSE
    if contact != SEPARATE:
        if touches == SIDE_END:
            hold_contact(system, state, right, NO_POINT)
        flush: bool = length != 0.0 and touches == WHOLE_SIDE
        _strike(system, state, contact, flush, fence_x, fence_y)
    return GOES_ON


def _choose_blow(
    system: System, state: RunState, length: float, fence_x: float, fence_y: float,
    current: int, policy: int, other: int,
) -> tuple[int, int]:  # fmt: skip
    """The preferred mode of an impact, or another one, and where it touches a side of a length."""
    data, row = zeros(3 * EFFECT), zeros(MASS_COLUMNS + LOAD_COLUMNS)
    solutions = zeros(MOST_ON_SIDE * SIDE_SOLUTION)
    pose, spin, size = (
        pose_of(system, state),
        state.spin,
        sqrt(fence_x * fence_x + fence_y * fence_y),
    )
    u_x, u_y = fence_x + state.slip_speed, fence_y + state.normal_speed
    unit = max(max(size, sqrt(u_x * u_x + u_y * u_y)), fabs(spin))
    v_x, v_y = center_motion(pose, u_x, u_y, spin)
    _write_inertia(system, momentum_over(system, pose.rod, v_x, v_y, spin, unit), data, row)
    push = Push(read_effects(data, row), pose.contact, pose.rod.x, -pose.rod.y)
    law, pusher = law_of(system, pose.rod), pusher_along(pose, fence_x, fence_y, size / unit)
    if length == 0.0:
        number, _ = contact_modes(push, law, pusher, solutions)
        for i in range(number):
            contact = Solution(solutions[i * SOLUTION :]).mode
            if is_preferred(policy, current, contact, other):
                other = contact
        return other, WHOLE_SIDE
    number = side_modes(push, FlatSide(0.0, length), law, pusher, solutions)
    chosen, first = WHOLE_SIDE, SIDE_START if spin >= 0.0 else SIDE_END
    for k in range(3):
        touches = WHOLE_SIDE if k == 0 else first if k == 1 else SIDE_START + SIDE_END - first
        for i in range(number):
            contact = SideSolution(solutions[i * SIDE_SOLUTION :]).mode
            there: bool = SideSolution(solutions[i * SIDE_SOLUTION :]).touches_at == touches
            if there and is_preferred(policy, current, contact, other):
                other, chosen = contact, touches
    return other, chosen


def _write_inertia(system: System, momentum: Vector, data: Numbers, row: Numbers) -> None:
    """Write the effects of an impact: a mass, and its momentum as a load."""
    scene = system.scene
    inertia, moving, last = (
        EffectHead(data),
        EffectHead(data[EFFECT:]),
        EffectHead(data[2 * EFFECT :]),
    )
    inertia.kind, inertia.column = MASS, 0
    moving.kind, moving.column = LOAD, MASS_COLUMNS
    last.kind, last.column = LAST, MASS_COLUMNS + LOAD_COLUMNS
    body, load = MassRow(row), LoadRow(row[MASS_COLUMNS:])
    body.mass, body.gyration = scene.mass, system.run.moment / scene.mass
    body.center_x, body.center_y = scene.center.x, scene.center.y
    load.x, load.y, load.torque = momentum.x, momentum.y, momentum.spin


def _strike(
    system: System, state: RunState, contact: int, flush: bool, fence_x: float, fence_y: float
) -> None:
    """Change the twist by the impulse of a mode at the contact, or along a side, which stops rotating.

    The closed form has more digits than the solution, whose noise grows with the length of the rod.
    """
    pose, moment = pose_of(system, state), system.run.moment
    x, y, spin = state.slip_speed, state.normal_speed, state.spin
    if flush:
        impulse = reaction_of_side(system, contact, x - spin * pose.arm_y, y + spin * pose.arm_x)
    else:
        impulse = reaction_of(system, pose, contact, x, y)
    p_x, p_y = impulse.f_x, impulse.f_y
    turn = moment_of(pose, p_x, p_y)
    add_impulse(system, state, p_x, p_y)
    state.slip_speed, state.normal_speed = impulse.x, 0.0
    state.spin = 0.0 if flush else spin + turn / moment
    state.work += p_x * fence_x + p_y * fence_y
    twice = p_x * (x + impulse.x) + p_y * y
    if flush:
        twice -= (moment * spin + turn) * spin
    state.lost -= twice / 2.0
