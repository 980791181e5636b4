"""The outline of an object: drawings, chains of sides, arcs and corners, and the plate they enclose."""

from planar_pushing.mechanics.outline.drawing import (
    DRAWN,
    KEPT,
    Corners,
    Drawing,
    corners_of_drawing,
    put_on_line,
    read_drawing,
    size,
)
from planar_pushing.mechanics.outline.outline import (
    Outline,
    outline_of_corners,
    require_corners,
    require_outline,
    rounded,
    straight_corners,
)

__all__ = [
    "DRAWN",
    "KEPT",
    "Corners",
    "Drawing",
    "Outline",
    "corners_of_drawing",
    "outline_of_corners",
    "put_on_line",
    "read_drawing",
    "require_corners",
    "require_outline",
    "rounded",
    "size",
    "straight_corners",
]
