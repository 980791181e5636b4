"""Content of the section `simulate` of a scene file: the pusher's motion and the simulation settings."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any, ClassVar, Self

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
from planar_pushing.scenes.pusher_model import Moving, PieceEntry, WaypointEntry, require_order
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


class PolicyEntry(FileModel):
    """Policy that chooses between contact modes from a start time."""

    time: NonNegative
    policy: PolicyName


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


def policies_of(entry: Any) -> tuple[PolicyEntry, ...]:
    """Policies over time, one of which a file can give by its name."""
    return entry if isinstance(entry, tuple) else (PolicyEntry(time=0.0, policy=entry),)


class SimulateEntry(Moving):
    """Motion of the fence or the finger, constant or in pieces, and settings of the simulation.

    Candidates are effects in the object's frame that the command `assess` tries besides those of the
    scene.
    """

    keys: ClassVar[Mapping[str, str]] = {
        "angle": "pusher_angle", "speed": "pusher_speed", "pieces": "pusher", "waypoints": "waypoints",
        "shape": "pusher_shape", "radius": "pusher_radius", "frame": "pusher_frame",
    }  # fmt: skip

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
        if self.pusher_frame == PusherFrame.WORLD and self.object_pose is None:
            self._refuse("pusher_frame", "an object_pose", "give the pose of the object at time 0")
        if self.walls is not None and self.object_pose is None:
            self._refuse("walls", "an object_pose", "give the pose of the object at time 0")
        if self.step is not None and self.method != Method.TIME_STEPPING:
            self._refuse(
                "step", "the method time-stepping", "leave it out: rtol controls the steps"
            )
        require_order("on_ambiguity", self.policies)
        return self

    @property
    def policies(self) -> tuple[PolicyEntry, ...]:
        """Policies that choose between contact modes, one for each piece of time."""
        return policies_of(self.on_ambiguity)
