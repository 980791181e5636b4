"""The rotation without torque about the contact, and the force: sticking with any effects.

At a given motion of the contact the torque increases with the rotation, so that a change of its sign
proves that there is one root. At a foot that lies across the motion from the contact the torque jumps
by twice the foot's share times its distance; the slider pivots about the foot if the remaining torque
is smaller than the jump allows.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from flint import arb, ctx, fmpq

from planar_pushing.certified.balls import Undecided, sign
from planar_pushing.certified.potential import collinear
from planar_pushing.certified.potential.gradient import Motion, response
from planar_pushing.certified.potential.push import Push
from planar_pushing.certified.potential.resistance import Resistance
from planar_pushing.certified.supports.pressure.moments import Vector
from planar_pushing.certified.supports.pressure.pieces import Place

NOTHING = arb(0), arb(0)
#: Doublings of a rotation whose torque is too small.
DOUBLINGS = 400
#: Maximum number of steps to a guess; bisection alone needs fewer.
STEPS = 500
#: Steps outward to the bounds of a root over balls; each of the first is twice as long as the one before.
BROADENINGS = 40


@dataclass(frozen=True, slots=True)
class Stuck:
    """A motion with a given motion of the contact, in the body frame.

    Attributes
    ----------
    spin : arb
        Rotation.
    force : tuple of arb
        Force at the contact; for a pivot, the middle of the interval of forces.
    free : tuple of arb
        For a pivot, half of the interval of forces, directed away from the contact; otherwise zero.
    pivot : int
        Index of the support's point that is the center of rotation, -1 if there is none.
    straight : bool
        Whether the force is along the contact's motion, exactly.
    """

    spin: arb
    force: Vector
    free: Vector = NOTHING
    pivot: int = -1
    straight: bool = False


def width(level: int = 0) -> arb:
    """Relative width of a root's enclosure; wider by levels, as each treats the one below as rounding."""
    return arb(2) ** (-(5 - level) * ctx.prec // 8)


def stick(total: Resistance, push: Push, size: fmpq | arb) -> Stuck:
    """The motion of a slider whose contact moves by `size` along the direction of `push`.

    Parameters
    ----------
    total : Resistance
    push : Push
        The direction of the motion, from `total.push`.
    size : fmpq or arb
        Magnitude of the motion; 0 is the limit of small motions.

    Raises
    ------
    Undecided
        If a sign remains undecided, or a load rotates the slider against any friction.
    """
    size = arb(size)
    for i in range(len(total.support.points)):
        found = _pivot(total, push, size, i)
        if found is not None:
            return _made_even(total, push, found)
    if _is_straight(total, push, size):
        x, y, _, _ = response(total, Motion((push.x, push.y), arb(0), size))
        return Stuck(arb(0), (x, y), straight=all(each.is_zero() for each in total.load))
    beyond = _beyond(total, push)
    if beyond is not None:
        return beyond
    spin = rotation(total, (push.x, push.y), size)
    x, y, _, feet = response(total, Motion((push.x, push.y), spin, size))
    if feet:
        raise Undecided("a center of rotation next to a foot")
    return _made_even(total, push, Stuck(spin * size, (x, y)))


def _made_even(total: Resistance, push: Push, found: Stuck) -> Stuck:
    """A sticking motion whose force is exactly along the motion, by symmetry."""
    if not is_across(push) or not total.is_even():
        return found
    part = found.force[0] * push.x + found.force[1] * push.y
    force = part * push.x, part * push.y
    return Stuck(found.spin, force, found.free, found.pivot, straight=sign(part) > 0)


def is_across(push: Push) -> bool:
    """Whether a direction is exactly across the rod."""
    return push.along((fmpq(1), fmpq(0))) == 0


def _is_straight(total: Resistance, push: Push, size: arb) -> bool:
    """Whether a translation has exactly no torque."""
    if not total.load[2].is_zero() or not size.is_exact():
        return False
    scale, (x, y), (p_x, p_y) = size.fmpq(), total.first, total.pressure
    p_x, p_y = total.weight * p_x + scale * x, total.weight * p_y + scale * y
    return push.side((p_x - total.length, p_y)) == 0


def _beyond(total: Resistance, push: Push) -> Stuck | None:
    """A rotation about a point on the line of the support, beyond its ends; the force is across it."""
    if total.mass != 0 or not total.load[2].is_zero():
        return None
    c = collinear.center_beyond(push)
    if c is None:
        return None
    (a, b), (d, e) = collinear.line_ends(push.support) or (push.contact, push.contact)
    x, y = e - b, a - d
    part = total.weight / (push.along((x, y)) * arb(x * x + y * y).sqrt())
    return Stuck(1 / push.arm(c), (part * x - total.load[0], part * y - total.load[1]))


def rotation(total: Resistance, t: Vector, scale: arb) -> arb:
    """Rotation without torque, per unit scale, for a contact motion that is exact or a ball.

    Raises
    ------
    Undecided
        If the friction of a foot does not determine it, or a load rotates the slider against any friction.
    """
    middle = _rotation(total, (t[0].mid(), t[1].mid()), scale.mid())
    return rotations(total, Motion(t, middle, scale))


def _rotation(total: Resistance, t: Vector, scale: arb) -> arb:
    """A guess of the rotation."""

    def torque(spin: arb) -> arb:
        return bounds(total, Motion(t, spin, scale))

    start = torque(arb(0))
    if start.contains(0):
        return arb(0, width())
    side = 1 if start < 0 else -1
    high = arb(1)
    for _ in range(DOUBLINGS):
        if side * torque(side * high) > 0:
            return side * near_root(lambda s: side * torque(side * s), arb(0), high, width())
        high = 2 * high
    raise Undecided("a load rotates the slider against any friction")


def near_root(rising: Callable[[arb], arb], low: arb, high: arb, wide: arb) -> arb:
    """A guess of the root of an increasing function between places of opposite sign, by Illinois steps."""
    below, above, side = rising(low), rising(high), 0
    for step in range(STEPS):
        guess = (
            (low + high) / 2 if step % 5 == 4 else (low * above - high * below) / (above - below)
        )
        margin = (wide * abs(guess)).mid()
        if high - low <= 2 * margin:
            break
        point = arb.max(low + margin, arb.min(high - margin, guess.mid())).mid()
        value = rising(point)
        if value.contains(0):
            return point + arb(0, margin)
        if value < 0:
            low, below, above, side = point, value.mid(), above / (2 if side < 0 else 1), -1
        else:
            high, above, below, side = point, value.mid(), below / (2 if side > 0 else 1), 1
    return low.union(high)


def bounds(total: Resistance, motion: Motion) -> arb:
    """Bounds of the torque about the contact, with any friction of the feet near the center of rotation."""
    now = response(total, motion)
    return now.torque + sum((_most(total, i) for i in now.feet), arb(0))


def _most(total: Resistance, i: int) -> arb:
    (x, y), share = total.foot(i), total.weight * total.support.points[i].share
    return arb(0, (share * arb(x * x + y * y).sqrt()).upper())


def rotations(total: Resistance, guess: Motion) -> arb:
    """Bounds of the rotation over balls of contact motions, starting from a guess."""
    return rising_bounds(lambda spin: bounds(total, guess._replace(spin=spin)), guess.spin)


def rising_bounds(rising: Callable[[arb], arb], guess: arb) -> arb:
    """Bounds of the root of an increasing function that is known as balls, starting from a guess."""
    step = (guess.rad() / 4 + abs(guess).upper() * arb(2) ** (8 - ctx.prec)).mid()
    below = _outward(lambda x: -rising(x), guess.lower(), -step)
    return below.union(_outward(rising, guess.upper(), step))


def _outward(excess: Callable[[arb], arb], start: arb, step: arb) -> arb:
    """A place at which the excess is positive."""
    at = start
    for i in range(BROADENINGS):
        if excess(at) > 0:
            return at
        at, step = (at + step).mid(), step * 2 ** (1 + i // 4)
    raise Undecided("no bounds of a root")


def _pivot(total: Resistance, push: Push, size: arb, i: int) -> Stuck | None:
    place = total.foot(i)
    if not any(place) or push.along(place) != 0:
        return None
    sense = push.side(total.support.points[i].place)
    return pivot(total, (push.x, push.y), size, i, sense / _distance(place))


def _distance(place: Place) -> arb:
    return arb(place[0] ** 2 + place[1] ** 2).sqrt()


def pivot(total: Resistance, t: Vector, scale: arb, i: int, spin: arb) -> Stuck | None:
    """The rotation about a foot across the motion t of the contact; None if the foot slides."""
    (x, y), share = total.foot(i), total.weight * total.support.points[i].share
    reach, rest = _distance((x, y)), response(total, Motion(t, spin, scale), i)
    part = -rest.torque / reach
    if sign(share * share - part * part) <= 0:
        return None
    force = rest.x - part * y / reach, rest.y + part * x / reach
    free = (share * share - part * part).sqrt() / reach
    return Stuck(spin * scale, force, (free * x, free * y), i)
