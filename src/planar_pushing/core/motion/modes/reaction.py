"""Forces at the contact of a slider with inertia, by contact mode.

With r from the contact to the center of mass, a force f at the contact accelerates it by
``f / m + (r_y f_x - r_x f_y) (r_y, -r_x) / J``.
"""

from __future__ import annotations

from math import atan2, fabs, sqrt
from typing import NamedTuple

from planar_pushing.core.instant.directions import QUARTER_TURN
from planar_pushing.core.instant.solution import SLIP_RIGHT, STICK
from planar_pushing.core.motion.kinematics.mode import slip_side
from planar_pushing.core.motion.kinematics.shapes import Pose
from planar_pushing.core.motion.kinematics.system import System
from planar_pushing.core.supports.tolerances import RESOLUTION, SLACK


class Reaction(NamedTuple):
    """The force of a mode, and the relative acceleration of the contact with it."""

    f_x: float
    f_y: float
    x: float
    y: float


def edge_of_slip(system: System, contact: int) -> tuple[float, float]:
    """Direction of the force in a slipping mode, on the edge that opposes the slip."""
    run = system.run
    if contact == SLIP_RIGHT:
        return run.left.x, run.left.y
    return run.right.x, run.right.y


def edge_angle(system: System, contact: int) -> float:
    """Angle of the force in a slipping mode."""
    return system.scene.left if contact == SLIP_RIGHT else system.scene.right


def cone_margin(system: System, f_x: float, f_y: float, smallest: float) -> float:
    """Margin of a force in the friction cone, negative outside.

    It is the angle to the nearer edge, with a weight that is small for forces below `smallest`, so that the
    margin is smooth and 0 for zero force.
    """
    scene = system.scene
    if scene.rough:
        return 1.0
    size = sqrt(f_x * f_x + f_y * f_y)
    half = (scene.left - scene.right) / 2.0 + system.run.wall.pocket
    if half > QUARTER_TURN:
        return 1.0
    if size == 0.0:
        return 0.0
    # A force that is the rounding error of zero has any direction; the square makes it negligible.
    part = smallest / size
    return (half - fabs(atan2(f_x, f_y))) / (1.0 + part * part)


def moment_of(pose: Pose, f_x: float, f_y: float) -> float:
    """Torque of a force at the contact about the center of mass."""
    return pose.arm_y * f_x - pose.arm_x * f_y


def _acceleration_by(system: System, pose: Pose, f_x: float, f_y: float) -> tuple[float, float]:
    """Acceleration of the contact due to a force there."""
    turn = moment_of(pose, f_x, f_y) / system.run.moment
    mass = system.scene.mass
    return f_x / mass + turn * pose.arm_y, f_y / mass - turn * pose.arm_x


def _force_for(system: System, pose: Pose, a_x: float, a_y: float) -> tuple[float, float]:
    """Force at the contact that gives it an acceleration."""
    mass, reach = system.scene.mass, sqrt(pose.arm_x * pose.arm_x + pose.arm_y * pose.arm_y)
    if reach == 0.0:
        return mass * a_x, mass * a_y
    # The effective mass is the mass along the arm, and less across it; components along these directions
    # avoid cancellation for a long arm.
    x, y = pose.arm_x / reach, pose.arm_y / reach
    along = mass * (a_x * x + a_y * y)
    across = (a_x * y - a_y * x) / (1.0 / mass + reach * reach / system.run.moment)
    return along * x + across * y, along * y - across * x


def reaction_of(system: System, pose: Pose, contact: int, x: float, y: float) -> Reaction:
    """The force and the acceleration of a mode, from the relative acceleration without the force."""
    if contact == STICK:
        f_x, f_y = _force_for(system, pose, -x, -y)
        return Reaction(f_x, f_y, 0.0, 0.0)
    if slip_side(contact) == 0.0:
        return Reaction(0.0, 0.0, x, y)
    e_x, e_y = edge_of_slip(system, contact)
    along, normal = _acceleration_by(system, pose, e_x, e_y)
    # A force without normal acceleration cannot keep the contact closed; the negative size rejects the
    # slip.
    square = pose.arm_x * pose.arm_x + pose.arm_y * pose.arm_y
    smallest = RESOLUTION * (1.0 / system.scene.mass + square / system.run.moment)
    size = -y / normal if fabs(normal) > smallest else -system.run.force
    return Reaction(size * e_x, size * e_y, x + size * along, 0.0)


def reaction_of_side(system: System, contact: int, x: float, y: float) -> Reaction:
    """The force on a side that lies on the fence, from the acceleration of the center of mass without it.

    The acceleration is relative to the fence. The side does not rotate with it.
    """
    mass = system.scene.mass
    if contact == STICK:
        return Reaction(-mass * x, -mass * y, 0.0, 0.0)
    if slip_side(contact) == 0.0:
        return Reaction(0.0, 0.0, x, y)
    e_x, e_y = edge_of_slip(system, contact)
    size = -mass * y / e_y if e_y > SLACK else -system.run.force
    return Reaction(size * e_x, size * e_y, x + size * e_x / mass, 0.0)
