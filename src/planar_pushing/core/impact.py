"""Forces and impulses at the contact of a slider with inertia, and impacts.

With r from the contact to the center of mass, a force f at the contact accelerates it by
``f / m + (r_y f_x - r_x f_y) (r_y, -r_x) / J``. Impacts are inelastic. Support friction is finite and
therefore contributes no impulse.
"""

from __future__ import annotations

from math import atan2, fabs, sqrt
from typing import NamedTuple

from planar_pushing.core.fence import Span
from planar_pushing.core.numbers import Numbers
from planar_pushing.core.run import (
    IN_CLOSED,
    IN_LEFT,
    IN_MASS,
    IN_RIGHT,
    IN_ROUGH,
    IN_SLIPS,
    RUN_FORCE,
    RUN_LEFT,
    RUN_MOMENT,
    RUN_RIGHT,
    RUN_SPEED,
)
from planar_pushing.core.shapes import Pose, pose_of, pusher_velocity
from planar_pushing.core.solution import SEPARATE, SLIP_LEFT, SLIP_RIGHT, STICK
from planar_pushing.core.system import (
    GOES_ON,
    LOST,
    NO_IMPULSE,
    NO_MODE,
    OVER,
    RISE,
    SPIN,
    WORK,
    System,
    is_preferred,
    slip_side,
)
from planar_pushing.core.tolerances import SLACK


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
    lean = (scene[IN_LEFT] - scene[IN_RIGHT]) / 2.0 - fabs(atan2(f_x, f_y))
    return lean * size / (size + smallest) if size > 0.0 else 0.0


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


def collide(
    system: System, during: Span, time: float, state: Numbers, current: int, policy: int
) -> int:
    """Change the twist by the impulse that the policy prefers; return why there is none, or `GOES_ON`."""
    x, y, speed = state[OVER], state[RISE], system.run[RUN_SPEED]
    if max(fabs(x), fabs(y)) <= SLACK * speed:
        state[OVER], state[RISE] = 0.0, 0.0
        return GOES_ON
    pose, chosen = pose_of(system, state), NO_MODE
    for contact in range(SEPARATE, SLIP_LEFT + 1):
        preferred: bool = is_preferred(policy, current, contact, chosen)
        if preferred and _is_consistent(system, pose, contact, x, y):
            chosen = contact
    if chosen == NO_MODE:
        return NO_IMPULSE
    impulse = answer_of(system, pose, chosen, x, y)
    p_x, p_y = impulse.f_x, impulse.f_y
    state[OVER], state[RISE] = impulse.x, impulse.y
    state[SPIN] += moment_of(pose, p_x, p_y) / system.run[RUN_MOMENT]
    fence_x, fence_y = pusher_velocity(system, during, time, state)
    state[WORK] += p_x * fence_x + p_y * fence_y
    state[LOST] -= p_x * (x + impulse.x) / 2.0 + p_y * (y + impulse.y) / 2.0
    return GOES_ON


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
