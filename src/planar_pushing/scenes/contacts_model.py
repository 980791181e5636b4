"""Content of a scene file with several contacts, of an object in its own frame."""

from __future__ import annotations

import math
from typing import Annotated, Any, Self, Union

from pydantic import Field, create_model, model_validator
from pydantic_core import PydanticCustomError

from planar_pushing.mechanics.contact import LAWS
from planar_pushing.mechanics.effects import EFFECTS
from planar_pushing.mechanics.outline import require_outline
from planar_pushing.objects.several.contact import Contact, place_contacts
from planar_pushing.objects.several.solve_contacts import scene_about_center
from planar_pushing.scenes.entries import EffectEntry, UnitsEntry, entry_of
from planar_pushing.scenes.fields import FileModel, NotEmpty, Positive, Text, refuse_key
from planar_pushing.scenes.object_model import BodyEntry, Point, SideNumber, give_support
from planar_pushing.scenes.pusher_model import PusherEntry, require_order
from planar_pushing.scenes.simulate_model import (
    PolicyEntries,
    PolicyEntry,
    PoseEntry,
    TwistEntry,
    WallEntry,
    policies_of,
)
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.simulation.walls import Wall
from planar_pushing.terms.declared import Pair, finite
from planar_pushing.terms.domain import DURATION, RTOL, SAMPLE_COUNT
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.numbers import in_radians
from planar_pushing.terms.options import EffectKind, Policy

VELOCITY = Pair(
    finite("give finite components in the object's frame"), "[v_x, v_y] of finite numbers"
)


class PalmEntry(TwistEntry):
    """Twist of a pusher that turns, about the origin of the object's frame; omega in degrees per time."""


class TouchEntry(FileModel):
    """A contact with a finger or a wall, or along a side with a palm, in the object's frame.

    With an outline, the normal can be omitted unless the contact is at a corner; at an inner corner, a
    contact without a normal is one with each side. Without a velocity or a twist, the contact is at rest.
    With a grip force, it is a finger of a gripper that presses with this force and follows the object along
    the normal.
    """

    point: Point | None = None
    normal: Point | None = None
    side: SideNumber | None = None
    velocity: Annotated[Any, VELOCITY] | None = None
    twist: PalmEntry | None = None
    grip_force: Positive | None = None

    def build(self) -> Contact:
        """The contact with its law."""
        law: Any = super().build()  # type: ignore[misc]
        twist = self.twist and (self.twist.v_x, self.twist.v_y, math.radians(self.twist.omega))
        return Contact(
            self.point, self.normal, law=law, side=self.side, velocity=self.velocity, twist=twist,
            grip_force=self.grip_force,
        )  # fmt: skip


def _touch_entry() -> Any:
    """Union of the contacts of each law, which the key `law` tells apart."""
    models = tuple(
        create_model(
            f"{law.__name__}Contact", __base__=(TouchEntry, entry_of(law, {"law": word})),
            __doc__=TouchEntry.__doc__,
        )
        for word, law in LAWS.items()
    )  # fmt: skip
    return Annotated[Union[models], Field(discriminator="law")]  # noqa: UP007


SeveralEntry: Any = _touch_entry()


class SimulateContactsEntry(FileModel):
    """The motion of a pusher for each contact, walls at rest, and settings of the simulation.

    With `step`, the motion is stepped; otherwise it is integrated from event to event.
    """

    pushers: Annotated[tuple[PusherEntry, ...], NotEmpty]
    duration: Annotated[float, DURATION]
    object_pose: PoseEntry = PoseEntry(x=0.0, y=0.0, angle=0.0)
    walls: Annotated[tuple[WallEntry, ...], NotEmpty] | None = None
    on_ambiguity: PolicyEntries = Policy.KEEP_CONTACT.value
    rtol: Annotated[float, RTOL] = 1e-9
    samples: Annotated[float, SAMPLE_COUNT] = 101
    step: Positive | None = None

    @model_validator(mode="after")
    def _in_order(self) -> Self:
        require_order("on_ambiguity", self.policies)
        return self

    @property
    def policies(self) -> tuple[PolicyEntry, ...]:
        """Policies that choose between contact modes, one for each piece of time."""
        return policies_of(self.on_ambiguity)

    @property
    def world(self) -> dict[str, Any]:
        """The pose of the object and the walls, as arguments of `simulate_contacts`."""
        pose = self.object_pose
        return {
            "object_pose": (pose.x, pose.y, float(in_radians(pose.angle))),
            "walls": [
                Wall(wall.point, wall.normal, wall.contact.build()) for wall in self.walls or ()
            ],
        }


class ContactsFile(FileModel):
    """An object in its own frame, one to four contacts, and the effects that resist the motion.

    The velocities of the contacts are theirs, or those of the pushers in the section `simulate`.
    """

    title: Text = ""
    object: BodyEntry = BodyEntry()
    contacts: Annotated[tuple[SeveralEntry, ...], NotEmpty]
    effects: Annotated[tuple[EffectEntry, ...], NotEmpty]
    simulate: SimulateContactsEntry | None = None
    units: UnitsEntry | None = None

    @model_validator(mode="before")
    @classmethod
    def _rests(cls, content: Any) -> Any:
        """Refuse a contact beside contacts, and give the object's support to effects without one."""
        if isinstance(content, dict) and "contact" in content:
            raise refuse_key(
                "contact", content["contact"], "either contact or contacts", "leave out one of them"
            )
        return give_support(content, BodyEntry)

    @model_validator(mode="after")
    def _makes_one(self) -> Self:
        try:
            self._require_contacts()
            scene_about_center(self._effects(), self._outline())
            if self.simulate is not None:
                self._require_motion(self.simulate)
        except InvalidValue as error:
            raise PydanticCustomError("refused", "{allowed}", vars(error)) from None
        return self

    def _require_contacts(self) -> None:
        """Refuse contacts that do not fit the object, each under its own key, or one another."""
        drawing, outline = self.object.built_outline, self._outline()
        contacts = [entry.build() for entry in self.contacts]
        for number, contact in enumerate(contacts):
            try:
                place_contacts([contact], outline, drawing)
            except InvalidValue as error:
                key = "object" if error.name == "outline" else f"contacts[{number}]"
                error.name = f"{key}.{error.name}"
                raise
        place_contacts(contacts, outline, drawing)

    def _require_motion(self, section: SimulateContactsEntry) -> None:
        """Refuse what goes with a velocity, or with a quasi-static motion over time, only."""
        if self.object.outline is None:
            raise InvalidValue(
                "object.outline", None, "an outline with the section simulate", "give the outline"
            )
        for number, entry in enumerate(self.contacts):
            for name in ("velocity", "twist", "grip_force"):
                if (value := getattr(entry, name)) is not None:
                    given = value.model_dump() if name == "twist" else value
                    remedy = "leave it out: the pusher of the contact moves it"
                    if name == "grip_force":
                        remedy = "leave it out: a grip force is for one instant"
                    raise InvalidValue(
                        f"contacts[{number}].{name}",
                        given,
                        "none with the section simulate",
                        remedy,
                    )
        for number, effect in enumerate(self.effects):
            if EFFECTS[effect.type].kind == EffectKind.INERTIA:
                raise InvalidValue(
                    f"effects[{number}].type", effect.type,
                    "effects without inertia with the section simulate",
                    "leave it out: several contacts are followed without inertia",
                )  # fmt: skip
        if len(section.pushers) != len(self.contacts):
            raise InvalidValue(
                "simulate.pushers", f"{len(section.pushers)} pushers",
                f"one for each of the {len(self.contacts)} contacts",
                "give as many pushers as contacts; walls have their own key",
            )  # fmt: skip
        try:
            self.build()
        except InvalidValue as error:
            error.name = f"simulate.{error.name}"
            raise

    def _outline(self) -> Any:
        drawing = self.object.built_outline
        return None if drawing is None else require_outline(drawing)

    def _effects(self) -> list[Any]:
        return [effect.build() for effect in self.effects]

    def build(self) -> dict[str, Any]:
        """Arguments of `solve_contacts`; with the section `simulate`, of the instant at which it starts."""
        contacts = [entry.build() for entry in self.contacts]
        outline = self.object.built_outline
        if self.simulate is not None:
            from planar_pushing.objects.several.simulate_contacts import contacts_at_start

            pushers = [Pusher(**entry.arguments_of_pusher) for entry in self.simulate.pushers]
            contacts = contacts_at_start(contacts, pushers, outline=outline, **self.simulate.world)
        return {"contacts": contacts, "effects": self._effects(), "outline": outline}

    def arguments(self, section: SimulateContactsEntry) -> dict[str, Any]:
        """Arguments of `simulate_contacts`; angles in radians."""
        return {
            "contacts": [entry.build() for entry in self.contacts],
            "pushers": [Pusher(**entry.arguments_of_pusher) for entry in section.pushers],
            "effects": self._effects(),
            "outline": self.object.built_outline,
            "duration": section.duration,
            "step": section.step,
            "on_ambiguity": [(piece.time, piece.policy) for piece in section.policies],
            "samples": int(section.samples),
            "rtol": section.rtol,
            "units": None if self.units is None else self.units.build(),
            **section.world,
        }  # fmt: skip
