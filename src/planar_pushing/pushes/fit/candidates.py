"""Families of supports: places within an outline, and columns of weights to combine."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from planar_pushing.mechanics.outline import Outline
from planar_pushing.mechanics.outline.chains import BETA0, LENGTH, RHO, points_at, split_chains
from planar_pushing.mechanics.outline.places import nearest_place
from planar_pushing.mechanics.outline.plate import bounds
from planar_pushing.mechanics.plane import Array

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


def points(outline: Outline, spacing: float) -> Family:
    """Separate weights at all places of a grid, at all corners, and along arcs."""
    places = with_corners(outline, spacing)
    return Family(places, np.eye(len(places)))


def uniform_and_corners(outline: Outline, spacing: float) -> Family:
    """A uniform pressure, and a weight at each corner, or along arcs at each spacing."""
    even, edge = inside(outline, outline.size / EVEN, 0.5), edge_points(outline, spacing)
    first = np.concatenate([np.full(len(even), 1.0 / len(even)), np.zeros(len(edge))])
    corners = np.concatenate([np.zeros((len(even), len(edge))), np.eye(len(edge))])
    return Family(np.concatenate([even, edge]), np.column_stack([first, corners]))


def ellipse(outline: Outline, spacing: float) -> Family:
    """Uniform pressures within ellipses about the centroid, along the outline's principal axes."""
    places = inside(outline, outline.size / EVEN, 0.5)
    away = places - places.mean(axis=0)
    # A uniform ellipse extends to twice the square root of its second moments.
    reach = np.sqrt((away @ np.linalg.inv(np.cov(away.T)) * away).sum(axis=1)) / 2.0
    columns = (reach[:, None] <= ELLIPSES).astype(float)
    columns = columns[:, columns.any(axis=0)]
    return Family(places, columns / columns.sum(axis=0))


def pressure_map(outline: Outline, spacing: float) -> Family:
    """A pressure that varies linearly between the nodes of a grid."""
    places = inside(outline, spacing / 3.0, 0.5)
    low, high = bounds(outline.pieces)
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


FAMILIES: dict[str, Callable[[Outline, float], Family]] = {
    "points": points, "uniform_and_corners": uniform_and_corners, "ellipse": ellipse, "map": pressure_map,
}  # fmt: skip


def inside(outline: Outline, spacing: float, offset: float = 0.0) -> Array:
    """Places of a grid that are within an outline; with an offset of 0.5, centers of cells."""
    low, high = bounds(outline.pieces)
    counts = np.maximum(np.round((high - low) / spacing).astype(int), 1)
    marks = [
        np.linspace(low[k], high[k], counts[k] + 1)
        if offset == 0.0
        else low[k] + (np.arange(counts[k]) + offset) / counts[k] * (high - low)[k]
        for k in (0, 1)
    ]
    grid = np.stack(np.meshgrid(*marks, indexing="ij"), axis=-1).reshape(-1, 2)
    return np.asarray(grid[nearest_place(outline, grid).gap <= 1e-9 * outline.size])


def with_corners(outline: Outline, spacing: float) -> Array:
    """Places of a grid within an outline, and corners and points of arcs of the outline."""
    grid, edge = inside(outline, spacing), edge_points(outline, spacing)
    distance = np.hypot(*np.moveaxis(edge[:, None] - grid, -1, 0)).min(axis=1)
    return np.concatenate([grid, edge[distance > spacing / 4.0]])


def edge_points(outline: Outline, spacing: float) -> Array:
    """Corners of an outline, and points about a spacing apart along its arcs, shape (n, 2)."""
    chains = split_chains(outline.pieces)
    # The corner at the start of a side is the row before it.
    corners = [np.roll(chain[chain[:, RHO] == 0.0, :2], 1, axis=0) for chain in chains]
    runs = [run for chain in chains for is_arc, run in _runs(chain) if is_arc]
    return np.concatenate([*corners, *(_along_arcs(run, spacing) for run in runs)])


def _runs(chain: Array) -> list[tuple[bool, Array]]:
    """Parts of a chain that consist of arcs, or of sides and corners, alternately."""
    is_arc = np.isfinite(chain[:, RHO]) & (chain[:, RHO] != 0.0)
    cuts = np.flatnonzero(np.diff(is_arc)) + 1
    parts = zip(np.split(is_arc, cuts), np.split(chain, cuts), strict=True)
    return [(bool(arcs[0]), part) for arcs, part in parts]


def _along_arcs(run: Array, spacing: float) -> Array:
    """Points in the middle of equal parts of arcs that follow one another."""
    ends = run[:, LENGTH].cumsum()
    count = max(round(float(ends[-1]) / spacing), 1)
    along = (np.arange(count) + 0.5) / count * ends[-1]
    row = np.searchsorted(ends, along)
    arcs = run[row]
    beta = arcs[:, BETA0] + (along - ends[row] + arcs[:, LENGTH]) / arcs[:, RHO]
    return points_at(arcs, beta)
