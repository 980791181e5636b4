"""The guards of a mode: margins, positive while it lasts, and watches, whose sign changes at events."""

from __future__ import annotations

from math import fabs, log, sqrt

from planar_pushing.core.instant.solution import SEPARATE, SLIP_LEFT, SLIP_RIGHT, STICK
from planar_pushing.core.motion.kinematics.corner import turn_to_side
from planar_pushing.core.motion.kinematics.drag import (
    depends_on_speed,
)
from planar_pushing.core.motion.kinematics.instant import (
    Instant,
)
from planar_pushing.core.motion.kinematics.mode import REST, Mode, contact_mode_of, slip_side
from planar_pushing.core.motion.kinematics.rolling import follows_chain, is_in_pocket
from planar_pushing.core.motion.kinematics.shapes import center_height, is_steady_pusher, pose_of
from planar_pushing.core.motion.kinematics.system import (
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
    SEPARATION_CHANGES,
    SLIDER_STOPS,
    SLIP_ENDS,
    TANGENTIAL_REVERSES,
    TOUCHES,
    RunState,
    System,
    is_massive,
)
from planar_pushing.core.motion.kinematics.touch import is_flush
from planar_pushing.core.motion.kinematics.wall import (
    clearance_of,
    gap_of_finger,
    is_closed,
    outline_height,
    room_on_piece,
)
from planar_pushing.core.motion.modes.equations import motion_in_mode, store_rates
from planar_pushing.core.motion.modes.feet import (
    arrival_speed,
    leaving_speed,
    slowest_foot_at,
    speed_of_passing,
)
from planar_pushing.core.motion.modes.inertia import (
    motion_beside_push,
    push_in_mode,
    slowest_motion,
)
from planar_pushing.core.motion.modes.reaction import cone_margin, edge_of_slip
from planar_pushing.core.numbers import UNKNOWN, Numbers
from planar_pushing.core.supports.tolerances import NO_FORCE, PUSHES, SLACK


def write_guards(system: System, mode: Mode, time: float, state: RunState, guards: Numbers) -> None:
    """Store margins and watches by cause, NaN for causes without one."""
    _write_guards(system, mode, state, motion_in_mode(system, mode, time, state), guards)


def write_rates_and_guards(
    system: System, mode: Mode, time: float, state: RunState, rates: RunState, guards: Numbers
) -> None:
    """Store the derivative and the guards, with one evaluation of the motion."""
    instant = motion_in_mode(system, mode, time, state)
    store_rates(system, mode, state, instant, rates)
    _write_guards(system, mode, state, instant, guards)


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
        gap = gap_of_finger(system, state)
        guards[TOUCHES] = gap if fabs(gap) > SLACK else 0.0
        guards[PUSH_STARTS] = 1.0
    if rests_on_pusher:
        guards[PUSH_STARTS] = PUSHES - _approach_of(system, instant) / system.run.speed
    elif is_open and not system.run.parted:
        guards[TOUCHES] = gap_of_finger(system, state)
    if not rests:
        guards[CENTER_DOWN] = center_height(system, state)
    is_open = is_open or not is_closed(system, state)
    if not is_open or (follows_chain(system) and system.run.wall.piece >= 0):
        guards[END_OF_SIDE] = room_on_piece(system, state) + (SLACK if is_open else 0.0)
    guards[PENETRATES] = outline_height(system, state, not is_open)
    if is_massive(system):
        _guard_moving_contact(system, mode, state, instant, guards)
    else:
        _guard_quasi_static_contact(system, mode, instant, guards)


def _approach_of(system: System, instant: Instant) -> float:
    """Speed of the pusher toward the slider; at an inner corner, toward the side that it approaches."""
    if not is_in_pocket(system):
        return instant.fence_y
    _, before = turn_to_side(system, SLIP_RIGHT, instant.fence_x, instant.fence_y)
    _, after = turn_to_side(system, SLIP_LEFT, instant.fence_x, instant.fence_y)
    return max(before, after)


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
        normal = _approach_of(system, instant)
        guards[NORMAL_REVERSES] = normal / speed if speed > 0.0 else 0.0
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
                guards[FORCE_ENDS] = instant.slip_margin / (
                    fabs(instant.slip_margin) + system.run.force
                )
                guards[FORCE_ENDS] *= motion / (motion + speed)
            else:
                margin = instant.slip_margin / (1.0 + system.scene.length)
                guards[FORCE_ENDS] = margin * instant.fence_y / speed


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
