"""What the builders of the datasets share: axes from the grid, and cells evaluated over them."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr

from planar_pushing.study.models import StudyFile

#: Variables of one point of the outer axes, each scalar or over the inner axes.
Cell = dict[str, Any]


def axes(study: StudyFile, names: tuple[str, ...]) -> dict[str, list[Any]]:
    """Axes of the study's grid as coordinates."""
    return {name: list(getattr(study.grid, name)) for name in names}


def parameters(study: StudyFile) -> dict[str, object]:
    """Slider and effects of the study, for the dataset's attributes."""
    return {"slider": study.slider, **study.parts}


def assemble(
    coords: dict[str, list[Any]], outer: tuple[str, ...], cell: Callable[..., Cell]
) -> xr.Dataset:
    """Evaluate `cell` at each point of the outer axes and fill the variables over all axes."""
    shape = tuple(len(coords[name]) for name in outer)
    inner = tuple(name for name in coords if name not in outer)
    variables: dict[str, tuple[tuple[str, ...], npt.NDArray[Any]]] = {}
    points = itertools.product(*(coords[name] for name in outer))
    for place, point in zip(np.ndindex(shape), points, strict=True):
        for name, value in cell(*point).items():
            one = np.asarray(value)
            if name not in variables:
                whole = np.empty(shape + one.shape, dtype=one.dtype)
                variables[name] = outer + inner[: one.ndim], whole
            variables[name][1][place] = one
    return xr.Dataset(variables, coords=coords)
