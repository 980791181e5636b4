"""Content of the section `simulate` of a scene file: the pusher's motion and the simulation settings."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from itertools import starmap
from typing import Annotated, Any, Self

from pydantic import Discriminator, Tag, model_validator

from planar_pushing.scenes.entries import ContactEntry, EffectEntry
from planar_pushing.scenes.fields import (
    Degrees,
    EventName,
    FileModel,
    FiniteNumber,
    FrameName,
    MethodName,
    ModeName,
    NonNegative,
    NotEmpty,
    PolicyName,
    Positive,
    ShapeName,
    refuse,
    refuse_key,
)
from planar_pushing.terms.domain import (
    DISTANCE,
    DURATION,
    FINGER_RADIUS,
    GAP,
    ROTATION,
    RTOL,
    SAMPLE_COUNT,
)
from planar_pushing.terms.options import Method, Policy, PusherFrame, Shape


class PieceEntry(FileModel):
    """The fence's velocity from a start time; the angle in degrees."""

    time: NonNegative
    angle: Degrees
    speed: NonNegative = 1.0


class PolicyEntry(FileModel):
    """Policy that chooses between contact modes from a start time."""

    time: NonNegative
    policy: PolicyName


class WaypointEntry(FileModel):
    """Position of the pusher at a time."""

    time: NonNegative
    x: FiniteNumber
    y: FiniteNumber


def _leg(here: WaypointEntry, there: WaypointEntry) -> PieceEntry:
    """Velocity from one waypoint to the next."""
    x, y = there.x - here.x, there.y - here.y
    speed = math.hypot(x, y) / (there.time - here.time)
    return PieceEntry(time=here.time, angle=math.degrees(math.atan2(y, x)), speed=speed)


class PoseEntry(FileModel):
    """Pose of the object's frame in the world at time 0; the angle in degrees."""

    x: FiniteNumber
    y: FiniteNumber
    angle: Degrees


class WallEntry(FileModel):
    """A straight wall at rest: a point of it, its normal toward the free side, and its contact law."""

    point: tuple[FiniteNumber, FiniteNumber]
    normal: tuple[FiniteNumber, FiniteNumber]
    contact: ContactEntry

    @model_validator(mode="after")
    def _has_direction(self) -> Self:
        if not any(self.normal):
            raise refuse_key(
                "normal", list(self.normal), "a nonzero vector",
                "give the direction toward the free side",
            )  # fmt: skip
        return self


class UntilEntry(FileModel):
    """Stopping condition: an event, a contact mode, or the first goal reached; angles in degrees."""

    event: EventName | None = None
    mode: ModeName | None = None
    rotation: Annotated[float, ROTATION] | None = None
    distance: Annotated[float, DISTANCE] | None = None
    pusher_distance: Annotated[float, DISTANCE] | None = None

    @model_validator(mode="after")
    def _one(self) -> Self:
        if sum(map(bool, (self.event, self.mode, self.goals))) != 1:
            raise refuse("an event, a mode, or some of rotation, distance and pusher_distance")
        return self

    @property
    def goals(self) -> dict[str, float]:
        """The given goals; angles in radians."""
        rotation = None if self.rotation is None else ROTATION.from_file(self.rotation)
        goals = {
            "rotation": rotation,
            "distance": self.distance,
            "pusher_distance": self.pusher_distance,
        }
        return {name: goal for name, goal in goals.items() if goal is not None}


class TwistEntry(FileModel):
    """Velocity of the slider's center, and angular velocity in degrees per time."""

    v_x: FiniteNumber = 0.0
    v_y: FiniteNumber = 0.0
    omega: FiniteNumber = 0.0


#: One policy, or policies over time.
PolicyEntries = Annotated[
    Annotated[PolicyName, Tag("one")]
    | Annotated[tuple[PolicyEntry, ...], NotEmpty, Tag("several")],
    Discriminator(lambda value: "several" if isinstance(value, (list, tuple)) else "one"),
]


class SimulateEntry(FileModel):
    """Motion of the fence or the finger, constant or in pieces, and settings of the simulation.

    Candidates are effects in the object's frame that the command `assess` tries besides those of the
    scene.
    """

    pusher_angle: Degrees | None = None
    pusher_speed: NonNegative | None = None
    pusher_shape: ShapeName = Shape.FENCE.value
    pusher_radius: Annotated[float, FINGER_RADIUS] | None = None
    pusher_frame: FrameName = PusherFrame.FENCE.value
    pusher: Annotated[tuple[PieceEntry, ...], NotEmpty] | None = None
    waypoints: tuple[WaypointEntry, ...] | None = None
    duration: Annotated[float, DURATION]
    method: MethodName = Method.EVENT_DRIVEN.value
    on_ambiguity: PolicyEntries = Policy.KEEP_CONTACT.value
    rtol: Annotated[float, RTOL] = 1e-10
    initial_twist: TwistEntry | None = None
    initial_gap: Annotated[float, GAP] = 0.0
    object_pose: PoseEntry | None = None
    walls: Annotated[tuple[WallEntry, ...], NotEmpty] | None = None
    until: UntilEntry | None = None
    samples: Annotated[float, SAMPLE_COUNT] = 101
    step: Positive | None = None
    candidates: Annotated[tuple[EffectEntry, ...], NotEmpty] | None = None

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        kinds = ("pusher_angle", "pusher", "waypoints")
        names = [name for name in kinds if getattr(self, name) is not None]
        if len(names) != 1:
            allowed = f"exactly one of {', '.join(kinds[:2])} and {kinds[2]}"
            if names:
                raise refuse_key(names[1], " and ".join(names), allowed, "remove the others")
            raise refuse_key(kinds[0], None, allowed, "give one of them")
        if self.pusher_angle is None and self.pusher_speed is not None:
            self._refuse("pusher_speed", "pusher_angle", "give each piece of pusher its own speed")
        if self.pusher_radius and self.pusher_shape != Shape.FINGER:
            self._refuse("pusher_radius", "pusher_shape finger", "leave it out: a fence is a line")
        if self.pusher_frame == PusherFrame.WORLD and self.object_pose is None:
            self._refuse("pusher_frame", "an object_pose", "give the pose of the object at time 0")
        if self.walls is not None and self.object_pose is None:
            self._refuse("walls", "an object_pose", "give the pose of the object at time 0")
        if self.step is not None and self.method != Method.TIME_STEPPING:
            self._refuse(
                "step", "the method time-stepping", "leave it out: rtol controls the steps"
            )
        timed: dict[str, Sequence[Any]] = {
            "pusher": self.pusher or (), "waypoints": self.waypoints or (),
            "on_ambiguity": self.policies,
        }  # fmt: skip
        for name, pieces in timed.items():
            times = [piece.time for piece in pieces] or [0.0]
            if times[0] != 0 or any(b <= a for a, b in itertools.pairwise(times)):
                raise refuse_key(
                    name, times, "times that begin at 0 and increase", "put them in order"
                )
        if self.waypoints is not None and len(self.waypoints) < 2:
            raise refuse_key("waypoints", len(self.waypoints), "at least two waypoints", "add one")
        return self

    def _refuse(self, name: str, other: str, remedy: str) -> None:
        """Refuse a key that goes with another one only."""
        raise refuse_key(name, getattr(self, name), f"this key with {other} only", remedy)

    @property
    def pieces(self) -> tuple[PieceEntry, ...]:
        """Pieces of the pusher's motion, one if it is constant; it rests after the last waypoint."""
        if self.pusher is not None:
            return self.pusher
        if self.waypoints is not None:
            legs = starmap(_leg, itertools.pairwise(self.waypoints))
            return (*legs, PieceEntry(time=self.waypoints[-1].time, angle=0.0, speed=0.0))
        speed = 1.0 if self.pusher_speed is None else self.pusher_speed
        return (PieceEntry(time=0.0, angle=self.pusher_angle, speed=speed),)

    @property
    def policies(self) -> tuple[PolicyEntry, ...]:
        """Policies that choose between contact modes, one for each piece of time."""
        if isinstance(self.on_ambiguity, tuple):
            return self.on_ambiguity
        return (PolicyEntry(time=0.0, policy=self.on_ambiguity),)
