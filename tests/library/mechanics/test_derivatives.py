"""Derivatives of solutions: literal and symmetric scenes, pivots, changes of mode, central differences."""

from __future__ import annotations

import math
from dataclasses import fields, replace

import numpy as np
import pytest
import xarray as xr
from mechanics.builders import BOTH, FRICTION, INERTIA, INFINITE, make_scene
from mechanics.checked import TABLE, UPRIGHT, scene_of
from mechanics.differences import (
    KINDS,
    SQUARE,
    THIRDS,
    Problem,
    assert_same,
    points,
    polygon,
    random_problem,
    values_of,
)

import planar_pushing as pp

BOX = pp.Polygon(SQUARE)


def friction_on(make_support):
    """Effects of one support, whose strength is its weight."""

    def make(strengths, feet, turn):
        return (pp.SupportFriction(support=make_support(feet, turn), weight=strengths[0]),)

    return make


def table(places, loads, motion, contact, mu):
    """A push of a slider on feet, whose weight is that of the feet unless it is changed itself."""

    def make(strengths, feet, turn):
        weight = strengths[0] / sum(loads) * sum(feet)
        return (pp.SupportFriction(support=points(places, feet, turn), weight=weight),)

    return Problem(
        motion=motion, contact=contact, mu=mu, strengths=(sum(loads),), feet=tuple(loads), make=make
    )


# Literal values


def test_a_square_that_sticks_has_the_published_derivatives():
    problem = Problem(
        motion=(0.3, 1.0), contact=(0.5, -1.0), mu=1.0, strengths=(1.0,), feet=(),
        make=friction_on(lambda _, turn: polygon(SQUARE, turn)),
    )  # fmt: skip
    (stick,) = problem.solutions
    by = stick.derivatives
    assert by.status is pp.Smoothness.SMOOTH
    assert stick.twist[2] == pytest.approx(0.490713050, abs=1e-9)
    assert by.twist_by_motion[2] == pytest.approx([0.5479494, 0.3263282], abs=1e-7)
    assert by.force_by_motion == pytest.approx(
        np.array([[0.5173383, -0.1552015], [-0.1552015, 0.0465605]]), abs=1e-7
    )
    assert by.twist_by_strength == pytest.approx(np.zeros((3, 1)), abs=1e-15)
    assert by.force_by_strength[:, 0] == pytest.approx(stick.force, rel=1e-12)


def test_a_table_that_is_pushed_in_its_middle():
    """By hand: four equal feet, in translation each foot resists motions across by its load."""
    (stick,) = pp.solve(scene_of(TABLE, 1.0, UPRIGHT, pp.Coulomb(0.5)), UPRIGHT, derivatives=True)
    by = stick.derivatives
    assert by.twist_by_motion == pytest.approx(np.array([[0.5, 0], [0, 1], [0.5, 0]]), abs=1e-11)
    assert by.force_by_motion == pytest.approx(np.array([[0.5, 0], [0, 0]]), abs=1e-11)
    assert by.twist_by_point == pytest.approx(np.array([[-0.5, 0], [0, 0], [0.5, 0]]), abs=1e-11)
    # Feet in the body frame, x along the rod: two on the left, two on the right of the push.
    left = np.array([1, 1, -1, -1])
    expected = np.array([-left / 2, 0 * left, left / 2])
    assert by.twist_by_foot == pytest.approx(expected, abs=1e-11)
    assert by.force_by_foot == pytest.approx(np.array([-left / 2, left * left]), abs=1e-11)


@pytest.mark.parametrize("support", [BOX, pp.Ring(1.0), TABLE, pp.Disc(1.0)], ids=str)
@pytest.mark.parametrize("masses", [(), (pp.Inertia(gyration_radius=0.7),)], ids=["", "inertia"])
def test_a_symmetric_slider_that_is_pushed_in_its_middle(support, masses):
    """It mirrors itself in the normal: what is along the fence and what is across it do not mix."""
    scene = scene_of(support, 1.0, UPRIGHT, pp.Coulomb(0.5), *masses)
    (stick,) = pp.solve(scene, UPRIGHT, derivatives=True)
    by = stick.derivatives
    assert by.status is pp.Smoothness.SMOOTH
    for each, odd in (
        (by.twist_by_motion, [[0, 1], [1, 0], [0, 1]]),
        (by.force_by_motion, [[0, 1], [1, 0]]),
    ):
        assert each[np.array(odd) == 1] == pytest.approx(0, abs=1e-11)
    assert np.all(by.force_by_motion[0, 0] > 0.1)
    assert by.twist_by_motion[1, 1] == pytest.approx(1)


@pytest.mark.parametrize("support", [BOX, pp.Ring(1.0), TABLE], ids=str)
@pytest.mark.parametrize("masses", [(), INERTIA], ids=["friction", "inertia"])
@pytest.mark.parametrize("angle", [0.0, math.pi])
def test_a_symmetric_slider_pushed_along_the_fence_is_at_a_change_of_mode(support, masses, angle):
    """The stick is an end of a continuum, and the fence grazes where the slider separates."""
    found = pp.solve(scene_of(support, 1.0, UPRIGHT, INFINITE, *masses), angle, derivatives=True)
    assert [each.mode.name for each in found] == ["SEPARATE", "STICK"]
    for each in found:
        assert each.derivatives.status is pp.Smoothness.CHANGE
        assert np.isnan(values_of(each.derivatives)).all()


@pytest.mark.parametrize("effects", [FRICTION, INERTIA], ids=["friction", "inertia"])
def test_motions_of_one_degree_grow_with_the_pusher(effects):
    """Euler's theorem: twists are in proportion to the motion; forces are too, or constant."""
    angles = np.linspace(-3.0, 3.0, 40)
    found = pp.solve(make_scene(2.0, 2.0, effects), angles, 1.7, derivatives=True)
    motion = 1.7 * np.stack([np.cos(angles), np.sin(angles)], -1)[:, None, :, None]
    by, here = found.derivatives, found.consistent
    twist, force = (
        (each @ motion)[..., 0][here] for each in (by.twist_by_motion, by.force_by_motion)
    )
    assert twist == pytest.approx(found.twist[here], abs=1e-13)
    assert force == pytest.approx(found.force[here] * (effects is INERTIA), abs=1e-13)
    assert np.all(by.status[here] == pp.Smoothness.SMOOTH)
    assert np.all(by.status[~here] == pp.Smoothness.NONE)
    assert np.isnan(by.twist_by_motion[~here]).all()


@pytest.mark.parametrize("effects", [FRICTION, INERTIA, BOTH], ids=["friction", "inertia", "both"])
def test_a_sticking_force_is_a_gradient(effects):
    (stick,) = pp.solve(make_scene(2.0, 2.0, effects), 1.9, 1.3, derivatives=True)
    matrix = stick.derivatives.force_by_motion
    assert matrix[0, 1] == pytest.approx(matrix[1, 0], rel=1e-12)
    assert np.linalg.eigvalsh(matrix).min() >= -1e-14


# Contact friction


def test_mu_changes_slips_alone():
    scene = make_scene(0.5, 0.3)
    stick, slip = (pp.solve(scene, a, derivatives=True)[0] for a in (math.pi / 2, 0.3))
    assert (stick.mode, slip.mode) == (pp.ContactMode.STICK, pp.ContactMode.SLIP_LEFT)
    assert not stick.derivatives.twist_by_mu.any()
    assert not stick.derivatives.force_by_mu.any()
    by, force = slip.derivatives, slip.force
    # f_x = mu f_y holds on the edge.
    change = by.force_by_mu[0] - 0.3 * by.force_by_mu[1]
    assert change == pytest.approx(force[1], rel=1e-12)
    assert not by.twist_by_motion[:, 0].any()


def test_infinite_friction_is_the_limit_of_large_mu():
    """A slip under infinite friction depends on no coefficient; towards it the rate falls like 1/mu^2."""
    angle = np.deg2rad(-20)
    (*_, exact) = pp.solve(make_scene(2.0), angle, derivatives=True)
    (*_, near) = pp.solve(make_scene(2.0, 1e6), angle, derivatives=True)
    (*_, mild) = pp.solve(make_scene(2.0, 1e3), angle, derivatives=True)
    assert exact.mode == near.mode == pp.ContactMode.SLIP_LEFT
    assert not exact.derivatives.twist_by_mu.any()
    assert not exact.derivatives.force_by_mu.any()
    assert near.derivatives.twist_by_motion == pytest.approx(
        exact.derivatives.twist_by_motion, abs=1e-4
    )
    ratio = mild.derivatives.twist_by_mu / near.derivatives.twist_by_mu
    assert ratio == pytest.approx(1e6, rel=0.05)


def test_a_frictionless_contact_slips_and_has_a_derivative_by_mu():
    """Four feet by hand: under the normal force the slider translates, mu turns it."""
    scene = scene_of(TABLE, 1.0, UPRIGHT, pp.Coulomb(0.0))
    (slip,) = pp.solve(scene, math.pi / 3, derivatives=True)
    speed = math.sin(math.pi / 3)
    assert slip.derivatives.twist_by_mu == pytest.approx([speed, 0, speed], abs=1e-11)
    assert slip.derivatives.force_by_mu == pytest.approx([1, 0], abs=1e-11)
    (stick,) = pp.solve(scene, UPRIGHT, derivatives=True)
    assert np.isnan(values_of(stick.derivatives)).all()


def test_a_perfectly_rough_contact_is_smooth_where_it_pulls():
    scene = make_scene(2.0, pp.PerfectlyRough())
    for angle in (-2.0, -0.5, 0.01, 3.0):
        *_, stick = pp.solve(scene, angle, derivatives=True)
        assert stick.mode is pp.ContactMode.STICK
        assert stick.derivatives.status is pp.Smoothness.SMOOTH


# Changes of mode


@pytest.mark.parametrize("support", [BOX, pp.Ring(1.0)], ids=str)
@pytest.mark.parametrize("side", ["right", "left"])
def test_a_stick_on_an_edge_of_the_cone_is_at_a_change_of_mode(support, side):
    scene = scene_of(support, 2.0, math.pi / 4, pp.Coulomb(0.4))
    edge, sign = getattr(pp.motion_cone(scene), side), 1 if side == "right" else -1
    (found,) = pp.solve(scene, edge, derivatives=True)
    assert found.mode is pp.ContactMode.STICK
    assert found.derivatives.status is pp.Smoothness.CHANGE
    assert np.isnan(values_of(found.derivatives)).all()
    for beside in (1e-9, -1e-9):
        (found,) = pp.solve(scene, edge + sign * beside, derivatives=True)
        assert (found.mode is pp.ContactMode.STICK) == (beside > 0)
        assert found.derivatives.status is pp.Smoothness.SMOOTH


def test_a_grazing_pusher_and_one_at_rest_are_at_a_change_of_mode():
    scene = make_scene(0.5, 0.5)
    for angle, size in ((0.0, 1.0), (math.pi, 1.0), (1.0, 0.0)):
        separate = pp.solve(scene, angle, size, derivatives=True)[0]
        assert separate.mode is pp.ContactMode.SEPARATE
        assert np.isnan(values_of(separate.derivatives)).all()


def test_a_slider_left_behind_does_not_change():
    (separate,) = pp.solve(make_scene(0.5, 0.5, BOTH), -1.0, derivatives=True)
    by = separate.derivatives
    assert by.status is pp.Smoothness.SMOOTH
    assert not values_of(by).any()


# Pivots


def test_a_pivot_that_slips_turns_with_the_pusher_alone():
    """Three feet about one of which the slider turns while it slips: its share takes up all changes.

    By hand: u_y = -omega r_x with r from the contact to the foot, so that omega is in proportion to u_y,
    does not depend on mu and loads, and takes the contact's shift along the fence by its lever alone.
    """
    problem = table(THIRDS, (9.0, 1.0, 1.0), (1.0, 0.6), (0.1, -1.0), 0.1)
    (slip,) = problem.solutions
    by, omega = slip.derivatives, slip.twist[2]
    assert (slip.mode, slip.pivot) == (pp.ContactMode.SLIP_LEFT, 0)
    assert by.status is pp.Smoothness.PIVOT
    lever = 1.0 - 0.1
    assert omega == pytest.approx(-0.6 / lever)
    assert by.twist_by_motion == pytest.approx(np.outer(slip.twist, [0, 1 / 0.6]), abs=1e-13)
    assert by.twist_by_point == pytest.approx(np.outer(slip.twist, [1 / lever, 0]), abs=1e-13)
    for name in ("mu", "strength", "foot"):
        assert not getattr(by, f"twist_by_{name}").any()
    assert not by.force_by_foot[:, 0].any()
    assert np.all(by.force_by_foot[1, 1:] > 0.01)
    assert abs(by.force_by_mu[1]) > 0.01
    assert not by.force_by_motion.any()
    assert_same(problem, slip)


def test_a_pivot_that_sticks_leaves_the_force_open():
    """The contact moves across its line to foot 0; along this line the foot would slide either way."""
    scene = scene_of(pp.Points(THIRDS, [1, 1, 1]), 1.5, UPRIGHT, pp.PerfectlyRough())
    *_, stick = pp.solve(scene, 0.0, derivatives=True)
    by = stick.derivatives
    assert (stick.mode, stick.pivot) == (pp.ContactMode.STICK, 0)
    assert by.status is pp.Smoothness.OPEN
    assert by.twist_by_motion[:, 0] == pytest.approx(stick.twist)
    assert by.twist_by_point[:, 1] == pytest.approx(stick.twist / 2.5)
    assert np.isnan(by.twist_by_motion[:, 1]).all()
    assert np.isnan(by.twist_by_point[:, 0]).all()
    assert not by.twist_by_foot.any()
    assert not by.twist_by_mu.any()
    assert all(
        np.isnan(getattr(by, each.name)).all() for each in fields(by) if "force" in each.name
    )


def test_a_sticking_pivot_has_different_slopes_to_either_side():
    """The slopes of the rotation by the motion along the line to the foot: this is why it is NaN."""
    scene = scene_of(pp.Points(THIRDS, [1, 1, 1]), 1.5, UPRIGHT, pp.PerfectlyRough())
    here, ahead, back = (pp.solve(scene, a).solutions[-1].twist[2] for a in (0.0, 1e-5, -1e-5))
    assert (ahead - here) / 1e-5 == pytest.approx(-(back - here) / -1e-5, rel=1e-3)
    assert abs(ahead - here) > 1e-6


# Differences


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("seed", range(4))
def test_derivatives_are_limits_of_differences(kind, seed):
    _assert_limits(random_problem(np.random.default_rng(seed), kind))


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_derivatives_of_a_thousand_scenes_are_limits_of_differences(kind):
    rng = np.random.default_rng(33)
    statuses = set().union(*(_assert_limits(random_problem(rng, kind)) for _ in range(84)))
    assert pp.Smoothness.SMOOTH in statuses
    assert (pp.Smoothness.PIVOT in statuses) == ("points" in kind)


def _assert_limits(problem):
    found = problem.solutions
    for each in found:
        assert each.derivatives.status in (pp.Smoothness.SMOOTH, pp.Smoothness.PIVOT)
        assert np.isfinite(values_of(each.derivatives)).all()
        assert_same(problem, each)
    return {each.derivatives.status for each in found}


@pytest.mark.parametrize("kind", ["polygon", "points", "points+inertia"])
@pytest.mark.parametrize("off", [0.1, 3e-3, 5e-4, 1e-6, 0.0])
def test_derivatives_of_pushes_that_nearly_translate(kind, off):
    """The force of a translation is through the center of pressure; pushes beside it turn slowly."""
    problem = random_problem(np.random.default_rng(5), kind)
    problem = replace(problem, mu=None, law=pp.PerfectlyRough(), contact=(0.3, -1.0))
    friction = problem.scene.friction[0]
    arm = np.array(_center_of_pressure(problem, friction)) - problem.contact
    x, y = pp.motion_of_force(
        problem.scene, np.arctan2(arm[1], arm[0]), problem.ratio
    ).contact_motion
    angle = np.arctan2(y, x) + off
    problem = replace(problem, motion=(np.cos(angle), np.sin(angle)))
    stick = problem.solutions[-1]
    assert stick.derivatives.status is pp.Smoothness.SMOOTH
    assert_same(problem, stick)


def _center_of_pressure(problem, friction):
    """The center of pressure along the fence."""
    psi = problem.scene.slider.rod_angle
    x, y = friction.support.center_of_pressure
    return x * np.cos(psi) - y * np.sin(psi), x * np.sin(psi) + y * np.cos(psi)


def test_a_slider_that_a_load_carries_away_changes_with_mass_and_load():
    """A separate slider that slides down a tilted table: its acceleration is the free one."""

    def make(strengths, feet, turn):
        center = tuple(turn @ [0.2, 0.1])
        return (
            pp.RingFriction(weight=strengths[0]),
            pp.Inertia(mass=strengths[1], gyration_radius=0.7, center=center),
            pp.Load(
                force=(0.3 * strengths[2], 2.0 * strengths[2]), center=tuple(turn @ [0.4, 0.1])
            ),
        )

    problem = Problem(
        motion=(0.5, 0.1),
        contact=(0.2, -1.0),
        mu=0.4,
        strengths=(1.0, 0.8, 1.0),
        feet=(),
        make=make,
    )
    (separate,) = problem.solutions
    assert separate.mode is pp.ContactMode.SEPARATE
    assert np.abs(separate.derivatives.twist_by_strength).min() > 0.01
    assert separate.derivatives.twist_by_motion == pytest.approx(np.zeros((3, 2)), abs=1e-14)
    assert_same(problem, separate)


# Arrays, orders and refusals


def test_derivatives_of_arrays_are_those_of_each_number():
    feet = np.array([pp.Points(THIRDS, [1, 2, 3]), pp.Points(SQUARE, [1, 2, 3, 4])], dtype=object)
    mu, angles = np.array([0.2, 2.0])[:, None, None], np.array([-0.5, 0.2, 1.5])[:, None]
    scene = pp.Scene(
        slider=pp.Slider(rod_length=1.3, rod_angle=0.9, radius=1.1), contact=pp.Coulomb(mu),
        effects=(pp.Inertia(center=(0.1, 0.2)), pp.SupportFriction(support=feet, weight=2.0)),
    )  # fmt: skip
    found = pp.solve(scene, angles, derivatives=True)
    assert found.derivatives.twist_by_strength.shape == (2, 3, 2, 8, 3, 2)
    assert found.derivatives.twist_by_foot.shape == (2, 3, 2, 8, 3, 4)
    for i, j, k in np.ndindex(2, 3, 2):
        one = pp.Scene(
            slider=scene.slider, contact=pp.Coulomb(mu[i, 0, 0]),
            effects=(scene.effects[0], replace(scene.effects[1], support=feet[k])),
        )  # fmt: skip
        for number, each in enumerate(pp.solve(one, angles[j, 0], derivatives=True)):
            by, count = found.derivatives[i, j, k, number], len(feet[k].weights)
            assert np.isnan(by.twist_by_foot[:, count:]).all()
            assert by.twist_by_foot[:, :count].tolist() == each.derivatives.twist_by_foot.tolist()
            assert by.twist_by_strength.tolist() == each.derivatives.twist_by_strength.tolist()
            assert by.force_by_motion.tolist() == each.derivatives.force_by_motion.tolist()
            assert by.status is each.derivatives.status


def test_strengths_are_in_the_order_of_the_scene_and_absent_effects_change_nothing():
    film = pp.Viscous(support=BOX, coefficient=0.5)
    listed = (film, pp.Inertia(), pp.RingFriction(weight=2.0))
    results = []
    for effects in (listed, listed[::-1]):
        scene = replace(make_scene(2.0, 2.0), effects=effects)
        (each,) = pp.solve(scene, 1.9, derivatives=True)
        results.append(each.derivatives)
    assert not results[0].twist_by_strength[:, 0].any()
    assert results[0].twist_by_strength[:, 1:].any(axis=0).all()
    assert results[0].twist_by_strength.tolist() == results[1].twist_by_strength[:, ::-1].tolist()


@pytest.mark.parametrize(("length", "force", "size"), [(1e-3, 1e4, 1e-2), (200.0, 1e-5, 1e3)])
def test_derivatives_have_the_units_of_their_parts(length, force, size):
    """The same push in other units of length, force and motion."""

    def solved(length, force, size):
        x, y = np.array([0.1, 0.2]) * length
        effects = (
            pp.SupportFriction(
                support=pp.Points(np.multiply(THIRDS, length), [1, 2, 3]), weight=force
            ),
            pp.Inertia(mass=0.7 * force / size, gyration_radius=0.4 * length, center=(x, y)),
        )
        slider = pp.Slider(rod_length=1.3 * length, rod_angle=0.8)
        return pp.solve(
            pp.Scene(slider=slider, contact=pp.Coulomb(0.4), effects=effects),
            0.4,
            size,
            derivatives=True,
        )[0]

    one, other = solved(1.0, 1.0, 1.0).derivatives, solved(length, force, size).derivatives
    twist, mass = np.array([size, size, size / length])[:, None], force / size
    for name, unit in (
        ("motion", size),
        ("point", length),
        ("strength", [force, mass]),
        ("foot", force),
    ):
        own, scaled = (getattr(by, f"twist_by_{name}") for by in (one, other))
        assert scaled * unit / twist == pytest.approx(own, rel=1e-9, abs=1e-12)
        own, scaled = (getattr(by, f"force_by_{name}") for by in (one, other))
        assert scaled * unit / force == pytest.approx(own, rel=1e-9, abs=1e-12)


def test_without_the_option_there_are_none_and_solutions_with_them_are_equal():
    scene = make_scene(2.0, 2.0)
    assert pp.solve(scene, 1.0)[0].derivatives is None
    assert pp.solve(scene, [1.0]).derivatives is None
    one, other = (pp.solve(scene, [-0.2, 1.0], derivatives=True) for _ in range(2))
    assert one == other
    assert one.derivatives == other.derivatives
    assert one.derivatives[1] != other.derivatives[0]
    assert pp.solve(scene, 1.0, derivatives=True)[0] == pp.solve(scene, 1.0, derivatives=True)[0]


def test_derivatives_of_labeled_problems_are_refused():
    angles = xr.DataArray([0.1, 0.2], dims="angle")
    with pytest.raises(
        pp.InvalidValue, match="False if an argument is a DataArray; give numpy arrays"
    ):
        pp.solve(make_scene(2.0, 2.0), angles, derivatives=True)
