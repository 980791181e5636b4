"""Accuracy against the transcription of the paper, on the same double inputs."""

from __future__ import annotations

import numpy as np
import pytest
from mechanics.builders import BOTH, DEFINITION_2, EFFECT_SETS, FRICTION, INERTIA, PSI, make_scene
from mechanics.degenerate import generic_arrays, random_support
from mpmath import mp, mpf

import planar_pushing as pp
import reference
from planar_pushing.mechanics.force.limit_curve import curve_of_unit_motions

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


# Cones of feet with inertia, whose motion under an edge is extreme at one magnitude


def rows_of(values, rows):
    """Some entries of a parameter of an array of scenes."""
    return np.asarray(values)[rows]


def feet_with_inertia(rows):
    """Some of three thousand random scenes; the first four have an edge that a few magnitudes reach."""
    support = random_support(np.random.default_rng(3), "points")
    whole, *_ = generic_arrays(78, support, "both", 3000)
    friction, mass = whole.effects
    effects = (
        pp.SupportFriction(support=support, weight=rows_of(friction.weight, rows)),
        pp.Inertia(
            mass=rows_of(mass.mass, rows), gyration_radius=rows_of(mass.gyration_radius, rows),
            center=tuple(rows_of(each, rows) for each in mass.center),
        ),
    )  # fmt: skip
    slider = pp.Slider(
        rod_length=rows_of(whole.slider.rod_length, rows),
        rod_angle=rows_of(whole.slider.rod_angle, rows), radius=1.0,
    )  # fmt: skip
    return pp.Scene(slider=slider, contact=whole.contact[rows], effects=effects)


def extreme(scene, force, sense):
    """The extreme of the motion angles under a force of any magnitude, by finer and finer grids."""
    low, high, best = np.log(1e-2), np.log(1e5), -np.inf
    for points in (1001, 101, 101, 101, 101, 101):
        sizes = np.linspace(low, high, points)
        angles = sense * pp.motion_angle(scene, force, force_ratio=np.exp(sizes))
        k = np.nanargmax(angles)
        best, low, high = angles[k], sizes[max(k - 1, 0)], sizes[min(k + 1, points - 1)]
    return sense * best


def test_no_magnitude_of_the_motion_leaves_the_cone():
    rows = [598, 2753, 1045, 481, *range(4)]
    scene, beyond = feet_with_inertia(rows), 0
    cone = pp.motion_cone(scene)
    for i, row in enumerate(rows):
        one = feet_with_inertia([row])
        for edge, force, sense in (
            (cone.right[i], one.law.right, -1.0), (cone.left[i], one.law.left, 1.0)
        ):  # fmt: skip
            reached = extreme(one, np.ravel(force)[0], sense)
            assert reached * sense <= edge * sense + 1e-9
            # An edge that is the limit of fast or slow motions is approached slowly.
            assert reached == pytest.approx(edge, abs=1e-4)
            beyond += abs(reached - edge) < 1e-9
    assert beyond > 5


def test_of_a_corner_slow_motions_with_inertia_are_those_nearest_the_fast_ones():
    """Without contact friction a segment across the normal moves in many directions, a mass in one."""
    segment = pp.SupportFriction(support=pp.Segment((0, -1), (0, 1)))
    slider = pp.Slider(rod_length=3.0, rod_angle=np.pi / 2, radius=1.0)
    for center in ((0.0, 0.0), (0.0, 0.1), (0.0, -0.1), (0.0, 3.0), (-1.5, 0.3), (-1.5, -0.3)):
        mass = pp.Inertia(gyration_radius=0.1, center=center)
        corner, fast, cone = (
            pp.motion_cone(pp.Scene(slider=slider, contact=pp.Coulomb(0.0), effects=effects)).degrees
            for effects in ((segment,), (mass,), (segment, mass))
        )  # fmt: skip
        assert fast[0] == fast[1]
        if corner[0] < fast[0] < corner[1]:
            assert cone == pytest.approx(fast, abs=1e-7)
        else:
            slow = np.clip(fast[0], *corner)
            assert cone[0] <= min(slow, fast[0]) + 1e-9
            assert cone[1] >= max(slow, fast[0]) - 1e-9
    assert not corner[0] < fast[0] < corner[1]
