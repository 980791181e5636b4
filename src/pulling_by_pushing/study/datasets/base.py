"""Axes as labeled arrays, effects and supports along them, and angles."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr

from planar_pushing.mechanics.contact import ContactLaw
from planar_pushing.mechanics.effects import SupportFriction
from planar_pushing.mechanics.scene import Scene, Slider
from planar_pushing.terms.numbers import in_radians
from pulling_by_pushing.study.model import Part, contact_law


def axis(part: Part, name: str) -> xr.DataArray:
    """An axis of the grid, with its values as the coordinate."""
    values = list(part.grid[name])
    return xr.DataArray(values, dims=name, coords={name: values}, name=name)


def objects(name: str, labels: Iterable[Any], values: Iterable[Any]) -> xr.DataArray:
    """Objects along a labeled axis, such as contact laws or supports."""
    listed = list(values)
    array = np.empty(len(listed), dtype=object)
    array[:] = listed
    return xr.DataArray(array, dims=name, coords={name: list(labels)})


def friction_axis(part: Part) -> xr.DataArray:
    """Contact laws for the grid's friction coefficients."""
    coefficients = part.grid["friction_coefficient"]
    return objects("friction_coefficient", coefficients, map(contact_law, coefficients))


def support_axis(supports: Mapping[str, Any]) -> xr.DataArray:
    """Supports along the axis `support`."""
    return objects("support", supports, supports.values())


def supported(part: Part, contact: xr.DataArray | ContactLaw) -> Scene:
    """Scene with every support and rod of the grid under one or more contact laws; the weight is 1."""
    slider = Slider(
        rod_length=axis(part, "rod_length"), rod_angle=np.deg2rad(axis(part, "rod_angle"))
    )
    friction = SupportFriction(support=support_axis(part.gallery()))
    return Scene(slider=slider, contact=contact, effects=(friction,))


def over_effects(part: Part, build: Callable[[tuple[Any, ...]], xr.Dataset]) -> xr.Dataset:
    """Combine the datasets for the grid's sets of effects along the axis `effects`."""
    names = list(part.grid["effects"])
    found = [build(part.effects(name)) for name in names]
    return xr.concat(found, xr.Variable("effects", names))


def pushing(degrees: xr.DataArray) -> xr.DataArray:
    """Angles in radians, labeled in degrees."""
    return degrees.copy(data=in_radians(degrees.values))


def friction_angle(coefficients: npt.ArrayLike) -> npt.NDArray[np.float64]:
    """Friction angles in degrees; 90 for an infinite coefficient, NaN for a NaN coefficient."""
    angles: npt.NDArray[np.float64] = np.arctan(np.asarray(coefficients, dtype=float))
    return np.degrees(angles)


def words(name: str) -> str:
    """Name of a support in prose: rectangle_2_1 is "rectangle 2:1", l_shape "L shape"."""
    parts = re.sub(r"(\d)_(?=\d)", r"\1:", name).split("_")
    return " ".join(part.upper() if len(part) == 1 else part for part in parts)
