"""The motion of a slider with inertia in a mode, whose twist is part of the state (Secs. 4 and 5).

The state holds the velocity of the contact relative to the pusher and the angular velocity. A sticking
contact then has exactly zero relative velocity, and a slipping one exactly zero normal velocity. The
contact force follows from the mode, and the accelerations follow from the force. While the slider pivots
about a support point, its twist is that of the rotation about this point.
"""

from __future__ import annotations

from math import fabs, sqrt
from typing import NamedTuple

from planar_pushing.core.instant.solution import SEPARATE, STICK
from planar_pushing.core.motion.kinematics.drag import drag, friction_effects, load_at
from planar_pushing.core.motion.kinematics.instant import (
    Instant,
    Support,
    instant_at_rest,
    support_of_side,
)
from planar_pushing.core.motion.kinematics.mode import REST, Mode
from planar_pushing.core.motion.kinematics.rolling import rates_of_contact, sticking_acceleration
from planar_pushing.core.motion.kinematics.shapes import (
    Pose,
    center_motion,
    contact_motion,
    pose_of,
    pusher_acceleration,
    pusher_velocity,
    size_of_twist,
    to_body,
    to_contact,
)
from planar_pushing.core.motion.kinematics.system import STATE, RunState, System, vector_of
from planar_pushing.core.motion.kinematics.touch import is_flush, side_length
from planar_pushing.core.motion.modes.feet import (
    leaving_friction,
    leaving_speed,
    passing_friction,
    slowest_foot_at,
    speed_at_center,
    speed_of_foot,
)
from planar_pushing.core.motion.modes.reaction import (
    edge_of_slip,
    moment_of,
    reaction_of,
    reaction_of_side,
)
from planar_pushing.core.numbers import UNKNOWN
from planar_pushing.core.supports.rows import NO_POINT, foot_position
from planar_pushing.core.supports.tolerances import (
    AT_REST,
    NO_DIRECTION,
    PART_OF_STEP,
    PUSHES,
    STOPPED,
)


class Hinge(NamedTuple):
    """Accelerations about a hinge, and the forces required.

    Attributes
    ----------
    f_x, f_y : float
        Force of the pusher.
    a_x, a_y, turn : float
        Acceleration of the contact relative to the pusher, and angular acceleration.
    lift : float
        Normal acceleration of the contact without the contact force.
    p_x, p_y : float
        Force of the hinge.
    """

    f_x: float
    f_y: float
    a_x: float
    a_y: float
    turn: float
    lift: float
    p_x: float
    p_y: float


def _hinged_motion(
    system: System, pose: Pose, contact: int, q_x: float, q_y: float,
    a_x: float, a_y: float, turn: float, gap: float, slip: float, normal_speed: float, spin: float,
    b_x: float, b_y: float,
) -> Hinge:  # fmt: skip
    """Accelerations of a slider that friction holds at a support point like a hinge, free or in a slip.

    Parameters
    ----------
    system : System
    pose : Pose
    contact : int
        Contact mode.
    q_x, q_y : float
        Vector from the center of mass to the hinge.
    a_x, a_y, turn : float
        Acceleration of the center of mass and angular acceleration without hinge and contact.
    gap, slip, normal_speed, spin : float
        Distance and velocity of the contact relative to the pusher, and angular velocity.
    b_x, b_y : float
        Acceleration of the pusher.
    """
    mass, moment = system.scene.mass, system.run.moment
    total, square = moment + mass * (q_x * q_x + q_y * q_y), spin * spin
    # Vector from the hinge to the contact.
    d_x, d_y = -(pose.arm_x + q_x), -(pose.arm_y + q_y)
    torque = moment * turn - mass * (q_x * a_y - q_y * a_x)
    free_turn = torque / total
    along, lift = _rates_about_hinge(
        system, gap, slip, normal_speed, spin, free_turn, d_x, d_y, b_x, b_y
    )
    f_x, f_y, rate_x, rate_y, turn = 0.0, 0.0, along, lift, free_turn
    if contact != SEPARATE:
        e_x, e_y = edge_of_slip(system, contact)
        turn = free_turn - lift / d_x if d_x != 0.0 else free_turn
        lever = d_x * e_y - d_y * e_x
        size = (total * turn - torque) / lever if lever != 0.0 else 0.0
        f_x, f_y, rate_y = size * e_x, size * e_y, 0.0
        rate_x, _ = _rates_about_hinge(
            system, gap, slip, normal_speed, spin, turn, d_x, d_y, b_x, b_y
        )
    # The center of mass rotates about the hinge.
    c_x, c_y = turn * q_y + square * q_x, -turn * q_x + square * q_y
    p_x, p_y = mass * (c_x - a_x) - f_x, mass * (c_y - a_y) - f_y
    return Hinge(f_x, f_y, a_x=rate_x, a_y=rate_y, turn=turn, lift=lift, p_x=p_x, p_y=p_y)


def _rates_about_hinge(
    system: System, gap: float, slip: float, normal_speed: float, spin: float, turn: float,
    d_x: float, d_y: float, b_x: float, b_y: float,
) -> tuple[float, float]:  # fmt: skip
    """Rates of the velocity, relative to the pusher, of a contact at (d_x, d_y) from the hinge."""
    square = spin * spin
    a_x, a_y = -turn * d_y - square * d_x, turn * d_x - square * d_y
    return rates_of_contact(system, gap, spin, slip, normal_speed, a_x=a_x - b_x, a_y=a_y - b_y)


def slowest_motion(system: System) -> float:
    """Speed, relative to the typical one, below which a motion that stops is completed in closed form.

    It is well above the integrator's error, so that no step passes the slider's rest.
    """
    return max(STOPPED, PART_OF_STEP * system.scene.tolerance)


def push_in_mode(contact: int, fence_x: float, fence_y: float) -> float:
    """Speed that the pusher imposes on the contact."""
    if contact == SEPARATE:
        return 0.0
    return fabs(fence_y) if contact != STICK else sqrt(fence_x * fence_x + fence_y * fence_y)


def motion_beside_push(system: System, size: float, pushed: float) -> float:
    """Size of a motion, to be compared with `slowest_motion`.

    At a loose tolerance, a slider that a slow pusher moves is slower than that, but does not stop.
    """
    return size + (slowest_motion(system) / STOPPED - 1.0) * pushed


def motion_with_inertia(system: System, mode: Mode, time: float, state: RunState) -> Instant:
    """The motion at an instant in a mode."""
    fence_x, fence_y = pusher_velocity(system, mode.during, time, state)
    b_x, b_y = pusher_acceleration(system, mode.during, time, state)
    if mode.contact == REST:
        return instant_at_rest(
            x=fence_x, y=fence_y, a_x=b_x, a_y=b_y, f_x=mode.f_x, f_y=mode.f_y, offset=mode.offset
        )
    mass, moment = system.scene.mass, system.run.moment
    pose, spin = pose_of(system, state), state.spin
    system.run.evaluations += 1
    slip, normal_speed, foot_x, foot_y = state.slip_speed, state.normal_speed, 0.0, 0.0
    v_x, v_y = center_motion(pose, fence_x + slip, fence_y + normal_speed, spin)
    number = mode.foot
    sticks: bool = mode.contact == STICK
    if is_flush(system):
        number = NO_POINT
    elif sticks:
        foot = slowest_foot_at(system, pose, v_x, v_y, spin)
        passes: bool = foot.speed < leaving_speed(system, size_of_twist(v_x, v_y, spin))
        number = foot.number if passes else NO_POINT
    t_x, t_y = v_x, v_y
    turns: bool = number >= 0
    if turns:
        # Rotation exactly about the support point.
        point = foot_position(friction_effects(system), number)
        foot_x, foot_y = to_contact(pose.rod, point.x, point.y)
        t_x, t_y = spin * foot_y, -spin * foot_x
        if mode.hinged:
            v_x, v_y = t_x, t_y
            u_x, u_y = contact_motion(pose, v_x, v_y, spin)
            slip, normal_speed = u_x - fence_x, u_y - fence_y if mode.contact == SEPARATE else 0.0
    x, y, opposed_spin = _opposed_twist(system, mode, pose, v_x=t_x, v_y=t_y, spin=spin)
    total = drag(system, x, y, opposed_spin)
    x, y = to_body(pose.rod, v_x, v_y)
    dissipated = total.f_x * x + total.f_y * y + total.torque * spin
    load = load_at(system, state.angle)
    d_x, d_y = load.x - total.f_x, load.y - total.f_y
    torque = load.spin - total.torque
    torque -= system.scene.center.x * d_y - system.scene.center.y * d_x
    d_x, d_y = to_contact(pose.rod, d_x, d_y)
    a_x, a_y, turn, hold = d_x / mass, d_y / mass, torque / moment, 1.0
    f_x, f_y, lift, rate_x, rate_y, hinged_turn = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    support = Support(0.0, UNKNOWN)
    q_x, q_y = foot_x + pose.x - pose.arm_x, foot_y + pose.y - pose.arm_y
    if turns and sticks:
        w_x, w_y = v_x - t_x, v_y - t_y
        s_x, s_y = sticking_acceleration(system, spin, b_x, b_y)
        size, typical = size_of_twist(v_x, v_y, spin), system.run.speed
        slowest = max(AT_REST * typical, speed_at_center(system, size) * size)
        is_at_center: bool = w_x * w_x + w_y * w_y <= slowest * slowest
        p_x, p_y = passing_friction(
            system,
            pose,
            q_x,
            q_y,
            a_x,
            a_y,
            turn,
            b_x=s_x,
            b_y=s_y,
            w_x=w_x,
            w_y=w_y,
            spin=spin,
            share=total.limit,
            leaves=mode.foot == number,
            is_at_center=is_at_center,
            speed=speed_of_foot(system, mode, number),
        )
        a_x, a_y = a_x + p_x / mass, a_y + p_y / mass
        turn += (q_x * p_y - q_y * p_x) / moment
        dissipated -= p_x * w_x + p_y * w_y
    elif turns:
        hinge = _hinged_motion(
            system,
            pose,
            mode.contact,
            q_x,
            q_y,
            a_x,
            a_y,
            turn,
            state.gap,
            slip,
            normal_speed,
            spin,
            b_x,
            b_y,
        )
        f_x, f_y, rate_x, rate_y, hinged_turn, lift = (
            hinge.f_x, hinge.f_y, hinge.a_x, hinge.a_y, hinge.turn, hinge.lift,
        )  # fmt: skip
        p_x, p_y = hinge.p_x, hinge.p_y
        carried = sqrt(p_x * p_x + p_y * p_y)
        hold = (total.limit - carried) / (total.limit + carried)
        if not mode.hinged:
            # At a point that begins to move, friction equals its full share.
            p_x, p_y, leaves = leaving_friction(
                system, pose, mode.contact, q_x, q_y, p_x, p_y, total.limit, mode.departure
            )
            hold = 1.0 if leaves else -1.0
            a_x, a_y = a_x + p_x / mass, a_y + p_y / mass
            turn += (q_x * p_y - q_y * p_x) / moment
            dissipated -= p_x * (v_x - t_x) + p_y * (v_y - t_y)
    if mode.hinged:
        turn = hinged_turn
    elif is_flush(system):
        length = side_length(system, state)
        lift = min(a_y - turn * pose.arm_x, a_y + turn * (length - pose.arm_x)) - b_y
        reaction = reaction_of_side(system, mode.contact, a_x - b_x, a_y - b_y)
        f_x, f_y, rate_x = reaction.f_x, reaction.f_y, reaction.x
        torque = -(moment * turn + moment_of(pose, f_x, f_y))
        support, turn = support_of_side(length, f_y, torque), 0.0
    else:
        free_x, free_y = _acceleration_of_contact(pose, a_x, a_y, turn, spin)
        free_x, lift = rates_of_contact(
            system, state.gap, spin, slip, normal_speed, a_x=free_x - b_x, a_y=free_y - b_y
        )
        reaction = reaction_of(system, pose, mode.contact, x=free_x, y=lift)
        f_x, f_y, rate_x, rate_y = reaction.f_x, reaction.f_y, reaction.x, reaction.y
        turn += moment_of(pose, f_x, f_y) / moment
    return Instant(
        slip,
        normal_speed,
        fence_x,
        fence_y,
        v_x,
        v_y,
        spin,
        speed=sqrt(v_x * v_x + v_y * v_y),
        f_x=f_x,
        f_y=f_y,
        dissipated=dissipated,
        a_x=rate_x,
        a_y=rate_y,
        turn=turn,
        lift=lift,
        slip_margin=0.0,
        pivot=mode.foot if mode.hinged else NO_POINT,
        hold=hold,
        offset=support.offset,
        press=support.press,
    )


def _opposed_twist(
    system: System, mode: Mode, pose: Pose, v_x: float, v_y: float, spin: float
) -> tuple[float, float, float]:
    """Twist, in the body frame, that friction opposes.

    From rest it is the impending twist. At a stop, where the twist vanishes, it is that at the start of the
    step.
    """
    x, y = to_body(pose.rod, v_x, v_y)
    starts: bool = mode.start.x != 0.0 or mode.start.y != 0.0 or mode.start.spin != 0.0
    # The velocity of a start is the difference of those of contact and pusher, and loses digits; but its
    # direction changes with the acceleration of the pusher.
    slowest = PUSHES if starts else NO_DIRECTION
    if size_of_twist(v_x, v_y, spin) > slowest * system.run.speed:
        return x, y, spin
    if starts:
        x, y = to_body(pose.rod, mode.start.x, mode.start.y)
        return x, y, mode.start.spin
    state = vector_of(system, STATE)
    start = pose_of(system, state)
    w_x, w_y = pusher_velocity(system, mode.during, system.run.time, state)
    u_x, u_y = center_motion(start, w_x + state.slip_speed, w_y + state.normal_speed, state.spin)
    if size_of_twist(u_x, u_y, state.spin) <= NO_DIRECTION * system.run.speed:
        return x, y, spin
    x, y = to_body(start.rod, u_x, u_y)
    return x, y, state.spin


def _acceleration_of_contact(
    pose: Pose, a_x: float, a_y: float, turn: float, spin: float
) -> tuple[float, float]:
    """Acceleration of the contact from that of the center of mass."""
    square = spin * spin
    x = a_x + turn * pose.arm_y + square * pose.arm_x
    return x, a_y - turn * pose.arm_x + square * pose.arm_y
