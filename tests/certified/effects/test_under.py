"""Enclosed motions under a line of force: published values, pivots, corners, symmetry, sticking."""

import math
from itertools import pairwise

import pytest
from flint import arb, ctx, fmpq

from certified.supports.cases import MAP, SQUARE, SUPPORTS, TRIPOD
from planar_pushing.certified import cones, setting
from planar_pushing.certified.balls import PRECISION, Undecided, in_degrees, rational
from planar_pushing.certified.contact.modes import INFINITE_FREE
from planar_pushing.certified.effects.cone_edges import edge, pivot_load
from planar_pushing.certified.effects.modes import edge as force_edge
from planar_pushing.certified.effects.under import under
from planar_pushing.certified.potential.direction import degrees, relative, returned
from planar_pushing.certified.potential.gradient import Motion, center, response
from planar_pushing.certified.potential.resistance import Friction, Load, Scene, resistance
from planar_pushing.certified.potential.sticking import stick
from planar_pushing.certified.supports.pressure.mirror import is_mirrored
from planar_pushing.certified.supports.pressure.pieces import pieces

RING, DISC = {"shape": "ring"}, {"shape": "disc", "radius": 1}
QUADRUPED = {
    "shape": "points",
    "positions": [(-1, -1), (1, -1), (1, 1), (-1, 1)],
    "weights": [1, 1, 1, 1],
}
ACROSS = {"shape": "segment", "start": (0, -1), "end": (0, 1)}
#: Distance of the center of rotation for offsets of the line of force, known from numerical integrals.
OFFSETS = [0.1, 0.25, 0.5, 1]
DISTANCES = [
    (DISC, (2.5820217533, 1.1927516849, 0.8269565546, 0.5471102677)),
    (RING, (5.0742673043, 2.1772547559, 1.3141186285, 1)),
    (SQUARE, (3.4805719766, 1.6035437776, 1.0015655201, 0.6766826421)),
]
#: Motion cones of a ring with a load at its center; l = 2, psi = 45 degrees, infinite friction.
LOADED = [
    ((0, -0.3), (-40.602404, 157.663777)),
    ((0.3, 0), (-29.819697, 145.278721)),
    ((-0.3, 0), (-34.721279, 150.180303)),
]


@pytest.fixture(autouse=True)
def _precision():
    with ctx.workprec(PRECISION):
        yield


def slider(length, *effects, rod=0):
    """A slider whose contact is on the body's x axis, its rod at an angle in degrees."""
    return resistance(Scene(rational(length), degrees(rational(rod)), effects))


def friction(entry):
    return Friction(pieces(entry), fmpq(1))


def line(total, turn):
    """A line of force at an angle from the rod, degrees."""
    return total.push(degrees(rational(turn)))


def moved(entry, length, turn):
    total = slider(length, friction(entry))
    return under(total, line(total, turn), fmpq(1))


def place(found, length):
    """Center of rotation, and the distance from the slider's origin along the rod."""
    return center(slider(length, friction(RING)), Motion(found.motion, found.spin))


@pytest.mark.parametrize(("entry", "distances"), DISTANCES)
def test_published_distances_of_the_center(entry, distances):
    for offset, distance in zip(OFFSETS, distances, strict=True):
        x, y = place(moved(entry, offset, 90), offset)
        assert abs(float(x) - distance) < 1e-10
        assert abs(float(y)) < 1e-25


@pytest.mark.parametrize(
    ("mu", "radians"), [(0.2, 0.7401183583), (0.5, 1.0591831566), (1.0, 1.2552928238)]
)
def test_published_edges_of_a_disc_pushed_on_its_rim(mu, radians):
    found = edge(pieces(DISC), fmpq(1), fmpq(90), mu, 1)
    assert abs(math.radians(90 - float(found.angle)) - radians) < 1e-10


@pytest.mark.parametrize(("force", "cone"), LOADED)
def test_published_cones_of_a_ring_with_a_load(force, cone):
    load = Load((rational(force[0]), rational(force[1])))
    total = slider(2, friction(RING), load, rod=45)
    for side, angle in zip((1, -1), cone, strict=True):
        push = total.push(relative(force_edge(INFINITE_FREE, side), degrees(fmpq(45))))
        x, y = returned(under(total, push, fmpq(1)).motion, total.rod)
        assert abs(float(in_degrees(arb.atan2(y, x))) - angle) < 1e-6


@pytest.mark.parametrize("mu", [0.5, 2.0, math.inf])
@pytest.mark.parametrize("length", [0.5, 2, 5])
def test_the_ring_moves_as_by_its_own_route(length, mu):
    one = setting.Slider.of(length, 60.0)
    wanted = cones.motion_cone(one, setting.Effects.FRICTION, mu)
    for side, ball in ((1, wanted.right), (-1, wanted.left)):
        found = edge(pieces(RING), rational(length), fmpq(60), mu, side)
        assert abs(float(found.angle - ball)) < 1e-30


@pytest.mark.parametrize("turn", [90, -30])
def test_a_line_that_touches_the_ring_turns_it_about_the_opposite_point(turn):
    length = fmpq(2) if turn == -30 else fmpq(1)
    x, y = place(moved(RING, length, turn), length)
    assert abs(float(x * x + y * y - 1)) < 1e-28


@pytest.mark.parametrize("name", ["square", "L", "map", "annulus", "composite", "triangle"])
def test_the_motion_leaves_no_torque_and_no_force_across(name):
    total = slider(3, friction(SUPPORTS[name]))
    push = line(total, 40)
    found = under(total, push, fmpq(1))
    now = response(total, Motion(found.motion, found.spin))
    assert (push.x * now.y - push.y * now.x).contains(0)
    assert now.torque.contains(0)
    assert found.spin.rel_accuracy_bits() > 120


@pytest.mark.parametrize(
    ("length", "pivot"),
    [(0.267, -1), (0.268, 0), (1, 0), (3.732, 0), (3.733, -1)],
)
def test_the_tripod_pivots_between_its_offsets(length, pivot):
    """At 2 - sqrt 3 = 0.26795 and 2 + sqrt 3 = 3.73205."""
    assert moved(TRIPOD, length, 90).pivot == pivot


def test_a_point_that_takes_just_its_share_is_open():
    """Three of four points at the corners of a square leave the fourth its share, exactly."""
    three = {
        "shape": "points",
        "positions": [(-4, -3), (4, -3), (4, 3), (-4, 3)],
        "weights": [1] * 4,
    }
    rod = pieces(three), fmpq(10), fmpq(90), 0.5, 1
    with pytest.raises(Undecided):
        edge(*rod)
    loads = [pivot_load(*rod, foot) for foot in range(4)]
    assert any(each is not None and abs(float(each - 1)) < 1e-30 for each in loads)


@pytest.mark.parametrize("length", [0.3, 2, 5])
@pytest.mark.parametrize("turn", range(-170, 180, 20))
def test_points_that_are_no_pivots_do_not_hold_the_method(length, turn):
    found = moved(QUADRUPED, length, turn)
    if found.pivot < 0:
        total = slider(length, friction(QUADRUPED))
        now, push = response(total, Motion(found.motion, found.spin)), line(total, turn)
        assert (push.x * now.y - push.y * now.x).contains(0)


def test_a_force_through_the_center_of_pressure_translates():
    for name in ("ring", "square"):
        found = moved(SUPPORTS[name], 2, 0)
        assert (found.motion, found.spin, found.force) == ((1, 0), 0, 1)


def test_a_corner_has_an_interval_of_motions():
    found = edge(pieces(ACROSS), fmpq(1), fmpq(45), 1.0, 1)
    assert float(found.force_angle) == 45
    assert [float(found.low), float(found.high)] == pytest.approx([0, 90], abs=1e-14)


def test_a_segment_along_the_rod_turns_about_a_place_on_it():
    x, y = place(moved({"shape": "segment", "start": (-1, 0), "end": (1, 0)}, 2, 90), 2)
    assert abs(float(y)) < 1e-25
    # D + (c - P) . G = 0 is x^2 + 4 x - 1 = 0.
    assert abs(float(x) - (math.sqrt(5) - 2)) < 1e-15


def test_mirrored_supports_move_along_a_force_across_the_rod():
    """Infinite friction along the fence, across the rod: the angle is exact."""
    assert is_mirrored(pieces(SQUARE))
    assert edge(pieces(SQUARE), fmpq(2), fmpq(90), math.inf, 1).angle == 0
    for entry in (MAP, SUPPORTS["L"]):
        assert not is_mirrored(pieces(entry))
        assert edge(pieces(entry), fmpq(2), fmpq(90), math.inf, 1).angle != 0


def test_motions_turn_with_the_force():
    """The map from force angle to motion angle increases, with flats where the slider pivots."""
    for entry in (SQUARE, TRIPOD, SUPPORTS["L"]):
        motions = [moved(entry, 2, turn).motion for turn in range(-180, 180, 15)]
        turns = [float(a * d - b * c) for (a, b), (c, d) in pairwise(motions)]
        assert all(each >= -1e-12 for each in turns)


# --- Sticking ------------------------------------------------------------------------------------


def stuck(entry, length, turn):
    total = slider(length, friction(entry))
    return stick(total, line(total, turn), fmpq(1))


@pytest.mark.parametrize("name", ["ring", "square", "L", "map", "points", "segment", "composite"])
@pytest.mark.parametrize("turn", [-100, 20, 75, 160])
def test_the_force_of_a_sticking_motion_causes_it(name, turn):
    x, y = stuck(SUPPORTS[name], 2, turn).force
    u, v = moved(SUPPORTS[name], 2, float(in_degrees(arb.atan2(y, x)))).motion
    assert abs((float(in_degrees(arb.atan2(v, u))) - turn + 180) % 360 - 180) < 1e-11


def test_a_motion_along_the_rod_of_a_centered_slider_is_a_translation():
    found = stuck(SQUARE, 2, 0)
    assert (found.spin, found.force, found.free) == (0, (1, 0), (0, 0))


def test_a_pivot_leaves_the_force_open():
    """Across the line from the contact to the first foot; its share is a third."""
    found = stuck(TRIPOD, 2, 90)
    assert found.pivot == 0
    assert abs(float(found.spin) - -1 / 3) < 1e-15
    for side in (-1, 1):
        x, y = (f + side * free for f, free in zip(found.force, found.free, strict=True))
        off = float(in_degrees(arb.atan2(y, x))) - 90
        for part, pivot in ((0.999, 0), (1.001, -1)):
            assert moved(TRIPOD, 2, 90 + part * off).pivot == pivot


@pytest.mark.parametrize("turn", [10, 45, -30])
def test_beyond_a_corner_the_force_is_across_the_line(turn):
    assert stuck(ACROSS, 1, turn).force == (1, 0)


def test_within_the_ends_of_a_line_it_is_not():
    assert abs(stuck(ACROSS, 1, 50).force[1]) > arb(10) ** -4
