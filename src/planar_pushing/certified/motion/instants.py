"""Instants of a motion over time: the numbers that a log contains, with lengths in units of R = 1."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

from flint import arb, fmpq, fmpq_poly

from planar_pushing.certified.balls import (
    Exact,
    Undecided,
    cosine_sine,
    exact_direction,
    has_exact_direction,
    norm,
    rational,
    settle,
)
from planar_pushing.certified.contact.modes import Mode

File = Mapping[str, Any]
Vector = tuple[arb, arb]
NOTHING = arb(0)
ZERO: Vector = (NOTHING, NOTHING)
NO_EVENT, NO_PIVOT = -1, -1
#: A stored instant this close to an event, as a fraction of the last time, is that of the event.
NEAR = fmpq(1, 10**8)


@dataclass(frozen=True, slots=True, kw_only=True)
class Instant:
    """A slider and the fence at an instant; angles in radians, the other numbers as in the logs.

    Attributes
    ----------
    time, angle : arb
    position, contact, fence : tuple of arb
        Positions of the slider's center, of the contact, and of the fence.
    twist : tuple of arb
        (v_x, v_y, omega) at the slider's center.
    mode : Mode
    solutions : int
        Number of consistent contact modes.
    spin : arb
        Spin ratio.
    force : tuple of arb
    slip, gap : arb
    work, rubbed, lost : arb
        Work of the fence, and energies dissipated by support friction and at the contact.
    kinetic : arb
    pivot, event : int
    """

    time: arb
    angle: arb
    position: Vector
    contact: Vector
    fence: Vector
    twist: tuple[arb, arb, arb]
    mode: Mode
    solutions: int
    spin: arb
    force: Vector
    slip: arb
    gap: arb
    work: arb
    rubbed: arb
    lost: arb
    kinetic: arb = NOTHING
    pivot: int = NO_PIVOT
    event: int = NO_EVENT


@dataclass(frozen=True, slots=True)
class Piece:
    """A constant velocity of the fence: start, end, angle in degrees and speed, all exact."""

    start: fmpq
    end: fmpq
    degrees: fmpq
    speed: fmpq

    @property
    def velocity(self) -> Vector:
        """Velocity; exact zeros along the axes."""
        x, y = cosine_sine(self.degrees)
        return self.speed * x, self.speed * y


def pieces(file: File) -> list[Piece]:
    """The fence's motion in a scene file.

    Raises
    ------
    Undecided
        If the section `simulate` contains something that is not certified.
    """
    section = file["simulate"]
    plain = section["method"] == "event-driven" and section["pusher_shape"] == "fence"
    further = any(section.get(name) is not None for name in ("waypoints", "until"))
    along = section.get("pusher_frame", "fence") == "fence"
    if not plain or not along or further or not isinstance(section["on_ambiguity"], str):
        raise Undecided(
            "certified motion requires event-driven integration, a fence, and one policy"
        )
    given = section["pusher"] or [
        {"time": 0, "angle": section["pusher_angle"], "speed": section["pusher_speed"]}
    ]
    ends = [*(rational(each["time"]) for each in given), rational(section["duration"])]
    speeds = [1 if each["speed"] is None else each["speed"] for each in given]
    return [
        Piece(start, end, rational(each["angle"]), rational(speed))
        for each, speed, start, end in zip(given, speeds, ends, ends[1:], strict=False)
    ]


def only_piece(file: File) -> Piece:
    """The single velocity of a fence that moves uniformly."""
    found = pieces(file)
    if len(found) != 1:
        raise Undecided("certified motion of this kind requires a fence of constant velocity")
    return found[0]


def during(times: Sequence[fmpq], piece: Piece, last: bool) -> list[fmpq]:
    """Instants in a piece of the fence's motion; its end belongs to the next piece."""
    return [t for t in times if piece.start <= t and (t < piece.end or (last and t == piece.end))]


def displacement(fence: Sequence[Piece], time: fmpq) -> Vector:
    """Displacement of the fence; zeros are exact if the directions of the pieces are."""
    paths = [(min(time, each.end) - each.start, each) for each in fence if each.start < time]
    sums = (sum((path * piece.velocity[i] for path, piece in paths), NOTHING) for i in (0, 1))
    if not all(has_exact_direction(piece.degrees) for _, piece in paths):
        x, y = sums
        return x, y

    def exact(i: int) -> Exact:
        terms = (path * piece.speed * exact_direction(piece.degrees)[i] for path, piece in paths)
        return sum(terms, fmpq_poly([0]))

    x, y = (settle(each, partial(exact, i)) for i, each in enumerate(sums))
    return x, y


def ahead(start: Vector, velocity: Vector, time: arb) -> Vector:
    """Place after some time at a constant velocity."""
    return start[0] + time * velocity[0], start[1] + time * velocity[1]


def rod_of(length: fmpq, angle: arb) -> Vector:
    """Vector from the contact to the slider's center."""
    sine, cosine = angle.sin_cos()
    return length * cosine, length * sine


def center_motion(rod: Vector, contact: Vector, spin: arb) -> Vector:
    """Velocity of the center, from the velocity of the contact and the rotation."""
    return contact[0] - spin * rod[1], contact[1] + spin * rod[0]


def spin_ratio(velocity: Vector, spin: arb) -> arb:
    """Spin ratio of a twist, zero at rest."""
    return arb(0) if spin.is_zero() else spin / norm(*velocity)


def of_event(times: Sequence[fmpq], event: arb) -> int:
    """Index of the stored instant of an event.

    Raises
    ------
    Undecided
        If there is not exactly one stored instant next to the event.
    """
    found = [i for i, time in enumerate(times) if abs(time - event) < NEAR * times[-1]]
    if len(found) != 1:
        raise Undecided(f"{len(found)} stored instants are next to the event at {event}")
    return found[0]
