"""Motion of a slider with any support under a line of force through the contact, enclosed.

In the body frame the contact is P = (-l, 0). A line of force of direction t turns the slider about the
centre c at which the friction has no part across t and no torque about the contact::

    G(c) . t = 0,    D(c) + (c - P) . G(c) = 0

The potential is convex, so that there is one such motion. It is found otherwise where a line of force
through the centre of pressure translates the slider; where a point of the support is a pivot, because it
would have to take less than its share; and on a support's own line. Where a force leaves an interval of
motions its ends are the turns of `Moved`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from flint import arb

from planar_pushing.certified.balls import in_degrees, sign
from planar_pushing.certified.supports import collinear
from planar_pushing.certified.supports.newton import enclosed
from planar_pushing.certified.supports.pivots import pivot
from planar_pushing.certified.supports.pressure.moments import Vector, moments
from planar_pushing.certified.supports.push import Push, ball, decided, is_even


@dataclass(frozen=True, slots=True)
class Moved:
    """A motion under a line of force, for unit weight.

    Attributes
    ----------
    turns : tuple of arb
        Least and greatest angle from the force to the contact's motion, degrees; the same but at a corner.
    force : arb
        Size of the force.
    center : tuple of arb, optional
        Of rotation, in the body frame; None of a translation.
    sense : int
        Sign of the rotation.
    pivot : int
        Number of the support's point that is the centre, -1 without one.
    """

    turns: tuple[arb, arb]
    force: arb
    center: Vector | None = None
    sense: int = 0
    pivot: int = -1

    def spin_ratio(self, radius: arb) -> arb:
        """R omega / v at the slider's centre, infinite where that is the centre of rotation."""
        if self.center is None:
            return arb(0)
        x, y = self.center
        if x.is_zero() and y.is_zero():
            return self.sense * arb.pos_inf()
        return self.sense * radius / (x * x + y * y).sqrt()


def moved(push: Callable[[], Push]) -> Moved:
    """The motion under a line of force, which is made anew for each precision.

    Raises
    ------
    Undecided
        Where a sign stays open at the last precision.
    """
    return decided(_moved, push)


def _moved(push: Push) -> Moved:
    if push.side(push.support.center) == 0:
        return Moved(_open_turns(push), arb(1))
    found = pivot(push)
    if found is not None:
        i, rotation = found
        c = ball(push.support.points[i].place)
        size = rotation.force[0] * push.x + rotation.force[1] * push.y
        return Moved((_turn(push, c),) * 2, size, c, rotation.sense, i)
    return _about(push, _center(push))


def _open_turns(push: Push) -> tuple[arb, arb]:
    """Turns of a line of force through the centre of pressure: none, but at a corner.

    A contact on the line of the support moves along the force, whatever the rotation.
    """
    ends = collinear.crossed(push)
    if ends is None or push.side(ends[0]) == 0:
        return arb(0), arb(0)
    turns = [_turn(push, ball(end)) for end in ends]
    return arb.min(*turns), arb.max(*turns)


def _turn(push: Push, c: Vector) -> arb:
    """Angle from the force to the contact's motion about a centre, within 90 degrees."""
    return in_degrees((-push.reach(c) / push.arm(c)).atan())


def _about(push: Push, c: Vector) -> Moved:
    now = moments(push.support, c)
    size = (now.x * now.x + now.y * now.y).sqrt()
    turn = arb(0) if is_even(push) else _turn(push, c)
    return Moved((turn, turn), size, c, sign(push.arm(c)))


def _center(push: Push) -> Vector:
    """Centre of rotation off the support's points."""
    ends = collinear.crossed(push)
    if ends is not None:
        return collinear.center_between(push, ends)
    rings = push.support.rings
    if len(rings) == 1 and rings[0].share == 1 and push.touches(rings[0].center, rings[0].radius):
        return _on_rim(push)
    return enclosed(push.support, push.length, (push.x, push.y))


def _on_rim(push: Push) -> Vector:
    """A line of force that touches a ring turns it about the opposite point: H(1) = 1."""
    ring = push.support.rings[0]
    x, y = ball(ring.center)
    reach = ring.radius * push.side(ring.center)
    return x - reach * push.y, y + reach * push.x
