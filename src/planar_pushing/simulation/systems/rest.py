"""Starts from rest, and stops, of a slider with inertia that friction of the support can hold."""

from __future__ import annotations

from collections.abc import Callable
from math import atan2, copysign, inf, sqrt
from typing import Any

from planar_pushing.mechanics.compiled import compiled, generic, inlined
from planar_pushing.mechanics.effects.base import scaled
from planar_pushing.mechanics.modes import contact_modes
from planar_pushing.mechanics.plane import contact_motion, rod, toward
from planar_pushing.mechanics.reduced.base import slips
from planar_pushing.simulation.systems import base, contact
from planar_pushing.simulation.systems.motion import MASSES, kinetic_energy

#: A fence slower than this part of it, and hardly accelerated, does not move.
STILL = 1e-10


@generic
def starting(kinds: Any) -> Callable[..., Any]:
    """Write down every mode in which a slider at rest on the fence may start: effects, as `base.modes`."""
    return _never if len(kinds) == 1 and kinds[0] in MASSES else _starting


@compiled
def _never(effects, system, during, time, state, kinds, starts):
    """Nothing holds a slider without friction."""
    return 0


@compiled
def _starting(effects, system, during, time, state, kinds, starts):
    turn_x, turn_y, moves = _setting_off(system, during, time, state)
    if not moves:
        kinds[0] = base.HELD
        return 1
    size = sqrt(turn_x * turn_x + turn_y * turn_y)
    # The pusher's motion is the unit of `contact_modes`, so the mass counts in units of its acceleration.
    body, now = system.body, _exact_pose(system, state)
    driven, own = (now.effects[0], scaled(now.effects[1], size)), now.own
    found, motions = body.modes[:], body.motions[:]
    if abs(state[base.OVER]) > base.AT_REST * body.speed:
        slip, normal = state[base.OVER], turn_y / size
        count = _slipping_starts(driven, body, own, normal, slip, found, motions)
    else:
        towards = toward(own, atan2(turn_y, turn_x))
        count = contact_modes(driven, own, contact.law_of(body), towards, True, found, motions)
    for i in range(count):
        kinds[i] = base.HELD if found[i] == base.SEPARATE else found[i]
        for j in range(3):
            starts[i, j] = size * motions[i, j]
    return count


@compiled
def _exact_pose(system, state):
    """The pose, exact where the rod's angle is a quarter turn."""
    return base.pose_of(system, rod(system.body.length, state[base.ANGLE]), state)


@inlined
def _setting_off(system, during, time, state):
    """Acceleration of the fence, and whether it moves at all."""
    turn_x, turn_y = base.acceleration(system, during, time, state)
    w_x, w_y = base.velocity(system, during, time, state)
    size = sqrt(turn_x * turn_x + turn_y * turn_y)
    # A fence given as a function leaves some rounding where it is still.
    least = STILL * system.body.speed
    if sqrt(w_x * w_x + w_y * w_y) > least:
        return turn_x, turn_y, size > 0.0
    moves = size > least / base.pace(system, during, time)
    return turn_x, 0.0 if abs(turn_y) <= base.AT_REST * size else turn_y, moves


@inlined
def _slipping_starts(driven, body, own, normal, slip, found, motions):
    """Starts under a fence that already slips along below the slider and begins to push it."""
    count = 0
    if normal <= 0.0:
        found[0], motions[0, :], count = base.SEPARATE, 0.0, 1
    if body.slips:
        kind = base.SLIP_RIGHT if slip > 0.0 else base.SLIP_LEFT
        edge = toward(own, contact.edge_of(body, kind)[2])
        for _ in range(slips(driven, own, edge, normal, copysign(inf, edge.x), motions[count:])):
            found[count] = kind
            count += 1
    return count


@inlined
def set_off(system, mode, time, state, policy):
    """Let a slider at rest keep up with a fence that has just begun to push it; 0, or a `Stop`."""
    state[base.GAP] = 0.0
    during = mode.during
    kinds, starts = system.body.kinds[:], system.body.starts[:]
    starts[:] = 0.0
    count = starting(system.effects, system, during, time, state, kinds, starts)
    chosen = contact.preferred(policy, base.contact_mode(mode.kind), kinds, count)
    if chosen < 0 or kinds[chosen] == base.HELD:
        return contact.impact(system, during, time, state, mode.kind, policy)
    turn_y = base.acceleration(system, during, time, state)[1]
    fence_x, fence_y = base.velocity(system, during, time, state)
    part = fence_y / turn_y if turn_y != 0.0 else 0.0
    v_x, v_y, spin = part * starts[chosen, 0], part * starts[chosen, 1], part * starts[chosen, 2]
    slip = contact_motion(_exact_pose(system, state).own, v_x, v_y, spin)[0] - fence_x
    state[base.OVER] = 0.0 if kinds[chosen] == base.STICK else slip
    state[base.RISE], state[base.SPIN] = 0.0, spin
    return 0


@inlined
def stopped(system, mode, time, state):
    """Finish a motion that dies out: speeds fall in proportion to the time that is left; the time then.

    The energy then falls with its square, and everything moves on at half its present rate.
    """
    during, body, found = mode.during, system.body, system.body.rates[:]
    base.rates(system, mode, time, state, found)
    lost = found[base.LOST] + found[base.RUBBED] - found[base.WORK]
    if lost <= 0.0:
        return time
    v_x, v_y = base.center_velocity(system, during, time, state)
    now = base.pose(system, state)
    energy = kinetic_energy(body, now.x, now.y, v_x, v_y, state[base.SPIN])
    half = min(2 * energy / lost, during.end - time) / 2
    for entry in range(base.OVER):
        state[entry] += found[entry] * half
    # The fence itself moves on at its own speed.
    fence_x, fence_y = base.velocity(system, during, time, state)
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
