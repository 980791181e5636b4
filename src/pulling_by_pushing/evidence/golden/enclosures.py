"""Stored enclosures: midpoints as doubles, and radii as exponents of two in a byte, or as numbers.

The radius of a number is what `oracle.balls.ROUNDINGS` roundings of the terms and inputs of its equations
change in it. The radius of an infinite number is the size from which on a computed one counts as
infinite.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr

Floats = npt.NDArray[np.float64]
#: Suffix of a variable that contains the exponents of the radii of another one.
RADIUS = "_radius"
#: Exponent of a number that is known exactly.
EXACT = -128


def holds_radii(name: object, dataset: xr.Dataset) -> bool:
    """Whether a variable contains the radii of another one; `gyration_radius` does not."""
    stem = str(name).removesuffix(RADIUS)
    return stem != name and stem in dataset.variables


def is_exact(golden: xr.Dataset, name: str) -> bool:
    """Whether a variable is an axis of the grid or a parameter, a coordinate without dimensions."""
    return name in golden.dims or (name in golden.coords and golden[name].ndim == 0)


def radii(stored: npt.NDArray[Any]) -> Floats:
    """Radii from exponents; radii that are given as numbers are returned as they are."""
    if stored.dtype.kind == "f":
        return stored
    radius: Floats = np.where(stored == EXACT, 0.0, np.exp2(stored.astype(float)))
    return radius
