"""Regions of possible acceleration centers: the paper's bound and the exact set (Sec. 4, Fig. 12)."""

from __future__ import annotations

import numpy as np
import xarray as xr

from planar_pushing.core.instant.directions import motion_center
from planar_pushing.mechanics.angles import RESOLUTION
from planar_pushing.mechanics.contact import InfiniteFriction
from planar_pushing.mechanics.force.centers import conservative_spin_ratios, motion_centers
from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.terms.options import EffectKind, EffectSet
from pulling_by_pushing.study.datasets.base import axis, labeled_radians
from pulling_by_pushing.study.model import Part

#: Ends of both regions along a line of force; the segment between them sweeps over the region.
BOUND_ENDS = ("inner", "outer")
EXACT_ENDS = (str(EffectKind.SUPPORT_FRICTION), str(EffectKind.INERTIA))


def _bound_ends(length: float, angle: float, force_angle: float) -> Array:
    """Ends of the paper's bound for one line of force, in radii from the contact, shape (end, xy)."""
    arm = length * np.sin(angle - force_angle)  # Eq. (10)
    # Rounding of the sine must not move a line that is tangent to the ring inside or outside.
    if abs(abs(arm) - 1.0) <= RESOLUTION * max(length, 1.0):
        arm = np.copysign(1.0, arm)
    outer, inner = conservative_spin_ratios(arm)
    rod, (x, y) = length * direction(angle), direction(force_angle).tolist()
    ends = np.array([rod + motion_center(x, y, float(ratio)) for ratio in (inner, outer)])
    # The center of a translation is at both ends of a line; choose the end that the region approaches.
    return np.where(np.isinf(ends) & (arm < 0), -ends, ends)


def center_regions(part: Part) -> xr.Dataset:
    """Build the dataset for part of a study: ends of both regions along every line of force."""
    slider = part.ring(axis(part, "rod_length"), axis(part, "rod_angle"))
    scene = Scene(slider=slider, contact=InfiniteFriction(), effects=part.effects(EffectSet.BOTH))
    phi = labeled_radians(axis(part, "force_angle"))
    bound = slider.radius * xr.apply_ufunc(
        np.vectorize(_bound_ends, signature="(),(),()->(e,c)"),
        *(slider.length_ratio, slider.rod_angle, phi),
        output_core_dims=[["bound_end", "xy"]],
    )
    exact = motion_centers(scene, phi, xr.DataArray([0.0, 1.0], dims="exact_end"))
    variables = {
        f"{name}_{across}": ends.isel(xy=i, drop=True)
        for name, ends in (("bound", bound), ("exact", exact))
        for i, across in enumerate("xy")
    }
    return xr.Dataset(variables, {"bound_end": list(BOUND_ENDS), "exact_end": list(EXACT_ENDS)})
