"""The contact's frame, whose +y is the normal there, and in it the body frame, whose x is along the rod."""

from __future__ import annotations

from math import cos, sin, sqrt
from typing import NamedTuple

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.plane import Rod
from planar_pushing.mechanics.reduced.psi import Contact


class Pose(NamedTuple):
    """The slider as the contact sees it.

    Attributes
    ----------
    frame : Rod
        Direction of body x in the contact's frame, of unit length.
    at : Contact
        The contact in the body frame.
    x, y : float
        From the contact to the slider's center.
    arm_x, arm_y : float
        From the contact to the center of mass.
    """

    frame: Rod
    at: Contact
    x: float
    y: float
    arm_x: float
    arm_y: float


class Motion(NamedTuple):
    """The motion at an instant, along the axes of the contact's frame.

    Attributes
    ----------
    slip, rise : float
        Velocity of the contact over the fence.
    fence_x, fence_y : float
        Velocity of the fence.
    v_x, v_y, spin, speed : float
        Twist of the slider's center, and the center's speed.
    f_x, f_y : float
        Force of the fence on the slider.
    rubbed : float
        Power that friction on the support dissipates.
    a_x, a_y, turn : float
        Accelerations of the contact over the fence and of the rotation, zero without inertia.
    lift : float
        Normal acceleration of the contact without the force; without inertia, its normal velocity in a slip
        of unit magnitude.
    pivot : int
        Number of the support point about which the slider pivots, -1 without one.
    hold : float
        Margin of the friction that holds a hinge, 1 without a hinge.
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
    """The motion of a slider at rest over a fence with a velocity and an acceleration."""
    return Motion(
        -x, -y, x, y, 0.0, 0.0, 0.0, 0.0, f_x, f_y, 0.0, -a_x, -a_y, 0.0, 0.0, -1, 1.0
    )  # fmt: skip


@compiled
def frame_of(angle):
    """The direction of body x at an angle."""
    return Rod(1.0, angle, cos(angle), sin(angle))


@compiled
def to_body(frame, x, y):
    """A vector of the contact's frame in the body frame."""
    return x * frame.x + y * frame.y, y * frame.x - x * frame.y


@compiled
def to_contact(frame, x, y):
    """A vector of the body frame in the contact's frame."""
    return x * frame.x - y * frame.y, x * frame.y + y * frame.x


@compiled
def pose_at(frame, at, center):
    """The pose of a slider whose contact is at a position of the body frame."""
    x, y = to_contact(frame, -at.x, -at.y)
    arm_x, arm_y = to_contact(frame, center[0] - at.x, center[1] - at.y)
    return Pose(frame, at, x, y, arm_x, arm_y)


@compiled
def contact_motion(now, v_x, v_y, spin):
    """Motion of the contact under a twist of the slider's center."""
    return v_x + spin * now.y, v_y - spin * now.x


@compiled
def center_motion(now, u_x, u_y, spin):
    """Motion of the slider's center under a motion of the contact and a rotation."""
    return u_x - spin * now.y, u_y + spin * now.x


@compiled
def size_of(v_x, v_y, spin):
    """Speed of the slider's center and of the rotation together."""
    return sqrt(v_x * v_x + v_y * v_y) + abs(spin)


@compiled
def kinetic_energy(body, now, v_x, v_y, spin):
    """Kinetic energy of a slider whose center moves by (v_x, v_y)."""
    v_x, v_y = v_x - spin * (now.arm_y - now.y), v_y + spin * (now.arm_x - now.x)
    return (body.mass * (v_x * v_x + v_y * v_y) + body.moment * spin * spin) / 2
