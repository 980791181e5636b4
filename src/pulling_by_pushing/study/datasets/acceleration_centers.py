"""Acceleration centers with friction and inertia under infinite friction (Sec. 4, Fig. 12)."""

from __future__ import annotations

import numpy as np
import xarray as xr

from planar_pushing.mechanics.contact import InfiniteFriction
from planar_pushing.mechanics.force.centers import conservative_motion_cone, motion_centers
from planar_pushing.mechanics.force.cones import motion_angle, motion_cone
from planar_pushing.mechanics.scene import Scene
from planar_pushing.terms.options import EffectSet
from pulling_by_pushing.study.datasets.base import axis, labeled_radians
from pulling_by_pushing.study.model import Part


def acceleration_centers(part: Part) -> xr.Dataset:
    """Build the dataset for part of a study; centers are relative to the contact."""
    scene = Scene(
        slider=part.ring(axis(part, "rod_length")),
        contact=InfiniteFriction(),
        effects=part.effects(EffectSet.BOTH),
    )
    phi, share = labeled_radians(axis(part, "force_angle")), axis(part, "inertia_share")
    center = motion_centers(scene, phi, share)
    bound, exact = conservative_motion_cone(scene), motion_cone(scene)
    return xr.Dataset(
        {
            "center_x": center.isel(xy=0, drop=True),
            "center_y": center.isel(xy=1, drop=True),
            "motion_angle": np.rad2deg(motion_angle(scene, phi, share)),
            "conservative_cone_right": np.rad2deg(bound.right),
            "conservative_cone_left": np.rad2deg(bound.left),
            "exact_cone_right": np.rad2deg(exact.right),
            "exact_cone_left": np.rad2deg(exact.left),
        }
    )
