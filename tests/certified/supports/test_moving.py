"""Enclosed motions of any support: published values, pivots, corners, symmetry, the ring's own route."""

import math
from itertools import pairwise

import pytest
from flint import arb, ctx, fmpq

from certified.supports.cases import MAP, SQUARE, SUPPORTS, TRIPOD
from planar_pushing.certified import cones, setting
from planar_pushing.certified.balls import PRECISION, Undecided, rational
from planar_pushing.certified.supports.cone_edges import edge
from planar_pushing.certified.supports.moving import moved
from planar_pushing.certified.supports.pressure.mirror import is_mirrored
from planar_pushing.certified.supports.pressure.moments import moments
from planar_pushing.certified.supports.pressure.pieces import pieces
from planar_pushing.certified.supports.push import at_angle, on_edge

RING, DISC = {"shape": "ring"}, {"shape": "disc", "radius": 1}
QUADRUPED = {
    "shape": "points",
    "positions": [(-1, -1), (1, -1), (1, 1), (-1, 1)],
    "weights": [1, 1, 1, 1],
}
#: Distance of the centre of rotation for offsets of the line of force, known from numerical integrals.
OFFSETS = [0.1, 0.25, 0.5, 1]
DISTANCES = [
    (DISC, (2.5820217533, 1.1927516849, 0.8269565546, 0.5471102677)),
    (RING, (5.0742673043, 2.1772547559, 1.3141186285, 1)),
    (SQUARE, (3.4805719766, 1.6035437776, 1.0015655201, 0.6766826421)),
]


@pytest.fixture(autouse=True)
def _precision():
    with ctx.workprec(PRECISION):
        yield


def under(entry, length, turn):
    """The motion under a force at an angle from the rod, degrees."""
    support = pieces(entry)
    return moved(lambda: at_angle(support, rational(length), fmpq(0), rational(turn)))


@pytest.mark.parametrize(("entry", "distances"), DISTANCES)
def test_published_distances_of_the_centre(entry, distances):
    for offset, distance in zip(OFFSETS, distances, strict=True):
        found = under(entry, offset, 90)
        assert abs(float(found.center[0]) - distance) < 1e-10
        assert found.center[1].contains(0)
        assert found.sense == -1


@pytest.mark.parametrize(
    ("mu", "degrees"), [(0.2, 0.7401183583), (0.5, 1.0591831566), (1.0, 1.2552928238)]
)
def test_published_edges_of_a_disc_pushed_on_its_rim(mu, degrees):
    found = edge(pieces(DISC), fmpq(1), fmpq(90), mu, 1)
    assert abs(math.radians(90 - float(found.angle)) - degrees) < 1e-10


@pytest.mark.parametrize("mu", [0.5, 2.0, math.inf])
@pytest.mark.parametrize("length", [0.5, 2, 5])
def test_the_ring_moves_as_by_its_own_route(length, mu):
    slider = setting.Slider.of(length, 60.0)
    wanted = cones.motion_cone(slider, setting.Effects.FRICTION, mu)
    for side, ball in ((1, wanted.right), (-1, wanted.left)):
        found = edge(pieces(RING), rational(length), fmpq(60), mu, side)
        assert (found.angle - ball).contains(0) or abs(float(found.angle - ball)) < 1e-30


def test_a_line_that_touches_the_ring():
    found = under(RING, 2, -30)
    beside = under(RING, 2, -30.0000001)
    assert abs(float(found.center[0] - beside.center[0])) < 1e-6
    assert abs(float(found.center[0] ** 2 + found.center[1] ** 2 - 1)) < 1e-30


@pytest.mark.parametrize("name", ["square", "L", "map", "annulus", "composite", "triangle"])
def test_the_centre_leaves_no_torque_and_no_force_across(name):
    support = pieces(SUPPORTS[name])
    push = at_angle(support, fmpq(3), fmpq(30), fmpq(70))
    c = tuple(each.mid() for each in moved(lambda: push).center)
    now = moments(support, c)
    assert abs(float(now.x * push.x + now.y * push.y)) < 1e-50
    assert abs(float(now.torque(c, push.contact))) < 1e-50


@pytest.mark.parametrize(
    ("length", "pivot"),
    [(0.267, -1), (0.268, 0), (1, 0), (3.732, 0), (3.733, -1)],
)
def test_the_tripod_pivots_between_its_offsets(length, pivot):
    """At 2 - sqrt 3 = 0.26795 and 2 + sqrt 3 = 3.73205."""
    assert under(TRIPOD, length, 90).pivot == pivot


def test_a_point_that_takes_just_its_share_is_open():
    """Three of four points at the corners of a square leave the fourth its share, exactly."""
    three = {
        "shape": "points",
        "positions": [(-4, -3), (4, -3), (4, 3), (-4, 3)],
        "weights": [1] * 4,
    }
    with pytest.raises(Undecided):
        moved(lambda: on_edge(pieces(three), fmpq(10), fmpq(90), 0.5, 1))


@pytest.mark.parametrize("length", [0.3, 2, 5])
@pytest.mark.parametrize("turn", range(-170, 180, 20))
def test_points_that_are_no_pivots_do_not_hold_the_method(length, turn):
    found = under(QUADRUPED, length, turn)
    if found.pivot < 0:
        now = moments(pieces(QUADRUPED), found.center)
        t = arb(turn) / 180
        assert (now.x * t.cos_pi() + now.y * t.sin_pi()).contains(0)


def test_a_force_through_the_centre_of_pressure_translates():
    for name in ("ring", "square"):
        found = under(SUPPORTS[name], 2, 0)
        assert (found.center, found.turns, float(found.force)) == (None, (0, 0), 1.0)
        assert found.spin_ratio(arb(1)) == 0


def test_a_corner_has_an_interval_of_motions():
    across = {"shape": "segment", "start": (0, -1), "end": (0, 1)}
    low, high = under(across, 1, 0).turns
    assert abs(float(low) + 45) < 1e-30
    assert abs(float(high) - 45) < 1e-30


def test_a_segment_along_the_rod_turns_about_a_place_on_it():
    along = {"shape": "segment", "start": (-1, 0), "end": (1, 0)}
    found = under(along, 2, 90)
    assert found.center[1] == 0
    # D + (c - P) . G = 0 is x^2 + 4 x - 1 = 0.
    assert abs(float(found.center[0]) - (math.sqrt(5) - 2)) < 1e-15
    assert found.turns == (0, 0)


def test_mirrored_supports_move_along_a_force_across_the_rod():
    assert is_mirrored(pieces(SQUARE))
    assert not is_mirrored(pieces(MAP))
    assert not is_mirrored(pieces(SUPPORTS["L"]))
    assert under(SQUARE, 2, 90).turns == (0, 0)
    assert under(MAP, 2, 90).turns[0] != 0


def test_motions_turn_with_the_force():
    """The map from force angle to motion angle increases, with flats where the slider pivots."""
    for entry in (SQUARE, TRIPOD, SUPPORTS["L"]):
        angles = [turn + float(under(entry, 2, turn).turns[0]) for turn in range(-180, 180, 5)]
        assert all(b >= a - 1e-12 for a, b in pairwise(angles))
