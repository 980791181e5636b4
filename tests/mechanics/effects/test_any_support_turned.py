"""A support seen from a turned rod is the turned support seen from the rod."""

import math

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.mechanics.effects.any_mass import MassAt
from planar_pushing.mechanics.effects.any_support import Supports, aligned, point
from planar_pushing.mechanics.effects.base import fastest, gradient, made, rough, wrench_about
from planar_pushing.mechanics.effects.inertia import Mass
from planar_pushing.mechanics.reduced.corners import corner_under
from planar_pushing.mechanics.reduced.line_of_force import Line
from planar_pushing.mechanics.supports.pressure.table import table_of

ANGLE = 0.7
C, S = math.cos(ANGLE), math.sin(ANGLE)
TURN = np.array([[C, -S], [S, C]])
CORNERS = np.array([(1.0, 0.2), (-0.4, 0.9), (-0.7, -0.8)])
SUPPORTS = {"polygon": pp.Polygon, "points": lambda places: pp.Points(places, [0.2, 0.5, 0.3])}
MOTIONS = [(1.0, 0.5, 0.3), (0.3, -0.2, 2.0), (0.0, 0.0, -1.0), (1.0, 0.0, 0.0)]


def effects(support, x=0.0, y=0.0):
    kinds = Supports(table_of([support])), MassAt(1.0, 1.0, 0.0, 0.0)
    return made(kinds, np.array([0.7, 1.3, 0.64, x, y, 0.0, support.extent]))


@pytest.fixture(params=SUPPORTS.values(), ids=SUPPORTS)
def pair(request):
    """The support seen from a turned rod, and the turned support."""
    build, (x, y) = request.param, TURN @ (0.3, -0.2)
    return aligned(effects(build(CORNERS), 0.3, -0.2), C, S), effects(build(CORNERS @ TURN.T), x, y)


@pytest.mark.parametrize("motion", MOTIONS, ids=str)
def test_gradients_are_those_of_the_turned_support(pair, motion):
    one, other = pair
    assert gradient(one, *motion) == pytest.approx(gradient(other, *motion), abs=1e-13)


def test_bounds_and_rough_values_are_those_of_the_turned_support(pair):
    for one, other in zip(*pair, strict=True):
        assert rough(one) == pytest.approx(rough(other), abs=1e-14)
        assert fastest(one, 1.5) == pytest.approx(fastest(other, 1.5), abs=1e-13)


def test_points_and_their_pivots_are_those_of_the_turned_support():
    build = SUPPORTS["points"]
    one, other = aligned(effects(build(CORNERS)), C, S), effects(build(CORNERS @ TURN.T))
    for i in range(3):
        assert point(one[0], i) == pytest.approx(point(other[0], i), abs=1e-14)
        x, y, _ = point(other[0], i)
        found = wrench_about(one, i, -0.6, x, y)
        assert found == pytest.approx(wrench_about(other, i, -0.6, x, y), abs=1e-13)


@pytest.mark.parametrize(
    "support",
    [pp.Segment((0, -1), (0, 1)), pp.Points([(0, -1), (0, 0.5), (0, 1)], [1.5, 1, 1])],
    ids=["segment", "points"],
)
def test_a_line_has_its_corner_from_every_side(support):
    """The contact is opposite to the middle of a line across, seen from the rod."""
    turned = (
        pp.Segment((1, 0), (-1, 0))
        if isinstance(support, pp.Segment)
        else pp.Points([(1, 0), (-0.5, 0), (-1, 0)], support.weights)
    )
    one = corner_under(effects(support)[:1], Line((), 2.0, 1.0, 0.0, 0.7))
    other = corner_under(aligned(effects(turned)[:1], 0.0, -1.0), Line((), 2.0, 1.0, 0.0, 0.7))
    assert one.exists
    assert other.exists
    ends = [sorted(map(tuple, corner[1:])) for corner in (one, other)]
    assert np.array(ends[0]) == pytest.approx(np.array(ends[1]), abs=1e-15)


def test_isotropic_effects_have_no_direction():
    assert aligned((Mass(1.3, 0.64),), C, S) == (Mass(1.3, 0.64),)
    assert aligned((MassAt(1.3, 0.64, 1.0, 0.0),), C, S)[0] == pytest.approx((1.3, 0.64, C, S))
