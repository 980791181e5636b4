"""Consistent contact modes over effects, contact law, rod length and pusher motion (Secs. 2-5)."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.candidates import Candidates, modes_under, outcomes, push
from planar_pushing.mechanics.contact import (
    ContactLaw,
    ContactMode,
    Coulomb,
    InfiniteFriction,
    PerfectlyRough,
)
from planar_pushing.mechanics.contact.laws import friction_coefficient
from planar_pushing.mechanics.planar import Array, direction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.study import catalog
from planar_pushing.study.datasets.base import parameters
from planar_pushing.study.describe import describe
from planar_pushing.study.models import StudyFile

DIMS = catalog.DIMS["contact_modes"]
MOVING = [mode for mode in ContactMode if mode is not ContactMode.SEPARATE]
VALUES = ("spin_ratio", "force_angle", "spin_ratio_fast", "force_angle_fast")


def contacts(study: StudyFile) -> dict[str, tuple[str, ContactLaw]]:
    """Label: (type, law) along the contact axis; the label holds the coefficient of friction."""
    coulomb = {
        f"coulomb_{catalog.number_label(mu)}": ("coulomb", Coulomb(mu))
        for mu in study.grid.contact_friction_coefficient
    }
    return coulomb | {
        "infinite_friction_free": ("infinite_friction", InfiniteFriction()),
        "infinite_friction_none": ("infinite_friction", InfiniteFriction("none")),
        "perfectly_rough": ("perfectly_rough", PerfectlyRough()),
    }


def _extremes(found: Sequence[Candidates]) -> dict[str, Array]:
    """Spin ratio and force angle of the slowest and the fastest consistent motion; 0 where none.

    Of one mode under several laws, along the first axis.
    """
    consistent = np.stack([c.consistent for c in found])
    ratio = np.stack([c.spin_ratio for c in found])
    speed = np.stack([np.linalg.norm(c.twist, axis=-1) for c in found])
    angle = np.rad2deg(np.stack([c.force_angle for c in found]))
    slow = np.where(consistent, speed, np.inf).argmin(axis=-1, keepdims=True)
    fast = np.where(consistent, speed, -np.inf).argmax(axis=-1, keepdims=True)
    moves = consistent.any(axis=-1)

    def pick(values: Array, branch: Any) -> Array:
        return np.where(moves, np.take_along_axis(values, branch, axis=-1)[..., 0], 0.0)

    picks = (ratio, slow), (angle, slow), (ratio, fast), (angle, fast)
    return dict(zip(VALUES, (pick(*each) for each in picks), strict=True))


def build(study: StudyFile) -> xr.Dataset:
    """Build the dataset of a study."""
    laws, grid = contacts(study), study.grid
    coords: dict[str, Any] = {
        "effects": list(grid.effects),
        "contact": list(laws),
        "rod_length": list(grid.rod_length),
        "pusher_magnitude": list(grid.pusher_magnitude),
        "pusher_angle": list(grid.pusher_angle),
        "mode": [mode.name for mode in ContactMode],
    }
    shape = tuple(len(coords[dim]) for dim in DIMS)
    consistent, outcome = np.zeros(shape, np.int8), np.zeros(shape[:-1], np.int8)
    values = {name: np.zeros(shape) for name in VALUES}
    heading = direction(np.deg2rad(grid.pusher_angle))
    magnitude = np.array(grid.pusher_magnitude)[:, None]
    for (i, effects), (m, length) in product(enumerate(grid.effects), enumerate(grid.rod_length)):
        scene = Scene(
            slider=study.ring(length), contact=InfiniteFriction(), effects=study.effects(effects)
        )
        given = push(scene, heading, magnitude)  # the same for every law
        of_mode: dict[ContactMode, dict[int, Candidates]] = {mode: {} for mode in ContactMode}
        for j, found in enumerate(modes_under(scene, [law for _, law in laws.values()], given)):
            outcome[i, j, m] = outcomes(found)
            for each in found:
                consistent[i, j, m, ..., each.mode] = each.consistent.sum(axis=-1)
                of_mode[each.mode][j] = each
        for mode in MOVING:
            for name, picked in _extremes(list(of_mode[mode].values())).items():
                values[name][i, list(of_mode[mode]), m, ..., mode] = picked
    variables: dict[str, Any] = {"consistent": (DIMS, consistent), "outcome": (DIMS[:-1], outcome)}
    variables |= {name: (DIMS, array) for name, array in values.items()}
    dataset = xr.Dataset(variables, coords=coords).assign_coords(
        law=("contact", [kind for kind, _ in laws.values()]),
        friction_coefficient=("contact", [friction_coefficient(law) for _, law in laws.values()]),
    )
    return describe(
        dataset,
        title="Consistent contact modes: none, one or several for each pusher motion",
        source="Secs. 2, 3.2, 4 and 5",
        parameters=parameters(study),
    )
