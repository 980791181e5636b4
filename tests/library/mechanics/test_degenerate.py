"""Contact modes of symmetric and degenerate scenes, and of random ones, against the transcription.

The slow nets solve some 110,000 scenes.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from mechanics.checked import UPRIGHT, assert_scanned, scene_of, solved
from mechanics.degenerate import (
    EFFECTS,
    RANDOM,
    SYMMETRIC,
    degenerate,
    degenerate_arrays,
    generic_arrays,
    random_support,
    symmetric_feet,
)
from mechanics.problems import problem_of
from mechanics.transcription import faults, found_of, imbalance

import planar_pushing as pp

# --- Nets ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("effects", EFFECTS)
def test_degenerate_scenes_of_feet_meet_the_conditions(effects):
    """Equal feet, feet on the contact's normal and tangent, pushes along and across the fence."""
    wrong = []
    for scene, angle, magnitude in degenerate(1, 150, effects):
        found = faults(scene, angle, magnitude, pp.solve(scene, angle, magnitude))
        wrong += [f"{each}\n    {scene!r}, {angle!r}, {magnitude}" for each in found]
    assert not wrong, "\n".join(wrong[:20])


@pytest.mark.parametrize("effects", ["friction", "both"])
@pytest.mark.parametrize("kind", SYMMETRIC)
def test_degenerate_scenes_of_symmetric_areas_meet_the_conditions(kind, effects):
    seed = list(SYMMETRIC).index(kind)
    scene, angle, magnitude = degenerate_arrays(seed, SYMMETRIC[kind], effects, 300)
    solved(scene, angle, magnitude)


@pytest.mark.parametrize("effects", ["friction", "both"])
@pytest.mark.parametrize("kind", RANDOM)
def test_random_scenes_meet_the_conditions(kind, effects):
    """Of backward errors, generic scenes leave a thousandth of what is allowed."""
    support = random_support(np.random.default_rng(3), kind)
    scene, angle, magnitude = generic_arrays(4, support, effects, 300)
    each = found_of(solved(scene, angle, magnitude))
    problem = problem_of(scene, angle, magnitude)[each.place]
    assert imbalance(problem, each.twist, each.force).max() < 1e-3


@pytest.mark.parametrize(("kind", "count"), [("points", 40), ("segment", 10), ("polygon", 3)])
@pytest.mark.parametrize("effects", ["friction", "both"])
def test_slips_are_as_many_as_a_scan_along_the_fence_finds(kind, count, effects):
    """A slip that the scan steps over has a partner within the same step."""
    support = random_support(np.random.default_rng(5), kind)
    scene, angle, magnitude = generic_arrays(6, support, effects, count)
    assert_scanned(scene, angle, magnitude)


#: Supports of the slow net: feet of every kind, areas with an axis, and areas without.
FEET_SEEDS = range(16)


@pytest.mark.slow
@pytest.mark.parametrize("effects", ["friction", "both"])
@pytest.mark.parametrize("seed", FEET_SEEDS)
def test_thousands_of_degenerate_scenes_of_feet(seed, effects):
    support = symmetric_feet(np.random.default_rng(seed))
    solved(*degenerate_arrays([seed, 1], support, effects, 2000))


@pytest.mark.slow
@pytest.mark.parametrize("effects", ["friction", "both"])
@pytest.mark.parametrize("kind", SYMMETRIC)
def test_thousands_of_degenerate_scenes_of_areas(kind, effects):
    solved(*degenerate_arrays([7, 1], SYMMETRIC[kind], effects, 1500))


@pytest.mark.slow
@pytest.mark.parametrize("effects", ["friction", "both"])
@pytest.mark.parametrize("kind", RANDOM)
def test_thousands_of_random_scenes(kind, effects):
    support = random_support(np.random.default_rng(8), kind)
    solved(*generic_arrays(9, support, effects, 1500))


@pytest.mark.slow
@pytest.mark.parametrize("effects", ["friction", "both"])
@pytest.mark.parametrize("seed", range(8))
def test_slips_of_many_feet_are_as_many_as_a_scan_finds(seed, effects):
    support = random_support(np.random.default_rng([seed, 5]), "points")
    assert_scanned(*generic_arrays([seed, 6], support, effects, 150))


NEAR_PIVOTS = {
    "foot at the contact": (
        pp.Points([(0, 0), (0.1, -1.4), (1.5, -1.3)], [2, 1, 2]), 0.0, 2.288691053419013, 1e-12
    ),
    "foot above the contact": (
        pp.Points([(0, -1), (0, 0), (0, 1)], [1, 3, 2]), 2.0, UPRIGHT, math.pi - 1e-13
    ),
    "feet on the rod": (pp.Points([(-1, 0), (-1, 1), (-1, -1)], [3, 3, 1]), 3.0, UPRIGHT, 1e-10),
}  # fmt: skip


@pytest.mark.parametrize("near", NEAR_PIVOTS.values(), ids=NEAR_PIVOTS)
def test_the_force_of_a_foot_that_barely_moves_leaves_no_torque(near):
    """The twist, in doubles, does not say how such a foot moves; the balance of torques says it."""
    support, length, psi, angle = near
    scene = scene_of(support, length, psi, pp.PerfectlyRough())
    each = found_of(solved(scene, angle))
    problem = problem_of(scene, angle)[each.place]
    assert imbalance(problem, each.twist, each.force, rounding=0.0).max() <= 1


# --- Symmetry and units --------------------------------------------------------------------------


def mirrored(support):
    """A support on the other side of the rod."""
    return replace(support, positions=[(x, -y) for x, y in support.positions])


def in_mirror(scene):
    """The scene seen in a mirror along the fence's normal: the rod leans the other way."""
    psi = scene.slider.rod_angle
    friction, *masses = scene.effects
    masses = [replace(each, center=(each.center[0], -each.center[1])) for each in masses]
    slider = pp.Slider(rod_length=scene.slider.rod_length, rod_angle=math.pi - psi)
    effects = (replace(friction, support=mirrored(friction.support)), *masses)
    return pp.Scene(slider=slider, contact=scene.contact, effects=effects)


@pytest.mark.parametrize("effects", ["friction", "both"])
def test_a_mirrored_scene_has_mirrored_solutions(effects):
    """Away from pushes along the fence, whose mirror images rounding moves to the other side of it."""
    turn, compared = np.array([-1.0, 1.0, -1.0]), 0
    for scene, angle, magnitude in degenerate(11, 120, effects):
        if abs(math.sin(angle)) < 1e-3:
            continue
        compared += 1
        own = pp.solve(scene, angle, magnitude)
        other = pp.solve(in_mirror(scene), math.remainder(math.pi - angle, 2 * math.pi), magnitude)
        assert len(own) == len(other), (scene, angle, magnitude)
        for one in own:
            gap = min(np.abs(each.twist * turn - one.twist).max() for each in other)
            assert gap <= 1e-7 * np.abs(one.twist).max(), (scene, angle, magnitude)
    assert compared > 30


@pytest.mark.parametrize("effects", EFFECTS)
def test_units_that_are_powers_of_two_change_no_digit(effects):
    """Lengths by 2, weights by 4, masses by 1/8 and so motions by 32: only exponents change."""
    length, weight, mass = 2.0, 4.0, 0.125
    motion = weight / mass
    for scene, angle, magnitude in degenerate(12, 80, effects):
        own = pp.solve(scene, angle, magnitude)
        other = pp.solve(scaled(scene, length, weight, mass), angle, motion * magnitude)
        assert own.modes == other.modes, (scene, angle, magnitude)
        for one, two in zip(own, other, strict=True):
            scale = motion * np.array([1, 1, 1 / length])
            assert np.array_equal(two.twist, one.twist * scale)
            assert np.array_equal(two.force, one.force * weight)


def scaled(scene, length, weight, mass):
    """The scene in other units."""
    slider = pp.Slider(
        rod_length=length * scene.slider.rod_length, rod_angle=scene.slider.rod_angle
    )
    effects = []
    for each in scene.effects:
        if isinstance(each, pp.Inertia):
            center = tuple(length * x for x in each.center)
            own = {"mass": mass * each.mass, "gyration_radius": length * each.gyration_radius}
            effects.append(pp.Inertia(center=center, **own))
        else:
            places = [(length * x, length * y) for x, y in each.support.positions]
            support = replace(each.support, positions=places)
            effects.append(pp.SupportFriction(support=support, weight=weight * each.weight))
    return pp.Scene(slider=slider, contact=scene.contact, effects=tuple(effects))
