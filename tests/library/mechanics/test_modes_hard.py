"""Scenes that the sweep of random and adversarial inputs found, each with its right answer."""

from __future__ import annotations

import numpy as np
import pytest
from mechanics.builders import INFINITE, make_scene, names, numbers
from mechanics.checked import solved
from mechanics.problems import problem_of
from mechanics.slip_scan import slips_by_scan
from scipy.optimize import brentq, minimize_scalar

import planar_pushing as pp
from planar_pushing.mechanics.force.wrench import ring_profile


def scene(length, psi, law, *effects):
    return make_scene(length, law, effects, psi)


def inertia(gyration_radius, mass=1.0):
    return pp.Inertia(mass=mass, gyration_radius=gyration_radius)


def refused(name, call):
    with pytest.raises(pp.InvalidValue) as caught:
        call()
    assert caught.value.name == name


def test_sliders_that_cannot_be_are_refused():
    """They once took formulas to their limits: rods of 1e15 radii, masses within 1e-60 of the center."""
    rod = pp.Slider(rod_length=1985701788925619.8, rod_angle=1e-12)
    for effect in (pp.RingFriction(), pp.Inertia()):
        refused(
            "rod_length", lambda on=effect: pp.Scene(slider=rod, contact=INFINITE, effects=(on,))
        )
    refused("rod_length", lambda: pp.Slider(rod_length=1e213, rod_angle=1e-12, radius=1e155))
    for ratio in (9e-26, 5e-45, 2e64):
        refused("gyration_radius", lambda ratio=ratio: scene(1.0, 1.0, 1.0, inertia(ratio)))
    for mu in (5e241, 1.9e281):
        refused("friction_coefficient", lambda mu=mu: scene(1.0, np.pi / 2, mu, inertia(1.0)))


@pytest.mark.parametrize("push", [1e-12, 1e12])
def test_root_next_to_a_small_end_stays_in_its_bracket(push):
    """The spin ratios of friction and of inertia are up to 1e14 apart."""
    length, psi = 1e6, 1e-12
    rod = scene(length, psi, INFINITE, pp.RingFriction(), inertia(1e-4))
    (slip,) = pp.solve(rod, -3.1415926535897936, push)
    assert slip.mode is pp.ContactMode.SLIP_RIGHT
    friction = pp.spin_ratio(scene(length, psi, INFINITE, pp.RingFriction()), np.pi)
    dynamic = pp.spin_ratio(scene(length, psi, INFINITE, inertia(1e-4)), np.pi)
    assert abs(friction) <= abs(slip.spin_ratio) <= abs(dynamic)


def test_both_edges_of_a_cone_narrower_than_rounding_count_once():
    """The motion cone is narrower than an ulp: R = 1, rho = 1e-4, l = 1e6."""
    rod = scene(1e6, 1e-12, 1.0, inertia(1e-4))
    assert len(pp.solve(rod, np.pi / 2, 0.5)) == 1


def test_greatest_coefficient_sticks_like_infinite_friction():
    for law in (1e9, INFINITE):
        (found,) = pp.solve(scene(1.0, np.pi / 2, law, inertia(1e-4)), 1.0)
        assert found.mode is pp.ContactMode.STICK
        assert np.all(np.isfinite(numbers([found])))


def test_edge_of_infinite_friction_is_a_half_turn_to_a_long_rod():
    """Taken for the double next to pi, it would move the motion cone by 7e-11 and make this push slip."""
    rod = scene(755.0248268669369, 1e-300, INFINITE, pp.Inertia())
    assert pp.motion_cone(rod).left == np.pi
    assert names(pp.solve(rod, 3.1415926535897927)) == ["STICK"]


@pytest.mark.parametrize("tilt", [5e-324, 1e-300, 1e-45])
def test_an_upright_rod_keeps_a_push_that_hardly_leaves_the_fence(tilt):
    """The cosine of the double next to a quarter turn, 6e-17, would pass for the push and stick."""
    rod = scene(1e6, np.pi / 2, 1.0, pp.Inertia())
    assert names(pp.solve(rod, tilt)) == ["SLIP_LEFT"]


@pytest.mark.parametrize("gyration_radius", [1e-2, 1e-3, 1e-4])
def test_slip_whose_spin_ratio_is_a_small_part_of_its_range(gyration_radius):
    """From friction to inertia the spin ratio runs over eight decades; n . u turns in the first one."""
    effects = pp.RingFriction(), pp.Inertia(gyration_radius=gyration_radius)
    rod = scene(1.0, 0.8069, 1.0, *effects)
    assert names(pp.solve(rod, 0.05, 1e-6)) == ["SLIP_LEFT"]
    friction = pp.spin_ratio(scene(1.0, 0.8069, 1.0, pp.RingFriction()), np.pi / 4)
    assert next(iter(pp.solve(rod, 0.05, 1e-6))).spin_ratio == pytest.approx(friction, rel=1e-3)


FLAT = np.nextafter(np.pi, 0)
FLAT_RODS = [
    (68.76402567408803, 0.12539251088369704, -FLAT, 0.05, ["SEPARATE", "STICK", "SLIP_RIGHT"]),
    (62.700328085599466, None, -1.5e-323, 16.6, ["SEPARATE"]),
    (804.6215437331406, 0.2952638755453314, 0.0, 15.5, ["SEPARATE"]),
]


@pytest.mark.parametrize(("length", "gyration_radius", "pusher", "size", "modes"), FLAT_RODS)
def test_long_rod_along_the_fence(length, gyration_radius, pusher, size, modes):
    """Force and edge of the cone are an ulp apart, the directions of the pusher l^2 times as far."""
    inertia = [pp.Inertia(gyration_radius=gyration_radius)] if gyration_radius else []
    rod = scene(length, FLAT, INFINITE, pp.RingFriction(), *inertia)
    assert names(pp.solve(rod, pusher, size)) == modes


@pytest.mark.parametrize("length", [1e-2, 3e-3, 2.2e-3])
def test_slip_whose_normal_motion_has_a_plateau(length):
    """Between spin ratios of 1 and 1 / l friction has no more torque to give: n . u is even to rounding."""
    effects = pp.RingFriction(), pp.Inertia(gyration_radius=length**1.5)
    rod = scene(length, 1.8, 1.0, *effects)
    found = pp.solve(rod, np.pi - 1e-3)
    assert names(found) == ["SLIP_RIGHT"]
    friction = pp.spin_ratio(scene(length, 1.8, 1.0, pp.RingFriction()), 3 * np.pi / 4)
    (slip,) = found
    assert slip.spin_ratio == pytest.approx(friction, rel=0.1)


@pytest.mark.parametrize("beyond", [1e-9, 1e-6, 1e-3])
def test_long_rod_along_an_edge_of_the_friction_cone(beyond):
    """An ulp of the edge's angle moves the motion cone by l^2 ulp: stick and slip must take it for one."""
    rod = scene(1e6, np.nextafter(np.pi / 4, 1.0), 1.0, inertia(1e-3))
    edge = pp.motion_cone(rod).right
    assert edge < -0.7
    assert names(pp.solve(rod, edge - beyond)) == ["SEPARATE"]
    assert names(pp.solve(rod, edge + beyond)) == ["SEPARATE", "STICK", "SLIP_LEFT"]


@pytest.mark.parametrize("steepness", [1e-3, 1e-6, 1e-9])
def test_slip_next_to_friction_that_moves_along_the_fence(steepness):
    """The motion under friction leaves the fence by a small angle, under inertia it enters it."""
    length, psi = 2.0, 1.0
    leaves = brentq(
        lambda mu: pp.motion_cone(scene(length, psi, mu, pp.RingFriction())).right - steepness,
        0.1,
        3,
    )
    rod = scene(length, psi, leaves, pp.RingFriction(), pp.Inertia(gyration_radius=0.3))
    assert pp.motion_cone(rod).right < -0.1
    found = pp.solve(rod, steepness / 1000, steepness / 1000)
    assert names(found) == ["SLIP_LEFT"]


@pytest.mark.parametrize("length", 10.0 ** np.arange(-9, 7, 3))
@pytest.mark.parametrize("part", [1e-9, 1e-4, 1e4, 1e9])
def test_a_plateau_is_not_cut_at_its_rounding(length, part):
    """Friction's torque is even to rounding over many decades; each turn of n . u would be a branch."""
    ratio = np.clip(length * part, 1e-4, 1e4)
    rod = scene(length, 1.8, -1 / np.tan(2.5), pp.RingFriction(), inertia(ratio))
    for across in (1e-9, 1e-3, 1.0, 1e3):
        for along in (-1e4, 1e4):
            found = pp.solve(rod, np.arctan2(across, along), np.hypot(across, along))
            assert sum(mode > pp.ContactMode.STICK for mode in found.modes) <= 2


# Two slips under one edge: mu = 1.4, W = m = R = rho = 1, l = 2, psi = 45 degrees


def slip_under_the_right_edge(k):
    """Magnitude of the force, and motion of the contact, at a spin ratio, under both effects."""
    phi, rod = np.pi / 2 - np.arctan(1.4), np.array([np.sqrt(2), np.sqrt(2)])
    arm = rod[1] * np.cos(phi) - rod[0] * np.sin(phi)
    force, torque = ring_profile(k)
    acceleration = (torque - arm * force) / (arm - k)
    u = acceleration * np.array([np.cos(phi) + k * rod[1], np.sin(phi) - k * rod[0]])
    return force + acceleration, u


def normal_motion(k):
    return float(slip_under_the_right_edge(k)[1][1])


@pytest.mark.parametrize("part", [0.5, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10])
def test_two_slips_that_are_nearly_one(part):
    """The normal motion falls with the force to -0.0400296 and rises again: two slips or none."""
    lowest = minimize_scalar(normal_motion, bounds=(0.45, 0.5), method="bounded").x
    bottom = normal_motion(lowest)
    assert bottom == pytest.approx(-0.0400296, abs=1e-7)
    assert slip_under_the_right_edge(lowest)[0] == pytest.approx(1.40897, abs=1e-5)
    both = scene(2.0, np.pi / 4, 1.4, pp.RingFriction(), inertia(1.0))

    def push(normal):
        return pp.solve(both, np.arctan2(normal, 10.0), np.hypot(normal, 10.0))

    normal = (1.0 - part) * bottom
    found = push(normal)
    assert names(found) == ["SEPARATE", "SLIP_LEFT", "SLIP_LEFT"]
    ends = [
        brentq(lambda k: normal_motion(k) - normal, lowest, end, xtol=1e-16, rtol=1e-15)
        for end in (0.575, 0.41)
    ]
    for slip, k in zip(found[1:], ends, strict=True):
        # Near the bottom a rounding error of the normal motion moves the slips by its root.
        assert slip.spin_ratio == pytest.approx(k, abs=1e-14 / np.sqrt(part))
        assert slip.contact_motion[1] == pytest.approx(normal, rel=1e-15)
        size, motion = slip_under_the_right_edge(slip.spin_ratio)
        assert slip.contact_motion == pytest.approx(motion, abs=1e-14)
        assert np.hypot(*slip.force) == pytest.approx(size, rel=1e-14)
    assert names(push((1.0 + part) * bottom)) == ["SEPARATE"]


DISC = pp.Disc(0.4456, (-1.2778, 0.209))
#: Rod, coefficient, weight and mass of a slider, and a pull, which two slips answer along with separation.
CLOSE_SLIPS = {
    "ring": (9.89, 1.11, 0.82, pp.Ring(0.4456), 0.332, (0.709, 5.37, (-0.377, 0.305)), -0.00334, 30.0),
    "disc": (0.347, 1.23, 1.38, DISC, 0.115, (0.177, 0.947, (0.0928, 0.325)), -0.00127, 6.98),
    "heavy disc": (2.2, 0.712, 1.08, DISC, 9.52, (3.78, 0.338, (0.368, 0.129)), -0.00141, 8.15),
}  # fmt: skip


@pytest.mark.parametrize("pull", CLOSE_SLIPS.values(), ids=CLOSE_SLIPS)
def test_two_slips_between_which_friction_hardly_turns(pull):
    """The force leaves the cone and returns within a part of the search; a scan along the fence counts."""
    length, psi, mu, support, weight, (mass, radius, center), angle, size = pull
    effects = (
        pp.SupportFriction(support=support, weight=weight),
        pp.Inertia(mass=mass, gyration_radius=radius, center=center),
    )
    rod = scene(length, psi, mu, *effects)
    found, problem = solved(rod, angle, size), problem_of(rod, angle, size)
    assert names(found) == ["SEPARATE", "SLIP_LEFT", "SLIP_LEFT"]
    assert [slips_by_scan(problem, sense).item() for sense in (1, -1)] == [0, 2]
