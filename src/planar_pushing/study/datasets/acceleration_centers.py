"""Acceleration centers with friction and inertia under infinite friction (Sec. 4, Fig. 12)."""

from __future__ import annotations

import numpy as np
import xarray as xr

from planar_pushing.mechanics.centers import conservative_motion_cone, motion_centers
from planar_pushing.mechanics.cones import motion_angle, motion_cone
from planar_pushing.mechanics.contact import InfiniteFriction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.study.datasets.base import axis, half_turn, ordered, parameters
from planar_pushing.study.describe import describe
from planar_pushing.study.files.models import StudyFile
from planar_pushing.terms.options import EffectSet


def build(study: StudyFile) -> xr.Dataset:
    """Build the dataset of a study; centers are relative to the contact."""
    scene = Scene(
        slider=study.ring(axis(study, "rod_length")),
        contact=InfiniteFriction(),
        effects=study.effects(EffectSet.BOTH),
    )
    phi = half_turn(axis(study, "force_angle"))
    share = axis(study, "inertia_share")
    center = motion_centers(scene, phi, share)
    bound, exact = conservative_motion_cone(scene), motion_cone(scene)
    dataset = xr.Dataset(
        {
            "center_x": center.isel(xy=0),
            "center_y": center.isel(xy=1),
            "motion_angle": np.rad2deg(motion_angle(scene, phi, share)),
            "conservative_cone_right": np.rad2deg(bound.right),
            "conservative_cone_left": np.rad2deg(bound.left),
            "exact_cone_right": np.rad2deg(exact.right),
            "exact_cone_left": np.rad2deg(exact.left),
        }
    )
    return describe(
        ordered(dataset.transpose("rod_length", "force_angle", "inertia_share")),
        title="Acceleration centres and cones with support friction and inertia",
        source="Sec. 4, Fig. 12: the paper's conservative bound and the exact set",
        parameters=parameters(study),
    )
