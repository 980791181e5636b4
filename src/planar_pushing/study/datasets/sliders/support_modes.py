"""Consistent contact modes over support, rod, friction coefficient and pusher angle (Secs. 2 and 3)."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.solve import solve
from planar_pushing.study.catalog import DIMS
from planar_pushing.study.datasets.base import angles_of, axis, friction_angle, friction_axis
from planar_pushing.study.datasets.sliders.gallery import described, scenes
from planar_pushing.study.files.sliders_model import SlidersFile

MODES = DIMS["support_modes"]
VALUES = ("force_angle", "force_angle_end", "motion_angle", "spin")
#: What a value of a mode without a solution, or without a force, is.
COMMENT = "NaN where the mode is not consistent; 0 for SEPARATE, which has neither force nor motion"


def _values(found: xr.Dataset, extent: xr.DataArray) -> dict[str, Array]:
    """What every solution has, by its place along the axis `solution`."""
    spin = found.twist.isel(twist_component=2) * extent
    return {
        "force_angle": angles_of(found.force.values),
        "force_angle_end": angles_of(found.force_end.values),
        "motion_angle": angles_of(found.contact_motion.values),
        "spin": spin.transpose(*found.mode.dims).values,
        "pivot": found.pivot.values,
    }


def _of_mode(mode: ContactMode, found: Array, values: dict[str, Array]) -> dict[str, Any]:
    """What the solution of a mode has; of friction alone each mode has one at most."""
    here = found == mode
    exists, place = here.any(axis=-1), here.argmax(axis=-1)[..., None]
    picked = {
        name: np.take_along_axis(value, place, axis=-1)[..., 0] for name, value in values.items()
    }
    if mode == ContactMode.SEPARATE:
        picked |= {name: np.zeros_like(picked[name]) for name in VALUES}
    parts = {name: np.where(exists, picked[name], np.nan) for name in VALUES}
    pivot = np.where(exists, picked["pivot"], -1).astype(np.int16)
    return {"consistent": exists, **parts, "pivot": pivot}


def build(study: SlidersFile) -> xr.Dataset:
    """Build the dataset of a study."""
    scene = scenes(study, friction_axis(study))
    found = solve(scene, np.deg2rad(axis(study, "pusher_angle"))).transpose(*MODES[:-1], ...)
    values = _values(found, scene.slider.radius)
    modes = [_of_mode(mode, found.mode.values, values) for mode in ContactMode]
    variables: dict[str, Any] = {
        name: (MODES, np.stack([each[name] for each in modes], axis=-1)) for name in modes[0]
    }
    variables["outcome"] = (MODES[:-1], found.outcome.values)
    angle = ("friction_coefficient", friction_angle(study.grid.friction_coefficient))
    coords = {name: found[name] for name in MODES[:-1]} | {"friction_angle": angle}
    dataset = xr.Dataset(variables, coords | {"mode": [mode.name for mode in ContactMode]})
    dataset = described(
        dataset,
        study,
        title="Consistent contact modes of every support: none, one or several for each push",
        source="Secs. 2, 3.1 and 3.2, for any pressure distribution",
    )
    for name in VALUES:
        dataset[name].attrs["comment"] = COMMENT
    return dataset
