"""Wrench and potential of an effect, and the ring's two relations over arrays."""

from __future__ import annotations

import numpy as np
import pytest
from mpmath import mpf

import planar_pushing as pp
import reference
from planar_pushing.mechanics.force.wrench import ring_profile, ring_spin_ratios

EPS = np.finfo(float).eps
RATIOS = [5e-324, 1e-300, 1e-9, 0.1, 0.5, 0.9 - EPS, 0.9, 0.999, 1 - 1e-9, 1 - EPS]
RATIOS = [*RATIOS, 1.0, 1 + EPS, 1 + 1e-9, 1.001, 1.2, 2.0, 30.0, 1e9, 1e160, 1e300]


def ulps(value, exact):
    return abs(mpf(float(value)) - exact) / mpf(np.spacing(abs(float(exact))))


@pytest.mark.parametrize("k", RATIOS)
def test_ring_wrench_to_4_ulp(k):
    """Eqs. (2)-(3), both signs of the spin ratio."""
    for sign in (1, -1):
        force, across, torque = pp.wrench(pp.RingFriction(), [1.0, 0.0, sign * k])
        assert ulps(force, reference.ring_force(k)) <= 4
        assert ulps(torque, reference.ring_torque(sign * k)) <= 4
        assert across == 0


def test_ring_wrench_without_rotation_and_without_translation():
    ring = pp.RingFriction(weight=3.0)
    assert np.array_equal(pp.wrench(ring, [0.0, -2.0, 0.0]), [0.0, -3.0, 0.0])
    assert np.array_equal(pp.wrench(ring, [0.0, 0.0, -1e-300]), [0.0, 0.0, -3.0])


def test_ring_wrench_on_the_ring_is_two_over_pi():
    assert pp.wrench(pp.RingFriction(), [1.0, 0.0, 1.0]) == pytest.approx(
        [2 / np.pi, 0, 2 / np.pi], rel=2 * EPS, abs=0
    )


@pytest.mark.parametrize("k", [0.0, 1e-300, 0.3, 1 - 1e-9, 1.0, 1 + EPS, 3.0, 1e300])
def test_ring_potential_to_4_ulp(k):
    """Euler on Eqs. (2)-(3): D = f + k t for a unit speed."""
    exact = reference.ring_force(k) + mpf(k) * reference.ring_torque(k)
    assert ulps(pp.potential(pp.RingFriction(), [0.6, 0.8, k]), exact) <= 4


def test_inertia_wrench_and_potential():
    inertia = pp.Inertia(mass=2.0, gyration_radius=3.0)
    twist = [[1.0, -2.0, 0.5]]
    assert np.array_equal(pp.wrench(inertia, twist), [[2.0, -4.0, 9.0]])
    assert pp.potential(inertia, twist) == pytest.approx([2 * (5 + 9 * 0.25) / 2])


@pytest.mark.parametrize("effect", [pp.RingFriction(), pp.Inertia()], ids=["friction", "inertia"])
def test_zero_motion_has_a_wrench_that_is_a_number(effect):
    rest = np.zeros((2, 3))
    assert np.array_equal(pp.wrench(effect, rest), rest)
    assert np.array_equal(pp.potential(effect, rest), [0.0, 0.0])


def test_wrench_of_a_ring_of_another_radius():
    """The torque grows with R, the force depends on R omega."""
    slider = pp.Slider(rod_length=1.0, rod_angle=1.0, radius=2.5)
    unit = pp.wrench(pp.RingFriction(), [0.6, -0.8, 2.5 * 0.7])
    assert pp.wrench(pp.RingFriction(), [0.6, -0.8, 0.7], slider) == pytest.approx(
        unit * [1, 1, 2.5], rel=1e-15, abs=0
    )
    inertia = pp.Inertia(mass=2.0, gyration_radius=3.0)
    assert pp.wrench(inertia, [0.6, -0.8, 0.7], slider) == pytest.approx(
        [1.2, -1.6, 2 * 9 * 0.7], rel=1e-15, abs=0
    )
    assert pp.potential(inertia, [0.6, -0.8, 0.7], slider) == pytest.approx(1 + 9 * 0.49)


def test_twists_of_any_shape():
    twists = np.random.default_rng(3).normal(size=(2, 3, 3))
    for effect in (pp.RingFriction(weight=2.0), pp.Inertia(mass=3.0)):
        found = pp.wrench(effect, twists)
        assert found.shape == (2, 3, 3)
        assert pp.potential(effect, twists).shape == (2, 3)
        for place in np.ndindex(2, 3):
            assert np.array_equal(found[place], pp.wrench(effect, twists[place]))


def test_ratios_and_arms_of_any_size():
    assert np.array_equal(ring_spin_ratios([0.0, 1.0, -1.0]), [0.0, 1.0, -1.0])
    force, torque = ring_profile([0.0, np.inf, -np.inf])
    assert np.array_equal(force, [1.0, 0.0, 0.0])
    assert np.array_equal(torque, [0.0, 1.0, -1.0])
    k = ring_spin_ratios([1e-300, 1e300])
    assert k == pytest.approx([2e-300, 5e299], rel=4 * EPS, abs=0)


@pytest.mark.parametrize("size", [1e-300, 1e-163, 1e-150, 1e150, 1e200])
@pytest.mark.parametrize("k", [0.3, 0.95, 1.0, 1.05, 3.0])
def test_friction_does_not_see_the_size_of_the_motion(k, size):
    """Squares of the motion would leave the doubles."""
    unit = pp.wrench(pp.RingFriction(), [0.6, 0.8, k])
    found = pp.wrench(pp.RingFriction(), size * np.array([0.6, 0.8, k]))
    assert found == pytest.approx(unit, rel=1e-14, abs=0)
