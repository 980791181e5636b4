"""What a study file holds."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Annotated, Self

import numpy as np
from pydantic import Field, model_validator

from planar_pushing.mechanics.contact import ContactLaw, Coulomb, InfiniteFriction
from planar_pushing.mechanics.effects import Effect, Inertia, RingFriction
from planar_pushing.mechanics.scene import Slider
from planar_pushing.study.files.fields import (
    Angles,
    Count,
    Degrees,
    EffectsName,
    FileModel,
    FilePath,
    FiniteFrictionCoefficients,
    FrictionCoefficient,
    FrictionCoefficients,
    Lengths,
    Magnitudes,
    Name,
    NonNegative,
    NotEmpty,
    Positive,
    RodAngle,
    RodAngles,
    Shares,
    Text,
    Truth,
    refuse,
)
from planar_pushing.terms.domain import Number
from planar_pushing.terms.options import STUDIED

Axis = tuple[float, ...]


class RingEntry(FileModel):
    """The paper's ring: its radius, and the rod angle where a dataset has no axis for it."""

    radius: Positive
    rod_angle: RodAngle


class FrictionParameters(FileModel):
    """Parameters of the support friction."""

    weight: Positive

    def effect(self) -> RingFriction:
        """Build the effect."""
        return RingFriction(weight=self.weight)


class InertiaParameters(FileModel):
    """Parameters of the inertia."""

    mass: Positive
    gyration_radius: Positive

    def effect(self) -> Inertia:
        """Build the effect."""
        return Inertia(mass=self.mass, gyration_radius=self.gyration_radius)


class Grid(FileModel):
    """The axes of the datasets; angles in degrees."""

    effects: Annotated[tuple[EffectsName, ...], NotEmpty]
    rod_length: Lengths
    rod_angle: RodAngles
    friction_coefficient: FrictionCoefficients
    force_angle: Angles
    inertia_share: Shares
    pusher_angle: Angles
    pusher_magnitude: Magnitudes
    contact_friction_coefficient: FiniteFrictionCoefficients


class PushEntry(FileModel):
    """A scene of the study and the fence's motion: its angle, or the force angle it sustains.

    With friction and inertia the force angle is that of equal shares.
    """

    file: FilePath
    pusher_angle: Degrees | None = None
    force_angle: Degrees | None = None
    pusher_magnitude: Positive = 1.0

    @model_validator(mode="after")
    def _one_motion(self) -> Self:
        if (self.pusher_angle is None) == (self.force_angle is None):
            raise refuse("exactly one of pusher_angle and force_angle")
        return self


class FigureEntry(FileModel):
    """Values that a figure takes from the grid."""

    rod_length: NonNegative | tuple[NonNegative, ...] | None = None
    mapped_rod_length: NonNegative | None = None
    friction_coefficient: FrictionCoefficient | None = None
    pusher_magnitude: Positive | None = None

    def grid_values(self, grid: Grid) -> Iterator[tuple[str, Axis, Axis]]:
        """Key, given values and allowed values of what the figure takes from the grid."""
        for key, given in self:
            if given is not None:
                allowed = getattr(grid, key.removeprefix("mapped_"))
                yield key, given if isinstance(given, tuple) else (given,), allowed


class StudyFile(FileModel):
    """The grid of every dataset, the scenes, and the values that the paper leaves open.

    `simulations` names the scene files with a section `simulate` that are followed over time.
    `chunks` gives the most values along dimensions of a dataset that one job computes; `gather` says
    whether its chunks become one file. Paths are relative to the study's file.
    """

    title: Text
    slider: RingEntry
    support_friction: FrictionParameters | None = None
    inertia: InertiaParameters | None = None
    grid: Grid
    scenes: dict[Name, PushEntry]
    simulations: dict[Name, FilePath] = Field(default_factory=dict)
    figures: dict[Name, FigureEntry]
    chunks: dict[Name, dict[Name, Count]] = Field(default_factory=dict)
    gather: dict[Name, Truth] = Field(default_factory=dict)
    golden: FilePath | None = None

    def needed_values(self) -> Iterator[tuple[str, tuple[object, ...], tuple[object, ...]]]:
        """Grid axis, its values, and those among them that the figures cannot do without."""
        psi, grid = self.slider.rod_angle, self.grid
        turns = tuple((psi + turn) % 360 for turn in (0, 90, 180, 270))
        yield "rod_angle", grid.rod_angle, (psi,)
        yield "friction_coefficient", grid.friction_coefficient, (math.inf,)
        yield "force_angle", grid.force_angle, (*turns, 45.0, 90.0)
        yield "inertia_share", grid.inertia_share, (0.0, 1.0)

    @property
    def parts(self) -> dict[str, FrictionParameters | InertiaParameters]:
        """Parameters of the effects that the study lists, by name."""
        known = {str(kind): getattr(self, kind) for kind in STUDIED}
        return {name: part for name, part in known.items() if part is not None}

    def effects(self, name: EffectsName) -> tuple[Effect, ...]:
        """Build the effects that a value of the effects axis stands for."""
        return tuple(self.parts[part].effect() for part in name.split("+"))

    def ring(self, rod_length: Number, rod_angle: Number = None) -> Slider:
        """Build the study's slider with this rod, or these rods; the angle in degrees."""
        return Slider(
            rod_length=rod_length,
            rod_angle=np.deg2rad(self.slider.rod_angle if rod_angle is None else rod_angle),
            radius=self.slider.radius,
        )


def contact_law(friction_coefficient: float) -> ContactLaw:
    """Law of a value of the friction_coefficient axis."""
    finite = math.isfinite(friction_coefficient)
    return Coulomb(friction_coefficient) if finite else InfiniteFriction()
