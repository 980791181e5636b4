"""The motion under a force and its derivatives: `solve`, literal pivots, central differences."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import xarray as xr
from mechanics.builders import BOTH, FRICTION, INERTIA, INFINITE, make_scene
from mechanics.checked import UPRIGHT, scene_of
from mechanics.differences import (
    KINDS,
    THIRDS,
    Problem,
    assert_differences,
    numbers,
    points,
    random_problem,
    values_of,
)

import planar_pushing as pp
from planar_pushing.mechanics.plane import direction

ANGLES = np.deg2rad([1.0, 40.0, 90.0, 91.0, 150.0, 200.0])


@pytest.mark.parametrize("effects", [FRICTION, INERTIA], ids=["friction", "inertia"])
def test_it_is_the_stick_of_a_unit_motion_in_its_direction(effects):
    scene = make_scene(2.0, pp.PerfectlyRough(), effects)
    found = pp.motion_of_force(scene, ANGLES)
    motion = pp.motion_angle(scene, ANGLES)
    assert np.hypot(*found.contact_motion.T) == pytest.approx(1.0, rel=1e-14)
    assert found.contact_motion == pytest.approx(direction(motion), abs=1e-13)
    sticks = [pp.solve(scene, angle).solutions[-1] for angle in motion]
    assert found.twist == pytest.approx(np.array([each.twist for each in sticks]), abs=1e-12)
    assert found.force == pytest.approx(np.array([each.force for each in sticks]), abs=1e-12)


def test_with_friction_and_inertia_the_force_has_its_magnitude():
    scene = replace(
        make_scene(2.0, pp.PerfectlyRough()), effects=(pp.RingFriction(weight=3.0), pp.Inertia())
    )
    found = pp.motion_of_force(scene, ANGLES, 2.0)
    assert found.force == pytest.approx(6.0 * direction(ANGLES), rel=1e-12)
    for i, (x, y) in enumerate(found.contact_motion):
        stick = pp.solve(scene, np.arctan2(y, x), np.hypot(x, y)).solutions[-1]
        assert stick.twist == pytest.approx(found.twist[i], rel=1e-11, abs=1e-12)
        assert stick.force == pytest.approx(found.force[i], rel=1e-11, abs=1e-12)


def test_friction_holds_a_small_force():
    found = pp.motion_of_force(make_scene(2.0, 2.0, BOTH), UPRIGHT, [0.1, 2.0], derivatives=True)
    assert found.status.tolist() == [pp.Status.NONE, pp.Status.CONSISTENT]
    assert np.isnan(found.twist[0]).all()
    assert found.derivatives.status.tolist() == [pp.Smoothness.NONE, pp.Smoothness.SMOOTH]
    assert np.isnan(values_of(found.derivatives[0])).all()
    assert pp.motion_of_force(make_scene(2.0, 2.0, BOTH), UPRIGHT, 0.1).status is pp.Status.NONE


# Pivots


def thirds_at(offset):
    """Three equal points that are pushed across the radius of the first, at an offset beyond the center."""
    return scene_of(pp.Points(THIRDS, [1, 1, 1]), offset, UPRIGHT, INFINITE)


@pytest.mark.parametrize("offset", [0.268, 0.5, 1.0, 2.0, 3.732])
def test_three_points_pivot_about_one(offset):
    """By hand: the slider turns about the foot at a distance 1 + offset, whatever the force and loads."""
    found = pp.motion_of_force(thirds_at(offset), 0.0, derivatives=True)
    by, omega = found.derivatives, 1 / (1 + offset)
    assert (found.status, found.pivot, by.status) == (pp.Status.PIVOTS, 0, pp.Smoothness.PIVOT)
    assert found.twist == pytest.approx([omega, 0, omega], abs=1e-14)
    assert found.contact_motion == pytest.approx([1, 0], abs=1e-14)
    for name in ("angle", "ratio", "strength", "foot"):
        assert not getattr(by, f"twist_by_{name}").any()
    # Nearer to the foot by a shift along y, the unit motion turns the slider faster.
    assert by.twist_by_point[:, 1] == pytest.approx(np.array([1, 0, 1]) * omega**2, abs=1e-14)
    assert by.force_by_foot[:, 0] == pytest.approx([0, 0], abs=1e-14)
    assert by.force_by_foot[0, 1:].min() > 0.1


@pytest.mark.parametrize(("offset", "change"), [(2 - 3**0.5, 1e-6), (2 + 3**0.5, -1e-6)])
def test_a_pivot_about_to_slide_is_at_a_change_of_mode(offset, change):
    here, inside, outside = (
        pp.motion_of_force(thirds_at(offset + by), 0.0, derivatives=True)
        for by in (0, change, -change)
    )
    assert here.derivatives.status is pp.Smoothness.CHANGE
    assert np.isnan(values_of(here.derivatives)).all()
    assert inside.derivatives.status is pp.Smoothness.PIVOT
    assert outside.derivatives.status is pp.Smoothness.SMOOTH
    assert outside.pivot == -1


def test_feet_on_one_line_leave_a_continuum():
    """By hand: any center between two feet, on their line, gives them the same forces, whose line meets the
    contact.
    """
    scene = scene_of(pp.Points([(0, 0.7), (2, 0.7)], [3, 1]), 1.0, UPRIGHT, INFINITE)
    found = pp.motion_of_force(scene, 0.0, derivatives=True)
    assert found.status is pp.Status.CONTINUUM
    assert found.force == pytest.approx([0.5, 0], abs=1e-14)
    assert found.derivatives.status is pp.Smoothness.CHANGE
    assert np.isnan(values_of(found.derivatives)).all()


# Differences


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("seed", range(3))
def test_derivatives_are_limits_of_differences(kind, seed):
    _assert_limits(random_problem(np.random.default_rng(seed), kind))


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_derivatives_of_a_thousand_scenes_are_limits_of_differences(kind):
    rng = np.random.default_rng(34)
    statuses = {_assert_limits(random_problem(rng, kind)) for _ in range(84)}
    assert pp.Smoothness.SMOOTH in statuses


def test_a_pivot_with_inertia_grows_with_the_force():
    def make(strengths, feet, turn):
        weight = strengths[0] / 12 * sum(feet)
        friction = pp.SupportFriction(support=points(THIRDS, feet, turn), weight=weight)
        return friction, pp.Inertia(mass=strengths[1], gyration_radius=0.8)

    problem = Problem(
        motion=(1.0, 0.0), contact=(0.0, -1.0), mu=1.0, strengths=(12.0, 0.2), feet=(10.0, 1.0, 1.0),
        make=make, angle=1.4, ratio=0.4,
    )  # fmt: skip
    found = problem.of_force
    assert found.derivatives.status is pp.Smoothness.PIVOT
    assert found.derivatives.twist_by_ratio.any()
    assert found.derivatives.twist_by_angle.any()
    _assert_limits(problem)


def _assert_limits(problem):
    found = problem.of_force
    names = "angle", "ratio", "contact", "strengths", "feet"
    if found.status != pp.Status.NONE:
        assert found.derivatives.status in (pp.Smoothness.SMOOTH, pp.Smoothness.PIVOT)
        assert_differences(
            problem, found.derivatives, names, lambda p: numbers(p.of_force), numbers(found)
        )
    return found.derivatives.status


# Arrays and refusals


def test_motions_of_arrays_are_those_of_each_number():
    feet = np.array(
        [pp.Points(THIRDS, [1, 2, 3]), pp.Points([(1, 0), (-1, 0)], [1, 1])], dtype=object
    )
    friction = pp.SupportFriction(support=feet, weight=np.array([[2.0], [3.0]]))
    slider = pp.Slider(rod_length=1.3, rod_angle=0.9, radius=1.1)
    scene = pp.Scene(slider=slider, contact=INFINITE, effects=(pp.Inertia(), friction))
    ratios = np.array([2.0, 3.0])[:, None, None]
    found = pp.motion_of_force(scene, 1.2, ratios, derivatives=True)
    assert found.twist.shape == (2, 2, 2, 3)
    assert found.derivatives.twist_by_foot.shape == (2, 2, 2, 3, 3)
    for i, j, k in np.ndindex(2, 2, 2):
        friction = pp.SupportFriction(support=feet[k], weight=[2.0, 3.0][j])
        one = replace(scene, effects=(pp.Inertia(), friction))
        each = pp.motion_of_force(one, 1.2, ratios[i, 0, 0], derivatives=True)
        assert found.twist[i, j, k].tolist() == each.twist.tolist()
        by, own = found.derivatives[i, j, k], each.derivatives
        assert by.twist_by_ratio.tolist() == own.twist_by_ratio.tolist()
        assert by.twist_by_strength.tolist() == own.twist_by_strength.tolist()
        count = own.twist_by_foot.shape[1]
        assert by.twist_by_foot[:, :count].tolist() == own.twist_by_foot.tolist()
        assert np.isnan(by.twist_by_foot[:, count:]).all()


def test_labeled_problems_give_a_dataset():
    angle = xr.DataArray(ANGLES, dims="force_angle", coords={"force_angle": ANGLES})
    found = pp.motion_of_force(make_scene(2.0), angle)
    assert found["twist"].dims == ("force_angle", "twist_component")
    assert (
        found["twist"].values.tolist() == pp.motion_of_force(make_scene(2.0), ANGLES).twist.tolist()
    )
    with pytest.raises(
        pp.InvalidValue, match="derivatives: True given; allowed: False if an argument"
    ):
        pp.motion_of_force(make_scene(2.0), angle, derivatives=True)


@pytest.mark.parametrize(
    ("effects", "ratio", "message"),
    [
        (FRICTION, 1.0, "1.0 given; allowed: None for a scene whose effects are of one kind"),
        (BOTH, None, "None given; allowed: a number > 0 for a scene with friction and inertia"),
        (BOTH, -1.0, "-1.0 given; allowed: a finite number > 0"),
    ],
)
def test_a_ratio_is_given_where_the_magnitude_is_open_and_only_there(effects, ratio, message):
    with pytest.raises(pp.InvalidValue) as raised:
        pp.motion_of_force(make_scene(2.0, 2.0, effects), 1.0, ratio)
    assert f"force_ratio: {message}" in str(raised.value)


def test_motions_are_equal_as_their_numbers_are():
    one, other = (pp.motion_of_force(make_scene(2.0), ANGLES, derivatives=True) for _ in range(2))
    assert one == other
    assert one != pp.motion_of_force(make_scene(2.0), ANGLES)
    assert pp.motion_of_force(make_scene(2.0), 1.0).derivatives is None
