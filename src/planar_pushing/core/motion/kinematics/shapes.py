"""Where the slider and the pusher are: a fence touches a point of the slider, and a finger a flat side.

Quantities are in the contact frame, with +y along the normal at the contact. At an instant, a fence and a
finger then pose the same problem. A fence is a line that stays parallel to x; its contact is the rod's free
end, or another point of the slider (`touch`), and its contact frame is that of the world.

A finger is a disc that does not rotate, or a point. The contact frame is fixed to the side and rotates with
the slider, so that the direction of body x is constant in it. The contact, which is the finger's point
nearest to the side, travels along the side. The finger's center is one radius r below it. Let w be the
velocity of the slider's contact point relative to the finger. The contact, even if it sticks, travels along
the side at ``-(w_x + r spin)``. With the accelerations a of this point and a_F of the finger,
``dw/dt = a - a_F - 2 spin x w - spin x (r spin, 0)``.

In contact, the finger's center is on a line parallel to the side, so the disc meets other points of the
outline at fixed positions of the contact. Free of the side, its distance from the outline is followed.
"""

from __future__ import annotations

from math import cos, fabs, sin, sqrt
from typing import NamedTuple

from planar_pushing.core.instant.directions import Rod
from planar_pushing.core.motion.kinematics.fence import Span, fence_acceleration, fence_velocity
from planar_pushing.core.motion.kinematics.rolling import contact_in_body, frame_angle, has_finger
from planar_pushing.core.motion.kinematics.system import RunState, System, is_massive
from planar_pushing.core.motion.kinematics.touch import (
    count_points,
)
from planar_pushing.core.numbers import UNKNOWN
from planar_pushing.core.supports.contact import Contact, contact_at, hold_rotation


class Pose(NamedTuple):
    """Pose of the slider in the contact frame.

    Attributes
    ----------
    rod : Rod
        Direction of body x.
    contact : Contact
        Contact in the body frame.
    x, y : float
        Vector from the contact to the slider's center.
    arm_x, arm_y : float
        Vector from the contact to the center of mass.
    """

    rod: Rod
    contact: Contact
    x: float
    y: float
    arm_x: float
    arm_y: float


def hold_pose(pose: Pose) -> Pose:
    """The pose of a slider with a side that stays on the fence."""
    return Pose(pose.rod, hold_rotation(pose.contact, 0.0), pose.x, pose.y, pose.arm_x, pose.arm_y)


def pose_of(system: System, state: RunState) -> Pose:
    """Pose of the slider in a state."""
    angle = frame_angle(system, state)
    return pose_with_rod(system, Rod(1.0, angle, cos(angle), sin(angle)), state)


def pose_with_rod(system: System, rod: Rod, state: RunState) -> Pose:
    """Pose of the slider in a state, for a known direction of body x."""
    scene = system.scene
    c_x, c_y = contact_in_body(system, state, rod.x, rod.y)
    contact = contact_at(c_x, c_y)
    x, y = to_contact(rod, -contact.x, -contact.y)
    arm_x, arm_y = to_contact(rod, scene.center.x - contact.x, scene.center.y - contact.y)
    return Pose(rod, contact, x, y, arm_x, arm_y)


def to_body(rod: Rod, x: float, y: float) -> tuple[float, float]:
    """A vector of the contact frame in the body frame."""
    return x * rod.x + y * rod.y, y * rod.x - x * rod.y


def to_contact(rod: Rod, x: float, y: float) -> tuple[float, float]:
    """A vector of the body frame in the contact frame."""
    return x * rod.x - y * rod.y, x * rod.y + y * rod.x


def frame_turn(system: System, state: RunState) -> float:
    """Angle of the contact frame in the world."""
    return state.angle - frame_angle(system, state)


def from_world(system: System, state: RunState, x: float, y: float) -> tuple[float, float]:
    """A vector of the world in the contact frame."""
    if not has_finger(system):
        return x, y
    turn = frame_turn(system, state)
    c, s = cos(turn), sin(turn)
    return c * x + s * y, c * y - s * x


def to_world(system: System, state: RunState, x: float, y: float) -> tuple[float, float]:
    """A vector of the contact frame in the world."""
    if not has_finger(system):
        return x, y
    turn = frame_turn(system, state)
    c, s = cos(turn), sin(turn)
    return c * x - s * y, c * y + s * x


def pusher_velocity(
    system: System, during: Span, time: float, state: RunState
) -> tuple[float, float]:
    """Velocity of the pusher in the contact frame."""
    x, y = fence_velocity(system.fence, during, time)
    return from_world(system, state, x, y)


def pusher_acceleration(
    system: System, during: Span, time: float, state: RunState
) -> tuple[float, float]:
    """Acceleration of the pusher along the axes of the contact frame."""
    x, y = fence_acceleration(system.fence, during, time)
    return from_world(system, state, x, y)


def contact_motion(pose: Pose, v_x: float, v_y: float, spin: float) -> tuple[float, float]:
    """Motion of the contact under a twist of the slider's center."""
    return v_x + spin * pose.y, v_y - spin * pose.x


def center_motion(pose: Pose, u_x: float, u_y: float, spin: float) -> tuple[float, float]:
    """Motion of the slider's center for a motion of the contact and a rotation."""
    return u_x - spin * pose.y, u_y + spin * pose.x


def size_of_twist(v_x: float, v_y: float, spin: float) -> float:
    """Combined speed of the slider's center and of the rotation."""
    return sqrt(v_x * v_x + v_y * v_y) + fabs(spin)


def kinetic_energy_of(system: System, pose: Pose, v_x: float, v_y: float, spin: float) -> float:
    """Kinetic energy of a slider whose center has the velocity (v_x, v_y)."""
    v_x, v_y = v_x - spin * (pose.arm_y - pose.y), v_y + spin * (pose.arm_x - pose.x)
    energy = system.scene.mass * (v_x * v_x + v_y * v_y)
    return (energy + system.run.moment * spin * spin) / 2.0


def center_position(
    system: System, pose: Pose, state: RunState, x: float, y: float
) -> tuple[float, float]:
    """Position of the slider's center in the world, from the displacement of the pusher."""
    if not has_finger(system):
        return x + state.along + pose.x, y + state.gap + pose.y
    w_x, w_y = to_world(system, state, pose.x, pose.y)
    turn, radius = frame_turn(system, state), system.scene.radius
    half = sin(turn / 2.0)
    # Seen from the finger's center, the contact rotates with the side.
    x, y = x - radius * sin(turn), y - 2.0 * radius * half * half
    return x + w_x, y + w_y


def contact_after_flight(
    system: System, pose: Pose, state: RunState, x: float, y: float,
    path_x: float, path_y: float, turn: float,
) -> tuple[float, float]:  # fmt: skip
    """Position of the contact, along and across, after displacements of the slider's center and the pusher.

    Displacements (x, y) and (path_x, path_y) are in the contact frame before the rotation.
    """
    if not has_finger(system):
        # The center of an arc, which is above the contact, stays above it.
        c, s, up = cos(turn) - 1.0, sin(turn), pose.y - system.run.wall.radius
        x, y = x - (c * pose.x - s * up), y - (s * pose.x + c * up)
        return state.along + (x - path_x), state.gap + (y - path_y)
    c, s, radius, wall = cos(turn), sin(turn), system.scene.radius, system.run.wall
    x, y = pose.x + x - path_x, pose.y + y - path_y
    along, across = c * x + s * y, c * y - s * x
    half = sin(turn / 2.0)
    # The side rotates about the finger's center, and the contact is again one radius above the center.
    along, across = along + radius * s, across - 2.0 * radius * half * half
    a_x, a_y = wall.anchor.x, wall.anchor.y
    along += wall.base + (a_x * wall.rod.x - a_y * wall.rod.y)
    return along, across + (a_x * wall.rod.y + a_y * wall.rod.x)


def is_steady_pusher(system: System, during: Span) -> bool:
    """Whether the pusher's motion is constant in the contact frame while the slider moves."""
    return not has_finger(system) and during.constant


def center_height(system: System, state: RunState) -> float:
    """Height of the slider's center above a fence, relative to the rod; NaN if it is not limited.

    It is the limit of the model if only the rod's end, or one side, is known.
    """
    length = system.scene.length
    if has_finger(system) or has_outline(system) or not length > 0.0:
        return UNKNOWN
    if count_points(system) > 0:
        return (state.gap + pose_of(system, state).y) / length
    return state.gap / length + sin(state.angle)


def has_outline(system: System) -> bool:
    """Whether the slider has an outline."""
    return system.scene.chain > 0


def put_initial_state(system: System, state: RunState) -> None:
    """Store the state at time 0."""
    scene = system.scene
    v_x, v_y, spin = scene.twist.x, scene.twist.y, scene.twist.spin
    for k in range(system.entries):
        state[k] = 0.0
    state.gap, state.angle = scene.gap, scene.angle
    if is_massive(system):
        u_x, u_y = contact_motion(pose_of(system, state), v_x, v_y, spin)
        state.slip_speed, state.normal_speed, state.spin = u_x, u_y, spin
