"""Starts from rest, and stops, of a slider with inertia that friction of the support can hold."""

from __future__ import annotations

from collections.abc import Callable
from math import atan2, sqrt
from typing import Any

import numpy as np

from planar_pushing.mechanics.compiled import compiled, generic, inlined
from planar_pushing.mechanics.effects.inertia import Mass
from planar_pushing.mechanics.effects.support_friction import RingSupport
from planar_pushing.mechanics.modes import MOST, contact_modes
from planar_pushing.mechanics.plane import rod, toward
from planar_pushing.mechanics.reduced.base import slips
from planar_pushing.mechanics.reduced.turning import SLIPS
from planar_pushing.simulation.fence import acceleration, velocity
from planar_pushing.simulation.systems.base import (
    ALONG,
    ANGLE,
    GAP,
    HELD,
    LOST,
    MOVING,
    OVER,
    RISE,
    RUBBED,
    SEPARATE,
    SLACK,
    SLIP_LEFT,
    SLIP_RIGHT,
    SPIN,
    STICK,
    WORK,
    contact_mode,
    law_of,
    pace,
    rank,
)
from planar_pushing.simulation.systems.impacts import impact
from planar_pushing.simulation.systems.inertial_motion import kinetic_energy, rates

#: Below this part of the typical speed friction holds the slider.
AT_REST = 1e-9
#: A fence slower than this part of it, and hardly accelerated, does not move.
STILL = 1e-10


@generic
def from_rest(kinds: Any) -> Callable[..., Any]:
    """Write down every mode in which a slider at rest on the fence may start, with its acceleration.

    Parameters
    ----------
    effects : tuple
    system, during, time, state, kinds, starts
        As in `base.modes`.
    """
    return _never if kinds == (Mass,) else _starts


@generic
def set_off(kinds: Any) -> Callable[..., Any]:
    """Let a slider at rest keep up with a fence that has just begun to push it; 0, or a `Stop`.

    Parameters
    ----------
    effects : tuple
    system, mode, time, state, policy
        As in `base.after`.
    """
    return _stays if kinds == (Mass,) else _set_off


@compiled
def _never(effects, system, during, time, state, kinds, starts):
    """Nothing holds a slider without friction."""
    return 0


@compiled
def _stays(effects, system, mode, time, state, policy):
    return 0


@compiled
def _starts(effects, system, during, time, state, kinds, starts):
    body, slip = system.body, state[OVER]
    turn_x, turn_y = acceleration(system.fence, during, time)
    w_x, w_y = velocity(system.fence, during, time)
    size = sqrt(turn_x * turn_x + turn_y * turn_y)
    # A fence given as a function leaves some rounding where it is still.
    still = sqrt(w_x * w_x + w_y * w_y) <= STILL * body.speed
    if size <= (STILL * body.speed / pace(system, during, time) if still else 0.0):
        kinds[0] = HELD
        return 1
    if still and abs(turn_y) <= AT_REST * size:
        turn_y = 0.0
    own = rod(body.length, state[ANGLE])
    if abs(slip) > AT_REST * body.speed:
        return _slipping_starts(effects, body, own, size, turn_y / size, slip, kinds, starts)
    modes, motions = np.empty(MOST, np.int8), np.empty((MOST, 5))
    towards = toward(own, atan2(turn_y, turn_x))
    driven = _driven(effects, size)
    count = contact_modes(driven, own, law_of(body), towards, True, modes, motions)
    for i in range(count):
        kinds[i] = HELD if modes[i] == SEPARATE else modes[i]
        for j in range(3):
            starts[i, j] = size * motions[i, j]
    return count


@compiled
def _driven(effects, size):
    """The effects in units of an acceleration, and of the larger of their forces in a translation."""
    weight, mass = effects[0].weight, effects[1].mass * size
    unit = max(weight, mass)
    return RingSupport(weight / unit), Mass(mass / unit, effects[1].gyration)


@inlined
def _slipping_starts(effects, body, own, size, normal, slip, kinds, starts):
    """Starts under a fence that already slips along below the slider and begins to push it."""
    count = 0
    if normal <= 0.0:
        kinds[0] = HELD
        count = 1
    if not body.slips:
        return count
    kind, edge = (SLIP_RIGHT, body.left_angle) if slip > 0.0 else (SLIP_LEFT, body.right_angle)
    found = np.empty((SLIPS, 5))
    for i in range(slips(_driven(effects, size), own, toward(own, edge), normal, found)):
        kinds[count] = kind
        for j in range(3):
            starts[count, j] = size * found[i, j]
        count += 1
    return count


@inlined
def _set_off(effects, system, mode, time, state, policy):
    state[GAP] = 0.0
    kinds, starts = np.empty(MOST, np.int64), np.zeros((MOST, 3))
    count = _starts(effects, system, mode.during, time, state, kinds, starts)
    previous, chosen = contact_mode(mode.kind), -1
    for i in range(count):
        if kinds[i] != HELD and (
            chosen < 0 or rank(policy, previous, kinds[i]) < rank(policy, previous, kinds[chosen])
        ):
            chosen = i
    if chosen < 0:
        return impact(system, mode.during, time, state, mode.kind, policy)
    start = starts[chosen]
    turn_y = acceleration(system.fence, mode.during, time)[1]
    fence_x, fence_y = velocity(system.fence, mode.during, time)
    part = fence_y / turn_y if turn_y != 0.0 else 0.0
    own = rod(system.body.length, state[ANGLE])
    slip = part * (start[0] + own.length * start[2] * own.y) - fence_x
    state[OVER] = 0.0 if kinds[chosen] == STICK else slip
    state[RISE], state[SPIN] = 0.0, part * start[2]
    return 0


@inlined
def stopped(system, mode, time, state):
    """Finish a motion that dies out: speeds fall in proportion to the time that is left; the time then.

    The energy then falls with its square, and everything moves on at half its present rate.
    """
    during, found = mode.during, np.empty(MOVING)
    rates(system, mode, time, state, found)
    lost = found[LOST] + found[RUBBED] - found[WORK]
    if lost <= 0.0:
        return time
    left = min(2 * kinetic_energy(system, during, time, state) / lost, during.end - time)
    fence_x, fence_y = velocity(system.fence, during, time)
    touches = state[GAP] + found[GAP] * left / 2 - fence_y * left / 2 <= SLACK
    touches = touches and abs(state[RISE]) <= SLACK * system.body.speed
    for entry in range(OVER):
        state[entry] += found[entry] * left / 2
    # The fence itself moves on at its own speed.
    state[ALONG] -= fence_x * left / 2
    state[GAP] = 0.0 if touches else state[GAP] - fence_y * left / 2
    last_x, last_y = velocity(system.fence, during, time + left)
    state[OVER], state[RISE], state[SPIN] = -last_x, -last_y, 0.0
    return time + left
