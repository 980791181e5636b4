"""`assess_push`: pushes that are odd, inputs that are refused, and what an assessment shows."""

import math
from dataclasses import replace

import numpy as np
import pytest
import xarray as xr

import planar_pushing as pp
from planar_pushing.assessment.methods import RTOLS
from planar_pushing.terms.netcdf import read_dataset

BOX = pp.Polygon.rectangle(0.3, 0.2)
WEIGHT = pp.weight(1.2, 0.3)
FRICTION = pp.SupportFriction(support=BOX, weight=WEIGHT)
INERTIA = pp.Inertia(mass=1.2)
FINGER = pp.Pusher(velocity=(0.0, 0.05), shape="finger")
COULOMB = pp.Coulomb(0.5)
UNITS = pp.Units()


def box(point=(0.04, -0.1), *effects, **options):
    options = {"outline": BOX, "units": UNITS} | options
    return pp.scene_at(point, effects=effects or (FRICTION,), contact=COULOMB, **options)


@pytest.fixture(scope="module")
def assessment():
    return pp.assess_push(box(), FINGER, duration=1.6, candidates=[INERTIA], tolerance=1e-3)


def test_the_table(assessment):
    text = str(assessment)
    lines = text.splitlines()
    assert lines[0].split()[:2] == ["effect", "share"]
    (inertia,) = [line for line in lines if line.startswith("inertia  ")]
    assert "leave it out" in inertia
    assert "0.756" in inertia
    assert "effects needed for 1 mm: support_friction; off by" in text
    assert text.count("cheapest") == 1
    assert "all inputs off together" in text
    assert repr(assessment) == text
    assert assessment._repr_html_().startswith("<pre>effect")


def test_methods_become_more_accurate(assessment):
    methods = assessment.methods
    events = methods.isel(setting=slice(len(RTOLS)))
    steps = methods.isel(setting=slice(len(RTOLS), None))
    assert (steps["error"].diff("setting") < 0).all()
    assert events["error"].max() < steps["error"].min() / 1e3
    assert (events["evaluations"].diff("setting") >= 0).all()
    # The first order of the steps.
    ratio = steps["error"].values * steps["value"].values
    np.testing.assert_allclose(ratio, ratio[-1], rtol=0.1)
    best = methods.isel(setting=methods.attrs["cheapest"])
    assert best["error"] <= assessment.tolerance
    assert (methods["seconds"] >= 0).all()


def test_the_settings_hold_the_tolerance(assessment):
    logs = [
        pp.simulate(assessment.scene, FINGER, duration=1.6, object_pose=(0, 0, 0), **settings)
        for settings in (assessment.settings, {"rtol": 1e-12})
    ]
    ends = [log["object_position"].values[-1] for log in logs]
    assert np.hypot(*(ends[1] - ends[0])) <= assessment.tolerance


def test_the_file_has_three_groups(assessment, tmp_path):
    path = tmp_path / "assessment.nc"
    assessment.to_netcdf(path)
    for name in ("effects", "methods", "inputs"):
        xr.testing.assert_identical(
            read_dataset(path, name).load().drop_attrs(), getattr(assessment, name).drop_attrs()
        )
    assert read_dataset(path).attrs["needed"] == "support_friction"


def test_the_picture_has_three_panels(assessment):
    plt = pytest.importorskip("matplotlib.pyplot")
    axes = assessment.plot()
    assert len(axes) == 3
    assert [label.get_text() for label in axes[0].get_yticklabels()] == [
        "support friction",
        "inertia",
    ]
    change = assessment.effects["pose_change_near"].values * 1e3
    ends = [line.get_xdata()[-1] for line in axes[0].lines if len(line.get_xdata()) == 2]
    assert set(change) <= set(ends)
    plt.close(axes[0].figure)
    with pytest.raises(pp.InvalidValue, match="three axes"):
        assessment.plot(axes[:2])


def test_symmetry_hides_no_effect():
    """Through the center, viscous friction of half the weight changes nothing, beside it much."""
    viscous = pp.Viscous(support=BOX, coefficient=0.5 * WEIGHT / 0.05)
    through = pp.assess_push(
        box((0.0, -0.1)), FINGER, duration=1.6, candidates=[viscous], tolerance=1e-4
    )
    row = through.effects.sel(effect="viscous")
    assert row["pose_change"] < 1e-9
    assert row["pose_change_near"] > 1e-4
    assert row["needed"]


def test_friction_that_alone_holds_a_load_is_listed():
    load = pp.Load(force=(0.0, -0.5 * WEIGHT))
    held = pp.assess_push(box(), FINGER, duration=1.0, candidates=[load], tolerance=1e-3)
    friction = held.effects.sel(effect="support_friction")
    assert friction["modes"].item() == "no motion"
    assert np.isinf(friction["pose_change"])
    assert held.effects["needed"].all()


def test_without_friction_inertia_alone_is_needed():
    scene = box((0.04, -0.1), pp.Inertia(mass=1.2, center=(0.0, 0.0)))
    alone = pp.assess_push(scene, FINGER, duration=1.0)
    assert alone.effects["needed"].values.tolist() == [True]
    assert np.isnan(alone.effects["speed_limit"]).all()
    assert alone.tolerance == pytest.approx(0.01 * math.hypot(0.3, 0.2))


def test_friction_is_not_needed_by_a_fast_push():
    """At 20 m/s, inertia alone moves the box; without it the push is another."""
    fast = pp.Pusher(velocity=(0.0, 20.0), shape="finger")
    answer = pp.assess_push(box(), fast, duration=0.004, candidates=[INERTIA], tolerance=1e-3)
    assert answer.effects["needed"].values.tolist() == [False, True]


@pytest.mark.parametrize("effects", [("support_friction",), ("support_friction", "inertia")])
def test_the_motion_does_not_depend_on_the_frame_of_the_object(effects):
    """A box that is described elsewhere, turned by 2 radians, has the same assessment."""
    c, s = math.cos(2.0), math.sin(2.0)

    def there(x, y):
        return (x * c - y * s + 3.0, x * s + y * c - 1.0)

    corners = [there(*corner) for corner in BOX.vertices]
    outlines = BOX, pp.Polygon(corners)
    answers = []
    for outline, point in zip(outlines, ((0.04, -0.1), there(0.04, -0.1)), strict=True):
        listed = [pp.SupportFriction(support=outline, weight=WEIGHT)]
        if "inertia" in effects:
            listed.append(INERTIA)
        scene = box(point, *listed, outline=outline)
        answers.append(pp.assess_push(scene, FINGER, duration=1.6, tolerance=1e-3))
    for name in ("effects", "inputs"):
        one, other = (getattr(answer, name) for answer in answers)
        for variable in one:
            if one[variable].dtype.kind == "f" and variable != "kink":
                np.testing.assert_allclose(one[variable], other[variable], rtol=1e-4, atol=1e-10)


def test_a_scene_file_has_the_same_assessment_as_its_object(tmp_path, assessment):
    """A scene file is in the body frame, with a placement."""
    pp.save_scene(box(), tmp_path / "box.yaml")
    loaded = pp.load_scene(tmp_path / "box.yaml")
    answer = pp.assess_push(loaded, FINGER, duration=1.6, candidates=[INERTIA], tolerance=1e-3)
    np.testing.assert_allclose(answer.inputs["change"], assessment.inputs["change"], atol=1e-9)
    for name in ("pose_change", "pose_change_near", "estimate"):
        np.testing.assert_allclose(answer.effects[name], assessment.effects[name], rtol=1e-5)


@pytest.mark.parametrize("shape", ["fence", "finger"])
def test_a_scene_without_an_object(shape):
    """The ring of the paper on its rod, whose change is that over a circle of its radius."""
    slider = pp.Slider(rod_length=2.0, rod_angle=math.radians(50))
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(2.0), effects=(pp.RingFriction(weight=1.0),))
    pusher = pp.Pusher(velocity=(0.2, 1.0), shape=shape)
    answer = pp.assess_push(scene, pusher, duration=0.5, candidates=[pp.Inertia(mass=0.1)])
    assert answer.tolerance == pytest.approx(0.02)
    assert answer.effects["effect"].values.tolist() == ["support_friction", "inertia"]
    # What is off by 1 % of the extent's diameter moves the pose by about as much.
    place = answer.inputs["change"].sel(input="place of the contact").values
    assert (place > 1e-4).all()
    assert (place < 0.2).all()


def test_a_disc_is_compared_over_its_circle():
    """A push beside the center of a disc: the change does not depend on how the disc is turned."""
    disc = pp.Disc(0.1)
    friction = pp.SupportFriction(support=pp.Disc(0.05), weight=WEIGHT)
    answers = []
    for angle in (-90.0, 17.0):
        c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        scene = pp.scene_at(
            (0.1 * c, 0.1 * s), effects=(friction,), contact=COULOMB, outline=disc, units=UNITS
        )
        pusher = pp.Pusher(velocity=(0.02, 0.05), shape="finger")
        candidates = [pp.Inertia(mass=1.2)]
        answers.append(pp.assess_push(scene, pusher, duration=1.0, candidates=candidates))
    one, other = answers
    np.testing.assert_allclose(one.effects["pose_change"], other.effects["pose_change"], rtol=1e-6)
    np.testing.assert_allclose(one.inputs["change"], other.inputs["change"], rtol=1e-4, atol=1e-9)


def test_a_side_on_the_fence_has_no_place():
    scene = pp.scene_at(side=0, effects=(FRICTION,), contact=COULOMB, outline=BOX)
    fence = pp.Pusher(velocity=(0.01, 0.05))
    answer = pp.assess_push(scene, fence, duration=1.0, candidates=[INERTIA])
    assert "place of the contact" not in answer.inputs["input"]
    assert "pressure along the side" in answer.inputs["input"]


def test_a_fence_at_a_corner_is_turned():
    scene = pp.scene_at(
        (-0.15, -0.1), (0.3, 1.0), effects=(FRICTION,), contact=COULOMB, outline=BOX
    )
    answer = pp.assess_push(scene, pp.Pusher(velocity=(0.0, 0.05)), duration=1.0)
    names = answer.inputs["input"].values.tolist()
    assert "angle of the fence" in names
    assert "place of the contact" not in names


def test_a_pusher_that_follows_a_function(assessment):
    """A constant function is the constant velocity, along the axes of the fence or of the object."""
    for pusher in (
        pp.Pusher(velocity=lambda time: (0.0, 0.05), shape="finger"),
        replace(FINGER, frame="world"),
    ):
        answer = pp.assess_push(box(), pusher, duration=1.6, candidates=[INERTIA], tolerance=1e-3)
        for name in ("pose_change", "estimate"):
            np.testing.assert_allclose(answer.effects[name], assessment.effects[name], rtol=1e-6)
        np.testing.assert_allclose(answer.inputs["change"], assessment.inputs["change"], atol=1e-8)


def test_a_kink_is_told():
    """The force of a translation is on the edge of the friction cone: with less friction, it slips."""
    angle = math.radians(20.0)
    scene = pp.scene_at(
        (-0.1 * math.tan(angle), -0.1), effects=(FRICTION,), outline=BOX,
        contact=pp.Coulomb(1.005 * math.tan(angle)),
    )  # fmt: skip
    pusher = pp.Pusher(velocity=(0.05 * math.sin(angle), 0.05 * math.cos(angle)), shape="finger")
    answer = pp.assess_push(scene, pusher, duration=1.0, tolerance=1e-5)
    friction = answer.inputs.sel(input="friction of the contact")
    more, less = friction["change"].values
    assert more < 1e-9
    assert less > 1e-5
    assert friction["kink"] == pytest.approx(1.0, abs=1e-3)
    assert not friction["same_modes"]
    assert any(text.startswith("friction of the contact: ") for text in answer.warnings)


def test_several_consistent_modes_are_told():
    """A pull, which separation would obey as well."""
    scene = pp.load_scene("workflow/scenes/pulling.yaml")
    angles = np.deg2rad([60.0, -20.0])
    pieces = zip((0.0, 0.4), zip(np.cos(angles), np.sin(angles), strict=True), strict=True)
    answer = pp.assess_push(scene, pp.Pusher(velocity=list(pieces)), duration=1.0)
    assert any("several contact modes are consistent" in text for text in answer.warnings)


def test_an_early_end_is_told_and_its_effect_is_listed():
    """The finger comes to a second place of a hollow object, sooner or later by its inertia."""
    hollow = [(-2, -1), (2, -1), (2, 1), (1.5, 1), (1.5, -0.5), (-1.5, -0.5), (-1.5, 1), (-2, 1)]
    outline = 0.1 * np.array(hollow)
    friction = pp.SupportFriction(support=pp.Polygon(outline), weight=WEIGHT)
    scene = pp.scene_at(
        (0.05, -0.05), (0.0, -1.0), effects=(friction,), contact=pp.Coulomb(0.1), outline=outline
    )
    pusher = pp.Pusher(velocity=(-0.05, 0.05), shape="finger")
    answer = pp.assess_push(scene, pusher, duration=6.0, candidates=[INERTIA])
    assert any("ends early, at" in text for text in answer.warnings)


WRONG = [
    ({"scene": 3}, "scene: 3 given; allowed: a Scene"),
    ({"scene": box(np.array([(0.04, -0.1), (0.0, -0.1)]))}, "scene: 'an array of scenes' given"),
    ({"pusher": (0, 1)}, "pusher: (0, 1) given; allowed: a Pusher"),
    ({"pusher": pp.Pusher(velocity=(np.zeros(2), np.ones(2)))}, "pusher: 'arrays' given"),
    ({"duration": 0.0}, "duration: 0.0 given"),
    ({"duration": [1.0, 2.0]}, "duration"),
    ({"tolerance": -1.0}, "tolerance: -1.0 given; allowed: a finite number > 0"),
    ({"tolerance": math.nan}, "tolerance: nan given"),
    ({"tolerance": [1.0, 2.0]}, "tolerance"),
    ({"change": 0.0}, "change: 0.0 given; allowed: a number in (0, 0.1]"),
    ({"change": 0.2}, "change: 0.2 given"),
    ({"candidates": "inertia"}, "candidates: 'inertia' given"),
    ({"candidates": [FRICTION, COULOMB]}, "candidates: "),
]


@pytest.mark.parametrize(("wrong", "said"), WRONG)
def test_wrong_input_gets_one_line(monkeypatch, wrong, said):
    monkeypatch.setattr("planar_pushing.assessment.trial.simulate", None)  # nothing runs
    arguments = {"scene": box(), "pusher": FINGER, "duration": 1.0} | wrong
    scene, pusher = arguments.pop("scene"), arguments.pop("pusher")
    with pytest.raises(pp.InvalidValue) as error:
        pp.assess_push(scene, pusher, **arguments)
    message = str(error.value)
    assert said in message
    assert "\n" not in message


def test_a_push_that_simulate_refuses_is_refused():
    scene = pp.scene_at(side=0, effects=(FRICTION,), contact=COULOMB, outline=BOX)
    with pytest.raises(pp.InvalidValue, match="finger on a side"):
        pp.assess_push(scene, FINGER, duration=1.0)
