"""Rows: what an integrator writes down at one instant."""

from __future__ import annotations

from enum import IntEnum
from typing import Any

import numpy as np

#: Value of `mode` where no mode is consistent; otherwise it is one of `ContactMode`.
NO_MODE = -1
#: One instant, lengths in radii of the slider: ring centre, rod angle in radians, twist with R omega,
#: displacement of the pusher, and energies since the start. `stopped` is a `Stop`. Place of a finger along
#: the side, and whether its contact has ended for good.
ROW = np.dtype(
    [
        ("time", "f8"), ("position", "f8", (2,)), ("rod_angle", "f8"), ("twist", "f8", (3,)),
        ("fence", "f8", (2,)), ("slip", "f8"), ("gap", "f8"), ("force", "f8", (2,)),
        ("mode", "i8"), ("solutions", "i8"), ("spin_ratio", "f8"), ("dissipated", "f8"),
        ("contact_dissipated", "f8"), ("work", "f8"), ("kinetic_energy", "f8"),
        ("evaluations", "i8"), ("stopped", "i8"), ("contact_position", "f8"), ("parted", "i8"),
    ],
    align=True,
)  # fmt: skip
#: Variables that the core has in radii; energies too are forces times radii.
LENGTHS = (
    "position", "twist", "fence", "slip", "gap", "contact_position",
    "dissipated", "contact_dissipated", "work", "kinetic_energy",
)  # fmt: skip


class Stop(IntEnum):
    """Why a run ended before its time."""

    NO = 0
    INCONSISTENT = 1
    LIES = 2
    NO_IMPULSE = 3
    SINGULAR = 4
    EVENTS = 5


REASONS = {
    Stop.NO: "",
    Stop.INCONSISTENT: "no contact mode is consistent",
    Stop.LIES: "the ring's centre comes down to the fence",
    Stop.NO_IMPULSE: "no impulse at the contact is consistent",
    Stop.SINGULAR: "the motion is singular in the mode",
    Stop.EVENTS: "without any time between them",
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
    rows : array of ROW
    radius : float, or ndarray over the first dimension of the rows
    """
    for name in LENGTHS:
        values = rows[name].T  # the last dimension is that of the radii
        values *= radius
    return rows
