"""Certified values as datasets: nested lists of balls, integers or labels, with units by name."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import xarray as xr
from flint import arb

from planar_pushing.certified.balls import pack, precise
from planar_pushing.evidence.golden.build.marks import marks, provenance

#: An enclosure of zero below this size is one of a number that vanishes by symmetry.
NOTHING = 1e-40
#: Name: dims and values, nested lists of balls or integers.
Values = dict[str, tuple[tuple[str, ...], Any]]


def _packed(ball: arb) -> tuple[float, float, float]:
    """Midpoint and radius; a number that vanishes by symmetry is stored as zero and its radius."""
    if ball.is_finite() and ball.contains(0) and ball.abs_upper() < NOTHING:
        return 0.0, 0.0, float(ball.abs_upper()) * 2
    return pack(ball)


@precise
def certified(values: Values, coords: Mapping[str, Any], title: str) -> xr.Dataset:
    """Dataset of values with the midpoint, its low part and the radius of each ball."""
    dataset = xr.Dataset(coords=dict(coords))
    for name, (dims, nested) in values.items():
        array = np.array(nested, dtype=object)
        if not any(isinstance(each, arb) for each in array.ravel()):
            kind = np.int8 if all(isinstance(each, int) for each in array.ravel()) else float
            dataset[name] = (dims, array.astype(kind), marks(name))
            continue
        packed = np.array([_packed(each) for each in array.ravel()]).reshape((*array.shape, 3))
        for i, part in enumerate((name, f"{name}_low", f"{name}_radius")):
            dataset[part] = (dims, packed[..., i], marks(part))
    for axis in dataset.coords:
        dataset[axis].attrs = marks(str(axis))
    dataset.attrs = provenance(title)
    return dataset
