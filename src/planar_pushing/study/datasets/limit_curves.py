"""Limit curves over effects, rod length, rod angle and force angle (Eqs. 2-7, Figs. 5 and 10)."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.contact import InfiniteFriction
from planar_pushing.mechanics.limit_curve import limit_curve
from planar_pushing.mechanics.planar import Array
from planar_pushing.mechanics.scene import Scene
from planar_pushing.study.blocks import in_blocks
from planar_pushing.study.catalog import AXES
from planar_pushing.study.datasets.base import Cell, assemble, axes, parameters
from planar_pushing.study.describe import describe
from planar_pushing.study.models import StudyFile

DIMS = AXES["limit_curves"]


def _curve(scene: Scene, force_angle: Array) -> Cell:
    curve = limit_curve(scene, force_angle)
    return {
        "force": curve.magnitude,
        "force_x": curve.force[:, 0],
        "force_y": curve.force[:, 1],
        "spin_ratio": curve.spin_ratio,
        "motion_angle": np.rad2deg(curve.motion_angle),
    }


def build(study: StudyFile) -> xr.Dataset:
    """Build the dataset of a study."""
    coords = axes(study, DIMS)
    phi = np.deg2rad(coords["force_angle"])

    def cell(effects: Any, length: float, angle: float) -> Cell:
        scene = Scene(
            slider=study.ring(length, angle),
            contact=InfiniteFriction(),
            effects=study.effects(effects),
        )
        return in_blocks(lambda angles: _curve(scene, angles), phi)

    return describe(
        assemble(coords, DIMS[:3], cell),
        title="Limit curves: forces through the contact and the motions they cause",
        source="Eqs. (2)-(7), Sec. 3, Fig. 5, and the ellipses of Sec. 4, Fig. 10",
        parameters=parameters(study),
    )
