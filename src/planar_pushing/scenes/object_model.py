"""Content of an object file: a scene with its supports and contact in the object's frame."""

from __future__ import annotations

import re
from typing import Annotated, Any, Self

from pydantic import ValidationError, WithJsonSchema, field_validator, model_validator
from pydantic_core import PydanticCustomError

from planar_pushing.mechanics.entries import scene_entry
from planar_pushing.mechanics.outline import Outline
from planar_pushing.mechanics.outline.chains import sample_chain, split_chains
from planar_pushing.mechanics.outline.entries import OUTLINE, WORDS, outline_of_entry
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.supports import SHAPES
from planar_pushing.mechanics.supports.base import POSITION, positions
from planar_pushing.objects.scene_at import place_object
from planar_pushing.scenes.entries import ContactEntry, EffectEntry, UnitsEntry, is_point
from planar_pushing.scenes.fields import FileModel, NotEmpty, Positive, Text
from planar_pushing.scenes.scene_model import SceneFile, require_inertia
from planar_pushing.scenes.simulate_model import SimulateEntry
from planar_pushing.terms.declared import Read
from planar_pushing.terms.errors import InvalidValue

Point = Annotated[Any, POSITION]


def _read_outline(name: str, value: Any) -> Any:
    """An outline in the form of the file, if it has a shape, or vertices."""
    if isinstance(value, dict):
        outline_of_entry(value, name)
        return value
    return positions(name, value)


OBJECT_OUTLINE = Read(_read_outline, WORDS, OUTLINE.schema)
#: The number of a side; `scene_at` checks it.
SideNumber = Annotated[Any, WithJsonSchema({"type": "integer", "minimum": 0})]
#: Types of effects that have a support.
RESTING = ("support_friction", "viscous")
#: Deviation of the polygon with uniform pressure from an outline with arcs, in sizes of the outline.
FINE = 1e-5
#: Stands in for the support of an object that is refused itself, so that effects are not refused as well.
STAND_IN = {"shape": "disc", "radius": 1.0}
#: Keys of a file for the parameters that `scene_at` can reject.
PLACES = {
    **dict.fromkeys(("point", "normal", "side"), "object.contact."), "outline": "object.",
}  # fmt: skip


class FootEntry(FileModel):
    """A foot in the object's frame, with its load in any unit and its name."""

    position: Point
    weight: Positive = 1.0
    name: Text | None = None


class PlaceEntry(FileModel):
    """Contact point on the object, and the normal there into the object; or a side that lies on the fence.

    With an outline, the normal can be omitted unless the contact is at a corner. The sides of the outline
    are numbered from 0: a side begins at the corner with its number.
    """

    point: Point | None = None
    normal: Point | None = None
    side: SideNumber | None = None


class BodyEntry(FileModel):
    """An object in its own frame: its outline and its feet.

    Effects without a support act on the feet or, without feet, on the whole outline with uniform pressure;
    under arcs it is that of a polygon within a hundred-thousandth of the outline's size.
    """

    outline: Annotated[Any, OBJECT_OUTLINE] | None = None
    feet: Annotated[tuple[FootEntry, ...], NotEmpty] | None = None

    @property
    def built_outline(self) -> Any:
        """The outline; its corners as they were drawn, because their sides are numbered."""
        is_shape = isinstance(self.outline, dict)
        return outline_of_entry(self.outline) if is_shape else self.outline


class ObjectEntry(BodyEntry):
    """An object in its own frame: its outline, its feet and its contact.

    Effects without a support act on the feet or, without feet, on the whole outline with uniform pressure;
    under arcs it is that of a polygon within a hundred-thousandth of the outline's size.
    """

    contact: PlaceEntry


def give_support(content: Any, model: type[BodyEntry]) -> Any:
    """Content of a file in which effects and candidates without a support have that of the object.

    Raises
    ------
    PydanticCustomError
        If the feet or the outline are no support, with the key of the object.
    """
    if not isinstance(content, dict):
        return content
    simulate = content.get("simulate")
    section = simulate if isinstance(simulate, dict) else {}
    lists = [content.get("effects"), section.get("candidates")]
    if not any(_rests_on_object(effect) for effects in lists for effect in _entries_of(effects)):
        return content
    support = _support(content.get("object"), model)
    if support is None:
        return content
    effects, candidates = (_with_support(effects, support) for effects in lists)
    if candidates is not None:
        content = content | {"simulate": section | {"candidates": candidates}}
    return content | {"effects": effects} if "effects" in content else content


class ObjectFile(FileModel):
    """A scene with an object in its own frame; it is converted to a scene file when it is read."""

    title: Text = ""
    object: ObjectEntry
    contact: ContactEntry
    effects: Annotated[tuple[EffectEntry, ...], NotEmpty]
    simulate: SimulateEntry | None = None
    units: UnitsEntry | None = None

    @model_validator(mode="before")
    @classmethod
    def _rests(cls, content: Any) -> Any:
        """Give the object's support to effects and candidates without one."""
        return give_support(content, ObjectEntry)

    _twist_has_inertia = field_validator("simulate")(
        lambda entry, info: require_inertia(entry, info)
    )

    @model_validator(mode="after")
    def _makes_one(self) -> Self:
        try:
            self.build()
        except InvalidValue as error:
            about = vars(error) | {"name": PLACES.get(error.name, "") + error.name}
            raise PydanticCustomError("refused", "{allowed}", about) from None
        return self

    def build(self) -> Scene:
        contact = self.object.contact
        scene, _ = place_object(
            contact.point,
            contact.normal,
            contact.side,
            effects=[effect.build() for effect in self.effects],
            contact=self.contact.build(),
            outline=self.object.built_outline,
            units=None if self.units is None else self.units.build(),
        )
        return scene

    def scene_file(self) -> SceneFile:
        """The same scene in its body frame."""
        simulate = None if self.simulate is None else self.simulate.model_dump(exclude_none=True)
        return SceneFile.model_validate(
            scene_entry(self.build(), self.title) | {"simulate": simulate}
        )


def _entries_of(effects: Any) -> list[Any]:
    return effects if isinstance(effects, list) else []


def _with_support(effects: Any, support: dict[str, Any]) -> Any:
    """Entries of effects, with a support for those without one."""
    if not isinstance(effects, list):
        return effects
    return [
        effect | {"support": support} if _rests_on_object(effect) else effect for effect in effects
    ]


def _rests_on_object(effect: Any) -> bool:
    """Whether the entry of an effect leaves out its support, which is then that of the object."""
    is_resting = isinstance(effect, dict) and effect.get("type") in RESTING
    return is_resting and "support" not in effect


def _support(entry: Any, model: type[BodyEntry]) -> dict[str, Any] | None:
    """Entry of an object's support, if it has feet or an outline; errors name the keys of the object."""
    try:
        model.model_validate(entry)
    except ValidationError:
        return STAND_IN
    support = _support_entry(entry)
    if support is None:
        return None
    try:
        _require_support(support)
    except InvalidValue as error:
        key = error.name.replace("vertices", "outline")
        key = re.sub(r"^(position|weight|name)s((?:\[\d+\])?)", r"feet\2.\1", key)
        about = vars(error) | {"name": f"object.{key}"}
        raise PydanticCustomError("refused", "{allowed}", about) from None
    return support


def _require_support(entry: dict[str, Any]) -> None:
    """Refuse an invalid support of an object, and a single point."""
    parameters = {key: value for key, value in entry.items() if key != "shape"}
    if is_point(SHAPES[entry["shape"]](**parameters)):
        raise InvalidValue(
            "positions", entry["positions"],
            "at least two points of support, because a single point resists no rotation", "list all feet",
        )  # fmt: skip


def _support_entry(entry: Any) -> dict[str, Any] | None:
    """Entry of a support on feet or on an outline."""
    content = entry if isinstance(entry, dict) else {}
    feet, outline = content.get("feet"), content.get("outline")
    if isinstance(feet, list) and feet and all(isinstance(foot, dict) for foot in feet):
        names = [foot.get("name") for foot in feet]
        return {
            "shape": "points",
            "positions": [foot.get("position") for foot in feet],
            "weights": [foot.get("weight", 1.0) for foot in feet],
            **({"names": names} if all(names) else {}),
        }
    if not outline or feet:
        return None
    if not isinstance(outline, dict):
        return {"shape": "polygon", "vertices": outline}
    disc = outline.get("disc")
    if isinstance(disc, dict):
        return {"shape": "disc"} | disc
    return _uniform_support(outline_of_entry(outline))


def _uniform_support(outline: Outline) -> dict[str, Any]:
    """Entry of uniform pressure under an outline: a disc, or a polygon, with holes."""
    chains = split_chains(outline.pieces)
    if len(outline.pieces) == 1:
        x, y, radius = outline.pieces[0, :3].tolist()
        return {"shape": "disc", "radius": radius, "center": [x, y]}
    vertices, *holes = (sample_chain(chain, FINE * outline.size).tolist() for chain in chains)
    return {"shape": "polygon", "vertices": vertices} | ({"holes": holes} if holes else {})
