"""What the section `simulate` of a scene file holds: the fence's motion over time, and how to follow it."""

from __future__ import annotations

import itertools
from typing import Annotated, Self

from pydantic import Discriminator, Tag, model_validator

from planar_pushing.study.files.fields import (
    Degrees,
    FileModel,
    FiniteNumber,
    MethodName,
    NonNegative,
    NotEmpty,
    PolicyName,
    Positive,
    RelativeTolerance,
    SampleCount,
    ShapeName,
    refuse,
)
from planar_pushing.terms.options import Method, Policy, Shape


class PieceEntry(FileModel):
    """The fence's velocity from a time on; the angle in degrees."""

    time: NonNegative
    angle: Degrees
    speed: NonNegative = 1.0


class PolicyEntry(FileModel):
    """What decides between contact modes from a time on."""

    time: NonNegative
    policy: PolicyName


class TwistEntry(FileModel):
    """Velocity of the slider's center, and rotation in degrees per time."""

    v_x: FiniteNumber = 0.0
    v_y: FiniteNumber = 0.0
    omega: FiniteNumber = 0.0


#: A policy, or policies over time.
PolicyEntries = Annotated[
    Annotated[PolicyName, Tag("one")]
    | Annotated[tuple[PolicyEntry, ...], NotEmpty, Tag("several")],
    Discriminator(lambda given: "several" if isinstance(given, (list, tuple)) else "one"),
]


class SimulateEntry(FileModel):
    """A motion of the fence or the finger, constant or in pieces, and how the slider is followed."""

    pusher_angle: Degrees | None = None
    pusher_speed: NonNegative | None = None
    pusher_shape: ShapeName = Shape.FENCE.value
    pusher: Annotated[tuple[PieceEntry, ...], NotEmpty] | None = None
    duration: Positive
    method: MethodName = Method.EVENT_DRIVEN.value
    on_ambiguity: PolicyEntries = Policy.KEEP_CONTACT.value
    rtol: RelativeTolerance = 1e-10
    initial_twist: TwistEntry | None = None
    initial_gap: NonNegative = 0.0
    samples: SampleCount = 101
    step: Positive | None = None

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        if (self.pusher_angle is None) == (self.pusher is None):
            raise refuse("exactly one of pusher_angle and pusher")
        if self.pusher is not None and self.pusher_speed is not None:
            raise refuse(
                "pusher_speed with pusher_angle only; the pieces of pusher hold a speed each"
            )
        for name, pieces in (("pusher", self.pieces), ("on_ambiguity", self.policies)):
            times = [piece.time for piece in pieces]
            if times[0] != 0 or any(b <= a for a, b in itertools.pairwise(times)):
                raise refuse(f"times of {name} that begin at 0 and increase")
        if self.step is not None and self.method != Method.TIME_STEPPING:
            raise refuse("step with the method time-stepping only")
        return self

    @property
    def pieces(self) -> tuple[PieceEntry, ...]:
        """The fence's motion as pieces, of which a constant one has one."""
        if self.pusher is not None:
            return self.pusher
        speed = 1.0 if self.pusher_speed is None else self.pusher_speed
        return (PieceEntry(time=0.0, angle=self.pusher_angle, speed=speed),)

    @property
    def policies(self) -> tuple[PolicyEntry, ...]:
        """What decides between contact modes as pieces, of which a policy alone has one."""
        if isinstance(self.on_ambiguity, tuple):
            return self.on_ambiguity
        return (PolicyEntry(time=0.0, policy=self.on_ambiguity),)
