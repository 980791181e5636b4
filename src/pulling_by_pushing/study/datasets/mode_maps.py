"""Sets of consistent contact modes over friction and the direction of the push (Secs. 2-5)."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.contact import ContactMode, PerfectlyRough
from planar_pushing.mechanics.force.cones import friction_cone
from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.solve import solve
from pulling_by_pushing.study.datasets.base import axis, labeled_radians, objects, over_effects
from pulling_by_pushing.study.datasets.contact_modes import law_coordinates
from pulling_by_pushing.study.model import Part, labeled_law

#: Halvings of the half turn that contains an angle, until it is known to a rounding.
ANGLE_HALVINGS = 56


def mode_maps(part: Part) -> xr.Dataset:
    """Build the dataset for part of a study by `solve` on labeled arrays.

    A perfectly rough contact sticks under every motion. Under Coulomb's law the contact sticks if the
    force of the perfectly rough contact is inside the friction cone; the angle of this force therefore
    gives the exact limits of sticking.
    """
    labels = part.grid["contact"]
    laws = list(map(labeled_law, labels))
    slider = part.ring(axis(part, "rod_length"))
    angle, magnitude = labeled_radians(axis(part, "pusher_angle")), axis(part, "pusher_magnitude")

    finite = xr.DataArray([not isinstance(law, PerfectlyRough) for law in laws], dims="contact")

    def maps(effects: tuple[Any, ...]) -> xr.Dataset:
        scene = Scene(slider=slider, contact=objects("contact", labels, laws), effects=effects)
        rough = Scene(slider=slider, contact=PerfectlyRough(), effects=effects)
        force_angle = _sticking_force_angle(rough, angle, magnitude)
        pull_angle = _furthest_pull(scene, rough, magnitude)
        return xr.Dataset(
            {
                "modes": mode_sets(solve(scene, angle, magnitude)["mode"]),
                "sticking_force_angle": np.rad2deg(force_angle),
                "furthest_pull": np.rad2deg(pull_angle.where(finite)),
            }
        )

    return over_effects(part, maps).assign_coords(law_coordinates(laws))


def mode_sets(modes: xr.DataArray) -> xr.DataArray:
    """Code of the set of consistent modes along `solution`: the sum of 2 ** mode over the modes.

    Several slips of one mode count as one mode.
    """
    code = xr.zeros_like(modes.isel(solution=0, drop=True))
    for kind in ContactMode:
        code += (modes == kind).any("solution").astype(code.dtype) << kind
    return code


def _sticking_force(rough: Scene, length: Array, angle: Array, magnitude: Array) -> Any:
    """Force of a perfectly rough contact, sticking; shape (..., xy)."""
    rough = replace(rough, slider=replace(rough.slider, rod_length=length))
    solutions = solve(rough, angle, magnitude)
    sticks = solutions.mode == ContactMode.STICK
    return np.fmax.reduce(np.where(sticks[..., None], solutions.force, np.nan), axis=-2)


def _sticking_force_angle(rough: Scene, angle: xr.DataArray, magnitude: xr.DataArray) -> Any:
    """Angle of the force of a perfectly rough contact, sticking, radians."""

    def force_angle(*push: Array) -> Any:
        force = _sticking_force(rough, *push)
        return np.arctan2(force[..., 1], force[..., 0])

    return xr.apply_ufunc(force_angle, rough.slider.rod_length, angle, magnitude)


def _furthest_pull(scene: Scene, rough: Scene, magnitude: xr.DataArray) -> Any:
    """Pusher angle, radians, at which the sticking force is on the right edge of the friction cone.

    A force and its motion differ by less than 90 degrees; this half turn is halved.
    """

    def halve(length: Array, magnitude: Array, edge: Array) -> Array:
        e_x, e_y = np.moveaxis(direction(edge), -1, 0)
        angle, step = edge + 0 * magnitude, np.pi / 2
        for _ in range(ANGLE_HALVINGS):
            force = _sticking_force(rough, length, angle, magnitude)
            angle = angle - step * np.sign(e_x * force[..., 1] - e_y * force[..., 0])
            step /= 2
        return angle

    # Without labels, which would take longer than the solutions.
    edge = friction_cone(scene).right
    return xr.apply_ufunc(halve, rough.slider.rod_length, magnitude, edge)
