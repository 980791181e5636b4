"""Accuracy against the transcription of the paper, on the same double inputs."""

from __future__ import annotations

import numpy as np
import pytest
from mpmath import mp, mpf

import planar_pushing as pp
import reference
from mechanics.builders import BOTH, FRICTION, INERTIA, PSI, make_scene

RADIANS = 1e-12
LENGTHS = 10.0 ** np.arange(-3, 4)
COEFFICIENTS = [0.0, 3.0, 1e6, np.inf]
EPS = np.finfo(float).eps

K_INSIDE = [5e-324, 1e-300, 1e-160, 1e-9, 1e-3, 0.1, 0.5, 0.7, 0.9 - EPS, 0.9, 0.95, 0.999]
K_AT_RING = [1 - 1e-6, 1 - 1e-9, 1 - EPS, 1.0, 1 + EPS, 1 + 1e-9, 1 + 1e-6]
K_OUTSIDE = [1.001, 1.1, 1.2, 2.0, 30.0, 1e3, 1e9, 1e160, 1e300]


def ulps(value, exact):
    return abs(mpf(float(value)) - exact) / mpf(np.spacing(abs(float(exact))))


@pytest.mark.parametrize("k", [*K_INSIDE, *K_AT_RING, *K_OUTSIDE])
def test_ring_wrench_to_4_ulp(k):
    """Eqs. (2)-(3), both signs of the spin ratio."""
    for sign in (1, -1):
        force, _, torque = pp.RingFriction().wrench(np.array([1.0, 0.0, sign * k]))
        assert ulps(force, reference.ring_force(k)) <= 4
        assert ulps(torque, reference.ring_torque(sign * k)) <= 4


def test_ring_wrench_without_rotation_and_without_translation():
    ring = pp.RingFriction(weight=3.0)
    assert np.array_equal(ring.wrench(np.array([0.0, -2.0, 0.0])), [0.0, -3.0, 0.0])
    assert np.array_equal(ring.wrench(np.array([0.0, 0.0, -1e-300])), [0.0, 0.0, -3.0])
    force, torque = ring.profile(np.array([0.0, np.inf, -np.inf]))
    assert np.array_equal(force, [3.0, 0.0, 0.0])
    assert np.array_equal(torque, [0.0, 3.0, -3.0])


def test_ring_wrench_on_the_ring_is_two_over_pi():
    assert pp.RingFriction().wrench(np.array([1.0, 0.0, 1.0])) == pytest.approx(
        [2 / np.pi, 0, 2 / np.pi], rel=2 * EPS
    )


@pytest.mark.parametrize("k", [0.0, 1e-300, 0.3, 1 - 1e-9, 1.0, 1 + EPS, 3.0, 1e300])
def test_ring_potential_to_4_ulp(k):
    """Euler on Eqs. (2)-(3): D = f + k t for a unit speed."""
    exact = reference.ring_force(k) + mpf(k) * reference.ring_torque(k)
    assert ulps(pp.RingFriction().potential(np.array([0.6, 0.8, k])), exact) <= 4


ARMS = [1e-300, 1e-12, 1e-8, 0.99e-6, 1.01e-6, 1e-3, 0.3, 0.9, 1.0, 7.0, 1e3, 0.99e6, 1e12, 1e300]
ARMS_AT_RING = [1 - 1e-4, 1 - 1e-5, 1 - 1e-7, 1 - 1e-9, 1 - EPS, 1 + EPS, 1 + 1e-9, 1 + 1e-5]


@pytest.mark.parametrize("arm", [*ARMS, *ARMS_AT_RING])
def test_inverse_of_the_moment_arm(arm):
    """Eq. (7): k from h, relative to k."""
    exact = reference.friction_spin_ratio(arm)
    for sign in (1, -1):
        k = pp.RingFriction().spin_ratio(sign * arm)
        assert abs(mpf(float(k)) / exact - sign) <= 8 * EPS


def test_inverse_of_zero_is_zero():
    assert pp.RingFriction().spin_ratio(0.0) == 0
    assert pp.Inertia().spin_ratio(0.0) == 0


@pytest.mark.parametrize("psi", [PSI, 2.0])
@pytest.mark.parametrize("mu", COEFFICIENTS)
@pytest.mark.parametrize(("effects", "exact"), [
    (FRICTION, reference.friction_motion_angle),
    (INERTIA, reference.inertia_motion_angle),
], ids=["friction", "inertia"])  # fmt: skip
def test_motion_cone_edges(effects, exact, mu, psi):
    """Eqs. (7) and (11)-(12) at the double force angles of the friction cone."""
    for length in LENGTHS:
        scene = make_scene(length, mu, effects, psi)
        force, motion = pp.friction_cone(scene), pp.motion_cone(scene)
        assert abs(motion.right - exact(length, force.right, psi)) < RADIANS
        assert abs(motion.left - exact(length, force.left, psi)) < RADIANS


@pytest.mark.parametrize("mu", COEFFICIENTS)
def test_friction_cone_edges(mu):
    exact = mp.pi / 2 if np.isinf(mu) else mp.atan(mpf(mu))
    cone = pp.friction_cone(make_scene(1.0, mu))
    assert abs(cone.right - (mp.pi / 2 - exact)) < 4 * EPS
    assert abs(cone.left - (mp.pi / 2 + exact)) < 4 * EPS


@pytest.mark.parametrize("share", [0.0, 1e-9, 0.3, 0.999, 1.0])
@pytest.mark.parametrize("length", [1e-3, 0.3, 2.0, 30.0, 1e3])
def test_motion_angles_with_both_effects(length, share):
    """Sec. 4: h = (t + s rho^2 k) / (f + s)."""
    scene = make_scene(length, np.inf, [pp.RingFriction(), pp.Inertia(gyration_radius=0.7)])
    for phi in (0.0, 2.4):
        exact = reference.mixed_motion_angle(length, phi, PSI, share, rho=0.7)
        assert abs(float(pp.motion_angle(scene, phi, share)) - exact) < RADIANS


@pytest.mark.parametrize("offset", [np.spacing(PSI), 1e-12, 1e-9, 1e-6, 1e-4])
@pytest.mark.parametrize("length", [1.0, 30.0, 1e3])
def test_force_along_the_rod(length, offset):
    """Here the motion angle turns up to 2 l^2 times as fast as the force angle."""
    for phi in (PSI - offset, PSI + offset):
        friction = float(pp.motion_angle(make_scene(length), phi))
        assert abs(friction - reference.friction_motion_angle(length, phi, PSI)) < RADIANS
        inertia = float(pp.motion_angle(make_scene(length, effects=INERTIA), phi))
        assert abs(inertia - reference.inertia_motion_angle(length, phi, PSI)) < RADIANS


@pytest.mark.parametrize("gap", [1e-3, 1e-4, 1e-5, 1e-7, -1e-8, -1e-5])
@pytest.mark.parametrize("length", [1.01, 2.0, 5.0])
def test_force_almost_tangent_to_the_ring(length, gap):
    """The slope of H is infinite on the ring: its inverse is flat, and Newton steps are slow."""
    phi = PSI - np.arcsin((1 - gap) / length)
    computed = float(pp.motion_angle(make_scene(length), phi))
    assert abs(computed - reference.friction_motion_angle(length, phi, PSI)) < RADIANS


@pytest.mark.parametrize("gyration_radius", [1e-4, 1e-2, 1e2, 1e4])
def test_gyration_radius_far_from_the_radius(gyration_radius):
    effects = [pp.RingFriction(), pp.Inertia(gyration_radius=gyration_radius)]
    for share in (0.1, 0.9):
        computed = pp.motion_angle(make_scene(2.0, effects=effects), 0.3, share)
        exact = reference.mixed_motion_angle(2.0, 0.3, PSI, share, rho=gyration_radius)
        assert abs(float(computed) - exact) < RADIANS


@pytest.mark.parametrize("psi", [1e-12, 1e-6, np.pi - 1e-6, np.nextafter(np.pi, 0)])
@pytest.mark.parametrize("length", [0.5, 2.0, 1e3])
def test_rod_almost_along_the_fence(length, psi):
    scene = make_scene(length, np.inf, FRICTION, psi)
    cone = pp.motion_cone(scene)
    assert abs(cone.right - reference.friction_motion_angle(length, 0.0, psi)) < RADIANS
    # The edge of infinite friction is a half turn, not the double next to it.
    assert abs(cone.left - reference.friction_motion_angle(length, mp.pi, psi)) < RADIANS


@pytest.mark.parametrize("length", [0.3, 2.0, 20.0])
@pytest.mark.parametrize("pusher_angle", [0.3, 2.2])
@pytest.mark.parametrize("effects", [FRICTION, INERTIA, BOTH], ids=["friction", "inertia", "both"])
def test_sticking_force_maps_back_to_the_pusher(effects, length, pusher_angle):
    """`solve` inverts the map: the reference motion of its force is the pusher's."""
    (stick,) = pp.solve(make_scene(length, pp.PerfectlyRough(), effects), pusher_angle, 2.0)
    phi, share = np.arctan2(*stick.force[::-1]), 1.0 if effects == INERTIA else 0.0
    if effects == BOTH:
        speed = np.hypot(*stick.twist[:2])
        share = speed / (1 + speed)
    exact = reference.mixed_motion_angle(length, phi, PSI, share)
    # An error of one ulp in the force angle comes back up to 2 l^2 times as large.
    assert abs(pusher_angle - exact) < RADIANS * max(1.0, length**2 / 10)


@pytest.mark.parametrize("phi", [0.2, 0.9, 2.6])
@pytest.mark.parametrize("length", [0.3, 2.0, 20.0])
def test_limit_curve_with_both_effects(length, phi):
    """W f + m v with v = 1 / sqrt(1 + rho^2 k^2), on the line of force h."""
    weight, mass, rho = 2.0, 3.0, 0.7
    effects = [pp.RingFriction(weight=weight), pp.Inertia(mass=mass, gyration_radius=rho)]
    curve = pp.limit_curve(make_scene(length, effects=effects), phi)
    k = mpf(float(curve.spin_ratio))
    speed = 1 / mp.sqrt(1 + mpf(rho) ** 2 * k**2)
    force = weight * reference.ring_force(k) + mass * speed
    torque = weight * reference.ring_torque(k) + mass * speed * mpf(rho) ** 2 * k
    assert float(curve.magnitude) == pytest.approx(float(force), rel=1e-14)
    assert float(torque / force) == pytest.approx(length * np.sin(PSI - phi), rel=1e-13)
    exact = reference.motion_angle(length, phi, PSI, k)
    assert float(curve.motion_angle) == pytest.approx(float(exact), abs=RADIANS)


@pytest.mark.parametrize("phi", [0.2, PSI, 2.6])
@pytest.mark.parametrize("length", [1e-3, 1.0, 1e3])
def test_limit_curve_of_friction(length, phi):
    curve = pp.limit_curve(make_scene(length, effects=[pp.RingFriction(weight=2.0)]), phi)
    k = reference.friction_spin_ratio(reference.moment_arm(length, phi, PSI))
    assert float(curve.magnitude) == pytest.approx(float(2 * reference.ring_force(k)), rel=1e-13)
