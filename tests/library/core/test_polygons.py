"""Areas of polygons and edges that meet, against exact arithmetic on a grid."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from planar_pushing.mechanics.kernels.calls import run

RANDOM = np.random.default_rng(1)
#: Vertices on a grid, where edges often touch, fold back, or have no length; the products are exact.
RINGS = [
    RANDOM.integers(-size, size + 1, (count, 2)).astype(float)
    for count in (3, 4, 5, 7)
    for size in (1, 2, 6, 1000)
    for _ in range(40)
]


def sides(ring):
    corners = [tuple(map(Fraction, map(int, each))) for each in ring.tolist()]
    return list(zip(corners, [*corners[1:], corners[0]], strict=True))


def common(first, last):
    """Points that two edges have in common, as the end points of an interval along the first, or None."""
    (a, b), (c, d) = first
    (e, f), (g, h) = last
    along, across = c - a, d - b
    turn = along * (h - f) - across * (g - e)
    if turn:
        s = ((e - a) * (h - f) - (f - b) * (g - e)) / turn
        t = ((e - a) * across - (f - b) * along) / turn
        return (s, s) if 0 <= s <= 1 and 0 <= t <= 1 else None
    if not along and not across:
        # The first edge is a point: it is on the other edge, or not.
        flat = (g - e) * (b - f) == (h - f) * (a - e)
        inside = min(e, g) <= a <= max(e, g) and min(f, h) <= b <= max(f, h)
        return (0, 0) if flat and inside else None
    if along * (f - b) != across * (e - a) or along * (h - b) != across * (g - a):
        return None
    square = along * along + across * across
    places = sorted(((x - a) * along + (y - b) * across) / square for x, y in last)
    low, high = max(places[0], 0), min(places[1], 1)
    return (low, high) if low <= high else None


def crossing(ring):
    """The first two edges that have more in common than the vertex between them."""
    edges = sides(ring)
    for i in range(len(edges)):
        for j in range(i + 1, len(edges)):
            shared = common(edges[i], edges[j])
            pointlike = edges[i][0] == edges[i][1] or edges[j][0] == edges[j][1]
            if j == i + 1:
                allowed = not pointlike and shared == (1, 1)
            elif i == 0 and j == len(edges) - 1:
                allowed = not pointlike and shared == (0, 0)
            else:
                allowed = shared is None
            if not allowed:
                return i, j
    return -1, -1


def touching(one, other):
    for i, edge in enumerate(sides(one)):
        for j, another in enumerate(sides(other)):
            if common(edge, another) is not None:
                return i, j
    return -1, -1


def rows_of(rings):
    counts = np.array([len(each) for each in rings])
    return np.column_stack([counts.cumsum() - counts, counts])


def test_areas_are_those_of_the_determinants():
    found = run("polygon_area", np.concatenate(RINGS), rows_of(RINGS), 1)[:, 0]
    exact = [sum(a * d - b * c for (a, b), (c, d) in sides(ring)) / 2 for ring in RINGS]
    assert found.tolist() == [float(each) for each in exact]


def test_the_first_edges_of_a_polygon_that_meet_are_named():
    found = run("crossing_edges", np.concatenate(RINGS), rows_of(RINGS), 2)
    exact = [crossing(ring) for ring in RINGS]
    assert found.tolist() == [list(map(float, each)) for each in exact]
    assert 50 < sum(i < 0 for i, _ in exact) < len(RINGS) - 50


@pytest.mark.parametrize("shift", [0, 3])
def test_the_first_edges_of_two_polygons_that_meet_are_named(shift):
    others = [ring + shift for ring in RINGS[1:] + RINGS[:1]]
    rows = rows_of(RINGS + others)
    data = np.concatenate(RINGS + others)
    found = run(
        "touching_edges", data, np.column_stack([rows[: len(RINGS)], rows[len(RINGS) :]]), 2
    )
    exact = [touching(*pair) for pair in zip(RINGS, others, strict=True)]
    assert found.tolist() == [list(map(float, each)) for each in exact]
    assert 50 < sum(i >= 0 for i, _ in exact) < len(RINGS) - 50


def test_a_polygon_of_many_vertices_is_searched_to_its_last_edge():
    turns = 2 * np.pi * np.arange(300) / 300
    ring = np.column_stack([np.cos(turns), np.sin(turns)])
    crossed = ring.copy()
    crossed[-1] *= -1.5
    found = run("crossing_edges", np.concatenate([ring, crossed]), [[0, 300], [300, 300]], 2)
    assert found[0].tolist() == [-1.0, -1.0]
    assert 140 < found[1, 0] < 160
    assert found[1, 1] in (298.0, 299.0)
    area = run("polygon_area", ring, [[0, 300]], 1)[0, 0]
    assert area == pytest.approx(150 * np.sin(2 * np.pi / 300), rel=1e-13)
