"""Slips within rounding of a kink, against roots bracketed in 60 digits that stand for rods an ulp off.

Feet on one line that meets the contact's tangent, its normal or the line of the force: there one force has
an interval of motions, or one motion an interval of forces, and a root of the force across the edge is
within rounding of where that interval begins.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
import pytest
from mechanics.builders import names
from mechanics.checked import INFINITE, UPRIGHT, solved
from mechanics.transcription import faults

import planar_pushing as pp


class Slip(NamedTuple):
    """A scene and a push that has one slip, and nothing else where it moves into the slider."""

    scene: pp.Scene
    angle: float
    magnitude: float
    modes: list[str]
    force: tuple[float, float]
    motion_x: float
    size: float
    """What `motion_x` is judged against: the pusher's motion, or its own where the root is apart."""


def scene(feet, weights, rod, law, *masses, weight=1.0) -> Any:
    """A scene whose unit of length is 1 and not the feet's extent, on which rounding depends."""
    slider = pp.Slider(rod_length=rod[0], rod_angle=rod[1], radius=1.0)
    friction = pp.SupportFriction(support=pp.Points(feet, weights), weight=weight)
    return pp.Scene(slider=slider, contact=law, effects=(friction, *masses))


LEFT, RIGHT = ["SLIP_LEFT"], ["SLIP_RIGHT"]
SLIPS = {
    "feet along the fence, a force of another twist": Slip(
        scene([(0, 0), (0, -0.25), (0, 2), (0, -1)],
              [0.45617609370601664, 0.8760964696924166, 0.5252657067809723, 0.3133915637634931],
              (3.0, UPRIGHT), pp.Coulomb(0.5), weight=14.135419044566488),
        1e-16, 5.0, LEFT, (3.40119967037, 6.80239934074), 4.459e-15, 5.0,
    ),
    "the force's line through a foot": Slip(
        scene([(0, 1), (0, -1)], [2, 1], (0.5, math.atan2(1, -2)), pp.Coulomb(0.0),
              weight=7.704645334914916),
        math.nextafter(UPRIGHT, 4.0), 1.0, LEFT, (0.0, 5.74270357047), -0.75, 1.0,
    ),
    "seven ghosts": Slip(
        scene([(-4.378600909780335, -0.17677669529663687), (-3.4947174332971502, -1.0606601717798212),
               (-5.2624843862635196, 0.7071067811865475)], [3, 1, 2],
              (4.555377605076972, 3 * math.pi / 4), INFINITE,
              pp.Inertia(gyration_radius=0.05, center=(1.0, 0.0)), weight=1.2182158791734496),
        1e-16, 2.5963571583920024, LEFT, (1.21314728796, 0.0), 0.0030348902170969753, 0.003,
    ),
    "three times one slip, a push off the axes": Slip(
        scene([(0.25, 0), (1.5, 0)], [2, 3], (4.928914172120723, 0.9118768164304993), INFINITE,
              pp.Inertia(mass=300.85062691320513, gyration_radius=1.1207798108471292, center=(1.0, 0.0))),
        2.9726634682893316, 0.001, RIGHT, (-0.10217381131, 0.0), -0.00021711297790588252, 0.0002,
    ),
    "three times one slip of friction alone": Slip(
        scene([(0.20710678118654746, 0.7071067811865476), (-1, 0), (0.5, 1), (1, 0)],
              [0.5077916449185094, 0.41558766572724126, 0.7912986456140222, 0.999076122600033],
              (0.5, 3 * math.pi / 4), pp.Coulomb(0.5)),
        1.5707963612115041, 271.07262556910786, RIGHT, (-0.270536702445, 0.541073404889), 0.0, 271.0,
    ),
    "feet on the rod, a pull off the axes": Slip(
        scene([(1, 0), (-1, 1.2246467991473532e-16)], [3, 1], (0.5, math.pi / 4), INFINITE),
        -0.3337774074895412, 1.0, ["SEPARATE", "STICK", "SLIP_LEFT"], (0.471404520791, 0.0),
        0.32761429547924747, 1.0,
    ),
}  # fmt: skip


@pytest.mark.parametrize("given", SLIPS.values(), ids=SLIPS)
def test_a_slip_at_a_kink_is_found_once_with_its_force(given):
    found = solved(given.scene, given.angle, given.magnitude)
    assert names(found) == given.modes
    slip = found[-1]
    assert slip.force == pytest.approx(given.force, rel=1e-9, abs=1e-9 * np.hypot(*given.force))
    assert abs(slip.contact_motion[0] - given.motion_x) <= 1e-7 * given.size


def test_feet_along_the_fence_of_which_one_just_holds_what_the_others_leave():
    """The middle foot's share is the force at rest to the digit, so whether a slip is there is rounding."""
    feet = [
        (-8.04004449379846, 0.39821403002689953),
        (-8.23915150881191, 1.3781917831276695),
        (-7.84093747878501, -0.5817637230738706),
    ]
    mass, rod = pp.Inertia(gyration_radius=1.8443127836501367), (10.0, 1.3703497203542114)
    own = scene(feet, [2, 3, 1], rod, pp.Coulomb(1.0), mass, weight=437.37102864753484)
    assert names(solved(own, math.pi, 334.5625080874837))[0] == "SEPARATE"


#: Rod angle in degrees at which a push starts to turn three equal feet about the first.
ONSET = 21.228146214862


@pytest.mark.parametrize("ahead", [10.0**-n for n in range(5, 13)])
def test_the_force_of_a_pivot_that_begins_is_on_the_line_of_force(ahead):
    """Just behind the onset the root is next to the kink, which a step from one side passes."""
    feet = [(1, 0), (-0.5, math.sqrt(0.75)), (-0.5, -math.sqrt(0.75))]
    force = UPRIGHT - math.atan(0.25)
    before, after = (
        pp.limit_curve(scene(feet, [1, 1, 1], (2.0, math.radians(rod)), pp.Coulomb(0.25)), force)
        for rod in (ONSET + ahead, ONSET - ahead)
    )
    assert after.magnitude == pytest.approx(before.magnitude, abs=0.1 * ahead, rel=1e-12)
    assert after.spin_ratio == pytest.approx(before.spin_ratio, abs=0.1 * ahead, rel=1e-12)


class Hinge(NamedTuple):
    """A push of a table that turns by -1 about its middle foot, which lies on the line of the force.

    Feet at 0 and at (+-1, 0) have friction 2 and 1; mass and radius of gyration are 1. A load with the
    torque -3 about the middle foot therefore turns the slider by ``-(3 - 2)``, and neither the outer feet
    nor the mass add a force: the foot holds any force f if f and the load add up to no more than 2.
    """

    law: Any
    contact: tuple[float, float]
    load: tuple[float, float]
    load_at: tuple[float, float]
    ahead: float
    """The pusher's motion along the fence relative to that of the slider at the contact."""
    modes: list[str]
    ends: list[tuple[float, float]]


EDGE = (1 / math.sqrt(5), 2 / math.sqrt(5))
#: Ends of the forces along an edge (+-1, 2) that differ from (0, 3) by no more than 2.
NEAR, FAR = (6 - math.sqrt(11)) / 5, (6 + math.sqrt(11)) / 5
DOWN, ALONG, COUPLE = ((0, -3), (1, 0)), ((3, 0), (0, 1)), ((0, -1), (3, 0))
HINGES = {
    "without friction": Hinge(pp.Coulomb(0.0), (0, -1), *DOWN, 1.5, LEFT, [(0, 1), (0, 5)]),
    "without friction, a slow fence": Hinge(
        pp.Coulomb(0.0), (0, -1), *DOWN, -0.5, RIGHT, [(0, 1), (0, 5)]
    ),
    "without friction, a stick": Hinge(
        pp.Coulomb(0.0), (0, -1), *DOWN, 0.0, ["STICK"], [(0, 1), (0, 5)]
    ),
    "without friction, beyond the foot": Hinge(
        pp.Coulomb(0.0), (0, 2), *DOWN, -1.0, RIGHT, [(0, 1), (0, 5)]
    ),
    "the foot holds without the contact": Hinge(
        pp.Coulomb(0.0), (0, -1), *COUPLE, -1.5, RIGHT, [(0, 0), (0, 3)]
    ),
    "a left edge": Hinge(
        pp.Coulomb(0.5), (EDGE[0], -EDGE[1]), *DOWN, -1.0, RIGHT, [(-NEAR, 2 * NEAR), (-FAR, 2 * FAR)]
    ),
    "a right edge": Hinge(
        pp.Coulomb(0.5), (-EDGE[0], -EDGE[1]), *DOWN, 1.0, LEFT, [(NEAR, 2 * NEAR), (FAR, 2 * FAR)]
    ),
    "infinite friction": Hinge(
        INFINITE, (2, 0), *ALONG, -1.0, ["STICK", *RIGHT], [(-1, 0), (-5, 0)]
    ),
    "at the foot, without friction": Hinge(pp.Coulomb(0.0), (0, 0), *DOWN, 1.0, LEFT, [(0, 1), (0, 5)]),
    "at the foot, with friction": Hinge(
        pp.Coulomb(0.5), (0, 0), *DOWN, 1.0, LEFT, [(NEAR, 2 * NEAR), (FAR, 2 * FAR)]
    ),
    "at the foot, infinite friction": Hinge(
        INFINITE, (0, 0), *ALONG, -1.0, ["SEPARATE", "STICK", *RIGHT], [(-1, 0), (-5, 0)]
    ),
}  # fmt: skip
IMAGES = [
    (origin, turn, mirror)
    for origin in ((0, 0), (0.5, 0.5), (0.3, -0.7)) for turn in (0.0, 0.7) for mirror in (1, -1)
]  # fmt: skip


@pytest.mark.parametrize("hinge", HINGES.values(), ids=HINGES)
def test_a_slip_about_a_foot_on_the_line_of_its_force_has_both_ends_of_the_interval(hinge):
    for origin, turn, mirror in IMAGES:
        own, angle, magnitude = image_of(hinge, origin, turn, mirror)
        found = pp.solve(own, angle, magnitude)
        there = hinge.modes if mirror > 0 else [MIRRORED.get(mode, mode) for mode in hinge.modes]
        assert names(found) == there
        if any(hinge.ends[0]):
            assert faults(own, angle, magnitude, found) == []
        slip = found[-1]
        assert slip.pivot == 0
        assert not slip.continuum
        assert slip.twist[2] == pytest.approx(-mirror, rel=1e-12, abs=0)
        ends = [(mirror * x, y) for x, y in hinge.ends]
        assert slip.force == pytest.approx(ends[0], abs=1e-12)
        assert slip.force_end == pytest.approx(ends[1], abs=1e-12)


MIRRORED = {"SLIP_LEFT": "SLIP_RIGHT", "SLIP_RIGHT": "SLIP_LEFT"}


def image_of(hinge, origin, turn, mirror):
    """The scene of a hinge in another body frame, and the pusher's angle and magnitude."""
    c, s = math.cos(turn), math.sin(turn)

    def vector(x, y):
        return c * mirror * x - s * y, s * mirror * x + c * y

    def position(x, y):
        return vector(x - mirror * origin[0], y - origin[1])

    feet = [position(x, 0) for x in (0, 1, -1)]
    effects = (
        pp.SupportFriction(support=pp.Points(feet, [2, 1, 1]), weight=4.0),
        pp.Inertia(gyration_radius=1.0, center=position(0, 0)),
        pp.Load(force=vector(*hinge.load), center=position(*hinge.load_at)),
    )
    own = pp.scene_at(position(*hinge.contact), vector(0, 1), effects=effects, contact=hinge.law)
    w_x, w_y = mirror * (hinge.contact[1] + hinge.ahead), -hinge.contact[0]
    angle = math.atan2(w_y, w_x) if w_y else math.pi * (w_x < 0)
    return own, angle, math.hypot(w_x, w_y)


def test_the_force_of_an_interval_has_no_derivatives():
    own, angle, magnitude = image_of(HINGES["without friction"], (0.3, -0.7), 0.7, 1)
    (slip,) = pp.solve(own, angle, magnitude, derivatives=True)
    assert slip.derivatives.status is pp.Smoothness.CHANGE
    assert np.isnan(slip.derivatives.force_by_motion).all()


def test_a_batch_has_both_ends_of_the_interval():
    own, angle, magnitude = image_of(HINGES["a right edge"], (0, 0), 0.0, 1)
    both = pp.solve(own, np.array([angle, angle]), magnitude)
    assert both.force[:, 0] == pytest.approx(np.tile([NEAR, 2 * NEAR], (2, 1)), abs=1e-12)
    assert both.force_end[:, 0] == pytest.approx(np.tile([FAR, 2 * FAR], (2, 1)), abs=1e-12)


@pytest.mark.parametrize("angle", [1e-13, 1e-16, math.pi - 1e-13])
def test_two_ends_of_a_continuum_that_are_one_motion_are_one_slip(angle):
    """Three feet along the fence, so that one force along the normal has an interval of motions."""
    support = pp.Points([(0, 0), (0, -1), (0, 1)], [3, 1, 1])
    own = pp.Scene(
        slider=pp.Slider(rod_length=0.5, rod_angle=UPRIGHT, radius=1.0), contact=pp.Coulomb(0.0),
        effects=(pp.SupportFriction(support=support, weight=1.0),),
    )  # fmt: skip
    found = pp.solve(own, angle, 1.0)
    assert names(found) == ["SLIP_LEFT" if angle < 1 else "SLIP_RIGHT"]


@pytest.mark.parametrize("weight", [0.5, 0.5476131253435219, 0.7])
def test_a_continuum_of_pivots_ends_where_the_friction_of_the_foot_is_at_its_share(weight):
    """Turning by u / 3 about the far foot takes ``W / 3 + u / 12`` from it, and its share is W / 2."""
    mass = pp.Inertia(mass=0.5, gyration_radius=0.5, center=(0, -0.5))
    own = scene(
        [(1, 0), (-1, 0), (0.5, 0)], [3, 1, 2], (2.0, UPRIGHT), pp.Coulomb(2.0), mass, weight=weight
    )
    slip = solved(own, 0.0, 2.0)[-1]
    assert (slip.mode.name, slip.pivot, slip.continuum) == ("SLIP_LEFT", 0, True)
    assert slip.contact_motion[0] == pytest.approx(2 * weight, rel=1e-11, abs=0)
    assert slip.force == pytest.approx((weight / 3, weight / 6), rel=1e-11, abs=0)
