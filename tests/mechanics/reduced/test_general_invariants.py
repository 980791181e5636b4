"""What holds of every support under every push, by Hypothesis."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import planar_pushing as pp
from mechanics.supports.test_moments_invariants import moved, points, polygons, segments, simple

lengths = st.floats(-0.7, 0.7).map(lambda power: round(10.0**power, 3))
rod_angles = st.floats(0.2, 2.9).map(lambda angle: round(angle, 3))
force_angles = st.floats(-3.0, 3.0).map(lambda angle: round(angle, 3))
shares = st.floats(0.2, 1.0)
mixtures = st.lists(st.tuples(shares, simple), min_size=2, max_size=3).map(pp.Composite)
#: Supports of more than one point; a contact is off them at a generic place.
supports = st.one_of(points(), segments(), polygons(), mixtures).filter(
    lambda each: each.extent > 0.1
)
MASS = pp.Inertia(mass=0.8, gyration_radius=0.6, center=(0.1, -0.2))


def scene(support, length, psi, contact=None, radius=1.0, masses=()):
    slider = pp.Slider(rod_length=length, rod_angle=psi, radius=radius)
    effects = (pp.SupportFriction(support=support), *masses)
    return pp.Scene(slider=slider, contact=contact or pp.PerfectlyRough(), effects=effects)


def curve(support, length, psi, turns, **kind):
    """Force and motion on the limit curve at angles from the rod."""
    found = pp.limit_curve(scene(support, length, psi, **kind), psi + np.asarray(turns))
    return np.array([found.magnitude, found.motion_angle - psi])


@given(supports, lengths, rod_angles)
def test_the_motion_never_turns_back_and_takes_work(support, length, psi):
    phi = np.linspace(-np.pi, np.pi, 60)
    theta = pp.motion_angle(scene(support, length, psi), phi)
    assert np.diff(theta).min() >= -1e-9
    assert np.abs(theta - phi).max() <= np.pi / 2 + 1e-9
    assert theta[-1] - theta[0] == pytest.approx(2 * np.pi, abs=1e-9)


@given(supports, lengths, rod_angles, force_angles)
def test_the_reversed_force_has_the_reversed_motion(support, length, psi, turn):
    there, back = curve(support, length, psi, [turn, turn + np.pi]).T
    assert back == pytest.approx(there + np.array([0.0, np.pi]), abs=1e-9)


@given(supports, lengths, rod_angles, force_angles)
def test_the_mirrored_support_has_the_mirrored_motion(support, length, psi, turn):
    other = moved(support, [[1.0, 0.0], [0.0, -1.0]])
    force, motion = curve(support, length, psi, turn)
    assert curve(other, length, np.pi - psi, -turn) == pytest.approx([force, -motion], abs=1e-9)


@given(supports, lengths, rod_angles, rod_angles, force_angles)
def test_the_curve_turns_with_the_rod(support, length, psi, other, turn):
    one, two = (curve(support, length, angle, turn) for angle in (psi, other))
    assert one == pytest.approx(two, abs=1e-9)


@given(polygons(), lengths, rod_angles, force_angles, st.floats(-4.0, 4.0))
def test_the_unit_of_length_does_not_matter(support, length, psi, turn, power):
    size = 10.0**power
    scaled = moved(support, size * np.eye(2))
    found = curve(scaled, size * length, psi, turn, radius=size)
    assert found == pytest.approx(curve(support, length, psi, turn), abs=1e-9)


@given(supports, lengths, rod_angles, force_angles, st.floats(0.3, 3.0))
def test_the_radius_is_a_unit_alone(support, length, psi, turn, radius):
    """The general route takes its numbers from the support, not from the radius of the slider."""
    found = curve(support, length, psi, turn, radius=radius)
    assert found == pytest.approx(curve(support, length, psi, turn), abs=1e-9)


@given(supports, shares, lengths, rod_angles, force_angles)
def test_a_support_that_shares_with_itself_moves_alike(support, share, length, psi, turn):
    double = pp.Composite([(share, support), (1.1 - share, support)])
    found = curve(double, length, psi, turn)
    assert found == pytest.approx(curve(support, length, psi, turn), abs=1e-8)


@given(supports, lengths, rod_angles)
@pytest.mark.parametrize("masses", [(), (MASS,)], ids=["friction", "both"])
def test_a_normal_push_sticks_under_infinite_friction(masses, support, length, psi):
    """Sec. 3.2: whatever the support distribution."""
    pushed = scene(support, length, psi, pp.InfiniteFriction(), masses=masses)
    assert pp.solve(pushed, np.pi / 2).modes == (pp.ContactMode.STICK,)


@given(supports, lengths, rod_angles, force_angles)
def test_the_centre_is_within_the_bound_of_peshkin_and_sanderson(support, length, psi, phi):
    """Within a^2 / d, for a line of force that meets the disc of radius a; beyond, within a."""
    pushed = scene(support, length, psi)
    x, y = np.array([np.cos(psi), np.sin(psi)]), np.array([-np.sin(psi), np.cos(psi)])
    middle = support.center_of_pressure[0] * x + support.center_of_pressure[1] * y
    arm, a = length * x + middle, support.extent
    offset = abs(arm[0] * np.sin(phi) - arm[1] * np.cos(phi))
    apart = np.hypot(*(pp.motion_centers(pushed, phi, origin="ring-center") - middle))
    assert apart <= max(a * a / offset if offset > 0 else np.inf, a) * (1 + 1e-9)


@given(supports, lengths, rod_angles, st.floats(0.2, 5.0))
def test_the_weight_is_a_unit_of_force(support, length, psi, weight):
    light = scene(support, length, psi)
    friction = pp.SupportFriction(support=support, weight=weight)
    heavy = replace(light, effects=(friction,))
    one, other = (pp.limit_curve(each, psi + 0.7) for each in (light, heavy))
    assert other.magnitude == pytest.approx(weight * one.magnitude, rel=1e-12, abs=0)
    assert other.motion_angle == pytest.approx(one.motion_angle, abs=1e-12)
