"""Rows of numbers with names, for plain Python; the joiner knows them by itself."""

from __future__ import annotations

import sys
from typing import Any, ClassVar, overload

from planar_pushing.core.numbers import Numbers

#: Fields that are one number.
NUMBERS: dict[str, type] = {"float": float, "int": int, "bool": bool}


class Record:
    """A row of numbers whose entries have names: the annotated fields of a subclass, in their order.

    A field is a float, an integer, a truth value, or another record. Those of a base class come first. In
    compiled code a record is the address of its first number.

    Parameters
    ----------
    row : Numbers
    """

    __slots__ = ("row",)

    def __init__(self, row: Numbers) -> None:
        self.row = row

    def __init_subclass__(cls) -> None:
        """Make a property of each annotated field."""
        place, cls.places = cls.size, dict(cls.places)
        known = vars(sys.modules[cls.__module__]) | NUMBERS
        for name, annotation in cls.__annotations__.items():
            kind = known[annotation]
            setattr(cls, name, _property_of(kind, place))
            size = size_of(kind)
            cls.places[name] = slice(place, place + size) if issubclass(kind, Record) else place
            place += size
        cls.size = place

    @overload
    def __getitem__(self, index: int, /) -> float: ...
    @overload
    def __getitem__(self, index: slice, /) -> Numbers: ...
    def __getitem__(self, index: Any, /) -> Any:
        """Read a number, or a part of the row."""
        return self.row[index]

    def __setitem__(self, index: int, number: float, /) -> None:
        """Store a number."""
        self.row[index] = number

    #: Number of its numbers, and the place of each field in a row: an index, or a part for a record.
    size: ClassVar[int] = 0
    places: ClassVar[dict[str, Any]] = {}


def _property_of(kind: type, place: int) -> property:
    """A field of a kind at a place of the row."""
    if issubclass(kind, Record):
        return property(lambda record: kind(record.row[place:]))

    def get(record: Record) -> float:
        number = record.row[place]
        return number != 0.0 if kind is bool else int(number) if kind is int else number

    def put(record: Record, value: float) -> None:
        record.row[place] = float(value)

    return property(get, put)


def size_of(kind: type) -> int:
    """Number of numbers of a record, 1 of another type."""
    return kind.size if issubclass(kind, Record) else 1
