"""Motion cones over effects, rod length, rod angle and friction coefficient (Figs. 6, 7 and 9)."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.cones import leaves_the_fence, motion_cones, omits_pushes
from planar_pushing.mechanics.limit_curve import limit_curve
from planar_pushing.mechanics.scene import Scene
from planar_pushing.study.catalog import AXES
from planar_pushing.study.datasets.base import Cell, assemble, axes, parameters
from planar_pushing.study.describe import describe
from planar_pushing.study.models import StudyFile, contact_law

DIMS = AXES["motion_cones"]


def build(study: StudyFile) -> xr.Dataset:
    """Build the dataset of a study."""
    coords = axes(study, DIMS)
    laws = [contact_law(mu) for mu in coords["friction_coefficient"]]
    forces = np.array([[law.force_angles.right, law.force_angles.left] for law in laws])

    def cell(effects: Any, length: float, angle: float) -> Cell:
        scene = Scene(
            slider=study.ring(length, angle), contact=laws[0], effects=study.effects(effects)
        )
        cones = motion_cones(scene, laws)
        magnitude = limit_curve(scene, forces).magnitude
        slips = [law.slips and omits_pushes(cone) for law, cone in zip(laws, cones, strict=True)]
        return {
            "friction_cone_right": np.rad2deg(forces[:, 0]),
            "friction_cone_left": np.rad2deg(forces[:, 1]),
            "motion_cone_right": np.rad2deg([cone.right for cone in cones]),
            "motion_cone_left": np.rad2deg([cone.left for cone in cones]),
            "limit_force_right": magnitude[:, 0],
            "limit_force_left": magnitude[:, 1],
            "pulls": np.array([leaves_the_fence(cone) for cone in cones], np.int8),
            "slips_while_pushing": np.array(slips, np.int8),
        }

    return describe(
        assemble(coords, DIMS[:3], cell),
        title="Friction cones and the motion cones they map to",
        source="Secs. 3.1, 3.2 and 4, Figs. 6, 7 and 9",
        parameters=parameters(study),
    )
