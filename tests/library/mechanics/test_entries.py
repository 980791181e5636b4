"""Scenes and values as plain data."""

from __future__ import annotations

import json
from enum import StrEnum

import numpy as np
import pytest
from mechanics.builders import BOTH, PSI, make_scene

import planar_pushing as pp
from planar_pushing.mechanics.entries import PACKAGES, plain, scene_entry, to_json, versions


class Color(StrEnum):
    """An option."""

    RED = "red"


def test_json_has_words_for_infinities_and_keys_in_order():
    value = {"b": (1.0, float("inf")), "a": [-float("inf"), None, Color.RED], 3: {"x": True}}
    assert to_json(value) == ('{"3": {"x": true}, "a": ["-inf", null, "red"], "b": [1.0, "inf"]}')
    assert plain(np.float64(2.5)) == 2.5


def test_versions_are_those_of_the_packages():
    assert set(json.loads(versions())) == set(PACKAGES)


@pytest.mark.parametrize("law", [
    (pp.Coulomb(0.5), {"law": "coulomb", "friction_coefficient": 0.5}),
    (pp.InfiniteFriction(), {"law": "infinite_friction", "at_zero_normal": "free"}),
    (pp.InfiniteFriction("none"), {"law": "infinite_friction", "at_zero_normal": "none"}),
    (pp.PerfectlyRough(), {"law": "perfectly_rough"}),
], ids=str)  # fmt: skip
def test_a_scene_as_an_entry(law):
    contact, entry = law
    scene = make_scene(2.0, contact, BOTH, radius=1.5)
    assert scene_entry(scene, "a title") == {
        "title": "a title",
        "slider": {"rod_length": 2.0, "rod_angle": 45.0, "radius": 1.5},
        "contact": entry,
        "effects": [
            {"type": "ring_friction", "weight": 1.0},
            {"type": "inertia", "mass": 1.0, "gyration_radius": 1.0},
        ],
    }


def test_degrees_of_an_entry_give_the_same_radians():
    angles = np.array([*np.random.default_rng(4).uniform(0.01, 3.1, 200), PSI])
    degrees = [scene_entry(make_scene(1.0, psi=x))["slider"]["rod_angle"] for x in angles.tolist()]
    assert np.deg2rad(degrees) == pytest.approx(angles, rel=2.3e-16, abs=0)


def test_degrees_are_short_where_they_can_be():
    for degrees in (30.0, 12.5, 0.1, 179.0):
        scene = make_scene(1.0, psi=float(np.deg2rad(degrees)))
        assert scene_entry(scene)["slider"]["rod_angle"] == degrees


def test_a_law_of_ones_own_has_no_entry():
    class Glue:
        force_angles, slips = pp.AngleInterval(0.0, 1.0), False

    with pytest.raises(pp.InvalidValue, match="save a scene of one of these laws"):
        scene_entry(make_scene(1.0, Glue()))
