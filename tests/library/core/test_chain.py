"""Chains of pieces in the core: nearest places and free stretches, against dense samples of the outline."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial import cKDTree

import planar_pushing as pp
from planar_pushing.core.supports import chain
from planar_pushing.mechanics.kernels.arrays import Output, map_kernel
from planar_pushing.mechanics.kernels.columns import row_of
from planar_pushing.mechanics.outline.places import chain_rows, depth_tolerance

SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
T = [
    (-0.6, 0),
    (-0.6, -0.3),
    (-0.15, -0.3),
    (-0.15, -1.2),
    (0.15, -1.2),
    (0.15, -0.3),
    (0.6, -0.3),
    (0.6, 0),
]
OUTLINES = {
    "square": pp.Outline(SQUARE),
    "T": pp.Outline(T),
    "rounded square": pp.rounded(SQUARE, 0.3),
    "T with fillets": pp.rounded(T, [0.02, 0, 0.1, 0.02, 0, 0.05, 0, 0.05]),
    "disc": pp.Outline(pp.Disc(0.7)),
    "hole": pp.Outline(SQUARE, holes=[[(-0.5, -0.5), (0.4, -0.4), (0.1, 0.6)]]),
    "ellipse": pp.Outline.ellipse(1.0, 0.6, arcs=16),
    "hollow": pp.Outline.from_bulges([(-1, -1, -0.6), (1, -1, 0), (1, 1, 0.4), (-1, 1, 0)]),
}


def sample(outline, count):
    """Points of each piece, and the direction of its inward normal there; one for a corner."""
    points, normals = [], []
    for x, y, rho, first, last, length, *_ in outline.pieces:
        part = np.linspace(0.0, 1.0, count if length else 2)
        beta = first + part * (last - first)
        normal = np.stack([-np.sin(beta), np.cos(beta)], axis=-1)
        point = (x, y) - (0.0 if np.isinf(rho) else rho) * normal
        if np.isinf(rho):
            point = (x, y) + length * part[:, None] * np.stack(
                [np.cos(beta), np.sin(beta)], axis=-1
            )
        points.append(point)
        normals.append(normal)
    return points, normals


@pytest.mark.parametrize("name", OUTLINES)
def test_the_nearest_place_is_that_of_dense_samples(name):
    outline, random = OUTLINES[name], np.random.default_rng(1)
    rows, unit = memoryview(chain_rows(outline).ravel()), depth_tolerance(outline)
    points = sample(outline, 800)[0]
    boundary = np.concatenate(points)
    for x, y in random.uniform(-1.6, 1.6, (60, 2)).tolist():
        place = chain.nearest_on_chain(rows, len(outline.pieces), x / unit, y / unit)
        distance = np.hypot(*(boundary - (x, y)).T).min()
        assert abs(place.distance) * unit == pytest.approx(distance, abs=2e-3)
        crossings = sum(crossings_of(point, x, y) for point in points)
        assert (place.distance < 0.0) == (crossings % 2 == 1), (x, y)


def crossings_of(points, x, y):
    """How often a ray along +x from a point crosses the lines from point to point."""
    (a, b), (c, d) = points[:-1].T, points[1:].T
    crosses = (b > y) != (d > y)
    with np.errstate(divide="ignore", invalid="ignore"):
        return int((crosses & (x < a + (y - b) / (d - b) * (c - a))).sum())


@pytest.mark.parametrize("radius", [0.03, 0.2, 0.45])
@pytest.mark.parametrize("name", OUTLINES)
def test_a_disc_is_free_on_its_stretch_and_overlaps_beyond(name, radius):
    """The distance of the disc's center from dense samples of the other pieces."""
    outline = OUTLINES[name]
    rows, unit = chain_rows(outline), depth_tolerance(outline)
    points, normals = sample(outline, 401)
    checked = 0
    for number, (point, normal) in enumerate(zip(points, normals, strict=True)):
        _, _, rho, first, last, length, *_ = outline.pieces[number]
        if length == 0.0 or len(points) == 1 or (rho < 0.0 and rho + radius >= 0.0):
            continue
        others = np.concatenate([other for i, other in enumerate(points) if i != number])
        centers = point - radius * normal
        free = cKDTree(others).query(centers)[0] > radius - 1e-5
        if not free.any():
            continue
        middle = np.flatnonzero(free)[free.sum() // 2]
        low = middle - np.argmin(np.append(free[middle::-1], False)) + 1
        high = middle + np.argmin(np.append(free[middle:], False)) - 1
        places = (
            np.linspace(0.0, length / unit, 401) if np.isinf(rho) else np.linspace(first, last, 401)
        )
        row = row_of(
            chain.StretchRow, piece=number, radius=radius / unit, place=places[middle],
            count=len(rows), first=0,
        )  # fmt: skip
        outputs = Output("low"), Output("high")
        stretch = sorted(map(float, map_kernel("stretches_of_pieces", rows.ravel(), row, outputs)))
        ends, step = sorted((places[low], places[high])), abs(places[1] - places[0])
        least, most = sorted((places[0], places[-1]))
        assert max(stretch[0], least) == pytest.approx(ends[0], abs=2.5 * step), number
        assert min(stretch[1], most) == pytest.approx(ends[1], abs=2.5 * step), number
        checked += 1
    assert checked or name == "disc"


@pytest.mark.parametrize("radius", [1e-3, 0.5, 1.0])
def test_a_disc_that_is_smaller_than_the_tolerance_meets_no_other_piece(radius):
    """It leaves a piece at its end, as a point does."""
    outputs = Output("low"), Output("high")
    for name, outline in OUTLINES.items():
        rows = chain_rows(outline)
        for number, (_, _, rho, first, last, length, *_) in enumerate(outline.pieces):
            middle = length / depth_tolerance(outline) if np.isinf(rho) else first + last
            row = row_of(
                chain.StretchRow,
                piece=number,
                radius=radius,
                place=middle / 2,
                count=len(rows),
                first=0,
            )
            ends = map_kernel("stretches_of_pieces", rows.ravel(), row, outputs)
            assert list(map(float, ends)) == [-np.inf, np.inf], (name, number)


def test_a_ring_of_pieces_has_its_arc_length():
    for outline in OUTLINES.values():
        rows, unit = memoryview(chain_rows(outline).ravel()), depth_tolerance(outline)
        chain_length = chain.length_of_chain(rows, 0) * unit
        points = np.concatenate(sample(outline.exterior, 4001)[0])
        lengths = np.hypot(*np.diff(points, axis=0, append=points[:1]).T)
        assert chain_length == pytest.approx(lengths.sum(), rel=1e-6)
