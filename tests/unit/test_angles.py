"""Angle intervals, directions and the plane's conventions."""

from __future__ import annotations

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.mechanics.plane import (
    contact_motion_angle,
    direction,
    moment_arm,
    motion_center,
    parts_along_rod,
)
from unit.builders import PSI


def test_closed_interval_contains_its_edges_and_every_turn_of_them():
    interval = pp.AngleInterval(-0.5, 1.0)
    angles = np.array([-0.5, 0.0, 1.0])
    for turns in (-2, 0, 1, 3):
        assert np.all(interval.contains(angles + 2 * np.pi * turns))
    assert not np.any(interval.contains([-0.5 - 1e-9, 1 + 1e-9, np.pi, -3.0]))


def test_open_interval_does_not_contain_its_edges():
    interval = pp.AngleInterval(0.0, np.pi, closed=False)
    assert not np.any(interval.contains([0.0, np.pi, -np.pi, 2 * np.pi, -1e-17]))
    assert np.all(interval.contains([1e-9, 1.0, np.pi - 1e-9, 1 + 2 * np.pi]))


def test_edges_are_reached_within_rounding_only():
    closed = pp.AngleInterval(0.0, 1.0)
    assert np.all(closed.contains([-1e-16, 1 + 2.3e-16]))
    assert not np.any(closed.contains([-1e-14, 1 + 1e-14]))


def test_degenerate_interval_is_one_direction():
    interval = pp.AngleInterval(1.2, 1.2)
    assert interval.span == 0
    assert interval.contains(1.2)
    assert not interval.contains(1.2 + 1e-9)
    assert not pp.AngleInterval(1.2, 1.2, closed=False).contains(1.2)


def test_full_turn_contains_everything():
    interval = pp.PerfectlyRough().force_angles
    assert interval.span == pytest.approx(2 * np.pi)
    assert np.all(interval.contains(np.linspace(-10, 10, 1001)))


def test_contains_keeps_the_shape():
    assert pp.AngleInterval(0.0, 1.0).contains(np.zeros((2, 3))).shape == (2, 3)
    assert pp.AngleInterval(0.0, 1.0).contains(0.5).shape == ()
    assert pp.AngleInterval(0.25, 1.0).span == 0.75


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
    """A force right of the ring centre turns the slider counter-clockwise."""
    assert moment_arm(2.0, PSI, 0.0) == pytest.approx(np.sqrt(2))
    assert moment_arm(2.0, PSI, np.pi / 2) == pytest.approx(-np.sqrt(2))
    assert moment_arm(2.0, PSI, PSI) == 0


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_parts_along_an_upright_rod_are_exact(side):
    along, aside = parts_along_rod(np.pi / 2, np.array([side, 5e-324]))
    assert (along, aside) == (5e-324, side)


@pytest.mark.parametrize("lean", [0.0, 1e-13, -1e-9, 0.3, np.pi / 2 + 1e-12])
def test_parts_along_a_leaning_rod_do_not_cancel(lean):
    """Known to the rounding of the angles, about 1e-16."""
    along, aside = parts_along_rod(PSI, direction([PSI - lean]))
    assert along == pytest.approx(np.cos(lean), rel=1e-15, abs=4e-16)
    assert aside == pytest.approx(np.sin(lean), rel=1e-15, abs=4e-16)


def test_infinite_spin_ratio_moves_the_contact_across_the_rod():
    assert contact_motion_angle(0.1, np.inf, 2.0, PSI) == pytest.approx(PSI - np.pi / 2)
    assert contact_motion_angle(2.0, -np.inf, 2.0, PSI) == pytest.approx(PSI + np.pi / 2)


def test_motion_center_of_a_translation_and_of_a_spin():
    ring_center = 2.0 * direction(PSI)
    assert np.all(np.isinf(motion_center(0.3, 0.0, 2.0, PSI)))
    assert motion_center(0.3, np.inf, 2.0, PSI) == pytest.approx(ring_center)
    along_fence = motion_center(np.pi / 2, 0.0, 2.0, PSI)
    assert np.isinf(along_fence[0])
    assert along_fence[1] == pytest.approx(ring_center[1])


def test_motion_center_is_where_nothing_moves():
    phi, k, length, radius = 0.4, 1.7, 3.0, 0.5
    center = motion_center(phi, k, length, PSI, radius)
    offset = center - length * direction(PSI)
    omega = k / radius
    velocity = direction(phi) + omega * np.array([-offset[1], offset[0]])
    assert velocity == pytest.approx([0, 0], abs=1e-15)
