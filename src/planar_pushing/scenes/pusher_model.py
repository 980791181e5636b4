"""Keys of files for the motion of a pusher: constant, in pieces, or from waypoint to waypoint."""

from __future__ import annotations

import itertools
import math
from collections.abc import Mapping, Sequence
from itertools import starmap
from typing import Annotated, Any, ClassVar, Self

from pydantic import model_validator

from planar_pushing.scenes.fields import (
    Degrees,
    FileModel,
    FiniteNumber,
    FrameName,
    NonNegative,
    NotEmpty,
    ShapeName,
    refuse_key,
)
from planar_pushing.terms.domain import FINGER_RADIUS
from planar_pushing.terms.options import PusherFrame, Shape


class PieceEntry(FileModel):
    """The pusher's velocity from a start time; the angle in degrees."""

    time: NonNegative
    angle: Degrees
    speed: NonNegative = 1.0


class WaypointEntry(FileModel):
    """Position of the pusher at a time."""

    time: NonNegative
    x: FiniteNumber
    y: FiniteNumber


def require_order(name: str, entries: Sequence[Any]) -> None:
    """Refuse entries whose times do not begin at 0 or do not increase."""
    times = [entry.time for entry in entries] or [0.0]
    if times[0] != 0 or any(b <= a for a, b in itertools.pairwise(times)):
        raise refuse_key(name, times, "times that begin at 0 and increase", "put them in order")


class Moving(FileModel):
    """A section with one pusher; `keys` has its names for the angle, the pieces and the rest."""

    keys: ClassVar[Mapping[str, str]]

    def _value(self, part: str) -> Any:
        return getattr(self, self.keys[part])

    @model_validator(mode="after")
    def _moves(self) -> Self:
        """Refuse keys of the pusher that do not go together."""
        names = [self.keys[part] for part in ("angle", "pieces", "waypoints")]
        given = [name for name in names if getattr(self, name) is not None]
        if len(given) != 1:
            allowed = f"exactly one of {', '.join(names[:2])} and {names[2]}"
            if given:
                raise refuse_key(given[1], " and ".join(given), allowed, "remove the others")
            raise refuse_key(names[0], None, allowed, "give one of them")
        if self._value("angle") is None and self._value("speed") is not None:
            remedy = f"give each piece of {names[1]} its own speed"
            self._refuse(self.keys["speed"], names[0], remedy)
        if self._value("radius") and self._value("shape") != Shape.FINGER:
            finger = f"{self.keys['shape']} finger"
            self._refuse(self.keys["radius"], finger, "leave it out: a fence is a line")
        for name in names[1:]:
            require_order(name, getattr(self, name) or ())
        waypoints = self._value("waypoints")
        if waypoints is not None and len(waypoints) < 2:
            raise refuse_key(names[2], len(waypoints), "at least two waypoints", "add one")
        return self

    def _refuse(self, name: str, other: str, remedy: str) -> None:
        """Refuse a key that goes with another one only."""
        raise refuse_key(name, getattr(self, name), f"this key with {other} only", remedy)

    @property
    def pieces(self) -> tuple[PieceEntry, ...]:
        """Pieces of the pusher's motion, one if it is constant; it rests after the last waypoint."""
        pieces: tuple[PieceEntry, ...] | None = self._value("pieces")
        if pieces is not None:
            return pieces
        if (waypoints := self._value("waypoints")) is not None:
            legs = starmap(_leg, itertools.pairwise(waypoints))
            return (*legs, PieceEntry(time=waypoints[-1].time, angle=0.0, speed=0.0))
        speed = self._value("speed")
        speed = 1.0 if speed is None else speed
        return (PieceEntry(time=0.0, angle=self._value("angle"), speed=speed),)

    @property
    def arguments_of_pusher(self) -> dict[str, Any]:
        """Keyword arguments of `Pusher`, with its velocities or its waypoints."""
        kind: dict[str, Any] = {name: self._value(name) for name in ("shape", "frame")}
        if (radius := self._value("radius")) is not None:
            kind["radius"] = radius
        if (waypoints := self._value("waypoints")) is not None:
            positions = [(waypoint.time, (waypoint.x, waypoint.y)) for waypoint in waypoints]
            return kind | {"waypoints": positions}
        return kind | {"velocity": [(piece.time, velocity(piece)) for piece in self.pieces]}


def _leg(here: WaypointEntry, there: WaypointEntry) -> PieceEntry:
    """Velocity from one waypoint to the next."""
    x, y = there.x - here.x, there.y - here.y
    speed = math.hypot(x, y) / (there.time - here.time)
    return PieceEntry(time=here.time, angle=math.degrees(math.atan2(y, x)), speed=speed)


def velocity(piece: PieceEntry) -> tuple[float, float]:
    """Velocity of a piece; directions along the axes are free of rounding of pi."""
    angle = math.radians(piece.angle % 360)
    x, y = piece.speed * math.cos(angle), piece.speed * math.sin(angle)
    return (0.0 if piece.angle % 180 == 90 else x), (0.0 if piece.angle % 180 == 0 else y)


class PusherEntry(Moving):
    """One of several pushers: its motion, constant or in pieces, its shape, and the axes of its motion.

    Angles of velocities are in degrees, in the frame `fence` counterclockwise from the contact's tangent,
    so that 90 is straight into the object, and in the frame `world` from x of the world.
    """

    keys: ClassVar[Mapping[str, str]] = {
        "angle": "angle", "speed": "speed", "pieces": "velocities", "waypoints": "waypoints",
        "shape": "shape", "radius": "radius", "frame": "frame",
    }  # fmt: skip

    angle: Degrees | None = None
    speed: NonNegative | None = None
    velocities: Annotated[tuple[PieceEntry, ...], NotEmpty] | None = None
    waypoints: tuple[WaypointEntry, ...] | None = None
    shape: ShapeName = Shape.FENCE.value
    radius: Annotated[float, FINGER_RADIUS] | None = None
    frame: FrameName = PusherFrame.FENCE.value
