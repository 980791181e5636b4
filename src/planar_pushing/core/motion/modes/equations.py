"""The equations of motion in a mode: the motion at an instant, the rates of the state, and the guards.

Without inertia the pusher's velocity and the rod's angle determine the twist (Sec. 3). The state then holds
the gap, so that the contact stays exactly on the fence.
"""

from __future__ import annotations

from math import copysign, cos, fabs, sin, sqrt

from planar_pushing.core.instant.directions import Rod, direction_at
from planar_pushing.core.instant.force import ContactMotion, motion_at_root, motion_under_force
from planar_pushing.core.instant.path import Path, find_root, first_sample, sample_at_infinity
from planar_pushing.core.instant.solution import SEPARATE, STICK
from planar_pushing.core.motion.kinematics.drag import (
    depends_on_speed,
    problem_effects,
    put_loads_at,
    write_powers,
)
from planar_pushing.core.motion.kinematics.instant import (
    Instant,
    Support,
    instant_at_rest,
    load_power,
    support_of_side,
)
from planar_pushing.core.motion.kinematics.mode import REST, Mode, contact_mode_of
from planar_pushing.core.motion.kinematics.rolling import frame_angle, travel_rate
from planar_pushing.core.motion.kinematics.shapes import (
    Pose,
    hold_pose,
    pose_of,
    pusher_velocity,
    to_body,
    to_contact,
)
from planar_pushing.core.motion.kinematics.system import (
    RunState,
    System,
    energies_of,
    is_massive,
)
from planar_pushing.core.motion.kinematics.touch import is_flush, side_length
from planar_pushing.core.motion.modes.inertia import (
    motion_with_inertia,
)
from planar_pushing.core.motion.modes.reaction import edge_angle
from planar_pushing.core.numbers import INFINITY, UNKNOWN
from planar_pushing.core.supports.contact import resistance_about
from planar_pushing.core.supports.psi import guess_spin, psi
from planar_pushing.core.supports.rows import NO_POINT, Effects


def motion_in_mode(system: System, mode: Mode, time: float, state: RunState) -> Instant:
    """The motion at an instant in a mode."""
    if is_massive(system):
        return motion_with_inertia(system, mode, time, state)
    return _quasi_static_motion(system, mode, time, state)


def _quasi_static_motion(system: System, mode: Mode, time: float, state: RunState) -> Instant:
    fence_x, fence_y = pusher_velocity(system, mode.during, time, state)
    stays: bool = mode.contact == SEPARATE or mode.contact == REST
    if stays or (mode.contact == STICK and fence_x == 0.0 and fence_y == 0.0):
        return instant_at_rest(x=fence_x, y=fence_y, a_x=0.0, a_y=0.0, f_x=0.0, f_y=0.0, offset=0.0)
    system.run.evaluations += 1
    put_loads_at(system, state.angle)
    pose, effects = pose_of(system, state), problem_effects(system)
    if is_flush(system):
        pose = hold_pose(pose)
    slip, margin = 0.0, 0.0
    if mode.contact == STICK:
        u_x, u_y = to_body(pose.rod, fence_x, fence_y)
        guess = guess_spin(effects, pose.contact, u_x, u_y)
        root = psi(effects, pose.contact, x=u_x, y=u_y, guess=guess, point=NO_POINT, tolerance=0.0)
        v_x, v_y = to_contact(pose.rod, root.v_x, root.v_y)
        f_x, f_y = to_contact(pose.rod, root.f_x, root.f_y)
        spin, pivot = root.spin, root.point
    else:
        motion, size, margin = _slip_in_mode(system, effects, pose, mode, fence_x, fence_y)
        u_x, u_y = to_contact(pose.rod, motion.u_x, motion.u_y)
        v_x, v_y = to_contact(pose.rod, size * motion.v_x, size * motion.v_y)
        f_x, f_y = to_contact(pose.rod, motion.f_x, motion.f_y)
        spin, slip, pivot = size * motion.spin, size * u_x - fence_x, motion.point
    power = f_x * (fence_x + slip) + f_y * fence_y
    power += load_power(system, pose, state, v_x, v_y, spin)
    support = Support(0.0, UNKNOWN)
    moves: bool = v_x * v_x + v_y * v_y > 0.0
    if moves and is_flush(system):
        x, y = to_body(pose.rod, v_x, v_y)
        torque = resistance_about(effects, pose.contact, x, y, spin=0.0, blur=0.0).torque
        support = support_of_side(side_length(system, state), f_y, torque)
        if mode.contact != STICK and not margin > 0.0:
            support = Support(support.offset, -fabs(support.press))
    return Instant(
        slip,
        normal_speed=0.0,
        fence_x=fence_x,
        fence_y=fence_y,
        v_x=v_x,
        v_y=v_y,
        spin=spin,
        speed=sqrt(v_x * v_x + v_y * v_y),
        f_x=f_x,
        f_y=f_y,
        dissipated=power,
        a_x=0.0,
        a_y=0.0,
        turn=0.0,
        lift=0.0,
        slip_margin=margin,
        pivot=pivot,
        hold=1.0,
        offset=support.offset,
        press=support.press,
    )


def path_along_fence(
    system: System, effects: Effects, pose: Pose, contact: int, normal: float, side: float
) -> Path:
    """Path of contact motions along the fence, with the force on an edge of the friction cone."""
    edge = direction_at(pose.rod, edge_angle(system, contact))
    n_x, n_y = to_body(pose.rod, 0.0, normal)
    t_x, t_y = to_body(pose.rod, side, 0.0)
    return Path(
        effects, pose.contact, e_x=edge.along, e_y=-edge.across, p_x=n_x, p_y=n_y, d_x=t_x, d_y=t_y
    )


def _slip_in_mode(
    system: System, effects: Effects, pose: Pose, mode: Mode, fence_x: float, fence_y: float
) -> tuple[ContactMotion, float, float]:
    """A slip, the factor of its motion, and a number that is positive while the slip lasts.

    If the direction of the motion depends on its magnitude, it is the slip nearest to the one at the start
    of the mode or of its last step.
    """
    if not depends_on_speed(system):
        edge = direction_at(pose.rod, edge_angle(system, mode.contact))
        motion = motion_under_force(
            effects, pose.contact, e_x=edge.along, e_y=-edge.across, along=1.0
        )
        _, u_y = to_contact(pose.rod, motion.u_x, motion.u_y)
        return motion, fence_y / u_y if u_y != 0.0 else 0.0, u_y
    motion, force, converged = _nearest_slip(
        system, effects, pose, mode, normal=fence_y, along=mode.u_x
    )
    if converged and force > 0.0:
        return motion, 1.0, force
    # A slow slip is proportional to the pusher's motion.
    part = fence_y / mode.u_y if mode.u_y != 0.0 else 0.0
    other, push, ends = _nearest_slip(
        system, effects, pose, mode, normal=fence_y, along=part * mode.u_x
    )
    if ends and (push > 0.0 or not converged):
        motion, force, converged = other, push, ends
    if converged or not fence_y < 0.0:
        return motion, 1.0 if converged else UNKNOWN, force
    # The pusher retreats, and the slip has ended. Until its end is located, it continues backwards.
    motion, force, converged = _nearest_slip(
        system, effects, pose, mode, normal=-fence_y, along=fabs(part) * mode.u_x
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


def write_rates(system: System, mode: Mode, time: float, state: RunState, rates: RunState) -> None:
    """Store the derivative of the state."""
    store_rates(system, mode, state, motion_in_mode(system, mode, time, state), rates)


def store_rates(
    system: System, mode: Mode, state: RunState, instant: Instant, rates: RunState
) -> None:
    """Store the derivative of the state, from the motion at an instant."""
    rates.along = travel_rate(system, state.gap, instant.slip, instant.spin)
    rates.gap, rates.angle = instant.normal_speed, instant.spin
    # The contact does not slip while the slider rests or is in flight.
    rates.slipped = instant.slip if contact_mode_of(mode) != SEPARATE else 0.0
    rates.lost = -instant.f_x * instant.slip - instant.f_y * instant.normal_speed
    rates.work = instant.f_x * instant.fence_x + instant.f_y * instant.fence_y
    if is_massive(system):
        rates.slip_speed, rates.normal_speed, rates.spin = instant.a_x, instant.a_y, instant.turn
    angle = frame_angle(system, state)
    x, y = to_body(Rod(1.0, angle, cos(angle), sin(angle)), instant.v_x, instant.v_y)
    write_powers(system, x, y, instant.spin, instant.dissipated, energies_of(system, rates))
