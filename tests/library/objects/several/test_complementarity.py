"""Every solution with several contacts, and no other, also solves the complementarity conditions."""

from __future__ import annotations

import pytest
from objects.several.scenes import compare, degenerate_scene, random_scene

import planar_pushing as pp

#: Scenes by the number of contacts and the seed: those of every test run, and all.
FEW = [(2, seed) for seed in range(60)] + [(3, seed) for seed in range(5000, 5015)]
MANY = [(2, seed) for seed in range(60, 500)] + [(3, seed) for seed in range(5015, 5060)]
MANY += [(4, seed) for seed in range(6000, 6015)]


def require_equal(scene, seed, starts):
    answer, unmet, extra = compare(scene, seed, starts)
    assert not unmet, (answer, unmet)
    assert not extra, (answer, extra)
    return answer


@pytest.mark.parametrize("part", range(5))
def test_random_scenes(part):
    answers = [
        require_equal(random_scene(seed, count), seed, 200 * count) for count, seed in FEW[part::5]
    ]
    assert sum(map(len, answers)) >= len(answers) / 2


@pytest.mark.slow
@pytest.mark.parametrize("part", range(25))
def test_many_random_scenes(part):
    for count, seed in MANY[part::25]:
        require_equal(random_scene(seed, count), seed, 200 * count)


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


@pytest.mark.parametrize("part", range(3))
def test_degenerate_scenes(part):
    assert compare_degenerate(range(10 * part, 10 * part + 10)) >= 8


@pytest.mark.slow
@pytest.mark.parametrize("part", range(12))
def test_many_degenerate_scenes(part):
    assert compare_degenerate(range(30 + 10 * part, 40 + 10 * part)) >= 7
