"""Limit curves over effects, rod length, rod angle and force angle (Eqs. 2-7, Figs. 5 and 10)."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.contact import InfiniteFriction
from planar_pushing.mechanics.force.limit_curve import curve_of_unit_motions
from planar_pushing.mechanics.plane import direction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.slider import Slider
from pulling_by_pushing.study.datasets.base import axis, labeled_radians, over_effects
from pulling_by_pushing.study.model import Part


def limit_curves(part: Part) -> xr.Dataset:
    """Build the dataset for part of a study."""
    return _curves_of(part, part.ring(axis(part, "rod_length"), axis(part, "rod_angle")))


def curves(part: Part) -> xr.Dataset:
    """Build the dataset of fine lines, at the rod angle of the study (Figs. 5, 6 and 10)."""
    return _curves_of(part, part.ring(axis(part, "rod_length")))


def _curves_of(part: Part, slider: Slider) -> xr.Dataset:
    """Limit curves of a slider for all effects and force angles of part of a study."""
    phi = labeled_radians(axis(part, "force_angle"))
    heading = xr.DataArray(direction(phi.values), dims=("force_angle", "xy"))

    def curve_of(effects: tuple[Any, ...]) -> xr.Dataset:
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

    return over_effects(part, curve_of)
