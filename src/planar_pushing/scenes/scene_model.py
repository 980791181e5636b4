"""Content of a scene file."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated, Self

import numpy as np
from pydantic import ValidationInfo, field_validator, model_validator
from pydantic_core import PydanticCustomError

from planar_pushing.mechanics.effects import EFFECTS
from planar_pushing.mechanics.scene import Scene
from planar_pushing.scenes.entries import (
    ContactEntry,
    EffectEntry,
    PlacementEntry,
    SliderEntry,
    UnitsEntry,
)
from planar_pushing.scenes.fields import FileModel, NotEmpty, Text, refuse_key
from planar_pushing.scenes.pusher_model import PieceEntry
from planar_pushing.scenes.simulate_model import SimulateEntry
from planar_pushing.simulation.world import world_of
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.numbers import in_radians
from planar_pushing.terms.options import EffectKind, PusherFrame


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
        lambda entry, info: require_inertia(entry, info)
    )

    @model_validator(mode="after")
    def _makes_one(self) -> Self:
        try:
            self._scene()
        except InvalidValue as error:
            raise PydanticCustomError("refused", "{allowed}", vars(error)) from None
        return self

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
        section = self.simulate
        if (
            section is None
            or section.object_pose is None
            or section.pusher_frame == PusherFrame.FENCE
        ):
            return () if section is None else section.pieces
        pose = section.object_pose
        fence = world_of(self._scene(), (pose.x, pose.y, float(np.deg2rad(pose.angle)))).fence
        turn = float(np.rad2deg(np.arctan2(fence.axis[1], fence.axis[0])))
        return tuple(
            piece.model_copy(update={"angle": piece.angle - turn}) for piece in section.pieces
        )

    def _scene(self) -> Scene:
        return Scene(
            slider=self.slider.build(),
            contact=self.contact.build(),
            effects=tuple(effect.build() for effect in self.effects),
            placement=None if self.placement is None else self.placement.build(),
            units=None if self.units is None else self.units.build(),
        )


def require_inertia(entry: SimulateEntry | None, info: ValidationInfo) -> SimulateEntry | None:
    """Require inertia among the effects if the section `simulate` has an initial twist."""
    inert = EffectKind.INERTIA in {
        EFFECTS[effect.type].kind for effect in info.data.get("effects", ())
    }
    if entry and entry.initial_twist and not inert:
        twist, allowed = (
            entry.initial_twist.model_dump(),
            "this key with inertia among the effects only",
        )
        raise refuse_key("initial_twist", twist, allowed, "leave it out, or add inertia")
    return entry
