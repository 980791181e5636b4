"""Pushes of an object on a support, with exact mechanics by `simulate_batch` and related functions."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from planar_pushing.mechanics.contact import Coulomb, InfiniteFriction
from planar_pushing.mechanics.effects import SupportFriction
from planar_pushing.mechanics.force.force_motion import motion_of_force
from planar_pushing.mechanics.force.wrench import wrench
from planar_pushing.mechanics.plane import Array, Frame
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.slider import Slider
from planar_pushing.objects.scene_at import scene_at
from planar_pushing.pushes.logs.contacts import Contacts, Ends
from planar_pushing.simulation.batch import simulate_batch
from planar_pushing.simulation.early_end import quietly
from planar_pushing.simulation.pusher import Pusher

#: Tolerance of the motions: a thousandth of the error of the best measurement.
TOLERANCE = 1e-6


@dataclass(frozen=True, slots=True)
class OnSupport:
    """An object on a support given in the object's frame."""

    support: Any

    def ends(self, contacts: Contacts, friction: float) -> Ends:
        frames = body_frames(
            contacts, np.array(self.support.center_of_pressure), self.support.extent
        )
        supports = [self.support.in_frame(placement) for placement in frames.every]
        return simulate_contacts(
            contacts, frames, supports, np.full(len(supports), friction), self.support.extent
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
    """Body frames of contacts: origin, direction of the x axis, and length and angle of the rod."""

    every: list[Frame]
    origin: Array
    axis: Array
    length: Array
    angle: Array


def body_frames(contacts: Contacts, center: Array, extent: float) -> BodyFrames:
    """Body frames with origin at the center, or above the contact if the center is not above the side."""
    rod = center - contacts.point
    height = (rod * contacts.normal).sum(axis=1)
    rod = np.where((height > 1e-3 * extent)[:, None], rod, extent * contacts.normal)
    length = np.hypot(*rod.T)
    axis, origin = rod / length[:, None], contacts.point + rod
    angle = np.arctan2((rod * contacts.normal).sum(axis=1), (rod * contacts.tangent).sum(axis=1))
    frames = [
        Frame((o_x, o_y), (a_x, a_y))
        for (o_x, o_y), (a_x, a_y) in zip(origin.tolist(), axis.tolist(), strict=True)
    ]
    return BodyFrames(frames, origin, axis, length, angle)


def simulate_contacts(
    contacts: Contacts, frames: BodyFrames, supports: list[Any], friction: Array, extent: float
) -> Ends:
    """Ends of the motions of supports given in the body frames, for one or several sets of supports.

    The numbers of `supports` and `friction` are a multiple of the number of contacts.
    """
    count = len(contacts.push)
    times = len(supports) // count

    def repeat(values: Any) -> Any:
        return np.tile(values, (times, *(1,) * (values.ndim - 1)))

    laws = [
        InfiniteFriction() if sticks else Coulomb(float(mu))
        for sticks, mu in zip(repeat(contacts.sticks), friction, strict=True)
    ]
    scene = Scene(
        slider=Slider(
            rod_length=repeat(frames.length), rod_angle=repeat(frames.angle), radius=extent,
            side=(repeat(contacts.start), repeat(contacts.end)),
        ),
        contact=_objects(laws), effects=(SupportFriction(weight=1.0, support=_objects(supports)),),
    )  # fmt: skip
    log = quietly(simulate_batch)(scene, _pusher(contacts, repeat), duration=1.0, rtol=TOLERANCE)
    tangent, normal = repeat(contacts.tangent), repeat(contacts.normal)
    position = log["position"].values
    center = repeat(contacts.point) + position[:, :1] * tangent + position[:, 1:] * normal
    turn = np.deg2rad(log["rod_angle"].values) - repeat(frames.angle)
    c, s = np.cos(turn), np.sin(turn)
    x, y = repeat(frames.origin).T
    moved = center - np.column_stack([c * x - s * y, s * x + c * y])
    poses = np.column_stack([moved, turn]).reshape(times, count, 3)
    lasted = _contact_fraction(log, turn, repeat(contacts.radius), repeat(contacts.path))
    lasted = lasted.reshape(times, count)
    return Ends(poses[0], lasted[0]) if times == 1 else Ends(poses, lasted)


def _contact_fraction(log: Any, turn: Array, radius: Array, path: Array) -> Array:
    """Fraction of the finger's path over which the contact lasts.

    The object is at rest after the finger has left the side. The remaining path is therefore the distance
    of the finger from the point at which it left, relative to the object.
    """
    left = -log["slip"].values - radius * turn
    rest = np.hypot(log["contact_position"].values - left, log["gap"].values)
    distance = np.hypot(path[..., 0], path[..., 1]).sum(axis=1)
    parted = np.divide(rest, distance, out=np.zeros_like(distance), where=distance > 0.0)
    return np.asarray(np.clip(log["time"].values - parted, 0.0, 1.0))


def _pusher(contacts: Contacts, repeat: Any) -> Pusher:
    """The finger as a pusher; each part of its path takes the same time."""
    parts = contacts.path.shape[1]
    velocities = []
    for k in range(parts):
        distance = parts * contacts.path[:, k]
        along, across = (
            (distance * contacts.tangent).sum(axis=1),
            (distance * contacts.normal).sum(axis=1),
        )
        velocities.append((k / parts, (repeat(along), repeat(across))))
    velocity: Any = velocities[0][1] if parts == 1 else velocities
    return Pusher(velocity=velocity, shape="finger", radius=repeat(contacts.radius))


def _objects(values: list[Any]) -> Array:
    array = np.empty(len(values), dtype=object)
    array[:] = values
    return array
