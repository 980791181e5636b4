"""Contact modes and the outcome of their enumeration (Sec. 2)."""

from __future__ import annotations

from enum import IntEnum

from planar_pushing.mechanics.status import formatted, name_of


class ContactMode(IntEnum):
    """The motion at the contact; the slider slips over the fence to the right or to the left."""

    SEPARATE = 0
    STICK = 1
    SLIP_RIGHT = 2
    SLIP_LEFT = 3

    __str__ = name_of
    __format__ = formatted


class Outcome(IntEnum):
    """How many solutions are consistent: none, one, or several."""

    INCONSISTENT = 0
    UNIQUE = 1
    AMBIGUOUS = 2

    __str__ = name_of
    __format__ = formatted
