"""The numbered equations of the paper, one test each, against their transcription."""

from __future__ import annotations

import numpy as np
import pytest
from mechanics.builders import INERTIA, PSI, make_scene
from mpmath import mp

import planar_pushing as pp
import reference

SPIN_RATIOS = [1e-6, 0.3, 0.95, 1.0, 1.0 + 1e-9, 1.7, 40.0]
FORCES = [(1.0, 0.0), (0.3, 1.1), (-0.7, 0.4), (0.0, -2.0)]


def ring_wrench(phi, k, weight=1.0):
    """Wrench of the ring for a unit center velocity along phi."""
    twist = np.array([np.cos(phi), np.sin(phi), k])
    return pp.wrench(pp.RingFriction(weight=weight), twist)


def inertia_twist(fx, fy, length, psi):
    """Initial acceleration of the center from the force that sustains it."""
    phi = np.arctan2(fy, fx)
    k = float(pp.spin_ratio(make_scene(length, effects=INERTIA, psi=psi), phi))
    size = np.hypot(fx, fy)
    twist = size * np.array([np.cos(phi), np.sin(phi), k])
    assert pp.wrench(pp.Inertia(), twist)[:2] == pytest.approx([fx, fy], rel=1e-14, abs=1e-15)
    return twist


@pytest.mark.parametrize("k", SPIN_RATIOS)
def test_eq_01_friction_has_no_part_across_the_motion(k):
    """Eq. (1)."""
    assert abs(reference.eq_01_sideways_force(k)) < 1e-30
    wrench = ring_wrench(0.7, k)
    assert abs(wrench[1] * np.cos(0.7) - wrench[0] * np.sin(0.7)) < 1e-15


@pytest.mark.parametrize("k", SPIN_RATIOS)
def test_eq_02_friction_force(k):
    """Eq. (2), with the weight as its factor and the sign of v."""
    expected = float(reference.eq_02_force(k, weight=3))
    assert ring_wrench(0.0, k, weight=3.0)[0] == pytest.approx(expected, rel=1e-14, abs=0)
    backwards = pp.wrench(pp.RingFriction(weight=3.0), [-1.0, 0.0, -k])
    assert backwards[0] == pytest.approx(-expected, rel=1e-14, abs=0)


@pytest.mark.parametrize("k", SPIN_RATIOS)
def test_eq_03_friction_torque(k):
    """Eq. (3), odd in the spin ratio."""
    expected = float(reference.eq_03_torque(k, weight=3))
    assert ring_wrench(0.0, k, weight=3.0)[2] == pytest.approx(expected, rel=1e-14, abs=0)
    assert ring_wrench(0.0, -k, weight=3.0)[2] == pytest.approx(-expected, rel=1e-14, abs=0)


@pytest.mark.parametrize("phi", [0.0, 0.4, 2.0, -1.3])
def test_eq_04_force_along_the_fence(phi):
    """Eq. (4)."""
    expected = float(reference.eq_04_force_x(reference.eq_02_force(0.5), phi))
    assert ring_wrench(phi, 0.5)[0] == pytest.approx(expected, rel=1e-14, abs=0)


@pytest.mark.parametrize("phi", [0.1, 0.4, 2.0, -1.3])
def test_eq_05_force_across_the_fence(phi):
    """Eq. (5)."""
    expected = float(reference.eq_05_force_y(reference.eq_02_force(0.5), phi))
    assert ring_wrench(phi, 0.5)[1] == pytest.approx(expected, rel=1e-14, abs=0)


@pytest.mark.parametrize("phi", [0.1, 0.4, 2.0, -1.3])
def test_eq_06_torque_about_the_contact(phi):
    """Eq. (6): moving the wrench from the ring center to the contact."""
    k, length = 0.5, 2.0
    expected = reference.eq_06_torque_about_contact(
        reference.eq_02_force(k), reference.eq_03_torque(k), length, phi, PSI
    )
    fx, fy, torque = ring_wrench(phi, k)
    arm = length * np.array([np.cos(PSI), np.sin(PSI)])
    assert torque + arm[0] * fy - arm[1] * fx == pytest.approx(float(expected), abs=1e-14)


@pytest.mark.parametrize(("length", "phi"), [(0.5, 3.0), (1.0, PSI)])
def test_eq_07_spin_ratio_balances_the_torque(length, phi):
    """Eq. (7), its root found with the integrals as printed."""
    expected = float(reference.eq_07_spin_ratio(length, phi, PSI))
    assert float(pp.spin_ratio(make_scene(length), phi)) == pytest.approx(
        expected, rel=1e-14, abs=0
    )
    elliptic = float(reference.friction_spin_ratio(reference.moment_arm(length, phi, PSI)))
    assert elliptic == pytest.approx(expected, rel=1e-15, abs=0)


def test_eq_07_sign_and_center():
    """Below Eq. (7): the velocity center lies at -v / omega along x'."""
    scene, phi = make_scene(2.0), 0.2
    k = float(pp.spin_ratio(scene, phi))
    x_axis = np.array([np.cos(phi - np.pi / 2), np.sin(phi - np.pi / 2)])
    ring_center = 2.0 * np.array([np.cos(PSI), np.sin(PSI)])
    assert pp.motion_centers(scene, phi) == pytest.approx(
        ring_center - x_axis / k, rel=1e-14, abs=0
    )


@pytest.mark.parametrize("force", FORCES)
def test_eq_08_acceleration_along_the_fence(force):
    """Eq. (8)."""
    expected, _, _ = reference.eq_08_to_10_acceleration(*force, 2.0, 1.1)
    assert inertia_twist(*force, 2.0, 1.1)[0] == pytest.approx(float(expected), abs=1e-15)


@pytest.mark.parametrize("force", FORCES)
def test_eq_09_acceleration_across_the_fence(force):
    """Eq. (9)."""
    _, expected, _ = reference.eq_08_to_10_acceleration(*force, 2.0, 1.1)
    assert inertia_twist(*force, 2.0, 1.1)[1] == pytest.approx(float(expected), abs=1e-15)


@pytest.mark.parametrize("force", FORCES)
def test_eq_10_angular_acceleration(force):
    """Eq. (10)."""
    _, _, expected = reference.eq_08_to_10_acceleration(*force, 2.0, 1.1)
    assert inertia_twist(*force, 2.0, 1.1)[2] == pytest.approx(float(expected), rel=1e-14, abs=0)


def rod_end(transcription, axis, pusher_angle, length=2.0, psi=1.1):
    """A part of a_s from the force of a sticking contact, from `solve` and from the pusher."""
    scene = make_scene(length, effects=INERTIA, psi=psi)
    (stick,) = (s for s in pp.solve(scene, pusher_angle, 3.0) if s.mode is pp.ContactMode.STICK)
    pusher = 3.0 * np.array([np.cos(pusher_angle), np.sin(pusher_angle)])
    return float(transcription(*stick.force, length, psi)), stick.contact_motion[axis], pusher[axis]


@pytest.mark.parametrize("pusher_angle", [0.6, 1.5, 2.0])
def test_eq_11_acceleration_of_the_rod_end_along_the_fence(pusher_angle):
    """Eq. (11)."""
    from_force, contact, pusher = rod_end(reference.eq_11_rod_end_x, 0, pusher_angle)
    assert [from_force, contact] == pytest.approx([pusher, pusher], abs=1e-13)


@pytest.mark.parametrize("pusher_angle", [0.6, 1.5, 2.0])
def test_eq_12_acceleration_of_the_rod_end_across_the_fence(pusher_angle):
    """Eq. (12)."""
    from_force, contact, pusher = rod_end(reference.eq_12_rod_end_y, 1, pusher_angle)
    assert [from_force, contact] == pytest.approx([pusher, pusher], abs=1e-13)


@pytest.mark.parametrize("force", FORCES)
def test_eq_11_and_eq_12_angle_of_the_rod_end(force):
    """Eqs. (11)-(12) fix the angle of a_s for every force."""
    ax, ay = (f(*force, 2.0, 1.1) for f in (reference.eq_11_rod_end_x, reference.eq_12_rod_end_y))
    computed = pp.motion_angle(make_scene(2.0, effects=INERTIA, psi=1.1), np.arctan2(*force[::-1]))
    turns = (float(computed) - float(mp.atan2(ay, ax))) / (2 * np.pi)
    assert turns == pytest.approx(round(turns), abs=1e-15)


@pytest.mark.parametrize("psi", [0.3, PSI, 1.4, 2.2])
@pytest.mark.parametrize("length", [0.5, 1.0, 2.0, 5.0])
@pytest.mark.parametrize("mu", [0.1, 1.0, 3.0, 30.0])
def test_eq_13_pulling_condition(length, psi, mu):
    """Eq. (13), applied to both edges of the friction cone."""
    pulls = any(reference.eq_13_pulls(side * mu, 1, length, psi) for side in (-1, 1))
    assert pp.can_pull(make_scene(length, mu, INERTIA, psi)) == pulls


def test_eq_13_transcription_against_eq_12():
    """Eq. (13) at psi = 45 deg, l = 2: 3 f_y - 2 mu f_y < 0."""
    assert float(reference.eq_12_rod_end_y(2, 1, 2, mp.pi / 4)) == pytest.approx(3 - 2 * 2)
    assert not pp.can_pull(make_scene(2.0, 1.4, INERTIA))
