"""Positions of corners and feet in common layouts."""

from __future__ import annotations

from typing import Any

import numpy as np

from planar_pushing.mechanics.pressure.pieces import Array
from planar_pushing.mechanics.supports.base import POSITION, a_length
from planar_pushing.terms.declared import OneAngle, Read, finite
from planar_pushing.terms.domain import RADIANS, TO_RADIANS, TURNS
from planar_pushing.terms.errors import require_number

#: Declarations of the parameters of layouts.
WIDTH = a_length("give the length of the sides along x")
HEIGHT = a_length("give the length of the sides along y")
RADIUS = a_length("give the radius")
TURN = OneAngle(
    lambda x: abs(x) <= TURNS, RADIANS, TO_RADIANS,
    degrees=finite("give one angle", "a finite number of degrees"),
)  # fmt: skip


def _integer(minimum: int) -> Read:
    """Declaration of a whole number."""

    def require(name: str, value: Any) -> float:
        return require_number(
            name, value, lambda n: n >= minimum and n == int(n) and n < 1e6,
            f"a whole number >= {minimum}", "give more of them",
        )  # fmt: skip

    return Read(require, f"a whole number >= {minimum}", {"type": "integer", "minimum": minimum})


COUNT, RINGS = _integer(3), _integer(1)


def placed_corners(places: Array, center: Any, angle: float) -> Array:
    """Positions rotated about the origin by an angle in radians, then shifted to a center."""
    turn = TURN.require("angle", angle)
    c, s = (1.0, 0.0) if turn == 0.0 else (np.cos(turn), np.sin(turn))
    turned: Array = places @ np.array([[c, s], [-s, c]])
    middle: Array = np.array(POSITION.require("center", center))
    return turned + middle


def rectangle_corners(width: float, height: float) -> Array:
    """Corners of a rectangle about the origin, counterclockwise."""
    x, y = WIDTH.require("width", width) / 2, HEIGHT.require("height", height) / 2
    return np.array([(-x, -y), (x, -y), (x, y), (-x, y)])


def regular_corners(count: int, radius: float) -> Array:
    """Corners of a regular polygon about the origin, the first on the x axis."""
    number = int(COUNT.require("count", count))
    turns = 2 * np.pi * np.arange(number) / number
    return float(RADIUS.require("radius", radius)) * np.column_stack([np.cos(turns), np.sin(turns)])


def disc_places(rings: int, radius: float) -> Array:
    """Positions on rings of 6, 12, 18, ... around a central one, all with equal areas around them.

    Each ring has the root mean square radius of its area, so that the second moment of the positions is
    close to that of the disc.
    """
    number = int(RINGS.require("count", rings))
    edges = np.sqrt(
        (1 + 3 * np.arange(number + 1) * np.arange(1, number + 2)) / (1 + 3 * number * (number + 1))
    )
    places = [np.zeros((1, 2))]
    for k in range(1, number + 1):
        turns = 2 * np.pi * np.arange(6 * k) / (6 * k)
        away = np.sqrt((edges[k - 1] ** 2 + edges[k] ** 2) / 2)
        places.append(away * np.column_stack([np.cos(turns), np.sin(turns)]))
    return float(RADIUS.require("radius", radius)) * np.concatenate(places)
