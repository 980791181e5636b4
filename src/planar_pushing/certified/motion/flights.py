"""Validated motion over time of a slider with inertia alone that flies, hits the fence once and leaves it.

Without support friction the twist is constant between impacts, and the motion has a closed form except
for the time of the impact, which is the root of the height of the contact above the fence.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from flint import arb, fmpq

from planar_pushing.certified.balls import Undecided, precise, rational, sign
from planar_pushing.certified.contact.modes import Mode
from planar_pushing.certified.motion import impulses
from planar_pushing.certified.motion.impulses import Body
from planar_pushing.certified.motion.instants import (
    NOTHING,
    ZERO,
    File,
    Instant,
    Vector,
    ahead,
    of_event,
    only_piece,
    rod_of,
    spin_ratio,
)
from planar_pushing.certified.roots import increasing_root

#: Number of the event at which contact is made.
TOUCHES = 3
#: Maximum number of halvings of a time span in which contact can be made.
DEPTH = 24


@dataclass(frozen=True, slots=True)
class _Flight:
    """A flight from an initial time, rod angle and place of the center, and the energies up to then."""

    of: Body
    fence: Vector
    start: arb
    angle: arb
    position: Vector
    velocity: Vector
    spin: arb
    gap: fmpq
    work: arb = NOTHING
    lost: arb = NOTHING
    solutions: int = 1

    def turned(self, time: arb) -> arb:
        """Rod angle at a time."""
        return self.angle + self.spin * (time - self.start)

    def height(self, time: arb) -> arb:
        """Height of the contact above the fence."""
        rod = rod_of(self.of.length, self.turned(time))
        passed = time - self.start
        fence = self.fence[1] * time - self.gap
        return self.position[1] + passed * self.velocity[1] - rod[1] - fence

    def rise(self, time: arb) -> arb:
        """Rate of the height."""
        rod = rod_of(self.of.length, self.turned(time))
        return self.velocity[1] - self.spin * rod[0] - self.fence[1]

    def at(self, time: arb) -> Instant:
        """The instant at a time."""
        angle, passed = self.turned(time), time - self.start
        rod, position = (
            rod_of(self.of.length, angle),
            ahead(self.position, self.velocity, passed),
        )
        x, y = ahead((arb(0), arb(-self.gap)), self.fence, time)
        contact = position[0] - rod[0], position[1] - rod[1]
        speed = self.velocity[0] ** 2 + self.velocity[1] ** 2
        kinetic = (self.of.mass * speed + self.of.moment * self.spin**2) / 2
        return Instant(
            time=time, angle=angle, position=position, contact=contact, fence=(x, y),
            twist=(*self.velocity, self.spin), mode=Mode.SEPARATE, solutions=1,
            spin=spin_ratio(self.velocity, self.spin), force=ZERO, slip=arb(0),
            gap=contact[1] - y, work=self.work, rubbed=arb(0), lost=self.lost, kinetic=kinetic,
        )  # fmt: skip


@precise
def flying(file: File, times: Sequence[fmpq]) -> list[Instant]:
    """Flight, an impact, and the flight after it.

    The height is shown to be positive before and after the impact, and the policy selects the mode of
    the impact. The stored instant of the impact is the one just after it.

    Raises
    ------
    Undecided
        If the fence does not move uniformly, or the slider starts on it or stays on it after the impact.
    """
    piece, of, end = only_piece(file), impulses.body(file), arb(times[-1])
    first = _begun(file, of, piece.velocity)
    touch = _touch(first, arb(0), end, DEPTH)
    if touch is None:
        return [first.at(arb(time)) for time in times]
    event, second = of_event(times, touch), _bounced(file, first, touch)
    _shown_open(second, end)
    found = [(first if time < touch else second).at(arb(time)) for time in times]
    found[event] = replace(
        second.at(arb(times[event])), time=touch, gap=NOTHING, event=TOUCHES,
        solutions=second.solutions,
    )  # fmt: skip
    return found


def _begun(file: File, of: Body, fence: Vector) -> _Flight:
    section, twist = file["simulate"], file["simulate"]["initial_twist"] or {}
    angle = arb.pi() * rational(file["slider"]["rod_angle"]) / 180
    v_x, v_y, omega = (arb(rational(twist.get(name, 0))) for name in ("v_x", "v_y", "omega"))
    gap, spin = rational(section["initial_gap"]), arb.pi() * omega / 180
    if gap == 0:
        raise Undecided("certified flight must begin above the fence")
    return _Flight(of, fence, arb(0), angle, rod_of(of.length, angle), (v_x, v_y), spin, gap)


def _touch(flight: _Flight, start: arb, end: arb, depth: int) -> arb | None:
    """Time at which the height first vanishes between two exact times; it is positive at the first."""
    over = start.union(end)
    if flight.height(over) > 0:
        return None
    if flight.rise(over) < 0:
        if flight.height(end) > 0:
            return None
        return increasing_root(lambda time: -flight.height(time), start, end)
    if depth == 0:
        raise Undecided(f"it is undecided whether contact is made between {start} and {end}")
    middle = (start + end) / 2
    found = _touch(flight, start, middle, depth - 1)
    return _touch(flight, middle, end, depth - 1) if found is None else found


def _bounced(file: File, flight: _Flight, touch: arb) -> _Flight:
    """The flight after an impact under the policy."""
    of, angle = flight.of, flight.turned(touch)
    rod = rod_of(of.length, angle)
    slip = flight.velocity[0] + flight.spin * rod[1] - flight.fence[0]
    hit = impulses.impact(of, rod, (slip, flight.rise(touch)), file["simulate"]["on_ambiguity"])
    p, spin = hit.impulse, flight.spin + impulses.torque(rod, hit.impulse) / of.moment
    free = spin * spin * rod[0], spin * spin * rod[1]
    return replace(
        flight, start=touch, angle=angle, spin=spin, lost=flight.lost + hit.lost,
        position=ahead(flight.position, flight.velocity, touch - flight.start),
        velocity=(flight.velocity[0] + p[0] / of.mass, flight.velocity[1] + p[1] / of.mass),
        work=flight.work + p[0] * flight.fence[0] + p[1] * flight.fence[1],
        solutions=len(impulses.consistent(of, rod, hit.slip, free)),
    )  # fmt: skip


def _shown_open(flight: _Flight, end: arb) -> None:
    """Show that the contact opens and stays open: its height is convex with a minimum at the impact."""
    turned = flight.turned(flight.start.union(end))
    if not (turned.sin() > 0 and sign(flight.spin)):
        raise Undecided("it is undecided whether the slider leaves the fence after the impact")
