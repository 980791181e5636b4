"""What holds for every pressure: convexity, symmetry, scaling, and parts that add to a whole."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from mechanics.supports.cases import regular, rows_of

from planar_pushing.mechanics.pressure.table import moments, table_of_pieces
from planar_pushing.mechanics.supports.composite import Composite
from planar_pushing.mechanics.supports.disc import Disc
from planar_pushing.mechanics.supports.points import Points
from planar_pushing.mechanics.supports.polygon import Polygon
from planar_pushing.mechanics.supports.pressure_map import PressureMap
from planar_pushing.mechanics.supports.segment import Segment

numbers = st.floats(-1.0, 1.0).map(lambda x: round(x, 6))
places = st.tuples(numbers, numbers)
sizes = st.floats(0.1, 1.0)
shares = st.floats(0.05, 1.0)
angles = st.floats(0.0, 2 * np.pi)
centers = st.tuples(st.floats(-3.0, 3.0), st.floats(-3.0, 3.0))


@st.composite
def polygons(draw):
    """Polygons that a ray from a place inside leaves once: simple, and seldom convex."""
    reach = draw(st.lists(sizes, min_size=3, max_size=9))
    vertices = draw(places) + regular(len(reach)) * np.array(reach)[:, None]
    return Polygon(vertices if draw(st.booleans()) else vertices[::-1])


@st.composite
def points(draw):
    found = draw(st.lists(st.tuples(places, shares), min_size=1, max_size=6))
    return Points([place for place, _ in found], [share for _, share in found])


@st.composite
def segments(draw):
    start, length, angle = draw(places), draw(sizes), draw(angles)
    return Segment(start, np.array(start) + length * np.array([np.cos(angle), np.sin(angle)]))


@st.composite
def maps(draw):
    rows = draw(st.lists(st.lists(shares, min_size=3, max_size=3), min_size=2, max_size=2))
    return PressureMap(np.cumsum(draw(st.tuples(*[sizes] * 4))), [-0.5, 0.0, draw(sizes)], rows)


simple = st.one_of(points(), segments(), polygons(), st.builds(Disc, sizes, places))
composites = st.lists(st.tuples(shares, simple), min_size=2, max_size=4).map(Composite)
supports = st.one_of(simple, maps(), composites)


def moved(support, matrix, shift=(0.0, 0.0)):
    """The support after a rotation, a reflection or a stretch, and a shift."""
    matrix, shift = np.array(matrix), np.array(shift)
    match support:
        case Points():
            return Points(support.positions @ matrix.T + shift, support.weights)
        case Segment():
            return Segment(matrix @ support.start + shift, matrix @ support.end + shift)
        case Polygon():
            return Polygon(support.vertices @ matrix.T + shift)
        case Disc():
            size = np.sqrt(abs(np.linalg.det(matrix)))
            return Disc(size * support.radius, matrix @ support.center + shift)
    return Composite([(share, moved(each, matrix, shift)) for share, each in support.members])


def at(support, c):
    return moments(table_of_pieces(support.pieces(), 1.0), float(c[0]), float(c[1]))


def same(found, expected, distance):
    """Whether two sets of moments agree to rounding; second derivatives, next to a kink, do not count."""
    assert np.array(found) == pytest.approx(expected, abs=1e-13 * (1 + distance))


@given(supports, centers, centers, st.floats(0.0, 1.0))
def test_the_mean_distance_is_convex_and_the_unit_vector_its_slope(support, a, b, part):
    a, b = np.array(a), np.array(b)
    between = at(support, (1 - part) * a + part * b)
    first, last = at(support, a), at(support, b)
    rounding = 1e-13
    chord = (1 - part) * first.distance + part * last.distance
    assert between.distance <= chord + rounding
    assert last.distance >= first.distance - np.dot(first[1:3], b - a) - rounding


@given(supports, centers)
def test_bounds(support, c):
    """|G| <= 1, D between the distance to the center of pressure and that plus the extent, T >= 0."""
    found, middle = at(support, c), support.center_of_pressure
    distance = np.hypot(c[0] - middle[0], c[1] - middle[1])
    assert np.hypot(*found[1:3]) <= 1 + 1e-14
    assert distance - 1e-13 <= found.distance <= distance + support.extent + 1e-13
    assert -1e-13 <= found.torque <= support.extent + 1e-13
    assert found.xx >= -1e-9
    assert found.yy >= -1e-9


@given(st.one_of(simple, composites), centers, angles)
def test_rotation_and_reflection(support, c, angle):
    cosine, sine = np.cos(angle), np.sin(angle)
    found = at(support, c)
    for matrix in ([[cosine, -sine], [sine, cosine]], [[cosine, sine], [sine, -cosine]]):
        other = at(moved(support, matrix), np.array(matrix) @ c)
        expected = [found.distance, *(np.array(matrix) @ found[1:3]), found.torque]
        if found.atom < 0 and other.atom < 0:
            near = min(
                [
                    1.0,
                    *np.hypot(
                        *(rows_of(table_of_pieces(support.pieces(), 1.0), "atoms")[:, :2] - c).T
                    ),
                ]
            )
            assert np.array(other[:4]) == pytest.approx(expected, abs=1e-13 / near + 1e-13)


@given(maps(), centers)
def test_reflection_of_a_map(support, c):
    mirrored = PressureMap(support.x, [-y for y in support.y[::-1]], support.pressure[::-1])
    found, other = at(support, c), at(mirrored, (c[0], -c[1]))
    expected = [found.distance, found.unit_x, -found.unit_y, found.torque]
    same(other[:4], expected, np.hypot(*c))


@given(polygons(), centers, st.floats(-6.0, 6.0))
def test_scaling(support, c, power):
    size = 10.0**power
    found, scaled = at(support, c), at(moved(support, size * np.eye(2)), size * np.array(c))
    same([scaled.distance / size, *scaled[1:3], scaled.torque / size], found[:4], np.hypot(*c))


@given(places, st.lists(sizes, min_size=3, max_size=9), centers)
def test_a_polygon_is_its_triangles(middle, reach, c):
    vertices = middle + regular(len(reach)) * np.array(reach)[:, None]
    whole = Polygon(vertices)
    parts = [
        Polygon([middle, a, b])
        for a, b in zip(vertices, np.roll(vertices, -1, axis=0), strict=True)
    ]
    sizes_of_parts = reach * np.roll(reach, -1)
    together = Composite(list(zip(sizes_of_parts, parts, strict=True)))
    assert together.center_of_pressure == pytest.approx(whole.center_of_pressure, abs=1e-14)
    assert together.extent == pytest.approx(whole.extent, rel=1e-14, abs=0)
    same(at(together, c)[:4], at(whole, c)[:4], np.hypot(*c))


@given(maps(), centers)
def test_a_map_is_its_cells(support, c):
    cells = [
        (row[i] * (b - a) * (top - bottom), Polygon([(a, bottom), (b, bottom), (b, top), (a, top)]))
        for row, bottom, top in zip(support.pressure, support.y, support.y[1:], strict=False)
        for i, (a, b) in enumerate(zip(support.x, support.x[1:], strict=False))
    ]
    same(at(Composite(cells), c)[:4], at(support, c)[:4], np.hypot(*c))
