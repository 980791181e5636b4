"""The motion at one instant of a run."""

from __future__ import annotations

from typing import NamedTuple

from planar_pushing.core.motion.kinematics.drag import load_at
from planar_pushing.core.motion.kinematics.shapes import Pose, to_body
from planar_pushing.core.motion.kinematics.system import RunState, System
from planar_pushing.core.numbers import UNKNOWN
from planar_pushing.core.supports.rows import NO_POINT


class Instant(NamedTuple):
    """The motion at an instant, along the axes of the contact frame.

    Attributes
    ----------
    slip, normal_speed : float
        Velocity of the contact relative to the pusher.
    fence_x, fence_y : float
        Velocity of the pusher.
    v_x, v_y, spin, speed : float
        Twist of the slider's center, and the center's speed.
    f_x, f_y : float
        Force of the pusher on the slider.
    dissipated : float
        Power dissipated by friction and viscous friction.
    a_x, a_y, turn : float
        Acceleration of the contact relative to the pusher, and angular acceleration; zero without inertia.
    lift : float
        Normal acceleration of the contact without the contact force; zero without inertia.
    slip_margin : float
        Without inertia, a number that is positive while a slip lasts.
    pivot : int
        Number of the support point about which the slider pivots, -1 without one.
    hold : float
        Margin of the friction force that holds a hinge; 1 without a hinge, and -1 at a support point that
        cannot leave the center of rotation.
    offset : float
        Place of the force along the pusher, from the contact.
    press : float
        Smaller of the normal forces at both ends of a side on the fence, NaN at a point of contact.
    """

    slip: float
    normal_speed: float
    fence_x: float
    fence_y: float
    v_x: float
    v_y: float
    spin: float
    speed: float
    f_x: float
    f_y: float
    dissipated: float
    a_x: float
    a_y: float
    turn: float
    lift: float
    slip_margin: float
    pivot: int
    hold: float
    offset: float
    press: float


class Support(NamedTuple):
    """Where a force on a side acts, from its first end, and the smaller normal force at its ends."""

    offset: float
    press: float


def instant_at_rest(
    x: float, y: float, a_x: float, a_y: float, f_x: float, f_y: float, offset: float
) -> Instant:
    """A slider at rest, relative to a pusher with a velocity and an acceleration."""
    return Instant(
        slip=-x,
        normal_speed=-y,
        fence_x=x,
        fence_y=y,
        v_x=0.0,
        v_y=0.0,
        spin=0.0,
        speed=0.0,
        f_x=f_x,
        f_y=f_y,
        dissipated=0.0,
        a_x=-a_x,
        a_y=-a_y,
        turn=0.0,
        lift=0.0,
        slip_margin=0.0,
        pivot=NO_POINT,
        hold=1.0,
        offset=offset,
        press=UNKNOWN,
    )


def load_power(
    system: System, pose: Pose, state: RunState, v_x: float, v_y: float, spin: float
) -> float:
    """Power of the loads."""
    x, y = to_body(pose.rod, v_x, v_y)
    load = load_at(system, state.angle)
    return load.x * x + load.y * y + load.spin * spin


def support_of_side(length: float, normal: float, torque: float) -> Support:
    """Place of a force on a side, from its normal component and its torque about the side's first end."""
    last = torque / length
    return Support(torque / normal if normal != 0.0 else 0.0, min(normal - last, last))
