"""Motion cones over effects, rod length, rod angle and friction coefficient (Figs. 6, 7 and 9)."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.cones import can_pull, friction_cone, motion_cone, slips_while_pushing
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

    def cell(effects: Any, length: float, angle: float, mu: float) -> Cell:
        scene = Scene(
            slider=study.ring(length, angle),
            contact=contact_law(mu),
            effects=study.effects(effects),
        )
        forces, motions = friction_cone(scene), motion_cone(scene)
        magnitude = limit_curve(scene, [forces.right, forces.left]).magnitude
        return {
            "friction_cone_right": np.rad2deg(forces.right),
            "friction_cone_left": np.rad2deg(forces.left),
            "motion_cone_right": np.rad2deg(motions.right),
            "motion_cone_left": np.rad2deg(motions.left),
            "limit_force_right": magnitude[0],
            "limit_force_left": magnitude[1],
            "pulls": np.int8(can_pull(scene)),
            "slips_while_pushing": np.int8(slips_while_pushing(scene)),
        }

    return describe(
        assemble(coords, DIMS, cell),
        title="Friction cones and the motion cones they map to",
        source="Secs. 3.1, 3.2 and 4, Figs. 6, 7 and 9",
        parameters=parameters(study),
    )
