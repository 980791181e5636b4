"""Edges of the motion cone of a slider with friction on any support, enclosed."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

from flint import arb, fmpq

from planar_pushing.certified.balls import in_degrees, precise, rational
from planar_pushing.certified.contact.modes import Law
from planar_pushing.certified.effects.modes import edge as edge_of
from planar_pushing.certified.effects.under import Moved, about, is_straight, under
from planar_pushing.certified.potential import collinear
from planar_pushing.certified.potential.direction import degrees, relative
from planar_pushing.certified.potential.precision import FINE, decided
from planar_pushing.certified.potential.push import Push
from planar_pushing.certified.potential.resistance import Friction, Resistance, Scene, resistance
from planar_pushing.certified.potential.sticking import is_across
from planar_pushing.certified.supports.pressure.pieces import Pieces, Place

ONE = fmpq(1)


class Edge(NamedTuple):
    """The motion at an edge of a friction cone; angles in degrees.

    Attributes
    ----------
    force_angle : arb
    low, high : arb
        Range of the angles of the contact's motion; the two are equal except at a corner.
    moved : Moved
        For unit weight and ``e . u = 1``.
    """

    force_angle: arb
    low: arb
    high: arb
    moved: Moved

    @property
    def angle(self) -> arb:
        """Angle of the contact's motion; at a corner, the middle of the range."""
        return self.low if self.low is self.high else (self.low + self.high) / 2


@lru_cache(maxsize=1 << 15)
@precise
def edge(support: Pieces, length: fmpq, angle: fmpq, friction: float, side: int) -> Edge:
    """Motion at an edge, 1 for the right and -1 for the left one, for a rod at an angle in degrees."""

    def found() -> tuple[Moved, tuple[arb, arb]]:
        total, push = pushed(support, length, angle, friction, side)
        moved = under(total, push, ONE)
        return moved, _turns(total, push, moved)

    # Under infinite friction exactly along the fence.
    half = arb(90) if math.isinf(friction) else in_degrees(arb(rational(friction)).atan())
    force, (moved, turns) = 90 - side * half, decided(found, FINE)
    if moved.pivot >= 0 and not support.points[moved.pivot].place[1]:
        reach = support.points[moved.pivot].place[0] + length
        exact = _across_rod(reach * (1 if moved.spin > 0 else -1), angle, force)
        return Edge(force, exact, exact, moved)
    low, high = (force + turn for turn in turns)
    return Edge(force, low, low if turns[0] is turns[1] else high, moved)


def pivot_load(
    support: Pieces, length: fmpq, angle: fmpq, friction: float, side: int, foot: int
) -> arb | None:
    """Squared load of a foot, relative to its share, as a pivot under the force of an edge.

    None if the line of force passes through the foot.
    """
    found = about(*pushed(support, length, angle, friction, side), ONE, foot)
    return None if found is None else found.own / support.points[foot].share ** 2


def pushed(
    support: Pieces, length: fmpq, angle: fmpq, friction: float, side: int
) -> tuple[Resistance, Push]:
    """Friction for unit weight, and the line of force of an edge."""
    scene = Scene(length, degrees(angle), (Friction(support, ONE),))
    total = resistance(scene)
    return total, total.push(relative(edge_of(Law(friction), side), scene.rod))


def _turns(total: Resistance, push: Push, moved: Moved) -> tuple[arb, arb]:
    """Minimum and maximum angle from the force to the contact's motion; they differ only at a corner.

    A contact on the line of a support moves along a force that acts across that line through the center
    of pressure, whatever the rotation.
    """
    if is_straight(total, push, ONE):
        ends = collinear.crossed(push)
        if ends is None or push.side(ends[0]) == 0:
            return (arb(0),) * 2
        turns = [_turn(push, end) for end in ends]
        return arb.min(*turns), arb.max(*turns)
    if is_across(push) and total.is_even():  # by symmetry
        return (arb(0),) * 2
    x, y = moved.motion
    across = (push.x * y - push.y * x) / (push.x * x + push.y * y)
    return (in_degrees(across.atan()),) * 2


def _turn(push: Push, center: Place) -> arb:
    """Angle from the force to the contact's motion in a rotation about a center, within 90 degrees."""
    place = arb(center[0]), arb(center[1])
    return in_degrees((-push.reach(place) / push.arm(place)).atan())


def _across_rod(reach: fmpq, angle: fmpq, force: arb) -> arb:
    """Angle of a motion about a point on the rod's line, within 90 degrees of the force; exact.

    The reach is negative if the slider rotates clockwise.
    """
    degrees = angle - (90 if reach > 0 else -90)
    return arb(degrees + 360 * round(float(force - degrees) / 360))
