"""Every solution of a scene: its motion meets the conditions of its mode, its forces follow from it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.certified.doubled.numbers import Floats, doubled
from planar_pushing.certified.doubled.ring import wrench
from planar_pushing.evidence.golden.residual.centers import center, center_error, distance
from planar_pushing.evidence.golden.residual.finding import EPSILON, Finding
from planar_pushing.evidence.golden.residual.scenes.scene import Scene
from planar_pushing.terms.options import EffectSet

STICK, SLIP_RIGHT, SLIP_LEFT = 1, 2, 3
#: Roundings of motions and forces.
MOTION = 64


def solutions(dataset: xr.Dataset, scene: Scene) -> Iterable[Finding]:
    """Findings of the variables along the dimension `solution`."""
    twist = dataset["twist"].values
    velocity, spin = twist[:, :2], twist[:, 2]
    lever = np.array(dataset["ring_center"].values) / scene.radius
    contact = velocity + spin[:, None] * lever[::-1] * [1.0, -1.0]
    pace = np.hypot(*velocity.T)
    size = (pace + scene.length * np.abs(spin) + scene.magnitude) * MOTION * EPSILON
    pushed = dataset["pusher_motion"].values
    yield _near(dataset, "contact_motion", contact, size[:, None])
    slip = dataset["contact_motion"].values[:, 0] - pushed[0]
    yield _near(dataset, "slip", slip, EPSILON * np.abs(slip))
    k, error = dataset["spin_ratio"].values, _conditions(dataset, scene, contact, velocity)
    yield Finding("twist", np.broadcast_to(error[:, None], twist.shape), size[:, None])
    ratio = np.divide(spin, pace, out=np.zeros_like(spin), where=pace > 0)
    yield _near(dataset, "spin_ratio", ratio, MOTION * EPSILON * np.abs(ratio))
    yield _force(dataset, scene, velocity, spin, k)
    yield from _places(dataset, scene, velocity, spin, k)


def _force(dataset: xr.Dataset, scene: Scene, velocity: Floats, spin: Floats, k: Floats) -> Finding:
    """The force is along the centre's motion, and carries the torque of friction and inertia."""
    pace, lever = np.hypot(*velocity.T), dataset["ring_center"].values / scene.radius
    force, torque = _resistance(scene, pace, k)
    heading = velocity / np.where(pace > 0, pace, 1.0)[:, None]
    found = dataset["force"].values
    error = np.abs(found - force[:, None] * heading * (pace > 0)[:, None]).max(axis=1)
    carried = found[:, 0] * lever[1] - found[:, 1] * lever[0]
    balance = np.where(pace > 0, np.abs(carried - torque * np.sign(spin)), 0.0)
    both = np.maximum(error, balance)[:, None]
    allowed = MOTION * EPSILON * force * (1 + scene.length)
    return Finding("force", np.broadcast_to(both, found.shape), allowed[:, None])


def _near(dataset: xr.Dataset, name: str, wanted: Any, allowed: Any) -> Finding:
    return Finding(name, np.abs(dataset[name].values - wanted), allowed)


def _conditions(dataset: xr.Dataset, scene: Scene, contact: Floats, velocity: Floats) -> Floats:
    """The contact moves with the fence: in both directions where it sticks, else normal to it.

    Where it slips the center moves along the edge of the friction cone.
    """
    mode, lack = dataset["mode"].values, np.abs(contact - dataset["pusher_motion"].values)
    error = np.where(mode >= STICK, lack[:, 1], np.abs(velocity).max(axis=1))
    error = np.maximum(error, np.where(mode == STICK, lack[:, 0], 0.0))
    for slip, side in ((SLIP_RIGHT, -1), (SLIP_LEFT, 1)):
        x, y = (part.value() for part in scene.edges[side])
        off = np.abs(velocity[:, 0] * y - velocity[:, 1] * x)
        error = np.where(mode == slip, np.maximum(error, off), error)
    return np.asarray(error)


def _resistance(scene: Scene, pace: Floats, k: Floats) -> tuple[Floats, Floats]:
    """Size of the force of each solution, and of its torque over R."""
    force, torque = (part.value() for part in wrench(np.abs(k)))
    weight, mass, gyration = scene.slider
    if scene.effects == EffectSet.INERTIA:
        weight = 0.0
    pull = mass * pace
    return weight * force + pull, weight * torque + pull * gyration * np.abs(k)


def _places(
    dataset: xr.Dataset, scene: Scene, velocity: Floats, spin: Floats, k: Floats
) -> Iterable[Finding]:
    """Motion centers, and the motion of points of the ring with the support's friction on them."""
    ring = [doubled(part) for part in dataset["ring_center"].values]
    angle = doubled(np.arctan2(*dataset["force"].values.T[::-1]))
    wanted = center(ring, angle, distance(doubled(k), scene.radius))
    yield Finding("center", *center_error(dataset["center"].values, wanted, MOTION * EPSILON))
    place = np.deg2rad(dataset["support_angle"].values)
    turned = np.stack([-np.sin(place), np.cos(place)], axis=-1)
    motion = velocity[:, None] + spin[:, None, None] * turned
    size = MOTION * EPSILON * (np.hypot(*velocity.T) + np.abs(spin))[:, None, None]
    yield _near(dataset, "support_motion", motion, size)
    speed = np.hypot(*np.moveaxis(motion, -1, 0))[..., None]
    weight = 0.0 if scene.effects == EffectSet.INERTIA else scene.slider.weight / (2 * np.pi)
    heading = np.divide(motion, speed, out=np.zeros_like(motion), where=speed > 0)
    rounding = weight * size / np.where(speed > 0, speed, 1.0) + weight * MOTION * EPSILON
    yield _near(dataset, "support_force", -weight * heading, rounding)
