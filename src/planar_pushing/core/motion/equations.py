"""The equations of motion in a mode: the motion at an instant, the rates of the state, and the guards.

Without inertia the pusher's velocity and the rod's angle determine the twist (Sec. 3). The state then holds
the gap, so that the contact stays exactly on the fence.
"""

from __future__ import annotations

from math import copysign, cos, fabs, log, sin, sqrt

from planar_pushing.core.instant.directions import Rod, direction_at
from planar_pushing.core.instant.force import ContactMotion, motion_at_root, motion_under_force
from planar_pushing.core.instant.path import Path, find_root, first_sample, sample_at_infinity
from planar_pushing.core.instant.solution import SEPARATE, STICK
from planar_pushing.core.motion.drag import (
    depends_on_speed,
    problem_effects,
    put_loads_at,
    write_powers,
)
from planar_pushing.core.motion.feet import (
    arrival_speed,
    leaving_speed,
    slowest_foot_at,
    speed_of_passing,
)
from planar_pushing.core.motion.inertia import (
    motion_beside_push,
    motion_with_inertia,
    push_in_mode,
    slowest_motion,
)
from planar_pushing.core.motion.instant import (
    Instant,
    Support,
    instant_at_rest,
    load_power,
    support_of_side,
)
from planar_pushing.core.motion.reaction import cone_margin, edge_angle, edge_of_slip
from planar_pushing.core.motion.shapes import (
    Pose,
    center_height,
    clearance_of,
    frame_angle,
    hold_pose,
    is_steady_pusher,
    outline_height,
    pose_of,
    pusher_velocity,
    room_on_side,
    to_body,
    to_contact,
    travel_rate,
)
from planar_pushing.core.motion.system import (
    CAUSES,
    CENTER_AT_POINT,
    CENTER_DOWN,
    END_OF_SIDE,
    FORCE_ENDS,
    KINK,
    LEAVES_CONE,
    NORMAL_REVERSES,
    PENETRATES,
    PIVOT_YIELDS,
    PUSH_STARTS,
    REST,
    SEPARATION_CHANGES,
    SLIDER_STOPS,
    SLIP_ENDS,
    TANGENTIAL_REVERSES,
    TOUCHES,
    Mode,
    RunState,
    System,
    contact_mode_of,
    energies_of,
    is_massive,
    slip_side,
)
from planar_pushing.core.motion.touch import is_flush, side_length
from planar_pushing.core.numbers import INFINITY, UNKNOWN, Numbers
from planar_pushing.core.supports.contact import resistance_about
from planar_pushing.core.supports.psi import guess_spin, psi
from planar_pushing.core.supports.rows import NO_POINT, Effects
from planar_pushing.core.supports.tolerances import NO_FORCE, PUSHES, SLACK


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
    slip, lift = 0.0, 0.0
    if mode.contact == STICK:
        u_x, u_y = to_body(pose.rod, fence_x, fence_y)
        guess = guess_spin(effects, pose.contact, u_x, u_y)
        root = psi(effects, pose.contact, x=u_x, y=u_y, guess=guess, point=NO_POINT, tolerance=0.0)
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
    support = Support(0.0, UNKNOWN)
    moves: bool = v_x * v_x + v_y * v_y > 0.0
    if moves and is_flush(system):
        x, y = to_body(pose.rod, v_x, v_y)
        torque = resistance_about(effects, pose.contact, x, y, spin=0.0, blur=0.0).torque
        support = support_of_side(side_length(system, state), f_y, torque)
        if mode.contact != STICK and not lift > 0.0:
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
        lift=lift,
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
    _write_rates(system, mode, state, motion_in_mode(system, mode, time, state), rates)


def write_guards(system: System, mode: Mode, time: float, state: RunState, guards: Numbers) -> None:
    """Store margins and watches by cause, NaN for causes without one."""
    _write_guards(system, mode, state, motion_in_mode(system, mode, time, state), guards)


def write_rates_and_guards(
    system: System, mode: Mode, time: float, state: RunState, rates: RunState, guards: Numbers
) -> None:
    """Store the derivative and the guards, with one evaluation of the motion."""
    instant = motion_in_mode(system, mode, time, state)
    _write_rates(system, mode, state, instant, rates)
    _write_guards(system, mode, state, instant, guards)


def _write_rates(
    system: System, mode: Mode, state: RunState, instant: Instant, rates: RunState
) -> None:
    rates.along = travel_rate(system, instant.slip, instant.spin)
    rates.gap, rates.angle = instant.normal_speed, instant.spin
    # The contact does not slip while the slider rests or is in flight.
    rates.slipped = instant.slip if contact_mode_of(mode) != SEPARATE else 0.0
    rates.lost = -instant.f_x * instant.slip - instant.f_y * instant.normal_speed
    rates.work = instant.f_x * instant.fence_x + instant.f_y * instant.fence_y
    if is_massive(system):
        rates.slip_speed, rates.normal_speed, rates.spin = instant.a_x, instant.a_y, instant.turn
    angle = frame_angle(system, state.angle)
    x, y = to_body(Rod(1.0, angle, cos(angle), sin(angle)), instant.v_x, instant.v_y)
    write_powers(system, x, y, instant.spin, instant.dissipated, energies_of(system, rates))


def _write_guards(
    system: System, mode: Mode, state: RunState, instant: Instant, guards: Numbers
) -> None:
    for cause in range(CAUSES):
        guards[cause] = UNKNOWN
    if instant.spin != instant.spin:
        guards[LEAVES_CONE] = -1.0  # a motion that is not found does not last
        return
    rests: bool = mode.contact == REST
    # A pusher that retreats from a slider at rest opens the contact without an event.
    rests_on_pusher: bool = mode.touches and clearance_of(system, state) <= SLACK
    is_open: bool = mode.contact == SEPARATE or (rests and not rests_on_pusher)
    if mode.touches:
        # It leaves the slider, and returns, within the mode.
        guards[TOUCHES] = state.gap if fabs(state.gap) > SLACK else 0.0
        guards[PUSH_STARTS] = 1.0
    if rests_on_pusher:
        guards[PUSH_STARTS] = PUSHES - instant.fence_y / system.run.speed
    elif is_open and not system.run.parted:
        guards[TOUCHES] = state.gap
    if not rests:
        guards[CENTER_DOWN] = center_height(system, state)
    is_open = is_open or state.gap > SLACK
    if not is_open:
        guards[END_OF_SIDE] = room_on_side(system, state.along)
    guards[PENETRATES] = outline_height(system, state, not is_open)
    if is_massive(system):
        _guard_moving_contact(system, mode, state, instant, guards)
    else:
        _guard_quasi_static_contact(system, mode, instant, guards)


def _guard_moving_contact(
    system: System, mode: Mode, state: RunState, instant: Instant, guards: Numbers
) -> None:
    """Store the margins and watches that end a contact of a slider with inertia."""
    speed, force = system.run.speed, system.run.force
    side = slip_side(contact_mode_of(mode))
    if side != 0.0:
        guards[SLIP_ENDS] = side * instant.slip / speed
    if mode.contact == REST:
        return
    if mode.contact == STICK:
        guards[LEAVES_CONE] = cone_margin(system, instant.f_x, instant.f_y, NO_FORCE * force)
    if is_flush(system):
        guards[FORCE_ENDS] = _margin_of_side(system, instant)
    elif side != 0.0:
        e_x, e_y = edge_of_slip(system, mode.contact)
        push = instant.f_x * e_x + instant.f_y * e_y
        guards[FORCE_ENDS] = push / (fabs(push) + force)
    if mode.contact != SEPARATE:
        guards[SEPARATION_CHANGES] = instant.lift * system.scene.mass / force
    if system.scene.weight > 0.0:
        size, slowest = instant.speed + fabs(instant.spin), slowest_motion(system)
        pushed = push_in_mode(mode.contact, instant.fence_x, instant.fence_y)
        guards[SLIDER_STOPS] = motion_beside_push(system, size, pushed) / speed - slowest
        if mode.hinged:
            guards[PIVOT_YIELDS] = instant.hold
        elif mode.contact == STICK and not is_flush(system):
            guards[CENTER_AT_POINT] = speed_of_passing(
                system, pose_of(system, state), instant.v_x, instant.v_y, instant.spin
            )
        elif mode.contact != STICK and size > slowest * speed:
            foot = slowest_foot_at(
                system, pose_of(system, state), instant.v_x, instant.v_y, instant.spin
            )
            limit = leaving_speed(system, size) if mode.foot >= 0 else arrival_speed(system, size)
            guards[CENTER_AT_POINT] = min(foot.speed, 1.0) - limit


def _guard_quasi_static_contact(
    system: System, mode: Mode, instant: Instant, guards: Numbers
) -> None:
    """Store the margins and watches that end a contact without inertia."""
    slips: bool = slip_side(mode.contact) != 0.0
    speed = sqrt(instant.fence_x * instant.fence_x + instant.fence_y * instant.fence_y)
    if mode.contact == STICK:
        rests: bool = instant.f_x == 0.0 and instant.f_y == 0.0
        margin = cone_margin(system, instant.f_x, instant.f_y, 0.0)
        # The force of a pivot can be any in an interval, so the trend of the margin decides.
        guards[LEAVES_CONE] = -1.0 if rests else 0.0 if instant.pivot >= 0 else margin
        guards[FORCE_ENDS] = _margin_of_side(system, instant)
    elif slips:
        _guard_slip(system, mode, instant, speed, guards)
    if mode.contact == STICK or slips:
        guards[KINK] = _kink_of(system, instant, slips)
    if is_steady_pusher(system, mode.during):
        return
    if mode.contact == REST and mode.touches:
        guards[NORMAL_REVERSES] = 1.0 if speed > 0.0 else -1.0
    elif mode.contact != REST:
        guards[NORMAL_REVERSES] = instant.fence_y / speed if speed > 0.0 else 0.0
        guards[TANGENTIAL_REVERSES] = instant.fence_x / speed if speed > 0.0 else 0.0


def _guard_slip(
    system: System, mode: Mode, instant: Instant, speed: float, guards: Numbers
) -> None:
    guards[SLIP_ENDS], guards[FORCE_ENDS] = -1.0, -1.0
    if speed > 0.0:
        guards[SLIP_ENDS] = slip_side(mode.contact) * instant.slip / (speed + fabs(instant.slip))
        # A slipping contact transmits no motion from a fence that only moves along its own line.
        if instant.fence_y != 0.0 or not mode.during.constant:
            if is_flush(system):
                guards[FORCE_ENDS] = _margin_of_side(system, instant)
            elif depends_on_speed(system):
                # The force jumps where the contact comes to rest, so the margin vanishes with its motion.
                x, y = instant.fence_x + instant.slip, instant.fence_y
                motion = sqrt(x * x + y * y)
                guards[FORCE_ENDS] = instant.lift / (fabs(instant.lift) + system.run.force)
                guards[FORCE_ENDS] *= motion / (motion + speed)
            else:
                lift = instant.lift / (1.0 + system.scene.length)
                guards[FORCE_ENDS] = lift * instant.fence_y / speed


def _margin_of_side(system: System, instant: Instant) -> float:
    """Margin of the forces at the ends of a side, NaN at a point and where the contact can pull."""
    if system.scene.rough or not is_flush(system):
        return UNKNOWN
    if instant.press != instant.press:
        return 0.0  # at rest
    return instant.press / (fabs(instant.f_x) + fabs(instant.f_y) + system.run.force)


def _kink_of(system: System, instant: Instant, slips: bool) -> float:
    """Watch for kinks of a contact's motion.

    For a ring, the center of rotation crosses the ring; with support points, a pivot begins or ends in a
    slip.
    """
    if not system.run.has_ring:
        if not slips or system.run.feet == 0:
            return UNKNOWN
        return 1.0 if instant.pivot >= 0 else -1.0
    total = fabs(instant.spin) + instant.speed
    part = (fabs(instant.spin) - instant.speed) / total if total > 0.0 else 0.0
    # As smooth in time as the moment arm; near the ring, the spin ratio behaves like x / log(x) of the arm.
    return part * (2.0 - log(fabs(part))) if part != 0.0 else 0.0
