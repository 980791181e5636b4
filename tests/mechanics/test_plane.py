"""Directions and the plane's conventions."""

from __future__ import annotations

import numpy as np
import pytest
from mpmath import mp, mpf

from mechanics.builders import PSI
from planar_pushing.mechanics.plane import (
    contact_motion,
    contact_motion_angle,
    direction,
    moment_arm,
    motion_center,
    rod,
    toward,
)

OWN = rod(2.0, PSI)


@pytest.mark.parametrize("quarters", range(-4, 5))
def test_direction_is_exact_at_quarter_turns(quarters):
    vector = direction(quarters * (np.pi / 2))
    expected = [(1, 0), (0, 1), (-1, 0), (0, -1)][quarters % 4]
    assert np.array_equal(vector, expected)


def test_direction_elsewhere():
    angle = np.array([[0.3, 1.0], [2.0, np.nextafter(np.pi, 0)]])
    vectors = direction(angle)
    assert vectors.shape == (2, 2, 2)
    assert np.array_equal(vectors[..., 0], np.cos(angle))
    assert np.array_equal(vectors[..., 1], np.sin(angle))
    assert vectors[1, 1, 1] > 0


def test_moment_arm_sign():
    """A force right of the ring center turns the slider counterclockwise."""
    assert moment_arm(OWN, toward(OWN, 0.0)) == pytest.approx(np.sqrt(2))
    assert moment_arm(OWN, toward(OWN, np.pi / 2)) == pytest.approx(-np.sqrt(2))
    assert moment_arm(OWN, toward(OWN, PSI)) == 0


@pytest.mark.parametrize("angle", [0.0, np.pi, 5e-324, np.nextafter(np.pi, 0)])
def test_parts_along_an_upright_rod_are_exact(angle):
    seen = toward(rod(2.0, np.pi / 2), angle)
    assert (seen.along, seen.aside) == (seen.y, seen.x)
    assert (seen.x, seen.y) == tuple(direction(angle))


@pytest.mark.parametrize("lean", [0.0, 1e-13, -1e-9, 0.3, np.pi / 2 + 1e-12])
def test_parts_along_a_leaning_rod_do_not_cancel(lean):
    """Known to the rounding of the angles, about 1e-16."""
    seen = toward(OWN, PSI - lean)
    assert seen.along == pytest.approx(np.cos(lean), rel=1e-15, abs=4e-16)
    assert seen.aside == pytest.approx(np.sin(lean), rel=1e-15, abs=4e-16)


@pytest.mark.parametrize("psi", [PSI, 1e-3, 2.5])
@pytest.mark.parametrize("turn", [-7.3, -np.pi, -np.pi / 2, -1e-9, 1e-3, 1.0, np.pi / 2, np.pi])
def test_parts_along_a_rod_are_those_of_the_exact_angles(psi, turn):
    """Across and along the rod a part is as small as the rounding of the angles' difference."""
    angle = psi + turn
    seen = toward(rod(1.0, psi), angle)
    with mp.workdps(40):
        lean = mpf(psi) - mpf(angle)
        assert abs(seen.along / mp.cos(lean) - 1) <= 1e-15
        assert abs(seen.aside / mp.sin(lean) - 1) <= 1e-15


def test_contact_moves_with_the_center_and_around_it():
    """``u = (v_x + omega l sin psi, v_y - omega l cos psi)``."""
    found = contact_motion(OWN, 0.3, -0.2, 0.7)
    expected = 0.3 + 0.7 * 2 * np.sin(PSI), -0.2 - 0.7 * 2 * np.cos(PSI)
    assert found == pytest.approx(expected, rel=1e-15, abs=0)


def test_infinite_spin_ratio_moves_the_contact_across_the_rod():
    for angle, ratio, across in ((0.1, np.inf, -1), (2.0, -np.inf, 1)):
        found = contact_motion_angle(OWN, toward(OWN, angle), ratio)
        assert found == pytest.approx(PSI + across * np.pi / 2)


@pytest.mark.parametrize("ratio", [-3.0, 0.0, 0.4, 1e9])
def test_contact_moves_along_the_force_and_across_the_rod(ratio):
    """Along ``f + k l (sin psi, -cos psi)``."""
    force = toward(OWN, PSI - np.sign(ratio) * 0.6)
    x, y = force.x + 2 * ratio * np.sin(PSI), force.y - 2 * ratio * np.cos(PSI)
    assert contact_motion_angle(OWN, force, ratio) == pytest.approx(
        np.arctan2(y, x), rel=1e-14, abs=0
    )


def test_motion_center_of_a_translation_and_of_a_spin():
    ring_center = 2.0 * direction(PSI)
    assert np.all(np.isinf(motion_center(OWN, 0.3, 0.4, 0.0)))
    assert motion_center(OWN, 0.0, 0.0, 1.5) == pytest.approx(ring_center)
    along_normal = motion_center(OWN, 0.0, 1.0, 0.0)
    assert np.isinf(along_normal[0])
    assert along_normal[1] == pytest.approx(ring_center[1])


def test_motion_center_is_where_nothing_moves():
    v_x, v_y, spin = 0.4, -0.9, 1.7
    offset = np.array(motion_center(rod(3.0, PSI), v_x, v_y, spin)) - 3.0 * direction(PSI)
    velocity = np.array([v_x, v_y]) + spin * np.array([-offset[1], offset[0]])
    assert velocity == pytest.approx([0, 0], abs=1e-15)
