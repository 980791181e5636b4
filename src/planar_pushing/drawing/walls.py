"""Walls at rest beside an object, hatched on the side away from it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.drawing.body import STROKE_SPACING
from planar_pushing.drawing.canvas.colors import GUIDE
from planar_pushing.drawing.canvas.marks import Hatch, Picture
from planar_pushing.mechanics.plane import Array, Frame, direction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.simulation.walls import Wall
from planar_pushing.simulation.world import world_of

#: Half of a drawn wall, largest distance of an object from one, and depth of the hatch, in its sizes.
HALF, FAR, DEPTH = 0.7, 1.5, 0.036


class DrawnWall(NamedTuple):
    """A point of a wall, and its unit normal toward the free side, in the plane of a picture."""

    point: Array
    normal: Array

    def segment(self, position: Array, size: float) -> Array | None:
        """Ends of the part beside an object at a position, shape (2, 2); None if it is far away."""
        height = float((position - self.point) @ self.normal)
        if height > FAR * size:
            return None
        along = HALF * size * np.array([self.normal[1], -self.normal[0]])
        foot = position - height * self.normal
        return np.array([foot - along, foot + along])


def walls_in(frame: Frame, walls: Iterable[Wall]) -> tuple[DrawnWall, ...]:
    """Walls of the world in a frame that the world sees."""
    return tuple(
        DrawnWall(frame.point_in(wall.position), frame.vector_in(wall.unit_normal))
        for wall in walls
    )


def walls_before(scene: Scene, settings: dict[str, Any]) -> tuple[DrawnWall, ...]:
    """Walls in the fence frame at time 0, of a scene and the arguments of `simulate`."""
    if not settings.get("walls"):
        return ()
    return walls_in(world_of(scene, settings["object_pose"]).fence, settings["walls"])


def walls_of_object(
    pose: tuple[float, float, float], walls: Iterable[Wall]
) -> tuple[DrawnWall, ...]:
    """Walls in the frame of an object that has a pose in the world."""
    x, y, angle = pose
    return walls_in(Frame((x, y), tuple(direction(angle).tolist())), walls)


def add_wall(picture: Picture, ends: Array, normal: Array, size: float) -> None:
    """Add the segment of a wall beside an object of a size."""
    depth = DEPTH * size
    picture.line(ends, GUIDE, width=1.0)
    length = float(np.hypot(*(ends[1] - ends[0])))
    along = (ends[1] - ends[0]) / length
    places = np.arange(depth, length, STROKE_SPACING * depth)
    tops = ends[0] + places[:, None] * along
    strokes = np.stack([tops, tops - depth * (along + normal)], axis=1)
    picture.add(Hatch(strokes, GUIDE))
