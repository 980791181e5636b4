"""The motion under a force along a direction, with any effects.

Among the contact motions ``p e + s n``, with n to the left of the direction e, the component of the
force along n vanishes for exactly one: by convexity the component increases with s, and it jumps where
the slider pivots about a foot. Newton's method finds the motion, and the signs of the component on both
sides prove it.
"""

from __future__ import annotations

from dataclasses import dataclass

from flint import arb, ctx, fmpq

from planar_pushing.certified.balls import Undecided, sign
from planar_pushing.certified.effects.way import Way, at, line
from planar_pushing.certified.potential.gradient import Motion, response, slopes
from planar_pushing.certified.potential.newton import Line, least
from planar_pushing.certified.potential.push import Push
from planar_pushing.certified.potential.resistance import Resistance
from planar_pushing.certified.potential.sticking import near_root, rising_bounds, rotations, width
from planar_pushing.certified.supports.pressure.moments import Vector

ZERO = arb(0)
#: Maximum number of doublings of a bracket.
DOUBLINGS = 200


@dataclass(frozen=True, slots=True)
class Moved:
    """A motion under a line of force, in the body frame.

    Attributes
    ----------
    motion : tuple of arb
        Motion of the contact.
    spin : arb
        Rotation.
    force : arb
        Component along the direction; the other component is zero.
    pivot : int
        Index of the support's point that is the center of rotation, -1 if there is none.
    own : arb
        For a pivot, the squared force that the point carries.
    """

    motion: Vector
    spin: arb
    force: arb
    pivot: int = -1
    own: arb = ZERO

    @property
    def turn(self) -> arb:
        """Rotation per unit motion of the contact."""
        x, y = self.motion
        return self.spin / (x * x + y * y).sqrt()


def under(total: Resistance, push: Push, power: arb | fmpq) -> Moved:
    """The motion under a force along a direction e with a given ``e . u``, where u is the contact's motion.

    Parameters
    ----------
    total : Resistance
    push : Push
        The direction e, from `total.push`.
    power : arb or fmpq
        ``e . u``; its sign is free unless friction is the only effect.

    Raises
    ------
    Undecided
        If a sign remains undecided, or the motion is not unique: at a corner, and at rest.
    """
    if is_straight(total, push, power):
        t = line(push, power)
        now = response(total, Motion(t, arb(0)))
        return Moved(t, arb(0), now.x * push.x + now.y * push.y)
    way = Way(total, line(push, power), Push(push.support, push.length, -push.y, push.x))
    for foot in range(0 if way.rests else len(total.support.points)):
        found = about(total, push, power, foot)
        share = total.weight * total.support.points[foot].share
        if found is not None and sign(found.own - share * share) < 0:
            return found
    s, spin = _through_rest(way) if way.rests else _balanced(way, push, power)
    t, scale = way.motion(s)
    now = response(total, Motion(t, spin, scale))
    if now.feet:
        raise Undecided("a center of rotation next to a foot")
    motion = (t[0] * scale, t[1] * scale) if way.rests else t
    return Moved(motion, spin * scale, now.x * push.x + now.y * push.y)


def is_straight(total: Resistance, push: Push, power: arb | fmpq) -> bool:
    """Whether the line of force passes exactly through the common center of all effects."""
    if not all(each.is_zero() for each in total.load):
        return False
    if not isinstance(power, fmpq) or not power > 0:
        return False
    (x, y), (p_x, p_y) = total.first, total.pressure
    place = total.weight * p_x + power * x, total.weight * p_y + power * y
    return push.side((place[0] - total.length, place[1])) == 0


def about(total: Resistance, push: Push, power: arb | fmpq, foot: int) -> Moved | None:
    """The rotation about a foot under a line of force, whatever the share of the foot.

    The other effects require the force f and the torque T about the contact. With the foot at r from the
    contact, its force ``h = (T e - r (e x f)) / (e x r)`` makes f + h parallel to e, without torque.

    Returns
    -------
    Moved or None
        None if the line of force passes through the foot.
    """
    if push.side(total.support.points[foot].place) == 0:
        return None
    (e_x, e_y), (x, y) = (push.x, push.y), total.foot(foot)
    arm = e_x * y - e_y * x
    spin = power / arm
    t = spin * y, -spin * x
    rest = response(total, Motion(t, spin), foot)
    across = e_x * rest.y - e_y * rest.x
    h_x, h_y = ((rest.torque * e - r * across) / arm for e, r in ((e_x, x), (e_y, y)))
    force = (rest.x + h_x) * e_x + (rest.y + h_y) * e_y
    return Moved(t, spin, force, foot, h_x * h_x + h_y * h_y)


def _balanced(way: Way, push: Push, power: arb | fmpq) -> tuple[arb, arb]:
    """The place at which the force has no component along the path, and the rotation there."""
    one = Line(way.total, (push.x.mid(), push.y.mid()), arb(power).mid())
    try:
        near = least(one)
        bend = slopes(way.total, one.motion(near))
        rate = -((bend.xs * way.toward.x + bend.ys * way.toward.y) / bend.ss).mid()
        if not rate.is_finite():
            raise Undecided("no slope")
    except Undecided:  # on a rim, or on a line of the support
        return _through_rest(way)

    def spin(s: arb) -> arb:
        guess = near.spin + rate * (s - near.s)
        return rotations(way.total, Motion(way.motion(s)[0], guess))

    def part(s: arb) -> arb:
        now = response(way.total, Motion(way.motion(s)[0], spin(s)))
        if now.feet:
            raise Undecided("a center of rotation next to a foot")
        return now.x * way.toward.x + now.y * way.toward.y

    # By symmetry the place can be exactly zero.
    wide = (abs(near.s) + abs(one.power)) * arb(2) ** (8 - ctx.prec)
    s = rising_bounds(part, near.s + arb(0, wide.mid()))
    return s, spin(s)


def _through_rest(way: Way) -> tuple[arb, arb]:
    """The balanced place without slopes, on a path through rest, where the potential has a kink."""

    def part(way: Way, s: arb) -> arb:
        x, y = at(way, s).force
        return x * way.toward.x + y * way.toward.y

    start = way.start[0].mid(), way.start[1].mid()
    middle = way._replace(start=start)
    reach = arb.max(abs(start[0]), abs(start[1])).mid()
    reach = reach if reach > 0 else arb(1)
    for _ in range(DOUBLINGS):
        if part(middle, -reach) < 0 and part(middle, reach) > 0:
            break
        reach = 2 * reach
    else:
        raise Undecided("no motion under this line of force")
    near = near_root(lambda x: part(middle, x - reach), arb(0), 2 * reach, width(1)) - reach
    s = rising_bounds(lambda s: part(way, s), near)
    return s, at(way, s).spin
