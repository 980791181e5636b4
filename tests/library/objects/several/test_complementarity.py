"""Every solution with several contacts, and no other, also solves the complementarity conditions."""

from __future__ import annotations

import pytest
from objects.several.scenes import compare, degenerate_scene, modes_of, random_scene, scene_of

import planar_pushing as pp

#: Scenes by the number of contacts and the seed: those of every test run, and all.
FEW = [(2, seed) for seed in range(20)] + [(3, seed) for seed in range(5000, 5005)]
MANY = [(2, seed) for seed in range(20, 160)] + [(3, seed) for seed in range(5005, 5025)]
MANY += [(4, seed) for seed in range(6000, 6006)]


def require_equal(scene, seed, starts):
    answer, unmet, extra = compare(scene, seed, starts)
    assert not unmet, (answer, unmet)
    assert not extra, (answer, extra)
    return answer


@pytest.mark.parametrize("part", [0, pytest.param(1, marks=pytest.mark.slow)])
def test_random_scenes(part):
    answers = [
        require_equal(random_scene(seed, count), seed, 200 * count) for count, seed in FEW[part::2]
    ]
    assert sum(map(len, answers)) >= len(answers) / 2


@pytest.mark.slow
@pytest.mark.parametrize("part", range(8))
def test_many_random_scenes(part):
    for count, seed in MANY[part::8]:
        require_equal(random_scene(seed, count), seed, 200 * count)


def test_five_solutions_of_which_three_share_their_modes():
    """A thin object between two fingers that move alike, far from the feet."""
    feet = [(0.74, 0.098), (0.786, 0.055), (0.592, 0.133), (0.053, 0.036)]
    velocity = (0.381, -0.631)
    fingers = [
        ((0.916, 0.141), (-0.82, -0.573), velocity, 1.8),
        ((-0.979, -0.075), (0.887, 0.462), velocity, 1.8),
    ]
    answer = require_equal(scene_of(feet, [0.515, 0.399, 0.916, 0.448], fingers), 3, 600)
    assert [modes_of(one) for one in answer] == ["KK", "RS", "RL", "RL", "RL"]


def is_squeeze(scene):
    """Whether two contacts are refused because they press on one line and do not close in."""
    try:
        scene.solve()
    except pp.InvalidValue as refusal:
        return "squeeze" in str(refusal)
    return False


def compare_degenerate(seeds):
    """Number of scenes that are not refused as a squeeze; the others are compared."""
    number = 0
    for seed in seeds:
        scene = degenerate_scene(seed)
        if not is_squeeze(scene):
            require_equal(scene, seed, 400)
            number += 1
    return number


def test_degenerate_scenes():
    assert compare_degenerate(range(10)) >= 8


@pytest.mark.slow
@pytest.mark.parametrize("part", range(5))
def test_many_degenerate_scenes(part):
    assert compare_degenerate(range(10 + 10 * part, 20 + 10 * part)) >= 7
