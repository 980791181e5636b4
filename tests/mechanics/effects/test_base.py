"""Invariants of the effects: convex potentials, gradients, duality."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

import planar_pushing as pp
from mechanics.strategies import masses, powers, rings, spin_ratios, twists

any_effect = st.one_of(rings, masses)


@given(any_effect, twists, twists, st.floats(0, 1))
def test_potentials_are_convex(effect, a, b, part):
    between = effect.potential(part * a + (1 - part) * b)
    chord = part * effect.potential(a) + (1 - part) * effect.potential(b)
    assert between <= chord * (1 + 1e-14) + 1e-14


@given(any_effect, twists, twists)
def test_wrench_is_a_subgradient_of_the_potential(effect, a, b):
    """Every tangent plane supports the potential: convexity and gradient in one."""
    plane = effect.potential(a) + effect.wrench(a) @ (b - a)
    scale = 1 + abs(effect.potential(a)) + np.abs(effect.wrench(a)) @ np.abs(b - a)
    assert effect.potential(b) >= plane - 1e-14 * scale


@given(any_effect, twists)
def test_wrench_is_the_slope_of_the_potential(effect, twist):
    speed, spin = np.hypot(*twist[:2]), abs(twist[2])
    assume(speed > 0.1 and abs(spin - speed) > 0.1)
    step = 1e-5
    for axis, unit in enumerate(np.eye(3)):
        rise = effect.potential(twist + step * unit) - effect.potential(twist - step * unit)
        scale = 1 + np.abs(effect.wrench(twist)).max()
        assert rise / (2 * step) == pytest.approx(effect.wrench(twist)[axis], abs=1e-6 * scale)


@given(any_effect, twists)
def test_euler(effect, twist):
    """wrench . twist = degree x potential, for homogeneous potentials."""
    power = effect.wrench(twist) @ twist
    assert power == pytest.approx(effect.degree * effect.potential(twist), rel=1e-13, abs=1e-300)
    assert power >= 0


@given(any_effect, twists, powers(-3, 3))
def test_homogeneity(effect, twist, factor):
    scaled = effect.wrench(factor * twist)
    expected = factor ** (effect.degree - 1) * effect.wrench(twist)
    assert scaled == pytest.approx(expected, rel=1e-12, abs=1e-250)


@given(any_effect, twists)
def test_wrench_is_odd_and_potential_is_even(effect, twist):
    assert np.array_equal(effect.wrench(-twist), -effect.wrench(twist))
    assert effect.potential(-twist) == effect.potential(twist)


@given(any_effect, twists, st.floats(-np.pi, np.pi))
def test_effects_are_isotropic(effect, twist, turn):
    rotation = np.eye(3)
    rotation[:2, :2] = [[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]]
    turned = effect.wrench(rotation @ twist)
    assert turned == pytest.approx(rotation @ effect.wrench(twist), rel=1e-10, abs=1e-12)


@given(twists)
def test_friction_stays_inside_its_limit_surface(twist):
    force_x, force_y, torque = pp.RingFriction().wrench(twist)
    assert np.hypot(force_x, force_y) <= 1 + 1e-15
    assert abs(torque) <= 1 + 1e-15


@given(spin_ratios)
def test_ring_is_self_dual(k):
    """f(k) = t(1/k), so H(1/k) = 1 / H(k)."""
    ring = pp.RingFriction()
    (force, torque), (dual_force, dual_torque) = ring.profile(k), ring.profile(1 / k)
    assert force == pytest.approx(dual_torque, rel=1e-14)
    assert torque == pytest.approx(dual_force, rel=1e-14)
    assert torque / force == pytest.approx(dual_force / dual_torque, rel=1e-14)


@given(spin_ratios, st.floats(1e-6, 0.5))
def test_moment_arm_increases_with_the_spin_ratio(k, gap):
    ring = pp.RingFriction()
    (f1, t1), (f2, t2) = ring.profile(k), ring.profile(k * (1 + gap))
    assert t1 / f1 < t2 / f2


@given(any_effect, st.one_of(powers(-9, 9), st.floats(-12, -2).map(lambda e: 1 - 10.0**e)))
def test_moment_arm_of_the_inverse_is_the_moment_arm(effect, arm):
    """H(H^-1(h)) = h, also where the line of force is almost tangent to the ring."""
    force, torque = effect.profile(effect.spin_ratio(arm))
    assert torque / force == pytest.approx(arm, rel=1e-14)


@given(any_effect, st.one_of(powers(-9, 9), st.floats(-12, -2).map(lambda e: 1 + 10.0**e)))
def test_inverse_of_the_moment_arm_is_the_spin_ratio(effect, k):
    """H^-1(H(k)) = k."""
    force, torque = effect.profile(k)
    assert effect.spin_ratio(torque / force) == pytest.approx(k, rel=4e-15)
