"""Forces and impulses at the contact of a slider with inertia, and impacts.

With r from the contact to the center of mass, a force f at the contact accelerates it by
``f / m + (r_y f_x - r_x f_y) (r_y, -r_x) / J``. Impacts are inelastic. Support friction is finite and
therefore contributes no impulse.
"""

from __future__ import annotations

from math import atan2, fabs, sqrt
from typing import NamedTuple

from planar_pushing.core.fence import Span
from planar_pushing.core.instant import support_of_side
from planar_pushing.core.numbers import Numbers
from planar_pushing.core.rows import NO_POINT
from planar_pushing.core.run import (
    IN_CLOSED,
    IN_LEFT,
    IN_MASS,
    IN_RIGHT,
    IN_ROUGH,
    IN_SLIPS,
    RUN_FORCE,
    RUN_IMPULSE,
    RUN_LEFT,
    RUN_MOMENT,
    RUN_RIGHT,
    RUN_SPEED,
)
from planar_pushing.core.shapes import Pose, pose_of, pusher_velocity, to_world
from planar_pushing.core.solution import SEPARATE, SLIP_LEFT, SLIP_RIGHT, STICK
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
    slip_side,
)
from planar_pushing.core.tolerances import SLACK
from planar_pushing.core.touch import hold_contact, offset_of, side_on_fence


class Answer(NamedTuple):
    """The force of a mode, and the relative acceleration of the contact with it.

    Also the impulse of a mode, and the relative velocity after it.
    """

    f_x: float
    f_y: float
    x: float
    y: float


def edge_of_slip(system: System, contact: int) -> tuple[float, float]:
    """Direction of the force in a slipping mode, on the edge that opposes the slip."""
    run = system.run
    if contact == SLIP_RIGHT:
        return run[RUN_LEFT], run[RUN_LEFT + 1]
    return run[RUN_RIGHT], run[RUN_RIGHT + 1]


def edge_angle(system: System, contact: int) -> float:
    """Angle of the force in a slipping mode."""
    return system.scene[IN_LEFT] if contact == SLIP_RIGHT else system.scene[IN_RIGHT]


def cone_margin(system: System, f_x: float, f_y: float, smallest: float) -> float:
    """Margin of a force in the friction cone, negative outside.

    It is the angle to the nearer edge, with a weight that is small for forces below `smallest`, so that the
    margin is smooth and 0 for zero force.
    """
    scene = system.scene
    if scene[IN_ROUGH] != 0.0:
        return 1.0
    size = sqrt(f_x * f_x + f_y * f_y)
    angle = (scene[IN_LEFT] - scene[IN_RIGHT]) / 2.0 - fabs(atan2(f_x, f_y))
    return angle * size / (size + smallest) if size > 0.0 else 0.0


def _admits_impulse(system: System, p_x: float, p_y: float) -> bool:
    """Whether an impulse lies in the cone of the law; a zero impulse does not."""
    if p_x == 0.0 and p_y == 0.0:
        return False
    # An impulse on the edge belongs to a closed cone.
    smallest = -SLACK if system.scene[IN_CLOSED] != 0.0 else SLACK
    return cone_margin(system, p_x, p_y, 0.0) >= smallest


def moment_of(pose: Pose, f_x: float, f_y: float) -> float:
    """Torque of a force at the contact about the center of mass."""
    return pose.arm_y * f_x - pose.arm_x * f_y


def _acceleration_by(system: System, pose: Pose, f_x: float, f_y: float) -> tuple[float, float]:
    """Acceleration of the contact due to a force there."""
    turn = moment_of(pose, f_x, f_y) / system.run[RUN_MOMENT]
    mass = system.scene[IN_MASS]
    return f_x / mass + turn * pose.arm_y, f_y / mass - turn * pose.arm_x


def _force_for(system: System, pose: Pose, a_x: float, a_y: float) -> tuple[float, float]:
    """Force at the contact that gives it an acceleration."""
    mass, reach = system.scene[IN_MASS], sqrt(pose.arm_x * pose.arm_x + pose.arm_y * pose.arm_y)
    if reach == 0.0:
        return mass * a_x, mass * a_y
    # The effective mass is the mass along the arm, and less across it; components along these directions
    # avoid cancellation for a long arm.
    x, y = pose.arm_x / reach, pose.arm_y / reach
    along = mass * (a_x * x + a_y * y)
    across = (a_x * y - a_y * x) / (1.0 / mass + reach * reach / system.run[RUN_MOMENT])
    return along * x + across * y, along * y - across * x


def answer_of(system: System, pose: Pose, contact: int, x: float, y: float) -> Answer:
    """The force and the acceleration of a mode, from the relative acceleration without the force.

    Also the impulse and the velocity after it, from the velocity before.
    """
    if contact == STICK:
        f_x, f_y = _force_for(system, pose, -x, -y)
        return Answer(f_x, f_y, 0.0, 0.0)
    if slip_side(contact) == 0.0:
        return Answer(0.0, 0.0, x, y)
    e_x, e_y = edge_of_slip(system, contact)
    along, normal = _acceleration_by(system, pose, e_x, e_y)
    # A force without normal acceleration cannot keep the contact closed; the negative size rejects the
    # slip.
    square = pose.arm_x * pose.arm_x + pose.arm_y * pose.arm_y
    smallest = SLACK * (1.0 / system.scene[IN_MASS] + square / system.run[RUN_MOMENT])
    size = -y / normal if fabs(normal) > smallest else -system.run[RUN_FORCE]
    return Answer(size * e_x, size * e_y, x + size * along, 0.0)


def answer_of_side(system: System, contact: int, x: float, y: float) -> Answer:
    """The force on a side that lies on the fence, from the acceleration of the center of mass without it.

    The acceleration is relative to the fence. As in `answer_of`, also the impulse. The side does not rotate
    with it.
    """
    mass = system.scene[IN_MASS]
    if contact == STICK:
        return Answer(-mass * x, -mass * y, 0.0, 0.0)
    if slip_side(contact) == 0.0:
        return Answer(0.0, 0.0, x, y)
    e_x, e_y = edge_of_slip(system, contact)
    size = -mass * y / e_y if e_y > SLACK else -system.run[RUN_FORCE]
    return Answer(size * e_x, size * e_y, x + size * e_x / mass, 0.0)


def add_impulse(system: System, state: Numbers, p_x: float, p_y: float) -> None:
    """Add an impulse at the contact to those that the next row of the log contains."""
    x, y = to_world(system, state[ANGLE], p_x, p_y)
    system.run[RUN_IMPULSE] += x
    system.run[RUN_IMPULSE + 1] += y


def collide(
    system: System, during: Span, time: float, state: Numbers, current: int, policy: int
) -> int:
    """Change the twist by the impulse that the policy prefers; return why there is none, or `GOES_ON`."""
    left, right = side_on_fence(system, state)
    if left >= 0:
        return _collide_side(system, during, time, state, left, right, current, policy)
    if max(fabs(state[SLIP_SPEED]), fabs(state[NORMAL_SPEED])) <= SLACK * system.run[RUN_SPEED]:
        state[SLIP_SPEED], state[NORMAL_SPEED] = 0.0, 0.0
        return GOES_ON
    chosen = _mode_at_point(system, state, 0.0, SEPARATE, current, policy, NO_MODE)
    if chosen == NO_MODE:
        return NO_IMPULSE
    _strike_point(system, during, time, state, chosen)
    return GOES_ON


def _mode_at_point(
    system: System, state: Numbers, length: float, first: int, current: int, policy: int, other: int
) -> int:
    """The preferred mode of an impact at the contact, from a first one on, or the other if it is as good.

    With a side of a signed length, its other end may not approach after the impact.
    """
    x, y, pose, chosen = state[SLIP_SPEED], state[NORMAL_SPEED], pose_of(system, state), other
    for contact in range(first, SLIP_LEFT + 1):
        preferred: bool = is_preferred(policy, current, contact, chosen)
        if preferred and _is_consistent(system, pose, contact, x, y):
            impulse = answer_of(system, pose, contact, x, y)
            turn = moment_of(pose, impulse.f_x, impulse.f_y) / system.run[RUN_MOMENT]
            leaves = impulse.y + (state[SPIN] + turn) * length
            if length == 0.0 or leaves >= -SLACK * system.run[RUN_SPEED]:
                chosen = contact
    return chosen


def _strike_point(system: System, during: Span, time: float, state: Numbers, contact: int) -> None:
    """Change the twist by the impulse of a mode at the contact."""
    x, y, pose = state[SLIP_SPEED], state[NORMAL_SPEED], pose_of(system, state)
    impulse = answer_of(system, pose, contact, x, y)
    p_x, p_y = impulse.f_x, impulse.f_y
    add_impulse(system, state, p_x, p_y)
    state[SLIP_SPEED], state[NORMAL_SPEED] = impulse.x, impulse.y
    state[SPIN] += moment_of(pose, p_x, p_y) / system.run[RUN_MOMENT]
    fence_x, fence_y = pusher_velocity(system, during, time, state)
    state[WORK] += p_x * fence_x + p_y * fence_y
    state[LOST] -= p_x * (x + impulse.x) / 2.0 + p_y * (y + impulse.y) / 2.0


def _collide_side(
    system: System, during: Span, time: float, state: Numbers, left: int, right: int,
    current: int, policy: int,
) -> int:  # fmt: skip
    """`collide` at both ends of a side, or at one of them if the other one would be pulled.

    Of equal modes, both ends come first, then the end that arrives faster.
    """
    hold_contact(system, state, left, NO_POINT)
    length, slack = offset_of(system, state, right).x, SLACK * system.run[RUN_SPEED]
    x, first, last = (
        state[SLIP_SPEED],
        state[NORMAL_SPEED],
        state[NORMAL_SPEED] + state[SPIN] * length,
    )
    if max(max(fabs(x), fabs(first)), fabs(last)) <= slack:
        state[SLIP_SPEED], state[NORMAL_SPEED], state[SPIN] = 0.0, 0.0, 0.0
        return GOES_ON
    chosen = SEPARATE if min(first, last) >= -slack else NO_MODE
    chosen = _mode_on_side(system, state, length, current, policy, chosen)
    struck = NO_POINT
    for i in range(2):
        at_left: bool = (first <= last) == (i == 0)
        end, reach = left if at_left else right, length if at_left else -length
        hold_contact(system, state, end, NO_POINT)
        contact = _mode_at_point(system, state, reach, STICK, current, policy, chosen)
        if contact != chosen:
            chosen, struck = contact, end
    if chosen == NO_MODE:
        return NO_IMPULSE
    hold_contact(system, state, left if struck < 0 else struck, NO_POINT)
    if struck >= 0:
        _strike_point(system, during, time, state, chosen)
    elif chosen != SEPARATE:
        _strike_side(system, during, time, state, length, chosen)
    return GOES_ON


def _motion_of_mass(state: Numbers, pose: Pose) -> tuple[float, float]:
    """Velocity of the center of mass relative to the pusher."""
    spin = state[SPIN]
    return state[SLIP_SPEED] - spin * pose.arm_y, state[NORMAL_SPEED] + spin * pose.arm_x


def _mode_on_side(
    system: System, state: Numbers, length: float, current: int, policy: int, other: int
) -> int:
    """The preferred mode of an impact at both ends of a side; the other mode if it is as good."""
    pose, spin, chosen = pose_of(system, state), state[SPIN], other
    x, y = _motion_of_mass(state, pose)
    for contact in range(STICK, SLIP_LEFT + 1):
        preferred: bool = is_preferred(policy, current, contact, chosen)
        if preferred and _fits_side(system, pose, contact, x, y, spin, length):
            chosen = contact
    return chosen


def _strike_side(
    system: System, during: Span, time: float, state: Numbers, length: float, contact: int
) -> None:
    """Stop the rotation and the normal motion of a side by the impulse of a mode at both of its ends."""
    pose, spin, x, first = (
        pose_of(system, state),
        state[SPIN],
        state[SLIP_SPEED],
        state[NORMAL_SPEED],
    )
    v_x, v_y = _motion_of_mass(state, pose)
    impulse = answer_of_side(system, contact, v_x, v_y)
    p_x, p_y = impulse.f_x, impulse.f_y
    add_impulse(system, state, p_x, p_y)
    at_last = _torque_on_side(system, pose, p_x, p_y, spin) / length
    state[SLIP_SPEED], state[NORMAL_SPEED], state[SPIN] = impulse.x, 0.0, 0.0
    fence_x, fence_y = pusher_velocity(system, during, time, state)
    state[WORK] += p_x * fence_x + p_y * fence_y
    twice_work = p_x * (x + impulse.x) + p_y * first + at_last * spin * length
    state[LOST] -= twice_work / 2.0


def _torque_on_side(system: System, pose: Pose, p_x: float, p_y: float, spin: float) -> float:
    """Torque about the contact of an impulse on a side that stops the rotation."""
    return -(system.run[RUN_MOMENT] * spin + moment_of(pose, p_x, p_y))


def _fits_side(
    system: System, pose: Pose, contact: int, x: float, y: float, spin: float, length: float
) -> bool:
    """Whether the impulse at both ends of a side lies in the cone and pushes at each of them."""
    impulse = answer_of_side(system, contact, x, y)
    torque = _torque_on_side(system, pose, impulse.f_x, impulse.f_y, spin)
    press = support_of_side(length, impulse.f_y, torque).press
    size = fabs(impulse.f_x) + fabs(impulse.f_y)
    if press < -SLACK * size and system.scene[IN_ROUGH] == 0.0:
        return False
    if contact == STICK:
        return _admits_impulse(system, impulse.f_x, impulse.f_y)
    slips: bool = slip_side(contact) * impulse.x > SLACK * system.run[RUN_SPEED]
    return system.scene[IN_SLIPS] != 0.0 and impulse.f_y > 0.0 and slips


def _is_consistent(system: System, pose: Pose, contact: int, x: float, y: float) -> bool:
    """Whether the impulse of a mode lies in the cone and the resulting motion agrees with the mode."""
    slack = SLACK * system.run[RUN_SPEED]
    if contact == SEPARATE:
        return y >= -slack
    impulse = answer_of(system, pose, contact, x, y)
    if contact == STICK:
        return _admits_impulse(system, impulse.f_x, impulse.f_y)
    e_x, e_y = edge_of_slip(system, contact)
    pushes: bool = impulse.f_x * e_x + impulse.f_y * e_y > 0.0
    slips: bool = slip_side(contact) * impulse.x > slack
    return system.scene[IN_SLIPS] != 0.0 and pushes and slips
