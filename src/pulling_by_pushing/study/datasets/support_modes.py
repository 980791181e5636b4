"""Consistent solutions over support, rod, friction coefficient and pusher angle (Secs. 2 and 3)."""

from __future__ import annotations

import xarray as xr

from planar_pushing.mechanics.solve import solve
from pulling_by_pushing.study.datasets.base import (
    axis,
    friction_angle,
    friction_axis,
    pushing,
    supported,
)
from pulling_by_pushing.study.model import Part


def build(part: Part) -> xr.Dataset:
    """Build the dataset for part of a study by `solve` on labeled arrays."""
    angles: xr.DataArray = pushing(axis(part, "pusher_angle"))
    found = solve(supported(part, friction_axis(part)), angles)
    angle = friction_angle(part.grid["friction_coefficient"])
    return found.assign_coords(friction_angle=("friction_coefficient", angle))
