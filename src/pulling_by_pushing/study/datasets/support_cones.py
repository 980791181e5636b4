"""Motion cones over support, rod length, rod angle and friction coefficient (Secs. 3.1 and 3.2)."""

from __future__ import annotations

import numpy as np
import xarray as xr

from planar_pushing.mechanics.contact import PerfectlyRough
from planar_pushing.mechanics.force.cones import leaves_the_fence, motion_cone, omits_pushes
from planar_pushing.mechanics.solve import solve
from pulling_by_pushing.study.datasets.base import friction_angle, friction_axis, supported
from pulling_by_pushing.study.model import Part

EDGES = ["right", "left"]


def pivots(part: Part, angle: xr.DataArray) -> xr.DataArray:
    """Number of the support point about which the slider pivots if its contact moves at an angle, radians.

    The contact is perfectly rough, so that it sticks for every motion.
    """
    pivot: xr.DataArray = solve(supported(part, PerfectlyRough()), angle).pivot
    return pivot.max("solution").astype(np.int16)


def build(part: Part) -> xr.Dataset:
    """Build the dataset for part of a study."""
    scene = supported(part, friction_axis(part))
    cone = motion_cone(scene)
    both: list[xr.DataArray] = [cone.right, cone.left]
    edges = xr.concat(both, xr.Variable("edge", EDGES))
    angle = friction_angle(part.grid["friction_coefficient"])
    return xr.Dataset(
        {
            "motion_angle": np.rad2deg(edges),
            "pivot": pivots(part, edges),
            "width": np.rad2deg(cone.left - cone.right),
            "pulls": leaves_the_fence(cone),
            "slips_while_pushing": scene.law.slips & omits_pushes(cone),
        },
        {"friction_angle": ("friction_coefficient", angle)},
    )
