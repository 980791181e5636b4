"""Sticking along a path of contact motions ``start + s toward``: forces at a place and over an interval.

A path through rest is divided there: friction has one limit on each side and is evaluated at the unit
motion. Where the slider pivots about a foot the force jumps; there, too, it has a limit on each side.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from flint import arb, fmpq

from planar_pushing.certified.balls import Undecided
from planar_pushing.certified.potential.gradient import (
    Motion,
    Response,
    center,
    response,
    slopes,
)
from planar_pushing.certified.potential.push import Push
from planar_pushing.certified.potential.resistance import Resistance
from planar_pushing.certified.potential.sticking import (
    Stuck,
    bounds,
    pivot,
    rising_bounds,
    rotation,
    rotations,
)
from planar_pushing.certified.supports.pressure.moments import Vector

#: First bound on the deviation of the rotation from its secant over a cell, as a fraction of its change.
WIDE = 64


class Way(NamedTuple):
    """Contact motions on a straight line, in the body frame.

    Attributes
    ----------
    total : Resistance
    start : tuple of arb
        Exactly zero if the path passes through rest.
    toward : Push
        Direction of the path.
    """

    total: Resistance
    start: Vector
    toward: Push

    @property
    def rests(self) -> bool:
        """Whether friction has a kink at s = 0, where the contact is at rest."""
        still = self.start[0].is_zero() and self.start[1].is_zero()
        return still and self.total.weight != 0

    def motion(self, s: arb) -> tuple[Vector, arb]:
        """The contact's motion and its scale; on a path through rest, the unit motion on one side."""
        (x, y), (t_x, t_y) = self.start, (self.toward.x, self.toward.y)
        if not self.rests:
            return (x + s * t_x, y + s * t_y), arb(1)
        side = 1 if s > 0 or s.lower() == 0 else -1
        return (side * t_x, side * t_y), abs(s)


class Place(NamedTuple):
    """A place of a path: the rotation per unit scale, the force, and the foot that is the pivot, if any.

    At a pivot the force is the limit from the interval that the place ends.
    """

    s: arb
    spin: arb
    force: Vector
    foot: int = -1


class Kink(NamedTuple):
    """A place at which the slider pivots about a foot, and the interval of forces."""

    s: arb
    foot: int
    stuck: Stuck

    def toward(self, way: Way, side: int) -> Place:
        """The end of the interval of forces toward larger s (1) or smaller s (-1)."""
        part = side * way.toward.along(way.total.foot(self.foot))
        (x, y), (e_x, e_y) = self.stuck.force, self.stuck.free
        return Place(self.s, self.stuck.spin, (x + part * e_x, y + part * e_y), self.foot)


def at(way: Way, s: arb, side: int = 0) -> Place:
    """The place at an s off the kinks; at rest, its limit from a side."""
    (x, y), scale = way.motion(s if s != 0 or not side else arb(side))
    scale = abs(s) if way.rests else scale
    spin = rotation(way.total, (x, y), scale)
    now = response(way.total, Motion((x, y), spin, scale))
    if now.feet:
        raise Undecided("a center of rotation next to a foot")
    return Place(s, spin, (now.x, now.y))


def kinks(way: Way) -> Iterator[Kink]:
    """Every place except rest at which the slider pivots about a foot.

    Raises
    ------
    Undecided
        If the load of a foot as the pivot is too close to its share to decide whether it slides.
    """
    for i in range(len(way.total.support.points)):
        x, y = way.total.foot(i)
        if way.rests or not (x or y) or way.toward.along((x, y)) == 0:
            continue
        s = -(x * way.start[0] + y * way.start[1]) / (x * way.toward.x + y * way.toward.y)
        (u_x, u_y), scale = way.motion(s)
        spin = (y * u_x - x * u_y) / (x * x + y * y)
        if spin.contains(0):
            continue  # the contact is at rest there
        found = pivot(way.total, (u_x, u_y), scale, i, spin)
        if found is not None:
            yield Kink(s, i, found)


class Cell(NamedTuple):
    """An interval of a path between two places; kinks lie only at its ends."""

    low: Place
    high: Place

    @property
    def s(self) -> arb:
        """The whole interval as a ball."""
        return self.low.s.union(self.high.s)


class Range(NamedTuple):
    """Balls over a cell: contact motion, scale, rotation, and force."""

    motion: Motion
    force: Vector


def over(way: Way, cell: Cell) -> Range:
    """Enclose the forces over a cell.

    Raises
    ------
    Undecided
        If the cell is too large.
    """
    motion = _motion(way, cell)
    now = response(way.total, motion)
    return Range(motion, _with_feet(way, cell, now))


def _motion(way: Way, cell: Cell) -> Motion:
    """The motions over a cell."""
    middle = ((cell.low.s + cell.high.s) / 2).mid()
    _, scale = way.motion(cell.s)
    if way.rests:
        guess = Motion(way.motion(middle)[0], cell.low.spin.union(cell.high.spin), scale)
        return guess._replace(spin=rotations(way.total, guess))
    tube = _Tube(way, cell, middle)
    wide = abs(cell.high.spin - cell.low.spin) / WIDE + cell.low.spin.rad() + cell.high.spin.rad()
    off = rising_bounds(lambda off: bounds(way.total, tube.motion(off)), arb(0, wide.upper()))
    return tube.motion(off)


class _Tube(NamedTuple):
    """Motions near the secant of a cell: the rotation deviates from a linear function of s."""

    way: Way
    cell: Cell
    middle: arb

    def motion(self, off: arb) -> Motion:
        """The motions for a deviation of the rotation from the secant; centers by first derivatives."""
        (low, high), (d_x, d_y) = self.cell, (self.way.toward.x, self.way.toward.y)
        (x, y), scale = self.way.motion(self.cell.s)
        run, rate = self.cell.s - self.middle, ((high.spin - low.spin) / (high.s - low.s)).mid()
        own = (low.spin + rate * (self.middle - low.s)).mid() + off
        spin = own + rate * run
        if spin.contains(0):
            return Motion((x, y), spin, scale)
        start = center(self.way.total, Motion(self.way.motion(self.middle)[0], own))
        about = (
            start[0] + run * (y * rate - d_y * spin) / spin**2,
            start[1] + run * (d_x * spin - x * rate) / spin**2,
        )
        return Motion((x, y), spin, scale, about)


def _with_feet(way: Way, cell: Cell, now: Response) -> Vector:
    """The force, including that of the feet that can be at the center of rotation."""
    for side, end in ((1, cell.low), (-1, cell.high)):
        if now.feet == (end.foot,):
            return _next_to_pivot(way, now, side)
    x, y = now.x, now.y
    for i in now.feet:
        most = arb(way.total.weight * way.total.support.points[i].share)
        x, y = x + arb(0, most), y + arb(0, most)
    return x, y


def _next_to_pivot(way: Way, now: Response, side: int) -> Vector:
    """The force near a pivot, where its foot slides slowly.

    The friction of the foot balances the remaining torque about the contact, which determines its
    component across the line to the contact; along this line the foot moves as the contact does.
    """
    (i,), total = now.feet, way.total
    (x, y), share = total.foot(i), arb(total.weight * total.support.points[i].share)
    reach = arb(x * x + y * y).sqrt()
    part = -now.torque / reach
    rest = arb.max(share * share - part * part, arb(0)).sqrt()
    along = side * way.toward.along((x, y)) * rest
    return now.x + (along * x - part * y) / reach, now.y + (along * y + part * x) / reach


def rise(way: Way, motion: Motion) -> Vector:
    """Derivative of the force along the path over a motion's balls, times the scale."""
    xx, xy, yy = slopes(way.total, motion).felt()
    x, y = way.toward.x, way.toward.y
    return xx * x + xy * y, xy * x + yy * y


def line(push: Push, part: arb | fmpq) -> Vector:
    """A multiple of the unit vector of a push."""
    if isinstance(part, fmpq) and not part:
        return arb(0), arb(0)
    return push.x * part, push.y * part
