"""Motions of the contact along the fence: the rotation without torque, the force across an edge."""

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.mechanics.effects.base import COLUMNS, made
from planar_pushing.mechanics.plane import rod, toward
from planar_pushing.mechanics.reduced.pressed.places import (
    Slide,
    first_place,
    place_at,
    rough_place,
)
from planar_pushing.mechanics.reduced.rotation import SETTLED, Motion, felt, rough_spin, turned

CORNERS = [(0.9, 0.1), (0.1, 0.7), (-0.8, 0.3), (-0.3, -0.9)]
SUPPORTS = {
    "polygon": pp.Polygon(CORNERS),
    "points": pp.Points(CORNERS, [1.0, 2.0, 1.5, 1.0]),
    "segment": pp.Segment((-0.5, 0.3), (0.6, 0.4)),
    "disc": pp.Disc(1.0, (0.2, 0.1)),
}


def effects_of(support, *masses):
    friction = pp.SupportFriction(support=support)
    slider = pp.Slider(rod_length=1.0, rod_angle=1.0, radius=1.0)
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(1.0), effects=(friction, *masses))
    row = np.zeros(COLUMNS)
    row[:7] = scene.weight, *scene.inertia, *scene.placement
    return made(scene.kinds, row)


def slides(support, count):
    """Motions along the fence with the edge that the force is on at one of them, and that place."""
    rng, effects = np.random.default_rng(1), effects_of(support, pp.Inertia())
    for _ in range(count):
        own, normal = rod(rng.uniform(0.3, 3.0), rng.uniform(0.3, 2.8)), rng.normal()
        x = rng.normal()
        u_x, u_y = x * own.x + normal * own.y, normal * own.x - x * own.y
        guess = rough_spin(effects, own.length, u_x, u_y)
        now = turned(effects, own.length, u_x, u_y, guess, SETTLED)[1]
        angle = np.arctan2(now.f_x * own.y + now.f_y * own.x, now.f_x * own.x - now.f_y * own.y)
        yield Slide(effects, own, toward(own, angle), normal), x


@pytest.mark.parametrize("name", SUPPORTS)
def test_a_rough_place_next_to_a_slip_has_the_right_sign(name):
    """Its own errors are far larger than the force across the edge."""
    for slide, x in slides(SUPPORTS[name], 40):
        for aside in (-1e-9, 1e-9):
            there = x + aside * (1.0 + abs(x))
            start = first_place(slide, there + 0.3)
            exact = place_at(slide, there, place_at(slide, there, start))
            assert rough_place(slide, there, start).across * exact.across > 0.0


@pytest.mark.parametrize("name", SUPPORTS)
@pytest.mark.parametrize("masses", [(), (pp.Inertia(gyration_radius=0.3),)], ids=["one", "both"])
def test_a_rotation_leaves_no_torque(name, masses):
    """Of the torque that turns the slider, only the rounding of the rotation is left."""
    rng, effects = np.random.default_rng(2), effects_of(SUPPORTS[name], *masses)
    for _ in range(300):
        length, angle = rng.uniform(0.1, 5.0), rng.uniform(-np.pi, np.pi)
        u_x, u_y = np.cos(angle), np.sin(angle)
        guess = rough_spin(effects, length, u_x, u_y)
        spin, _ = turned(effects, length, u_x, u_y, guess, SETTLED)
        left = felt(effects, length, Motion(u_x, u_y, spin))
        speed = 1.0 + abs(u_y + length * spin) + abs(spin)
        noise = left.ss * speed + (1.0 + length) * np.hypot(left.f_x, left.f_y)
        assert abs(left.torque) <= 2e-15 * noise
