"""The status of solutions, and how the members of enumerations are printed."""

from __future__ import annotations

from enum import IntEnum


def name_of(member: IntEnum) -> str:
    """The printed form of a member, its name; `int` gives its number."""
    return member.name


def formatted(member: IntEnum, format_spec: str) -> str:
    """A member in a formatted text: its name, or its number in the format d."""
    number = format_spec.endswith("d")
    return format(int(member) if number else member.name, format_spec)


class Status(IntEnum):
    """The status of the solutions of one push, or of a curve at one angle.

    `NONE`: no mode is consistent. `CONSISTENT`: every solution is a motion of its own. `PIVOTS`: one of
    them is a rotation about a support point, which belongs to an interval of forces. `CONTINUUM`: one of
    them is an end of a continuum of motions. `UNSOLVED`: an iteration has not settled, or more than the
    known number of slips was found.
    """

    NONE = 0
    CONSISTENT = 1
    PIVOTS = 2
    CONTINUUM = 3
    UNSOLVED = 4

    __str__ = name_of
    __format__ = formatted
