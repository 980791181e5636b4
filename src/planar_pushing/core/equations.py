"""The equations of motion in a mode: the motion at an instant, the rates of the state, and the guards.

Without inertia the pusher's velocity and the rod's angle determine the twist (Sec. 3). The state then holds
the gap, so that the contact stays exactly on the fence. With inertia the twist is part of the state (Secs.
4 and 5), as the velocity of the contact relative to the pusher and the angular velocity. A sticking contact
then has exactly zero relative velocity, and a slipping one exactly zero normal velocity. The contact force
follows from the mode, and the accelerations follow from the force. While the slider pivots about a support
point, its twist is that of the rotation about this point.
"""

from __future__ import annotations

from math import copysign, cos, fabs, log, sin, sqrt
from typing import NamedTuple

from planar_pushing.core.directions import Rod, direction_at
from planar_pushing.core.force import ContactMotion, motion_at_root, motion_under_force
from planar_pushing.core.impact import answer_of, cone_margin, edge_angle, edge_of_slip, moment_of
from planar_pushing.core.numbers import INFINITY, UNKNOWN, Numbers
from planar_pushing.core.path import Path, find_root, first_sample, sample_at_infinity
from planar_pushing.core.psi import guess_spin, psi
from planar_pushing.core.rows import NO_POINT, Effects, foot_position
from planar_pushing.core.run import (
    IN_LENGTH,
    IN_MASS,
    IN_MASS_X,
    IN_MASS_Y,
    IN_WEIGHT,
    RUN_EVALUATIONS,
    RUN_FEET,
    RUN_FORCE,
    RUN_MOMENT,
    RUN_RING,
    RUN_SPEED,
    RUN_SQUARE,
)
from planar_pushing.core.shapes import (
    Pose,
    center_height,
    center_motion,
    clearance_of,
    contact_motion,
    frame_angle,
    is_steady_pusher,
    outline_height,
    pose_of,
    pusher_acceleration,
    pusher_velocity,
    rates_of_contact,
    room_on_side,
    size_of_twist,
    sticking_acceleration,
    to_body,
    to_contact,
    travel_rate,
)
from planar_pushing.core.solution import SEPARATE, STICK
from planar_pushing.core.system import (
    ALONG,
    ANGLE,
    CAUSES,
    CENTER_AT_POINT,
    CENTER_DOWN,
    END_OF_SIDE,
    FORCE_ENDS,
    GAP,
    KINK,
    LEAVES_CONE,
    LOST,
    NORMAL_REVERSES,
    OVER,
    PENETRATES,
    PIVOT_YIELDS,
    PUSH_STARTS,
    REST,
    RISE,
    SEPARATION_CHANGES,
    SLIDER_STOPS,
    SLIP_ENDS,
    SLIPPED,
    SPIN,
    TANGENTIAL_REVERSES,
    TOUCHES,
    WORK,
    Foot,
    Mode,
    System,
    contact_mode_of,
    drag,
    energies_of,
    friction_effects,
    is_loaded,
    is_massive,
    load_at,
    problem_effects,
    put_load,
    slip_side,
    slowest_foot,
    write_powers,
)
from planar_pushing.core.tolerances import (
    ARRIVED,
    HAS_LEFT,
    NO_DIRECTION,
    NO_FORCE,
    PUSHES,
    SLACK,
    STOPPED,
)


class Instant(NamedTuple):
    """The motion at an instant, along the axes of the contact frame.

    Attributes
    ----------
    slip, rise : float
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
        Normal acceleration of the contact without the contact force; without inertia, a number that is
        positive while a slip lasts.
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
    dissipated: float
    a_x: float
    a_y: float
    turn: float
    lift: float
    pivot: int
    hold: float


def _instant_at_rest(x: float, y: float, a_x: float, a_y: float, f_x: float, f_y: float) -> Instant:
    """A slider at rest, relative to a pusher with a velocity and an acceleration."""
    return Instant(
        -x, -y, x, y, 0.0, 0.0, 0.0, 0.0, f_x, f_y, 0.0, -a_x, -a_y, 0.0, 0.0, NO_POINT, 1.0
    )  # fmt: skip


def motion_in_mode(system: System, mode: Mode, time: float, state: Numbers) -> Instant:
    """The motion at an instant in a mode."""
    if is_massive(system):
        return _motion_with_inertia(system, mode, time, state)
    return _quasi_static_motion(system, mode, time, state)


def load_power(
    system: System, pose: Pose, state: Numbers, v_x: float, v_y: float, spin: float
) -> float:
    """Power of the loads."""
    x, y = to_body(pose.rod, v_x, v_y)
    load = load_at(system, state[ANGLE])
    return load.x * x + load.y * y + load.spin * spin


# Without inertia


def effects_at(system: System, angle: float) -> Effects:
    """Friction, viscous friction and loads at a rod angle."""
    if is_loaded(system):
        put_load(system, load_at(system, angle))
    return problem_effects(system)


def depends_on_speed(system: System) -> bool:
    """Whether the direction of the motion depends on its magnitude, with viscous friction or loads."""
    return system.run[RUN_SQUARE] != 0.0 or is_loaded(system)


def _quasi_static_motion(system: System, mode: Mode, time: float, state: Numbers) -> Instant:
    fence_x, fence_y = pusher_velocity(system, mode.during, time, state)
    stays: bool = mode.contact == SEPARATE or mode.contact == REST
    if stays or (mode.contact == STICK and fence_x == 0.0 and fence_y == 0.0):
        return _instant_at_rest(fence_x, fence_y, 0.0, 0.0, 0.0, 0.0)
    system.run[RUN_EVALUATIONS] += 1.0
    pose, effects = pose_of(system, state), effects_at(system, state[ANGLE])
    slip, lift = 0.0, 0.0
    if mode.contact == STICK:
        u_x, u_y = to_body(pose.rod, fence_x, fence_y)
        guess = guess_spin(effects, pose.contact, u_x, u_y)
        root = psi(effects, pose.contact, u_x, u_y, guess, NO_POINT, 0.0)
        v_x, v_y = to_contact(pose.rod, root.v_x, root.v_y)
        f_x, f_y = to_contact(pose.rod, root.f_x, root.f_y)
        spin, pivot = root.spin, root.point
    else:
        motion, size, lift = _slip_in_mode(system, effects, pose, mode, fence_x, fence_y)
        u_x, u_y = to_contact(pose.rod, motion.u_x, motion.u_y)
        v_x, v_y = to_contact(pose.rod, size * motion.v_x, size * motion.v_y)
        f_x, f_y = to_contact(pose.rod, motion.f_x, motion.f_y)
        spin, slip, pivot = size * motion.spin, size * u_x - fence_x, motion.point
    power = f_x * (fence_x + slip) + f_y * fence_y
    power += load_power(system, pose, state, v_x, v_y, spin)
    return Instant(
        slip, 0.0, fence_x, fence_y, v_x, v_y, spin, sqrt(v_x * v_x + v_y * v_y), f_x, f_y,
        power, 0.0, 0.0, 0.0, lift, pivot, 1.0,
    )  # fmt: skip


def path_along_fence(
    system: System, effects: Effects, pose: Pose, contact: int, normal: float, side: float
) -> Path:
    """Path of contact motions along the fence, with the force on an edge of the friction cone."""
    edge = direction_at(pose.rod, edge_angle(system, contact))
    n_x, n_y = to_body(pose.rod, 0.0, normal)
    t_x, t_y = to_body(pose.rod, side, 0.0)
    return Path(effects, pose.contact, edge.along, -edge.across, n_x, n_y, t_x, t_y)


def _slip_in_mode(
    system: System, effects: Effects, pose: Pose, mode: Mode, fence_x: float, fence_y: float
) -> tuple[ContactMotion, float, float]:
    """A slip, the factor of its motion, and a number that is positive while the slip lasts.

    If the direction of the motion depends on its magnitude, it is the slip nearest to the one at the start
    of the mode or of its last step.
    """
    if not depends_on_speed(system):
        edge = direction_at(pose.rod, edge_angle(system, mode.contact))
        motion = motion_under_force(effects, pose.contact, edge.along, -edge.across, 1.0)
        _, u_y = to_contact(pose.rod, motion.u_x, motion.u_y)
        return motion, fence_y / u_y if u_y != 0.0 else 0.0, u_y
    motion, force, converged = _nearest_slip(system, effects, pose, mode, fence_y, mode.x)
    if converged and force > 0.0:
        return motion, 1.0, force
    # A slow slip is proportional to the pusher's motion.
    part = fence_y / mode.y if mode.y != 0.0 else 0.0
    other, push, ends = _nearest_slip(system, effects, pose, mode, fence_y, part * mode.x)
    if ends and (push > 0.0 or not converged):
        motion, force, converged = other, push, ends
    if converged or not fence_y < 0.0:
        return motion, 1.0 if converged else UNKNOWN, force
    # The pusher retreats, and the slip has ended. Until its end is located, it continues backwards.
    motion, force, converged = _nearest_slip(
        system, effects, pose, mode, -fence_y, fabs(part) * mode.x
    )
    return motion, -1.0 if converged else UNKNOWN, -force


def _nearest_slip(
    system: System, effects: Effects, pose: Pose, mode: Mode, normal: float, along: float
) -> tuple[ContactMotion, float, bool]:
    """The slip nearest to a motion along the fence, its force, and whether it was found."""
    path = path_along_fence(system, effects, pose, mode.contact, normal, 1.0)
    here = first_sample(path, along)
    sense = copysign(1.0, here.slope)
    root = find_root(
        path, sample_at_infinity(-INFINITY, -sense), sample_at_infinity(INFINITY, sense), here
    )
    motion = motion_at_root(path, root.s, root.spin, False, root.point)
    return motion, path.e_x * motion.f_x + path.e_y * motion.f_y, root.converged


# With inertia


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
    a_x: float, a_y: float, turn: float, slip: float, rise: float, spin: float,
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
    slip, rise, spin : float
        Velocity of the contact relative to the pusher, and angular velocity.
    b_x, b_y : float
        Acceleration of the pusher.
    """
    mass, moment = system.scene[IN_MASS], system.run[RUN_MOMENT]
    total, square = moment + mass * (q_x * q_x + q_y * q_y), spin * spin
    # Vector from the hinge to the contact.
    d_x, d_y = -(pose.arm_x + q_x), -(pose.arm_y + q_y)
    torque = moment * turn - mass * (q_x * a_y - q_y * a_x)
    free_turn = torque / total
    along, lift = _rates_about_hinge(system, slip, rise, spin, free_turn, d_x, d_y, b_x, b_y)
    f_x, f_y, rate_x, rate_y, turn = 0.0, 0.0, along, lift, free_turn
    if contact != SEPARATE:
        e_x, e_y = edge_of_slip(system, contact)
        turn = free_turn - lift / d_x if d_x != 0.0 else free_turn
        lever = d_x * e_y - d_y * e_x
        size = (total * turn - torque) / lever if lever != 0.0 else 0.0
        f_x, f_y, rate_y = size * e_x, size * e_y, 0.0
        rate_x, _ = _rates_about_hinge(system, slip, rise, spin, turn, d_x, d_y, b_x, b_y)
    # The center of mass rotates about the hinge.
    c_x, c_y = turn * q_y + square * q_x, -turn * q_x + square * q_y
    p_x, p_y = mass * (c_x - a_x) - f_x, mass * (c_y - a_y) - f_y
    return Hinge(f_x, f_y, rate_x, rate_y, turn, lift, p_x, p_y)


def _rates_about_hinge(
    system: System, slip: float, rise: float, spin: float, turn: float,
    d_x: float, d_y: float, b_x: float, b_y: float,
) -> tuple[float, float]:  # fmt: skip
    """Rates of the velocity, relative to the pusher, of a contact at (d_x, d_y) from the hinge."""
    square = spin * spin
    a_x, a_y = -turn * d_y - square * d_x, turn * d_x - square * d_y
    return rates_of_contact(system, spin, slip, rise, a_x - b_x, a_y - b_y)


def _passing_friction(
    system: System, pose: Pose, q_x: float, q_y: float, a_x: float, a_y: float, turn: float,
    b_x: float, b_y: float, w_x: float, w_y: float, share: float,
) -> tuple[float, float]:  # fmt: skip
    """Friction at a support point when the center of rotation passes it while the contact sticks.

    The contact determines the point's velocity along the line between them. This velocity changes sign, and
    the friction along the line jumps. The friction across the line keeps the center of rotation on the line
    as long as it is less than the share.

    Parameters
    ----------
    system : System
    pose : Pose
    q_x, q_y : float
        Vector from the center of mass to the point.
    a_x, a_y, turn : float
        Acceleration of the center of mass and angular acceleration without point and contact.
    b_x, b_y : float
        Acceleration of the slider's point at the contact.
    w_x, w_y : float
        Velocity of the point.
    share : float
        Maximum friction force at the point.
    """
    mass, moment = system.scene[IN_MASS], system.run[RUN_MOMENT]
    d_x, d_y = pose.arm_x + q_x, pose.arm_y + q_y
    reach, size = sqrt(d_x * d_x + d_y * d_y), sqrt(w_x * w_x + w_y * w_y)
    if reach > 0.0:
        total = moment + mass * (pose.arm_x * pose.arm_x + pose.arm_y * pose.arm_y)
        held_turn = -(b_y * d_x - b_x * d_y) / (reach * reach)
        torque = moment * turn + mass * (pose.arm_x * a_y - pose.arm_y * a_x)
        torque -= mass * (pose.arm_x * b_y - pose.arm_y * b_x)
        across = (total * held_turn - torque) / reach
        if fabs(across) < share:
            along = -copysign(sqrt(share * share - across * across), w_x * d_x + w_y * d_y)
            return (along * d_x - across * d_y) / reach, (along * d_y + across * d_x) / reach
    part = -share / size if size > 0.0 else 0.0
    return part * w_x, part * w_y


def slowest_foot_at(system: System, pose: Pose, v_x: float, v_y: float, spin: float) -> Foot:
    """The slowest support point, and its speed relative to the slider's."""
    x, y = to_body(pose.rod, v_x, v_y)
    foot = slowest_foot(system, x, y, spin)
    scale = max(size_of_twist(v_x, v_y, spin), NO_DIRECTION * system.run[RUN_SPEED])
    return Foot(foot.number, foot.speed / scale)


def _motion_with_inertia(system: System, mode: Mode, time: float, state: Numbers) -> Instant:
    fence_x, fence_y = pusher_velocity(system, mode.during, time, state)
    b_x, b_y = pusher_acceleration(system, mode.during, time, state)
    if mode.contact == REST:
        return _instant_at_rest(fence_x, fence_y, b_x, b_y, mode.x, mode.y)
    mass, moment = system.scene[IN_MASS], system.run[RUN_MOMENT]
    pose, spin = pose_of(system, state), state[SPIN]
    system.run[RUN_EVALUATIONS] += 1.0
    slip, rise, foot_x, foot_y = state[OVER], state[RISE], 0.0, 0.0
    v_x, v_y = center_motion(pose, fence_x + slip, fence_y + rise, spin)
    number = mode.foot
    sticks: bool = mode.contact == STICK
    if sticks:
        foot = slowest_foot_at(system, pose, v_x, v_y, spin)
        number = foot.number if foot.speed < HAS_LEFT else NO_POINT
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
            slip, rise = u_x - fence_x, u_y - fence_y if mode.contact == SEPARATE else 0.0
    x, y, opposed_spin = _opposed_twist(system, mode, pose, t_x, t_y, spin)
    total = drag(system, x, y, opposed_spin)
    x, y = to_body(pose.rod, v_x, v_y)
    dissipated = total.f_x * x + total.f_y * y + total.torque * spin
    load = load_at(system, state[ANGLE])
    d_x, d_y = load.x - total.f_x, load.y - total.f_y
    torque = (
        load.spin - total.torque - (system.scene[IN_MASS_X] * d_y - system.scene[IN_MASS_Y] * d_x)
    )
    d_x, d_y = to_contact(pose.rod, d_x, d_y)
    a_x, a_y, turn, hold = d_x / mass, d_y / mass, torque / moment, 1.0
    f_x, f_y, lift, rate_x, rate_y, hinged_turn = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    q_x, q_y = foot_x + pose.x - pose.arm_x, foot_y + pose.y - pose.arm_y
    if turns and sticks:
        w_x, w_y = v_x - t_x, v_y - t_y
        s_x, s_y = sticking_acceleration(system, spin, b_x, b_y)
        p_x, p_y = _passing_friction(
            system, pose, q_x, q_y, a_x, a_y, turn, s_x, s_y, w_x, w_y, total.limit
        )
        a_x, a_y = a_x + p_x / mass, a_y + p_y / mass
        turn += (q_x * p_y - q_y * p_x) / moment
        dissipated -= p_x * w_x + p_y * w_y
    elif turns:
        hinge = _hinged_motion(
            system, pose, mode.contact, q_x, q_y, a_x, a_y, turn, slip, rise, spin, b_x, b_y
        )
        f_x, f_y, rate_x, rate_y, hinged_turn, lift = (
            hinge.f_x, hinge.f_y, hinge.a_x, hinge.a_y, hinge.turn, hinge.lift,
        )  # fmt: skip
        p_x, p_y = hinge.p_x, hinge.p_y
        carried = sqrt(p_x * p_x + p_y * p_y)
        hold = (total.limit - carried) / (total.limit + carried)
        if not mode.hinged:
            # At a point that begins to move, friction equals its full share, along the force that held it.
            part = total.limit / carried if carried > 0.0 else 0.0
            p_x, p_y = part * p_x, part * p_y
            a_x, a_y = a_x + p_x / mass, a_y + p_y / mass
            turn += (q_x * p_y - q_y * p_x) / moment
            dissipated -= p_x * (v_x - t_x) + p_y * (v_y - t_y)
    if mode.hinged:
        turn = hinged_turn
    else:
        free_x, free_y = _acceleration_of_contact(pose, a_x, a_y, turn, spin)
        free_x, lift = rates_of_contact(system, spin, slip, rise, free_x - b_x, free_y - b_y)
        answer = answer_of(system, pose, mode.contact, free_x, lift)
        f_x, f_y, rate_x, rate_y = answer.f_x, answer.f_y, answer.x, answer.y
        turn += moment_of(pose, f_x, f_y) / moment
    return Instant(
        slip, rise, fence_x, fence_y, v_x, v_y, spin, sqrt(v_x * v_x + v_y * v_y),
        f_x, f_y, dissipated, rate_x, rate_y, turn, lift,
        mode.foot if mode.hinged else NO_POINT, hold,
    )  # fmt: skip


def _opposed_twist(
    system: System, mode: Mode, pose: Pose, v_x: float, v_y: float, spin: float
) -> tuple[float, float, float]:
    """Twist, in the body frame, that friction opposes; from rest, it is the impending twist."""
    impending: bool = mode.x != 0.0 or mode.y != 0.0 or mode.spin != 0.0
    if impending and size_of_twist(v_x, v_y, spin) <= NO_DIRECTION * system.run[RUN_SPEED]:
        x, y = to_body(pose.rod, mode.x, mode.y)
        return x, y, mode.spin
    x, y = to_body(pose.rod, v_x, v_y)
    return x, y, spin


def _acceleration_of_contact(
    pose: Pose, a_x: float, a_y: float, turn: float, spin: float
) -> tuple[float, float]:
    """Acceleration of the contact from that of the center of mass."""
    square = spin * spin
    x = a_x + turn * pose.arm_y + square * pose.arm_x
    return x, a_y - turn * pose.arm_x + square * pose.arm_y


# Rates and guards


def write_rates(system: System, mode: Mode, time: float, state: Numbers, rates: Numbers) -> None:
    """Store the derivative of the state."""
    _write_rates(system, mode, state, motion_in_mode(system, mode, time, state), rates)


def write_guards(system: System, mode: Mode, time: float, state: Numbers, guards: Numbers) -> None:
    """Store margins and watches by cause, NaN for causes without one."""
    _write_guards(system, mode, state, motion_in_mode(system, mode, time, state), guards)


def write_rates_and_guards(
    system: System, mode: Mode, time: float, state: Numbers, rates: Numbers, guards: Numbers
) -> None:
    """Store the derivative and the guards, with one evaluation of the motion."""
    now = motion_in_mode(system, mode, time, state)
    _write_rates(system, mode, state, now, rates)
    _write_guards(system, mode, state, now, guards)


def _write_rates(system: System, mode: Mode, state: Numbers, now: Instant, rates: Numbers) -> None:
    rates[ALONG] = travel_rate(system, now.slip, now.spin)
    rates[GAP], rates[ANGLE] = now.rise, now.spin
    # The contact does not slip while the slider rests or is in flight.
    rates[SLIPPED] = now.slip if contact_mode_of(mode) != SEPARATE else 0.0
    rates[LOST] = -now.f_x * now.slip - now.f_y * now.rise
    rates[WORK] = now.f_x * now.fence_x + now.f_y * now.fence_y
    if is_massive(system):
        rates[OVER], rates[RISE], rates[SPIN] = now.a_x, now.a_y, now.turn
    angle = frame_angle(system, state[ANGLE])
    x, y = to_body(Rod(1.0, angle, cos(angle), sin(angle)), now.v_x, now.v_y)
    write_powers(system, x, y, now.spin, now.dissipated, energies_of(system, rates))


def _write_guards(
    system: System, mode: Mode, state: Numbers, now: Instant, guards: Numbers
) -> None:
    for cause in range(CAUSES):
        guards[cause] = UNKNOWN
    if now.spin != now.spin:
        guards[LEAVES_CONE] = -1.0  # a motion that is not found does not last
        return
    rests: bool = mode.contact == REST
    # A pusher that retreats from a slider at rest opens the contact without an event.
    touches: bool = mode.touches and clearance_of(system, state) <= SLACK
    if rests and touches:
        guards[PUSH_STARTS] = PUSHES - now.fence_y / system.run[RUN_SPEED]
    elif rests or mode.contact == SEPARATE:
        height = clearance_of(system, state)
        guards[TOUCHES] = height if height < INFINITY else UNKNOWN
    if not rests:
        guards[CENTER_DOWN] = center_height(system, state)
    flies: bool = mode.contact == SEPARATE or (rests and not touches) or state[GAP] > SLACK
    if not flies:
        guards[END_OF_SIDE] = room_on_side(system, state[ALONG])
    guards[PENETRATES] = outline_height(system, state, not flies)
    if is_massive(system):
        _guard_moving_contact(system, mode, state, now, guards)
    else:
        _guard_quasi_static_contact(system, mode, now, guards)


def _guard_moving_contact(
    system: System, mode: Mode, state: Numbers, now: Instant, guards: Numbers
) -> None:
    """Store the margins and watches that end a contact of a slider with inertia."""
    speed, force, side = system.run[RUN_SPEED], system.run[RUN_FORCE], slip_side(mode.contact)
    if mode.contact == STICK:
        guards[LEAVES_CONE] = cone_margin(system, now.f_x, now.f_y, NO_FORCE * force)
    elif side != 0.0:
        e_x, e_y = edge_of_slip(system, mode.contact)
        push = now.f_x * e_x + now.f_y * e_y
        guards[SLIP_ENDS] = side * now.slip / speed
        guards[FORCE_ENDS] = push / (fabs(push) + force)
    if mode.contact == REST:
        return
    if mode.contact != SEPARATE:
        guards[SEPARATION_CHANGES] = now.lift * system.scene[IN_MASS] / force
    if system.scene[IN_WEIGHT] > 0.0:
        size = now.speed + fabs(now.spin)
        guards[SLIDER_STOPS] = size / speed - STOPPED
        if mode.hinged:
            guards[PIVOT_YIELDS] = now.hold
        elif mode.contact != STICK and size > STOPPED * speed:
            foot = slowest_foot_at(system, pose_of(system, state), now.v_x, now.v_y, now.spin)
            guards[CENTER_AT_POINT] = min(foot.speed, 1.0) - (
                HAS_LEFT if mode.foot >= 0 else ARRIVED
            )


def _guard_quasi_static_contact(system: System, mode: Mode, now: Instant, guards: Numbers) -> None:
    """Store the margins and watches that end a contact without inertia."""
    slips: bool = slip_side(mode.contact) != 0.0
    speed = sqrt(now.fence_x * now.fence_x + now.fence_y * now.fence_y)
    if mode.contact == STICK:
        rests: bool = now.f_x == 0.0 and now.f_y == 0.0
        margin = cone_margin(system, now.f_x, now.f_y, 0.0)
        # The force of a pivot can be any in an interval, so the trend of the margin decides.
        guards[LEAVES_CONE] = -1.0 if rests else 0.0 if now.pivot >= 0 else margin
    elif slips:
        _guard_slip(system, mode, now, speed, guards)
    if mode.contact == STICK or slips:
        guards[KINK] = _kink_of(system, now, slips)
    if is_steady_pusher(system, mode.during):
        return
    if mode.contact == REST and mode.touches:
        guards[NORMAL_REVERSES] = 1.0 if speed > 0.0 else -1.0
    elif mode.contact != REST:
        guards[NORMAL_REVERSES] = now.fence_y / speed if speed > 0.0 else 0.0
        guards[TANGENTIAL_REVERSES] = now.fence_x / speed if speed > 0.0 else 0.0


def _guard_slip(system: System, mode: Mode, now: Instant, speed: float, guards: Numbers) -> None:
    guards[SLIP_ENDS], guards[FORCE_ENDS] = -1.0, -1.0
    if speed > 0.0:
        guards[SLIP_ENDS] = slip_side(mode.contact) * now.slip / (speed + fabs(now.slip))
        # A slipping contact transmits no motion from a fence that only moves along its own line.
        if now.fence_y != 0.0 or not mode.during.constant:
            if depends_on_speed(system):
                # The force jumps where the contact comes to rest, so the margin vanishes with its motion.
                x, y = now.fence_x + now.slip, now.fence_y
                motion = sqrt(x * x + y * y)
                guards[FORCE_ENDS] = now.lift / (fabs(now.lift) + system.run[RUN_FORCE])
                guards[FORCE_ENDS] *= motion / (motion + speed)
            else:
                lift = now.lift / (1.0 + system.scene[IN_LENGTH])
                guards[FORCE_ENDS] = lift * now.fence_y / speed


def _kink_of(system: System, now: Instant, slips: bool) -> float:
    """Watch for kinks of a contact's motion.

    For a ring, the center of rotation crosses the ring; with support points, a pivot begins or ends in a
    slip.
    """
    if system.run[RUN_RING] == 0.0:
        if not slips or system.run[RUN_FEET] == 0.0:
            return UNKNOWN
        return 1.0 if now.pivot >= 0 else -1.0
    total = fabs(now.spin) + now.speed
    part = (fabs(now.spin) - now.speed) / total if total > 0.0 else 0.0
    # As smooth in time as the moment arm; near the ring, the spin ratio behaves like x / log(x) of the arm.
    return part * (2.0 - log(fabs(part))) if part != 0.0 else 0.0
