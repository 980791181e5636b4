"""Sticking with any support, enclosed: the slider's motion whose contact moves in a given direction.

The contact moves along u, so that the centre of rotation is ``c = P + J u / omega``. The torque about the
contact increases with omega and vanishes at one rotation, unless the slider pivots: about a point of the
support that lies across u from the contact, the torque jumps by twice what the point can take.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from flint import arb

from planar_pushing.certified.balls import sign
from planar_pushing.certified.roots import increasing_root
from planar_pushing.certified.supports import collinear
from planar_pushing.certified.supports.pressure.moments import Vector, moments
from planar_pushing.certified.supports.push import Push, ball, decided, is_even


@dataclass(frozen=True, slots=True)
class Stuck:
    """A motion of a contact that moves by one unit along u; unit weight, body frame.

    Attributes
    ----------
    spin : arb
        Rotation.
    force : tuple of arb
        At the contact; of a pivot the middle of what it may be.
    free : tuple of arb
        Of a pivot half of the interval of forces, away from the contact; else zero.
    pivot : int
        Number of the support's point that is the centre, -1 without one.
    """

    spin: arb
    force: Vector
    free: Vector
    pivot: int = -1


NOTHING = arb(0), arb(0)
#: Relative width of a rotation's enclosure.
WIDTH = arb(2) ** -200


def stuck(push: Callable[[], Push]) -> Stuck:
    """The motion of a contact that moves along the direction t of `push`, which has no force here.

    Raises
    ------
    Undecided
        Where a sign stays open at the last precision.
    """
    return decided(_stuck, push)


def _stuck(push: Push) -> Stuck:
    side = push.side(push.support.center)
    if side == 0:
        return Stuck(arb(0), (push.x, push.y), NOTHING)
    for i in range(len(push.support.points)):
        found = _pivot(push, i)
        if found is not None:
            return found
    beyond = collinear.center_beyond(push)
    if beyond is not None:
        return _on_line(push, beyond)
    low, high = _range(push)
    spin = side * increasing_root(lambda s: torque(push, side * s)[0] * side, low, high, WIDTH)
    _, (x, y) = torque(push, spin)
    if is_even(push):
        size = (x * x + y * y).sqrt()
        x, y = size * push.x, size * push.y
    return Stuck(spin, (x, y), NOTHING)


def _on_line(push: Push, c: Vector) -> Stuck:
    """A rotation about a place on the line of the support: the force is across that line."""
    (a, b), (d, e) = collinear.line_ends(push.support) or (push.contact, push.contact)
    x, y = e - b, a - d
    size = push.along((x, y)) * arb(x * x + y * y).sqrt()
    return Stuck(1 / push.arm(c), (x / size, y / size), NOTHING)


def center(push: Push, spin: arb) -> Vector:
    """Centre of rotation of a motion of the contact along t."""
    return -push.length - push.y / spin, push.x / spin


def torque(push: Push, spin: arb) -> tuple[arb, Vector]:
    """Torque about the contact at a rotation other than 0, and the force."""
    c = center(push, spin)
    now, sense = moments(push.support, c), 1 if spin > 0 else -1
    return sense * now.torque(c, push.contact), (-sense * now.y, sense * now.x)


def _range(push: Push) -> tuple[arb, arb]:
    """Rotations between which the torque changes its sign.

    One that takes more than a whole translation is too fast. A slow one is about a centre so far away
    that the torque is that of the translation, less at most the rotation times the square of the size.
    """
    here = moments(push.support, ball(push.contact)).distance
    x, y = ball(push.support.center)
    arm, size = abs(push.arm((x, y))), push.support.extent + abs(x + push.length) + abs(y)
    return (arm / (4 * size * size)).lower(), (2 / here).upper()


def _pivot(push: Push, i: int) -> Stuck | None:
    point = push.support.points[i]
    x, y = point.place[0] + push.length, point.place[1]
    if (not x and not y) or push.along((x, y)):
        return None
    c, sense = ball(point.place), push.side(point.place)
    rest, reach = moments(push.support, c), arb(x * x + y * y).sqrt()
    part = -sense * rest.torque(c, push.contact) / reach
    if sign(part * part - point.share**2) >= 0:
        return None
    f_x, f_y = -sense * rest.y - part * y / reach, sense * rest.x + part * x / reach
    free = (arb(point.share) ** 2 - part * part).sqrt() / reach
    return Stuck(sense / reach, (f_x, f_y), (free * x, free * y), i)
