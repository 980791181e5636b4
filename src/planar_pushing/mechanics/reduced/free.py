"""The motion of a slider that nothing pushes: rest, or where loads take it.

It is the least of the potential over all twists: the root of the torque over the rotation, at each rotation
the root of the force along x over the motion along x, and at each of these the root along y. Each increases,
as the potential is convex. Friction makes the torque jump at rest.
"""

from __future__ import annotations

from math import copysign
from typing import NamedTuple

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.effects.base import pull, resistance
from planar_pushing.mechanics.numerics.root import increasing_root

#: A twist whose inertia counts for nothing beside friction, in units in which both are of one magnitude.
SLOWEST = 1e-14


class Free(NamedTuple):
    """Twist of the origin, body frame."""

    x: float
    y: float
    spin: float


@compiled
def _along_y(of, y):
    effects, spin, x = of
    return resistance(effects, x, y, spin, 0.0).f_y


@compiled
def _y_at(effects, spin, x):
    return increasing_root(_along_y, (effects, spin, x), 0.0, abs(spin) + abs(x))


@compiled
def _along_x(of, x):
    effects, spin = of
    return resistance(effects, x, _y_at(effects, spin, x), spin, 0.0).f_x


@compiled
def _free_at(effects, spin):
    """The free motion with a given rotation."""
    x = increasing_root(_along_x, (effects, spin), 0.0, abs(spin))
    return Free(x, _y_at(effects, spin, x), spin)


@compiled
def _torque(of, spin):
    x, y, _ = _free_at(of[0], spin)
    return resistance(of[0], x, y, spin, 0.0).torque


@compiled
def free(effects):
    """The twist at which effects exert no wrench; zero where friction holds the loads."""
    x, y, torque = pull(effects)
    if x == 0.0 and y == 0.0 and torque == 0.0:
        return Free(0.0, 0.0, 0.0)
    before, after = _torque((effects,), -SLOWEST), _torque((effects,), SLOWEST)
    if before <= 0.0 <= after:
        slow = _free_at(effects, SLOWEST)
        if abs(slow.x) + abs(slow.y) < 1e9 * SLOWEST:
            return Free(0.0, 0.0, 0.0)
    spin = copysign(SLOWEST, -after if after < 0.0 else -before)
    return _free_at(effects, increasing_root(_torque, (effects,), spin, 1.0))
