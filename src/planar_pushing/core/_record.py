"""Rows of numbers with names, for plain Python; the joiner knows them by itself."""

from __future__ import annotations

import sys
from typing import Any, get_type_hints, overload

from planar_pushing.core.numbers import Numbers


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
        place = cls.size
        hints = get_type_hints(cls, vars(sys.modules[cls.__module__]))
        for name in cls.__annotations__:
            setattr(cls, name, _property_of(hints[name], place))
            place += size_of(hints[name])
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

    #: Number of its numbers.
    size = 0


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
