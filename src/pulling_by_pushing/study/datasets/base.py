"""Axes as labeled arrays, effects and supports along them, and angles."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr

from planar_pushing.terms.numbers import in_radians
from pulling_by_pushing.study.model import Part, contact_law


def axis(part: Part, name: str) -> xr.DataArray:
    """An axis of the grid, with its values as the coordinate."""
    values = list(part.grid[name])
    return xr.DataArray(values, dims=name, coords={name: values}, name=name)


def objects(name: str, labels: Iterable[Any], values: Iterable[Any]) -> xr.DataArray:
    """Objects along a labeled axis, such as contact laws or supports."""
    instances = list(values)
    array = np.empty(len(instances), dtype=object)
    array[:] = instances
    return xr.DataArray(array, dims=name, coords={name: list(labels)})


def friction_axis(part: Part) -> xr.DataArray:
    """Contact laws for the grid's friction coefficients."""
    coefficients = part.grid["friction_coefficient"]
    return objects("friction_coefficient", coefficients, map(contact_law, coefficients))


def over_effects(part: Part, build: Callable[[tuple[Any, ...]], xr.Dataset]) -> xr.Dataset:
    """Combine the datasets for the grid's sets of effects along the axis `effects`."""
    names = list(part.grid["effects"])
    datasets = [build(part.effects(name)) for name in names]
    return xr.concat(datasets, xr.Variable("effects", names))


def labeled_radians(degrees: xr.DataArray) -> xr.DataArray:
    """Angles in radians, labeled in degrees."""
    return degrees.copy(data=in_radians(degrees.values))


def friction_angle(coefficients: npt.ArrayLike) -> npt.NDArray[np.float64]:
    """Friction angles in degrees; 90 for an infinite coefficient, NaN for a NaN coefficient."""
    angles: npt.NDArray[np.float64] = np.arctan(np.asarray(coefficients, dtype=float))
    return np.degrees(angles)
