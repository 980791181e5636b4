"""The contact frame, with +y along the normal at the contact, and the body frame, with x along the rod."""

from __future__ import annotations

from math import cos, sin, sqrt
from typing import NamedTuple

from planar_pushing.simulation.legacy.compiled import compiled
from planar_pushing.simulation.legacy.motion import Contact
from planar_pushing.simulation.legacy.plane import Rod


class Pose(NamedTuple):
    """Pose of the slider in the contact frame.

    Attributes
    ----------
    frame : Rod
        Unit vector along body x in the contact frame.
    at : Contact
        Contact in the body frame.
    x, y : float
        Vector from the contact to the slider's center.
    arm_x, arm_y : float
        Vector from the contact to the center of mass.
    """

    frame: Rod
    at: Contact
    x: float
    y: float
    arm_x: float
    arm_y: float


class Motion(NamedTuple):
    """The motion at an instant, along the axes of the contact frame.

    Attributes
    ----------
    slip, rise : float
        Velocity of the contact relative to the fence.
    fence_x, fence_y : float
        Velocity of the fence.
    v_x, v_y, spin, speed : float
        Twist of the slider's center, and the center's speed.
    f_x, f_y : float
        Force of the fence on the slider.
    rubbed : float
        Power dissipated by support friction.
    a_x, a_y, turn : float
        Acceleration of the contact relative to the fence, and angular acceleration; zero without inertia.
    lift : float
        Normal acceleration of the contact without the contact force; without inertia, its normal velocity
        in a slip of unit magnitude.
    pivot : int
        Number of the support point about which the slider pivots, -1 without one.
    hold : float
        Margin of the friction force that holds a hinge, 1 without a hinge.
    """

    slip: float
    rise: float
    fence_x: float
    fence_y: float
    v_x: float
    v_y: float
    spin: float
    speed: float
    f_x: float
    f_y: float
    rubbed: float
    a_x: float
    a_y: float
    turn: float
    lift: float
    pivot: int
    hold: float


@compiled
def at_rest(x, y, a_x, a_y, f_x, f_y):
    """Motion of a slider at rest relative to a fence with a velocity and an acceleration."""
    return Motion(
        -x, -y, x, y, 0.0, 0.0, 0.0, 0.0, f_x, f_y, 0.0, -a_x, -a_y, 0.0, 0.0, -1, 1.0
    )  # fmt: skip


@compiled
def frame_of(angle):
    """Direction of body x at an angle."""
    return Rod(1.0, angle, cos(angle), sin(angle))


@compiled
def to_body(frame, x, y):
    """Transform a vector from the contact frame to the body frame."""
    return x * frame.x + y * frame.y, y * frame.x - x * frame.y


@compiled
def to_contact(frame, x, y):
    """Transform a vector from the body frame to the contact frame."""
    return x * frame.x - y * frame.y, x * frame.y + y * frame.x


@compiled
def pose_at(frame, at, center):
    """Pose of a slider with the contact at a position in the body frame."""
    x, y = to_contact(frame, -at.x, -at.y)
    arm_x, arm_y = to_contact(frame, center[0] - at.x, center[1] - at.y)
    return Pose(frame, at, x, y, arm_x, arm_y)


@compiled
def contact_motion(now, v_x, v_y, spin):
    """Motion of the contact under a twist of the slider's center."""
    return v_x + spin * now.y, v_y - spin * now.x


@compiled
def center_motion(now, u_x, u_y, spin):
    """Motion of the slider's center for a motion of the contact and a rotation."""
    return u_x - spin * now.y, u_y + spin * now.x


@compiled
def size_of(v_x, v_y, spin):
    """Magnitude of a twist: combined speed of the slider's center and of the rotation."""
    return sqrt(v_x * v_x + v_y * v_y) + abs(spin)


@compiled
def kinetic_energy(body, now, v_x, v_y, spin):
    """Kinetic energy of a slider; its center has the velocity (v_x, v_y)."""
    v_x, v_y = v_x - spin * (now.arm_y - now.y), v_y + spin * (now.arm_x - now.x)
    return (body.mass * (v_x * v_x + v_y * v_y) + body.moment * spin * spin) / 2
