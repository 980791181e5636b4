"""What the builders of the datasets share: axes from the grid, and cells stacked over them."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from typing import Any

import numpy as np
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
    """Evaluate `cell` at each point of the outer axes and stack the variables over all axes."""
    cells = [cell(*point) for point in itertools.product(*(coords[name] for name in outer))]
    shape = tuple(len(coords[name]) for name in outer)
    inner = tuple(name for name in coords if name not in outer)
    variables = {}
    for name in cells[0]:
        values = np.stack([np.asarray(each[name]) for each in cells])
        variables[name] = (
            outer + inner[: values.ndim - 1],
            values.reshape(shape + values.shape[1:]),
        )
    return xr.Dataset(variables, coords=coords)
