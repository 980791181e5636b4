"""Warnings about pushes over time that are probably not meant as given."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

import planar_pushing as pp

CORNERS = [(-0.15, -0.1), (0.15, -0.1), (0.15, 0.1), (-0.15, 0.1)]
BOX = pp.Polygon(CORNERS)
GIVEN = {"effects": (pp.SupportFriction(support=BOX),), "contact": pp.Coulomb(0.5)}
INSIDE = pp.scene_at((0.05, -0.1), outline=BOX, **GIVEN)
CORNER = pp.scene_at((-0.15, -0.1), (0.3, 1), outline=BOX, **GIVEN)
ALONG = pp.scene_at(side=0, outline=BOX, **GIVEN)
FREE = pp.scene_at((0.05, -0.1), (0, 1), **GIVEN)
RODS = pp.Slider(rod_length=0.2, rod_angle=1.0, radius=0.1)
DIRECT = pp.Scene(slider=RODS, effects=(pp.RingFriction(),), contact=pp.Coulomb(0.5))
BOUNDED = pp.Scene(
    slider=pp.Slider(rod_length=0.2, rod_angle=1.0, radius=0.1, side=(-0.1, 0.1), outline=None),
    effects=(pp.RingFriction(),), contact=pp.Coulomb(0.5),
)  # fmt: skip
FENCE = pp.Pusher(velocity=(0, 0.05))
FENCE_SAID, WALL_SAID = "pusher: a fence at an inner point", "outline: none given"


def finger(radius):
    return pp.Pusher(velocity=(0, 0.05), shape="finger", radius=radius)


@pytest.mark.parametrize(
    ("scene", "pusher", "said"),
    [
        (INSIDE, FENCE, FENCE_SAID),
        (CORNER, FENCE, ""),
        (ALONG, FENCE, ""),
        (FREE, FENCE, ""),
        (DIRECT, FENCE, ""),
        (INSIDE, finger(0.0), ""),
        (INSIDE, finger(0.29), ""),
        (INSIDE, finger(8.0), "radius: 8 of the finger, more than the size 0.360555 of the object"),
        (FREE, finger(0.0), WALL_SAID),
        (DIRECT, finger(0.1), ""),
        (DIRECT, finger(0.21), "radius: 0.21 of the finger, more than the size 0.2 of the object"),
        (BOUNDED, finger(0.0), ""),
    ],
)
@pytest.mark.parametrize("simulate", [pp.simulate, pp.simulate_batch])
def test_a_doubtful_push_warns_once_at_the_line_of_the_user(scene, pusher, said, simulate):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        simulate(scene, pusher, duration=0.01)
    assert [str(each.message)[: len(said)] for each in caught] == [said] * bool(said)
    for each in caught:
        assert (each.category, each.filename) == (pp.SceneWarning, __file__)


def test_one_of_many_fingers_is_enough():
    radii = np.array([0.01, 0.5, 0.02])
    with pytest.warns(pp.SceneWarning, match=r"radius: 0.5 of the finger.* one unit of length"):
        pp.simulate_batch(INSIDE, finger(radii), duration=0.01)


@pytest.mark.parametrize(
    "velocity",
    [(0, 1), [(0, (0, 1)), (1, (0, 2))], lambda t: (0.0, t), (np.array([0.0, 0.1]), 1.0)],
)
@pytest.mark.parametrize("acceleration", [(0, -0.5), lambda t: (0, 1)])
def test_an_acceleration_is_refused_with_what_to_give_instead(velocity, acceleration):
    said = r"acceleration: .*; allowed: none.*; give a velocity that changes.*lambda t:"
    with pytest.raises(pp.InvalidValue, match=said):
        pp.Pusher(velocity=velocity, acceleration=acceleration)


def test_a_log_says_where_the_center_of_mass_is():
    corners = [(0, -0.1), (0.3, -0.1), (0.3, 0.1), (0, 0.1)]
    friction = pp.SupportFriction(support=pp.Polygon(corners), weight=3.5)
    for given, center in ((None, (0.15, 0)), ((0.0, 0.0), (0, 0)), ((0.1, 0.05), (0.1, 0.05))):
        mass = pp.Inertia(mass=1.2, gyration_radius=0.1, center=given)
        scene = pp.scene_at(
            (0.19, -0.1), effects=(friction, mass), contact=pp.Coulomb(0.5), outline=corners,
            units=pp.Units(length="m"),
        )  # fmt: skip
        log = pp.simulate(scene, finger(0.0), duration=0.01)
        assert log.attrs["center_of_mass"] == pytest.approx(np.array(center), abs=1e-15)
        assert log.attrs["center_of_mass_units"] == "m"
    assert "center_of_mass" not in pp.simulate(DIRECT, FENCE, duration=0.01).attrs
