"""The motion of a slider with inertia in a mode, whose twist is part of the state (Secs. 4 and 5).

The state holds the velocity of the contact relative to the pusher and the angular velocity. A sticking
contact then has exactly zero relative velocity, and a slipping one exactly zero normal velocity. The
contact force follows from the mode, and the accelerations follow from the force. While the slider pivots
about a support point, its twist is that of the rotation about this point.
"""

from __future__ import annotations

from math import copysign, exp, fabs, log, sqrt
from typing import NamedTuple

from planar_pushing.core.drag import Foot, drag, friction_effects, load_at, load_work, slowest_foot
from planar_pushing.core.fence import fence_displacement
from planar_pushing.core.impact import answer_of, answer_of_side, edge_of_slip, moment_of
from planar_pushing.core.instant import Instant, Support, instant_at_rest, support_of_side
from planar_pushing.core.numbers import UNKNOWN, Numbers
from planar_pushing.core.roots import ITERATIONS
from planar_pushing.core.rows import NO_POINT, foot_position
from planar_pushing.core.run import (
    IN_MASS,
    IN_MASS_X,
    IN_MASS_Y,
    IN_TOLERANCE,
    RUN_EVALUATIONS,
    RUN_MOMENT,
    RUN_SPEED,
    RUN_TIME,
    RUN_UNTIL,
)
from planar_pushing.core.shapes import (
    Pose,
    center_motion,
    center_position,
    contact_motion,
    kinetic_energy_of,
    pose_of,
    pusher_acceleration,
    pusher_velocity,
    rates_of_contact,
    size_of_twist,
    sticking_acceleration,
    to_body,
    to_contact,
)
from planar_pushing.core.solution import SEPARATE, STICK
from planar_pushing.core.system import (
    ANGLE,
    LOST,
    MOVING,
    NORMAL_SPEED,
    REACHED,
    REST,
    SCALES,
    SLIP_SPEED,
    SPIN,
    STATE,
    WORK,
    Mode,
    System,
    is_loaded,
    is_massive,
    vector_of,
)
from planar_pushing.core.tolerances import (
    ARRIVED,
    AT_REST,
    ERRORS,
    FINEST,
    HAS_LEFT,
    NO_DIRECTION,
    PART_OF_STEP,
    ROUNDING,
    SLACK,
    STOPPED,
)
from planar_pushing.core.touch import is_flush, side_length

#: Rate at which friction drives the center to a support point, in units of that at which the point comes to
#: rest, from which on the direction of the point's velocity has settled.
STEADY = 3.0
#: Largest error of the balance of energy in one step, in units of the tolerance.
UNBALANCED = 1.0


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
    a_x: float, a_y: float, turn: float, slip: float, normal_speed: float, spin: float,
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
    slip, normal_speed, spin : float
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
    along, lift = _rates_about_hinge(
        system, slip, normal_speed, spin, free_turn, d_x, d_y, b_x, b_y
    )
    f_x, f_y, rate_x, rate_y, turn = 0.0, 0.0, along, lift, free_turn
    if contact != SEPARATE:
        e_x, e_y = edge_of_slip(system, contact)
        turn = free_turn - lift / d_x if d_x != 0.0 else free_turn
        lever = d_x * e_y - d_y * e_x
        size = (total * turn - torque) / lever if lever != 0.0 else 0.0
        f_x, f_y, rate_y = size * e_x, size * e_y, 0.0
        rate_x, _ = _rates_about_hinge(system, slip, normal_speed, spin, turn, d_x, d_y, b_x, b_y)
    # The center of mass rotates about the hinge.
    c_x, c_y = turn * q_y + square * q_x, -turn * q_x + square * q_y
    p_x, p_y = mass * (c_x - a_x) - f_x, mass * (c_y - a_y) - f_y
    return Hinge(f_x, f_y, rate_x, rate_y, turn, lift, p_x, p_y)


def _rates_about_hinge(
    system: System, slip: float, normal_speed: float, spin: float, turn: float,
    d_x: float, d_y: float, b_x: float, b_y: float,
) -> tuple[float, float]:  # fmt: skip
    """Rates of the velocity, relative to the pusher, of a contact at (d_x, d_y) from the hinge."""
    square = spin * spin
    a_x, a_y = -turn * d_y - square * d_x, turn * d_x - square * d_y
    return rates_of_contact(system, spin, slip, normal_speed, a_x - b_x, a_y - b_y)


def _passing_friction(
    system: System, pose: Pose, q_x: float, q_y: float, a_x: float, a_y: float, turn: float,
    b_x: float, b_y: float, w_x: float, w_y: float, spin: float, share: float, leaves: bool,
    is_at_center: bool, speed: float,
) -> tuple[float, float]:  # fmt: skip
    """Friction at a support point when the center of rotation passes it while the contact sticks.

    The contact determines the point's velocity along the line between them. This velocity passes through
    zero at a constant rate, and the velocity across the line keeps a constant ratio to it: before, if
    friction drives the center to the point, and after, always. The friction jumps when the point is at the
    center.

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
    spin : float
        Angular velocity.
    share : float
        Maximum friction force at the point.
    leaves, is_at_center : bool
        Whether the point has been at the center, and whether it is there.
    speed : float
        Velocity of the point along the line, away from the contact, at the start of the step. A step can go
        past the instant at which the point is at the center; the friction does not jump within it.
    """
    mass, moment = system.scene[IN_MASS], system.run[RUN_MOMENT]
    d_x, d_y = pose.arm_x + q_x, pose.arm_y + q_y
    reach, size = sqrt(d_x * d_x + d_y * d_y), sqrt(w_x * w_x + w_y * w_y)
    if reach > 0.0:
        d_x, d_y = d_x / reach, d_y / reach
        total = moment + mass * (pose.arm_x * pose.arm_x + pose.arm_y * pose.arm_y)
        torque = moment * turn + mass * (pose.arm_x * a_y - pose.arm_y * a_x)
        torque -= mass * (pose.arm_x * b_y - pose.arm_y * b_x)
        along = b_x * d_x + b_y * d_y - spin * spin * reach
        free = b_y * d_x - b_x * d_y + torque * reach / total
        most, sense = share * reach * reach / total, -1.0
        ahead, across = (w_x * d_x + w_y * d_y) * along, UNKNOWN
        if leaves and (ahead >= 0.0 or is_at_center):
            across = _rate_after(along, free, most)
        elif speed * along < 0.0:
            across, sense = _rate_before(fabs(along), free, most), 1.0
        rate = sqrt(along * along + across * across)
        if across == across and rate > 0.0:
            part = sense * share / rate
            return part * (along * d_x - across * d_y), part * (along * d_y + across * d_x)
    part = -share / size if size > 0.0 else 0.0
    return part * w_x, part * w_y


def _speed_of_foot(system: System, mode: Mode, x: float, y: float) -> float:
    """Velocity of a support point along the line from the contact, at the start of the step."""
    state = vector_of(system, STATE)
    pose, spin = pose_of(system, state), state[SPIN]
    fence_x, fence_y = pusher_velocity(system, mode.during, system.run[RUN_TIME], state)
    v_x, v_y = center_motion(pose, fence_x + state[SLIP_SPEED], fence_y + state[NORMAL_SPEED], spin)
    f_x, f_y = to_contact(pose.rod, x, y)
    d_x, d_y = pose.x + f_x, pose.y + f_y
    reach = sqrt(d_x * d_x + d_y * d_y)
    along = (v_x - spin * f_y) * d_x + (v_y + spin * f_x) * d_y
    return along / reach if reach > 0.0 else 0.0


def _rate_after(along: float, free: float, most: float) -> float:
    """Acceleration across a line of a point that begins to move, where friction opposes it.

    It solves ``x + most x / |(along, x)| = free``.
    """
    low, high = 0.0, fabs(free)
    x = high
    for _ in range(ITERATIONS):
        size = sqrt(along * along + x * x)
        if size == 0.0:
            return 0.0
        excess = x + most * x / size - fabs(free)
        if excess > 0.0:
            high = x
        else:
            low = x
        slope = 1.0 + most * along * along / (size * size * size)
        step = x - excess / slope
        if fabs(step - x) <= ROUNDING * x:
            break
        x = step if low < step < high else (low + high) / 2.0
    return copysign(x, free)


def _rate_before(along: float, free: float, most: float) -> float:
    """As `_rate_after`, of a point that comes to rest; NaN if friction does not drive it there.

    It solves ``x - most x / |(along, x)| = free`` where the left side decreases.
    """
    square = exp(2.0 / 3.0 * log(most * along * along)) - along * along if along > 0.0 else 0.0
    if square <= 0.0:
        return UNKNOWN
    low, high = 0.0, sqrt(square)
    if fabs(free) >= most * high / sqrt(along * along + square) - high:
        return UNKNOWN
    for _ in range(ITERATIONS):
        x = (low + high) / 2.0
        if most * x / sqrt(along * along + x * x) - x < fabs(free):
            low = x
        else:
            high = x
        if high - low <= ROUNDING * high:
            break
    size = sqrt(along * along + low * low)
    # Otherwise the ratio is still changing, and the friction is that of the velocity.
    drives: bool = most * along * along >= STEADY * size * size * size
    return -copysign(low, free) if drives else UNKNOWN


def _leaving_friction(
    system: System, pose: Pose, contact: int, q_x: float, q_y: float, p_x: float, p_y: float,
    share: float,
) -> tuple[float, float]:  # fmt: skip
    """Friction at a support point at the center of rotation that begins to move.

    It opposes the acceleration that it leaves: with the compliance B of the point in this mode,
    ``a = B (f - p)`` and ``f = -share a / |a|``.

    Parameters
    ----------
    system : System
    pose : Pose
    contact : int
        Contact mode, other than a stick.
    q_x, q_y : float
        Vector from the center of mass to the point.
    p_x, p_y : float
        Force that would hold the point.
    share : float
    """
    mass, moment = system.scene[IN_MASS], system.run[RUN_MOMENT]
    # Columns: acceleration of the point by forces on it along x and y.
    xx, xy = 1.0 / mass + q_y * q_y / moment, -q_x * q_y / moment
    yx, yy = xy, 1.0 / mass + q_x * q_x / moment
    if contact != SEPARATE:
        e_x, e_y = edge_of_slip(system, contact)
        lever = pose.arm_y * e_x - pose.arm_x * e_y
        normal = e_y / mass - pose.arm_x * lever / moment
        if normal != 0.0:
            c_x, c_y = e_x / mass - q_y * lever / moment, e_y / mass + q_x * lever / moment
            n_x = pose.arm_x * q_y / moment / normal
            n_y = (1.0 / mass - pose.arm_x * q_x / moment) / normal
            xx, xy, yx, yy = xx - c_x * n_x, xy - c_x * n_y, yx - c_y * n_x, yy - c_y * n_y
    a_x, a_y = -(xx * p_x + xy * p_y), -(yx * p_x + yy * p_y)
    # In a slip, the point can move against a force on it; its acceleration is then larger.
    low, high, carried = 0.0, sqrt(a_x * a_x + a_y * a_y), sqrt(p_x * p_x + p_y * p_y)
    f_x, f_y = p_x, p_y
    found: bool = False
    for _ in range(ITERATIONS):
        rate = (low + high) / 2.0 if found else high
        det = (rate + share * xx) * (rate + share * yy) - share * share * xy * yx
        if det == 0.0:
            break
        f_x = -share * ((rate + share * yy) * a_x - share * xy * a_y) / det
        f_y = -share * ((rate + share * xx) * a_y - share * yx * a_x) / det
        if f_x * f_x + f_y * f_y > share * share:
            low = rate
            if not found:
                high = 2.0 * high
        else:
            high = rate
            found = True
        if found and high - low <= ROUNDING * high:
            break
    size = sqrt(f_x * f_x + f_y * f_y)
    if not size > 0.0 or not carried > share:
        f_x, f_y, size = p_x, p_y, carried
    part = share / size if size > 0.0 else 0.0
    return part * f_x, part * f_y


def speed_of_passing(system: System, pose: Pose, v_x: float, v_y: float, spin: float) -> float:
    """The speed of the slowest support point, relative to the slider's, NaN without points.

    It has the sign of the point's velocity along the line from the contact.
    """
    foot = slowest_foot_at(system, pose, v_x, v_y, spin)
    if foot.number < 0:
        return UNKNOWN
    point = foot_position(friction_effects(system), foot.number)
    f_x, f_y = to_contact(pose.rod, point.x, point.y)
    ahead = (v_x - spin * f_y) * (pose.x + f_x) + (v_y + spin * f_x) * (pose.y + f_y)
    return copysign(min(foot.speed, 1.0), ahead)


def stop_slowest_foot(system: System, mode: Mode, time: float, state: Numbers) -> None:
    """Rotate a slider that sticks exactly about a support point that the center of rotation passes."""
    fence_x, fence_y = pusher_velocity(system, mode.during, time, state)
    pose, spin = pose_of(system, state), state[SPIN]
    u_x, u_y = fence_x + state[SLIP_SPEED], fence_y + state[NORMAL_SPEED]
    v_x, v_y = center_motion(pose, u_x, u_y, spin)
    foot = slowest_foot_at(system, pose, v_x, v_y, spin)
    size = size_of_twist(v_x, v_y, spin)
    if foot.number < 0 or foot.speed > speed_at_center(system, size):
        return
    point = foot_position(friction_effects(system), foot.number)
    f_x, f_y = to_contact(pose.rod, point.x, point.y)
    d_x, d_y = pose.x + f_x, pose.y + f_y
    square = d_x * d_x + d_y * d_y
    if square > 0.0:
        before = kinetic_energy_of(system, pose, v_x, v_y, spin)
        state[SPIN] = (u_x * d_y - u_y * d_x) / square
        v_x, v_y = center_motion(pose, u_x, u_y, state[SPIN])
        state[LOST] += before - kinetic_energy_of(system, pose, v_x, v_y, state[SPIN])


def slowest_motion(system: System) -> float:
    """Speed, relative to the typical one, below which a motion that stops is completed in closed form.

    It is well above the integrator's error, so that no step passes the slider's rest.
    """
    return max(STOPPED, PART_OF_STEP * system.scene[IN_TOLERANCE])


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


def arrival_speed(system: System, size: float) -> float:
    """Speed of a support point, relative to the slider's, at which the center of rotation has reached it.

    The integrator cannot resolve it better than to its own error.
    """
    part = system.run[RUN_SPEED] / size if size > 0.0 else 0.0
    error = ERRORS * max(PART_OF_STEP * system.scene[IN_TOLERANCE], FINEST)
    return min(max(ARRIVED, max(error * (1.0 + 0.01 * part), SLACK * part)), 100.0 * HAS_LEFT)


def speed_at_center(system: System, size: float) -> float:
    """Maximum speed of a support point at the center of rotation, relative to the slider's."""
    return max(AT_REST, 3.0 * arrival_speed(system, size))


def leaving_speed(system: System, size: float) -> float:
    """Speed of a support point, relative to the slider's, at which it has left the center of rotation."""
    return max(HAS_LEFT, 10.0 * arrival_speed(system, size))


def slowest_foot_at(system: System, pose: Pose, v_x: float, v_y: float, spin: float) -> Foot:
    """The slowest support point, and its speed relative to the slider's."""
    x, y = to_body(pose.rod, v_x, v_y)
    foot = slowest_foot(system, x, y, spin)
    scale = max(size_of_twist(v_x, v_y, spin), NO_DIRECTION * system.run[RUN_SPEED])
    return Foot(foot.number, foot.speed / scale)


def _energy_given(system: System, mode: Mode, time: float, state: Numbers) -> float:
    """Energy that pusher and loads have given to the slider, less what it has stored and dissipated."""
    pose = pose_of(system, state)
    fence_x, fence_y = pusher_velocity(system, mode.during, time, state)
    v_x, v_y = center_motion(
        pose, fence_x + state[SLIP_SPEED], fence_y + state[NORMAL_SPEED], state[SPIN]
    )
    total = state[WORK] - state[LOST] - kinetic_energy_of(system, pose, v_x, v_y, state[SPIN])
    for i in range(MOVING, system.entries):
        total -= state[i]
    if is_loaded(system):
        x, y = fence_displacement(system.fence, mode.during, time)
        x, y = center_position(system, pose, state, x, y)
        total += load_work(system, state[ANGLE], x, y)
    return total


def keeps_energy(system: System, mode: Mode) -> bool:
    """Whether the energies at the ends of the last step balance within the tolerance.

    The integrator's estimate can miss that the friction of a support point turns within a step, where the
    center of rotation passes the point closely, and is by chance small in a long step of a stiff motion.
    """
    run, state, reached = system.run, vector_of(system, STATE), vector_of(system, REACHED)
    if not is_massive(system) or mode.contact == REST or mode.hinged:
        return True
    lost = _energy_given(system, mode, run[RUN_UNTIL], reached)
    lost -= _energy_given(system, mode, run[RUN_TIME], state)
    scale = vector_of(system, SCALES)[WORK] + fabs(reached[WORK])
    return fabs(lost) <= UNBALANCED * max(system.scene[IN_TOLERANCE], FINEST) * scale


def motion_with_inertia(system: System, mode: Mode, time: float, state: Numbers) -> Instant:
    """The motion at an instant in a mode."""
    fence_x, fence_y = pusher_velocity(system, mode.during, time, state)
    b_x, b_y = pusher_acceleration(system, mode.during, time, state)
    if mode.contact == REST:
        return instant_at_rest(fence_x, fence_y, b_x, b_y, mode.x, mode.y, mode.offset)
    mass, moment = system.scene[IN_MASS], system.run[RUN_MOMENT]
    pose, spin = pose_of(system, state), state[SPIN]
    system.run[RUN_EVALUATIONS] += 1.0
    slip, normal_speed, foot_x, foot_y = state[SLIP_SPEED], state[NORMAL_SPEED], 0.0, 0.0
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
    x, y, opposed_spin = _opposed_twist(system, mode, pose, t_x, t_y, spin)
    total = drag(system, x, y, opposed_spin)
    x, y = to_body(pose.rod, v_x, v_y)
    dissipated = total.f_x * x + total.f_y * y + total.torque * spin
    load = load_at(system, state[ANGLE])
    d_x, d_y = load.x - total.f_x, load.y - total.f_y
    torque = load.spin - total.torque
    torque -= system.scene[IN_MASS_X] * d_y - system.scene[IN_MASS_Y] * d_x
    d_x, d_y = to_contact(pose.rod, d_x, d_y)
    a_x, a_y, turn, hold = d_x / mass, d_y / mass, torque / moment, 1.0
    f_x, f_y, lift, rate_x, rate_y, hinged_turn = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    support = Support(0.0, UNKNOWN)
    q_x, q_y = foot_x + pose.x - pose.arm_x, foot_y + pose.y - pose.arm_y
    if turns and sticks:
        w_x, w_y = v_x - t_x, v_y - t_y
        s_x, s_y = sticking_acceleration(system, spin, b_x, b_y)
        size, typical = size_of_twist(v_x, v_y, spin), system.run[RUN_SPEED]
        slowest = max(AT_REST * typical, speed_at_center(system, size) * size)
        is_at_center: bool = w_x * w_x + w_y * w_y <= slowest * slowest
        p_x, p_y = _passing_friction(
            system, pose, q_x, q_y, a_x, a_y, turn, s_x, s_y, w_x, w_y, spin, total.limit,
            mode.foot == number, is_at_center, _speed_of_foot(system, mode, point.x, point.y),
        )  # fmt: skip
        a_x, a_y = a_x + p_x / mass, a_y + p_y / mass
        turn += (q_x * p_y - q_y * p_x) / moment
        dissipated -= p_x * w_x + p_y * w_y
    elif turns:
        hinge = _hinged_motion(
            system, pose, mode.contact, q_x, q_y, a_x, a_y, turn, slip, normal_speed, spin, b_x, b_y
        )
        f_x, f_y, rate_x, rate_y, hinged_turn, lift = (
            hinge.f_x, hinge.f_y, hinge.a_x, hinge.a_y, hinge.turn, hinge.lift,
        )  # fmt: skip
        p_x, p_y = hinge.p_x, hinge.p_y
        carried = sqrt(p_x * p_x + p_y * p_y)
        hold = (total.limit - carried) / (total.limit + carried)
        if not mode.hinged:
            # At a point that begins to move, friction equals its full share.
            p_x, p_y = _leaving_friction(
                system, pose, mode.contact, q_x, q_y, p_x, p_y, total.limit
            )
            a_x, a_y = a_x + p_x / mass, a_y + p_y / mass
            turn += (q_x * p_y - q_y * p_x) / moment
            dissipated -= p_x * (v_x - t_x) + p_y * (v_y - t_y)
    if mode.hinged:
        turn = hinged_turn
    elif is_flush(system):
        length = side_length(system, state)
        lift = min(a_y - turn * pose.arm_x, a_y + turn * (length - pose.arm_x)) - b_y
        answer = answer_of_side(system, mode.contact, a_x - b_x, a_y - b_y)
        f_x, f_y, rate_x = answer.f_x, answer.f_y, answer.x
        torque = -(moment * turn + moment_of(pose, f_x, f_y))
        support, turn = support_of_side(length, f_y, torque), 0.0
    else:
        free_x, free_y = _acceleration_of_contact(pose, a_x, a_y, turn, spin)
        free_x, lift = rates_of_contact(
            system, spin, slip, normal_speed, free_x - b_x, free_y - b_y
        )
        answer = answer_of(system, pose, mode.contact, free_x, lift)
        f_x, f_y, rate_x, rate_y = answer.f_x, answer.f_y, answer.x, answer.y
        turn += moment_of(pose, f_x, f_y) / moment
    return Instant(
        slip, normal_speed, fence_x, fence_y, v_x, v_y, spin, sqrt(v_x * v_x + v_y * v_y),
        f_x, f_y, dissipated, rate_x, rate_y, turn, lift,
        mode.foot if mode.hinged else NO_POINT, hold, support.offset, support.press,
    )  # fmt: skip


def _opposed_twist(
    system: System, mode: Mode, pose: Pose, v_x: float, v_y: float, spin: float
) -> tuple[float, float, float]:
    """Twist, in the body frame, that friction opposes.

    From rest it is the impending twist. At a stop, where the twist vanishes, it is that at the start of the
    step.
    """
    x, y = to_body(pose.rod, v_x, v_y)
    starts: bool = mode.x != 0.0 or mode.y != 0.0 or mode.spin != 0.0
    # The velocity of a start is the difference of those of contact and pusher, and loses digits.
    slowest = AT_REST if starts else NO_DIRECTION
    if size_of_twist(v_x, v_y, spin) > slowest * system.run[RUN_SPEED]:
        return x, y, spin
    if starts:
        x, y = to_body(pose.rod, mode.x, mode.y)
        return x, y, mode.spin
    state = vector_of(system, STATE)
    start = pose_of(system, state)
    w_x, w_y = pusher_velocity(system, mode.during, system.run[RUN_TIME], state)
    u_x, u_y = center_motion(start, w_x + state[SLIP_SPEED], w_y + state[NORMAL_SPEED], state[SPIN])
    if size_of_twist(u_x, u_y, state[SPIN]) <= NO_DIRECTION * system.run[RUN_SPEED]:
        return x, y, spin
    x, y = to_body(start.rod, u_x, u_y)
    return x, y, state[SPIN]


def _acceleration_of_contact(
    pose: Pose, a_x: float, a_y: float, turn: float, spin: float
) -> tuple[float, float]:
    """Acceleration of the contact from that of the center of mass."""
    square = spin * spin
    x = a_x + turn * pose.arm_y + square * pose.arm_x
    return x, a_y - turn * pose.arm_x + square * pose.arm_y
