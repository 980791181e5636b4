"""Changes of the state between modes: impacts, starts of the pusher, and stops of the slider."""

from __future__ import annotations

from math import fabs, sqrt

from planar_pushing.core.instant.solution import SEPARATE, STICK
from planar_pushing.core.motion.kinematics.drag import friction_effects
from planar_pushing.core.motion.kinematics.fence import Span, fence_velocity, span_at
from planar_pushing.core.motion.kinematics.instant import load_power
from planar_pushing.core.motion.kinematics.mode import (
    NO_MODE,
    REST,
    Mode,
    contact_mode_of,
    is_preferred,
)
from planar_pushing.core.motion.kinematics.posing import pose_at_start
from planar_pushing.core.motion.kinematics.rolling import has_finger
from planar_pushing.core.motion.kinematics.shapes import (
    center_motion,
    contact_motion,
    from_world,
    kinetic_energy_of,
    pose_of,
    pusher_acceleration,
    pusher_velocity,
    to_contact,
)
from planar_pushing.core.motion.kinematics.system import (
    CENTER_AT_POINT,
    GOES_ON,
    LEAVES_CONE,
    MOVING,
    PENETRATES,
    PUSH_STARTS,
    RATES,
    SLIDER_STOPS,
    SLIP_ENDS,
    STILL,
    TOUCHES,
    RunState,
    System,
    candidate_at,
    is_massive,
    vector_of,
)
from planar_pushing.core.motion.kinematics.touch import (
    approach_of,
    count_points,
    is_flush,
    land_on_fence,
    settle_on_fence,
    take_lowest_point,
)
from planar_pushing.core.motion.kinematics.wall import clearance_of, is_closed, land_on_wall
from planar_pushing.core.motion.modes.candidates import write_starts
from planar_pushing.core.motion.modes.choice import hold_candidate
from planar_pushing.core.motion.modes.equations import motion_in_mode, write_rates
from planar_pushing.core.motion.modes.feet import slowest_foot_at, stop_slowest_foot
from planar_pushing.core.motion.modes.impact import add_impulse, collide
from planar_pushing.core.supports.rows import foot_position
from planar_pushing.core.supports.tolerances import NEAR_ZERO, RATTLES, SLACK


def _set_off(system: System, mode: Mode, time: float, state: RunState, policy: int) -> int:
    """Set a slider at rest in motion with a fence that starts to push it; return `GOES_ON` or a reason."""
    land_on_wall(system, mode.during, time, state)
    current, chosen, contact = contact_mode_of(mode), -1, NO_MODE
    for i in range(write_starts(system, mode.during, time, state)):
        start = candidate_at(system, i, mode.during.first)
        if start.contact != REST and is_preferred(policy, current, start.contact, contact):
            chosen, contact = i, start.contact
    if chosen < 0:
        return collide(system, mode.during, time, state, current, policy)
    start = candidate_at(system, chosen, mode.during.first)
    hold_candidate(system, state, chosen)
    _, b_y = pusher_acceleration(system, mode.during, time, state)
    fence_x, fence_y = pusher_velocity(system, mode.during, time, state)
    part = fence_y / b_y if b_y != 0.0 else 0.0
    v_x, v_y, spin = part * start.start.x, part * start.start.y, part * start.start.spin
    u_x, _ = contact_motion(pose_at_start(system, state), v_x, v_y, spin)
    state.slip_speed = 0.0 if start.contact == STICK else u_x - fence_x
    state.normal_speed, state.spin = 0.0, spin
    return GOES_ON


def _come_to_rest(system: System, mode: Mode, time: float, state: RunState) -> float:
    """Complete a motion that comes to rest; return the time at rest.

    Speeds decrease in proportion to the remaining time, and the energy with its square, so that everything
    changes at half its present rate on average.
    """
    during, rates = mode.during, vector_of(system, RATES)
    write_rates(system, mode, time, state, rates)
    pose = pose_of(system, state)
    fence_x, fence_y = pusher_velocity(system, during, time, state)
    v_x, v_y = center_motion(
        pose, fence_x + state.slip_speed, fence_y + state.normal_speed, state.spin
    )
    loss_rate = rates.lost - rates.work - load_power(system, pose, state, v_x, v_y, state.spin)
    for i in range(MOVING, system.entries):
        loss_rate += rates[i]
    if loss_rate <= 0.0:
        return time
    energy = kinetic_energy_of(system, pose, v_x, v_y, state.spin)
    half = min(2.0 * energy / loss_rate, during.end - time) / 2.0
    for entry in range(system.entries):
        if entry < STILL or entry >= MOVING:
            state[entry] += rates[entry] * half
    # The fence continues at its own speed.
    state.along -= fence_x * half
    state.gap -= fence_y * half
    slack = SLACK * system.run.speed
    if clearance_of(system, state) <= SLACK and fabs(state.normal_speed) <= slack:
        land_on_wall(system, during, time, state)
    last_x, last_y = pusher_velocity(system, during, time + 2.0 * half, state)
    state.slip_speed, state.normal_speed, state.spin = -last_x, -last_y, 0.0
    return time + 2.0 * half


def enter_span(system: System, index: int, state: RunState, current: int, policy: int) -> int:
    """Begin a span of the pusher's motion; return `GOES_ON`, or why there is no consistent state.

    With inertia a jump of the pusher's velocity is an impact on a slider in contact.
    """
    if not is_massive(system):
        return GOES_ON
    during, before_x, before_y = span_at(system.fence, index), 0.0, 0.0
    after_x, after_y = fence_velocity(system.fence, during, during.start)
    if index > 0:
        previous = span_at(system.fence, index - 1)
        before_x, before_y = fence_velocity(system.fence, previous, previous.end)
    jump_x, jump_y = from_world(system, state, before_x - after_x, before_y - after_y)
    state.slip_speed += jump_x
    state.normal_speed += jump_y
    slack = SLACK * system.run.speed
    touches: bool = clearance_of(system, state) <= SLACK
    if touches:
        take_lowest_point(system, state)
    hits: bool = (
        sqrt(jump_x * jump_x + jump_y * jump_y) > slack or approach_of(system, state) < -slack
    )
    if touches and hits:
        return collide(system, during, during.start, state, current, policy)
    return GOES_ON


def settle(
    system: System,
    during: Span,
    time: float,
    state: RunState,
    slack: float,
    current: int,
    policy: int,
) -> int:
    """Settle a side on the fence, as `settle_on_fence`, by an impulse that stops its normal motion.

    An end that still approaches collides before. Returns `GOES_ON` or why there is no impulse.
    """
    if not is_massive(system) or count_points(system) == 0:
        settle_on_fence(system, state, slack)
        return GOES_ON
    touches: bool = clearance_of(system, state) <= SLACK
    if touches:
        take_lowest_point(system, state)
    reason = GOES_ON
    if touches and approach_of(system, state) < -SLACK * system.run.speed:
        reason = collide(system, during, time, state, current, policy)
        # Of a slow impact, the slip is rounding error.
        slack = slack if reason == GOES_ON else RATTLES
    fence_x, fence_y = pusher_velocity(system, during, time, state)
    pose = pose_of(system, state)
    v_x, v_y = center_motion(
        pose, fence_x + state.slip_speed, fence_y + state.normal_speed, state.spin
    )
    energy = kinetic_energy_of(system, pose, v_x, v_y, state.spin)
    c_x = v_x - state.spin * (pose.arm_y - pose.y)
    c_y = v_y + state.spin * (pose.arm_x - pose.x)
    settle_on_fence(system, state, slack)
    if is_flush(system):
        if fabs(state.slip_speed) > SLACK * system.run.speed:
            state.slip_speed = c_x - fence_x  # without an impulse along the fence
        x, y = fence_x + state.slip_speed, fence_y
        mass, pose = system.scene.mass, pose_of(system, state)
        d_x, d_y = x - c_x, y - c_y
        if fabs(d_x) + fabs(d_y) > SLACK * system.run.speed:
            add_impulse(system, state, mass * d_x, mass * d_y)
        work = mass * (d_x * fence_x + d_y * fence_y)
        state.work += work
        state.lost += work - (kinetic_energy_of(system, pose, v_x=x, v_y=y, spin=0.0) - energy)
        return GOES_ON
    return reason


def close_contact(system: System, during: Span, time: float, state: RunState, policy: int) -> bool:
    """Close a contact that opens so slowly that its gap is zero; return whether there is one."""
    run = system.run
    if not is_massive(system) or count_points(system) > 0 or clearance_of(system, state) > SLACK:
        return False
    speed = fabs(state.normal_speed)
    if speed > RATTLES * run.speed or speed <= SLACK * run.speed:
        return False
    land_on_wall(system, during, time, state)
    state.normal_speed = -speed
    return collide(system, during, time, state, SEPARATE, policy) == GOES_ON


def close_on_foot(system: System, during: Span, time: float, state: RunState) -> bool:
    """Stop a support point and close the contact where both rattle; return whether they do.

    While a support point comes to rest, the contact can open and close, faster and faster, until the slider
    rotates about the point.
    """
    run = system.run
    if not is_massive(system) or count_points(system) > 0 or clearance_of(system, state) > SLACK:
        return False
    slowest, pose = RATTLES * run.speed, pose_of(system, state)
    fence_x, fence_y = pusher_velocity(system, during, time, state)
    v_x, v_y = center_motion(
        pose, fence_x + state.slip_speed, fence_y + state.normal_speed, state.spin
    )
    foot = slowest_foot_at(system, pose, v_x, v_y, state.spin)
    if fabs(state.normal_speed) > slowest or foot.number < 0 or foot.speed > RATTLES:
        return False
    point = foot_position(friction_effects(system), foot.number)
    f_x, f_y = to_contact(pose.rod, point.x, point.y)
    d_x, d_y = pose.x + f_x, pose.y + f_y
    spin = -fence_y / d_x if fabs(d_x) > SLACK else state.spin
    slip = spin * d_y - fence_x
    if fabs(slip) <= NEAR_ZERO * run.speed:
        slip = 0.0
    if fabs(spin - state.spin) > slowest or fabs(slip - state.slip_speed) > slowest:
        return False
    before = kinetic_energy_of(system, pose, v_x, v_y, state.spin)
    state.gap, state.slip_speed, state.normal_speed, state.spin = 0.0, slip, 0.0, spin
    state.lost += before - kinetic_energy_of(
        system, pose, v_x=spin * f_y, v_y=-spin * f_x, spin=spin
    )
    return True


def _land(system: System, during: Span, time: float, state: RunState) -> None:
    """Close the contact, where the slider meets the pusher."""
    if has_finger(system):
        land_on_wall(system, during, time, state)
    else:
        land_on_fence(system, state)


def change_state(
    system: System, cause: int, mode: Mode, time: float, state: RunState, policy: int
) -> tuple[float, int]:
    """Change the state just after an event; return the time, and `GOES_ON` or why the run ends."""
    if not is_massive(system):
        if cause == TOUCHES or (cause == PENETRATES and not has_finger(system)):
            _land(system, mode.during, time, state)
        elif is_closed(system, state):
            land_on_wall(system, mode.during, time, state)
        return time, GOES_ON
    contact = contact_mode_of(mode)
    if mode.hinged:
        instant = motion_in_mode(system, mode, time, state)
        state.slip_speed, state.normal_speed = instant.slip, instant.normal_speed
    passes: bool = cause == CENTER_AT_POINT
    passes = passes or cause == LEAVES_CONE
    if passes and contact == STICK and not is_flush(system):
        stop_slowest_foot(system, mode, time, state)
    if cause == TOUCHES:
        _land(system, mode.during, time, state)
    meets: bool = cause == PENETRATES and not has_finger(system)
    if meets:
        land_on_fence(system, state)
    if cause == TOUCHES or meets:
        return time, collide(system, mode.during, time, state, contact, policy)
    if cause == SLIP_ENDS:
        state.slip_speed = 0.0
    elif cause == SLIDER_STOPS:
        return _come_to_rest(system, mode, time, state), GOES_ON
    elif cause == PUSH_STARTS:
        return time, _set_off(system, mode, time, state, policy)
    touches: bool = mode.contact == SEPARATE and clearance_of(system, state) <= SLACK
    if touches:
        take_lowest_point(system, state)
    if touches and state.normal_speed < -SLACK * system.run.speed:
        land_on_wall(system, mode.during, time, state)
        return time, collide(system, mode.during, time, state, contact, policy)
    return time, GOES_ON
