"""What the datasets of a study of sliders share: the supports as an axis, and the scenes over the grid."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.effects import SupportFriction
from planar_pushing.mechanics.scene import Scene, Slider
from planar_pushing.study.datasets.base import axis
from planar_pushing.study.describe import describe
from planar_pushing.study.files.sliders_model import SlidersFile
from planar_pushing.terms.quantities import SLIDERS, SLIDERS_NOTES


def words(name: str) -> str:
    """Name of a support in prose: rectangle_2_1 is "rectangle 2:1", l_shape "L shape"."""
    parts = re.sub(r"(\d)_(?=\d)", r"\1:", name).split("_")
    return " ".join(part.upper() if len(part) == 1 else part for part in parts)


def support_axis(supports: dict[str, Any]) -> xr.DataArray:
    """Supports along the axis `support`, with their names as coordinate."""
    values = np.empty(len(supports), dtype=object)
    values[:] = list(supports.values())
    return xr.DataArray(values, dims="support", coords={"support": list(supports)})


def scenes(study: SlidersFile, contact: Any) -> Scene:
    """Every support of the study on every rod of its grid, with this law or these laws."""
    slider = Slider(
        rod_length=axis(study, "rod_length"), rod_angle=np.deg2rad(axis(study, "rod_angle"))
    )
    friction = SupportFriction(support=support_axis(study.gallery()))
    return Scene(slider=slider, contact=contact, effects=(friction,))


def described(dataset: xr.Dataset, study: SlidersFile, *, title: str, source: str) -> xr.Dataset:
    """Give a dataset its units and names; the supports are its parameters."""
    entries = {name: entry.model_dump(exclude_none=True) for name, entry in study.supports.items()}
    return describe(
        dataset,
        title=title,
        source=source,
        parameters={"supports": entries},
        quantities=SLIDERS,
        notes=SLIDERS_NOTES,
    )
