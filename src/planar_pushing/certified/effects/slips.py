"""Every slip along a path of contact motions: places with the force on an edge of the friction cone.

The path is bisected until balls show for each cell that the force is off the edge, or that its
component across the edge is monotone; in the second case the signs at the ends decide whether there is
a slip.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from flint import arb, ctx

from planar_pushing.certified.balls import Exhausted, Undecided, sign
from planar_pushing.certified.effects.way import Cell, Kink, Place, Way, at, kinks, over, rise
from planar_pushing.certified.potential.gradient import Motion, response
from planar_pushing.certified.potential.sticking import near_root, rising_bounds, rotation, width
from planar_pushing.certified.supports.pressure.moments import Vector

#: Maximum number of cells of the bisection.
BUDGET = 1000
#: Doublings of the path until the force points away from the edge for good.
DOUBLINGS = 200


@dataclass(frozen=True, slots=True)
class Slip:
    """A slip, in the body frame.

    Attributes
    ----------
    s : arb
        Place on the path.
    motion : tuple of arb
        Motion of the contact.
    spin : arb
        Rotation.
    force : tuple of arb
    pivot : int
        Index of the support's point that is the center of rotation, -1 if there is none.
    """

    s: arb
    motion: Vector
    spin: arb
    force: Vector
    pivot: int = -1


def slips(way: Way, edge: Vector, stick: arb, side: int, *, budget: int = BUDGET) -> list[Slip]:
    """Slips beyond sticking, nearest first.

    Parameters
    ----------
    way : Way
        Contact motions with the pusher's normal component; its direction is along the fence.
    edge : tuple of arb
        Unit vector of the edge, body frame.
    stick : arb
        Place of the pusher's motion.
    side : int
        1 for slips toward larger s, -1 toward smaller s.
    budget : int, optional
        Maximum number of cells of the bisection.

    Raises
    ------
    Undecided
        If the budget does not suffice: near a slip in which two slips merge, or near sticking.
    """
    search = _Search(way, edge, side, budget)
    every = [each for each in kinks(way) if not each.s.overlaps(stick)]
    kinked = [each for each in kinks(way) if each.s.overlaps(stick)]
    first = kinked[0].toward(way, side) if kinked else at(way, stick, side)
    if search.ahead(first.force) > 0:
        return []
    last = search.end(stick)
    inside = [each for each in every if _between(each.s, stick, last.s, side)]
    inside.sort(key=lambda each: side * float(each.s))
    found = list(search.between(first, inside, last))
    return sorted(found, key=lambda each: side * float(each.s))


def _between(s: arb, low: arb, high: arb, side: int) -> bool:
    return sign(side * (s - low)) > 0 > sign(side * (s - high))


@dataclass(slots=True)
class _Search:
    """The edge, the side, and the remaining number of cells."""

    way: Way
    edge: Vector
    side: int
    budget: int

    def across(self, force: Vector) -> arb:
        """Component of a force across the edge."""
        return self.edge[0] * force[1] - self.edge[1] * force[0]

    def along(self, force: Vector) -> arb:
        """Component of a force along the edge."""
        return self.edge[0] * force[0] + self.edge[1] * force[1]

    def ahead(self, force: Vector) -> arb:
        """Component of a force along the fence, toward the slips; it increases along the path."""
        return self.side * (self.way.toward.x * force[0] + self.way.toward.y * force[1])

    def end(self, stick: arb) -> Place:
        """A place beyond which the force points to the side of the slips; the force on an edge does not."""
        speed = self.way.start[0] ** 2 + self.way.start[1] ** 2
        step = arb.max(speed.sqrt(), abs(stick)).mid()
        step = step if step > 0 else arb(1)
        for _ in range(DOUBLINGS):
            # Not at a multiple of the start: a foot can be exactly across from it.
            s = (stick + self.side * step * arb("1.0371")).mid()
            try:
                found = at(self.way, s, self.side)
                if self.ahead(found.force) > 0:
                    return found
            except Undecided:
                pass
            step = 2 * step
        raise Undecided("the force never points to the side of the slips")

    def between(self, first: Place, inside: list[Kink], last: Place) -> Iterator[Slip]:
        """Slips between two places, with the kinks and rest between them."""
        start = first
        for kink in inside:
            yield from self._over(start, kink.toward(self.way, -self.side))
            yield from self._at_kink(kink)
            start = kink.toward(self.way, self.side)
        if self.way.rests and sign(start.s) * sign(last.s) < 0:
            yield from self._over(start, at(self.way, arb(0), -self.side))
            start = at(self.way, arb(0), self.side)
        yield from self._over(start, last)

    def _at_kink(self, kink: Kink) -> Iterator[Slip]:
        stuck = kink.stuck
        part, free = self.across(stuck.force), self.across(stuck.free)
        if sign(free * free - part * part) < 0:
            return
        force = tuple(f - part / free * e for f, e in zip(stuck.force, stuck.free, strict=True))
        if sign(self.along((force[0], force[1]))) > 0:
            motion, _ = self.way.motion(kink.s)
            yield Slip(kink.s, motion, stuck.spin, (force[0], force[1]), kink.foot)

    def _over(self, start: Place, end: Place) -> Iterator[Slip]:
        cells = [Cell(start, end) if self.side > 0 else Cell(end, start)]
        while cells:
            cell = cells.pop()
            self.budget -= 1
            if self.budget < 0:
                raise Exhausted("slips are undecided: the bisection does not end")
            verdict = self._verdict(cell)
            if verdict is None:
                cells += self._halves(cell)
            elif verdict:
                yield from self._slip(cell, verdict)

    def _halves(self, cell: Cell) -> list[Cell]:
        middle = at(self.way, ((cell.low.s + cell.high.s) / 2).mid())
        return [Cell(cell.low, middle), Cell(middle, cell.high)]

    def _verdict(self, cell: Cell) -> int | None:
        """0 without a slip, the sign of the slope if there is one, None if it is undecided."""
        try:
            motion, force = over(self.way, cell)
        except Undecided:
            return None
        if not self.across(force).contains(0) or self.along(force) < 0 or self.ahead(force) > 0:
            return 0
        return self._crossing(cell, motion)

    def _crossing(self, cell: Cell, motion: Motion) -> int | None:
        try:
            slope = self.across(rise(self.way, motion)) / motion.scale
        except Undecided:
            return None
        if not slope.is_finite():
            return None
        if self._stays_off(cell, slope):
            return 0
        if slope.contains(0):
            return None
        rising = 1 if slope > 0 else -1
        low, high = (rising * self.across(end.force) for end in (cell.low, cell.high))
        if low > 0 or high < 0:
            return 0
        return rising if low < 0 < high else None

    def _stays_off(self, cell: Cell, slope: arb) -> bool:
        """Whether the component across the edge does not reach zero from an end, by its slope."""
        step = arb(0).union((cell.high.s - cell.low.s).upper())
        ends = (
            self.across(cell.low.force) + slope * step,
            self.across(cell.high.force) - slope * step,
        )
        return not all(each.contains(0) for each in ends)

    def _slip(self, cell: Cell, rising: int) -> Iterator[Slip]:
        low, high = self._inward(cell, rising)

        def excess(x: arb) -> arb:
            return rising * self.across(at(self.way, low + x).force)

        guess = near_root(excess, arb(0), high - low, width(1))
        s = low + rising_bounds(excess, guess)
        t, scale = self.way.motion(s)
        spin = rotation(self.way.total, t, scale)
        now = response(self.way.total, Motion(t, spin, scale))
        if now.feet:
            raise Undecided("a slip next to a foot")
        size = scale if self.way.rests else arb(1)
        if sign(self.along((now.x, now.y))) > 0:  # and not opposite to it
            yield Slip(s, (size * t[0], size * t[1]), spin * size, (now.x, now.y))

    def _inward(self, cell: Cell, rising: int) -> tuple[arb, arb]:
        """Exact places off the kinks at the ends, on the same sides of the slip."""
        ends = []
        for own, other, way in ((cell.low.s, cell.high.s, -1), (cell.high.s, cell.low.s, 1)):
            if own.is_exact() and own != 0:
                ends.append(own)
                continue
            ends.append(self._next_to(own, other, way * rising))
        return ends[0], ends[1]

    def _next_to(self, own: arb, other: arb, wanted: int) -> arb:
        for power in range(1, ctx.prec // 2):
            s = (own + (other - own) * arb(2) ** -power).mid()
            if wanted * self.across(at(self.way, s).force) > 0:
                return s
        raise Undecided("a slip next to a kink")
