"""Pusher directions within an ulp of the fence and of the edges of the motion cone."""

from __future__ import annotations

import numpy as np
import pytest
from mechanics.builders import (
    DEFINITION_2,
    EVERY_EFFECT,
    FRICTION,
    INERTIA,
    make_scene,
    names,
    numbers,
)

import planar_pushing as pp

LAWS = [pp.Coulomb(0.0), pp.Coulomb(2.0), pp.InfiniteFriction(), DEFINITION_2, pp.PerfectlyRough()]
EVERY_LAW = pytest.mark.parametrize("law", LAWS, ids=str)


@EVERY_EFFECT
@EVERY_LAW
@pytest.mark.parametrize("length", [0.0, 0.5, 1e6])
def test_directions_next_to_the_fence_have_finite_solutions(effects, law, length):
    scene = make_scene(length, law, effects)
    for fence in (0.0, np.pi):
        for angle in (np.nextafter(fence, -9), fence, np.nextafter(fence, 9)):
            assert np.all(np.isfinite(numbers(pp.solve(scene, angle))))


@EVERY_EFFECT
@pytest.mark.parametrize("length", [0.5, 2.0, 5.0])
def test_directions_next_to_180_degrees(effects, length):
    scene = make_scene(length, np.inf, effects)
    assert names(pp.solve(scene, np.nextafter(np.pi, 0))) == ["SLIP_RIGHT"]
    assert names(pp.solve(scene, np.pi)) == ["SEPARATE"]
    assert names(pp.solve(scene, -np.pi)) == ["SEPARATE"]
    assert names(pp.solve(scene, np.nextafter(np.pi, 4))) == ["SEPARATE"]


@EVERY_EFFECT
@pytest.mark.parametrize("length", [0.5, 2.0, 5.0])
def test_directions_next_to_0_degrees(effects, length):
    scene = make_scene(length, np.inf, effects)
    assert names(pp.solve(scene, np.nextafter(0, 1))) == ["STICK"]
    assert names(pp.solve(scene, 0.0)) == ["SEPARATE", "STICK"]
    assert names(pp.solve(scene, np.nextafter(0, -1)))[:2] == ["SEPARATE", "STICK"]


@pytest.mark.parametrize("effects", [FRICTION, INERTIA], ids=["friction", "inertia"])
@pytest.mark.parametrize("law", [pp.Coulomb(0.5), pp.Coulomb(2.0), pp.InfiniteFriction()], ids=str)
@pytest.mark.parametrize("length", [0.0, 0.5, 2.0, 5.0, 100.0])
def test_directions_within_an_ulp_of_a_cone_edge_count_once(effects, law, length):
    scene = make_scene(length, law, effects)
    cone = pp.motion_cone(scene)
    for edge in (cone.right, cone.left):
        for angle in (np.nextafter(edge, -9), edge, np.nextafter(edge, 9)):
            moving = [n for n in names(pp.solve(scene, angle)) if n != "SEPARATE"]
            assert moving == ["STICK"]


@pytest.mark.parametrize("effects", [FRICTION, INERTIA], ids=["friction", "inertia"])
@pytest.mark.parametrize("length", [0.5, 2.0, 10.0, 30.0, 100.0, 1e3])
def test_pushing_across_a_cone_edge_always_has_one_solution(effects, length):
    """The right edge of mu = 1 is along the rod, where the force angle hardly turns."""
    scene = make_scene(length, 1.0, effects)
    edge = pp.motion_cone(scene).right
    offsets = 10.0 ** np.arange(-15.5, -5, 0.5)
    for angle in np.concatenate([edge - offsets, edge + offsets]):
        assert len(pp.solve(scene, angle)) == 1, angle - edge


@EVERY_EFFECT
def test_definition_2_at_the_edge_of_its_open_cone(effects):
    scene = make_scene(2.0, DEFINITION_2, effects)
    left = pp.motion_cone(scene).left
    assert not pp.motion_cone(scene).closed
    assert names(pp.solve(scene, left)) == []
    assert names(pp.solve(scene, left - 0.2)) == ["STICK"]


@pytest.mark.parametrize("angle", [0.0, np.pi])
def test_a_tangent_root_is_one_slip(angle):
    """Between the centers of pressure and mass the normal force touches zero and does not cross it.

    The motion of the contact was computed with more digits; the other one is its mirror image.
    """
    feet = pp.Points([(-1.0, 0.0), (1.0, 1.0), (1.0, -1.0)])
    mass = pp.Inertia(gyration_radius=2.0, center=(-0.5, 0.0))
    scene = pp.Scene(
        slider=pp.Slider(rod_length=0.0, rod_angle=np.pi / 4), contact=pp.InfiniteFriction(),
        effects=(pp.SupportFriction(support=feet, weight=0.59268763), mass),
    )  # fmt: skip
    sense = np.cos(angle)
    slips = [each for each in pp.solve(scene, angle) if each.mode.name.startswith("SLIP")]
    assert [each.mode.name for each in slips] == ["SLIP_LEFT" if sense > 0 else "SLIP_RIGHT"]
    # The weight has eight digits, and a double root half of them.
    assert slips[0].contact_motion == pytest.approx([0.3951250816 * sense, 0.0], abs=1e-7)
    assert slips[0].force == pytest.approx([0.98781 * sense, 0.0], abs=1e-5)
