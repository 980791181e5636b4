"""Wrench of each support over centers of rotation, and the ellipsoid by which planners approximate it."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.effects import SupportFriction
from planar_pushing.mechanics.entries import to_json
from planar_pushing.mechanics.force.wrench import potential, wrench
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.supports import EllipsoidFit, fit_ellipsoid
from planar_pushing.terms.quantities import TWIST
from pulling_by_pushing.study.datasets.base import axis
from pulling_by_pushing.study.model import Part

OVER_CENTERS = ("support", "center_x", "center_y")
#: Components of a wrench, and units of the components of motions and of wrenches per unit weight.
WRENCH, WRENCH_UNITS, MOTION_UNITS = (
    ("f_x", "f_y", "tau"),
    ("1", "1", "length"),
    ("1", "1", "1/length"),
)
#: Angular errors of the ellipsoid.
ERRORS = ("worst_force_error", "mean_force_error", "worst_motion_error", "mean_motion_error")


def rotations(part: Part) -> Array:
    """Twists of unit counterclockwise rotation about every center of the grid, shape S + (3,)."""
    x, y = np.meshgrid(part.grid["center_x"], part.grid["center_y"], indexing="ij")
    return np.stack([y, -x, np.ones_like(x)], axis=-1)


def _over_centers(supports: list[Any], twists: Array) -> dict[str, Any]:
    effects = [SupportFriction(support=support) for support in supports]
    wrenches = np.stack([wrench(effect, twists) for effect in effects])
    return {
        "mean_distance": (
            OVER_CENTERS,
            np.stack([potential(effect, twists) for effect in effects]),
        ),
        "force_x": (OVER_CENTERS, wrenches[..., 0]),
        "force_y": (OVER_CENTERS, wrenches[..., 1]),
        "torque": (OVER_CENTERS, wrenches[..., 2]),
    }


def _ellipsoids(fits: list[EllipsoidFit]) -> dict[str, Any]:
    angles = {name: np.rad2deg([getattr(fit, name) for fit in fits]) for name in ERRORS}
    return {
        "center_of_pressure_x": ("support", [fit.center[0] for fit in fits]),
        "center_of_pressure_y": ("support", [fit.center[1] for fit in fits]),
        "extent": ("support", [fit.extent for fit in fits]),
        "integration_constant": ("support", [fit.integration_constant for fit in fits]),
        "ellipsoid": (
            ("support", "twist_component", "wrench_component"),
            np.stack([fit.matrix for fit in fits]),
        ),
        **{name: ("support", values) for name, values in angles.items()},
    }


def supports(part: Part) -> xr.Dataset:
    """Build the dataset for part of a study; the weight is 1."""
    supports = list(part.gallery().values())
    entries = [entry.model_dump(exclude_none=True) for entry in part.supports.values()]
    return xr.Dataset(
        _over_centers(supports, rotations(part)) | _ellipsoids(list(map(fit_ellipsoid, supports))),
        {
            "support": list(part.supports),
            "description": ("support", list(map(to_json, entries))),
            "center_x": axis(part, "center_x"),
            "center_y": axis(part, "center_y"),
            "twist_component": list(TWIST),
            "twist_unit": ("twist_component", list(MOTION_UNITS)),
            "wrench_component": list(WRENCH),
            "wrench_unit": ("wrench_component", list(WRENCH_UNITS)),
        },
    )
