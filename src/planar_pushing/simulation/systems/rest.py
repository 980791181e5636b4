"""Starts from rest, and stops, of a slider with inertia and support friction."""

from __future__ import annotations

from collections.abc import Callable
from math import atan2, sqrt
from typing import Any

from planar_pushing.simulation.legacy.compiled import compiled, generic, inlined
from planar_pushing.simulation.legacy.free import free
from planar_pushing.simulation.legacy.mass import Mass
from planar_pushing.simulation.legacy.modes import contact_modes
from planar_pushing.simulation.legacy.plane import Direction, rod, toward
from planar_pushing.simulation.legacy.record import Push
from planar_pushing.simulation.systems import base, contact, equations
from planar_pushing.simulation.systems.drag import with_loads
from planar_pushing.simulation.systems.frame import (
    center_motion,
    contact_motion,
    kinetic_energy,
    to_contact,
)
from planar_pushing.simulation.systems.shapes.base import frame_angle

#: A fence slower than this fraction of the typical speed, with little acceleration, is at rest.
STILL = 1e-10
#: Tangential acceleration, in units of the normal one, that represents a fence already slipping at a
#: contact.
FAST = 1e6


@generic
def starting(kinds: Any) -> Callable[..., Any]:
    """Store all modes in which a slider at rest on the fence can start. Arguments as in `base.modes`."""
    return _starting if kinds else _never


@compiled
def _never(friction, system, during, time, state, kinds, feet, hinged, starts):
    """No modes, since a slider without friction is never held at rest."""
    return 0


@compiled
def _driven(system, state, size):
    """Effects of a start from rest, with accelerations in units of a magnitude."""
    body = system.body
    ratio = body.moment / body.mass
    mass = Mass(size * body.mass, ratio, body.center[0], body.center[1])
    effects = (*system.friction, mass)
    return with_loads(system.loads, effects, body, state[base.ANGLE])


@compiled
def _exact_pose(system, state):
    """Pose of the slider, exact if body x is at 90 degrees."""
    angle = frame_angle(system.shape, state[base.ANGLE])
    return base.pose_in(system, rod(1.0, angle), state)


@compiled
def clear(system, state, kinds, feet, hinged, starts):
    """Mode of a slider at rest above the fence: friction holds it, or loads set it in motion."""
    size = system.body.force / system.body.mass
    rest = free(_driven(system, state, size))
    kinds[0] = base.CLEAR
    if rest.x != 0.0 or rest.y != 0.0 or rest.spin != 0.0:
        frame = base.pose(system, state).frame
        x, y = to_contact(frame, size * rest.x, size * rest.y)
        kinds[0], starts[0, 0], starts[0, 1], starts[0, 2] = base.SEPARATE, x, y, size * rest.spin
    return 1


@compiled
def _starting(friction, system, during, time, state, kinds, feet, hinged, starts):
    turn_x, turn_y, moves = _setting_off(system, during, time, state)
    body, size = system.body, sqrt(turn_x * turn_x + turn_y * turn_y)
    loaded = len(system.loads) > 0
    if not moves and not loaded:
        kinds[0] = base.HELD
        return 1
    now, slip = _exact_pose(system, state), state[base.OVER]
    x, y = turn_x, turn_y
    slides = abs(slip) > base.AT_REST * body.speed
    if slides:
        # The fence already slips at the contact, so only its normal motion matters.
        x = -FAST * abs(turn_y) if slip > 0.0 else FAST * abs(turn_y)
        size = sqrt(x * x + y * y)
    if not moves:
        x, y, size = 0.0, 0.0, 0.0
    unit = max(size, body.force / body.mass) if loaded else size
    pusher = toward(now.frame, atan2(y, x))
    if size < unit:
        part = size / unit
        pusher = Direction(
            pusher.angle, part * pusher.x, part * pusher.y, part * pusher.along, part * pusher.aside
        )
    if unit == 0.0:
        kinds[0] = base.HELD
        return 1
    law, found, count = contact.law_of(body), system.room.solutions, 0
    edges = toward(now.frame, law.right), toward(now.frame, law.left)
    push = Push(_driven(system, state, unit), now.at, now.frame.x, -now.frame.y)
    for i in range(contact_modes(push, law, edges, pusher, True, system.room.scratch, found)[0]):
        if slides and not _goes_on(found[i].mode, slip):
            continue
        kinds[count], feet[count] = found[i].mode, found[i].pivot
        hinged[count] = found[i].pivot >= 0 and found[i].mode != base.STICK
        for j in range(3):
            starts[count, j] = unit * found[i].twist[j]
        if found[i].twist[0] == 0.0 and found[i].twist[1] == 0.0 and found[i].twist[2] == 0.0:
            kinds[count] = base.HELD if found[i].mode == base.SEPARATE else base.PROPPED
            starts[count, 0], starts[count, 1] = found[i].force[0], found[i].force[1]
            starts[count, 2] = 0.0
        count += 1
    return count


@compiled
def _goes_on(mode, slip):
    """Whether a start has the same direction of slip, or no contact force."""
    return mode == base.SEPARATE or contact.side_of(mode) * slip > 0.0


@inlined
def _setting_off(system, during, time, state):
    """Acceleration of the fence, and whether the fence moves."""
    turn_x, turn_y = base.acceleration(system, during, time, state)
    w_x, w_y = base.velocity(system, during, time, state)
    size = sqrt(turn_x * turn_x + turn_y * turn_y)
    # A fence at rest that is given as a function can have rounding errors in its velocity.
    least = STILL * system.body.speed
    if sqrt(w_x * w_x + w_y * w_y) > least:
        return turn_x, turn_y, size > 0.0
    moves = size > least / base.pace(system, during, time)
    return turn_x, 0.0 if abs(turn_y) <= base.AT_REST * size else turn_y, moves


@inlined
def set_off(system, mode, time, state, policy):
    """Set a slider at rest in motion with a fence that starts to push it; return 0 or a `Stop`."""
    state[base.GAP] = 0.0
    during, room = mode.during, system.room
    kinds, feet, hinged, starts = room.kinds, room.feet, room.hinged, room.starts
    starts[:], feet[:], hinged[:] = 0.0, -1, 0
    count = starting(system.friction, system, during, time, state, kinds, feet, hinged, starts)
    chosen = contact.preferred(policy, base.contact_mode(mode.kind), kinds, count)
    if chosen < 0 or kinds[chosen] >= base.CLEAR:
        return contact.impact(system, during, time, state, mode.kind, policy)
    turn_y = base.acceleration(system, during, time, state)[1]
    fence_x, fence_y = base.velocity(system, during, time, state)
    part = fence_y / turn_y if turn_y != 0.0 else 0.0
    v_x, v_y, spin = part * starts[chosen, 0], part * starts[chosen, 1], part * starts[chosen, 2]
    slip = contact_motion(_exact_pose(system, state), v_x, v_y, spin)[0] - fence_x
    state[base.OVER] = 0.0 if kinds[chosen] == base.STICK else slip
    state[base.RISE], state[base.SPIN] = 0.0, spin
    return 0


@inlined
def stopped(system, mode, time, state):
    """Complete a motion that comes to rest; return the time at rest.

    Speeds decrease in proportion to the remaining time, and the energy with its square, so that everything
    changes at half its present rate on average.
    """
    during, body, found = mode.during, system.body, system.room.rates
    equations.rates(system, mode, time, state, found)
    now = base.pose(system, state)
    fence_x, fence_y = base.velocity(system, during, time, state)
    v_x, v_y = center_motion(
        now, fence_x + state[base.OVER], fence_y + state[base.RISE], state[base.SPIN]
    )
    lost = (
        found[base.LOST]
        - found[base.WORK]
        - base.load_power(system, now, state, v_x, v_y, state[base.SPIN])
    )
    for i in range(len(state) - len(system.effects), len(state)):
        lost += found[i]
    if lost <= 0.0:
        return time
    energy = kinetic_energy(body, now, v_x, v_y, state[base.SPIN])
    half = min(2 * energy / lost, during.end - time) / 2
    for entry in range(len(state)):
        if entry < base.OVER or entry >= base.MOVING:
            state[entry] += found[entry] * half
    # The fence continues at its own speed.
    state[base.ALONG] -= fence_x * half
    state[base.GAP] -= fence_y * half
    if (
        base.clearance(system, state) <= base.SLACK
        and abs(state[base.RISE]) <= base.SLACK * body.speed
    ):
        state[base.GAP] = 0.0
    last_x, last_y = base.velocity(system, during, time + 2 * half, state)
    state[base.OVER], state[base.RISE], state[base.SPIN] = -last_x, -last_y, 0.0
    return time + 2 * half
