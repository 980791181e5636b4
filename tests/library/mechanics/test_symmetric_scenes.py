"""Symmetric scenes with their literal answers, and defects that were found once."""

from __future__ import annotations

import math

import numpy as np
import pytest
from mechanics.builders import names
from mechanics.checked import INFINITE, TABLE, UPRIGHT, assert_scanned, scene_of, solved
from mechanics.degenerate import SQUARE, SYMMETRIC, regular

import planar_pushing as pp

HEAVY_FOOT = [2, 1, 1]
EVEN = {"feet": TABLE, "square": pp.Polygon(SQUARE), "ring": pp.Ring(1.0), "map": SYMMETRIC["map"]}


@pytest.mark.parametrize("support", EVEN.values(), ids=EVEN)
@pytest.mark.parametrize("rho", [0.3, 1.0, 2.0])
@pytest.mark.parametrize("magnitude", [1e-3, 1.0, 4.9, 5.0, 1e3])
def test_a_symmetric_slider_pushed_along_the_fence_separates_or_sticks(support, rho, magnitude):
    """It mirrors itself in the contact's normal, so that the force is along the fence at every speed.

    Slips from rest up to the stick are a continuum, which is reported on the stick (defects A and E).
    """
    scene = scene_of(support, 1.0, UPRIGHT, INFINITE, pp.Inertia(gyration_radius=rho))
    for angle in (0.0, math.pi):
        found = solved(scene, angle, magnitude)
        assert names(found) == ["SEPARATE", "STICK"]
        assert found[1].continuum
        assert found[1].contact_motion == pytest.approx([math.cos(angle) * magnitude, 0.0])


def test_an_array_is_solved_for_all_of_its_elements():
    """Of a table that is pushed, one push along the fence does not spoil the others (defect A)."""
    scene = scene_of(TABLE, 1.0, UPRIGHT, INFINITE, pp.Inertia())
    found = solved(scene, np.linspace(0, 3, 1000))
    assert found.solutions[0] == 2
    assert np.all(found.solutions[1:] == 1)


@pytest.mark.parametrize("angle", [0.0, math.pi])
def test_feet_above_the_contact_that_only_separate(angle):
    """Defect B; discs of 1e-3 to 1e-9 in the place of the feet say so, and pushes 1e-9 rad beside."""
    feet = pp.Points([(-1, 0), (-1, 1), (-1, -1)], HEAVY_FOOT)
    scene = scene_of(feet, 3.0, UPRIGHT, pp.Coulomb(0.5), pp.Inertia())
    assert names(solved(scene, angle)) == ["SEPARATE"]


@pytest.mark.parametrize("size", [1e-3, 1e-6])
def test_small_discs_above_the_contact_only_separate(size):
    discs = [(w, pp.Disc(size, (-1, y))) for w, y in zip(HEAVY_FOOT, (0, 1, -1), strict=True)]
    scene = scene_of(pp.Composite(discs), 3.0, UPRIGHT, pp.Coulomb(0.5), pp.Inertia())
    assert names(solved(scene, 0.0)) == ["SEPARATE"]


def test_a_slip_about_a_foot_that_is_the_end_of_a_continuum():
    """Defect B: the foot at the slider's center holds f_y = 2 f_x up to its share, a half.

    With f_x = (0.5 + u_x / 3) / 3 and |f| = sqrt(5) f_x that is at u_x = 0.51246.
    """
    feet = pp.Points([(0, 0), (0, 1), (0, -1)], HEAVY_FOOT)
    scene = scene_of(feet, 3.0, UPRIGHT, pp.Coulomb(0.5), pp.Inertia())
    found = solved(scene, 0.0)
    assert names(found) == ["SEPARATE", "SLIP_LEFT"]
    slip, held = found[1], 0.5 / math.sqrt(5)
    assert slip.pivot == 0
    assert slip.continuum
    assert slip.force == pytest.approx([held, 2 * held], rel=1e-9)
    assert slip.contact_motion == pytest.approx([3 * (3 * held - 0.5), 0.0], abs=1e-9)


@pytest.mark.parametrize("center", [(0.25, -0.25), (0.0, 0.0)])
def test_feet_beside_the_contact_under_infinite_friction(center):
    """Defect C: no NaN, and no force that pulls at the slider."""
    feet = pp.Points([(0, -0.94), (0, -0.71), (0, -0.93)], [1.25, 4.4, 0.1])
    mass = pp.Inertia(mass=0.0233, gyration_radius=0.0535, center=center)
    scene = scene_of(feet, 0.0, UPRIGHT, INFINITE, mass, weight=9.83)
    found = solved(scene, -UPRIGHT)
    assert all(each.force[1] >= -1e-12 * np.hypot(*each.force) for each in found)


def test_one_place_is_no_support_however_its_weights_round():
    """Defect D: the extent of such points is 0 or some 1e-17."""
    random = np.random.default_rng(13)
    slider = pp.Slider(rod_length=1.0, rod_angle=1.0, radius=1.0)
    for weights in ([1, 2, 4, 6], *random.uniform(0.1, 1, (50, 4))):
        friction = pp.SupportFriction(support=pp.Points([(0.3, 0.7)] * 4, weights))
        with pytest.raises(pp.InvalidValue):
            pp.solve(pp.Scene(slider=slider, contact=INFINITE, effects=(friction,)), 1.0)


ALONG_ROD = {
    "two feet": (
        pp.Points([(0, 0), (-0.164137793662396, -0.4796726269281757)], [0.518, 0.66]), 3.0
    ),
    "attacker": (
        pp.Points(
            [(0, 0), (-0.164137793662396, -0.4796726269281757)],
            [0.5180018750924412, 0.660162015113078],
        ),
        3.0,
    ),
    "table": (TABLE, 1.0),
    "square": (pp.Polygon(SQUARE), 2.0),
    "ring": (pp.Ring(1.0), 2.0),
}  # fmt: skip


@pytest.mark.parametrize("psi", [math.pi / 4, 3 * math.pi / 4])
@pytest.mark.parametrize(("support", "length"), ALONG_ROD.values(), ids=ALONG_ROD)
def test_an_edge_of_the_cone_along_the_rod(support, length, psi):
    """mu = 1: every force in the cone, none against the edge, at least one solution."""
    beside = np.concatenate([[0.0, 7.687221475767577e-14], 10.0 ** np.arange(-14, -3)])
    angle = np.concatenate([beside, -beside, math.pi - beside, beside - math.pi])
    for mass in (0.0001534647824815597, 1.0):
        inertia = pp.Inertia(mass=mass, gyration_radius=0.5)
        solved(scene_of(support, length, psi, pp.Coulomb(1.0), inertia), angle)


def test_a_push_at_an_edge_along_the_rod_as_a_number():
    """The attacker's own push, which gave a force of (-0.04425, -0.04425)."""
    support, length = ALONG_ROD["attacker"]
    inertia = pp.Inertia(mass=0.0001534647824815597, gyration_radius=0.5)
    scene = scene_of(support, length, math.pi / 4, pp.Coulomb(1), inertia)
    assert len(solved(scene, 7.687221475767577e-14)) >= 1


@pytest.mark.parametrize("away", [0.5, -0.5, 1e-3])
def test_a_ring_with_its_mass_on_the_normal_separates_or_sticks(away):
    """It mirrors itself too, as the mass is on the normal through the contact."""
    scene = scene_of(pp.Ring(1.0), 2.0, UPRIGHT, INFINITE, pp.Inertia(center=(away, 0.0)))
    for angle in (0.0, math.pi):
        found = solved(scene, angle)
        assert names(found) == ["SEPARATE", "STICK"]
        assert found[1].continuum


@pytest.mark.parametrize("center", [(-0.5, 0.0), (0.0, 0.5), (0.2, -0.3)])
@pytest.mark.parametrize("psi", [math.pi / 4, UPRIGHT, 2.0])
def test_a_ring_with_its_mass_aside_pushed_exactly_along_the_fence(psi, center):
    """The slips under infinite friction are those of a scan; an upright mass is a continuum, above."""
    if psi == UPRIGHT and center[1] == 0.0:
        center = (0.1, 0.4)
    scene = scene_of(
        pp.Ring(1.0), 2.0, psi, INFINITE, pp.Inertia(gyration_radius=0.5, center=center)
    )
    for angle in (0.0, math.pi):
        assert_scanned(scene, np.array([angle]), 1.0)


def test_definition_two_has_no_stick_along_the_fence_for_a_symmetric_slider():
    """Its cone is open, and the force is along the fence."""
    law = pp.InfiniteFriction("none")
    scene = scene_of(TABLE, 1.0, UPRIGHT, law, pp.Inertia())
    assert names(solved(scene, 0.0)) == ["SEPARATE"]


@pytest.mark.parametrize(
    "support", [TABLE, pp.Disc(1.0), pp.Ring(1.0)], ids=["feet", "disc", "ring"]
)
@pytest.mark.parametrize("masses", [(), (pp.Inertia(),)], ids=["friction", "both"])
def test_without_friction_at_the_contact_a_push_along_the_fence_moves_nothing(support, masses):
    """The force is normal and so has no power where u_y = 0; and no retreat can pull, however slow."""
    scene = scene_of(support, 1.0, 1.0, pp.Coulomb(0.0), *masses)
    for angle in (0.0, math.pi, -math.pi, -1e-15, -1e-12, -1e-4):
        assert names(solved(scene, angle)) == ["SEPARATE"]
    assert names(solved(scene, 1e-14))[-1].startswith("SLIP")


def test_collinear_feet_on_a_flat_rod_have_no_slip_twice():
    """Defect F: psi of some 1e-6, pushes within 1e-8 of the fence."""
    random = np.random.default_rng(14)
    beside = 10.0 ** random.uniform(-16, -8, 200) * random.choice([-1, 1], 200)
    angle = np.where(random.random(200) < 0.5, beside, math.pi - beside)
    for psi in (1.6e-6, 5e-6):
        for feet in ([(-1, 0), (0.3, 0), (1, 0)], [(0, -1), (0, 0.4), (0, 1)]):
            scene = scene_of(pp.Points(feet, [1, 2, 3]), 1.5, psi, pp.Coulomb(0.7), pp.Inertia())
            solved(scene, angle, 10 ** random.uniform(-2, 2, 200))


def test_a_tripod_pivots_about_a_foot_for_pushes_across_its_radius():
    """Exactly, beyond the center, at an offset in [2 - sqrt 3, 2 + sqrt 3]."""
    tripod = pp.Points(regular(3), [1, 1, 1])
    for offset, pivots in ((0.26, False), (0.28, True), (3.7, True), (3.75, False)):
        scene = scene_of(tripod, offset, UPRIGHT, pp.PerfectlyRough())
        # The rod is body x: its contact at (-offset, 0), pushed across the radius of foot 0.
        found = solved(scene, 0.0)
        assert (found[-1].pivot == 0) == pivots, offset
