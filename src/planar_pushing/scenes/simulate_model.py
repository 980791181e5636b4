"""Content of the section `simulate` of a scene file: the pusher's motion and the simulation settings."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from itertools import starmap
from typing import Annotated, Any, Self

from pydantic import Discriminator, Tag, model_validator

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
    RelativeTolerance,
    SampleCount,
    ShapeName,
    refuse,
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


class UntilEntry(FileModel):
    """Stopping condition: an event, a contact mode, or the first goal reached; angles in degrees."""

    event: EventName | None = None
    mode: ModeName | None = None
    rotation: Positive | None = None
    distance: Positive | None = None
    pusher_distance: Positive | None = None

    @model_validator(mode="after")
    def _one(self) -> Self:
        if sum(map(bool, (self.event, self.mode, self.goals))) != 1:
            raise refuse("an event, a mode, or some of rotation, distance and pusher_distance")
        if self.rotation is not None and self.rotation > 720.0:
            raise refuse("a rotation of at most 720 degrees")
        return self

    @property
    def goals(self) -> dict[str, float]:
        """The given goals; angles in radians."""
        rotation = None if self.rotation is None else math.radians(self.rotation)
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
    Discriminator(lambda given: "several" if isinstance(given, (list, tuple)) else "one"),
]


class SimulateEntry(FileModel):
    """Motion of the fence or the finger, constant or in pieces, and settings of the simulation."""

    pusher_angle: Degrees | None = None
    pusher_speed: NonNegative | None = None
    pusher_shape: ShapeName = Shape.FENCE.value
    pusher_radius: NonNegative | None = None
    pusher_frame: FrameName = PusherFrame.FENCE.value
    pusher: Annotated[tuple[PieceEntry, ...], NotEmpty] | None = None
    waypoints: tuple[WaypointEntry, ...] | None = None
    duration: Positive
    method: MethodName = Method.EVENT_DRIVEN.value
    on_ambiguity: PolicyEntries = Policy.KEEP_CONTACT.value
    rtol: RelativeTolerance = 1e-10
    initial_twist: TwistEntry | None = None
    initial_gap: NonNegative = 0.0
    object_pose: PoseEntry | None = None
    until: UntilEntry | None = None
    samples: SampleCount = 101
    step: Positive | None = None

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        if [self.pusher_angle, self.pusher, self.waypoints].count(None) != 2:
            raise refuse("exactly one of pusher_angle, pusher and waypoints")
        if self.pusher_angle is None and self.pusher_speed is not None:
            raise refuse(
                "pusher_speed with pusher_angle only; each piece of pusher has its own speed"
            )
        if self.pusher_radius and self.pusher_shape != Shape.FINGER:
            raise refuse("pusher_radius with pusher_shape finger only; a fence is a line")
        if self.waypoints is not None and len(self.waypoints) < 2:
            raise refuse("at least two waypoints")
        if self.pusher_frame == PusherFrame.WORLD and self.object_pose is None:
            raise refuse("pusher_frame world with an object_pose only")
        timed: dict[str, Sequence[Any]] = {
            "pusher": self.pusher or (), "waypoints": self.waypoints or (),
            "on_ambiguity": self.policies,
        }  # fmt: skip
        for name, pieces in timed.items():
            times = [piece.time for piece in pieces] or [0.0]
            if times[0] != 0 or any(b <= a for a, b in itertools.pairwise(times)):
                raise refuse(f"times of {name} that begin at 0 and increase")
        if self.step is not None and self.method != Method.TIME_STEPPING:
            raise refuse("step with the method time-stepping only")
        return self

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
