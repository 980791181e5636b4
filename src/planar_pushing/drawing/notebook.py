"""SVG pictures of scenes, solutions and supports for notebooks."""

from __future__ import annotations

from typing import Any

import numpy as np

from planar_pushing.drawing.canvas.marks import Picture
from planar_pushing.drawing.canvas.svg import to_svg
from planar_pushing.drawing.scene import add_scale, scene_picture
from planar_pushing.drawing.sketch import Sketch
from planar_pushing.drawing.supports import Ink, Pose, add_support, extents
from planar_pushing.mechanics.pictures import PICTURES
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene, required_single

#: Width of a picture and its maximum height in pixels, pixels per point, and padding in points.
WIDTH, HEIGHT, POINT, PAD = 420.0, 420.0, 1.35, 16.0


def scene_svg(scene: Scene) -> str:
    """Picture of a slider with its cones."""
    sketch = Sketch.of(required_single(scene))
    return _svg(scene_picture(sketch), sketch.box, sketch.unit)


def push_svg(scene: Scene, angle: float, magnitude: float, found: Any) -> str:
    """Picture of a scene under a push with its solutions."""
    sketch = Sketch.of(scene, angle, magnitude, found=found)
    return _svg(scene_picture(sketch), sketch.box, sketch.unit)


def support_svg(support: Any) -> str:
    """Picture of a support in its body frame."""
    picture, pose = Picture(), Pose((0.0, 0.0), 0.0)
    add_support(picture, support, pose, Ink())
    low, high = extents(support, pose)
    below = low - np.array([0.0, 0.14 * float(np.max(high - low))])
    return _svg(picture, np.array([below, high]))


def _svg(picture: Picture, box: Array, unit: str = "") -> str:
    """SVG of a picture with its scale bar, as high as needed."""
    wide, high = np.ptp(box, axis=0)
    add_scale(picture, box, 0.3 * float(max(wide, high)), unit)
    room = WIDTH - 2 * PAD * POINT
    needed = room * high / max(wide, 1e-12 * high) + 2.6 * PAD * POINT
    return to_svg(picture, box, (WIDTH, min(HEIGHT, needed)), PAD, POINT)


PICTURES.update(scene=scene_svg, push=push_svg, support=support_svg)
