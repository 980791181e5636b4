"""Contact modes and the outcome of their enumeration (Sec. 2)."""

from __future__ import annotations

from enum import IntEnum


class ContactMode(IntEnum):
    """What the contact does; the slider slips over the fence to the right or to the left."""

    SEPARATE = 0
    STICK = 1
    SLIP_RIGHT = 2
    SLIP_LEFT = 3


class Outcome(IntEnum):
    """How many solutions are consistent: none, one, or several."""

    INCONSISTENT = 0
    UNIQUE = 1
    AMBIGUOUS = 2
