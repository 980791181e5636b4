"""Slips of a slider with friction alone, on any support, under an edge of the friction cone."""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

from flint import arb, fmpq

from planar_pushing.certified.balls import Undecided, norm, sign
from planar_pushing.certified.contact.modes import SLIPS, Mode
from planar_pushing.certified.effects import given
from planar_pushing.certified.effects.modes import edge
from planar_pushing.certified.effects.under import Moved, about, under
from planar_pushing.certified.motion.choices import consistent
from planar_pushing.certified.motion.impulses import SENSE
from planar_pushing.certified.motion.instants import File, Piece, Vector, center_motion, rod_of
from planar_pushing.certified.potential.direction import Direction, relative, returned
from planar_pushing.certified.potential.push import Push
from planar_pushing.certified.potential.resistance import Resistance, resistance

ONE = fmpq(1)
#: A pivot lasts up to this excess, since a stored time can be slightly before its start.
SLACK = arb(2) ** -20


class Slip(NamedTuple):
    """A slip: velocities of the contact and of the center, rotation, and force of the fence."""

    contact: Vector
    velocity: Vector
    spin: arb
    force: Vector


class Edges:
    """A scene's friction cone on a fence of constant velocity, and the slip under one of its edges.

    Rod angles are in radians and exact. A foot is the index of the support's point about which the
    slider pivots, -1 if there is none.
    """

    def __init__(self, file: File, mode: Mode, piece: Piece) -> None:
        self.scene, self.law, self.piece = given.scene(file), given.law(file), piece
        self.mode, self.side, self.fence = mode, SLIPS[mode], piece.velocity

    @property
    def feet(self) -> range:
        """Indices of the points of the support."""
        return range(len(resistance(self.scene).support.points))

    def excess(self, angle: arb, foot: int) -> arb:
        """Squared force that a pivot requires of a foot, less the square of its share.

        The slider pivots about the foot if it is negative.
        """
        total, push = self._line(angle, self.side)
        found = about(total, push, ONE, foot)
        share = total.weight * total.support.points[foot].share
        return arb.pos_inf() if found is None else found.own - share * share

    def turned(self, angle: arb, foot: int, time: arb) -> arb:
        """Rod angle after a pivot of some duration from a rod angle: the contact rotates about the foot."""
        x, y = (arb(each) for each in resistance(self.scene).foot(foot))
        lean, reach = arb.atan2(y, x), norm(x, y)
        sine = (angle + lean).sin() - self.fence[1] * time / reach
        if not (abs(sine) < 1 and (angle + lean).cos() > 0):
            raise Undecided("the pivot moves the contact past the foot")
        return (sine.asin() - lean).mid()

    def slip(self, angle: arb, foot: int) -> Slip:
        """The slip at a rod angle.

        Raises
        ------
        Undecided
            If the slip has ended, or its pivot has ended or changed to another foot.
        """
        motion, found = self._moved(angle, self.side, foot)
        scale, toward = self.fence[1] / motion[1], edge(self.law, self.side).ball()
        contact, spin = (scale * motion[0], self.fence[1]), scale * found.spin
        lasts = found.force > 0 and scale > 0
        if not lasts or sign(contact[0] - self.fence[0]) != SENSE[self.mode]:
            raise Undecided(f"the slip {self.mode.name} ends")
        if found.pivot != foot or (foot >= 0 and not self.excess(angle, foot) < SLACK):
            raise Undecided("a pivot begins or ends")
        velocity = center_motion(rod_of(self.scene.length, angle), contact, spin)
        return Slip(contact, velocity, spin, (found.force * toward[0], found.force * toward[1]))

    def modes(self, angle: arb, foot: int) -> list[Mode]:
        """Consistent modes at a rod angle."""
        own, _ = self._moved(angle, self.side, foot)
        other, _ = self._moved(angle, -self.side, -1)
        return consistent((own, other) if self.side > 0 else (other, own), self.fence)

    def _moved(self, angle: arb, side: int, foot: int) -> tuple[Vector, Moved]:
        """Motion of the contact under an edge, and the same in the body frame."""
        total, push = self._line(angle, side)
        found = under(total, push, ONE) if foot < 0 else about(total, push, ONE, foot)
        if found is None:
            raise Undecided("the line of force passes through the foot")
        return returned(found.motion, total.rod), found

    def _line(self, angle: arb, side: int) -> tuple[Resistance, Push]:
        """The effects at a rod angle, and the line of force of an edge."""

        def rod() -> Vector:
            sine, cosine = angle.sin_cos()
            return cosine, sine

        now = replace(self.scene, rod=Direction(rod))
        total = resistance(now)
        return total, total.push(relative(edge(self.law, side), now.rod))
