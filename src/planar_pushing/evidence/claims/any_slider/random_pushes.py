"""Statements of the paper on every push, for random supports that are touched at random places."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.evidence.claims.any_slider.supports import (
    SEED,
    everywhere,
    random_scenes,
    random_supports,
    reach,
)
from planar_pushing.evidence.claims.proofs.registry import check
from planar_pushing.evidence.claims.proofs.verdicts import Evidence
from planar_pushing.mechanics.centers import Origin, motion_centers
from planar_pushing.mechanics.cones import can_pull, motion_cone, slips_while_pushing
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.solve import solve

#: Rounding of an angle, radians, and of a length, relative.
ROUNDING = 1e-9

Truth = npt.NDArray[np.bool_]


def _each(holds: Truth, method: str) -> Evidence:
    return everywhere(holds, (f"support {i}" for i in range(len(holds))), method)


def _scenes(supports: float, contacts: float) -> Scene:
    return random_scenes(random_supports(int(supports)), int(contacts))


def _only(scenes: Scene, pusher_angle: Any, modes: Any) -> Truth:
    """Where one solution is consistent, of the given mode."""
    found = solve(scenes, pusher_angle)
    return np.asarray((found.solutions == 1) & (found.mode[..., 0] == modes))


@check
def normal_push_on_random_supports(supports: float, contacts: float) -> Evidence:
    """Sticking is the only solution of a push along the normal."""
    holds = _only(_scenes(supports, contacts), np.pi / 2, ContactMode.STICK)
    return _each(holds, "every contact mode, by the mechanics in double precision")


@check
def slip_outside_cone_on_random_supports(supports: float, contacts: float) -> Evidence:
    """A push in a random direction sticks within the cone, and slips towards it beyond."""
    scenes = _scenes(supports, contacts)
    cone = motion_cone(scenes)
    pusher = np.random.default_rng(SEED).uniform(0.01, np.pi - 0.01, cone.left.shape)
    beyond = np.where(pusher > cone.left, ContactMode.SLIP_RIGHT, ContactMode.SLIP_LEFT)
    modes = np.where(cone.contains(pusher), ContactMode.STICK, beyond)
    return _each(
        _only(scenes, pusher, modes), "cone and contact modes, by two routes of the mechanics"
    )


@check
def cones_of_random_supports(supports: float, contacts: float) -> Evidence:
    """The cone spans 180 degrees and holds the normal; it reaches away where it leaves out pushes."""
    scenes = _scenes(supports, contacts)
    cone = motion_cone(scenes)
    holds = (np.abs(cone.span - np.pi) < ROUNDING) & cone.contains(np.pi / 2)
    holds &= np.asarray(can_pull(scenes) == slips_while_pushing(scenes))
    return _each(holds, "edges of the cone, each by its own line of force")


@check
def centers_of_random_supports(supports: float, contacts: float) -> Evidence:
    """The center is within a^2 / d where the line of force meets the disc of radius a, else within a."""
    members = random_supports(int(supports))
    scenes = random_scenes(members, int(contacts))
    force = np.random.default_rng(SEED).uniform(-np.pi, np.pi, scenes.slider.rod_length.shape)
    middle = _center_of_pressure(scenes, members)
    rod = scenes.slider.rod_length[..., None] * direction(scenes.slider.rod_angle)
    size, along = reach(members), direction(force)
    arm = middle + rod
    offset = np.abs(arm[..., 0] * along[..., 1] - arm[..., 1] * along[..., 0])
    apart = np.linalg.norm(
        motion_centers(scenes, force, origin=Origin.RING_CENTER) - middle, axis=-1
    )
    holds = apart <= np.maximum(size**2 / offset, size) * (1 + ROUNDING)
    return _each(holds, "centre of rotation under random lines of force")


def _center_of_pressure(scenes: Scene, members: Any) -> Array:
    """Center of pressure from the slider's center, in the directions of the fence."""
    places = np.array([[each.center_of_pressure] for each in members[:, 0]])
    x, y = direction(scenes.slider.rod_angle), direction(scenes.slider.rod_angle + np.pi / 2)
    return np.asarray(places[..., :1] * x + places[..., 1:] * y)
