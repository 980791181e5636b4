"""Validated motion over time of a ring that sticks to the fence, or slips under infinite friction.

Lengths are in units of R = 1, and times are exact. Within a mode the motion is an integral over the
spin ratio (`quadrature`); the requested instants are roots of the time in it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from flint import arb, fmpq

from planar_pushing.certified import ring
from planar_pushing.certified.balls import Undecided, cosine_sine, precise, rational
from planar_pushing.certified.contact.modes import Mode
from planar_pushing.certified.motion.choices import chosen, ring_modes
from planar_pushing.certified.motion.instants import (
    ZERO,
    File,
    Instant,
    Piece,
    displacement,
    during,
    only_piece,
    pieces,
    rod_of,
)
from planar_pushing.certified.motion.quadrature import (
    Integral,
    arm,
    holds,
    slide_rates,
    slide_spin,
    stick_angle,
    stick_rates,
    stick_spin,
)

UNIT_SPEED = "certified motion is that of a fence of unit speed"
#: Relative width of the root at which a piece of the motion starts.
WIDTH = arb(2) ** -160
#: Relative step of Newton's method after which the next one would be rounding error.
CLOSE = arb(2) ** -100
#: Maximum number of Newton steps to an instant; from the previous instant about five suffice.
STEPS = 20


def rod_length(file: File) -> fmpq:
    """Rod length of a scene that can be certified."""
    slider, (effect,) = file["slider"], file["effects"]
    if slider["radius"] != 1 or effect != {"type": "ring_friction", "weight": 1.0}:
        raise Undecided("certified motion requires a ring of unit radius and weight")
    return rational(slider["rod_length"])


def _unit_pieces(file: File) -> list[Piece]:
    found = pieces(file)
    if any(piece.speed != 1 for piece in found):
        raise Undecided(UNIT_SPEED)
    return found


@precise
def pulled(file: File, times: Sequence[fmpq]) -> list[Instant]:
    """Motion whose contact sticks, or breaks where the fence recedes and the policy is `separate`.

    Every force is shown to lie in the friction cone, also between the instants.
    """
    length, fence = rod_length(file), _unit_pieces(file)
    angle, work = arb.pi() * rational(file["slider"]["rod_angle"]) / 180, arb(0)
    found: list[Instant] = []
    last: Instant | None = None
    for piece in fence:
        if not any(time >= piece.start for time in times):
            break
        inside = during(times, piece, piece is fence[-1])
        modes = ring_modes(file, length, angle, piece.velocity)
        mode = chosen(modes, file["simulate"]["on_ambiguity"])
        if mode is Mode.SEPARATE and last is not None and piece is fence[-1]:
            return found + [_left(file, last, fence, time) for time in inside]
        if mode is not Mode.STICK:
            raise Undecided(f"the contact does not stick at the time {piece.start}: {mode.name}")
        stick = _Stick(file, length, fence, piece, angle, work)
        found += [stick.at(time) for time in inside]
        if any(time >= piece.end for time in times):
            last = stick.at(piece.end)
            angle, work = last.angle, last.work
    return found


def _left(file: File, last: Instant, fence: Sequence[Piece], time: fmpq) -> Instant:
    """The slider at rest while the fence moves away in its last piece."""
    piece = fence[-1]
    # After the first instant the contact is open, and only separation is consistent.
    closed = time == piece.start
    count = len(ring_modes(file, rod_length(file), last.angle, piece.velocity)) if closed else 1
    return replace(
        last, time=arb(time), fence=displacement(fence, time), mode=Mode.SEPARATE,
        gap=(piece.start - time) * piece.velocity[1], solutions=count, spin=arb(0), force=ZERO,
        twist=(arb(0),) * 3,
    )  # fmt: skip


class _Stick:
    """Sticking during a piece of the fence's motion, from an initial rod angle and work.

    The spin ratio increases with time; instants must be requested in order.
    """

    def __init__(
        self, file: File, length: fmpq, fence: Sequence[Piece], piece: Piece, angle: arb, work: arb
    ) -> None:
        self.file, self.length, self.fence, self.piece = file, length, fence, piece
        self.heading = arb.pi() * piece.degrees / 180
        self.mu = rational(file["contact"]["friction_coefficient"])
        self.start, self.done = stick_spin(length, angle - self.heading, WIDTH), work
        self.shown = self.start
        self.path, self.work = (Integral(rate, self.start) for rate in stick_rates(length))

    def at(self, time: fmpq) -> Instant:
        """The instant at a time of the piece."""
        k = self._spin(time - self.piece.start)
        holds(self._in_cone, self.shown, k)
        self.shown = k
        angle = self.heading + stick_angle(self.length, k)
        fence = displacement(self.fence, time)
        rod, toward = rod_of(self.length, angle), self._force_angle(k)
        (force, torque), (sine, cosine) = ring.profile(k), toward.sin_cos()
        size = (1 + 2 * k * torque / force + (k * self.length) ** 2).rsqrt()
        modes = ring_modes(self.file, self.length, angle, self.piece.velocity)
        work = self.done if time == self.piece.start else self.done + self.work.to(k)
        return Instant(
            time=arb(time), angle=angle, position=(fence[0] + rod[0], fence[1] + rod[1]),
            contact=fence, fence=fence, twist=(size * cosine, size * sine, size * k),
            mode=Mode.STICK, solutions=len(modes), spin=k, force=(force * cosine, force * sine),
            slip=arb(0), gap=arb(0), work=work, rubbed=work, lost=arb(0),
        )  # fmt: skip

    def _spin(self, path: fmpq) -> arb:
        """Spin ratio after a path of the fence, by Newton's method; its last step is proved."""
        if path == 0:
            return self.start
        k = self.path.place
        for _ in range(STEPS):
            lack = path - self.path.to(k)
            step = lack / self.path.rate(k)
            if abs(step.mid()) < k * CLOSE:
                return k + self._proved(k + arb(0, 2 * abs(step).upper() + k * WIDTH), lack)
            k = (k + step).mid()
        raise Undecided(f"no spin ratio after the path {path}")

    def _proved(self, near: arb, lack: arb) -> arb:
        """Distance of the root from the middle of a ball that contains it, by the mean value theorem."""
        step = lack / self.path.rate(near)
        if not near.contains(near.mid() + step):
            raise Undecided(f"no enclosure of the spin ratio at {near}")
        return step

    def _force_angle(self, k: arb) -> arb:
        return self.heading + stick_angle(self.length, k) - (arm(k) / self.length).asin()

    def _in_cone(self, k: arb) -> bool:
        lean = self._force_angle(k) - arb.pi() / 2
        return bool(abs(lean) < arb(self.mu).atan())


@precise
def slipping(file: File, times: Sequence[fmpq]) -> list[Instant]:
    """Slip to the right under infinite friction: the force is along the fence, to the left.

    The ring's center remains at its height, so that ``l sin psi`` decreases as the fence rises. The
    slip is shown to be to the right, also between the instants.
    """
    length, piece = rod_length(file), only_piece(file)
    if piece.speed != 1:
        raise Undecided(UNIT_SPEED)
    if file["contact"] != {"law": "infinite_friction", "at_zero_normal": "free"}:
        raise Undecided("certified slip requires infinite friction")
    slide = _Slide(file, length, piece)
    return [slide.at(time) for time in times]


class _Slide:
    """Slip during a piece of the fence's motion; instants must be requested in order."""

    def __init__(self, file: File, length: fmpq, piece: Piece) -> None:
        self.file, self.length, self.piece = file, length, piece
        self.start = cosine_sine(rational(file["slider"]["rod_angle"]))
        self.shown = slide_spin(length, self.start[1])
        self.sums = [Integral(rate, self.shown) for rate in slide_rates(length)]

    def at(self, time: fmpq) -> Instant:
        """The instant at a time of the piece."""
        length, across = self.length, self.piece.velocity
        fence = displacement([self.piece], time)
        sine = self.start[1] - fence[1] / length
        q = slide_spin(length, sine)
        angle = sine.asin()
        modes = ring_modes(self.file, length, angle, across)
        if modes != [Mode.SLIP_RIGHT]:
            raise Undecided(f"a slip to the right is not the only solution at the time {time}")
        holds(self._goes_right, self.shown, q)
        path, rubbed, pull = (each.to(q) if time else arb(0) for each in self.sums)
        self.shown = q
        turn = -across[1] / (length * angle.cos())
        position = length * self.start[0] - path, length * self.start[1]
        contact = position[0] - length * angle.cos() if time else arb(0)
        work = -pull * across[0] / across[1]
        velocity = q * turn, arb(0)
        return Instant(
            time=arb(time), angle=angle, position=position, contact=(contact, fence[1]),
            fence=fence, twist=(*velocity, turn), mode=Mode.SLIP_RIGHT, solutions=len(modes),
            spin=-1 / q, force=(-ring.profile(1 / q)[0], arb(0)), slip=contact - fence[0],
            gap=arb(0), work=work, rubbed=rubbed, lost=work - rubbed,
        )  # fmt: skip

    def _goes_right(self, q: arb) -> bool:
        height, across = 1 / arm(q), self.piece.velocity
        run = (self.length * self.length - height * height).sqrt()
        return bool(-across[1] * (q + height) / run > across[0])
