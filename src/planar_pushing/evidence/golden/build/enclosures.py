"""Stored enclosures: a number is `name` plus `name_low`, with the radius `name_radius`."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
import xarray as xr


def golden_variables(golden: xr.Dataset) -> list[str]:
    """Variables that a golden file certifies, without their low parts and radii."""
    names = [str(name) for name in golden.data_vars]
    parts = {f"{name}{part}" for name in names for part in ("_low", "_radius")}
    return [name for name in names if name not in parts]


def disjoint(name: str, new: xr.Dataset, stored: xr.Dataset) -> npt.NDArray[np.bool_]:
    """Where the enclosures of a variable in two golden files do not overlap."""
    if f"{name}_low" not in new:
        return np.asarray(new[name].values != stored[name].values)
    high, low, radius = (name, f"{name}_low", f"{name}_radius")
    with np.errstate(invalid="ignore"):
        gap = np.abs(
            new[high].values - stored[high].values + (new[low].values - stored[low].values)
        )
    same = new[high].values == stored[high].values
    same |= np.isnan(new[high].values) & np.isnan(stored[high].values)
    infinite = same & ~np.isfinite(new[high].values)
    return np.asarray(~infinite & ~(gap <= new[radius].values + stored[radius].values))
