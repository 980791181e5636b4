"""Invariants of the contact modes, and an independent scan for slipping solutions."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.special import ellipe, ellipkm1, hyp2f1

import planar_pushing as pp
from properties.strategies import (
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
from unit.builders import make_scene, names

FEW = settings(max_examples=30)


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


# --- Every solution satisfies the conditions of its mode -----------------------------------------


def check_balance(scene, solution):
    """Eqs. (1)-(10): the effects' wrench is the pusher's, its torque from the moment arm."""
    slider = scene.slider
    wrench = np.zeros(3)
    for effect in scene.effects:
        scaled = solution.twist * np.array([1, 1, slider.radius])
        wrench += effect.scaled(slider.radius).wrench(scaled) * np.array([1, 1, slider.radius])
    size = np.hypot(*wrench[:2]) + 1e-300
    assert solution.force == pytest.approx(wrench[:2], abs=1e-13 * size)
    fx, fy = solution.force
    torque = slider.rod_length * (fx * np.sin(slider.rod_angle) - fy * np.cos(slider.rod_angle))
    assert wrench[2] == pytest.approx(torque, abs=1e-12 * size * (1 + slider.rod_length))


def check_kinematics(scene, solution):
    length, psi = scene.slider.rod_length, scene.slider.rod_angle
    vx, vy, omega = solution.twist
    contact = [vx + omega * length * np.sin(psi), vy - omega * length * np.cos(psi)]
    scale = np.hypot(vx, vy) + abs(omega) * length
    assert solution.contact_motion == pytest.approx(contact, abs=1e-13 * scale)


def check_conditions(scene, solution, pusher):
    force, motion, size = solution.force, solution.contact_motion, np.hypot(*pusher)
    cone, phi = pp.friction_cone(scene), np.arctan2(*solution.force[::-1])
    if solution.mode is pp.ContactMode.SEPARATE:
        assert pusher[1] <= 0
        assert not np.any(force)
        assert not np.any(solution.twist)
        return
    assert np.hypot(*force) > 0
    if solution.mode is pp.ContactMode.STICK:
        assert motion == pytest.approx(pusher, abs=1e-12 * size)
        assert cone.contains(phi) or min(np.abs([phi - cone.right, phi - cone.left])) < 1e-10
        return
    right = solution.mode is pp.ContactMode.SLIP_RIGHT
    assert np.sin((phi - (cone.left if right else cone.right)) / 2) == pytest.approx(0, abs=1e-15)
    assert motion[1] == pytest.approx(pusher[1], rel=1e-9, abs=1e-12 * np.hypot(*motion))
    assert (motion[0] - pusher[0]) * (1 if right else -1) > 0
    assert force[0] * (motion[0] - pusher[0]) <= 1e-15 * size or scene_is_steep(scene)
    assert force @ motion >= -1e-13 * np.hypot(*force) * np.hypot(*motion)


def scene_is_steep(scene):
    """Both edges on one side of the normal do not occur: friction opposes the slip."""
    return scene.contact.force_angles.right > np.pi / 2


@given(scenes(length=lengths), pusher_angles, magnitudes)
def test_every_solution_satisfies_its_mode(scene, angle, magnitude):
    pusher = magnitude * np.array([np.cos(angle), np.sin(angle)])
    for solution in pp.solve(scene, angle, magnitude):
        check_balance(scene, solution)
        check_kinematics(scene, solution)
        check_conditions(scene, solution, pusher)


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
        assert a.spin_ratio == pytest.approx(b.spin_ratio, rel=1e-12)


@given(scenes(), pusher_angles, magnitudes, powers(-3, 3))
def test_modes_do_not_see_the_unit_of_length(scene, angle, magnitude, factor):
    assume(away_from_the_edges(scene, angle))
    slider = pp.Slider(
        rod_length=factor * scene.slider.rod_length,
        rod_angle=scene.slider.rod_angle,
        radius=factor,
    )
    effects = tuple(effect.scaled(1 / factor) for effect in scene.effects)
    larger = pp.Scene(slider=slider, contact=scene.contact, effects=effects)
    found, other = pp.solve(scene, angle, magnitude), pp.solve(larger, angle, magnitude)
    assert names(found) == names(other)
    for a, b in zip(found, other, strict=True):
        assert b.spin_ratio == pytest.approx(a.spin_ratio, rel=1e-7)
        assert b.contact_motion == pytest.approx(a.contact_motion, rel=1e-7, abs=1e-9 * magnitude)


# --- Completeness --------------------------------------------------------------------------------


def friction_profile(k):
    """f and t of Eqs. (2)-(3) for k > 0, straight from their elliptic forms."""
    inner = np.minimum(k, 1 / k)
    force = 2 / np.pi * ellipe(inner**2)
    rest = np.maximum((1 - inner) * (1 + inner), 1e-300)
    exact = 2 / np.pi * (ellipe(inner**2) - rest * ellipkm1(rest)) / inner
    torque = np.where(inner < 0.1, inner / 2 * hyp2f1(0.5, 0.5, 2, inner**2), exact)
    return np.where(k <= 1, force, torque), np.where(k <= 1, torque, force)


class Scan:
    """Motions under a force on one edge, by brute force over the magnitude of the motion."""

    def __init__(self, length, psi, phi, rho):
        self.s = np.logspace(-6, 6, 2001)  # m a / W
        arm = length * np.sin(psi - phi)
        low, high = np.full_like(self.s, 1e-7), np.full_like(self.s, 1e7)
        for _ in range(50):
            k = np.sqrt(low * high)
            force, torque = friction_profile(k)
            below = torque + self.s * rho**2 * k < abs(arm) * (force + self.s)
            low, high = np.where(below, k, low), np.where(below, high, k)
        k = np.sign(arm) * np.sqrt(low * high)
        self.across = self.s * (np.sin(phi) - k * length * np.cos(psi))
        self.along = self.s * (np.cos(phi) + k * length * np.sin(psi))

    def crossings(self, level):
        """Indices before which n . u crosses a level."""
        side = np.sign(self.across - level)
        return np.nonzero(side[1:] * side[:-1] < 0)[0]

    def is_clear_of(self, level):
        """Whether the level is neither an extremum's nor out of the scan's reach."""
        rise = np.sign(np.diff(self.across))
        extrema = self.across[1:-1][rise[1:] != rise[:-1]]
        settled = abs(self.across[-1]) > 100 * abs(level) > 1e4 * abs(self.across[0])
        return settled and np.all(np.abs(extrema - level) > 1e-3 * abs(level))


def slip_count(scene, pusher, mode):
    found = pp.solve(scene, np.arctan2(*pusher[::-1]), np.hypot(*pusher))
    return sum(each is mode for each in found.modes)


def check_against_scan(length, psi, mu, weight, mass, rho, rightward, index, offset):
    """Aim the pusher at a motion of the scan; every crossing of its level must be found."""
    effects = pp.RingFriction(weight=weight), pp.Inertia(mass=mass, gyration_radius=rho)
    scene = make_scene(length, mu, effects, psi)
    cone = pp.friction_cone(scene)
    phi = cone.left if rightward else cone.right
    scan = Scan(length, psi, phi, rho)
    level = (scan.across[index] + scan.across[index + 1]) / 2
    assume(scan.is_clear_of(level))
    along = scan.along[scan.crossings(level)]
    sign = 1 if rightward else -1
    limit = along[offset % along.size] - sign * 0.02 * (abs(along).max() + abs(level))
    expected = int(np.sum(sign * (along - limit) > 0))
    assume(np.abs(along - limit).min() > 0.01 * (abs(along).max() + abs(level)))
    mode = pp.ContactMode.SLIP_RIGHT if rightward else pp.ContactMode.SLIP_LEFT
    pusher = weight / mass * np.array([limit, level])
    assert slip_count(scene, pusher, mode) == expected
    return expected


@FEW
@given(
    powers(-0.5, 1), rod_angles, st.one_of(st.just(np.inf), powers(-1, 2)), powers(-1, 1),
    powers(-1, 1), powers(-0.7, 0.7), st.booleans(), st.integers(400, 1600), st.integers(0, 2),
)  # fmt: skip
def test_scan_finds_no_slip_that_solve_misses(
    length, psi, mu, weight, mass, rho, rightward, index, offset
):
    assume(abs(length * np.sin(psi - np.pi / 2)) > 1e-3)
    check_against_scan(length, psi, mu, weight, mass, rho, rightward, index, offset)


@FEW
@given(
    powers(-0.3, 1), st.floats(0.2, 1.3), st.floats(0.05, 0.9), st.floats(-0.8, 3), powers(-1, 1),
    powers(-1, 1), st.booleans(), st.integers(400, 1600), st.integers(0, 2),
)  # fmt: skip
def test_scan_finds_no_slip_that_solve_misses_where_the_normal_motion_turns(
    length, psi, lean, beyond, weight, mass, mirrored, index, offset
):
    """rho puts the inertia end and the friction end on two sides of n . u = 0 (Painleve)."""
    phi = lean * psi
    slow = pp.spin_ratio(make_scene(length, 1.0, psi=psi), phi)
    along_fence = np.sin(phi) / (length * np.cos(psi))
    fast = along_fence + beyond * (along_fence - slow)
    assume(0.02 < fast / slow < 50)
    assume(abs(fast / along_fence - 1) > 1e-2)
    assume(abs(slow / along_fence - 1) > 1e-2)
    rho = float(np.sqrt(length * np.sin(psi - phi) / fast))
    rod = np.pi - psi if mirrored else psi
    check_against_scan(length, rod, 1 / np.tan(phi), weight, mass, rho, mirrored, index, offset)


def test_scan_sees_the_two_slips_of_the_published_example():
    """l = 2, mu = 1.4: the oracle itself is no worse than the table."""
    scan = Scan(2.0, np.pi / 4, np.pi / 2 - np.arctan(1.4), 1.0)
    assert scan.across.min() == pytest.approx(-0.0400296, abs=1e-6)
    assert scan.crossings(-0.03).size == 2
    assert scan.crossings(0.01).size == 1


# --- Coincidence ---------------------------------------------------------------------------------


@given(scenes(length=lengths, effects=one_effect), st.booleans(), st.integers(-2, 2))
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
