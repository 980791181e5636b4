"""Inertia, with or without friction of the support: the twist is part of the state.

It is kept as the velocity of the contact over the fence and the rotation R omega, so that a contact that
sticks has no relative velocity at all, and one that slips no normal one. The contact force follows from
the mode, and the accelerations follow from the force.
"""

from __future__ import annotations

from math import sqrt

from planar_pushing.mechanics.compiled import compiled, inlined
from planar_pushing.mechanics.plane import contact_motion
from planar_pushing.simulation.fence import span, velocity
from planar_pushing.simulation.systems import base, contact, rest
from planar_pushing.simulation.systems.motion import Motion, at_rest, friction, size_of
from planar_pushing.simulation.systems.shapes.base import relative, seen

#: Part of the typical force below which a force has no direction of its own.
NO_FORCE = 1e-9
#: The slider rests below this part of the typical speed; what is left is finished in closed form.
STOPPED = 2e-9
#: Below this part of the typical speed a slider that starts has no direction but the impending one.
NO_DIRECTION = 1e-13


@inlined
def enter(system, index, state, kind, policy):
    """A jump of the fence's velocity is an impact on what it touches."""
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
def modes(system, during, time, state, kinds, starts):
    starts[:] = 0.0
    body, (v_x, v_y) = system.body, base.center_velocity(system, during, time, state)
    slow = size_of(v_x, v_y, state[base.SPIN]) <= base.AT_REST * body.speed
    rests = slow and body.weight > 0.0
    if (
        base.clearance(system, state) > base.SLACK
        or abs(state[base.RISE]) > base.SLACK * body.speed
    ):
        kinds[0] = base.CLEAR if rests else base.SEPARATE
        return 1
    if rests:
        return rest.starting(system.effects, system, during, time, state, kinds, starts)
    return _in_motion(system, during, time, state, kinds)


@inlined
def _in_motion(system, during, time, state, kinds):
    """Modes of a contact on the fence whose slider moves."""
    body, slip, count = system.body, state[base.OVER], 0
    flight = base.motion(system, base.Mode(base.SEPARATE, 0.0, 0.0, 0.0, during), time, state)
    for kind in range(contact.MODES):
        may = body.slips and contact.side_of(kind) * slip >= -base.SLACK * body.speed
        if kind == base.SEPARATE:
            may = flight.lift >= -base.SLACK * body.force / body.mass
        elif kind == base.STICK:
            may = abs(slip) <= base.SLACK * body.speed
        if may:
            kinds[count] = kind
            count += 1
    return count


@inlined
def after(system, cause, mode, time, state, policy):
    if cause == base.TOUCHES:
        state[base.GAP] = 0.0
        return time, contact.impact(system, mode.during, time, state, mode.kind, policy)
    if cause == base.SLIP_ENDS:
        state[base.OVER] = 0.0
    elif cause == base.STOPS:
        return rest.stopped(system, mode, time, state), 0
    elif cause == base.STARTS:
        return time, rest.set_off(system, mode, time, state, policy)
    return time, 0


@compiled
def motion(system, mode, time, state):
    fence_x, fence_y = base.velocity(system, mode.during, time, state)
    turn_x, turn_y = base.acceleration(system, mode.during, time, state)
    if mode.kind >= base.CLEAR:
        return at_rest(fence_x, fence_y, turn_x, turn_y)
    body, now, spin = system.body, base.pose(system, state), state[base.SPIN]
    body.evaluations += 1
    slip, rise = state[base.OVER], state[base.RISE]
    v_x, v_y = contact_motion(now.own, fence_x + slip, fence_y + rise, -spin)
    drag_x, drag_y, drag = _drag(system, now, mode, v_x, v_y, spin)
    rubbed = drag_x * v_x + drag_y * v_y + drag * spin
    drag -= now.x * drag_y - now.y * drag_x
    free_x, free_y = _free(body, now.arm, drag_x, drag_y, drag, spin)
    free_x, free_y = relative(system.shape, spin, slip, rise, free_x - turn_x, free_y - turn_y)
    f_x, f_y, a_x, a_y = contact.pushed_in(body, now.arm, mode.kind, free_x, free_y)
    turn = (contact.moment_of(now.arm, f_x, f_y) - drag) / body.moment
    return Motion(
        slip, rise, fence_x, fence_y,
        v_x, v_y, spin, sqrt(v_x * v_x + v_y * v_y),
        f_x, f_y, rubbed, a_x, a_y, turn, free_y,
    )  # fmt: skip


@compiled
def _drag(system, now, mode, v_x, v_y, spin):
    """Friction on the support against the motion, or against the impending one from rest."""
    impending = mode.x != 0.0 or mode.y != 0.0 or mode.spin != 0.0
    if impending and size_of(v_x, v_y, spin) <= NO_DIRECTION * system.body.speed:
        return friction(now.effects, now.own, mode.x, mode.y, mode.spin)
    return friction(now.effects, now.own, v_x, v_y, spin)


@compiled
def _free(body, own, drag_x, drag_y, drag, spin):
    """Acceleration of the contact without a force of the fence."""
    x, y = contact_motion(own, -drag_x / body.mass, -drag_y / body.mass, -drag / body.moment)
    pull = own.length * spin * spin
    return x + pull * own.x, y + pull * own.y


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
    if base.contact_mode(kind) != base.SEPARATE:
        found[base.LIFTS] = now.lift * body.mass / body.force
    if kind < base.CLEAR and body.weight > 0.0:
        found[base.STOPS] = (now.speed + abs(now.spin)) / body.speed - STOPPED
