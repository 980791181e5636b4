"""Equations with inertia, with or without support friction: the twist is part of the state.

The twist is stored as the velocity of the contact relative to the fence and the angular velocity. A
sticking contact then has exactly zero relative velocity, and a slipping one exactly zero normal velocity.
The contact force follows from the mode, and the accelerations follow from the force. While the slider
pivots about a support point, its twist is that of the rotation about this point.
"""

from __future__ import annotations

from math import nan, sqrt

from planar_pushing.simulation.fence import span, velocity
from planar_pushing.simulation.legacy.compiled import compiled, inlined
from planar_pushing.simulation.systems import base, contact, rest
from planar_pushing.simulation.systems.drag import drag, foot_at, load_at, slowest_foot
from planar_pushing.simulation.systems.frame import (
    Motion,
    at_rest,
    center_motion,
    contact_motion,
    size_of,
    to_body,
    to_contact,
)
from planar_pushing.simulation.systems.hinge import hinged_motion, passing_friction
from planar_pushing.simulation.systems.shapes.base import pinned, relative, seen

#: Fraction of the typical force below which the direction of a force is undefined.
NO_FORCE = 1e-9
#: Fraction of the typical speed below which a motion is completed to rest in closed form.
STOPPED = 2e-9
#: Fraction of the typical speed below which a starting slider has the impending direction of motion.
NO_DIRECTION = 1e-13
#: Speeds of a support point, relative to the slider's: below the first, the point has arrived at the center
#: of rotation; above the second, it has left it; below the third, it can be a pivot.
ARRIVED, LEFT, NEAR = 1e-10, 1e-5, 1e-9


@inlined
def enter(system, index, state, kind, policy):
    """Apply a jump of the fence's velocity, which is an impact on a slider in contact."""
    during = span(system.fence, index)
    now_x, now_y = velocity(system.fence, during, during.start)
    before_x, before_y = 0.0, 0.0
    if index > 0:
        past = span(system.fence, index - 1)
        before_x, before_y = velocity(system.fence, past, past.end)
    jump_x, jump_y = seen(system.shape, state[base.ANGLE], before_x - now_x, before_y - now_y)
    state[base.OVER] += jump_x
    state[base.RISE] += jump_y
    slack = base.SLACK * system.body.speed
    hits = sqrt(jump_x * jump_x + jump_y * jump_y) > slack or state[base.RISE] < -slack
    if base.clearance(system, state) <= base.SLACK and hits:
        return contact.impact(system, during, during.start, state, kind, policy)
    return 0


@inlined
def modes(system, during, time, state, kinds, feet, hinged, starts):
    starts[:], feet[:], hinged[:] = 0.0, -1, 0
    body, (v_x, v_y) = system.body, base.center_velocity(system, during, time, state)
    rests = base.is_slow(system, v_x, v_y, state[base.SPIN]) and body.weight > 0.0
    if (
        base.clearance(system, state) > base.SLACK
        or abs(state[base.RISE]) > base.SLACK * body.speed
    ):
        if rests:
            return rest.clear(system, state, kinds, feet, hinged, starts)
        return _in_motion(system, during, time, state, 1, kinds, feet, hinged)
    if rests:
        return rest.starting(
            system.friction, system, during, time, state, kinds, feet, hinged, starts
        )
    return _in_motion(system, during, time, state, contact.MODES, kinds, feet, hinged)


@inlined
def _in_motion(system, during, time, state, most, kinds, feet, hinged):
    """Candidates among the first `most` contact modes for a moving slider."""
    body, slip, count = system.body, state[base.OVER], 0
    near = _near_foot(system, during, time, state)
    for kind in range(most):
        mode, foot = base.Mode(kind, near, True, 0.0, 0.0, 0.0, during), near >= 0
        if foot:
            foot = kind != base.STICK and base.motion(system, mode, time, state).hold > base.SLACK
        mode = base.Mode(kind, near, foot, 0.0, 0.0, 0.0, during)
        may = body.slips and contact.side_of(kind) * slip >= -base.SLACK * body.speed
        if kind == base.SEPARATE:
            lift = base.motion(system, mode, time, state).lift
            may = most == 1 or lift >= -base.SLACK * body.force / body.mass
        elif kind == base.STICK:
            may = abs(slip) <= base.SLACK * body.speed
        if may:
            kinds[count], feet[count], hinged[count] = kind, near, foot
            count += 1
    return count


@compiled
def _near_foot(system, during, time, state):
    """Number of the support point at the center of rotation, -1 if there is none."""
    now, spin = base.pose(system, state), state[base.SPIN]
    v_x, v_y = base.center_velocity(system, during, time, state)
    foot, ratio = _slowest(system, now, v_x, v_y, spin)
    return foot if ratio <= NEAR else -1


@compiled
def _slowest(system, now, v_x, v_y, spin):
    """Number of the slowest support point, and its speed relative to the slider's."""
    x, y = to_body(now.frame, v_x, v_y)
    foot, speed = slowest_foot(system.friction, x, y, spin)
    return foot, speed / max(size_of(v_x, v_y, spin), NO_DIRECTION * system.body.speed)


@inlined
def after(system, cause, mode, time, state, policy):
    if mode.hinged:
        now = base.motion(system, mode, time, state)
        state[base.OVER], state[base.RISE] = now.slip, now.rise
    if cause == base.TOUCHES:
        state[base.GAP] = 0.0
        return time, contact.impact(system, mode.during, time, state, mode.kind, policy)
    if cause == base.SLIP_ENDS:
        state[base.OVER] = 0.0
    elif cause == base.SLIDER_STOPS:
        return rest.stopped(system, mode, time, state), 0
    elif cause == base.PUSH_STARTS:
        return time, rest.set_off(system, mode, time, state, policy)
    falls = state[base.RISE] < -base.SLACK * system.body.speed
    if mode.kind == base.SEPARATE and falls and base.clearance(system, state) <= base.SLACK:
        state[base.GAP] = 0.0
        return time, contact.impact(system, mode.during, time, state, mode.kind, policy)
    return time, 0


@compiled
def motion(system, mode, time, state):
    fence_x, fence_y = base.velocity(system, mode.during, time, state)
    turn_x, turn_y = base.acceleration(system, mode.during, time, state)
    if mode.kind == base.PROPPED:
        return at_rest(fence_x, fence_y, turn_x, turn_y, mode.x, mode.y)
    if mode.kind >= base.CLEAR:
        return at_rest(fence_x, fence_y, turn_x, turn_y, 0.0, 0.0)
    body, now, spin = system.body, base.pose(system, state), state[base.SPIN]
    body.evaluations += 1
    slip, rise, foot_x, foot_y = state[base.OVER], state[base.RISE], 0.0, 0.0
    v_x, v_y = center_motion(now, fence_x + slip, fence_y + rise, spin)
    foot, sticks = mode.foot, mode.kind == base.STICK
    if sticks:
        foot, ratio = _slowest(system, now, v_x, v_y, spin)
        foot = foot if ratio < LEFT else -1
    t_x, t_y, turns = v_x, v_y, foot >= 0
    if turns:
        # Rotation exactly about the support point.
        p_x, p_y = foot_at(system.friction, foot)
        foot_x, foot_y = to_contact(now.frame, p_x, p_y)
        t_x, t_y = spin * foot_y, -spin * foot_x
        if mode.hinged:
            v_x, v_y = t_x, t_y
            u_x, u_y = contact_motion(now, v_x, v_y, spin)
            slip, rise = u_x - fence_x, u_y - fence_y if mode.kind == base.SEPARATE else 0.0
    x, y, turned = _direction(system, mode, now, t_x, t_y, spin)
    found = drag(system.effects, x, y, turned)
    x, y = to_body(now.frame, v_x, v_y)
    rubbed = found.f_x * x + found.f_y * y + found.torque * spin
    pull = load_at(body, state[base.ANGLE])
    d_x, d_y = pull.x - found.f_x, pull.y - found.f_y
    torque = pull.torque - found.torque - (body.center[0] * d_y - body.center[1] * d_x)
    d_x, d_y = to_contact(now.frame, d_x, d_y)
    a_x, a_y, turn, hold = d_x / body.mass, d_y / body.mass, torque / body.moment, 1.0
    f_x, f_y, along, normal, turn_too, free_y = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    q_x, q_y = foot_x + now.x - now.arm_x, foot_y + now.y - now.arm_y
    if turns and sticks:
        w_x, w_y = v_x - t_x, v_y - t_y
        held = pinned(system.shape, spin, turn_x, turn_y)
        p_x, p_y = passing_friction(
            system, now, q_x, q_y, (a_x, a_y, turn), held, (w_x, w_y), found.most
        )
        a_x, a_y = a_x + p_x / body.mass, a_y + p_y / body.mass
        turn += (q_x * p_y - q_y * p_x) / body.moment
        rubbed -= p_x * w_x + p_y * w_y
    elif turns:
        f_x, f_y, along, normal, turn_too, free_y, p_x, p_y = hinged_motion(
            system, now, mode.kind, q_x, q_y, (a_x, a_y, turn), (slip, rise, spin), (turn_x, turn_y)
        )
        carried = sqrt(p_x * p_x + p_y * p_y)
        hold = (found.most - carried) / (found.most + carried)
        if not mode.hinged:
            # At a point that begins to move, friction equals its full share, along the force that held it.
            part = found.most / carried if carried > 0.0 else 0.0
            p_x, p_y = part * p_x, part * p_y
            a_x, a_y = a_x + p_x / body.mass, a_y + p_y / body.mass
            turn += (q_x * p_y - q_y * p_x) / body.moment
            rubbed -= p_x * (v_x - t_x) + p_y * (v_y - t_y)
    if mode.hinged:
        a_x, a_y, turn = along, normal, turn_too
    else:
        free_x, free_y = _at_contact(now, a_x, a_y, turn, spin)
        free_x, free_y = relative(system.shape, spin, slip, rise, free_x - turn_x, free_y - turn_y)
        f_x, f_y, a_x, a_y = contact.pushed_in(
            body, now.arm_x, now.arm_y, mode.kind, free_x, free_y
        )
        turn += contact.moment_of(now.arm_x, now.arm_y, f_x, f_y) / body.moment
    pivot = mode.foot if mode.hinged else -1
    return Motion(
        slip, rise, fence_x, fence_y, v_x, v_y, spin, sqrt(v_x * v_x + v_y * v_y),
        f_x, f_y, rubbed, a_x, a_y, turn, free_y, pivot, hold,
    )  # fmt: skip


@compiled
def remember(system, time, state, mode, start):
    pass


@compiled
def _direction(system, mode, now, v_x, v_y, spin):
    """Twist, in the body frame, that friction opposes; from rest, it is the impending twist."""
    impending = mode.x != 0.0 or mode.y != 0.0 or mode.spin != 0.0
    if impending and size_of(v_x, v_y, spin) <= NO_DIRECTION * system.body.speed:
        x, y = to_body(now.frame, mode.x, mode.y)
        return x, y, mode.spin
    x, y = to_body(now.frame, v_x, v_y)
    return x, y, spin


@compiled
def _at_contact(now, a_x, a_y, turn, spin):
    """Acceleration of the contact from that of the center of mass."""
    pull = spin * spin
    return a_x + turn * now.arm_y + pull * now.arm_x, a_y - turn * now.arm_x + pull * now.arm_y


@compiled
def guard_contact(system, mode, state, now, found):
    body, kind, side = system.body, mode.kind, contact.side_of(mode.kind)
    if kind == base.STICK:
        found[base.LEAVES_CONE] = contact.margin(body, now.f_x, now.f_y, NO_FORCE * body.force)
    elif side != 0.0:
        e_x, e_y, _ = contact.edge_of(body, kind)
        size = now.f_x * e_x + now.f_y * e_y
        found[base.SLIP_ENDS] = side * now.slip / body.speed
        found[base.FORCE_ENDS] = size / (abs(size) + body.force)
    if base.contact_mode(kind) != base.SEPARATE and kind != base.PROPPED:
        found[base.SEPARATION_CHANGES] = now.lift * body.mass / body.force
    if kind < base.CLEAR and body.weight > 0.0:
        size = now.speed + abs(now.spin)
        found[base.SLIDER_STOPS] = size / body.speed - STOPPED
        if mode.hinged:
            found[base.PIVOT_YIELDS] = now.hold
        elif kind != base.STICK:
            _, ratio = _slowest(system, base.pose(system, state), now.v_x, now.v_y, now.spin)
            left = LEFT if mode.foot >= 0 else ARRIVED
            found[base.CENTER_AT_POINT] = (
                min(ratio, 1.0) - left if size > STOPPED * body.speed else nan
            )
