"""Builders of the datasets over the study's grid: limit curves, motion cones, acceleration centres."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.centers import conservative_motion_cone
from planar_pushing.mechanics.cones import (
    can_pull,
    friction_cone,
    motion_angle,
    motion_cone,
    slips_while_pushing,
    spin_ratio,
)
from planar_pushing.mechanics.contact import InfiniteFriction
from planar_pushing.mechanics.limit_curve import limit_curve
from planar_pushing.mechanics.planar import Array, motion_center
from planar_pushing.mechanics.scene import Scene
from planar_pushing.study.describe import describe
from planar_pushing.study.models import StudyFile, contact_law

Cell = dict[str, Any]


def _grid(study: StudyFile, names: tuple[str, ...]) -> dict[str, list[Any]]:
    return {name: list(getattr(study.grid, name)) for name in names}


def _parameters(study: StudyFile) -> dict[str, object]:
    return {"slider": study.slider, "support_friction": study.support_friction, "inertia": study.inertia}


def _assemble(coords: dict[str, Any], cells: list[Cell], outer: tuple[str, ...]) -> xr.Dataset:
    """Stack cells, one for each point of the outer axes, into variables over all axes."""
    shape = tuple(len(coords[name]) for name in outer)
    inner = tuple(name for name in coords if name not in outer)
    variables = {}
    for name in cells[0]:
        values = np.stack([np.asarray(cell[name]) for cell in cells])
        variables[name] = (outer + inner[: values.ndim - 1], values.reshape(shape + values.shape[1:]))
    return xr.Dataset(variables, coords=coords)


def limit_curves(study: StudyFile) -> xr.Dataset:
    """Limit curves over effects, rod length, rod angle and force angle (Eqs. 2-7, Fig. 5)."""
    outer = ("effects", "rod_length", "rod_angle")
    coords = _grid(study, (*outer, "force_angle"))
    phi = np.deg2rad(coords["force_angle"])

    def cell(effects: Any, length: float, angle: float) -> Cell:
        scene = Scene(
            slider=study.ring(length, angle),
            contact=InfiniteFriction(),
            effects=study.effects(effects),
        )
        curve = limit_curve(scene, phi)
        return {
            "force": curve.magnitude,
            "force_x": curve.force[:, 0],
            "force_y": curve.force[:, 1],
            "spin_ratio": curve.spin_ratio,
            "motion_angle": np.rad2deg(curve.motion_angle),
        }

    cells = [cell(*point) for point in itertools.product(*(coords[name] for name in outer))]
    return describe(
        _assemble(coords, cells, outer),
        title="Limit curves: forces through the contact and the motions they cause",
        source="Eqs. (2)-(7), Sec. 3, Fig. 5, and the ellipses of Sec. 4, Fig. 10",
        parameters=_parameters(study),
    )


def motion_cones(study: StudyFile) -> xr.Dataset:
    """Motion cones over effects, rod length, rod angle and friction coefficient (Figs. 6, 7, 9)."""
    outer = ("effects", "rod_length", "rod_angle", "friction_coefficient")
    coords = _grid(study, outer)

    def cell(effects: Any, length: float, angle: float, mu: float) -> Cell:
        scene = Scene(
            slider=study.ring(length, angle), contact=contact_law(mu), effects=study.effects(effects)
        )
        forces, motions = friction_cone(scene), motion_cone(scene)
        return {
            "friction_cone_right": np.rad2deg(forces.right),
            "friction_cone_left": np.rad2deg(forces.left),
            "motion_cone_right": np.rad2deg(motions.right),
            "motion_cone_left": np.rad2deg(motions.left),
            "pulls": np.int8(can_pull(scene)),
            "slips_while_pushing": np.int8(slips_while_pushing(scene)),
        }

    cells = [cell(*point) for point in itertools.product(*(coords[name] for name in outer))]
    return describe(
        _assemble(coords, cells, outer),
        title="Friction cones and the motion cones they map to",
        source="Secs. 3.1, 3.2 and 4, Figs. 6, 7 and 9",
        parameters=_parameters(study),
    )


def acceleration_centers(study: StudyFile) -> xr.Dataset:
    """Acceleration centres with friction and inertia under infinite friction (Sec. 4, Fig. 12)."""
    angles = np.array([angle for angle in study.grid.force_angle if 0 <= angle <= 180])
    coords: dict[str, Any] = {
        "rod_length": list(study.grid.rod_length),
        "force_angle": angles,
        "inertia_share": list(study.grid.inertia_share),
    }
    phi, share = np.deg2rad(angles)[:, None], np.array(study.grid.inertia_share)

    def cell(length: float) -> Cell:
        scene = Scene(
            slider=study.ring(length),
            contact=InfiniteFriction(),
            effects=study.effects("support_friction+inertia"),
        )
        k: Array = spin_ratio(scene, phi, share)
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

    cells = [cell(length) for length in coords["rod_length"]]
    return describe(
        _assemble(coords, cells, ("rod_length",)),
        title="Acceleration centres and cones with support friction and inertia",
        source="Sec. 4, Fig. 12: the paper's conservative bound and the exact set",
        parameters=_parameters(study),
    )
