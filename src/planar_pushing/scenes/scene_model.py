"""Content of a scene file."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import Field, ValidationInfo, field_validator
from pydantic_core import PydanticCustomError

from planar_pushing.mechanics.contact import (
    ContactLaw,
    Coulomb,
    InfiniteFriction,
    PerfectlyRough,
)
from planar_pushing.mechanics.effects import (
    Effect,
    Inertia,
    Load,
    RingFriction,
    SupportFriction,
    Viscous,
)
from planar_pushing.mechanics.frames import Placement
from planar_pushing.mechanics.outline import required_outline
from planar_pushing.mechanics.scene import Scene, Slider
from planar_pushing.mechanics.world import world_of
from planar_pushing.scenes.fields import (
    AtZeroNormalName,
    FileModel,
    FiniteFrictionCoefficient,
    NonNegative,
    NotEmpty,
    Positive,
    RodAngle,
    Side,
    Text,
    refuse,
)
from planar_pushing.scenes.simulate_model import PieceEntry, SimulateEntry
from planar_pushing.scenes.support_model import Point, Points, WholeSupport
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.numbers import in_radians
from planar_pushing.terms.options import EFFECT_TYPES, AtZeroNormal, EffectKind, PusherFrame
from planar_pushing.terms.units import Units


class SliderEntry(FileModel):
    """The slider and its rod; lengths in one common unit, the angle in degrees.

    The default radius is the support's largest distance from its center of pressure, or 1 for a ring.
    `side` holds the ends of the flat side that a finger pushes, measured along it from the contact; without
    it, the side has no ends. `outline` holds the slider's corners in the body frame.
    """

    rod_length: NonNegative
    rod_angle: RodAngle
    radius: Positive | None = None
    side: Side | None = None
    outline: Points | None = None

    @field_validator("outline")
    @classmethod
    def _is_simple(cls, given: Any) -> Any:
        try:
            return given if given is None else required_outline(given)
        except InvalidValue as error:
            raise PydanticCustomError("not_allowed", "{allowed}", vars(error)) from None

    def build(self) -> Slider:
        side = {} if self.side is None else {"side": self.side}
        return Slider(
            rod_length=self.rod_length, rod_angle=np.deg2rad(self.rod_angle), radius=self.radius,
            outline=self.outline, **side,
        )  # fmt: skip


class PlacementEntry(FileModel):
    """The contact and the inward normal there, in the object's frame."""

    point: Point
    normal: Point

    def build(self) -> Placement:
        return Placement(self.point, self.normal)


class UnitsEntry(FileModel):
    """Names of the units of length, force and time."""

    length: Text = "m"
    force: Text = "N"
    time: Text = "s"

    def build(self) -> Units:
        return Units(length=self.length, force=self.force, time=self.time)


class CoulombEntry(FileModel):
    """Coulomb friction with a finite coefficient."""

    law: Literal["coulomb"]
    friction_coefficient: FiniteFrictionCoefficient

    def build(self) -> ContactLaw:
        return Coulomb(self.friction_coefficient)


class InfiniteFrictionEntry(FileModel):
    """Infinite friction; at zero normal force the tangential force is free or zero."""

    law: Literal["infinite_friction"]
    at_zero_normal: AtZeroNormalName = AtZeroNormal.FREE.value

    def build(self) -> ContactLaw:
        return InfiniteFriction(self.at_zero_normal)


class PerfectlyRoughEntry(FileModel):
    """Kinematic no-slip."""

    law: Literal["perfectly_rough"]

    def build(self) -> ContactLaw:
        return PerfectlyRough()


class RingFrictionEntry(FileModel):
    """Support friction of the ring.

    `weight` is W = mu_s m g, the weight times the coefficient of support friction.
    """

    type: Literal["ring_friction"]
    weight: Positive = 1.0

    def build(self) -> Effect:
        return RingFriction(weight=self.weight)


class SupportFrictionEntry(FileModel):
    """Friction of any support.

    `weight` is W = mu_s m g, the weight times the coefficient of support friction.
    """

    type: Literal["support_friction"]
    weight: Positive = 1.0
    support: WholeSupport

    def build(self) -> Effect:
        return SupportFriction(support=self.support.build(), weight=self.weight)


class InertiaEntry(FileModel):
    """Inertia of the slider; the radius of gyration is about the center of mass."""

    type: Literal["inertia"]
    mass: Positive = 1.0
    gyration_radius: Positive = 1.0
    center: Point = (0.0, 0.0)

    def build(self) -> Effect:
        return Inertia(mass=self.mass, gyration_radius=self.gyration_radius, center=self.center)


class ViscousEntry(FileModel):
    """Viscous friction of a support; `coefficient` is force divided by speed in a translation."""

    type: Literal["viscous"]
    coefficient: Positive = 1.0
    support: WholeSupport

    def build(self) -> Effect:
        return Viscous(support=self.support.build(), coefficient=self.coefficient)


class LoadEntry(FileModel):
    """A constant force in the world, given along and normal to the fence, at a point of the body frame.

    By default it acts at the center of mass or, without inertia, at the slider's center.
    """

    type: Literal["load"]
    force: Point
    center: Point | None = None

    def build(self) -> Effect:
        return Load(force=self.force, center=self.center)


ContactEntry = Annotated[
    CoulombEntry | InfiniteFrictionEntry | PerfectlyRoughEntry, Field(discriminator="law")
]
EffectEntry = Annotated[
    RingFrictionEntry | SupportFrictionEntry | InertiaEntry | ViscousEntry | LoadEntry,
    Field(discriminator="type"),
]


class SceneFile(FileModel):
    """A scene: the slider, the contact law, and the effects that resist the motion.

    The optional section `simulate` describes the motion of the fence over time.
    """

    title: Text = ""
    slider: SliderEntry
    contact: ContactEntry
    effects: Annotated[tuple[EffectEntry, ...], NotEmpty]
    simulate: SimulateEntry | None = None
    placement: PlacementEntry | None = None
    units: UnitsEntry | None = None

    _twist_has_inertia = field_validator("simulate")(
        lambda given, info: require_inertia(given, info)
    )

    def build(self) -> Scene:
        """The scene; its push is the initial velocity of the pusher.

        A slider with inertia is pushed from rest by an acceleration of magnitude 1; files give none.
        """
        scene, pieces = self._scene(), self.pieces
        if not pieces:
            return scene
        magnitude = 1.0 if scene.stores_energy else pieces[0].speed
        return replace(scene, push=(in_radians(pieces[0].angle), magnitude))

    @property
    def pieces(self) -> tuple[PieceEntry, ...]:
        """Velocities of the pusher over time, with angles from the fence; empty without `simulate`."""
        given = self.simulate
        if given is None or given.object_pose is None or given.pusher_frame == PusherFrame.FENCE:
            return () if given is None else given.pieces
        pose = given.object_pose
        fence = world_of(self._scene(), (pose.x, pose.y, float(np.deg2rad(pose.angle)))).fence
        turn = float(np.rad2deg(np.arctan2(fence.axis[1], fence.axis[0])))
        return tuple(
            piece.model_copy(update={"angle": piece.angle - turn}) for piece in given.pieces
        )

    def _scene(self) -> Scene:
        return Scene(
            slider=self.slider.build(),
            contact=self.contact.build(),
            effects=tuple(effect.build() for effect in self.effects),
            placement=None if self.placement is None else self.placement.build(),
            units=None if self.units is None else self.units.build(),
        )


def require_inertia(given: SimulateEntry | None, info: ValidationInfo) -> SimulateEntry | None:
    """Require inertia among the effects if the section `simulate` has an initial twist."""
    inert = EffectKind.INERTIA in {EFFECT_TYPES[each.type] for each in info.data.get("effects", ())}
    if given and given.initial_twist and not inert:
        raise refuse("initial_twist with inertia among the effects only")
    return given
