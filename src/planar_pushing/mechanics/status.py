"""Enumerations of results: contact modes, outcomes and statuses, their printed forms, and flags."""

from __future__ import annotations

from collections.abc import Mapping
from enum import IntEnum
from typing import Any

import numpy as np
import numpy.typing as npt


def name_of(member: IntEnum) -> str:
    """The printed form of a member, which is its name; `int` gives its number."""
    return member.name


def formatted(member: IntEnum, format_spec: str) -> str:
    """A member in a formatted string: its name, or its number with the format d."""
    number = format_spec.endswith("d")
    return format(int(member) if number else member.name, format_spec)


class ContactMode(IntEnum):
    """The motion at the contact; in a slip the slider moves to the right or to the left along the fence."""

    SEPARATE = 0
    STICK = 1
    SLIP_RIGHT = 2
    SLIP_LEFT = 3

    __str__ = name_of
    __format__ = formatted


class Outcome(IntEnum):
    """How many solutions are consistent: none, one, or several; a continuum counts as several."""

    INCONSISTENT = 0
    UNIQUE = 1
    AMBIGUOUS = 2

    __str__ = name_of
    __format__ = formatted


class Status(IntEnum):
    """The status of the solutions of one push, or of a curve at one angle.

    `NONE`: no mode is consistent. `CONSISTENT`: every solution is an isolated motion. `PIVOTS`: one of
    them is a rotation about a support point, which is the same for an interval of forces. `CONTINUUM`: one
    of them belongs to a continuum of motions. `UNSOLVED`: an iteration has not converged, or there are
    more slips than expected.
    """

    NONE = 0
    CONSISTENT = 1
    PIVOTS = 2
    CONTINUUM = 3
    UNSOLVED = 4

    __str__ = name_of
    __format__ = formatted


#: Names of the values of variables that hold flags, in datasets of every kind.
FLAGS: dict[str, Mapping[str, int]] = {
    "mode": ContactMode.__members__,
    "outcome": Outcome.__members__,
    "status": Status.__members__,
}
#: Description of the value of a mode after the last solution.
BEHIND = "-1 after the last solution"


def flag_attributes(names: Mapping[str, int], dtype: npt.DTypeLike = np.int8) -> dict[str, Any]:
    """Attributes of a variable of flags, by the CF conventions."""
    return {
        "flag_values": np.array([int(each) for each in names.values()], dtype),
        "flag_meanings": " ".join(names),
    }
