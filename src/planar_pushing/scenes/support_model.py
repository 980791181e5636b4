"""Entries of the support in a scene file: its shape and the parameters of the shape."""

from __future__ import annotations

import math
from typing import Annotated, Any, Literal, Self

from pydantic import AfterValidator, BeforeValidator, Field, model_validator
from pydantic_core import PydanticCustomError

from planar_pushing.mechanics.pressure.table import extent_of
from planar_pushing.mechanics.supports import SHAPES, Polygon
from planar_pushing.scenes.fields import (
    CornerCount,
    Degrees,
    FileModel,
    NotEmpty,
    Positive,
    refuse,
)
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.numbers import in_radians


def _point(given: object) -> object:
    numbers = isinstance(given, (list, tuple)) and len(given) == 2
    if not numbers or not all(type(x) in (int, float) and math.isfinite(x) for x in given):  # type: ignore[attr-defined]
        raise refuse("two finite numbers, [x, y] in the body frame")
    return given


Point = Annotated[tuple[float, float], BeforeValidator(_point)]
Points = Annotated[tuple[Point, ...], NotEmpty]
Numbers = Annotated[tuple[float, ...], NotEmpty]


class Entry(FileModel):
    """A support that is built from its keys."""

    shape: str

    def build(self) -> Any:
        """The support.

        Raises
        ------
        InvalidValue
            If the keys do not define a valid support.
        """
        given = {name: value for name, value in self if name != "shape" and value is not None}
        return SHAPES[self.shape](**given)

    @model_validator(mode="after")
    def _makes_one(self) -> Self:
        try:
            self.build()
        except InvalidValue as error:
            raise PydanticCustomError("refused", "{allowed}", vars(error)) from None
        return self


class RingSupport(Entry):
    """A uniform ring, by default with the slider's radius and center."""

    shape: Literal["ring"]
    radius: Positive | None = None
    center: Point | None = None


class PointsSupport(Entry):
    """Support points, with their loads, which are equal by default, and their names."""

    shape: Literal["points"]
    positions: Points
    weights: Numbers | None = None
    names: Annotated[tuple[str, ...], NotEmpty] | None = None


class SegmentSupport(Entry):
    """A uniform straight line."""

    shape: Literal["segment"]
    start: Point
    end: Point


class DiscSupport(Entry):
    """A uniform disc."""

    shape: Literal["disc"]
    radius: Positive
    center: Point = (0.0, 0.0)


class AnnulusSupport(Entry):
    """A uniform disc with a hole."""

    shape: Literal["annulus"]
    inner: Positive
    outer: Positive
    center: Point = (0.0, 0.0)


class PolygonSupport(Entry):
    """A uniform polygon, with its corners in order, and those of its holes."""

    shape: Literal["polygon"]
    vertices: Points
    holes: Annotated[tuple[Points, ...], NotEmpty] | None = None


class RectangleSupport(Entry):
    """A uniform rectangle about a center; its width is at an angle from x, in degrees."""

    shape: Literal["rectangle"]
    width: Positive
    height: Positive
    center: Point = (0.0, 0.0)
    angle: Degrees = 0.0

    def build(self) -> Any:
        return Polygon.rectangle(self.width, self.height, self.center, in_radians(self.angle))


class RegularPolygonSupport(Entry):
    """A uniform regular polygon about a center; its first corner is at an angle from x, in degrees."""

    shape: Literal["regular_polygon"]
    count: CornerCount
    radius: Positive
    center: Point = (0.0, 0.0)
    angle: Degrees = 0.0

    def build(self) -> Any:
        return Polygon.regular(int(self.count), self.radius, self.center, in_radians(self.angle))


class PressureMapSupport(Entry):
    """Grid of cells bounded by the coordinates x and y, each with a pressure; rows are along y.

    `origin` and `axis` are the origin of x and y and the direction of x in the body frame.
    """

    shape: Literal["pressure_map"]
    x: Numbers
    y: Numbers
    pressure: Annotated[tuple[Numbers, ...], NotEmpty]
    origin: Point | None = None
    axis: Point | None = None


class MemberEntry(FileModel):
    """Part of a composite support, and its fraction of the weight."""

    share: Positive
    support: SupportEntry


class CompositeSupport(Entry):
    """A combination of several supports."""

    shape: Literal["composite"]
    members: Annotated[tuple[MemberEntry, ...], NotEmpty]

    def build(self) -> Any:
        members = [(member.share, member.support.build()) for member in self.members]
        return SHAPES[self.shape](members)


SupportEntry = Annotated[
    RingSupport
    | PointsSupport
    | SegmentSupport
    | DiscSupport
    | AnnulusSupport
    | PolygonSupport
    | RectangleSupport
    | RegularPolygonSupport
    | PressureMapSupport
    | CompositeSupport,
    Field(discriminator="shape"),
]


def is_point(support: Any) -> bool:
    """Whether a support is a single point, which does not resist rotation."""
    try:
        extent_of(support)
    except InvalidValue:
        return True
    return False


def _larger(given: Any) -> Any:
    if is_point(given.build()):
        raise refuse("a support with more than one point, since a single point resists no rotation")
    return given


#: A whole support; a member of a composite can be a point.
WholeSupport = Annotated[SupportEntry, AfterValidator(_larger)]
MemberEntry.model_rebuild()
CompositeSupport.model_rebuild()
