"""Rows: the data that an integrator records at one instant."""

from __future__ import annotations

from enum import IntEnum
from functools import cache
from typing import Any

import numpy as np

from planar_pushing.terms.options import Shape

#: Value of `mode` if no mode is consistent; otherwise it is a `ContactMode`.
NO_MODE = -1
#: Variables that the core has in units of the radius; energies are also in force times radius.
LENGTHS = (
    "position", "pusher", "slip", "gap", "contact_position",
    "dissipated", "contact_dissipated", "work", "load_work", "kinetic_energy",
)  # fmt: skip


@cache
def row_type(effects: int) -> np.dtype[Any]:
    """Data type of one instant of a scene with a number of resisting effects; lengths are in slider radii.

    The fields include the slider's center, the rod angle in radians, the twist, the displacement of the
    pusher, the number of the support point that is a pivot, the event at which the mode was chosen
    (`Event`), the energies since the start, the position of a finger along the side, and whether its
    contact has ended permanently. `stopped` is a `Stop`.
    """
    return np.dtype(
        [
            ("time", "f8"), ("position", "f8", (2,)), ("rod_angle", "f8"), ("twist", "f8", (3,)),
            ("pusher", "f8", (2,)), ("slip", "f8"), ("gap", "f8"), ("force", "f8", (2,)),
            ("mode", "i8"), ("solutions", "i8"), ("pivot", "i8"), ("event", "i8"),
            ("spin_ratio", "f8"), ("dissipated", "f8", (max(effects, 1),)),
            ("contact_dissipated", "f8"), ("work", "f8"), ("load_work", "f8"),
            ("kinetic_energy", "f8"), ("evaluations", "i8"), ("stopped", "i8"),
            ("contact_position", "f8"), ("parted", "i8"),
        ],
        align=True,
    )  # fmt: skip


class Stop(IntEnum):
    """Reasons why a run ended early."""

    NO = 0
    INCONSISTENT = 1
    SLIDER_CENTER_REACHES_FENCE = 2
    NO_IMPULSE = 3
    SINGULAR = 4
    EVENTS = 5
    PROGRESS = 6
    PENETRATES = 7
    END_OF_SIDE = 8


REASONS = {
    Stop.NO: "",
    Stop.INCONSISTENT: "no contact mode is consistent",
    Stop.SLIDER_CENTER_REACHES_FENCE: "the slider's center comes down to the fence",
    Stop.NO_IMPULSE: "no impulse at the contact is consistent",
    Stop.SINGULAR: "the motion is singular in the mode",
    Stop.EVENTS: "without any time between them",
    Stop.PROGRESS: "thousands of steps make no progress",
    Stop.PENETRATES: "another point of the outline meets the {shape}",
    Stop.END_OF_SIDE: "the finger comes to the end of the side",
}


def reason(stop: int, shape: Shape) -> str:
    """Text of the reason why a run with a pusher of this shape ended early."""
    return REASONS[Stop(stop)].format(shape=shape)


def records(dtype: np.dtype[Any], count: int) -> Any:
    """Array of records with fields as attributes, both in compiled code and in Python."""
    return np.zeros(count, dtype).view(np.recarray)


def in_units(rows: Any, radius: Any) -> Any:
    """Convert lengths in rows to the scene's unit, in place.

    Parameters
    ----------
    rows : array of a `row_type`
    radius : float, or ndarray over the first dimension of the rows
    """
    for name in LENGTHS:
        values = rows[name].T  # the radii are along the last dimension
        values *= radius
    velocity = rows["twist"][..., :2].T
    velocity *= radius
    return rows
