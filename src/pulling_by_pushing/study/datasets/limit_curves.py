"""Limit curves over effects, rod length, rod angle and force angle (Eqs. 2-7, Figs. 5 and 10)."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.contact import InfiniteFriction
from planar_pushing.mechanics.force.limit_curve import curve_of_unit_motions
from planar_pushing.mechanics.plane import direction
from planar_pushing.mechanics.scene import Scene
from pulling_by_pushing.study.datasets.base import axis, over_effects, pushing
from pulling_by_pushing.study.model import Part


def build(part: Part) -> xr.Dataset:
    """Build the dataset for part of a study."""
    slider = part.ring(axis(part, "rod_length"), axis(part, "rod_angle"))
    phi = pushing(axis(part, "force_angle"))
    heading = xr.DataArray(direction(phi.values), dims=("force_angle", "xy"))

    def curves(effects: tuple[Any, ...]) -> xr.Dataset:
        scene = Scene(slider=slider, contact=InfiniteFriction(), effects=effects)
        curve = curve_of_unit_motions(scene, phi)
        return xr.Dataset(
            {
                "force": curve.magnitude,
                "force_x": curve.magnitude * heading[:, 0],
                "force_y": curve.magnitude * heading[:, 1],
                "spin_ratio": curve.spin_ratio,
                "motion_angle": np.rad2deg(curve.motion_angle),
            }
        )

    return over_effects(part, curves)
