"""Solutions of one push: their order, their centers, and the angle of the pusher."""

from __future__ import annotations

import numpy as np
import pytest
from mechanics.builders import EVERY_EFFECT, PSI, make_scene, names

import planar_pushing as pp
from planar_pushing.mechanics.plane import direction


def test_solutions_are_an_iterable_of_known_length():
    solutions = pp.solve(make_scene(2.0, 2.0), np.deg2rad(-10))
    assert len(solutions) == len(list(solutions)) == len(solutions.modes) == 3
    assert solutions.modes == tuple(sorted(solutions.modes))


@EVERY_EFFECT
def test_a_slider_at_rest_has_no_center_and_no_spin(effects):
    (separate,) = pp.solve(make_scene(2.0, 2.0, effects), np.deg2rad(-90))
    still = [pp.solve(make_scene(2.0, 2.0, effects), angle, 0.0) for angle in (-1.0, 0.0, 1.0)]
    for each in (separate, *(one for found in still for one in found)):
        assert not each.twist.any()
        assert each.spin_ratio == 0
        assert np.isnan(each.center).all()
    assert separate.mode is pp.ContactMode.SEPARATE


def test_a_slider_that_separates_under_a_load_moves_and_has_a_center():
    effects = (
        pp.RingFriction(weight=0.5),
        pp.Inertia(),
        pp.Load(force=(0.0, 1.0), center=(0.3, 0)),
    )
    found = pp.solve(make_scene(2.0, 2.0, effects), np.deg2rad(-90))
    (separate,) = found.of(pp.ContactMode.SEPARATE)
    assert separate.twist.any()
    assert not np.isnan(separate.center).any()


@EVERY_EFFECT
def test_center_and_twist_agree(effects):
    scene = make_scene(3.0, 2.0, effects, radius=0.5)
    (stick,) = pp.solve(scene, 1.0, 2.0)
    vx, vy, omega = stick.twist
    offset = stick.center - 3.0 * direction(PSI)
    assert [vx - omega * offset[1], vy + omega * offset[0]] == pytest.approx([0, 0], abs=1e-12)
    contact = [vx + omega * 3 * np.sin(PSI), vy - omega * 3 * np.cos(PSI)]
    assert stick.contact_motion == pytest.approx(contact, rel=1e-12, abs=0)
    assert stick.contact_motion == pytest.approx(2 * direction(1.0), rel=1e-12, abs=0)
    assert abs(stick.spin_ratio) == pytest.approx(
        0.5 * abs(omega) / np.hypot(vx, vy), rel=1e-12, abs=0
    )


@EVERY_EFFECT
def test_pusher_angle_is_taken_modulo_a_turn(effects):
    scene = make_scene(2.0, 2.0, effects)
    for angle in (-0.1, 1.0, 3.0):
        for turns in (-1, 1):
            assert names(pp.solve(scene, angle + 2 * np.pi * turns)) == names(
                pp.solve(scene, angle)
            )
