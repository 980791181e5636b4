"""Motion over time of a slider on feet that slips and then pivots about one of them; not validated.

The force is along an edge of the friction cone, so that the motion depends only on the rod angle. Time,
slip and energies are integrals over this angle (`chebyshev`), and the instants are roots of the time.
The pivot begins where the foot can carry the force that the pivot requires, which is a root as well.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Generic, NamedTuple, TypeVar

from flint import arb, fmpq

from planar_pushing.certified.balls import Undecided, precise, rational, sign
from planar_pushing.certified.effects import given
from planar_pushing.certified.effects.modes import modes
from planar_pushing.certified.motion.chebyshev import integrals
from planar_pushing.certified.motion.choices import chosen
from planar_pushing.certified.motion.edges import Edges
from planar_pushing.certified.motion.impulses import SENSE
from planar_pushing.certified.motion.instants import (
    NO_PIVOT,
    File,
    Instant,
    displacement,
    of_event,
    only_piece,
    rod_of,
    spin_ratio,
)
from planar_pushing.certified.potential.direction import degrees
from planar_pushing.certified.roots import increasing_root

T = TypeVar("T")
#: Number of the event at which a pivot begins.
KINK = 10
#: Number of parts of the remaining rod angles in which the start of a pivot is sought.
PARTS = 64
#: An instant of the event is this close to the end of a phase, in radians.
BESIDE = arb(2) ** -16


class Sums(NamedTuple, Generic[T]):
    """Time, slip, and energies, or the quantities that determine them, along the rod angle."""

    time: T
    slip: T
    work: T
    rubbed: T


@precise
def pivoting(file: File, times: Sequence[fmpq], nodes: int) -> list[Instant]:
    """Slip and pivot on a fence of constant velocity, by series with a number of nodes.

    The stored instant next to the start of the pivot is that of the event, just after it.

    Raises
    ------
    Undecided
        If the slider does not slip at first, pivots at first or never, or pivots about two feet in turn.
    """
    piece, start = only_piece(file), (arb.pi() * rational(file["slider"]["rod_angle"]) / 180).mid()
    may = modes(given.scene(file), given.law(file), degrees(piece.degrees), piece.speed)
    mode = chosen([each.mode for each in may], file["simulate"]["on_ambiguity"])
    if mode not in SENSE or file["slider"]["radius"] != 1:
        raise Undecided(
            f"certified pivots must follow a slip, with R = 1, not the mode {mode.name}"
        )
    edges = Edges(file, mode, piece)
    foot, angle = _pivot(edges, start)
    slip = _Phase(edges, NO_PIVOT, start, angle, nodes, Sums(*[arb(0)] * 4))
    begins = slip.last.time
    end = edges.turned(angle, foot, times[-1] - begins)
    turn = _Phase(edges, foot, angle, end, nodes, slip.last)
    event = of_event(times, begins)
    found = [(slip if i < event else turn).at(time) for i, time in enumerate(times)]
    found[event] = replace(found[event], time=begins, event=KINK)
    return found


def _pivot(edges: Edges, start: arb) -> tuple[int, arb]:
    """The foot about which the slider first pivots, and the rod angle there."""
    falls = sign(edges.slip(start, NO_PIVOT).spin) < 0
    end = arb(0) if falls else arb.pi().mid()
    before = start
    for i in range(1, PARTS):
        place = (start + (end - start) * i / PARTS).mid()
        for foot in edges.feet:
            if edges.excess(place, foot) < 0:
                return foot, _crossing(edges, foot, before, place)
        before = place
    raise Undecided("the slider does not pivot")


def _crossing(edges: Edges, foot: int, before: arb, behind: arb) -> arb:
    """Rod angle at which a foot can first carry the force that a pivot requires of it."""
    low, high = (before, behind) if before < behind else (behind, before)
    sense = -1 if before < behind else 1
    return increasing_root(lambda angle: sense * edges.excess(angle, foot), low, high).mid()


class _Phase:
    """A slip, or a pivot about a foot, between two rod angles, with initial sums."""

    def __init__(
        self, edges: Edges, foot: int, start: arb, end: arb, nodes: int, first: Sums[arb]
    ) -> None:
        self.edges, self.foot, self.first = edges, foot, first
        self.start, self.end = start, end
        self.series = Sums(*integrals(self._rates, start, end, nodes))
        self.last = self._sums(end)

    def _rates(self, angle: arb) -> Sums[arb]:
        """Derivatives by the rod angle."""
        now, (w_x, w_y) = self.edges.slip(angle, self.foot), self.edges.fence
        (x, y), (u_x, u_y) = now.force, now.contact
        rates = arb(1), u_x - w_x, x * w_x + y * w_y, x * u_x + y * u_y
        return Sums(*(each / now.spin for each in rates))

    def _sums(self, angle: arb) -> Sums[arb]:
        sums = (first + each.at(angle) for first, each in zip(self.first, self.series, strict=True))
        return Sums(*(each.mid() for each in sums))

    def _angle(self, time: fmpq) -> arb:
        """The rod angle at a time."""
        falls = self.end < self.start
        low, high = (self.end, self.start) if falls else (self.start, self.end)
        sense, start = -1 if falls else 1, self.first.time
        lack = self.series.time
        root = increasing_root(
            lambda angle: sense * (start + lack.at(angle) - time), low - BESIDE, high + BESIDE
        )
        return root.mid()

    def at(self, time: fmpq) -> Instant:
        """The instant at a time."""
        begins = time == self.first.time
        angle = self.start if begins else self._angle(time)
        sums = self.first if begins else self._sums(angle)
        now, fence = self.edges.slip(angle, self.foot), displacement([self.edges.piece], time)
        rod, contact = rod_of(self.edges.scene.length, angle), (fence[0] + sums.slip, fence[1])
        return Instant(
            time=arb(time), angle=angle, position=(contact[0] + rod[0], contact[1] + rod[1]),
            contact=contact, fence=fence, twist=(*now.velocity, now.spin), mode=self.edges.mode,
            solutions=len(self.edges.modes(angle, self.foot)),
            spin=spin_ratio(now.velocity, now.spin), force=now.force, slip=sums.slip, gap=arb(0),
            work=sums.work, rubbed=sums.rubbed, lost=sums.work - sums.rubbed, pivot=self.foot,
        )  # fmt: skip
