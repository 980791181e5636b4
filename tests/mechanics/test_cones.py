"""Accuracy against the transcription of the paper, on the same double inputs."""

from __future__ import annotations

import numpy as np
import pytest
from mpmath import mp, mpf

import planar_pushing as pp
import reference
from mechanics.builders import BOTH, DEFINITION_2, EFFECT_SETS, FRICTION, INERTIA, PSI, make_scene
from planar_pushing.mechanics.limit_curve import curve_of_unit_motions

RADIANS = 1e-12
LENGTHS = 10.0 ** np.arange(-3, 4)
COEFFICIENTS = [0.0, 3.0, 1e6, np.inf]
EPS = np.finfo(float).eps


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


@pytest.mark.parametrize(
    "law", [pp.Coulomb(2.0), pp.InfiniteFriction(), pp.PerfectlyRough()], ids=str
)
def test_motion_cone_is_closed_like_its_friction_cone_unless_it_is_a_union(law):
    for effects in EFFECT_SETS.values():
        closed = pp.motion_cone(make_scene(2.0, law, effects)).closed
        assert closed == (effects != BOTH)
    assert not pp.motion_cone(make_scene(2.0, DEFINITION_2)).closed


def test_motion_cone_with_both_effects_is_closed_where_the_effects_agree():
    """Without a rod both effects translate the slider along the force."""
    assert pp.motion_cone(make_scene(0.0, 1.0, BOTH)).closed


def test_pulls_to_both_sides():
    assert pp.can_pull(make_scene(2.0, 2.0))
    assert pp.can_pull(make_scene(2.0, 2.0, psi=np.pi - PSI))
    assert not pp.can_pull(make_scene(2.0, 2.0, psi=np.pi / 2))
    assert not pp.can_pull(make_scene(0.0, np.inf))
    assert pp.can_pull(make_scene(2.0, pp.PerfectlyRough()))


def test_slips_while_pushing_needs_a_law_that_slips():
    assert pp.slips_while_pushing(make_scene(2.0, np.inf))
    assert not pp.slips_while_pushing(make_scene(2.0, DEFINITION_2))
    assert not pp.slips_while_pushing(make_scene(2.0, pp.PerfectlyRough()))
    assert pp.slips_while_pushing(make_scene(0.0, 1.0))


def test_vectorised_maps_broadcast_force_angle_against_share():
    scene = make_scene(2.0, np.inf, BOTH)
    phi, share = np.linspace(0, 3, 4)[:, None], np.array([0.0, 0.5, 1.0])
    angles = pp.motion_angle(scene, phi, share)
    assert angles.shape == pp.spin_ratio(scene, phi, share).shape == (4, 3)
    assert angles[2, 1] == pp.motion_angle(scene, phi[2, 0], 0.5)
    assert pp.motion_centers(scene, phi, share).shape == (4, 3, 2)
    curve = curve_of_unit_motions(scene, phi)
    assert curve.force.shape == curve.contact_motion.shape == (4, 1, 2)


def test_empty_arrays():
    for effects in EFFECT_SETS.values():
        scene = make_scene(2.0, 1.0, effects)
        assert pp.motion_angle(scene, [], 0.5 if effects == BOTH else None).shape == (0,)
        assert curve_of_unit_motions(scene, []).magnitude.shape == (0,)


def test_pure_spin_ratios_bound_every_share():
    scene = make_scene(3.0, np.inf, BOTH)
    phi = np.linspace(0, np.pi, 37)
    near, far = np.sort([np.abs(pp.spin_ratio(scene, phi, share)) for share in (0, 1)], axis=0)
    for share in (0.01, 0.5, 0.99):
        k = np.abs(pp.spin_ratio(scene, phi, share))
        assert np.all((near - 1e-14 <= k) & (k <= far * (1 + 1e-14)))
