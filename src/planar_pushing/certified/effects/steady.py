"""Slips along a path through rest on which the slider pivots about a foot at any speed.

The foot lies across the path from the contact. Its friction is any force up to its share, so that the
slips under the force of an edge form an interval of speeds.
"""

from __future__ import annotations

from collections.abc import Iterator

from flint import arb

from planar_pushing.certified.balls import Undecided, sign
from planar_pushing.certified.effects.slips import Slip
from planar_pushing.certified.effects.way import Way
from planar_pushing.certified.potential.gradient import Motion, response
from planar_pushing.certified.supports.pressure.moments import Vector

#: Coefficients of a polynomial in the speed.
Polynomial = tuple[arb, ...]


def steady_foot(way: Way) -> int:
    """The foot about which the slider can rotate everywhere on a path through rest, -1 if there is none."""
    for i in range(len(way.total.support.points)):
        place = way.total.foot(i)
        if way.rests and any(place) and way.toward.along(place) == 0:
            return i
    return -1


def steady_slips(
    way: Way, edge: Vector, stick: arb, side: int, foot: int, is_even: bool
) -> Iterator[Slip]:
    """Ends of the interval of slips between rest and sticking; rest is not a slip.

    Raises
    ------
    Undecided
        If the interval reaches sticking, or the foot slides before and no symmetry determines the force.
    """
    if not all(each.is_zero() for each in way.total.load):
        raise Undecided("a load, and a pivot at all speeds")
    sense = sign(stick)
    if sense == side:  # the force would extract energy from the slider
        return
    t = sense * way.toward.x, sense * way.toward.y
    (x, y), share = way.total.foot(foot), way.total.weight * way.total.support.points[foot].share
    spin, reach = (y * t[0] - x * t[1]) / (x * x + y * y), arb(x * x + y * y).sqrt()
    still, moving = (response(way.total, Motion(t, spin, arb(i)), foot) for i in (0, 1))
    part = -still.torque / reach, (still.torque - moving.torque) / reach
    middle = still.x - part[0] * y / reach, still.y + part[0] * x / reach
    change = (
        moving.x - still.x - part[1] * y / reach,
        moving.y - still.y + part[1] * x / reach,
    )
    free = share * share - part[0] * part[0], -2 * part[0] * part[1], -part[1] * part[1]
    limit = abs(stick)
    if not is_even and not _value(free, limit) > 0:
        raise Undecided("a foot that is a pivot only up to some speed")
    across = tuple(edge[0] * f[1] - edge[1] * f[0] for f in (middle, change, (x, y)))
    slack = (
        free[0] * across[2] ** 2 - across[0] ** 2 * reach**2,
        free[1] * across[2] ** 2 - 2 * across[0] * across[1] * reach**2,
        free[2] * across[2] ** 2 - across[1] ** 2 * reach**2,
    )
    for speed in _ends(slack, limit):
        force = _force((middle, change), speed, across, (arb(x), arb(y)))
        if sign(force[0] * edge[0] + force[1] * edge[1]) > 0:
            motion = speed * t[0], speed * t[1]
            yield Slip(sense * speed, motion, spin * speed, force, foot)


def _value(p: Polynomial, s: arb) -> arb:
    return p[0] + s * (p[1] + s * p[2])


def _force(
    lines: tuple[Vector, Vector], speed: arb, across: tuple[arb, ...], foot: tuple[arb, arb]
) -> Vector:
    """The force on the edge at a speed."""
    (a, b), (c, d) = lines
    part = -(across[0] + speed * across[1]) / across[2]
    return a + speed * c + part * foot[0], b + speed * d + part * foot[1]


def _ends(slack: Polynomial, limit: arb) -> list[arb]:
    """Ends of the range where a concave quadratic is positive, inside (0, limit)."""
    whole = slack[1] ** 2 - 4 * slack[0] * slack[2]
    if sign(slack[2]) == 0:
        raise Undecided("slips at all speeds")
    if sign(whole) < 0:
        return []
    root = whole.sqrt()
    ends = [(-slack[1] + side * root) / (2 * slack[2]) for side in (1, -1)]
    if sign(ends[1]) > 0 and sign(ends[1] - limit) >= 0 > sign(ends[0] - limit):
        raise Undecided("slips up to sticking")
    return [each for each in ends if sign(each) > 0 > sign(each - limit)]
