"""Whether friction holds a slider against a load, and whether the slider otherwise leaves the pusher."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise

from flint import arb, fmpq

from planar_pushing.certified.balls import Undecided, sign
from planar_pushing.certified.effects.under import under
from planar_pushing.certified.potential.direction import Direction, degrees
from planar_pushing.certified.potential.gradient import Motion, response
from planar_pushing.certified.potential.resistance import Resistance
from planar_pushing.certified.potential.sticking import rotation
from planar_pushing.certified.supports.pressure.moments import Vector, moments

#: Numbers of directions that are tried in turn; a polygon of forces has a corner for each.
DIRECTIONS = (8, 32, 128)
#: Angle of the first direction, degrees: no foot is exactly across it.
FIRST = fmpq(12345, 7919)


def is_held(total: Resistance) -> bool:
    """Whether the slider stays at rest without the pusher.

    The forces of small motions, less the load, bound a convex region. It contains the origin if a
    polygon of some of them does; it does not if the potential of one motion is negative.

    Raises
    ------
    Undecided
        If the load is next to the limit surface.
    """
    if all(each.is_zero() for each in total.load):
        return True
    if total.weight == 0:
        return False
    contact = arb(-total.length), arb(0)
    if sign(total.weight * moments(total.support, contact).distance - abs(total.load[2])) < 0:
        return False
    for count in DIRECTIONS:
        found = [_small(total, FIRST + fmpq(360 * i, count)) for i in range(count)]
        if any(u[0] * f[0] + u[1] * f[1] < 0 for u, f in found):
            return False
        if _holds_origin([force for _, force in found]):
            return True
    raise Undecided("the load is next to the limit surface")


def _small(total: Resistance, angle: fmpq) -> tuple[Vector, Vector]:
    """Direction of a small motion of the contact, and its force."""
    t = degrees(angle).ball()
    now = response(total, Motion(t, rotation(total, t, arb(0)), arb(0)))
    return t, (now.x, now.y)


def _holds_origin(corners: Sequence[Vector]) -> bool:
    """Whether a polygon with counter-clockwise corners contains the origin."""
    sides: Iterable[tuple[Vector, Vector]] = pairwise([*corners, corners[0]])
    return all(a[0] * b[1] - a[1] * b[0] > 0 for a, b in sides)


def free_normal(total: Resistance, normal: Direction, power: arb | fmpq) -> arb:
    """Normal force that a frictionless pusher with a given normal motion would exert.

    It is negative if the free slider moves away from the pusher.
    """
    return under(total, total.push(normal), power).force
