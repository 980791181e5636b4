"""Slips of any support, as `base` asks for them: under friction or inertia alone, and under both.

Under both, the contact's normal motion over the size of the motion need not be monotone, so several motions
may have one normal part. They are sought between nodes at which it is on either side of the one sought.
Where it is nearer to that at a node than at both neighbours, it is followed to its least distance, beside
which there may be two.
"""

from __future__ import annotations

from collections.abc import Callable
from math import hypot
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.compiled import compiled, generic
from planar_pushing.mechanics.effects.any_mass import MassAt
from planar_pushing.mechanics.numerics.bracket import bracketed, dip
from planar_pushing.mechanics.numerics.root import EQUATIONS, excess
from planar_pushing.mechanics.reduced.corners import corner_under
from planar_pushing.mechanics.reduced.pressed.motions import (
    RANGE,
    Amount,
    at_end,
    line_of,
    motion_of,
    pushed,
    rise_of,
)

#: Number of nodes on each side of the middle, where they are denser.
NODES = 24


class Rise(NamedTuple):
    """The contact's normal motion less a given one, times a sign."""

    amount: Amount
    normal: float
    sign: float


@compiled
def _lack(of, z):
    return of.sign * (rise_of(of.amount.own, motion_of(of.amount, z)) - of.normal), 0.0


EQUATIONS[Rise] = _lack


@compiled
def _write(moved, scale, force, found):
    """Write down a motion times a scale, its force times another."""
    found[0], found[1], found[2] = scale * moved.v_x, scale * moved.v_y, scale * moved.spin
    found[3], found[4] = force * moved.f_x, force * moved.f_y
    found[5], found[6], found[7] = found[3], found[4], float(moved.pivot)


@compiled
def edge_motion(effects, own, edge):
    """As `base.edge_motion`."""
    moved = pushed(effects, own, edge, 1.0)
    scale = 1.0 / max(hypot(moved.v_x, moved.v_y), abs(moved.spin))
    force = _growth(effects, scale)
    twist = scale * moved.v_x, scale * moved.v_y, scale * moved.spin
    return *twist, force * moved.f_x, force * moved.f_y


@compiled
def steady_slips(effects, own, edge, normal, found):
    """As `base.slips`, for one effect, whose motion keeps its direction; of a corner both ends."""
    line = line_of(effects, own, edge, 1.0)
    corner = corner_under(effects, line)
    if corner.exists:
        middle = pushed(effects, own, edge, 1.0)
        first = at_end(own, corner.first, middle.along, -middle.aside)
        last = at_end(own, corner.last, middle.along, -middle.aside)
        count = _grown(effects, own, first, normal, found[0])
        return count + _grown(effects, own, last, normal, found[count])
    return _grown(effects, own, pushed(effects, own, edge, 1.0), normal, found[0])


@compiled
def _grown(effects, own, moved, normal, found):
    """Write down a motion that has grown to a given normal part; how many can."""
    advance = rise_of(own, moved)
    if not ((normal > 0.0 and advance > 0.0) or (normal < 0.0 and advance < 0.0)):
        return 0
    scale = normal / advance
    _write(moved, scale, _growth(effects, scale), found)
    return 1


@generic
def _growth(kinds: Any) -> Callable[..., Any]:
    """How a force grows with the motion."""
    return _in_proportion if MassAt in kinds else _not


@compiled
def _in_proportion(effects, scale):
    return scale


@compiled
def _not(effects, scale):
    return 1.0


@compiled
def slips(effects, own, edge, normal, found):
    """As `base.slips`, for friction and inertia."""
    amount, count = Amount(effects, own, edge), 0
    places, lacks = _nodes(Rise(amount, normal, 1.0))
    for i in range(1, len(places)):
        if (lacks[i - 1] < 0.0) != (lacks[i] < 0.0):
            between = places[i - 1], places[i], lacks[i - 1], lacks[i]
            count = _write_root(Rise(amount, normal, 1.0), between, found, count)
        elif i + 1 < len(places):
            count = _write_dip(
                amount, normal, places[i - 1 : i + 2], lacks[i - 1 : i + 2], found, count
            )
    return count


@compiled
def _nodes(rise):
    """Nodes over the logarithm of the motion's size, and what the normal motion lacks there."""
    places, lacks = np.empty(2 * NODES + 1), np.empty(2 * NODES + 1)
    for i in range(-NODES, NODES + 1):
        places[i + NODES] = RANGE * i * abs(i) / (NODES * NODES)
        lacks[i + NODES] = excess(rise, places[i + NODES])[0]
    return places, lacks


@compiled
def _write_root(rise, between, found, count):
    """Write down the motion at a root between two places; the number of motions then."""
    if count == len(found):
        return count
    low, high, at_low, at_high = between
    _write(
        motion_of(rise.amount, bracketed(rise, low, high, at_low, at_high)), 1.0, 1.0, found[count]
    )
    return count + 1


@compiled
def _write_dip(amount, normal, places, lacks, found, count):
    """Write down both motions of a dip beside the middle one of three nodes, if it holds any."""
    sign = -1.0 if lacks[1] < 0.0 else 1.0
    if not (sign * lacks[0] > sign * lacks[1] and sign * lacks[2] >= sign * lacks[1] >= 0.0):
        return count
    rise = Rise(amount, normal, sign)
    place, value = dip(rise, places[0], places[1], places[2], sign * lacks[1])
    if value < 0.0:
        before = places[0], place, sign * lacks[0], value
        after = place, places[2], value, sign * lacks[2]
        count = _write_root(rise, before, found, count)
        count = _write_root(rise, after, found, count)
    return count
