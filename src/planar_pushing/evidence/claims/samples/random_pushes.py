"""Statements about every push, tested by the library on random supports with random contacts."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.evidence.claims.registry import sample
from planar_pushing.evidence.claims.samples.supports import (
    SEED,
    extent,
    random_scenes,
    random_supports,
)
from planar_pushing.evidence.claims.verdicts import Evidence, at_points
from planar_pushing.mechanics.centers import Origin, motion_centers
from planar_pushing.mechanics.cones import can_pull, motion_cone, slips_while_pushing
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.solve import solve

#: Rounding of an angle, radians, and of a length, relative.
ROUNDING = 1e-9

Truth = npt.NDArray[np.bool_]


def everywhere(holds: Truth) -> Evidence:
    """Evidence for a statement on each support and at each of its contacts."""
    wrong = [f"support {i}, contact {j}" for i, j in np.argwhere(~holds)]
    return at_points(wrong, holds.size)


def _scenes(supports: float, contacts: float) -> Scene:
    return random_scenes(random_supports(int(supports)), int(contacts))


def _only(scenes: Scene, pusher_angle: Any, modes: Any) -> Truth:
    """Whether exactly one solution is consistent, and of the given mode."""
    found = solve(scenes, pusher_angle)
    return np.asarray((found.solutions == 1) & (found.mode[..., 0] == modes))


@sample
def normal_push_on_random_supports(supports: float, contacts: float) -> Evidence:
    """Sticking is the only solution of a push along the normal.

    The library solves for every contact mode, in double precision.
    """
    return everywhere(_only(_scenes(supports, contacts), np.pi / 2, ContactMode.STICK))


@sample
def slip_outside_cone_on_random_supports(supports: float, contacts: float) -> Evidence:
    """A push in a random direction sticks inside the cone and slips toward it outside.

    The cone and the contact modes, which the library computes independently of each other, agree on one
    random direction for each contact.
    """
    scenes = _scenes(supports, contacts)
    cone = motion_cone(scenes)
    pusher = np.random.default_rng(SEED).uniform(0.01, np.pi - 0.01, cone.left.shape)
    beyond = np.where(pusher > cone.left, ContactMode.SLIP_RIGHT, ContactMode.SLIP_LEFT)
    modes = np.where(cone.contains(pusher), ContactMode.STICK, beyond)
    return everywhere(_only(scenes, pusher, modes))


@sample
def cones_of_random_supports(supports: float, contacts: float) -> Evidence:
    """The cone spans 180 degrees, contains the normal, and allows pulls where it excludes pushes.

    The library computes each edge of the cone from its own line of force, in double precision.
    """
    scenes = _scenes(supports, contacts)
    cone = motion_cone(scenes)
    holds = (np.abs(cone.span - np.pi) < ROUNDING) & cone.contains(np.pi / 2)
    return everywhere(np.asarray(holds & (can_pull(scenes) == slips_while_pushing(scenes))))


@sample
def pulls_of_random_supports(supports: float, contacts: float) -> Evidence:
    """Where a retreating pusher sticks, separation and a slip are consistent too.

    The library solves for every contact mode of a pusher that retreats midway between the edge of the
    cone and the fence, in double precision. A cone that is tilted by less than $10^(-9)$ rad counts as
    not tilted.
    """
    scenes = _scenes(supports, contacts)
    cone = motion_cone(scenes)
    below, beyond = cone.right < -ROUNDING, cone.left > np.pi + ROUNDING
    found = solve(scenes, np.where(below, cone.right, cone.left + np.pi) / 2)
    slip = np.where(below, ContactMode.SLIP_LEFT, ContactMode.SLIP_RIGHT)[..., None]
    modes = (ContactMode.SEPARATE, ContactMode.STICK, slip)
    has = np.all([(found.mode == mode).any(axis=-1) for mode in modes], axis=0)
    return everywhere(np.asarray(~(below | beyond) | (has & (found.solutions == 3))))


@sample
def centers_of_random_supports(supports: float, contacts: float) -> Evidence:
    """The center is within a^2 / d if the line of force crosses the disc of radius a, otherwise within a.

    The library computes the center of rotation under a random line of force, in double precision.
    """
    members = random_supports(int(supports))
    scenes = random_scenes(members, int(contacts))
    force = np.random.default_rng(SEED).uniform(-np.pi, np.pi, scenes.slider.rod_length.shape)
    middle = _center_of_pressure(scenes, members)
    arm = middle + scenes.slider.rod_length[..., None] * direction(scenes.slider.rod_angle)
    size, along = extent(members), direction(force)
    offset = np.abs(arm[..., 0] * along[..., 1] - arm[..., 1] * along[..., 0])
    centers = motion_centers(scenes, force, origin=Origin.SLIDER_CENTER)
    apart = np.linalg.norm(centers - middle, axis=-1)
    return everywhere(apart <= np.maximum(size**2 / offset, size) * (1 + ROUNDING))


def _center_of_pressure(scenes: Scene, members: Any) -> Array:
    """Center of pressure relative to the slider's center, in the frame of the fence."""
    places = np.array([[each.center_of_pressure] for each in members[:, 0]])
    x, y = direction(scenes.slider.rod_angle), direction(scenes.slider.rod_angle + np.pi / 2)
    return np.asarray(places[..., :1] * x + places[..., 1:] * y)
