"""Stored enclosures: midpoints as doubles, and radii as exponents of two in a byte, or as numbers."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]
#: Suffix of a variable that contains the exponents of the radii of another one.
RADIUS = "_radius"
#: Exponent of a number that is known exactly.
EXACT = -128


def radii(stored: npt.NDArray[Any]) -> Floats:
    """Radii from exponents; radii that are given as numbers are returned as they are."""
    if stored.dtype.kind == "f":
        return stored
    found: Floats = np.where(stored == EXACT, 0.0, np.exp2(stored.astype(float)))
    return found


def apart(one: Floats, one_radius: Floats, other: Floats, other_radius: Floats) -> Any:
    """Where enclosures do not overlap; the same infinity, and NaN twice, count as overlap."""
    same = (one == other) | (np.isnan(one) & np.isnan(other))
    with np.errstate(invalid="ignore"):
        return ~same & ~(np.abs(one - other) <= one_radius + other_radius)
