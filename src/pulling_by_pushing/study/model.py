"""Content of a study file."""

from __future__ import annotations

import math
from typing import Annotated, Any, Self

import numpy as np
from pydantic import BeforeValidator, ConfigDict, Field, model_validator

from planar_pushing.mechanics.contact import ContactLaw, Coulomb, InfiniteFriction, PerfectlyRough
from planar_pushing.mechanics.effects import Effect, Inertia, RingFriction
from planar_pushing.mechanics.slider import Slider
from planar_pushing.scenes.entries import WholeSupport
from planar_pushing.scenes.fields import (
    Angles,
    Coordinates,
    Count,
    Degrees,
    EffectsName,
    FileModel,
    FilePath,
    FiniteFrictionCoefficient,
    FiniteFrictionCoefficients,
    FiniteNumber,
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
    require_known_keys,
)
from planar_pushing.terms.domain import Number
from planar_pushing.terms.options import STUDIED
from pulling_by_pushing.study.catalog import AXIS_KEYS, CONTACT_LAWS, DATASETS, contact_labels


def _require_entries(entries: object) -> object:
    if not isinstance(entries, dict) or not entries:
        raise refuse("a mapping of at least one name to a support")
    return entries


class SliderEntry(FileModel):
    """Radius of the paper's ring, and the rod of datasets and figures that have no axis for it."""

    radius: Positive = 1.0
    rod_angle: RodAngle
    rod_length: Positive | None = None


class FrictionParameters(FileModel):
    """Support friction; `weight` is W = mu_s m g, the weight times the coefficient of support friction."""

    weight: Positive

    def effect(self) -> RingFriction:
        """Build the effect."""
        return RingFriction(weight=self.weight)


class InertiaParameters(FileModel):
    """Mass m, and radius of gyration about the center of mass."""

    mass: Positive
    gyration_radius: Positive

    def effect(self) -> Inertia:
        """Build the effect."""
        return Inertia(mass=self.mass, gyration_radius=self.gyration_radius)


class Grid(FileModel):
    """Axes of the datasets; angles in degrees, centers of rotation in the body frame.

    A dataset is computed only if all of its axes are given.
    """

    effects: Annotated[tuple[EffectsName, ...], NotEmpty] = ()
    rod_length: Lengths = ()
    rod_angle: RodAngles = ()
    friction_coefficient: FrictionCoefficients = ()
    force_angle: Angles = ()
    inertia_share: Shares = ()
    pusher_angle: Angles = ()
    pusher_magnitude: Magnitudes = ()
    contact_friction_coefficient: FiniteFrictionCoefficients = ()
    center_x: Coordinates = ()
    center_y: Coordinates = ()


class PushEntry(FileModel):
    """A scene of the study, and the angle of the fence's motion or of the force that this motion causes.

    With friction and inertia, a force angle assumes that each effect takes an equal share of the force.
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


class Cut(FileModel):
    """Values of axes at which a figure cuts a dataset: one, or several in a list."""

    rod_length: NonNegative | tuple[NonNegative, ...] | None = None
    friction_coefficient: FrictionCoefficient | tuple[FrictionCoefficient, ...] | None = None
    pusher_magnitude: Positive | tuple[Positive, ...] | None = None
    support: Annotated[tuple[Name, ...], NotEmpty] | None = None


class FigureEntry(Cut):
    """Values at which a figure cuts its datasets, or under the name of a dataset, this one alone."""

    model_config = ConfigDict(extra="allow")
    __pydantic_extra__: dict[str, Cut]

    @model_validator(mode="before")
    @classmethod
    def _require_known_keys(cls, content: object) -> object:
        return require_known_keys(content, [*cls.model_fields, *DATASETS])


class Parameters(FileModel):
    """The slider, the effects and the supports of a study."""

    slider: SliderEntry
    support_friction: FrictionParameters | None = None
    inertia: InertiaParameters | None = None
    supports: Annotated[dict[Name, WholeSupport], BeforeValidator(_require_entries)] = Field(
        default_factory=dict
    )

    @property
    def parts(self) -> dict[str, FrictionParameters | InertiaParameters]:
        """Parameters of the study's effects, by name."""
        entries = {str(kind): getattr(self, kind) for kind in STUDIED}
        return {name: part for name, part in entries.items() if part is not None}

    def effects(self, name: EffectsName) -> tuple[Effect, ...]:
        """Build the effects for a value of the effects axis."""
        return tuple(self.parts[part].effect() for part in name.split("+"))

    def ring(self, rod_length: Number, rod_angle: Number = None) -> Slider:
        """Build the paper's ring on one or more rods; the angle in degrees."""
        return Slider(
            rod_length=rod_length,
            rod_angle=np.deg2rad(self.slider.rod_angle if rod_angle is None else rod_angle),
            radius=self.slider.radius,
        )

    def gallery(self) -> dict[str, Any]:
        """Build the supports, by name."""
        return {name: entry.build() for name, entry in self.supports.items()}


class PlacedPush(FileModel):
    """Place on the pushed side, from its middle, and angle of the push, 90 degrees along the normal."""

    place: FiniteNumber
    pusher_angle: Degrees


class ModelErrors(FileModel):
    """A box that a finger pushes over a distance, on each support and at each speed; SI units.

    `length` is that of the pushed side, along the x axis of the `supports`.
    """

    length: Positive
    width: Positive
    mass: Positive
    support_friction_coefficient: Positive
    friction_coefficient: FiniteFrictionCoefficient
    distance: Positive
    speed: Magnitudes
    pushes: Annotated[tuple[PlacedPush, ...], NotEmpty]
    supports: Annotated[dict[Name, WholeSupport], BeforeValidator(_require_entries)]

    @model_validator(mode="after")
    def _on_the_side(self) -> Self:
        for push in self.pushes:
            if not (abs(push.place) < self.length / 2 and 0 < push.pusher_angle < 180):
                raise refuse("pushes at places within half the length, at angles between 0 and 180")
        return self


class ModelEstimates(FileModel):
    """Random pushes of boxes: their number, and the seed with which they are drawn."""

    pushes: Count
    seed: Count


#: Sections of a study from which the datasets with their names are computed.
SECTIONS: dict[str, type[FileModel]] = {
    "model_errors": ModelErrors,
    "model_estimates": ModelEstimates,
}


class Part(Parameters):
    """Part of a study: the parameters and axis values from which a dataset is computed."""

    grid: dict[str, tuple[Any, ...]]


class StudyFile(Parameters):
    """The grid of every dataset, the scenes, and values that the paper does not specify.

    `supports` is an axis of the datasets whose names begin with `support`. `model_errors` and
    `model_estimates` are the pushes of the datasets with these names. `simulations` names the scene
    files to simulate, each with a section `simulate`. `fine_grids` gives the axes of datasets from which
    lines and maps are drawn; an axis that it does not give is that of `grid`. `chunks` gives the maximum
    number of values along dimensions of a dataset that one job computes; `gather` says whether the chunks
    are combined into one file. Paths are relative to the study file.
    """

    title: Text
    grid: Grid
    scenes: dict[Name, PushEntry] = Field(default_factory=dict)
    model_errors: ModelErrors | None = None
    model_estimates: ModelEstimates | None = None
    simulations: dict[Name, FilePath] = Field(default_factory=dict)
    fine_grids: dict[Name, Grid] = Field(default_factory=dict)
    figures: dict[Name, FigureEntry] = Field(default_factory=dict)
    chunks: dict[Name, dict[Name, Count]] = Field(default_factory=dict)
    gather: dict[Name, Truth] = Field(default_factory=dict)
    golden: FilePath | None = None

    def values(self, axis: str, dataset: str = "") -> tuple[Any, ...]:
        """Values along an axis of a dataset, which can have a grid of its own."""
        if axis == "support":
            return tuple(self.supports)
        key = AXIS_KEYS.get(axis, axis)
        values: tuple[Any, ...] = getattr(self._grid(axis, dataset), key)
        return tuple(contact_labels(values)) if axis == "contact" and values else values

    def axis_key(self, axis: str, dataset: str) -> str:
        """Key of the study that gives the values along an axis of a dataset."""
        key = AXIS_KEYS.get(axis, axis)
        if axis == "support":
            return key
        fine = self._grid(axis, dataset) is not self.grid
        return f"fine_grids.{dataset}.{key}" if fine else f"grid.{key}"

    def _grid(self, axis: str, dataset: str) -> Grid:
        fine = self.fine_grids.get(dataset)
        return fine if fine and getattr(fine, AXIS_KEYS.get(axis, axis)) else self.grid


#: Laws for the labels along `contact` that have no coefficient.
LAWS: dict[str, ContactLaw] = dict(
    zip(CONTACT_LAWS, (InfiniteFriction(), InfiniteFriction("none"), PerfectlyRough()), strict=True)
)


def contact_law(friction_coefficient: float) -> ContactLaw:
    """Law for a value of the axis friction_coefficient."""
    finite = math.isfinite(friction_coefficient)
    return Coulomb(friction_coefficient) if finite else InfiniteFriction()


def labeled_law(label: str) -> ContactLaw:
    """Law for a label along the axis contact."""
    return LAWS[label] if label in LAWS else Coulomb(float(label.removeprefix("coulomb_")))
