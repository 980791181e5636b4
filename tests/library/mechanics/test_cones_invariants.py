"""Invariants of the map from force angles to motion angles, and of the cones."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from mechanics.builders import make_scene, scaled
from mechanics.strategies import (
    both,
    coefficients,
    effect_sets,
    force_angles,
    lengths,
    moderate_lengths,
    one_effect,
    rod_angles,
    scenes,
    share_of,
)

import planar_pushing as pp
from planar_pushing.mechanics.force.limit_curve import curve_of_unit_motions

RIGHT_ANGLE = np.pi / 2


def edges(cone):
    return np.array([cone.right, cone.left])


@given(scenes(length=lengths), force_angles, st.floats(1e-4, 3), st.floats(0, 1))
def test_motion_angle_increases_with_the_force_angle(scene, phi, gap, share):
    first, second = pp.motion_angle(scene, [phi, phi + gap], share_of(scene, share))
    assert first < second


@given(scenes(length=lengths), force_angles, st.floats(0, 1))
def test_pusher_does_no_negative_work(scene, phi, share):
    """f . u >= 0."""
    motion = pp.motion_angle(scene, phi, share_of(scene, share))
    assert abs(motion - phi) <= RIGHT_ANGLE + 1e-15


@given(scenes(length=lengths))
def test_motion_cone_is_within_90_degrees_of_the_friction_cone(scene):
    force, motion = edges(pp.friction_cone(scene)), edges(pp.motion_cone(scene))
    assert np.all(np.abs(motion - force) <= RIGHT_ANGLE)


@given(scenes(length=lengths, effects=one_effect), st.floats(0, 1))
def test_motion_cone_is_the_image_of_the_friction_cone(scene, part):
    force, motion = pp.friction_cone(scene), pp.motion_cone(scene)
    phi = force.right + part * force.span
    assert motion.right - 1e-12 <= pp.motion_angle(scene, phi) <= motion.left + 1e-12
    assert edges(motion) == pytest.approx(pp.motion_angle(scene, edges(force)), abs=1e-15)


@given(scenes(length=lengths, effects=both), st.floats(0, 1), st.floats(0, 1))
def test_motion_cone_of_both_effects_is_their_union(scene, part, share):
    force, motion = pp.friction_cone(scene), pp.motion_cone(scene)
    phi = force.right + part * force.span
    assert motion.right - 1e-12 <= pp.motion_angle(scene, phi, share) <= motion.left + 1e-12


@given(scenes(length=lengths, effects=both), force_angles)
def test_spin_ratio_runs_from_friction_to_inertia(scene, phi):
    ratios = np.abs(pp.spin_ratio(scene, phi, np.linspace(0, 1, 9)))
    steps = np.diff(ratios)
    slack = 1e-13 * ratios.max()
    assert np.all(steps >= -slack) or np.all(steps <= slack)


@given(moderate_lengths, coefficients, effect_sets, rod_angles)
def test_mirrored_scene_has_mirrored_cones(length, mu, effects, psi):
    """psi -> 180 - psi swaps right and left."""
    cone = pp.motion_cone(make_scene(length, mu, effects, psi))
    mirrored = pp.motion_cone(make_scene(length, mu, effects, np.pi - psi))
    assert edges(mirrored)[::-1] == pytest.approx(np.pi - edges(cone), abs=1e-12)


@given(lengths, rod_angles, force_angles, effect_sets)
def test_opposite_force_makes_the_opposite_motion(length, psi, phi, effects):
    scene = make_scene(length, 1.0, effects, psi)
    one, other = pp.motion_angle(scene, [phi, phi - np.pi], share_of(scene))
    # Rounding of psi - phi by an ulp is turned up to 2 l^2 times as far.
    assert other == pytest.approx(one - np.pi, abs=1e-14 * (1 + length**2))


@given(scenes(), force_angles, st.floats(-2, 2))
def test_motion_angles_depend_on_lengths_through_their_ratios(scene, phi, exponent):
    """Scaling with R."""
    factor = 10.0**exponent
    larger = pp.Scene(
        slider=pp.Slider(
            rod_length=factor * scene.slider.rod_length,
            rod_angle=scene.slider.rod_angle,
            radius=factor,
        ),
        contact=scene.contact,
        effects=tuple(scaled(effect, factor) for effect in scene.effects),
    )
    share = share_of(scene)
    expected = pp.motion_angle(scene, phi, share)
    assert pp.motion_angle(larger, phi, share) == pytest.approx(expected, abs=1e-12)
    assert edges(pp.motion_cone(larger)) == pytest.approx(edges(pp.motion_cone(scene)), abs=1e-12)
    assume(pp.spin_ratio(scene, phi, share) != 0)
    centers = [pp.motion_centers(each, phi, share) for each in (scene, larger)]
    assert centers[1] == pytest.approx(factor * centers[0], rel=1e-9, abs=1e-9 * factor)


@given(scenes(effects=one_effect), force_angles, st.floats(-2, 2))
def test_limit_curve_scales_with_weight_and_mass(scene, phi, exponent):
    factor = 10.0**exponent
    (effect,) = scene.effects
    if effect.degree == 1:
        heavier = pp.RingFriction(weight=factor * effect.weight)
    else:
        heavier = pp.Inertia(mass=factor * effect.mass, gyration_radius=effect.gyration_radius)
    other = pp.Scene(slider=scene.slider, contact=scene.contact, effects=(heavier,))
    curves = pp.limit_curve(scene, phi), pp.limit_curve(other, phi)
    assert curves[1].magnitude == pytest.approx(factor * curves[0].magnitude, rel=1e-13, abs=0)
    assert curves[1].motion_angle == pytest.approx(curves[0].motion_angle, abs=1e-14)


@given(scenes(), force_angles, force_angles)
def test_limit_curve_is_convex_with_the_motion_as_its_normal(scene, phi, other):
    """Every force on the curve lies behind the tangent through every other."""
    curve = curve_of_unit_motions(scene, np.array([phi, other]))
    at, elsewhere = curve.force
    assert (elsewhere - at) @ curve.contact_motion[0] <= 1e-13 * np.abs(curve.magnitude).max()


@given(moderate_lengths, effect_sets, rod_angles, st.floats(0, 50), st.floats(0, 50))
def test_larger_coefficient_has_the_larger_cone(length, effects, psi, one, other):
    small, large = (
        pp.motion_cone(make_scene(length, mu, effects, psi)) for mu in sorted((one, other))
    )
    assert large.right <= small.right + 1e-15
    assert small.left <= large.left + 1e-15


@given(scenes(length=lengths, contact=st.just(np.inf)))
def test_infinite_friction_cone_contains_the_contact_normal(scene):
    assert pp.motion_cone(scene).contains(RIGHT_ANGLE)


@given(scenes(length=lengths, contact=st.just(np.inf), effects=one_effect))
def test_infinite_friction_cone_spans_180_degrees(scene):
    slack = 1e-15 * (1 + scene.slider.rod_length**2)
    assert pp.motion_cone(scene).span == pytest.approx(np.pi, abs=slack)


@given(scenes(effects=one_effect))
def test_flags_agree_with_the_cone(scene):
    cone = pp.motion_cone(scene)
    assume(min(np.abs([cone.right, cone.left - np.pi])) > 1e-12)
    assert pp.can_pull(scene) == (cone.right < 0 or cone.left > np.pi)
    assert pp.slips_while_pushing(scene) == (cone.right > 0 or cone.left < np.pi)
