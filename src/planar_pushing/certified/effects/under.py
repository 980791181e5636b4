"""The motion under a force along a direction, with any effects.

Among contact motions ``p e + s n``, n to the left of the direction e, the force has no part along n at one:
the part rises with s, by convexity, and jumps where a foot pivots.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from flint import arb, fmpq

from planar_pushing.certified.balls import Undecided, sign
from planar_pushing.certified.effects.gradient import Motion, response, slopes
from planar_pushing.certified.effects.newton import Line, least
from planar_pushing.certified.effects.resistance import Resistance
from planar_pushing.certified.effects.sticking import near_root, rising_bounds, rotations, width
from planar_pushing.certified.effects.way import Way, at, kinks, line
from planar_pushing.certified.supports.pressure.moments import Vector
from planar_pushing.certified.supports.push import Push

#: Doublings of a bracket.
DOUBLINGS = 200


@dataclass(frozen=True, slots=True)
class Moved:
    """A motion under a line of force, body frame.

    Attributes
    ----------
    motion : tuple of arb
        Of the contact.
    spin : arb
        Rotation.
    force : arb
        Part along the direction; the other one is zero.
    pivot : int
        Number of the support's point that is the centre of rotation, -1 without one.
    """

    motion: Vector
    spin: arb
    force: arb
    pivot: int = -1


def under(total: Resistance, push: Push, power: arb | fmpq) -> Moved:
    """The motion under a force along a direction e, whose contact moves by u with a given ``e . u``.

    Parameters
    ----------
    total : Resistance
    push : Push
        The direction e, by `total.push`.
    power : arb or fmpq
        ``e . u``; its sign is free where the effects are not friction alone.

    Raises
    ------
    Undecided
        Where a sign stays open, or the motion is not the only one: at a corner, and at rest.
    """
    across = Push(push.support, push.length, -push.y, push.x, _left(push))
    way = Way(total, line(push, power), across)
    found = _pivot(way, push)
    if found is not None:
        return found
    if _is_straight(total, push, power):
        t = line(push, power)
        now = response(total, Motion(t, arb(0)))
        return Moved(t, arb(0), now.x * push.x + now.y * push.y)
    s, spin = _through_rest(way) if way.rests else _balanced(way, push, power)
    (x, y), scale = way.motion(s)
    now = response(total, Motion((x, y), spin, scale))
    if now.feet:
        raise Undecided("a centre of rotation next to a foot")
    motion = (x * scale, y * scale) if way.rests else (x, y)
    return Moved(motion, spin * scale, now.x * push.x + now.y * push.y)


def _left(push: Push) -> tuple[arb, arb] | None:
    return None if push.exact is None else (-push.exact[1], push.exact[0])


def _is_straight(total: Resistance, push: Push, power: arb | fmpq) -> bool:
    """Whether the line of force goes through the centre of all that resists, exactly."""
    if not total.load[2].is_zero() or not isinstance(power, fmpq) or not power > 0:
        return False
    if not all(each.is_zero() for each in total.load):
        return False
    (x, y), (p_x, p_y) = total.first, total.pressure
    place = total.weight * p_x + power * x - total.length, total.weight * p_y + power * y
    return push.side(place) == 0


def _pivot(way: Way, push: Push) -> Moved | None:
    """The pivot whose interval of forces holds the direction."""
    for kink in kinks(way):
        stuck = kink.stuck
        part, free = (x * way.toward.x + y * way.toward.y for x, y in (stuck.force, stuck.free))
        if sign(free * free - part * part) > 0:
            force = tuple(f - part / free * e for f, e in zip(stuck.force, stuck.free, strict=True))
            (x, y), _ = way.motion(kink.s)
            size = force[0] * push.x + force[1] * push.y
            return Moved((x, y), stuck.spin, size, kink.foot)
    return None


def _balanced(way: Way, push: Push, power: arb | fmpq) -> tuple[arb, arb]:
    """The place at which the force has no part along the way, and the rotation there."""
    e = push.x.mid(), push.y.mid()
    one = Line(way.total, e, arb(power).mid())
    near = least(one)
    bend = slopes(way.total, one.motion(near))
    rate = -((bend.xs * way.toward.x + bend.ys * way.toward.y) / bend.ss).mid()

    def spin(s: arb) -> arb:
        guess = near.spin + rate * (s - near.s)
        return rotations(way.total, way.motion(s)[0], arb(1), guess)

    def part(s: arb) -> arb:
        now = response(way.total, Motion(way.motion(s)[0], spin(s)))
        if now.feet:
            raise Undecided("a centre of rotation next to a foot")
        return now.x * way.toward.x + now.y * way.toward.y

    s = rising_bounds(part, near.s)
    return s, spin(s)


def _through_rest(way: Way) -> tuple[arb, arb]:
    """The same of a way through rest, where the potential has a kink."""

    def part(s: arb) -> arb:
        x, y = at(way, s).force
        return x * way.toward.x + y * way.toward.y

    s = rising_bounds(part, _root(part, arb(1), width(1)))
    return s, at(way, s).spin


def _root(rising: Callable[[arb], arb], size: arb, wide: arb) -> arb:
    """Root of a function that rises on the whole line; a size of the same order makes it fast."""
    reach = size if size > 0 else arb(1)
    for _ in range(DOUBLINGS):
        if rising(-reach) < 0 and rising(reach) > 0:
            break
        reach = 2 * reach
    else:
        raise Undecided("no motion under this line of force")
    guess = near_root(lambda x: rising(x - reach), arb(0), 2 * reach, wide) - reach
    return rising_bounds(rising, guess)


def under_size(total: Resistance, push: Push, size: arb | fmpq) -> Moved:
    """The motion under a force of a given size along a direction; of size 0 it is the free motion.

    Raises
    ------
    Undecided
        As `under`; with friction alone any motion along one direction has the same force.
    """

    def excess(power: arb) -> arb:
        return under(total, push, power).force - size

    return under(total, push, _root(excess, arb(1), width(2)))
