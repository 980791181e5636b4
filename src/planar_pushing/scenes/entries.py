"""Sections of scene files, derived from the declared parameters of what they describe."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping
from typing import Annotated, Any, ClassVar, Literal, Optional, Self, Union

from pydantic import AfterValidator, Field, create_model, model_validator
from pydantic_core import PydanticCustomError

from planar_pushing.mechanics.contact import LAWS
from planar_pushing.mechanics.effects import EFFECTS
from planar_pushing.mechanics.plane import Placement
from planar_pushing.mechanics.pressure.table import extent_of
from planar_pushing.mechanics.slider import Slider
from planar_pushing.mechanics.supports import SHAPES, Polygon
from planar_pushing.mechanics.supports.base import SUPPORT, SUPPORTS
from planar_pushing.mechanics.supports.composite import MEMBERS
from planar_pushing.scenes.fields import FileModel, NotEmpty, Positive, refuse
from planar_pushing.terms.declared import Declaration, declarations_of
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.units import Units

#: Defaults of a class that a file leaves out: nothing, no entries, and a side without ends; also False.
ABSENT = (None, (), (-float("inf"), float("inf")))


class Section(FileModel):
    """A section of a file in the file's form, and what it describes."""

    #: Class, or function, that takes the declared parameters.
    maker: ClassVar[Callable[..., Any]]

    def build(self) -> Any:
        """Build the scene part that the section describes.

        Raises
        ------
        InvalidValue
            If the values do not go together.
        """
        parameters = declarations_of(self.maker)
        return self.maker(
            **{
                name: parameters[name][0].from_file(_build(value))
                for name, value in self
                if name in parameters and value is not None
            }
        )

    @model_validator(mode="after")
    def _describes(self) -> Self:
        try:
            self.build()
        except InvalidValue as error:
            raise PydanticCustomError("refused", "{allowed}", vars(error)) from None
        return self


def _build(value: Any) -> Any:
    if isinstance(value, tuple) and all(hasattr(entry, "build") for entry in value):
        return [entry.build() for entry in value]
    return value.build() if hasattr(value, "build") else value


def entry_of(maker: Callable[..., Any], tag: Mapping[str, str] | None = None) -> Any:
    """Model of a section of a file for the declared parameters of a class or a function.

    Parameters
    ----------
    maker : callable
        Class, or function that takes the parameters by name.
    tag : mapping, optional
        Key, and its word, by which a file tells classes apart.
    """
    words = tag or {}
    fields: dict[str, Any] = {key: (Literal.__getitem__(word), ...) for key, word in words.items()}
    for name, (declaration, default) in declarations_of(maker).items():
        kind = FORMS.get(declaration, Annotated[Any, declaration])
        # A default that is made anew for each value, such as a ring, has no form in a file.
        if (
            default is inspect.Parameter.empty
            or type(default).__name__ == "_HAS_DEFAULT_FACTORY_CLASS"
        ):
            fields[name] = (kind, ...)
        else:
            absent = default is False or default in ABSENT
            fields[name] = (Optional[kind], None) if absent else (kind, default)  # noqa: UP045
    about = (inspect.getdoc(maker) or "").partition("\n\n")[0]
    model = create_model(maker.__name__, __base__=Section, __doc__=about, **fields)
    model.maker = maker
    return model


def tagged_union(key: str, makers: Mapping[str, Callable[..., Any]]) -> Any:
    """Union of the models of classes, which a key tells apart."""
    models = tuple(entry_of(maker, {key: word}) for word, maker in makers.items())
    return Annotated[Union[models], Field(discriminator=key)]  # noqa: UP007


class MemberEntry(FileModel):
    """Part of a composite support, and its fraction of the weight."""

    share: Positive
    support: SupportEntry

    def build(self) -> tuple[float, Any]:
        """The share and the support."""
        return self.share, self.support.build()


#: Forms in files of parameters that are not plain values.
FORMS: dict[Declaration, Any] = {MEMBERS: Annotated[tuple[MemberEntry, ...], NotEmpty]}
#: A support, also as a layout of a polygon.
SupportEntry: Any = tagged_union(
    "shape", SHAPES | {"rectangle": Polygon.rectangle, "regular_polygon": Polygon.regular}
)
MemberEntry.model_rebuild()


def is_point(support: Any) -> bool:
    """Whether a support is a single point, which does not resist rotation."""
    try:
        extent_of(support)
    except InvalidValue:
        return True
    return False


def _larger(value: Any) -> Any:
    if is_point(value.build()):
        raise refuse("a support with more than one point, since a single point resists no rotation")
    return value


#: A whole support; a member of a composite can be a point.
WholeSupport: Any = Annotated[SupportEntry, AfterValidator(_larger)]
FORMS |= {SUPPORT: WholeSupport, SUPPORTS: WholeSupport}

ContactEntry: Any = tagged_union("law", LAWS)
EffectEntry: Any = tagged_union("type", EFFECTS)
SliderEntry: Any = entry_of(Slider)
PlacementEntry: Any = entry_of(Placement)
UnitsEntry: Any = entry_of(Units)
