"""How far the contact moves aside from a force, over all magnitudes of the motion.

With friction and inertia the direction depends on the magnitude. Between slow and fast it may lie beyond
those of each effect alone.
"""

from __future__ import annotations

from math import atan2, inf, sinh
from typing import NamedTuple

import numpy as np

from planar_pushing.mechanics.angles import RESOLUTION
from planar_pushing.mechanics.compiled import compiled, owning
from planar_pushing.mechanics.numerics.bracket import dip
from planar_pushing.mechanics.numerics.root import EQUATIONS, excess
from planar_pushing.mechanics.reduced.pressed.motions import Amount, contact_of, motion_of

#: Magnitudes at which the angle of the contact's motion is evaluated, to either side of the one at which
#: friction and inertia are of one size: hyperbolic sines, this far apart, are their logarithms.
NODES, APART = 32, 0.11
#: Steps between the two neighbours of a node at which the angle is extreme.
FINER = 16
#: Added to angles from the force, which makes them positive.
POSITIVE = 2.0


class Turn(NamedTuple):
    """Angle from the force to the contact's motion, to the left or, for a side of -1, to the right."""

    amount: Amount
    side: float


@compiled
def _aside(own, force, moved):
    """Angle of the contact's motion from the force, within 90 degrees."""
    x, y = contact_of(own, moved)
    along, aside = x * own.x + y * own.y, x * own.y - y * own.x
    return atan2(
        force.aside * along - force.along * aside, force.along * along + force.aside * aside
    )


@compiled
def angle_of(own, force, moved):
    """Angle of the contact's motion."""
    return force.angle + _aside(own, force, moved)


@compiled
def _turn(of, z):
    aside = _aside(of.amount.own, of.amount.edge, motion_of(of.amount, z))
    return POSITIVE + of.side * aside, 0.0


EQUATIONS[Turn] = _turn


@owning
def between(amount):
    """How far to the right and to the left of the force the contact moves at the most."""
    aside = np.empty(2 * NODES + 1)
    for i in range(len(aside)):
        aside[i] = excess(Turn(amount, 1.0), _node(i))[0] - POSITIVE
    return -_least(Turn(amount, 1.0), aside), -_least(Turn(amount, -1.0), -aside)


@compiled
def _node(i):
    return sinh((i - NODES) * APART)


@owning
def _least(turn, asides):
    """The least angle of all magnitudes: in the dips about nodes, and at the ends of level stretches."""
    found = min(asides[0], asides[-1])
    for i in range(1, len(asides) - 1):
        here, before, after = asides[i], asides[i - 1], asides[i + 1]
        level = max(before, after) - here <= RESOLUTION
        if here <= before + RESOLUTION and here <= after + RESOLUTION and not level:
            found = min(found, _deepest(turn, _node(i - 1), _node(i + 1)) - POSITIVE)
    return found


@compiled
def _deepest(turn, low, high):
    """The least value in a dip, which may be narrow beside a level stretch."""
    step = (high - low) / FINER
    least, place = inf, low
    for i in range(1, FINER):
        value = excess(turn, low + i * step)[0]
        if value < least:
            least, place = value, low + i * step
    return dip(turn, place - step, place, place + step, least)[1]
