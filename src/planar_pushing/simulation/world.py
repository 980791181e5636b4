"""The world frame: where objects with a pose at time 0, and their pushers, are over time."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.kernels.arrays import broadcast_numbers, is_labeled, require_alike
from planar_pushing.mechanics.plane import Frame, Placement, direction, labeled_like
from planar_pushing.mechanics.scene import Scene
from planar_pushing.terms.domain import RADIANS, TO_RADIANS, TURNS, Number
from planar_pushing.terms.errors import InvalidValue, has_entries
from planar_pushing.terms.numbers import Array, as_numbers

#: A pose: x, y, and the angle in radians; numbers, or arrays over the scenes.
Pose = tuple[Number, Number, Number]


class World(NamedTuple):
    """The world frame over time; its numbers are arrays over the scenes of a batch.

    Attributes
    ----------
    fence : Frame
        The fence frame at time 0, in the world.
    origin : (x, y)
        Origin of the object's frame, in the body frame.
    angle : float or array
        Angle of the object in the world minus the rod angle, a constant.
    radius : float or array
        Radius of the finger, whose center is so far below the contact at time 0; 0 for a fence.
    """

    fence: Frame
    origin: tuple[Number, Number]
    angle: Number
    radius: Number

    @property
    def numbers(self) -> list[Number]:
        """All numbers, in the order of `of_numbers`."""
        return [*self.fence.origin, *self.fence.axis, *self.origin, self.angle, self.radius]

    @classmethod
    def of_numbers(cls, numbers: Any) -> World:
        """The world of the numbers that `numbers` returns."""
        x, y, c, s, origin_x, origin_y, angle, radius = numbers
        return cls(Frame((x, y), (c, s)), (origin_x, origin_y), angle, radius)

    def object_pose(self, position: Array, rod_angle: Array) -> tuple[Array, Array]:
        """Positions of the objects in the world, shape S + (2,), and angles in degrees, shape S.

        Parameters
        ----------
        position : ndarray, shape S + (2,)
            The slider's center in the fence frame of time 0.
        rod_angle : ndarray, shape S
            Radians.
        """
        body = Frame((position[..., 0], position[..., 1]), (np.cos(rod_angle), np.sin(rod_angle)))
        origin = self.fence.point_out(body.point_out(np.stack(self.origin, axis=-1)))
        return origin, np.asarray(np.rad2deg(rod_angle + self.angle))

    def pusher_position(self, displacement: Array) -> Array:
        """Positions of the pushers in the world from their displacements, both of shape S + (2,)."""
        below = np.stack([0.0 * np.asarray(self.radius), self.radius], axis=-1)
        return self.fence.point_out(displacement - below)

    def contact_normal(self, rotation: Array) -> Array:
        """Angles of the contact's normals in degrees from their rotations since time 0, in radians."""
        c, s = self.fence.axis
        return np.asarray(np.rad2deg(rotation + np.arctan2(c, -s)))


#: How many numbers a world has.
WORLD = 8


def world_of(scene: Scene, pose: Pose, radius: Number = 0.0) -> World:
    """The world of a scene whose object has this pose at time 0, under a finger of a radius.

    Raises
    ------
    InvalidValue
        If the shapes of arrays do not match.
    """
    slider, placement = scene.slider, scene.placement
    placed = [] if placement is None else [*placement.point, *placement.normal]
    given = [*pose, slider.rod_length, slider.rod_angle, *placed]
    require_one_shape(given)
    like, *others = broadcast_numbers(*given)
    x, y, angle, length, rod, *contact = map(np.asarray, (like, *others))
    body = _frame(length[..., None] * direction(rod), direction(rod))
    in_fence = body
    if contact:
        point, normal = (contact[0], contact[1]), (contact[2], contact[3])
        in_fence = Placement(point, normal).fence.inverse
    object_frame = _frame(np.stack([x, y], axis=-1), direction(angle))
    fence = _frame(
        object_frame.point_out(in_fence.point_in((0.0, 0.0))),
        object_frame.vector_out(in_fence.vector_in((1.0, 0.0))),
    )
    origin = body.point_in(in_fence.point_out((0.0, 0.0)))
    world = World(fence, (origin[..., 0], origin[..., 1]), angle - rod, radius)
    *own, radius = world.numbers
    return World.of_numbers([*(_as_given(number, like) for number in own), radius])


def require_one_shape(numbers: Sequence[Number]) -> None:
    """Refuse arrays over the scenes of several shapes, or labeled ones beside others."""
    if any(map(is_labeled, numbers)):
        require_alike(numbers)
        return
    shapes = {np.shape(number) for number in numbers}
    try:
        np.broadcast_shapes(*shapes)
    except ValueError:
        raise InvalidValue(
            "shapes", sorted(shapes), "() or (scenes,)", "give one number for each scene"
        ) from None


def _as_given(number: Array, like: Number) -> Number:
    """A float, or an array with the labels of the numbers that were given."""
    return labeled_like(like, number) if np.ndim(number) else float(number)


def _frame(origin: Array, axis: Array) -> Frame:
    return Frame((origin[..., 0], origin[..., 1]), (axis[..., 0], axis[..., 1]))


def require_pose(value: Any) -> Pose:
    """A pose, of numbers or of arrays over the scenes, or `InvalidValue`."""
    pose = tuple(map(as_numbers, value)) if has_entries(value) else ()
    finite = (part is not None and np.isfinite(np.asarray(part)).all() for part in pose)
    if len(pose) != 3 or not all(finite):
        raise InvalidValue(
            "object_pose", value, "(x, y, angle) of finite numbers",
            "give the pose of the object's frame in the world at time 0, the angle in radians",
        )  # fmt: skip
    x, y, angle = pose
    if (np.abs(np.asarray(angle)) > TURNS).any():
        raise InvalidValue("object_pose", value, f"an angle in {RADIANS}", TO_RADIANS)
    return x, y, angle
