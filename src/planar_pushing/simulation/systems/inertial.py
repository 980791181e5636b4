"""Inertia, with or without friction of the support: the twist is part of the state.

It is kept as the velocity of the contact over the fence and the rotation R omega, so that a contact that
sticks has no relative velocity at all, and one that slips no normal one.
"""

from __future__ import annotations

from math import cos, sin, sqrt

from planar_pushing.mechanics.compiled import compiled, inlined
from planar_pushing.mechanics.push import spin_ratio
from planar_pushing.simulation.fence import span, velocity
from planar_pushing.simulation.systems.base import (
    ALONG,
    ANGLE,
    CLEAR,
    GAP,
    LOST,
    OVER,
    RISE,
    SEPARATE,
    SLACK,
    SLIP_ENDS,
    SLIP_LEFT,
    SLIP_RIGHT,
    SPIN,
    STARTS,
    STICK,
    STOPS,
    TOUCHES,
    Mode,
)
from planar_pushing.simulation.systems.impacts import impact
from planar_pushing.simulation.systems.inertial_motion import (
    contact_force,
    guards,
    instant,
    kinetic_energy,
    rates,
    size,
)
from planar_pushing.simulation.systems.rest import AT_REST, from_rest, set_off, stopped

__all__ = [
    "after",
    "enter",
    "guards",
    "initial",
    "modes",
    "pace",
    "rates",
    "scales",
    "settling",
    "write",
]


@compiled
def initial(system, angle, gap, twist, state):
    state[:] = 0.0
    state[GAP], state[ANGLE], state[SPIN] = gap, angle, twist[2]
    lever = system.body.length * twist[2]
    state[OVER], state[RISE] = twist[0] + lever * sin(angle), twist[1] - lever * cos(angle)


@compiled
def scales(system, found):
    length = max(1.0, system.body.length)
    found[:] = length
    found[ANGLE] = 1.0
    found[LOST:OVER] = system.body.force * length
    found[OVER:] = 0.01 * system.body.speed


@compiled
def pace(system, during, time):
    body = system.body
    along = max(1.0, body.length) / body.speed
    return min(along, body.mass * body.speed / body.weight) if body.weight > 0.0 else along


@compiled
def settling(system, during, time, state):
    body = system.body
    return body.weight / (body.mass * max(size(system, during, time, state), AT_REST * body.speed))


@inlined
def enter(system, index, state, kind, policy):
    """A jump of the fence's velocity is an impact on what it touches."""
    during = span(system.fence, index)
    now_x, now_y = velocity(system.fence, during, during.start)
    before_x, before_y = 0.0, 0.0
    if index > 0:
        past = span(system.fence, index - 1)
        before_x, before_y = velocity(system.fence, past, past.end)
    jump_x, jump_y = before_x - now_x, before_y - now_y
    state[OVER] += jump_x
    state[RISE] += jump_y
    slack = SLACK * system.body.speed
    hits = sqrt(jump_x * jump_x + jump_y * jump_y) > slack or state[RISE] < -slack
    if state[GAP] <= SLACK and hits:
        return impact(system, during, during.start, state, kind, policy)
    return 0


@compiled
def _touches(system, state):
    """Whether the contact is on the fence and does not leave it."""
    return state[GAP] <= SLACK and abs(state[RISE]) <= SLACK * system.body.speed


@inlined
def modes(system, during, time, state, kinds, starts):
    starts[:] = 0.0
    body = system.body
    rests = body.weight > 0.0 and size(system, during, time, state) <= AT_REST * body.speed
    if not _touches(system, state):
        kinds[0] = CLEAR if rests else SEPARATE
        return 1
    if rests:
        return from_rest(system.effects, system, during, time, state, kinds, starts)
    return _in_motion(system, during, time, state, kinds)


@inlined
def _in_motion(system, during, time, state, kinds):
    """Modes of a contact on the fence whose slider moves."""
    body, slip, count = system.body, state[OVER], 0
    free = instant(system, Mode(SEPARATE, 0.0, 0.0, 0.0, during), time, state)
    if free.free_y >= -SLACK * body.force / body.mass:
        kinds[count] = SEPARATE
        count += 1
    if abs(slip) <= SLACK * body.speed:
        kinds[count] = STICK
        count += 1
        slip = 0.0
    if body.slips and slip >= 0.0:
        kinds[count] = SLIP_RIGHT
        count += 1
    if body.slips and slip <= 0.0:
        kinds[count] = SLIP_LEFT
        count += 1
    return count


@inlined
def after(system, cause, mode, time, state, policy):
    if cause == TOUCHES:
        state[GAP] = 0.0
        return time, impact(system, mode.during, time, state, mode.kind, policy)
    if cause == SLIP_ENDS:
        state[OVER] = 0.0
    elif cause == STOPS:
        return stopped(system, mode, time, state), 0
    elif cause == STARTS:
        return time, set_off(system.effects, system, mode, time, state, policy)
    return time, 0


@compiled
def write(system, mode, time, state, row):
    now = instant(system, mode, time, state)
    length, angle = system.body.length, state[ANGLE]
    row.position[0] = row.fence[0] + state[ALONG] + length * cos(angle)
    row.position[1] = row.fence[1] + state[GAP] + length * sin(angle)
    row.twist[0], row.twist[1], row.twist[2] = now.v_x, now.v_y, state[SPIN]
    row.force[0], row.force[1] = contact_force(system, mode, now)
    row.spin_ratio = spin_ratio(sqrt(now.v_x * now.v_x + now.v_y * now.v_y), state[SPIN])
    row.kinetic_energy = kinetic_energy(system, mode.during, time, state)
