"""Limit curves over effects, rod length, rod angle and force angle (Eqs. 2-7, Figs. 5 and 10)."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.contact import InfiniteFriction
from planar_pushing.mechanics.limit_curve import limit_curve
from planar_pushing.mechanics.plane import direction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.study.datasets.base import axis, over_effects, parameters
from planar_pushing.study.describe import describe
from planar_pushing.study.files.models import StudyFile


def build(study: StudyFile) -> xr.Dataset:
    """Build the dataset of a study."""
    slider = study.ring(axis(study, "rod_length"), axis(study, "rod_angle"))
    phi = np.deg2rad(axis(study, "force_angle"))
    heading = xr.DataArray(direction(phi), dims=("force_angle", "xy"))

    def part(effects: tuple[Any, ...]) -> xr.Dataset:
        scene = Scene(slider=slider, contact=InfiniteFriction(), effects=effects)
        curve = limit_curve(scene, phi)
        return xr.Dataset(
            {
                "force": curve.force_size,
                "force_x": curve.force_size * heading[:, 0],
                "force_y": curve.force_size * heading[:, 1],
                "spin_ratio": curve.spin_ratio,
                "motion_angle": np.rad2deg(curve.motion_angle),
            }
        )

    return describe(
        over_effects(study, part),
        title="Limit curves: forces through the contact and the motions they cause",
        source="Eqs. (2)-(7), Sec. 3, Fig. 5, and the ellipses of Sec. 4, Fig. 10",
        parameters=parameters(study, "rod_angle"),
    )
