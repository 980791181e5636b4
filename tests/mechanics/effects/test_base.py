"""Invariants of the effects: convex potentials, gradients, duality."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

import planar_pushing as pp
from mechanics.builders import make_scene
from mechanics.strategies import masses, powers, rings, spin_ratios, twists
from planar_pushing.mechanics.effects.base import made, response
from planar_pushing.mechanics.effects.inertia import Mass
from planar_pushing.mechanics.effects.support_friction import RingSupport
from planar_pushing.mechanics.supports.ring import ring_response
from planar_pushing.mechanics.wrench import ring_profile

any_effect = st.one_of(rings, masses)


@given(any_effect, twists, twists, st.floats(0, 1))
def test_potentials_are_convex(effect, a, b, part):
    between = pp.potential(effect, part * a + (1 - part) * b)
    chord = part * pp.potential(effect, a) + (1 - part) * pp.potential(effect, b)
    assert between <= chord * (1 + 1e-14) + 1e-14


@given(any_effect, twists, twists)
def test_wrench_is_a_subgradient_of_the_potential(effect, a, b):
    """Every tangent plane supports the potential: convexity and gradient in one."""
    plane = pp.potential(effect, a) + pp.wrench(effect, a) @ (b - a)
    scale = 1 + abs(pp.potential(effect, a)) + np.abs(pp.wrench(effect, a)) @ np.abs(b - a)
    assert pp.potential(effect, b) >= plane - 1e-14 * scale


@given(any_effect, twists)
def test_wrench_is_the_slope_of_the_potential(effect, twist):
    speed, spin = np.hypot(*twist[:2]), abs(twist[2])
    assume(speed > 0.1 and abs(spin - speed) > 0.1)
    step = 1e-5
    for axis, unit in enumerate(np.eye(3)):
        rise = pp.potential(effect, twist + step * unit) - pp.potential(effect, twist - step * unit)
        scale = 1 + np.abs(pp.wrench(effect, twist)).max()
        assert rise / (2 * step) == pytest.approx(pp.wrench(effect, twist)[axis], abs=1e-6 * scale)


@given(any_effect, twists)
def test_euler(effect, twist):
    """wrench . twist = degree x potential, for homogeneous potentials."""
    power = pp.wrench(effect, twist) @ twist
    assert power == pytest.approx(
        effect.degree * pp.potential(effect, twist), rel=1e-13, abs=1e-300
    )
    assert power >= 0


@given(any_effect, twists, powers(-3, 3))
def test_homogeneity(effect, twist, factor):
    scaled = pp.wrench(effect, factor * twist)
    expected = factor ** (effect.degree - 1) * pp.wrench(effect, twist)
    assert scaled == pytest.approx(expected, rel=1e-12, abs=1e-250)


@given(any_effect, twists)
def test_wrench_is_odd_and_potential_is_even(effect, twist):
    assert np.array_equal(pp.wrench(effect, -twist), -pp.wrench(effect, twist))
    assert pp.potential(effect, -twist) == pp.potential(effect, twist)


@given(any_effect, twists, st.floats(-np.pi, np.pi))
def test_effects_are_isotropic(effect, twist, turn):
    rotation = np.eye(3)
    rotation[:2, :2] = [[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]]
    turned = pp.wrench(effect, rotation @ twist)
    assert turned == pytest.approx(rotation @ pp.wrench(effect, twist), rel=1e-10, abs=1e-12)


@given(twists)
def test_friction_stays_inside_its_limit_surface(twist):
    force_x, force_y, torque = pp.wrench(pp.RingFriction(), twist)
    assert np.hypot(force_x, force_y) <= 1 + 1e-15
    assert abs(torque) <= 1 + 1e-15


@given(spin_ratios)
def test_ring_is_self_dual(k):
    """f(k) = t(1/k), so H(1/k) = 1 / H(k)."""
    (force, torque), (dual_force, dual_torque) = ring_profile(k), ring_profile(1 / k)
    assert force == pytest.approx(dual_torque, rel=1e-14, abs=0)
    assert torque == pytest.approx(dual_force, rel=1e-14, abs=0)
    assert torque / force == pytest.approx(dual_force / dual_torque, rel=1e-14, abs=0)


@given(spin_ratios, st.floats(1e-6, 0.5))
def test_moment_arm_increases_with_the_spin_ratio(k, gap):
    (f1, t1), (f2, t2) = ring_profile(k), ring_profile(k * (1 + gap))
    assert t1 / f1 < t2 / f2


def spin_ratio_under(effect, arm):
    """Spin ratio under a force of a moment arm, here the rod's length."""
    return pp.spin_ratio(make_scene(arm, effects=(effect,), psi=np.pi / 2), 0.0)


def arm_of(effect, k):
    """H(k): the moment arm of the force that turns the slider by a spin ratio."""
    force, _, torque = pp.wrench(effect, [1.0, 0.0, k])
    return torque / force


@given(any_effect, st.one_of(powers(-6, 6), st.floats(-12, -2).map(lambda e: 1 - 10.0**e)))
def test_moment_arm_of_the_inverse_is_the_moment_arm(effect, arm):
    """H(H^-1(h)) = h, also where the line of force is almost tangent to the ring."""
    assert arm_of(effect, spin_ratio_under(effect, arm)) == pytest.approx(arm, rel=1e-14, abs=0)


@given(any_effect, st.one_of(powers(-5.5, 5), st.floats(-12, -2).map(lambda e: 1 + 10.0**e)))
def test_inverse_of_the_moment_arm_is_the_spin_ratio(effect, k):
    """H^-1(H(k)) = k."""
    assert spin_ratio_under(effect, arm_of(effect, k)) == pytest.approx(k, rel=4e-15, abs=0)


@given(masses, twists)
def test_inertia_is_mass_times_motion(inertia, twist):
    (row,) = made((Mass(1.0, 1.0),), np.array([9.0, inertia.mass, inertia.gyration_radius**2]))
    speed, spin = abs(twist[0]), twist[2]
    force, torque, vv, vs, ss = response((row,), speed, spin)
    moment = inertia.mass * inertia.gyration_radius**2
    assert (force, vv, vs) == (inertia.mass * speed, inertia.mass, 0.0)
    assert (torque, ss) == pytest.approx((moment * spin, moment), rel=1e-15, abs=0)


@given(rings, masses, powers(-2, 2), st.floats(-30, 30))
def test_responses_add(ring, inertia, speed, spin):
    row = np.array([ring.weight, inertia.mass, inertia.gyration_radius**2])
    every = made((RingSupport(1.0), Mass(1.0, 1.0)), row)
    parts = [response(every[:1], speed, spin), response(every[1:], speed, spin)]
    assert response(every, speed, spin) == tuple(map(sum, zip(*parts, strict=True)))


@given(rings, powers(-2, 2), st.floats(-30, 30))
def test_response_of_friction_is_the_weight_times_that_of_the_ring(ring, speed, spin):
    effect = RingSupport(ring.weight)
    expected = [ring.weight * each for each in ring_response(speed, spin)]
    assert list(response(effect, speed, spin)) == expected
