"""Families of supports: places within an outline, and columns of weights to combine."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from planar_pushing.mechanics.plane import Array
from planar_pushing.objects.boundary import nearest, sides_of

#: Places per extent that represent a uniform pressure.
EVEN = 12
#: Sizes of the ellipses, as fractions of the ellipse with the moments of the outline.
ELLIPSES = np.linspace(0.2, 1.2, 6)


class Family(NamedTuple):
    """Supports of a family: nonnegative combinations of columns of weights on places.

    `places` has shape (k, 2) and `columns` has shape (k, c); each column has sum 1.
    """

    places: Array
    columns: Array


def points(outline: Array, spacing: float) -> Family:
    """Separate weights at all places of a grid and at all corners."""
    places = with_corners(outline, spacing)
    return Family(places, np.eye(len(places)))


def uniform_and_corners(outline: Array, spacing: float) -> Family:
    """A uniform pressure, and a weight at each corner."""
    even = inside(outline, np.ptp(outline, axis=0).max() / EVEN, 0.5)
    first = np.concatenate([np.full(len(even), 1.0 / len(even)), np.zeros(len(outline))])
    corners = np.concatenate([np.zeros((len(even), len(outline))), np.eye(len(outline))])
    return Family(np.concatenate([even, outline]), np.column_stack([first, corners]))


def ellipse(outline: Array, spacing: float) -> Family:
    """Uniform pressures within ellipses about the centroid, along the outline's principal axes."""
    places = inside(outline, np.ptp(outline, axis=0).max() / EVEN, 0.5)
    away = places - places.mean(axis=0)
    # A uniform ellipse extends to twice the square root of its second moments.
    reach = np.sqrt((away @ np.linalg.inv(np.cov(away.T)) * away).sum(axis=1)) / 2.0
    columns = (reach[:, None] <= ELLIPSES).astype(float)
    columns = columns[:, columns.any(axis=0)]
    return Family(places, columns / columns.sum(axis=0))


def pressure_map(outline: Array, spacing: float) -> Family:
    """A pressure that varies linearly between the nodes of a grid."""
    places = inside(outline, spacing / 3.0, 0.5)
    low, high = outline.min(axis=0), outline.max(axis=0)
    counts = np.maximum(np.round((high - low) / spacing).astype(int), 1)
    hats = [
        np.clip(
            1.0
            - np.abs(
                (places[:, k, None] - low[k]) / (high - low)[k] * counts[k]
                - np.arange(counts[k] + 1)
            ),
            0.0,
            None,
        )
        for k in (0, 1)
    ]
    columns = (hats[0][:, :, None] * hats[1][:, None, :]).reshape(len(places), -1)
    columns = columns[:, columns.sum(axis=0) > 0.0]
    return Family(places, columns / columns.sum(axis=0))


FAMILIES: dict[str, Callable[[Array, float], Family]] = {
    "points": points, "uniform_and_corners": uniform_and_corners, "ellipse": ellipse, "map": pressure_map,
}  # fmt: skip


def inside(outline: Array, spacing: float, offset: float = 0.0) -> Array:
    """Places of a grid that are within an outline; with an offset of 0.5, centers of cells."""
    low, high = outline.min(axis=0), outline.max(axis=0)
    counts = np.maximum(np.round((high - low) / spacing).astype(int), 1)
    marks = [
        np.linspace(low[k], high[k], counts[k] + 1)
        if offset == 0.0
        else low[k] + (np.arange(counts[k]) + offset) / counts[k] * (high - low)[k]
        for k in (0, 1)
    ]
    grid = np.stack(np.meshgrid(*marks, indexing="ij"), axis=-1).reshape(-1, 2)
    sides = sides_of(outline)
    return np.asarray(grid[nearest(sides, grid).gap <= 1e-9 * sides.scale])


def with_corners(outline: Array, spacing: float) -> Array:
    """Places of a grid within an outline, and the corners of the outline."""
    grid = inside(outline, spacing)
    distance = np.hypot(*np.moveaxis(outline[:, None] - grid, -1, 0)).min(axis=1)
    return np.concatenate([grid, outline[distance > spacing / 4.0]])
