"""Invariants of the contact modes."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from mechanics.builders import make_scene, names, scaled
from mechanics.strategies import (
    both,
    coefficients,
    effect_sets,
    lengths,
    magnitudes,
    one_effect,
    powers,
    pusher_angles,
    rod_angles,
    scenes,
)

import planar_pushing as pp


def replace_effects(scene, effects):
    return pp.Scene(slider=scene.slider, contact=scene.contact, effects=effects)


def rescaled(scene, force, motion):
    """The same scene in other units of force and of motion."""
    return replace_effects(
        scene,
        tuple(
            pp.RingFriction(weight=force * e.weight)
            if e.degree == 1
            else pp.Inertia(mass=force / motion * e.mass, gyration_radius=e.gyration_radius)
            for e in scene.effects
        ),
    )


def away_from_the_edges(scene, angle):
    """Whether the number of solutions cannot hang on rounding."""
    pure = [replace_effects(scene, (effect,)) for effect in scene.effects]
    special = [0.0, np.pi, *(edge for each in pure for edge in edges_of(each))]
    return np.abs(np.sin((angle - np.array(special)) / 2)).min() > 1e-6


def edges_of(scene):
    cone = pp.motion_cone(scene)
    return cone.right, cone.left


# --- Numbers of solutions -------------------------------------------------------------------------


@given(scenes(effects=one_effect), pusher_angles)
def test_sticks_exactly_inside_the_motion_cone(scene, angle):
    assume(away_from_the_edges(scene, angle))
    sticks = pp.ContactMode.STICK in pp.solve(scene, angle).modes
    assert sticks == pp.motion_cone(scene).contains(angle)


@given(scenes(length=lengths, effects=one_effect), st.floats(1e-3, np.pi - 1e-3))
def test_one_effect_has_exactly_one_solution_while_pushing(scene, angle):
    assume(away_from_the_edges(scene, angle))
    assert pp.solve(scene, angle).outcome is pp.Outcome.UNIQUE


@given(lengths, coefficients, effect_sets, rod_angles, st.floats(1e-3, np.pi - 1e-3), magnitudes)
def test_pushing_is_never_inconsistent(length, mu, effects, psi, angle, magnitude):
    """Under a closed law; definition 2 is the exception that Sec. 5 names."""
    assert len(pp.solve(make_scene(length, mu, effects, psi), angle, magnitude)) >= 1


@given(scenes(length=lengths, contact=st.just(np.inf)), magnitudes)
def test_normal_push_never_slips_under_infinite_friction(scene, magnitude):
    assert names(pp.solve(scene, np.pi / 2, magnitude)) == ["STICK"]


# --- Symmetry and scaling ------------------------------------------------------------------------

MIRRORED = {"SLIP_LEFT": "SLIP_RIGHT", "SLIP_RIGHT": "SLIP_LEFT"}


@given(scenes(), pusher_angles, magnitudes)
def test_mirrored_scene_has_mirrored_modes(scene, angle, magnitude):
    assume(away_from_the_edges(scene, angle))
    slider = scene.slider
    mirror = make_scene(slider.rod_length, scene.contact, scene.effects, np.pi - slider.rod_angle)
    found = pp.solve(scene, angle, magnitude)
    turned = pp.solve(mirror, np.pi - angle, magnitude)
    expected = sorted(MIRRORED.get(name, name) for name in names(found))
    assert sorted(names(turned)) == expected
    forces = sorted(np.hypot(*s.force) for s in found)
    assert sorted(np.hypot(*s.force) for s in turned) == pytest.approx(forces, rel=1e-8)


@given(scenes(), pusher_angles, magnitudes, powers(-3, 3), powers(-3, 3))
def test_modes_depend_on_the_magnitude_through_m_a_over_w(scene, angle, magnitude, force, motion):
    """Other units of force and motion change the numbers and nothing else."""
    assume(away_from_the_edges(scene, angle))
    found = pp.solve(scene, angle, magnitude)
    other = pp.solve(rescaled(scene, force, motion), angle, motion * magnitude)
    assert names(other) == names(found)
    for a, b in zip(found, other, strict=True):
        scale = np.hypot(*a.force)
        assert b.force / force == pytest.approx(a.force, rel=1e-8, abs=1e-10 * scale)
        assert b.twist / motion == pytest.approx(a.twist, rel=1e-7, abs=1e-10 * magnitude)


@given(scenes(effects=one_effect), pusher_angles, magnitudes)
def test_one_effect_does_not_see_the_magnitude(scene, angle, magnitude):
    assume(away_from_the_edges(scene, angle))
    found, other = pp.solve(scene, angle), pp.solve(scene, angle, magnitude)
    assert names(found) == names(other)
    for a, b in zip(found, other, strict=True):
        assert a.spin_ratio == pytest.approx(b.spin_ratio, rel=1e-12, abs=0)


@given(scenes(), pusher_angles, magnitudes, powers(-3, 3))
def test_modes_do_not_see_the_unit_of_length(scene, angle, magnitude, factor):
    assume(away_from_the_edges(scene, angle))
    slider = pp.Slider(
        rod_length=factor * scene.slider.rod_length,
        rod_angle=scene.slider.rod_angle,
        radius=factor,
    )
    effects = tuple(scaled(effect, factor) for effect in scene.effects)
    larger = pp.Scene(slider=slider, contact=scene.contact, effects=effects)
    found, other = pp.solve(scene, angle, magnitude), pp.solve(larger, angle, magnitude)
    assert names(found) == names(other)
    for a, b in zip(found, other, strict=True):
        assert b.spin_ratio == pytest.approx(a.spin_ratio, rel=1e-7)
        assert b.contact_motion == pytest.approx(a.contact_motion, rel=1e-7, abs=1e-9 * magnitude)


# --- Coincidence ---------------------------------------------------------------------------------


@given(scenes(length=lengths, effects=one_effect), st.booleans(), st.integers(-1, 1))
def test_solutions_that_coincide_at_a_cone_edge_count_once(scene, right, steps):
    cone = pp.motion_cone(scene)
    assume(cone.closed)
    edge = cone.right if right else cone.left
    moving = [n for n in names(pp.solve(scene, edge + steps * np.spacing(edge))) if n != "SEPARATE"]
    assert moving == ["STICK"]


@given(scenes(length=lengths, effects=one_effect), st.booleans(), st.floats(-15.5, -6))
def test_pushing_next_to_a_cone_edge_has_one_solution(scene, right, exponent):
    cone = pp.motion_cone(scene)
    edge = cone.right if right else cone.left
    assume(1e-3 < edge < np.pi - 1e-3)
    for side in (-1, 1):
        assert len(pp.solve(scene, edge + side * 10.0**exponent)) == 1


@given(scenes(effects=both), magnitudes, st.booleans())
def test_slip_that_vanishes_is_a_stick(scene, magnitude, right):
    """With both effects: the pusher moves exactly as the contact does under an edge force."""
    cone = pp.friction_cone(scene)
    phi = cone.right if right else cone.left
    weight, inertia = scene.effects
    share = magnitude / (1 + magnitude)
    k = pp.spin_ratio(scene, phi, share)
    length, psi = scene.slider.rod_length, scene.slider.rod_angle
    speed = magnitude * weight.weight / inertia.mass
    pusher = speed * np.array(
        [np.cos(phi) + k * length * np.sin(psi), np.sin(phi) - k * length * np.cos(psi)]
    )
    assume(abs(pusher[1]) > 1e-3 * np.hypot(*pusher))
    found = pp.solve(scene, np.arctan2(*pusher[::-1]), np.hypot(*pusher))
    near = [s for s in found if np.allclose(s.contact_motion, pusher, rtol=0, atol=1e-9 * speed)]
    assert names(pp.Solutions(tuple(near))) == ["STICK"]
