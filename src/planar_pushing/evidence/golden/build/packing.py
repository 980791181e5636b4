"""Certified values as arrays and datasets: nested lists of balls or integers, with units by name."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr
from flint import arb

from planar_pushing.certified.balls import pack, precise
from planar_pushing.evidence.golden.build.marks import marks, provenance

#: An enclosure of zero below this size is one of a number that vanishes by symmetry.
NOTHING = 1e-40
#: Numbers that are exact: flags, which Python counts among the integers, before these.
KINDS = (bool, int)
#: Name: dims and values, nested lists of balls or integers.
Values = dict[str, tuple[tuple[str, ...], Any]]


def _packed(ball: arb) -> tuple[float, float, float]:
    """Midpoint and radius; a number that vanishes by symmetry is stored as zero and its radius."""
    if math.isnan(float(ball.mid())):
        return math.nan, 0.0, 0.0
    if ball.is_finite() and ball.contains(0) and ball.abs_upper() < NOTHING:
        return 0.0, 0.0, float(ball.abs_upper()) * 2
    return pack(ball)


def parts(name: str, nested: Any) -> dict[str, npt.NDArray[Any]]:
    """Arrays by name: midpoint, low part and radius of balls; integers and numbers as they are."""
    array = np.array(nested, dtype=object)
    flat = array.ravel().tolist()
    if not any(isinstance(each, arb) for each in flat):
        kind = next((each for each in KINDS if all(isinstance(one, each) for one in flat)), float)
        return {name: array.astype(np.int8 if kind is int else kind)}
    packed = np.array([_packed(each) for each in flat]).reshape((*array.shape, 3))
    names = (name, f"{name}_low", f"{name}_radius")
    return dict(zip(names, np.moveaxis(packed, -1, 0), strict=True))


@precise
def certified(values: Values, coords: Mapping[str, Any], title: str) -> xr.Dataset:
    """Dataset of values with the midpoint, its low part and the radius of each ball."""
    dataset = xr.Dataset(coords=dict(coords))
    for name, (dims, nested) in values.items():
        for part, array in parts(name, nested).items():
            dataset[part] = (dims, array, marks(part))
    for axis in dataset.coords:
        dataset[axis].attrs = marks(str(axis))
    dataset.attrs = provenance(title)
    return dataset
