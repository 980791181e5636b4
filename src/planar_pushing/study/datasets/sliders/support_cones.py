"""Motion cones over support, rod length, rod angle and friction coefficient (Secs. 3.1 and 3.2)."""

from __future__ import annotations

import numpy as np
import xarray as xr

from planar_pushing.mechanics.cones import leaves_the_fence, motion_cone, omits_pushes
from planar_pushing.mechanics.contact import PerfectlyRough
from planar_pushing.mechanics.solve import solve
from planar_pushing.study.catalog import DIMS
from planar_pushing.study.datasets.base import friction_angle, friction_axis
from planar_pushing.study.datasets.sliders.gallery import described, scenes
from planar_pushing.study.files.sliders_model import SlidersFile

EDGES = ["right", "left"]


def pivots(study: SlidersFile, angle: xr.DataArray) -> xr.DataArray:
    """Number of the support point that a contact which moves at an angle, in radians, turns about.

    Of a perfectly rough contact every motion is a stick.
    """
    pivot: xr.DataArray = solve(scenes(study, PerfectlyRough()), angle).pivot
    return pivot.max("solution").astype(np.int16)


def build(study: SlidersFile) -> xr.Dataset:
    """Build the dataset of a study."""
    laws = friction_axis(study)
    scene = scenes(study, laws)
    cone = motion_cone(scene)
    edges = xr.concat([cone.right, cone.left], xr.Variable("edge", EDGES))
    dataset = xr.Dataset(
        {
            "motion_angle": np.rad2deg(edges),
            "pivot": pivots(study, edges),
            "width": np.rad2deg(cone.left - cone.right),
            "pulls": leaves_the_fence(cone),
            "slips_while_pushing": scene.law.slips & omits_pushes(cone),
        }
    ).transpose(*DIMS["support_cones"])
    angle = ("friction_coefficient", friction_angle(study.grid.friction_coefficient))
    return described(
        dataset.assign_coords(friction_angle=angle),
        study,
        title="Motion cones of every support, and what their edges pivot about",
        source="Secs. 3.1 and 3.2, for any pressure distribution",
    )
