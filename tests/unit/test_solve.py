"""The enumeration of contact modes, elementwise and one at a time; cones and centres around it."""

from __future__ import annotations

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.mechanics.candidates import candidates, outcomes
from planar_pushing.mechanics.centers import conservative_spin_ratios
from planar_pushing.mechanics.plane import direction
from unit.builders import BOTH, DEFINITION_2, EFFECT_SETS, PSI, make_scene, names

EVERY_EFFECT = pytest.mark.parametrize("effects", EFFECT_SETS.values(), ids=EFFECT_SETS)
EVERY_LAW = pytest.mark.parametrize(
    "law", [pp.Coulomb(1.4), pp.InfiniteFriction(), DEFINITION_2, pp.PerfectlyRough()], ids=str
)
ANGLES = np.deg2rad([-170.0, -90.0, -1.0, 0.0, 30.0, 90.0, 140.0, 165.0, 180.0])


@EVERY_EFFECT
@EVERY_LAW
def test_candidates_are_elementwise(effects, law):
    scene = make_scene(2.0, law, effects)
    found = candidates(scene, direction(ANGLES), np.array([[1.0], [3.0]]))
    assert outcomes(found).shape == (2, ANGLES.size)
    for row, magnitude in enumerate((1.0, 3.0)):
        for column in range(0, ANGLES.size, 2):
            single = pp.solve(scene, ANGLES[column], magnitude)
            modes = [
                each.mode
                for each in found
                for consistent in each.consistent[row, column]
                if consistent
            ]
            assert tuple(modes) == single.modes
            assert outcomes(found)[row, column] == single.outcome


def test_solutions_are_an_iterable_of_known_length():
    solutions = pp.solve(make_scene(2.0, 2.0), np.deg2rad(-10))
    assert len(solutions) == len(list(solutions)) == len(solutions.modes) == 3
    assert solutions.modes == tuple(sorted(solutions.modes))


def test_separation_has_a_centre_at_infinity_and_no_spin():
    (separate,) = pp.solve(make_scene(2.0, 2.0), np.deg2rad(-90))
    assert separate.mode is pp.ContactMode.SEPARATE
    assert separate.spin_ratio == 0
    assert np.any(np.isinf(separate.center))


@EVERY_EFFECT
def test_center_and_twist_agree(effects):
    scene = make_scene(3.0, 2.0, effects, radius=0.5)
    (stick,) = pp.solve(scene, 1.0, 2.0)
    vx, vy, omega = stick.twist
    offset = stick.center - 3.0 * direction(PSI)
    assert [vx - omega * offset[1], vy + omega * offset[0]] == pytest.approx([0, 0], abs=1e-12)
    contact = [vx + omega * 3 * np.sin(PSI), vy - omega * 3 * np.cos(PSI)]
    assert stick.contact_motion == pytest.approx(contact, rel=1e-12)
    assert stick.contact_motion == pytest.approx(2 * direction(1.0), rel=1e-12)
    assert abs(stick.spin_ratio) == pytest.approx(0.5 * abs(omega) / np.hypot(vx, vy), rel=1e-12)


@EVERY_EFFECT
def test_pusher_angle_is_taken_modulo_a_turn(effects):
    scene = make_scene(2.0, 2.0, effects)
    for angle in (-0.1, 1.0, 3.0):
        for turns in (-1, 2):
            assert names(pp.solve(scene, angle + 2 * np.pi * turns)) == names(
                pp.solve(scene, angle)
            )


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
    curve = pp.limit_curve(scene, phi)
    assert curve.force.shape == curve.contact_motion.shape == (4, 1, 2)


def test_empty_arrays():
    for effects in EFFECT_SETS.values():
        scene = make_scene(2.0, 1.0, effects)
        assert pp.motion_angle(scene, [], 0.5 if effects == BOTH else None).shape == (0,)
        assert pp.limit_curve(scene, []).magnitude.shape == (0,)


def test_pure_spin_ratios_bound_every_share():
    scene = make_scene(3.0, np.inf, BOTH)
    phi = np.linspace(0, np.pi, 37)
    near, far = np.sort([np.abs(pp.spin_ratio(scene, phi, share)) for share in (0, 1)], axis=0)
    for share in (0.01, 0.5, 0.99):
        k = np.abs(pp.spin_ratio(scene, phi, share))
        assert np.all((near - 1e-14 <= k) & (k <= far * (1 + 1e-14)))


def test_conservative_spin_ratios_follow_the_seven_cases():
    near, far = conservative_spin_ratios([-2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0])
    assert near == pytest.approx([-1, -1, 0, 0, 0, 1, 1])
    assert far == pytest.approx([-np.inf, -1, -1, 0, 1, 1, np.inf])


@pytest.mark.parametrize("mu", [0.5, 2.0, np.inf])
@pytest.mark.parametrize("length", [0.0, 0.5, 1.0, 1.3, 5.0, 100.0])
@pytest.mark.parametrize("psi", [0.3, PSI, 1.5, 2.5])
def test_conservative_cone_contains_the_exact_one(mu, length, psi):
    scene = make_scene(length, mu, BOTH, psi)
    bound, exact = pp.conservative_motion_cone(scene), pp.motion_cone(scene)
    assert bound.right <= exact.right + 1e-14
    assert exact.left <= bound.left + 1e-14
