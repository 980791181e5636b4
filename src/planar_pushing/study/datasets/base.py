"""What the builders of the datasets share: axes as labeled arrays, a part for each set of effects."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr

from planar_pushing.mechanics.angles import RESOLUTION
from planar_pushing.mechanics.contact import ContactLaw
from planar_pushing.mechanics.plane import Array
from planar_pushing.study.files.models import StudyFile, contact_law
from planar_pushing.study.files.sliders_model import Study


def axis(study: Study, name: str) -> xr.DataArray:
    """An axis of the study's grid, with its own values as coordinate."""
    values = list(getattr(study.grid, name))
    return xr.DataArray(values, dims=name, coords={name: values}, name=name)


def law_axis(name: str, labels: Sequence[Any], laws: Sequence[ContactLaw]) -> xr.DataArray:
    """Contact laws along an axis with these labels."""
    values = np.empty(len(laws), dtype=object)
    values[:] = laws
    return xr.DataArray(values, dims=name, coords={name: list(labels)})


def friction_axis(study: Study) -> xr.DataArray:
    """The laws of the grid's coefficients of friction."""
    coefficients = list(study.grid.friction_coefficient)
    return law_axis("friction_coefficient", coefficients, list(map(contact_law, coefficients)))


def over_effects(study: StudyFile, part: Callable[[tuple[Any, ...]], xr.Dataset]) -> xr.Dataset:
    """The parts of the grid's sets of effects, along the axis `effects`."""
    names = list(study.grid.effects)
    index = xr.Variable("effects", names)
    return ordered(xr.concat([part(study.effects(name)) for name in names], index))


def ordered(dataset: xr.Dataset) -> xr.Dataset:
    """The same with its variables before its coordinates, and these in the order of the dimensions."""
    dims = next(iter(dataset.data_vars.values())).dims
    variables = {name: each.variable for name, each in dataset.data_vars.items()}
    return xr.Dataset(variables, {name: dataset[name] for name in dims if name in dataset.coords})


def parameters(study: StudyFile, *axes: str) -> dict[str, object]:
    """Slider and effects of the study, for the attributes of a dataset over these axes.

    What is an axis is no parameter; `figures` says where the figures cut it.
    """
    slider = study.slider.model_dump()
    cut = {name: slider.pop(name) for name in axes}
    return {"slider": slider, **study.parts} | ({"figures": cut} if cut else {})


def half_turn(degrees: xr.DataArray) -> xr.DataArray:
    """The angles, in radians, that push: those from 0 to 180 degrees."""
    pushing = degrees[(degrees >= 0) & (degrees <= 180)]
    return pushing.copy(data=np.deg2rad(pushing.values))


def friction_angle(coefficients: npt.ArrayLike) -> npt.NDArray[np.float64]:
    """Angles of friction in degrees: finite where the coefficient is infinite, NaN without one."""
    angles: npt.NDArray[np.float64] = np.arctan(np.asarray(coefficients, dtype=float))
    return np.degrees(angles)


def angles_of(vectors: npt.ArrayLike) -> Array:
    """Angles of vectors, shape S + (2,), in (-180, 180] degrees."""
    x, y = np.moveaxis(np.asarray(vectors, dtype=float), -1, 0)
    angle = np.arctan2(y, x)
    return np.rad2deg(np.where(angle <= -np.pi + RESOLUTION, np.pi, angle))
