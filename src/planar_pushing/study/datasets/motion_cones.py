"""Motion cones over effects, rod length, rod angle and friction coefficient (Figs. 6, 7 and 9)."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.cones import (
    friction_cone,
    leaves_the_fence,
    motion_cone,
    omits_pushes,
)
from planar_pushing.mechanics.limit_curve import limit_curve
from planar_pushing.mechanics.scene import Scene
from planar_pushing.study.datasets.base import (
    axis,
    friction_angle,
    friction_axis,
    over_effects,
    parameters,
)
from planar_pushing.study.describe import describe
from planar_pushing.study.files.models import StudyFile


def build(study: StudyFile) -> xr.Dataset:
    """Build the dataset of a study."""
    slider = study.ring(axis(study, "rod_length"), axis(study, "rod_angle"))
    laws = friction_axis(study)

    def part(effects: tuple[Any, ...]) -> xr.Dataset:
        scene = Scene(slider=slider, contact=laws, effects=effects)
        force, cone = friction_cone(scene), motion_cone(scene)
        whole = xr.zeros_like(cone.right)
        found = {
            "friction_cone_right": np.rad2deg(force.right) + whole,
            "friction_cone_left": np.rad2deg(force.left) + whole,
            "motion_cone_right": np.rad2deg(cone.right),
            "motion_cone_left": np.rad2deg(cone.left),
            "limit_force_right": limit_curve(scene, force.right).force_size,
            "limit_force_left": limit_curve(scene, force.left).force_size,
            "pulls": leaves_the_fence(cone),
            "slips_while_pushing": scene.law.slips & omits_pushes(cone),
        }
        return xr.Dataset(found).transpose(*cone.right.dims)

    angle = ("friction_coefficient", friction_angle(study.grid.friction_coefficient))
    return describe(
        over_effects(study, part).assign_coords(friction_angle=angle),
        title="Friction cones and the motion cones they map to",
        source="Secs. 3.1, 3.2 and 4, Figs. 6, 7 and 9",
        parameters=parameters(study, "rod_angle"),
    )
