"""A slider with inertia that pivots about a support point, which friction holds like a hinge."""

from __future__ import annotations

from math import copysign, sqrt

from planar_pushing.simulation.legacy.compiled import compiled
from planar_pushing.simulation.systems import base, contact
from planar_pushing.simulation.systems.shapes.base import relative


@compiled
def hinged_motion(system, now, kind, q_x, q_y, free, velocity, fence):
    """Accelerations about a hinge, in flight or in a slip, and the forces required.

    Parameters
    ----------
    system : Inertial
    now : Pose
    kind : int
        Contact mode.
    q_x, q_y : float
        Vector from the center of mass to the hinge.
    free : (a_x, a_y, turn)
        Acceleration of the center of mass and angular acceleration without hinge and contact.
    velocity : (slip, rise, spin)
    fence : (a_x, a_y)
        Acceleration of the fence.

    Returns
    -------
    f_x, f_y : float
        Force of the fence.
    a_x, a_y, turn : float
        Acceleration of the contact relative to the fence, and angular acceleration.
    lift : float
        Normal acceleration of the contact without the contact force.
    p_x, p_y : float
        Force of the hinge.
    """
    body, (a_x, a_y, turn), (slip, rise, spin) = system.body, free, velocity
    whole, square = body.moment + body.mass * (q_x * q_x + q_y * q_y), spin * spin
    # Vector from the hinge to the contact.
    d_x, d_y = -(now.arm_x + q_x), -(now.arm_y + q_y)
    torque = body.moment * turn - body.mass * (q_x * a_y - q_y * a_x)
    open_turn = torque / whole
    along, lift = _at(system, slip, rise, spin, open_turn, d_x, d_y, fence)
    f_x, f_y, a_along, a_normal, turn = 0.0, 0.0, along, lift, open_turn
    if kind != base.SEPARATE:
        e_x, e_y, _ = contact.edge_of(body, kind)
        turn = open_turn - lift / d_x if d_x != 0.0 else open_turn
        lever = d_x * e_y - d_y * e_x
        size = (whole * turn - torque) / lever if lever != 0.0 else 0.0
        f_x, f_y = size * e_x, size * e_y
        a_along, a_normal = _at(system, slip, rise, spin, turn, d_x, d_y, fence)[0], 0.0
    # The center of mass rotates about the hinge.
    c_x, c_y = turn * q_y + square * q_x, -turn * q_x + square * q_y
    p_x, p_y = body.mass * (c_x - a_x) - f_x, body.mass * (c_y - a_y) - f_y
    return f_x, f_y, a_along, a_normal, turn, lift, p_x, p_y


@compiled
def passing_friction(system, now, q_x, q_y, free, held, velocity, share):
    """Friction at a support point when the center of rotation passes it while the contact sticks.

    The contact determines the point's velocity along the line between them. This velocity changes sign, and
    the friction along the line jumps. The friction across the line keeps the center of rotation on the line
    as long as it is less than the share.

    Parameters
    ----------
    system : Inertial
    now : Pose
    q_x, q_y : float
        Vector from the center of mass to the point.
    free : (a_x, a_y, turn)
        Acceleration of the center of mass and angular acceleration without point and contact.
    held : (a_x, a_y)
        Acceleration of the slider's point at the contact.
    velocity : (w_x, w_y)
        Velocity of the point.
    share : float
        Maximum friction force at the point.
    """
    body, (a_x, a_y, turn), (w_x, w_y) = system.body, free, velocity
    d_x, d_y = now.arm_x + q_x, now.arm_y + q_y
    reach = sqrt(d_x * d_x + d_y * d_y)
    size = sqrt(w_x * w_x + w_y * w_y)
    if reach > 0.0:
        whole = body.moment + body.mass * (now.arm_x * now.arm_x + now.arm_y * now.arm_y)
        held_turn = -(held[1] * d_x - held[0] * d_y) / (reach * reach)
        torque = body.moment * turn + body.mass * (now.arm_x * a_y - now.arm_y * a_x)
        torque -= body.mass * (now.arm_x * held[1] - now.arm_y * held[0])
        across = (whole * held_turn - torque) / reach
        if abs(across) < share:
            along = -copysign(sqrt(share * share - across * across), w_x * d_x + w_y * d_y)
            return (along * d_x - across * d_y) / reach, (along * d_y + across * d_x) / reach
    part = -share / size if size > 0.0 else 0.0
    return part * w_x, part * w_y


@compiled
def _at(system, slip, rise, spin, turn, d_x, d_y, fence):
    """Acceleration, relative to the fence, of a contact at (d_x, d_y) from the hinge."""
    square = spin * spin
    a_x, a_y = -turn * d_y - square * d_x, turn * d_x - square * d_y
    return relative(system.shape, spin, slip, rise, a_x - fence[0], a_y - fence[1])
