"""Motion cones over effects, rod length, rod angle and friction coefficient (Figs. 6, 7 and 9)."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.force.cones import (
    friction_cone,
    leaves_the_fence,
    motion_cone,
    omits_pushes,
)
from planar_pushing.mechanics.force.limit_curve import curve_of_unit_motions
from planar_pushing.mechanics.scene import Scene
from pulling_by_pushing.study.datasets.base import axis, friction_angle, friction_axis, over_effects
from pulling_by_pushing.study.model import Part


def motion_cones(part: Part) -> xr.Dataset:
    """Build the dataset for part of a study."""
    slider = part.ring(axis(part, "rod_length"), axis(part, "rod_angle"))
    laws = friction_axis(part)

    def cones(effects: tuple[Any, ...]) -> xr.Dataset:
        scene = Scene(slider=slider, contact=laws, effects=effects)
        force, cone = friction_cone(scene), motion_cone(scene)
        zeros = xr.zeros_like(cone.right)
        right: xr.DataArray = force.right
        left: xr.DataArray = force.left
        return xr.Dataset(
            {
                "friction_cone_right": np.rad2deg(right) + zeros,
                "friction_cone_left": np.rad2deg(left) + zeros,
                "motion_cone_right": np.rad2deg(cone.right),
                "motion_cone_left": np.rad2deg(cone.left),
                "limit_force_right": curve_of_unit_motions(scene, right).magnitude,
                "limit_force_left": curve_of_unit_motions(scene, left).magnitude,
                "pulls": leaves_the_fence(cone),
                "slips_while_pushing": scene.law.slips & omits_pushes(cone),
            }
        )

    angle = friction_angle(part.grid["friction_coefficient"])
    return over_effects(part, cones).assign_coords(friction_angle=("friction_coefficient", angle))
