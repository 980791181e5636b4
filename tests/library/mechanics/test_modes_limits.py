"""Reduced models join the full one, and the hard places of the parameter space."""

from __future__ import annotations

import numpy as np
import pytest
from mechanics.builders import (
    BOTH,
    DEFINITION_2,
    EFFECT_SETS,
    EVERY_EFFECT,
    FRICTION,
    INERTIA,
    PSI,
    make_scene,
    names,
    numbers,
)

import planar_pushing as pp

LAWS = [pp.Coulomb(0.0), pp.Coulomb(2.0), pp.InfiniteFriction(), DEFINITION_2, pp.PerfectlyRough()]
EVERY_LAW = pytest.mark.parametrize("law", LAWS, ids=str)
PHI = np.linspace(0, np.pi, 19)


@pytest.mark.parametrize("length", [0.1, 2.0, 50.0])
def test_share_0_is_friction_and_share_1_is_inertia(length):
    both = make_scene(length, effects=BOTH)
    for share, effects in ((0.0, FRICTION), (1.0, INERTIA)):
        pure = pp.motion_angle(make_scene(length, effects=effects), PHI)
        assert pp.motion_angle(both, PHI, share) == pytest.approx(pure, abs=1e-14)


@pytest.mark.parametrize("phi", [0.2, 2.5])
def test_share_joins_both_ends_linearly(phi):
    both = make_scene(2.0, effects=BOTH)
    for end, side in ((0.0, 1), (1.0, -1)):
        pure = pp.spin_ratio(both, phi, end)
        gaps = np.abs(pp.spin_ratio(both, phi, end + side * np.array([1e-4, 1e-5, 1e-6])) - pure)
        assert gaps[:-1] / gaps[1:] == pytest.approx(10, rel=1e-2)


@pytest.mark.parametrize("degrees", [-10.0, 20.0, 90.0, 130.0, 160.0, 179.0])
@pytest.mark.parametrize("length", [0.5, 2.0])
def test_slow_motion_solves_like_friction_and_fast_motion_like_inertia(length, degrees):
    """s -> 0 and s -> infinity: the same modes, and spin ratios that join like s and 1 / s."""
    angle = np.deg2rad(degrees)
    both = make_scene(length, 3.0, BOTH)
    for effects, magnitude in ((FRICTION, 1e-9), (INERTIA, 1e9)):
        pure = pp.solve(make_scene(length, 3.0, effects), angle, magnitude)
        full = pp.solve(both, angle, magnitude)
        assert names(full) == names(pure)
        for one, other in zip(full, pure, strict=True):
            assert one.spin_ratio == pytest.approx(other.spin_ratio, abs=1e-7)
            assert one.force == pytest.approx(other.force, rel=1e-7, abs=1e-7 * max(1, magnitude))


def test_solve_joins_friction_at_first_order_in_the_magnitude():
    both, friction = make_scene(2.0, 3.0, BOTH), make_scene(2.0, 3.0, FRICTION)
    for angle, mode in ((0.8, pp.ContactMode.STICK), (3.0, pp.ContactMode.SLIP_RIGHT)):
        (limit,) = pp.solve(friction, angle)
        assert limit.mode is mode
        found = [pp.solve(both, angle, magnitude) for magnitude in (1e-3, 1e-4, 1e-5)]
        gaps = np.abs([solutions.solutions[0].spin_ratio - limit.spin_ratio for solutions in found])
        assert gaps[:-1] / gaps[1:] == pytest.approx(10, rel=0.05)


@pytest.mark.parametrize("effects", [FRICTION, INERTIA, BOTH], ids=["friction", "inertia", "both"])
@pytest.mark.parametrize("length", [0.5, 2.0, 10.0])
def test_large_mu_converges_to_infinite_friction_like_1_over_mu(length, effects):
    limit = pp.motion_cone(make_scene(length, np.inf, effects))
    mu = np.array([1e3, 1e4, 1e5, 1e6])
    cones = [pp.motion_cone(make_scene(length, m, effects)) for m in mu]
    for gaps in ([c.right - limit.right for c in cones], [limit.left - c.left for c in cones]):
        assert np.all(np.array(gaps) > 0)
        rate = np.polyfit(np.log(mu), np.log(gaps), 1)[0]
        assert rate == pytest.approx(-1, abs=2e-3)


def test_greatest_coefficient_is_next_to_infinite_friction():
    """Beyond it the law is `InfiniteFriction`."""
    cone, limit = pp.motion_cone(make_scene(2.0, 1e9)), pp.motion_cone(make_scene(2.0))
    assert [cone.right, cone.left] == pytest.approx([limit.right, limit.left], abs=1e-8)
    assert pp.friction_cone(make_scene(2.0, 1e9)).right == pytest.approx(1e-9, rel=1e-15, abs=0)
    with pytest.raises(pp.InvalidValue, match="use the law of infinite friction"):
        pp.Coulomb(1e308)


@EVERY_EFFECT
@pytest.mark.parametrize("degrees", [10.0, 90.0, 170.0, -30.0])
def test_without_contact_friction_the_force_is_normal(effects, degrees):
    scene = make_scene(2.0, 0.0, effects)
    cone = pp.motion_cone(scene)
    assert pp.friction_cone(scene).span == 0
    if effects != BOTH:
        assert cone.span == 0
    for solution in pp.solve(scene, np.deg2rad(degrees)):
        if solution.mode is not pp.ContactMode.SEPARATE:
            assert abs(solution.force[0]) < 1e-15 * solution.force[1]


@EVERY_EFFECT
@EVERY_LAW
@pytest.mark.parametrize("angle", [0.0, 1.0, np.pi, -1.0])
def test_resting_pusher_leaves_the_slider_at_rest(effects, law, angle):
    solutions = pp.solve(make_scene(2.0, law, effects), angle, 0.0)
    assert names(solutions) == ["SEPARATE"]
    assert not np.any(numbers(solutions))


@EVERY_EFFECT
def test_without_a_rod_the_slider_translates_with_its_contact(effects):
    scene = make_scene(0.0, 1.0, effects)
    assert np.all(pp.spin_ratio(scene, PHI, 0.5 if effects == BOTH else None) == 0)
    cone = pp.motion_cone(scene)
    assert (cone.right, cone.left) == (pp.friction_cone(scene).right, pp.friction_cone(scene).left)
    (stick,) = pp.solve(scene, 1.2, 2.0)
    assert stick.twist == pytest.approx([2 * np.cos(1.2), 2 * np.sin(1.2), 0.0], rel=1e-15, abs=0)
    assert np.all(np.isinf(stick.center))
    (slip,) = pp.solve(scene, 0.3, 2.0)
    assert slip.mode is pp.ContactMode.SLIP_LEFT


@EVERY_EFFECT
@pytest.mark.parametrize("magnitude", [1e-3, 1.0, 1e3])
def test_short_rod_joins_no_rod(effects, magnitude):
    for degrees in (20.0, 45.0, 90.0, 150.0, -20.0):
        short, none = (
            pp.solve(make_scene(length, 1.0, effects), np.deg2rad(degrees), magnitude)
            for length in (1e-8, 0.0)
        )
        assert names(short) == names(none)
        scale = magnitude * np.array([1, 1, 1, 1, 1, 1, 1, 1 / magnitude])
        gap = np.abs(numbers(short) - numbers(none)) / np.maximum(scale, 1.0)
        assert gap.size == 0 or gap.max() < 5e-8


@EVERY_EFFECT
@pytest.mark.parametrize("length", [1e5, 1e6])
def test_long_rod_turns_its_motion_across_itself(effects, length):
    scene = make_scene(length, np.inf, effects)
    cone = pp.motion_cone(scene)
    assert [cone.right, cone.left] == pytest.approx([-PSI, np.pi - PSI], abs=3 / length)
    for degrees, found in ((100.0, ["STICK"]), (136.0, ["SLIP_RIGHT"])):
        for magnitude in (1e-3, 1.0, 1e3):
            solutions = pp.solve(scene, np.deg2rad(degrees), magnitude)
            assert names(solutions) == found
            (solution,) = solutions
            assert solution.contact_motion[1] == pytest.approx(
                magnitude * np.sin(np.deg2rad(degrees)), rel=1e-9
            )


@pytest.mark.parametrize("length", [1e-160, 1e-20])
def test_vanishing_rod_solves_like_no_rod(length):
    assert names(pp.solve(make_scene(length, 1.0), np.deg2rad(10))) == ["SLIP_LEFT"]


@EVERY_EFFECT
@pytest.mark.parametrize("length", [1e4, 1e6])
def test_long_rod_along_the_edge_of_the_friction_cone_slips_or_sticks(effects, length):
    """Every motion needs a force within 1 / l^2 of the rod, and so of the edge of mu = 1."""
    for degrees, mode in ((10.0, "SLIP_LEFT"), (40.0, "SLIP_LEFT"), (60.0, "STICK")):
        assert names(pp.solve(make_scene(length, 1.0, effects), np.deg2rad(degrees))) == [mode]


@EVERY_EFFECT
@pytest.mark.parametrize("psi", [1e-12, 1e-6, np.nextafter(np.pi, 0)])
@pytest.mark.parametrize("length", [0.5, 1e3])
def test_rod_almost_along_the_fence_solves(effects, psi, length):
    scene = make_scene(length, 1.0, effects, psi)
    for degrees in (-100.0, 10.0, 60.0, 170.0):
        solutions = pp.solve(scene, np.deg2rad(degrees))
        assert np.all(np.isfinite(numbers(solutions)))
        assert pp.ContactMode.SEPARATE in solutions.modes or degrees > 0


def test_rod_along_the_normal_is_symmetric():
    for effects in EFFECT_SETS.values():
        cone = pp.motion_cone(make_scene(2.0, 1.0, effects, np.pi / 2))
        assert cone.left - np.pi / 2 == pytest.approx(np.pi / 2 - cone.right, abs=1e-15)


@pytest.mark.parametrize("gyration_radius", [0.1, 0.3, 0.7, 1.0, 3.0])
@pytest.mark.parametrize("length", [0.5, 1.0, 5.0])
def test_conservative_bound_holds_or_is_refused(length, gyration_radius):
    """The seven cases of Sec. 4 are about a ring, rho = R; elsewhere they are no bound."""
    effects = [pp.RingFriction(), pp.Inertia(gyration_radius=gyration_radius)]
    scene = make_scene(length, effects=effects)
    try:
        bound = pp.conservative_motion_cone(scene)
    except pp.InvalidValue:
        assert gyration_radius != 1.0
        return
    exact = pp.motion_cone(scene)
    assert bound.right <= exact.right + 1e-12
    assert exact.left <= bound.left + 1e-12


@pytest.mark.parametrize("magnitude", [1e-100, 1e-12, 1e12, 1e100])
@EVERY_EFFECT
def test_pusher_magnitude_of_any_size(effects, magnitude):
    """With friction and inertia m a / W has a range."""
    if effects == BOTH and not 1e-12 <= magnitude <= 1e12:
        with pytest.raises(pp.InvalidValue, match="pusher_magnitude"):
            pp.solve(make_scene(2.0, np.inf, effects), 1.0, magnitude)
        return
    for degrees, mode in ((100.0, "STICK"), (179.0, "SLIP_RIGHT")):
        (solution,) = pp.solve(make_scene(2.0, np.inf, effects), np.deg2rad(degrees), magnitude)
        assert solution.mode.name == mode
        assert np.all(np.isfinite(numbers([solution])))


@pytest.mark.parametrize("excess", [1e-3, 1e-5, 1e-7])
def test_slow_slip_just_above_the_pulling_threshold(excess):
    """mu slightly above 1.26988: n . u is negative at small magnitudes only, and comes back to 0."""
    scene = make_scene(2.0, 1.2698754263747701 + excess, BOTH)
    friction = make_scene(2.0, 1.2698754263747701 + excess, FRICTION)
    edge = pp.motion_cone(friction).right
    # n . u = v (a v + edge) near rest, with a curvature of order one; well above the minimum.
    target = -1e-2 * edge**2
    pusher = np.array([10.0, target])
    found = names(pp.solve(scene, np.arctan2(*pusher[::-1]), np.hypot(*pusher)))
    assert found.count("SLIP_LEFT") == 2
