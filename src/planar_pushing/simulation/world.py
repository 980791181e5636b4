"""The world frame: where an object with a pose at time 0, and its fence, are over time."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.plane import Frame, direction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.terms.domain import RADIANS, TO_RADIANS, TURNS
from planar_pushing.terms.errors import InvalidValue, as_floats
from planar_pushing.terms.numbers import Array

#: A pose: x, y, and the angle in radians.
Pose = tuple[float, float, float]


class World(NamedTuple):
    """The world frame over time.

    Attributes
    ----------
    fence : Frame
        The fence frame at time 0, in the world.
    origin : ndarray, shape (2,)
        Origin of the object's frame, in the body frame.
    angle : float
        Angle of the object in the world minus the rod angle, a constant.
    """

    fence: Frame
    origin: Array
    angle: float

    def object_pose(self, position: Array, rod_angle: Array) -> tuple[Array, Array]:
        """Positions of the object in the world, shape S + (2,), and angles in degrees, shape S.

        Parameters
        ----------
        position : ndarray, shape S + (2,)
            The slider's center in the fence frame of time 0.
        rod_angle : ndarray, shape S
            Radians.
        """
        body = Frame((position[..., 0], position[..., 1]), (np.cos(rod_angle), np.sin(rod_angle)))
        origin = self.fence.point_out(body.point_out(self.origin))
        return origin, np.asarray(np.rad2deg(rod_angle + self.angle))


def world_of(scene: Scene, pose: Pose) -> World:
    """The world of a scene whose object has this pose at time 0."""
    x, y, angle = pose
    object_frame = _frame((x, y), direction(angle))
    origin = object_frame.point_out(scene.to_object((0.0, 0.0), "point"))
    fence = _frame(origin, object_frame.vector_out(scene.to_object((1.0, 0.0), "vector")))
    rod, length = float(scene.slider.rod_angle), float(scene.slider.rod_length)
    body = _frame(length * direction(rod), direction(rod))
    return World(fence, body.point_in(scene.to_fence((0.0, 0.0), "point")), angle - rod)


def _frame(origin: Any, axis: Any) -> Frame:
    return Frame((float(origin[0]), float(origin[1])), (float(axis[0]), float(axis[1])))


def require_pose(value: Any) -> Pose:
    """A pose as floats, or `InvalidValue`."""
    pose = as_floats(value)
    if len(pose) != 3 or not all(map(math.isfinite, pose)):
        raise InvalidValue(
            "object_pose", value, "(x, y, angle) of finite numbers",
            "give the pose of the object's frame in the world at time 0, the angle in radians",
        )  # fmt: skip
    x, y, angle = pose
    if abs(angle) > TURNS:
        raise InvalidValue("object_pose", value, f"an angle in {RADIANS}", TO_RADIANS)
    return x, y, angle
