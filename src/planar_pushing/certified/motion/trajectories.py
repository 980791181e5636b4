"""Certified motion over time of the simulations of figures 14 and 15.

Lengths are in units of R = 1, times exact. In a mode the motion is an integral over the spin ratio
(`quadrature`); the instants that are asked for are roots of the time in it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

from flint import arb, fmpq

from planar_pushing.certified import ring
from planar_pushing.certified.balls import Undecided, cosine_sine, precise, rational
from planar_pushing.certified.motion.quadrature import (
    arm,
    holds,
    slide_path,
    slide_spin,
    stick_angle,
    stick_spin,
    stick_time,
)
from planar_pushing.certified.roots import increasing_root

File = dict[str, Any]
Vector = tuple[arb, arb]
ZERO: Vector = (arb(0), arb(0))
#: Bits by which the roots of a piece of the fence's motion are wider than those that it starts from.
STEP = 16
SEPARATE, STICK, SLIP_RIGHT = 0, 1, 2


@dataclass(frozen=True, slots=True, kw_only=True)
class Instant:
    """Where slider and fence are; the angle in radians, the others as in the logs."""

    angle: arb
    contact: Vector
    fence: Vector
    mode: int
    spin: arb
    force: Vector
    slip: arb
    gap: arb


def rod_length(file: File) -> fmpq:
    """Rod length of a scene that can be certified."""
    slider, (effect,) = file["slider"], file["effects"]
    if slider["radius"] != 1 or effect != {"type": "ring_friction", "weight": 1.0}:
        raise Undecided("certified motion is that of a ring of unit radius and weight")
    return rational(slider["rod_length"])


def _pieces(file: File) -> list[tuple[fmpq, fmpq]]:
    """Start times and angles in degrees of a fence of unit speed."""
    section = file["simulate"]
    given = section["pusher"] or [
        {"time": 0, "angle": section["pusher_angle"], "speed": section["pusher_speed"] or 1}
    ]
    if any(piece["speed"] != 1 for piece in given):
        raise Undecided("certified motion is that of a fence of unit speed")
    return [(rational(piece["time"]), rational(piece["angle"])) for piece in given]


def _ahead(start: Vector, degrees: fmpq, path: fmpq) -> Vector:
    x, y = cosine_sine(degrees)
    return start[0] + path * x, start[1] + path * y


@precise
def pulled(file: File, times: Sequence[fmpq]) -> list[Instant]:
    """Motion whose contact sticks, or breaks where the fence recedes and the policy is `separate`.

    Every force is shown to lie in the friction cone, between the instants too.
    """
    length, pieces = rod_length(file), _pieces(file)
    mu = rational(file["contact"]["friction_coefficient"])
    leaves = file["simulate"]["on_ambiguity"] == "separate"
    angle, fence, last, found = (
        arb.pi() * rational(file["slider"]["rod_angle"]) / 180,
        ZERO,
        None,
        [],
    )
    ends = [start for start, _ in pieces[1:]] + [None]
    for number, ((start, degrees), end) in enumerate(zip(pieces, ends, strict=True)):
        inside = [time for time in times if time >= start and (end is None or time < end)]
        if leaves and last is not None and cosine_sine(degrees)[1] < 0:
            found += [_left(last, degrees, time - start) for time in inside]
            continue
        if not inside and end is not None and not any(time >= end for time in times):
            continue
        piece = _Stick(length, mu, degrees, angle, fence, width=arb(2) ** (STEP * number - 128))
        found += [piece.after(time - start) for time in inside]
        if end is not None and any(time >= end for time in times):
            last = piece.after(end - start)
            angle, fence = last.angle, last.fence
    return found


def _left(last: Instant, degrees: fmpq, path: fmpq) -> Instant:
    """The slider at rest, the fence moving away."""
    fence = _ahead(last.fence, degrees, path)
    gap = last.fence[1] - fence[1]
    return replace(last, fence=fence, gap=gap, mode=SEPARATE, spin=arb(0), force=ZERO)


class _Stick:
    """Sticking under one velocity of the fence, from a rod angle on; `width` is relative, of roots."""

    def __init__(
        self, length: fmpq, mu: fmpq, degrees: fmpq, angle: arb, fence: Vector, *, width: arb
    ) -> None:
        self.length, self.mu, self.degrees, self.fence = length, mu, degrees, fence
        self.heading, self.width = arb.pi() * degrees / 180, width * arb(2) ** (STEP // 2)
        self.start = stick_spin(length, angle - self.heading, width)

    def after(self, path: fmpq) -> Instant:
        """Instant after a path of the fence."""
        k = self._spin(path)
        angle = self.heading + stick_angle(self.length, k)
        fence, toward = _ahead(self.fence, self.degrees, path), self._force_angle(k)
        size = ring.profile(k)[0]
        force = size * toward.cos(), size * toward.sin()
        still = {"slip": arb(0), "gap": arb(0)}
        return Instant(
            angle=angle, contact=fence, fence=fence, mode=STICK, spin=k, force=force, **still
        )

    def _spin(self, path: fmpq) -> arb:
        if path == 0:
            return self.start
        low = self.start.upper()
        high = ((low + 1) / 2).mid()
        while not self._passed(high) > path:
            high = ((high + 1) / 2).mid()
        k = increasing_root(lambda k: self._passed(k) - path, low, high, self.width)
        holds(self._in_cone, self.start, k)
        return k

    def _passed(self, k: arb) -> arb:
        return stick_time(self.length, self.start, k)

    def _force_angle(self, k: arb) -> arb:
        return self.heading + stick_angle(self.length, k) - (arm(k) / self.length).asin()

    def _in_cone(self, k: arb) -> bool:
        lean = self._force_angle(k) - arb.pi() / 2
        return bool(abs(lean) < arb(self.mu).atan())


@precise
def slipping(file: File, times: Sequence[fmpq]) -> list[Instant]:
    """Slip to the right under infinite friction: the force is along the fence, to its left.

    The ring's center keeps its height, so ``l sin psi`` falls as the fence rises. The slip is shown to go
    to the right, between the instants too.
    """
    length, ((_, degrees),) = rod_length(file), _pieces(file)
    if file["contact"] != {"law": "infinite_friction", "at_zero_normal": "free"}:
        raise Undecided("certified slip is that of infinite friction")
    c, s = cosine_sine(rational(file["slider"]["rod_angle"]))
    begin = slide_spin(length, s)
    across = cosine_sine(degrees)

    def right(q: arb) -> bool:
        height = 1 / arm(q)
        run = (length * length - height * height).sqrt()
        return bool(-across[1] * (q + height) / run > across[0])

    found = []
    for time in times:
        fence = _ahead(ZERO, degrees, time)
        sine = s - fence[1] / length
        q = slide_spin(length, sine)
        path = arb(0)
        if time:
            path = slide_path(length, begin, q)
            holds(right, begin, q)
        angle = sine.asin()
        contact = length * (c - angle.cos()) - path
        found.append(
            Instant(
                angle=angle, contact=(contact, fence[1]), fence=fence, mode=SLIP_RIGHT,
                spin=-1 / q, force=(-ring.profile(1 / q)[0], arb(0)), slip=contact - fence[0],
                gap=arb(0),
            )
        )  # fmt: skip
    return found
