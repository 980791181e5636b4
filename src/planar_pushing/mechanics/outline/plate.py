"""Integrals over an outline: extent, area, centroid and second moments, exact for arcs and holes.

The area is that of the polygon through the ends of all pieces, and of the segments between arcs and their
chords, whose integrals are negative where the arc is hollow.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from planar_pushing.mechanics.outline.chains import (
    BETA0,
    BETA1,
    RHO,
    points_at,
    split_chains,
    starts_of,
)
from planar_pushing.terms.numbers import Array


class Plate(NamedTuple):
    """A uniform plate in the shape of an outline.

    Attributes
    ----------
    area : float
    centroid : (x, y)
    moments : (xx, xy, yy)
        Second moments of the area about the centroid.
    """

    area: float
    centroid: tuple[float, float]
    moments: tuple[float, float, float]

    @property
    def gyration_radius(self) -> float:
        """Radius of gyration about the centroid."""
        return math.sqrt((self.moments[0] + self.moments[2]) / self.area)


def extreme_points(pieces: Array, direction: float) -> Array:
    """Candidates for the extreme points of an outline along a direction (radians), and their opposites.

    They are the ends of all pieces, and the points of arcs whose normal is along the direction.
    """
    points = [starts_of(pieces)]
    arcs = pieces[np.isfinite(pieces[:, RHO]) & (pieces[:, RHO] != 0.0)]
    low, high = arcs[:, [BETA0, BETA1]].min(axis=1), arcs[:, [BETA0, BETA1]].max(axis=1)
    for side in (math.pi / 2.0, -math.pi / 2.0):
        # Directions of the tangent whose normal is along the direction, or against it.
        beta = low + np.mod(direction + side - low, 2.0 * math.pi)
        inside = beta <= high
        points.append(points_at(arcs[inside], beta[inside]))
    return np.concatenate(points)


def bounds(pieces: Array) -> tuple[Array, Array]:
    """Lowest and highest coordinates of an outline."""
    x, y = (extreme_points(pieces, angle)[:, i] for i, angle in enumerate((0.0, math.pi / 2.0)))
    return np.array([x.min(), y.min()]), np.array([x.max(), y.max()])


def plate_of(pieces: Array) -> Plate:
    """Area, centroid and second moments."""
    low, high = bounds(pieces)
    origin = (low + high) / 2.0
    total = np.zeros(6)
    for chain in split_chains(pieces):
        total += _of_polygon(starts_of(chain) - origin)
    for piece in pieces[np.isfinite(pieces[:, RHO]) & (pieces[:, RHO] != 0.0)]:
        total += _of_segment(piece, origin)
    area, x, y, xx, xy, yy = total.tolist()
    x, y = x / area, y / area
    moments = xx - area * x * x, xy - area * x * y, yy - area * y * y
    return Plate(area, (x + float(origin[0]), y + float(origin[1])), moments)


def _of_polygon(vertices: Array) -> Array:
    """Integrals of 1, x, y, x^2, x y and y^2 over a polygon."""
    (x, y), (a, b) = vertices.T, np.roll(vertices, -1, axis=0).T
    turn = x * b - a * y
    return np.array(
        [
            turn.sum() / 2.0,
            (turn * (x + a)).sum() / 6.0,
            (turn * (y + b)).sum() / 6.0,
            (turn * (x * x + x * a + a * a)).sum() / 12.0,
            (turn * (2.0 * (x * y + a * b) + x * b + a * y)).sum() / 24.0,
            (turn * (y * y + y * b + b * b)).sum() / 12.0,
        ]
    )


def _of_segment(piece: Array, origin: Array) -> Array:
    """The same integrals over the segment between an arc and its chord, negative for a hollow arc."""
    rho, half = float(piece[RHO]), float(piece[BETA1] - piece[BETA0]) / 2.0
    middle = float(piece[BETA0] + piece[BETA1]) / 2.0
    s, c = math.sin(half), math.cos(half)
    # Along u, from the center to the middle of the arc, and across it, about the center.
    area = rho**2 * (half - s * c)
    first = 2.0 / 3.0 * rho**3 * s**3
    along = rho**4 / 4.0 * (half + s * c - 2.0 * c**3 * s)
    across = rho**4 / 4.0 * (half - s * c - 2.0 / 3.0 * c * s**3)
    u, v = math.sin(middle), -math.cos(middle)
    x, y = (piece[:2] - origin).tolist()
    f_x, f_y = first * u, first * v
    return np.array(
        [
            area,
            area * x + f_x,
            area * y + f_y,
            area * x * x + 2.0 * x * f_x + along * u * u + across * v * v,
            area * x * y + x * f_y + y * f_x + (along - across) * u * v,
            area * y * y + 2.0 * y * f_y + along * v * v + across * u * u,
        ]
    )
