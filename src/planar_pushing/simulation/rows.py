"""Rows: what an integrator writes down at one instant."""

from __future__ import annotations

from enum import IntEnum
from functools import cache
from typing import Any

import numpy as np

#: Value of `mode` where no mode is consistent; otherwise it is one of `ContactMode`.
NO_MODE = -1
#: Variables that the core has in radii; energies too are forces times radii.
LENGTHS = (
    "position", "pusher", "slip", "gap", "contact_position",
    "dissipated", "contact_dissipated", "work", "load_work", "kinetic_energy",
)  # fmt: skip


@cache
def row_type(effects: int) -> np.dtype[Any]:
    """One instant of a scene with so many effects that resist the motion, lengths in radii of the slider.

    Slider's center, rod angle in radians, twist, displacement of the pusher, number of the support point
    that is a pivot, why the mode was chosen anew (`Event`), and energies since the start. `stopped` is a
    `Stop`. Position of a finger along the side, and whether its contact has ended for good.
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
    """Why a run ended before its time."""

    NO = 0
    INCONSISTENT = 1
    LIES = 2
    NO_IMPULSE = 3
    SINGULAR = 4
    EVENTS = 5
    PROGRESS = 6
    PENETRATES = 7
    END_OF_SIDE = 8


REASONS = {
    Stop.NO: "",
    Stop.INCONSISTENT: "no contact mode is consistent",
    Stop.LIES: "the slider's center comes down to the fence",
    Stop.NO_IMPULSE: "no impulse at the contact is consistent",
    Stop.SINGULAR: "the motion is singular in the mode",
    Stop.EVENTS: "without any time between them",
    Stop.PROGRESS: "thousands of steps make no progress",
    Stop.PENETRATES: "another point of the outline meets the fence",
    Stop.END_OF_SIDE: "the finger comes to the end of the side",
}


def reason(stop: int) -> str:
    """Why a run ended before its time, in words."""
    return REASONS[Stop(stop)]


def records(dtype: np.dtype[Any], count: int) -> Any:
    """Array of records whose fields are attributes, in compiled code as in Python."""
    return np.zeros(count, dtype).view(np.recarray)


def in_units(rows: Any, radius: Any) -> Any:
    """Rows with lengths in the unit of the scene; the rows themselves change.

    Parameters
    ----------
    rows : array of a `row_type`
    radius : float, or ndarray over the first dimension of the rows
    """
    for name in LENGTHS:
        values = rows[name].T  # the last dimension is that of the radii
        values *= radius
    velocity = rows["twist"][..., :2].T
    velocity *= radius
    return rows
