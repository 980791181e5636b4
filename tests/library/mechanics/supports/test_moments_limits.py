"""Limits between supports: polygons to a disc, points to a ring, cells to a polygon, and all from afar."""

from __future__ import annotations

import numpy as np
import pytest
from mechanics.supports.cases import SUPPORTS, rectangle, regular

from planar_pushing.mechanics.pressure.table import moments, table_of_pieces
from planar_pushing.mechanics.supports.annulus import Annulus
from planar_pushing.mechanics.supports.disc import Disc
from planar_pushing.mechanics.supports.even_ring import Ring
from planar_pushing.mechanics.supports.points import Points
from planar_pushing.mechanics.supports.polygon import Polygon
from planar_pushing.mechanics.supports.pressure_map import PressureMap
from planar_pushing.mechanics.supports.segment import Segment


def at(support, c):
    return np.array(moments(table_of_pieces(support.pieces(), 1.0), float(c[0]), float(c[1]))[:4])


def gaps(make, limit, c, counts):
    return [np.abs(at(make(count), c) - at(limit, c)).max() for count in counts]


@pytest.mark.parametrize("c", [(0.4, 0.1), (1.5, -0.6), (7.0, 3.0)])
def test_polygons_approach_the_disc_with_the_square_of_their_sides(c):
    first, second = gaps(lambda n: Polygon(regular(n)), Disc(1.0), c, (200, 400))
    assert first / second == pytest.approx(4.0, rel=0.01)


@pytest.mark.parametrize(("inside", "rate"), [(0.5, 0.5), (0.8, 0.8), (1 / 0.7, 0.7)])
def test_points_approach_the_ring_exponentially_away_from_it(inside, rate):
    """The sum over even points is the trapezoidal rule of a function that is analytic near the circle."""

    def make(count):
        return Points(regular(count), np.ones(count))

    first, second = gaps(make, Ring(), (inside, 0.0), (10, 20))
    assert second / first == pytest.approx(rate**10, rel=0.4, abs=0)


def test_points_approach_the_ring_on_it_with_the_square_of_their_number():
    def make(count):
        return Points(regular(count), np.ones(count))

    c = regular(1)[0]
    distance = [at(make(n), c)[0] - at(Ring(), c)[0] for n in (100, 200)]
    assert distance[0] / distance[1] == pytest.approx(4.0, rel=1e-3)


def test_annuli_approach_the_ring_and_the_disc():
    for c in [(0.4, 0.0), (1.3, 0.8)]:
        ring = gaps(lambda gap: Annulus(1 - gap, 1.0), Ring(), c, (2e-3, 1e-3))
        assert ring[0] / ring[1] == pytest.approx(2.0, rel=0.01)
        disc = gaps(lambda inner: Annulus(inner, 1.0), Disc(1.0), c, (2e-3, 1e-3))
        assert disc[0] / disc[1] == pytest.approx(4.0, rel=0.01)


def test_a_thin_rectangle_approaches_a_segment():
    line = Segment((-1.0, 0.0), (1.0, 0.0))
    for c in [(0.4, 0.5), (1.5, 0.3)]:
        first, second = gaps(lambda width: rectangle(1.0, width), line, c, (2e-3, 1e-3))
        assert first / second == pytest.approx(4.0, rel=0.01)


def test_even_cells_are_their_rectangle():
    cells = PressureMap(np.linspace(-2, 2, 12), np.linspace(-1, 1, 10), np.ones((9, 11)))
    for c in [(0.4, 0.3), (2.0, 1.0), (3.3, 1.9), (9.0, -20.0)]:
        assert at(cells, c) == pytest.approx(at(rectangle(2.0, 1.0), c), abs=2e-14)


@pytest.mark.parametrize("name", SUPPORTS)
def test_every_support_is_a_point_from_afar(name):
    """The mean distance is the distance, the force has the weight, and the torque vanishes."""
    support, _ = SUPPORTS[name]
    middle, size = np.array(support.center_of_pressure), support.extent
    for distance in (1e3, 1e6, 1e9):
        c = middle + size * distance * np.array([0.6, 0.8])
        found = at(support, c)
        assert found[0] == pytest.approx(size * distance, rel=1 / distance**2 + 1e-14)
        assert found[1:3] == pytest.approx([-0.6, -0.8], abs=1 / distance**2 + 1e-15)
        assert 0 <= found[3] + 1e-15 * size <= size / distance + 1e-15 * size


@pytest.mark.parametrize("name", ["square", "disc", "ring", "segment"])
def test_the_torque_from_afar_is_the_spread_over_the_distance(name):
    """Twice the excess of D: the mean square across the line of sight over the distance."""
    support, _ = SUPPORTS[name]
    middle = np.array(support.center_of_pressure)
    spread = {"square": 1 / 3, "disc": 0.7**2 / 4, "ring": 1.3**2 / 2}
    sight = np.array([0.6, 0.8])
    if name == "segment":
        along = (np.array(support.end) - support.start) / 2
        spread[name] = np.cross([*sight, 0], [*along, 0])[2] ** 2 / 3
    found = at(support, middle + 1e7 * sight)
    assert found[3] == pytest.approx(spread[name] / 1e7, rel=1e-12, abs=0)
