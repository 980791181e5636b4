"""The conditions of a contact mode, evaluated on balls around a claimed solution."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple, Protocol

from flint import arb, fmpq

from planar_pushing.certified.balls import norm, rational
from planar_pushing.certified.contact.modes import SLIPS, Law, Mode
from planar_pushing.certified.effects.modes import edge
from planar_pushing.certified.effects.rest import is_held
from planar_pushing.certified.potential.direction import Direction, returned, turned
from planar_pushing.certified.potential.gradient import Motion, Response, response
from planar_pushing.certified.potential.resistance import Resistance
from planar_pushing.certified.supports.pressure.moments import Vector


class Claim(Protocol):
    """A solution in the frame of the fence, as given by `planar_pushing.Solution`.

    Attributes
    ----------
    mode : int
        Value of `Mode`.
    force, force_end : sequence of float, shape (2,)
        Ends of the interval of forces.
    contact_motion : sequence of float, shape (2,)
    twist : sequence of float, shape (3,)
        (v_x, v_y, omega) at the origin of the body frame.
    pivot : int
        Index of the support's point at the center of rotation, -1 if there is none.
    """

    @property
    def mode(self) -> int: ...
    @property
    def force(self) -> Sequence[float]: ...
    @property
    def force_end(self) -> Sequence[float]: ...
    @property
    def contact_motion(self) -> Sequence[float]: ...
    @property
    def twist(self) -> Sequence[float]: ...
    @property
    def pivot(self) -> int: ...


class _Moved(NamedTuple):
    """A twist as balls: motion of the contact and rotation, body frame; and the radius of the speed."""

    motion: Motion
    slack: arb
    rests: bool


class Conditions:
    """The conditions of a claim."""

    def __init__(
        self,
        total: Resistance,
        law: Law,
        pusher: Direction,
        magnitude: fmpq,
        claim: Claim,
        tolerance: fmpq,
    ) -> None:
        self.total, self.law, self.claim, self.tolerance = total, law, claim, tolerance
        x, y = pusher.ball()
        self.pusher, self.size = (x * magnitude, y * magnitude), arb(magnitude)
        self.mode, self.pivot = Mode(int(claim.mode)), int(claim.pivot)
        self.moved = self._balls()

    def failures(self) -> Iterator[str]:
        """Every condition that fails with certainty."""
        yield from self._kinematics()
        if self.pivot >= 0 and not self._turns_about(self.pivot):
            yield "the pivot moves"
            return
        if self.mode is Mode.SEPARATE:
            yield from self._free()
            return
        if self.moved.rests:
            yield "a contact force without a motion"
            return
        ends = {_exact(self.claim.force), _exact(self.claim.force_end)}
        if len(ends) > 1 and (self.pivot < 0 or self.mode is not Mode.STICK):
            yield "an interval of forces without a sticking pivot"
        for given in ends:
            yield from self._force(given)

    # --- Motion ----------------------------------------------------------------------------------

    def _balls(self) -> _Moved:
        x, y, spin = (arb(rational(each)) for each in self.claim.twist)
        reach, length = _reach(self.total), self.total.length
        slack = ((norm(x, y) + reach * abs(spin)) * self.tolerance).upper()
        v_x, v_y = turned((x, y), self.total.rod)
        motion = v_x + arb(0, slack), v_y - spin * length + arb(0, slack)
        turn = spin + arb(0, (slack / reach).upper())
        return _Moved(Motion(motion, turn), slack, bool(slack.is_zero()))

    def _kinematics(self) -> Iterator[str]:
        """The contact's motion, and its slip relative to the pusher."""
        own = returned(self.moved.motion.t, self.total.rod)
        given = [arb(rational(each)) for each in self.claim.contact_motion]
        wide = arb(0, (self.tolerance * self.size).upper())
        if not all((a - b).contains(0) for a, b in zip(own, given, strict=True)):
            yield "the contact motion does not match the twist"
        slip, gap = (a - b + wide for a, b in zip(own, self.pusher, strict=True))
        if self.mode is Mode.SEPARATE:
            if gap < 0:
                yield "the pusher moves into the slider"
        elif not gap.contains(0):
            yield "the contact leaves the fence"
        if self.mode is Mode.STICK and not slip.contains(0):
            yield "the contact slips"
        if self.mode in SLIPS and -SLIPS[self.mode] * slip < 0:
            yield "the contact slips in the opposite direction"

    def _turns_about(self, foot: int) -> bool:
        if foot >= len(self.total.support.points):
            return False
        (x, y), (t_x, t_y) = self.total.foot(foot), self.moved.motion.t
        spin = self.moved.motion.spin
        return bool((t_x - spin * y).contains(0) and (t_y + spin * x).contains(0))

    # --- Force -----------------------------------------------------------------------------------

    def _free(self) -> Iterator[str]:
        """Separation: no force, and the free motion of the slider."""
        if any(_exact(self.claim.force)) or any(_exact(self.claim.force_end)):
            yield "a force without contact"
        if not self.moved.rests:
            yield from self._balance((arb(0), arb(0)))
        elif not is_held(self.total):
            yield "the load moves the slider"

    def _force(self, given: tuple[fmpq, fmpq]) -> Iterator[str]:
        size = norm(arb(given[0]), arb(given[1]))
        if size.is_zero():
            yield "no contact force"
            return
        slack = arb(0, (size * self.tolerance).upper())
        force = given[0] + slack, given[1] + slack
        yield from self._in_cone(force)
        yield from self._balance(
            force, is_end=_exact(self.claim.force) != _exact(self.claim.force_end)
        )

    def _in_cone(self, force: Vector) -> Iterator[str]:
        """The force is within the law's cone; for a slip, it is on the edge that opposes the slip."""
        if self.mode in SLIPS:
            bound = edge(self.law, SLIPS[self.mode]).ball()
            if not self.law.slips:
                yield "a slip under a law that does not allow slip"
            if not _cross(bound, force).contains(0):
                yield "the force is not on the edge of the cone"
            if bound[0] * force[0] + bound[1] * force[1] < 0:
                yield "the force is opposite to the edge of the cone"
        elif not self.law.adhesive:
            depths = (side * _cross(edge(self.law, side).ball(), force) for side in (1, -1))
            if any(each < 0 for each in depths) or force[1] < 0:
                yield "the force is outside the cone"

    def _balance(self, force: Vector, *, is_end: bool = False) -> Iterator[str]:
        """Balance of force and torque about the contact; feet at the center of rotation carry the rest."""
        total, x, y = self.total, *turned(force, self.total.rod)
        now = response(total, self.moved.motion, self.pivot)
        load = norm(*total.load[:2]) + abs(total.load[2]) / _reach(total)
        slack = arb(0, (self.tolerance * (norm(*force) + load)).upper())
        hinge = x - now.x + slack, y - now.y + slack
        torque = now.torque + _reach(total) * slack
        if not now.feet:
            if not (hinge[0].contains(0) and hinge[1].contains(0)):
                yield "the force does not balance the effects"
            if not torque.contains(0):
                yield "the torque about the contact is not zero"
            return
        yield from self._hinged(now, hinge, torque)
        if is_end and self.pivot >= 0 and not self._ends(force, hinge):
            yield "the interval of forces does not end here"

    def _hinged(self, now: Response, hinge: Vector, torque: arb) -> Iterator[str]:
        total, feet = self.total, now.feet
        share = total.weight * sum((total.support.points[i].share for i in feet), fmpq(0))
        if norm(*hinge) > share:
            yield "a foot at the center of rotation carries more than its share"
        places = [total.foot(i) for i in feet]
        x, y = (
            arb(min(p[k] for p in places)).union(arb(max(p[k] for p in places))) for k in (0, 1)
        )
        if not (torque + x * hinge[1] - y * hinge[0]).contains(0):
            yield "the torque about the contact is not zero"

    def _ends(self, force: Vector, hinge: Vector) -> bool:
        """Whether the foot carries its full share, or the force is on an edge of the cone."""
        share = self.total.weight * self.total.support.points[self.pivot].share
        if norm(*hinge).overlaps(arb(share)):
            return True
        edges = () if self.law.adhesive else (edge(self.law, side).ball() for side in (1, -1))
        return any(_cross(each, force).contains(0) for each in edges)


def _exact(pair: Sequence[float]) -> tuple[fmpq, fmpq]:
    return rational(pair[0]), rational(pair[1])


def _cross(a: Vector, b: Vector) -> arb:
    return a[0] * b[1] - a[1] * b[0]


def _reach(total: Resistance) -> arb:
    """Length of the rod plus the extent of the slider from its center of pressure or of mass."""
    own = total.support.extent
    if total.weight == 0 and total.mass:
        x, y = total.first
        own = arb(total.second / total.mass - (x * x + y * y) / total.mass**2).sqrt()
    return (total.length + own).mid()
