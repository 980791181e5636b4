"""How a slider with inertia moves on: free, at rest, sticking to the fence, slipping over it.

The contact force follows from the mode, and the accelerations follow from the force.
"""

from __future__ import annotations

from collections.abc import Callable
from math import cos, nan, sin, sqrt
from typing import Any, NamedTuple

from planar_pushing.mechanics.compiled import compiled, generic
from planar_pushing.mechanics.effects.base import response
from planar_pushing.mechanics.effects.inertia import Mass
from planar_pushing.simulation.fence import acceleration, velocity
from planar_pushing.simulation.systems.base import (
    ALONG,
    ANGLE,
    CLEAR,
    FORCE_ENDS,
    GAP,
    HELD,
    LEAVES_CONE,
    LIES,
    LIFTS,
    LOST,
    OVER,
    RISE,
    RUBBED,
    SEPARATE,
    SLIP,
    SLIP_ENDS,
    SLIP_RIGHT,
    SPIN,
    STARTS,
    STICK,
    STOPS,
    TOUCHES,
    WORK,
    edge_of,
    margin,
)
from planar_pushing.simulation.systems.contact_inertia import (
    ContactInertia,
    contact_inertia,
    force_of,
    motion_of,
)

#: Part of the typical force below which a force has no direction of its own.
NO_FORCE = 1e-9
#: The slider rests below this part of the typical speed; what is left is finished in closed form.
STOPPED = 2e-9
#: The fence pushes a slider at rest from this part of the typical speed on.
PUSHES = 2e-10
#: Below this part of the typical speed a slider that starts has no direction but the impending one.
NO_DIRECTION = 1e-13


class Instant(NamedTuple):
    """What the forces at one instant follow from, all but the contact force.

    Attributes
    ----------
    v_x, v_y : float
        Velocity of the ring centre.
    fence_x, fence_y : float
        Velocity of the fence.
    free_x, free_y : float
        Acceleration of the contact over the fence without a contact force.
    torque, power : float
        Torque of friction on the support, and what that friction dissipates.
    inertia : ContactInertia
    """

    v_x: float
    v_y: float
    fence_x: float
    fence_y: float
    free_x: float
    free_y: float
    torque: float
    power: float
    inertia: ContactInertia


@generic
def friction(kinds: Any) -> Callable[..., Any]:
    """Force along the motion and torque of friction on the support at a motion (v, s) that is not rest."""
    return _no_friction if kinds == (Mass,) else _friction


@compiled
def _no_friction(effects, speed, spin):
    return 0.0, 0.0


@compiled
def _friction(effects, speed, spin):
    force, torque, _, _, _ = response(effects[:1], speed, spin)
    return force, torque


@compiled
def center_velocity(system, during, time, state):
    """Velocity of the ring centre."""
    fence_x, fence_y = velocity(system.fence, during, time)
    lever = system.body.length * state[SPIN]
    return (
        fence_x + state[OVER] - lever * sin(state[ANGLE]),
        fence_y + state[RISE] + lever * cos(state[ANGLE]),
    )


@compiled
def size(system, during, time, state):
    """Speed of the centre and of the rotation together."""
    v_x, v_y = center_velocity(system, during, time, state)
    return sqrt(v_x * v_x + v_y * v_y) + abs(state[SPIN])


@compiled
def _resistance(system, v_x, v_y, spin, mode):
    """Friction on the support along the motion, or along the impending one from rest."""
    speed = sqrt(v_x * v_x + v_y * v_y)
    impending = mode.x != 0.0 or mode.y != 0.0 or mode.spin != 0.0
    starts = impending and speed + abs(spin) <= NO_DIRECTION * system.body.speed
    if starts:
        v_x, v_y, spin = mode.x, mode.y, mode.spin
        speed = sqrt(v_x * v_x + v_y * v_y)
    if speed == 0.0 and spin == 0.0:
        return 0.0, 0.0, 0.0, 0.0
    force, torque = friction(system.effects, speed, spin)
    part = force / speed if speed > 0.0 else 0.0
    power = 0.0 if starts else force * speed + torque * spin
    return part * v_x, part * v_y, torque, power


@compiled
def instant(system, mode, time, state):
    """Everything at an instant that the contact force does not change."""
    system.body.evaluations += 1
    body, angle, spin = system.body, state[ANGLE], state[SPIN]
    fence_x, fence_y = velocity(system.fence, mode.during, time)
    turn_x, turn_y = acceleration(system.fence, mode.during, time)
    e_x, e_y = cos(angle), sin(angle)
    lever = body.length * spin
    v_x, v_y = fence_x + state[OVER] - lever * e_y, fence_y + state[RISE] + lever * e_x
    f_x, f_y, torque, power = _resistance(system, v_x, v_y, spin, mode)
    pull, swing = lever * spin, -body.length * torque / body.moment
    free_x = -f_x / body.mass + swing * e_y + pull * e_x - turn_x
    free_y = -f_y / body.mass - swing * e_x + pull * e_y - turn_y
    inertia = contact_inertia(body, angle)
    return Instant(v_x, v_y, fence_x, fence_y, free_x, free_y, torque, power, inertia)


@compiled
def _edge_force(body, kind, now):
    """Size and direction of the force on an edge that keeps a slipping contact on the fence."""
    x, y = edge_of(body, kind)
    normal = motion_of(now.inertia, x, y)[1]
    return -now.free_y / normal if normal != 0.0 else 0.0, x, y


@compiled
def contact_force(system, mode, now):
    """Force of the fence on the slider."""
    if mode.kind == STICK:
        return force_of(now.inertia, -now.free_x, -now.free_y)
    if mode.kind == SEPARATE or mode.kind == CLEAR or mode.kind == HELD:
        return 0.0, 0.0
    size, x, y = _edge_force(system.body, mode.kind, now)
    return size * x, size * y


@compiled
def rates(system, mode, time, state, found):
    if mode.kind == CLEAR or mode.kind == HELD:
        _rates_at_rest(system, mode, time, found)
        return
    now = instant(system, mode, time, state)
    f_x, f_y = contact_force(system, mode, now)
    slip, rise, spin, angle = state[OVER], state[RISE], state[SPIN], state[ANGLE]
    torque = system.body.length * (f_x * sin(angle) - f_y * cos(angle))
    push_x, push_y = motion_of(now.inertia, f_x, f_y)
    touches = mode.kind != SEPARATE
    found[ALONG], found[GAP], found[ANGLE] = slip, rise, spin
    found[SLIP] = slip if touches else 0.0
    found[LOST] = -f_x * slip - f_y * rise
    found[WORK] = f_x * now.fence_x + f_y * now.fence_y
    found[RUBBED] = now.power
    found[OVER] = 0.0 if mode.kind == STICK else now.free_x + push_x
    found[RISE] = 0.0 if touches else now.free_y + push_y
    found[SPIN] = (torque - now.torque) / system.body.moment


@compiled
def _rates_at_rest(system, mode, time, found):
    found[:] = 0.0
    fence_x, fence_y = velocity(system.fence, mode.during, time)
    turn_x, turn_y = acceleration(system.fence, mode.during, time)
    found[ALONG], found[GAP] = -fence_x, -fence_y
    found[OVER], found[RISE] = -turn_x, -turn_y


@compiled
def guards(system, mode, time, state, found):
    found[:] = nan
    if mode.kind == CLEAR:
        found[TOUCHES] = state[GAP]
    elif mode.kind == HELD:
        fence_y = velocity(system.fence, mode.during, time)[1]
        found[STARTS] = PUSHES - fence_y / system.body.speed
    else:
        _guard_motion(system, mode, instant(system, mode, time, state), state, found)


@compiled
def _guard_motion(system, mode, now, state, found):
    body = system.body
    if mode.kind == SEPARATE:
        found[TOUCHES] = state[GAP]
    else:
        found[LIFTS] = now.free_y * body.mass / body.force
    if mode.kind == STICK:
        f_x, f_y = contact_force(system, mode, now)
        found[LEAVES_CONE] = margin(body, f_x, f_y, NO_FORCE * body.force)
    elif mode.kind != SEPARATE:
        side = 1.0 if mode.kind == SLIP_RIGHT else -1.0
        size, _, _ = _edge_force(body, mode.kind, now)
        found[SLIP_ENDS] = side * state[OVER] / body.speed
        found[FORCE_ENDS] = size / (abs(size) + body.force)
    if body.length > 0.0:
        found[LIES] = state[GAP] + body.length * sin(state[ANGLE])
    if body.weight > 0.0:
        speed = sqrt(now.v_x * now.v_x + now.v_y * now.v_y) + abs(state[SPIN])
        found[STOPS] = speed / body.speed - STOPPED


@compiled
def kinetic_energy(system, during, time, state):
    """Of the slider."""
    v_x, v_y = center_velocity(system, during, time, state)
    spin = state[SPIN]
    return (system.body.mass * (v_x * v_x + v_y * v_y) + system.body.moment * spin * spin) / 2
