"""Errors of pushes without an effect: closed forms, laws of similarity, and the logs of single runs."""

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.assessment.estimate import FACTOR, outline_circles, pose_change
from planar_pushing.terms.errors import InvalidFile
from pulling_by_pushing.study.catalog import DATASETS
from pulling_by_pushing.study.datasets import model_errors, model_estimates
from pulling_by_pushing.study.model import ModelErrors, ModelEstimates
from pulling_by_pushing.study.study_file import load_study

STUDY = load_study("workflow/config/smoke.yaml")
NAMES = ("model_errors", "model_estimates")


@pytest.fixture(scope="module")
def errors(results):
    return pp.open_dataset("model_errors", results)


@pytest.fixture(scope="module")
def estimates(results):
    return pp.open_dataset("model_estimates", results)


def changed(**values):
    """The pushes of the study with other values."""
    return ModelErrors.model_validate(STUDY.model_errors.model_dump() | values)


@pytest.mark.parametrize("name", NAMES)
def test_axes_variables_and_units_are_those_that_are_declared(results, name):
    dataset, entry = pp.open_dataset(name, results), DATASETS[name]
    assert set(dataset.dims) == set(entry.inner)
    assert tuple(dataset.data_vars) == entry.variables
    for key, variable in dataset.data_vars.items():
        assert variable.dims == tuple(dim for dim in entry.inner if dim in variable.dims), key
        assert np.isfinite(variable).all(), key
    assert {dataset[key].attrs["units"] for key in ("pose_error", "speed")} == {"m", "m s-1"}


def test_a_push_through_the_center_that_stops_coasts_on_its_friction(errors):
    """By v^2 / (2 mu_s g), on any support."""
    length = errors.speed**2 / (2 * 0.3 * 9.80665)
    expected = length.broadcast_like(errors.coasting_error)
    np.testing.assert_allclose(errors.coasting_error, expected, rtol=1e-10, atol=0)


@pytest.mark.parametrize("left_out", ["inertia", "friction"])
@pytest.mark.parametrize("support", ["base", "ring"])
def test_errors_are_those_between_the_logs_of_single_runs(errors, support, left_out):
    """With all runs at the same speed, and the outline of the scene."""
    shape = {"base": pp.Polygon.rectangle(0.3, 0.2), "ring": pp.Ring(0.06)}[support]
    friction = pp.SupportFriction(support=shape, weight=0.3 * 1.2 * 9.80665)
    inertia = pp.Inertia(mass=1.2, gyration_radius=np.hypot(0.3, 0.2) / np.sqrt(12))
    alone = {"inertia": (friction,), "friction": (inertia,)}[left_out]
    push, speed = STUDY.model_errors.pushes[1], 0.2
    velocity = speed * np.array([np.cos(angle := np.deg2rad(push.pusher_angle)), np.sin(angle)])
    pusher = pp.Pusher(velocity=tuple(velocity), shape="finger")
    scenes = [
        pp.scene_at((push.place, -0.1), effects=effects, contact=pp.Coulomb(0.5),
                    outline=pp.Polygon.rectangle(0.3, 0.2))
        for effects in ((friction, inertia), alone)
    ]  # fmt: skip
    logs = [
        pp.simulate(scene, pusher, duration=0.08 / speed, object_pose=(0, 0, 0)) for scene in scenes
    ]
    found = errors.pose_error.sel(support=support, left_out=left_out, speed=speed).isel(push=1)
    assert float(found) == pytest.approx(
        pose_change(*logs, outline_circles(scenes[0])), rel=1e-8, abs=0
    )


def test_errors_depend_on_the_stopping_length_over_the_way_alone(errors):
    """Twice the speed with four times the friction is the same motion, for any mass."""
    similar = changed(
        support_friction_coefficient=1.2,
        mass=5.0,
        speed=[0.1, 0.4],
        pushes=[{"place": 0.04, "pusher_angle": 90}],
    )
    found = model_errors.model_errors(similar).pose_error.isel(push=0)
    known = errors.pose_error.isel(push=0).sel(speed=[0.05, 0.2])
    np.testing.assert_allclose(found.transpose(*known.dims), known, rtol=1e-6, atol=0)


def test_inertia_matters_more_the_faster_and_friction_the_slower(errors):
    inertia, friction = (errors.pose_error.sel(left_out=each) for each in ("inertia", "friction"))
    assert (inertia.diff("speed") > 0).all()
    assert (friction.diff("speed") < 0).all()


def test_a_slow_run_with_inertia_needs_the_most_evaluations(errors):
    assert (errors.evaluations.sel(speed=0.05) > errors.evaluations.sel(speed=0.2)).all()
    assert (errors.evaluations > errors.evaluations_alone.sel(left_out="inertia")).all()


def test_the_readme_box_is_the_first_push(errors):
    base = errors.pose_error.sel(support="base", left_out="inertia").isel(push=0)
    found = [float(1e3 * base.sel(speed=speed)) for speed in (0.05, 0.2)]
    assert found == pytest.approx([0.756355, 9.627134], rel=1e-5)


def test_a_larger_error_than_the_factor_allows_is_in_no_random_push(estimates):
    assert (estimates.pose_error <= FACTOR * estimates.estimate).all()
    assert (estimates.estimate > 0).all()


def test_stopping_lengths_are_those_of_inertia(estimates):
    assert (estimates.stopping_length.sel(effect="inertia") > 0).all()
    assert (estimates.stopping_length.sel(effect=["viscous", "load"]) == 0).all()
    assert (estimates.estimate >= estimates.stopping_length).all()


def test_loads_and_viscous_friction_have_the_shares_that_are_drawn(estimates):
    """A load has its share throughout; it acts at the center, without a torque."""
    chooser = np.random.default_rng(STUDY.model_estimates.seed)
    pushes = [model_estimates.random_push(chooser) for _ in range(STUDY.model_estimates.pushes)]
    load = estimates.sel(effect="load")
    np.testing.assert_allclose(load.force_share, [push.load_share for push in pushes], rtol=1e-9)
    np.testing.assert_allclose(load.torque_share, 0.0, atol=1e-9)
    assert estimates.support.values.tolist() == [push.support for push in pushes]


def test_fewer_random_pushes_are_the_first_ones(estimates):
    few = model_estimates.model_estimates(ModelEstimates(pushes=2, seed=STUDY.model_estimates.seed))
    for name, variable in few.data_vars.items():
        np.testing.assert_array_equal(variable, estimates[name].isel(push=[0, 1]), err_msg=name)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("place: 0.04,", "place: 0.15,", "pushes at places within half the length, at angles"),
        ("pusher_angle: 90}", "pusher_angle: 180}", "pushes at places within half the length, at"),
        ("length: 0.3", "length: 0", "model_errors.length: 0 given; allowed: a finite number > 0"),
        ("speed: [0.05,", "speed: [0.5,", "model_errors.speed: .*; allowed: a list of increasing"),
        ("{pushes: 12, seed: 1}", "{pushes: 0, seed: 1}", "model_estimates.pushes: 0 given; allowed: an"),
        ("  distance: 0.08\n", "", "model_errors.distance: missing"),
    ],
)  # fmt: skip
def test_wrong_pushes_are_refused(study_text, tmp_path, old, new, said):
    assert old in study_text
    file = tmp_path / "config/wrong.yaml"
    file.write_text(study_text.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(InvalidFile, match=said):
        load_study(file)
