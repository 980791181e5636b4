"""Positions of corners and feet in common layouts."""

from __future__ import annotations

from typing import Any

import numpy as np

from planar_pushing.mechanics.pressure.pieces import Array
from planar_pushing.mechanics.supports.base import length, position
from planar_pushing.terms.domain import RADIANS, required
from planar_pushing.terms.errors import require_number


def placed_corners(places: Array, center: Any, angle: float) -> Array:
    """Positions rotated about the origin by an angle in radians, then shifted to a center."""
    turn = require_number("angle", required("angle", angle), np.isfinite, RADIANS, "give one angle")
    c, s = (1.0, 0.0) if turn == 0.0 else (np.cos(turn), np.sin(turn))
    turned: Array = places @ np.array([[c, s], [-s, c]])
    return turned + position("center", center)


def rectangle_corners(width: float, height: float) -> Array:
    """Corners of a rectangle about the origin, counterclockwise."""
    x = length("width", width, "give the length of the sides along x") / 2
    y = length("height", height, "give the length of the sides along y") / 2
    return np.array([(-x, -y), (x, -y), (x, y), (-x, y)])


def regular_corners(count: int, radius: float) -> Array:
    """Corners of a regular polygon about the origin, the first on the x axis."""
    number = _count(count, 3)
    turns = 2 * np.pi * np.arange(number) / number
    return _radius(radius) * np.column_stack([np.cos(turns), np.sin(turns)])


def disc_places(rings: int, radius: float) -> Array:
    """Positions on rings of 6, 12, 18, ... around a central one, all with equal areas around them.

    Each ring has the root mean square radius of its area, so that the second moment of the positions is
    close to that of the disc.
    """
    number = _count(rings, 1)
    edges = np.sqrt(
        (1 + 3 * np.arange(number + 1) * np.arange(1, number + 2)) / (1 + 3 * number * (number + 1))
    )
    places = [np.zeros((1, 2))]
    for k in range(1, number + 1):
        turns = 2 * np.pi * np.arange(6 * k) / (6 * k)
        away = np.sqrt((edges[k - 1] ** 2 + edges[k] ** 2) / 2)
        places.append(away * np.column_stack([np.cos(turns), np.sin(turns)]))
    return _radius(radius) * np.concatenate(places)


def _radius(given: float) -> float:
    return length("radius", given, "give the radius")


def _count(given: int, least: int) -> int:
    allowed = f"a whole number >= {least}"
    number = require_number(
        "count",
        given,
        lambda n: n >= least and n == int(n) and n < 1e6,
        allowed,
        "give more of them",
    )
    return int(number)
