"""Pushes of an object on a support, with exact mechanics by batches of runs and related functions."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from planar_pushing.mechanics.contact import Coulomb, InfiniteFriction
from planar_pushing.mechanics.effects import SupportFriction
from planar_pushing.mechanics.force.force_motion import motion_of_force
from planar_pushing.mechanics.force.wrench import wrench
from planar_pushing.mechanics.outline.places import Places
from planar_pushing.mechanics.plane import Array, Frame
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.slider import Slider
from planar_pushing.objects.scene_at import scene_at
from planar_pushing.pushes.logs.measured import Measured
from planar_pushing.simulation.batch import batch_of
from planar_pushing.simulation.problem import Problem, warn_of_doubts
from planar_pushing.simulation.pusher import Pusher

#: Tolerance of the motions: a thousandth of the error of the best measurement.
TOLERANCE = 1e-6


@dataclass(frozen=True, slots=True)
class OnSupport:
    """An object on a support given in the object's frame."""

    support: Any

    def poses(self, pushes: Measured, friction: float) -> Array:
        frames = body_frames(pushes, np.array(self.support.center_of_pressure), self.support.extent)
        supports = [self.support.in_frame(placement) for placement in frames.every]
        return simulate_measured(
            pushes, frames, supports, np.full(len(supports), friction), self.support.extent
        )

    def wrenches(self, twists: Array) -> Array:
        return wrench(SupportFriction(weight=1.0, support=self.support), twists)

    def motions(self, wrenches: Array) -> Array:
        """Twists under forces along the lines of wrenches; NaN for a torque without a force."""
        force, torque = wrenches[:, :2], wrenches[:, 2]
        square = (force**2).sum(axis=1)
        lines = np.flatnonzero(square > 0.0)
        motions = np.full(wrenches.shape, np.nan)
        if len(lines):
            arm = (torque / np.where(square > 0.0, square, 1.0))[lines, None]
            points = arm * np.column_stack([force[lines, 1], -force[lines, 0]])
            scene = scene_at(
                points, force[lines], contact=InfiniteFriction(),
                effects=[SupportFriction(weight=1.0, support=self.support)],
            )  # fmt: skip
            twist = motion_of_force(scene, np.pi / 2).twist
            motions[lines] = scene.to_object(twist, "twist")
        return motions


@dataclass(frozen=True, slots=True)
class BodyFrames:
    """Body frames of pushes: origin, direction of the x axis, and length and angle of the rod."""

    places: Places
    every: list[Frame]
    origin: Array
    axis: Array
    length: Array
    angle: Array


def body_frames(pushes: Measured, center: Array, extent: float) -> BodyFrames:
    """Body frames with origin at the center, or above the contact if the center is not above its line."""
    places = pushes.first_places
    normal, tangent = places.normal, places.tangent
    rod = center - places.point
    height = (rod * normal).sum(axis=1)
    rod = np.where((height > 1e-3 * extent)[:, None], rod, extent * normal)
    length = np.hypot(*rod.T)
    axis, origin = rod / length[:, None], places.point + rod
    angle = np.arctan2((rod * normal).sum(axis=1), (rod * tangent).sum(axis=1))
    frames = [
        Frame((o_x, o_y), (a_x, a_y))
        for (o_x, o_y), (a_x, a_y) in zip(origin.tolist(), axis.tolist(), strict=True)
    ]
    return BodyFrames(places, frames, origin, axis, length, angle)


def simulate_measured(
    pushes: Measured, frames: BodyFrames, supports: list[Any], friction: Array, extent: float
) -> Array:
    """Final poses for supports given in the body frames, for one or several sets of supports.

    Parameters
    ----------
    pushes : Measured
    frames : BodyFrames
    supports : list of m supports
        m is a multiple of the number n of pushes.
    friction : ndarray, shape (m,)
    extent : float

    Returns
    -------
    ndarray, shape (m, 3)
        Displacements and rotations of the object's frame. A push during which the finger touches two places
        ends there.
    """
    times = len(supports) // len(pushes)

    def repeat(values: Array) -> Array:
        return np.tile(values, (times, *(1,) * (values.ndim - 1)))

    origin, axis = repeat(frames.origin), repeat(frames.axis)
    scene = Scene(
        slider=Slider(
            rod_length=repeat(frames.length), rod_angle=repeat(frames.angle), radius=extent,
            outline=pushes.outline, outline_frame=Frame((*origin.T,), (*axis.T,)),
        ),
        contact=_objects([Coulomb(mu) for mu in friction.tolist()]),
        effects=(SupportFriction(weight=1.0, support=_objects(supports)),),
    )  # fmt: skip
    tangent, normal = repeat(frames.places.tangent), repeat(frames.places.normal)
    pusher = _pusher(repeat(pushes.path), tangent, normal, repeat(pushes.radius))
    problem = Problem(scene=scene, pusher=pusher, duration=1.0, rtol=TOLERANCE)
    warn_of_doubts(problem)
    log = batch_of(problem, passes_inner_corners=False)
    position = log["position"].values
    center = repeat(frames.places.point) + position[:, :1] * tangent + position[:, 1:] * normal
    turn = np.deg2rad(log["rod_angle"].values) - repeat(frames.angle)
    c, s = np.cos(turn), np.sin(turn)
    x, y = origin.T
    moved = center - np.column_stack([c * x - s * y, s * x + c * y])
    return np.column_stack([moved, turn])


def _pusher(path: Array, tangent: Array, normal: Array, radius: Array) -> Pusher:
    """The finger as a pusher; each part of its path takes the same time."""
    parts = path.shape[1]
    velocities = []
    for k in range(parts):
        distance = parts * path[:, k]
        along, across = (distance * tangent).sum(axis=1), (distance * normal).sum(axis=1)
        velocities.append((k / parts, (along, across)))
    velocity: Any = velocities[0][1] if parts == 1 else velocities
    return Pusher(velocity=velocity, shape="finger", radius=radius)


def _objects(values: list[Any]) -> Array:
    array = np.empty(len(values), dtype=object)
    array[:] = values
    return array
