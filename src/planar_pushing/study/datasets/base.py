"""What the builders of the datasets share: axes as labelled arrays, a part for each set of effects."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr

from planar_pushing.mechanics.contact import ContactLaw
from planar_pushing.study.models import StudyFile


def axis(study: StudyFile, name: str) -> xr.DataArray:
    """An axis of the study's grid, with its own values as coordinate."""
    values = list(getattr(study.grid, name))
    return xr.DataArray(values, dims=name, coords={name: values}, name=name)


def law_axis(name: str, labels: Sequence[Any], laws: Sequence[ContactLaw]) -> xr.DataArray:
    """Contact laws along an axis with these labels."""
    values = np.empty(len(laws), dtype=object)
    values[:] = laws
    return xr.DataArray(values, dims=name, coords={name: list(labels)})


def over_effects(study: StudyFile, part: Callable[[tuple[Any, ...]], xr.Dataset]) -> xr.Dataset:
    """The parts of the grid's sets of effects, along the axis `effects`."""
    names = list(study.grid.effects)
    index = xr.Variable("effects", names)
    return xr.concat([part(study.effects(name)) for name in names], index)


def values(array: xr.DataArray, dims: Sequence[str]) -> npt.NDArray[Any]:
    """Numbers of an array with its dimensions in this order."""
    return np.asarray(array.transpose(*dims).values)


def parameters(study: StudyFile) -> dict[str, object]:
    """Slider and effects of the study, for the dataset's attributes."""
    return {"slider": study.slider, **study.parts}
