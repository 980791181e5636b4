"""Support points near the center of rotation, with inertia: speeds, thresholds, and their friction."""

from __future__ import annotations

from math import copysign, exp, fabs, log, sqrt
from typing import NamedTuple

from planar_pushing.core.instant.solution import SEPARATE
from planar_pushing.core.motion.kinematics.drag import Foot, friction_effects, slowest_foot
from planar_pushing.core.motion.kinematics.mode import Mode
from planar_pushing.core.motion.kinematics.shapes import (
    Pose,
    center_motion,
    kinetic_energy_of,
    pose_of,
    pusher_velocity,
    size_of_twist,
    to_body,
    to_contact,
)
from planar_pushing.core.motion.kinematics.system import STATE, RunState, System, vector_of
from planar_pushing.core.motion.modes.reaction import edge_of_slip
from planar_pushing.core.numbers import UNKNOWN, zeros
from planar_pushing.core.supports.roots import ITERATIONS, MOST_ROOTS, positive_roots
from planar_pushing.core.supports.rows import foot_position
from planar_pushing.core.supports.tolerances import (
    ARRIVED,
    AT_REST,
    ERRORS,
    FINEST,
    HAS_LEFT,
    NO_DIRECTION,
    PART_OF_STEP,
    ROUNDING,
    SLACK,
)

#: Rate at which friction drives the center to a support point, in units of that at which the point comes to
#: rest, from which on the direction of the point's velocity has settled.
STEADY = 3.0
#: Maximum speed of a support point, relative to the slider's, that counts as at the center of rotation,
#: however loose the tolerance.
FASTEST_AT_CENTER = 3e-3


def passing_friction(
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
    mass, moment = system.scene.mass, system.run.moment
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


def speed_of_foot(system: System, mode: Mode, number: int) -> float:
    """Velocity of a support point along the line from the contact, at the start of the step."""
    state = vector_of(system, STATE)
    pose, spin = pose_of(system, state), state.spin
    fence_x, fence_y = pusher_velocity(system, mode.during, system.run.time, state)
    v_x, v_y = center_motion(pose, fence_x + state.slip_speed, fence_y + state.normal_speed, spin)
    point = foot_position(friction_effects(system), number)
    f_x, f_y = to_contact(pose.rod, point.x, point.y)
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
    """Acceleration across a line of a point that comes to rest; NaN if friction does not drive it there.

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


def leaving_friction(
    system: System, pose: Pose, contact: int, q_x: float, q_y: float, p_x: float, p_y: float,
    share: float, departure: int,
) -> tuple[float, float, bool]:  # fmt: skip
    """Friction at a support point at the center of rotation that begins to move, and whether it can.

    It opposes the acceleration a that it leaves: with the compliance B of the point in this mode,
    ``a = B (f - p)`` and ``f = -share a / |a|``. The magnitude L of a is then a root of
    ``|L a_0 - share det(B) p|^2 = det(L + share B)^2`` with ``a_0 = -B p``. There is exactly one if B is
    positive definite and friction cannot hold the point. In a slip, B can have a negative determinant.
    Several departures are then possible, also of a point that friction could hold.

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
    departure : int
        Which of the departures, from 1 in the order of decreasing acceleration. Without one, the friction
        is along the force that would hold the point.
    """
    polynomial = zeros(MOST_ROOTS + 1)
    rates = zeros(MOST_ROOTS)
    b = _compliance_of_foot(system, pose, contact, q_x, q_y)
    a_x, a_y = -(b.xx * p_x + b.xy * p_y), -(b.yx * p_x + b.yy * p_y)
    unit = sqrt(a_x * a_x + a_y * a_y) + share * (fabs(b.xx) + fabs(b.yy))
    part = share / unit
    x, y, trace = a_x / unit, a_y / unit, part * (b.xx + b.yy)
    det = part * part * (b.xx * b.yy - b.xy * b.yx)
    h_x, h_y = det * p_x / share, det * p_y / share
    polynomial[0] = det * det - (h_x * h_x + h_y * h_y)
    polynomial[1] = 2.0 * (trace * det + x * h_x + y * h_y)
    polynomial[2] = trace * trace + 2.0 * det - (x * x + y * y)
    polynomial[3], polynomial[4] = 2.0 * trace, 1.0
    number = positive_roots(polynomial, MOST_ROOTS, rates)
    leaves: bool = number >= departure
    f_x, f_y = p_x, p_y
    if leaves:
        rate = rates[number - departure]
        f_x = -((rate + part * b.yy) * x - part * b.xy * y)
        f_y = -((rate + part * b.xx) * y - part * b.yx * x)
        if (rate + part * b.xx) * (rate + part * b.yy) < part * part * b.xy * b.yx:
            f_x, f_y = -f_x, -f_y
    size = sqrt(f_x * f_x + f_y * f_y)
    part = share / size if size > 0.0 else 0.0
    return part * f_x, part * f_y, leaves


class Compliance(NamedTuple):
    """Accelerations of a point by forces on it: ``a_x = xx f_x + xy f_y``, ``a_y = yx f_x + yy f_y``."""

    xx: float
    xy: float
    yx: float
    yy: float


def _compliance_of_foot(
    system: System, pose: Pose, contact: int, q_x: float, q_y: float
) -> Compliance:
    """Compliance of a support point in a mode whose contact force keeps the contact closed."""
    mass, moment = system.scene.mass, system.run.moment
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
    return Compliance(xx, xy, yx, yy)


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


def stop_slowest_foot(system: System, mode: Mode, time: float, state: RunState) -> None:
    """Rotate a slider that sticks exactly about a support point that the center of rotation passes."""
    fence_x, fence_y = pusher_velocity(system, mode.during, time, state)
    pose, spin = pose_of(system, state), state.spin
    u_x, u_y = fence_x + state.slip_speed, fence_y + state.normal_speed
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
        state.spin = (u_x * d_y - u_y * d_x) / square
        v_x, v_y = center_motion(pose, u_x, u_y, state.spin)
        state.lost += before - kinetic_energy_of(system, pose, v_x, v_y, state.spin)


def arrival_speed(system: System, size: float) -> float:
    """Speed of a support point, relative to the slider's, at which the center of rotation has reached it.

    The integrator cannot resolve it better than to its own error.
    """
    part = system.run.speed / size if size > 0.0 else 0.0
    error = ERRORS * max(PART_OF_STEP * system.scene.tolerance, FINEST)
    return min(max(ARRIVED, max(error * (1.0 + 0.01 * part), SLACK * part)), FASTEST_AT_CENTER)


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
    scale = max(size_of_twist(v_x, v_y, spin), NO_DIRECTION * system.run.speed)
    return Foot(foot.number, foot.speed / scale)
