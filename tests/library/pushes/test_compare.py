"""Models of friction on simulated pushes, each half scored by fits to the other."""

from dataclasses import replace

import numpy as np
import pytest
from pushes.written import TRIANGLE, feet, small
from simulation.runs import pose_at_the_end

import planar_pushing as pp
from planar_pushing.pushes import halves as room
from planar_pushing.pushes.fit.fitted import fitted_ellipsoid
from planar_pushing.pushes.fit.scores import angles
from planar_pushing.pushes.fit.supported import OnSupport
from planar_pushing.pushes.logs.measured import measurements_of
from planar_pushing.pushes.models import MODELS, Half, errors_of, feet_of

NOISE = (0.5, 0.3, 0.05)
FEET = feet()[0].support
QUICK = ["known_feet", "uniform", "known_feet_ellipsoid", "uniform_ellipsoid"]


def pushed(count, **options):
    return pp.simulate_pushes(feet(), TRIANGLE, count, **{"noise": NOISE, "seed": 6} | options)


@pytest.fixture(scope="module")
def pushes():
    return pushed(60)


@pytest.fixture(scope="module")
def found(pushes):
    return pp.compare(pushes, resamples=200, spacing=20.0)


def test_exact_feet_beat_every_other_model(found):
    assert found["model"].values.tolist() == list(MODELS)
    for quantity in ("motion", "pose"):
        median = found["median"].sel(quantity=quantity)
        assert (median.sel(model="known_feet") <= median).all(), quantity
        assert median.sel(model="identified") < 0.8 * median.sel(model="fitted_ellipsoid")
    ratio = found.sel(quantity="motion", model="known_feet")
    assert float(ratio["ratio"]) < 0.6
    assert float(ratio["ratio_interval"].sel(bound="high")) < 0.8
    assert float(ratio["difference_interval"].sel(bound="high")) < 0.0


def test_the_dataset(found, pushes):
    assert dict(found.sizes) == {"quantity": 3, "model": 7, "push": 60, "bound": 2, "object": 1}
    assert found.attrs == {
        "seed": 0, "splits": 1, "resamples": 200, "reference": "fitted_ellipsoid", "pose_units": "mm",
        "angle_units": "degree", "source": "simulated",
    }  # fmt: skip
    assert found["error_unit"].dims == ("quantity",)
    assert found["error_unit"].values.tolist() == ["degree", "degree", "mm"]
    for name in ("error", "median", "difference_interval"):
        assert found[name].attrs["component_units"] == "error_unit"
    assert found["ratio"].attrs["units"] == found["ratio_interval"].attrs["units"] == "1"
    assert found["length"].values.tolist() == [75.0]
    assert not found["at_corner"].any()
    assert found["pushed"].values.tolist() == pushes["pushed"].values.tolist()
    assert np.isfinite(found["error"]).all()


def test_halves_are_disjoint_and_every_push_is_scored(pushes, monkeypatch):
    fits, scores = [], []

    def recorded(half: Half):
        fits.append(half)
        return OnSupport(FEET), 0.25

    def scored(model, friction, part):
        scores.append(part)
        return errors_of(model, friction, part)

    monkeypatch.setitem(MODELS, "known_feet", recorded)
    monkeypatch.setitem(MODELS, "fitted_ellipsoid", recorded)
    monkeypatch.setattr(room, "errors_of", scored)
    names = ["known_feet"]
    odd = pushes.isel(push=slice(59))
    found = pp.compare(odd, names, seed=3, resamples=2)
    contacts = [each.pushes.contact for each in fits]
    assert [len(each) for each in contacts] == [30, 30, 29, 29]
    rows = [set(map(tuple, each.tolist())) for each in contacts]
    assert rows[0] == rows[1]
    assert not rows[0] & rows[2]
    assert rows[0] | rows[2] == set(map(tuple, odd["contact"].values.tolist()))
    # What is fitted to one half is scored on the other.
    other = [set(map(tuple, each.contact.tolist())) for each in scores]
    assert other == [rows[2], rows[3], rows[0], rows[1]]
    assert fits[0].dataset["contact"].values.tolist() == contacts[0].tolist()
    # Every push has the error of this model, in its own place.
    expected = errors_of(OnSupport(FEET), 0.25, measurements_of(odd))
    assert found["error"].sel(model="known_feet").values == pytest.approx(expected)
    fits.clear()
    pp.compare(odd, names, seed=4, resamples=2)
    assert set(map(tuple, fits[0].pushes.contact.tolist())) not in (rows[0], rows[2])


@pytest.mark.filterwarnings("ignore:outline:planar_pushing.SceneWarning")
def test_errors_against_a_transcription():
    """Of exact mechanics on short pushes of three feet: the angle between vectors, and the final pose."""
    own = measurements_of(pushed(10, distance=3.0))
    model = OnSupport(pp.Points([(20, 10), (120, 20), (10, 110)], [1, 1, 2]))
    wrench, motion, pose = errors_of(model, 0.25, own)
    friction = pp.SupportFriction(support=model.support)
    for k in range(10):
        predicted = pp.wrench(friction, own.twists[k])
        a, b = (each - [0, 0, 50 * each[1] - 50 * each[0]] for each in (predicted, own.wrenches[k]))
        a, b = a / [1, 1, 75], b / [1, 1, 75]
        cosine = a @ b / np.linalg.norm(a) / np.linalg.norm(b)
        assert wrench[k] == pytest.approx(np.degrees(np.arccos(cosine)), abs=1e-6)
        twist = model.motions(own.wrenches[[k]])[0]
        a, b = (
            np.array([t[0] - 50 * t[2], t[1] + 50 * t[2], 75 * t[2]])
            for t in (twist, own.twists[k])
        )
        cosine = a @ b / np.linalg.norm(a) / np.linalg.norm(b)
        assert motion[k] == pytest.approx(np.degrees(np.arccos(cosine)), abs=1e-6)
    scene = pp.scene_at(own.contact[0], own.normal[0], effects=[friction], contact=pp.Coulomb(0.25))
    pusher = pp.Pusher(velocity=tuple(own.finger[0]), shape="finger", frame="world")
    log = pp.simulate(scene, pusher=pusher, duration=1.0, object_pose=(0, 0, 0))
    apart = pose_at_the_end(log) - own.observed[0]
    expected = np.hypot(*apart[:2]) + 75 * abs(apart[2])
    assert pose[0] == pytest.approx(expected, abs=1e-3)


def test_angles():
    a = np.array([(1, 0, 0), (1, 0, 0), (1, 1, 0), (0, 0, 2), (1, 1e-9, 0)], dtype=float)
    b = np.array([(0, 1, 0), (-2, 0, 0), (1, 0, 0), (0, 0, 5), (1, 0, 0)], dtype=float)
    assert angles(a, b) == pytest.approx([90, 180, 45, 0, np.degrees(1e-9)], rel=1e-9, abs=1e-12)


def test_models_of_ones_own(pushes):
    own = {"guess": pp.Points([(10, 10), (130, 10), (10, 130)], [2, 1, 1]), "truth": FEET}
    found = pp.compare(pushes.isel(push=slice(24)), own, resamples=5, spacing=40.0)
    assert found["model"].values.tolist() == ["guess", "truth", *MODELS]
    errors = found["error"]
    assert errors.sel(model="truth").values == pytest.approx(errors.sel(model="known_feet").values)
    median = found["median"].sel(quantity="wrench")
    assert median.sel(model="truth") < median.sel(model="guess")


def test_the_reference_is_always_there(pushes):
    found = pp.compare(pushes.isel(push=slice(16)), ["uniform"], resamples=2)
    assert found["model"].values.tolist() == ["uniform", "fitted_ellipsoid"]


@pytest.mark.slow
def test_without_forces_poses_alone_are_compared(pushes):
    """And without known feet there are no exact ones."""
    some = pushes.isel(push=slice(8)).drop_vars("force")
    found = pp.compare(some, [*QUICK, "fitted_quartic"], resamples=5)
    assert found["model"].values.tolist() == [*QUICK, "fitted_ellipsoid"]
    assert np.isnan(found["error"].sel(quantity=["wrench", "motion"])).all()
    assert np.isnan(found["median"].sel(quantity="motion")).all()
    assert np.isfinite(found["error"].sel(quantity="pose")).all()
    plain = pushes.isel(push=slice(12)).drop_vars(["feet", "foot_weight"])
    found = pp.compare(plain, QUICK, resamples=5)
    assert found["model"].values.tolist() == ["uniform", "uniform_ellipsoid", "fitted_ellipsoid"]


def test_pushes_without_force_among_others(pushes):
    force = pushes["force"].values[:16].copy()
    force[3] = np.nan
    some = pushes.isel(push=slice(16)).assign(force=(("push", "xy"), force, {"units": "N"}))
    error = pp.compare(some, ["known_feet"], resamples=2)["error"]
    missing = np.isnan(error.sel(model="known_feet"))
    assert missing.sel(quantity="motion").values.tolist() == [k == 3 for k in range(16)]
    assert not missing.sel(quantity="pose").any()


def test_a_push_that_does_not_move_the_object_has_no_direction(pushes):
    """Its force is below that of sliding; the final pose alone is scored."""
    some = pushes.isel(push=slice(16)).copy(deep=True)
    some["displacement"].values[3] = some["rotation"].values[3] = 0.0
    error = pp.compare(some, ["fitted_quartic"], resamples=2)["error"]
    missing = np.isnan(error.sel(model="fitted_quartic"))
    assert missing.sel(quantity="motion").values.tolist() == [k == 3 for k in range(16)]
    assert missing.sel(quantity="wrench").values.tolist() == [k == 3 for k in range(16)]
    assert not missing.sel(quantity="pose").any()


def test_two_objects_are_fitted_apart(pushes):
    plate = pp.SupportFriction(support=pp.Polygon(TRIANGLE), weight=5.0)
    other = pp.simulate_pushes((plate,), TRIANGLE, 10, noise=NOISE, name="plate")
    one = pushes.isel(push=slice(12))
    found = pp.compare(pp.concat_pushes([other, one]), QUICK, resamples=5)
    assert found["object"].values.tolist() == ["plate", "object"]
    plates = (found["pushed"] == "plate").values
    exact = found["error"].sel(model="known_feet").values
    assert np.isnan(exact[:, plates]).all()
    assert np.isfinite(exact[:, ~plates]).all()
    alone = pp.compare(one, QUICK, resamples=5)["error"]
    assert found["error"].values[:, :, ~plates] == pytest.approx(alone.values)


def test_the_fitted_ellipsoid_is_found_again():
    """Of pushes whose twists are those of an ellipsoid under the measured wrenches."""
    random = np.random.default_rng(0)
    own = measurements_of(pushed(40, noise=None, distance=1.0))
    low = np.array([[1, 0, 0], [0.3, 0.8, 0], [0.01, -0.005, 0.015]])
    matrix = low @ low.T
    twists = own.centered_wrenches @ matrix * random.uniform(1e-3, 2e-3, size=(40, 1))
    at_origin = np.column_stack([
        twists[:, 0] + 50 * twists[:, 2], twists[:, 1] - 50 * twists[:, 2], twists[:, 2]
    ])  # fmt: skip
    changed = replace(own, displacement=at_origin[:, :2], rotation=at_origin[:, 2])
    model, _ = fitted_ellipsoid(changed)
    again = angles(model.motions(changed.wrenches) * [1, 1, 75], changed.twists * [1, 1, 75])
    assert np.median(again) < 0.5


@pytest.mark.parametrize(("models", "options", "said"), [
    (["exakt"], {}, "models: 'exakt' given; allowed: a sequence of known_feet, identified,"),
    (3, {}, "models: 3 given; allowed: a sequence of"),
    ({"known_feet": FEET}, {}, "models: {'known_feet': Points("),
    ({"mine": 3}, {}, "models: 3 given; allowed: a support, such as Disc or Polygon; construct one"),
    (["known_feet"], {"resamples": 0}, "resamples: 0 given; allowed: a whole number >= 1"),
    (["identified"], {"family": "line"}, "family: 'line' given; allowed: points,"),
])  # fmt: skip
def test_wrong_input(pushes, models, options, said):
    with pytest.raises(pp.InvalidValue) as error:
        pp.compare(pushes.isel(push=slice(16)), models, **options)
    assert str(error.value).startswith(said), str(error.value)
    assert "\n" not in str(error.value)


def test_too_few_pushes():
    with pytest.raises(pp.InvalidValue) as error:
        pp.compare(small())
    assert str(error.value).startswith(
        "pushes: '3 pushes of square to which a model can be fitted' given; allowed: at least 8"
    )
    with pytest.raises(
        pp.InvalidValue, match=r"^pushes: 'list' given; allowed: a dataset of pushes"
    ):
        pp.compare([])


def test_feet_of_a_dataset(pushes):
    feet_found = feet_of(pushes)
    assert np.array(feet_found.positions).tolist() == [[10, 10], [130, 10], [10, 130]]
    assert feet_of(pushes.drop_vars("foot_weight")) is None
    unknown = pushes.assign(foot_weight=pushes["foot_weight"] * np.nan)
    assert feet_of(unknown) is None
