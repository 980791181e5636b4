"""Acceleration centres with friction and inertia under infinite friction (Sec. 4, Fig. 12)."""

from __future__ import annotations

import numpy as np
import xarray as xr

from planar_pushing.mechanics.centers import conservative_motion_cone
from planar_pushing.mechanics.cones import motion_angle, motion_cone, spin_ratio
from planar_pushing.mechanics.contact import InfiniteFriction
from planar_pushing.mechanics.planar import motion_center
from planar_pushing.mechanics.scene import Scene
from planar_pushing.study.catalog import AXES
from planar_pushing.study.datasets.base import Cell, assemble, axes, parameters
from planar_pushing.study.describe import describe
from planar_pushing.study.models import StudyFile

DIMS = AXES["acceleration_centers"]


def build(study: StudyFile) -> xr.Dataset:
    """Build the dataset of a study."""
    coords = axes(study, DIMS)
    coords["force_angle"] = [angle for angle in coords["force_angle"] if 0 <= angle <= 180]
    phi, share = np.deg2rad(coords["force_angle"])[:, None], np.array(coords["inertia_share"])

    def cell(length: float) -> Cell:
        scene = Scene(
            slider=study.ring(length),
            contact=InfiniteFriction(),
            effects=study.effects("support_friction+inertia"),
        )
        k = spin_ratio(scene, phi, share)
        center = motion_center(phi, k, 0.0, scene.slider.rod_angle, scene.slider.radius)
        bound, exact = conservative_motion_cone(scene), motion_cone(scene)
        return {
            "center_x": center[..., 0],
            "center_y": center[..., 1],
            "motion_angle": np.rad2deg(motion_angle(scene, phi, share)),
            "conservative_cone_right": np.rad2deg(bound.right),
            "conservative_cone_left": np.rad2deg(bound.left),
            "exact_cone_right": np.rad2deg(exact.right),
            "exact_cone_left": np.rad2deg(exact.left),
        }

    return describe(
        assemble(coords, ("rod_length",), cell),
        title="Acceleration centres and cones with support friction and inertia",
        source="Sec. 4, Fig. 12: the paper's conservative bound and the exact set",
        parameters=parameters(study),
    )
