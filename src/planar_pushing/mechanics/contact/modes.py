"""Contact modes and the outcome of their enumeration (Sec. 2)."""

from __future__ import annotations

from enum import IntEnum


def _name(member: IntEnum) -> str:
    """What is printed for a member: its name; `int` gives its number."""
    return member.name


def _formatted(member: IntEnum, format_spec: str) -> str:
    """A member in a formatted text: its name, or its number in the format d."""
    number = format_spec.endswith("d")
    return format(int(member) if number else member.name, format_spec)


class ContactMode(IntEnum):
    """What the contact does; the slider slips over the fence to the right or to the left."""

    SEPARATE = 0
    STICK = 1
    SLIP_RIGHT = 2
    SLIP_LEFT = 3

    __str__ = _name
    __format__ = _formatted


class Outcome(IntEnum):
    """How many solutions are consistent: none, one, or several."""

    INCONSISTENT = 0
    UNIQUE = 1
    AMBIGUOUS = 2

    __str__ = _name
    __format__ = _formatted


class Status(IntEnum):
    """What is known of the solutions of one push, or of a curve at one angle.

    `NONE`: no mode is consistent. `CONSISTENT`: every solution is a motion of its own. `PIVOTS`: one of
    them is a rotation about a support point, which belongs to an interval of forces. `CONTINUUM`: one of them
    is an end of a continuum of motions. `UNSOLVED`: an iteration has not settled, or more than the known
    number of slips was found.
    """

    NONE = 0
    CONSISTENT = 1
    PIVOTS = 2
    CONTINUUM = 3
    UNSOLVED = 4

    __str__ = _name
    __format__ = _formatted
