"""Motion over time of a ring with friction and inertia, from impact to impact and to rest; not validated.

The velocity of the fence is piecewise constant, and each piece begins with an impact at the jump of the
velocity. Lengths are in units of R = 1.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from flint import arb, fmpq

from planar_pushing.certified.balls import Undecided, precise, rational
from planar_pushing.certified.contact.modes import Mode
from planar_pushing.certified.motion import impulses
from planar_pushing.certified.motion.choices import chosen
from planar_pushing.certified.motion.extrapolation import Scheme, advance
from planar_pushing.certified.motion.impulses import Body
from planar_pushing.certified.motion.inertial import Now, Phase
from planar_pushing.certified.motion.instants import (
    NO_EVENT,
    ZERO,
    File,
    Instant,
    Piece,
    displacement,
    during,
    of_event,
    pieces,
    rod_of,
    spin_ratio,
)

#: Number of the event at which the slider comes to rest.
STOPS = 8


@precise
def driven(file: File, times: Sequence[fmpq], scheme: Scheme) -> list[Instant]:
    """Motion of a slider that is initially at rest on the fence.

    The stored instant closest to the time at which the slider comes to rest is that of the event.

    Raises
    ------
    Undecided
        If the slider leaves the fence, or a mode ends other than at rest.
    """
    section, fence = file["simulate"], pieces(file)
    if section["initial_gap"] != 0 or section["initial_twist"] is not None:
        raise Undecided(
            "certified motion with friction and inertia must begin at rest on the fence"
        )
    of, weight = impulses.body(file), _weight(file)
    angle = (arb.pi() * rational(file["slider"]["rod_angle"]) / 180).mid()
    now, past = Now(angle, *[arb(0)] * 7), None
    found: list[Instant] = []
    for piece in fence:
        part = _Part(of, weight, fence, piece, scheme)
        now = part.hit(now, past, section["on_ambiguity"])
        inside, last = during(times, piece, piece is fence[-1]), times[-1] <= piece.end
        part.look_for_rest(now, times)
        for time in inside:
            now, instant = part.at(now, time)
            found.append(instant)
        if last:
            break
        now = part.moved(now, piece.end)
        past = piece
    return found


def _weight(file: File) -> fmpq:
    """Weight on a ring of unit radius about the slider's center."""
    found = [each for each in file["effects"] if each["type"] != "inertia"]
    if len(found) != 1 or found[0]["type"] != "ring_friction":
        raise Undecided("certified motion with friction and inertia requires a ring")
    return rational(found[0]["weight"])


class _Part:
    """Motion during a piece of the fence's motion."""

    def __init__(
        self, of: Body, weight: fmpq, fence: Sequence[Piece], piece: Piece, scheme: Scheme
    ) -> None:
        self.of, self.fence, self.piece, self.scheme = of, fence, piece, scheme
        self.phase = Phase(of, weight, piece.velocity, Mode.STICK)
        self.rest: Now | None = None
        self.event: fmpq | None = None

    def hit(self, now: Now, past: Piece | None, policy: str) -> Now:
        """Select the mode, and return the state after the impact that begins the piece."""
        if past is not None and (past.degrees, past.speed) == (
            self.piece.degrees,
            self.piece.speed,
        ):
            raise Undecided("certified pieces of the fence's motion must differ in velocity")
        of, (w_x, w_y), rod = self.of, self.piece.velocity, rod_of(self.of.length, now.angle)
        before = ZERO if past is None else past.velocity
        apart = before[0] + now.rate - w_x, before[1] - w_y
        hit = impulses.impact(of, rod, apart, policy)
        if hit.mode is Mode.SEPARATE:
            raise Undecided(f"the slider leaves the fence at the time {self.piece.start}")
        x, y = hit.impulse
        after = now._replace(
            spin=now.spin + impulses.torque(rod, hit.impulse) / of.moment, rate=hit.slip,
            work=now.work + x * w_x + y * w_y, lost=now.lost + hit.lost,
        )  # fmt: skip
        after = Now(*(each.mid() for each in after))
        free = self.phase.forces(after).free
        mode = chosen(impulses.consistent(of, rod, after.rate, free), policy)
        if mode is Mode.SEPARATE:
            raise Undecided(f"the slider leaves the fence at the time {self.piece.start}")
        self.phase = replace(self.phase, mode=mode)
        return after

    def look_for_rest(self, now: Now, times: Sequence[fmpq]) -> None:
        """Find where the motion decays to rest, on a fence that does not move."""
        if self.piece.speed != 0:
            return
        rest = self.phase.rest(now, self.scheme)
        if rest.time < min(self.piece.end, times[-1]):
            self.rest, self.event = rest, times[of_event(times, rest.time)]

    def moved(self, now: Now, time: fmpq) -> Now:
        """The state at a later time."""
        if self.rest is not None and (time == self.event or time > self.rest.time):
            return self.rest
        if time == now.time:
            return now
        step = arb(time) - now.time
        return Now(*advance(self.phase.by_time, now, step, self.scheme))._replace(time=arb(time))

    def at(self, now: Now, time: fmpq) -> tuple[Now, Instant]:
        """State and instant at a later time."""
        now = self.moved(now, time)
        rests = now is self.rest
        stops = rests and time == self.event
        fence = displacement(self.fence, time)
        rod, contact = rod_of(self.of.length, now.angle), (fence[0] + now.slip, fence[1])
        found = Instant(
            time=now.time if stops else arb(time), angle=now.angle, contact=contact, fence=fence,
            position=(contact[0] + rod[0], contact[1] + rod[1]), twist=(arb(0),) * 3,
            mode=Mode.SEPARATE, solutions=1, spin=arb(0), force=ZERO, slip=now.slip, gap=arb(0),
            work=now.work, rubbed=now.rubbed, lost=now.lost, event=STOPS if stops else NO_EVENT,
        )  # fmt: skip
        return now, found if rests else self._moving(found, now)

    def _moving(self, found: Instant, now: Now) -> Instant:
        """An instant at rest with the motion of the phase."""
        here = self.phase.forces(now)
        speed = here.velocity[0] ** 2 + here.velocity[1] ** 2
        return replace(
            found, twist=(*here.velocity, now.spin), mode=self.phase.mode,
            solutions=len(self.phase.modes(now)), spin=spin_ratio(here.velocity, now.spin),
            force=here.force, kinetic=(self.of.mass * speed + self.of.moment * now.spin**2) / 2,
        )  # fmt: skip
