"""Outlines of dots for a radius of 1: polygons, each with a flag for the color of the edge."""

from __future__ import annotations

import numpy as np

from planar_pushing.mechanics.plane import Array, direction


def _turns(start: float, stop: float, count: int) -> Array:
    return np.asarray(direction(np.linspace(start, stop, count)))


def _quarter(start: float) -> Array:
    return np.vstack([[(0.0, 0.0)], _turns(start, start + np.pi / 2, 13)])


def _burst() -> Array:
    rays = _turns(np.pi / 2, 2.5 * np.pi, 17)[:-1]
    return rays * np.where(np.arange(16) % 2, 0.55, 1.0)[:, None]


_CIRCLE = _turns(0.0, 2 * np.pi, 33)[:-1]
_PLUS = np.array(
    [(1, 3), (1, 1), (3, 1), (3, -1), (1, -1), (1, -3), (-1, -3), (-1, -1), (-3, -1), (-3, 1),
     (-1, 1), (-1, 3)]
) / 3.0  # fmt: skip

#: A center of mass is a disc with two dark quadrants, and a center of pressure is a cross.
SHAPES: dict[str, tuple[tuple[Array, bool], ...]] = {
    "o": ((_CIRCLE, False),),
    "mass": ((_CIRCLE, False), (_quarter(0.0), True), (_quarter(np.pi), True)),
    "pressure": ((_PLUS, False),),
    "burst": ((_burst(), False),),
}
