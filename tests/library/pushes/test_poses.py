"""Pushes from poses and finger places in the world."""

import numpy as np
import pytest
from pushes.written import SQUARE, finger_places, small, turn, world_poses

import planar_pushing as pp

#: A square of side 2 at (5, 1), turned by 90 degrees: its -x side is below.
BEFORE, AFTER = [(5.0, 1.0, np.pi / 2)], [(5.0, 1.4, np.pi / 2 + 0.2)]
GIVEN = {
    "outline": SQUARE, "poses_before": BEFORE, "poses_after": AFTER,
    "finger_start": [(5.5, -1.0)], "finger_end": [(5.5, 0.5)],
}  # fmt: skip


def test_a_push_by_hand():
    found = pp.pushes_from_poses(**GIVEN, force=[(0.0, 2.0)])
    assert found["contact"].values[0] == pytest.approx([-1.0, -0.5], abs=1e-15)
    assert found["normal"].values[0] == pytest.approx([1.0, 0.0], abs=1e-15)
    assert found["finger_displacement"].values[0] == pytest.approx([0.5, 0.0], abs=1e-15)
    assert found["displacement"].values[0] == pytest.approx([0.4, 0.0], abs=1e-15)
    assert found["rotation"].values == pytest.approx([np.rad2deg(0.2)], abs=1e-12)
    # Midway the object's x has turned by 0.1 beyond the force.
    assert found["force"].values[0] == pytest.approx([2 * np.cos(0.1), -2 * np.sin(0.1)], abs=1e-15)
    assert found.attrs == {"source": ""}


def test_a_round_finger_begins_at_its_own_distance():
    after = {"poses_after": [(5.0, 1.7, np.pi / 2 + 0.2)]}
    found = pp.pushes_from_poses(**GIVEN | after, finger_radius=0.25)
    assert found["finger_displacement"].values[0] == pytest.approx([0.75, 0.0], abs=1e-15)
    assert found["finger_radius"].values.tolist() == [0.25]


def test_what_is_known_of_the_object():
    found = pp.pushes_from_poses(
        **GIVEN, feet=[(1, 0), (-1, 0), (0, 1)], foot_weights=[1, 1, 2], center_of_mass=(0, 0.5),
        mass=1.5, units=("cm", "lbf"), name="tripod", source="here", noise=(0.1, 0.3, 0.02),
    )  # fmt: skip
    assert found["foot_weight"].values.tolist() == [[0.25, 0.25, 0.5]]
    assert found["center_of_mass"].values.tolist() == [[0.0, 0.5]]
    assert (found["contact"].attrs["units"], found["mass"].attrs["units"]) == ("cm", "kg")
    assert found["pushed"].values.tolist() == ["tripod"]
    assert found.attrs == {
        "source": "here", "position_noise": 0.1, "angle_noise": 0.3, "force_noise": 0.02,
    }  # fmt: skip


@pytest.mark.parametrize("radius", [0.0, 0.3])
def test_the_world_frame_does_not_count(radius):
    random = np.random.default_rng(3)
    pushes = small(finger_radius=("push", [radius] * 3, {"units": "mm"}))
    pushes["force"] = (("push", "xy"), random.normal(size=(3, 2)))
    before, after = world_poses(pushes, random)
    start, end = finger_places(pushes, before, lead=0.7)
    middle = (before[:, 2] + after[:, 2]) / 2
    force = [turn(a) @ f for a, f in zip(middle, pushes["force"].values, strict=True)]
    signed, positive = (
        (np.arctan2(np.sin(each), np.cos(each)) for each in (before[:, 2], after[:, 2])),
        (np.mod(each, 2 * np.pi) for each in (before[:, 2], after[:, 2])),
    )
    for wrapped in ((before[:, 2], after[:, 2]), signed, positive):
        before[:, 2], after[:, 2] = wrapped
        found = pp.pushes_from_poses(
            outline=SQUARE, poses_before=before, poses_after=after, finger_start=start, finger_end=end,
            finger_radius=radius, force=force,
        )  # fmt: skip
        for name in (
            "contact",
            "normal",
            "finger_displacement",
            "displacement",
            "rotation",
            "force",
        ):
            assert found[name].values == pytest.approx(pushes[name].values, abs=1e-9), name


@pytest.mark.parametrize(("before", "after"), [
    (3.1, -3.1), (-3.1, 3.1), (np.pi, -np.pi + 0.08), (0.05, 2 * np.pi - 0.03), (6.27, 0.07),
    (np.float32(np.pi), np.float32(-3.06)), (7.0, 7.083), (-12.5, -12.42),
])  # fmt: skip
def test_wrapped_and_unwrapped_angles(before, after):
    turned = np.remainder(float(after) - float(before) + np.pi, 2 * np.pi) - np.pi
    c, s = np.cos(before), np.sin(before)
    start, end = (np.array([(c, -s), (s, c)]) @ each for each in ((-1.5, 0.5), (-0.9, 0.5)))
    found = pp.pushes_from_poses(
        outline=SQUARE, poses_before=[(0, 0, before)], poses_after=[(0.1 * c, 0.1 * s, after)],
        finger_start=[start], finger_end=[end],
    )  # fmt: skip
    assert found["rotation"].values == pytest.approx([np.rad2deg(turned)], rel=1e-9)


ROTATES = "poses_after: 'a rotation by "


@pytest.mark.parametrize(("before", "after", "said"), [
    ([0.0], [57.0], "poses_after: 'the angle 57, in pushes 0' given; allowed: angles in radians in"),
    ([90.0], [0.0], "poses_before: 'the angle 90, in pushes 0' given; allowed: angles in radians in"),
    ([0.0], [-5.4], f"{ROTATES}-5.4 radians, in pushes 0' given; allowed: pushes that rotate the object"),
    ([0.0, 0.0], [5.7, -4.4], f"{ROTATES}5.7 radians, in pushes 0, 1' given"),
    ([0.0, 0.0], [5.7, 8.0], f"{ROTATES}5.7 radians, in pushes 0, 1' given"),
    ([0.0, 0.0], [2 * np.pi + 0.1, 0.1], f"{ROTATES}6.38319 radians, in pushes 0' given"),
])  # fmt: skip
def test_angles_in_degrees_are_refused(before, after, said):
    given = {
        "outline": SQUARE, "poses_before": [(0, 0, a) for a in before],
        "poses_after": [(0.1, 0, a) for a in after], "finger_start": [(-1.5, 0.1)] * len(before),
        "finger_end": [(-0.9, 0.1)] * len(before),
    }  # fmt: skip
    with pytest.raises(pp.InvalidValue) as error:
        pp.pushes_from_poses(**given)
    assert str(error.value).startswith(said), str(error.value)
    assert "convert degrees with np.deg2rad" in str(error.value)
    radians = {
        name: np.array(given[name]) * (1, 1, np.pi / 180)
        for name in ("poses_before", "poses_after")
    }
    if max(map(abs, (*before, *after))) > 6.0:
        return
    found = pp.pushes_from_poses(**given | radians)
    assert found["rotation"].values == pytest.approx(np.subtract(after, before), rel=1e-9)


def test_a_path_begins_at_its_first_touch():
    corner = [(5.5, -2.0), (5.5, -1.0), (5.5, 0.5), (5.7, 0.5)]
    paths = np.array(
        [corner, [*corner[:3], (np.nan, np.nan)], [(5.5, -1), (5.5, 0), (5.5, 0.2), (5.5, 0.5)]]
    )
    times = np.array([[10, 11, 14, 15], [10, 11, 14, np.nan], [0, 2, 3, 4.0]])
    given = {name: each * 3 for name, each in GIVEN.items() if "poses" in name}
    found = pp.pushes_from_poses(outline=SQUARE, **given, finger_path=paths, path_time=times)
    nan = [np.nan, np.nan]
    expected = [
        [(0, 0), (0.5, 0), (0.5, -0.2)],
        [(0, 0), (0.5, 0), nan],
        [(0, 0), (0.2, 0), (0.5, 0)],
    ]
    assert found["finger_path"].values == pytest.approx(np.array(expected), abs=1e-12, nan_ok=True)
    after = [[0, 1, 2], [0, 1, np.nan], [0, 1, 2]]
    assert found["path_time"].values == pytest.approx(np.array(after), abs=1e-12, nan_ok=True)
    ends = [(0.5, -0.2), (0.5, 0), (0.5, 0)]
    assert found["finger_displacement"].values == pytest.approx(np.array(ends), abs=1e-12)


def several():
    """Four pushes: the second goes by, the last stops short."""
    starts = [(5.5, -1.0), (6.5, -1.0), (4.5, -1.0), (5.5, -1.0)]
    ends = [(5.5, 0.5), (6.5, 0.5), (4.5, 0.5), (5.5, -0.5)]
    (x, y, _), (start, *_) = AFTER[0], BEFORE
    after = [*AFTER * 2, (x, y, start[2] - 0.2), *AFTER]
    return GIVEN | {
        "poses_before": BEFORE * 4, "poses_after": after, "finger_start": starts, "finger_end": ends,
    }  # fmt: skip


def test_pushes_that_miss_are_named_or_left_out():
    with pytest.raises(pp.InvalidValue, match="2 of 4 that do not touch the object: 1, 3' given"):
        pp.pushes_from_poses(**several())
    found = pp.pushes_from_poses(**several(), skip_missed=True)
    assert (found.sizes["push"], found.attrs["left_out"]) == (2, 2)
    assert found["contact"].values[:, 1] == pytest.approx([-0.5, 0.5], abs=1e-15)
    missing = several() | {"finger_end": [(5.5, -0.5)] * 4}
    with pytest.raises(pp.InvalidValue, match="4 of 4 that do not touch"):
        pp.pushes_from_poses(**missing, skip_missed=True)


def test_a_finger_that_overlaps_the_object_at_its_start():
    near = GIVEN | {"finger_start": [(5.5, 0.03)]}
    found = pp.pushes_from_poses(**near)
    assert found["contact"].values[0] == pytest.approx([-1.0, -0.5], abs=1e-15)
    assert found["finger_displacement"].values[0] == pytest.approx([0.47, 0.0], abs=1e-15)
    with pytest.raises(pp.InvalidValue, match=r"begins 0.03 deep in the object, in pushes 0"):
        pp.pushes_from_poses(**near, tolerance=0.02)


def test_a_push_that_begins_deep_in_the_object_is_named_or_left_out():
    deep = several()
    deep["finger_start"] = [*deep["finger_start"][:2], (4.5, -0.2), deep["finger_start"][3]]
    deep["finger_start"][0] = (5.5, 0.4)
    with pytest.raises(pp.InvalidValue, match=r"begins 0.4 deep in the object, in pushes 0'"):
        pp.pushes_from_poses(**deep)
    found = pp.pushes_from_poses(**deep, skip_missed=True)
    assert (found.sizes["push"], found.attrs["left_out"]) == (1, 3)
    assert found["contact"].values[:, 1] == pytest.approx([0.5], abs=1e-15)
    with pytest.raises(
        pp.InvalidValue, match=r"begins 0.4 deep in the object, in pushes 0, 1, 2, 3'"
    ):
        pp.pushes_from_poses(**deep | {"finger_start": [(5.5, 0.4)] * 4}, skip_missed=True)


@pytest.mark.parametrize(("changes", "said"), [
    ({"poses_after": AFTER * 2}, "poses_after: '2 poses' given; allowed: 1 pose, as in poses_before"),
    ({"poses_before": [(5, 1)]}, "poses_before: 'shape (1, 2)' given; allowed: shape (n, 3)"),
    ({"poses_after": [(5, np.nan, 0)]}, "poses_after: '[ 5. nan  0.] of push 0' given; allowed: finite"),
    ({"poses_after": [(5, 9, 0)]},
     "poses_after: 'an object that moves by 8, in pushes 0' given; allowed: at most "
     "3 times its size 2; the pose jumps: leave the push out"),
    ({"finger_start": [(5.5, np.inf)]}, "finger_start: '[[5.5, inf]] of push 0' given; allowed: finite"),
    ({"finger_start": [(5.5, 0.5)] * 2}, "finger_start: 'shape (2, 2)' given; allowed: shape (1, 2)"),
    ({"finger_end": None},
     "finger_path: 'another choice' given; allowed: finger_start and finger_end, or "),
    ({"path_time": [[0, 1]]}, "finger_path: 'another choice' given"),
    ({"finger_start": [(5.5, -999)]},
     "finger_start: '1000 from the middle of an outline of size 2' given; allowed: "
     "lengths in one unit; check the units of outline, poses and finger"),
    ({"force": [(1, 2, 3)]}, "force: 'shape (1, 3)' given; allowed: shape (1, 2); give NaN where"),
    ({"feet": [(0, 0), (1, 0)], "foot_weights": [1, -2]}, "foot_weights: [1, -2] given; allowed: "),
    ({"noise": (0.1, 0.2)}, "noise: (0.1, 0.2) given; allowed: three numbers: position, angle in degrees"),
    ({"poses_before": np.zeros((0, 3))}, "poses_before: 'shape (0, 3)' given; allowed: shape (n, 3)"),
    ({"units": "mm"}, "units: 'mm' given; allowed: the names of two units, such as (mm, N); give both"),
    ({"finger_radius": [1.0]}, "finger_radius: [1.0] given; allowed: a number >= 0"),
    ({"skip_missed": np.array([True, False])}, "skip_missed: array([ True, False]) given; allowed: True"),
    *(({"mass": mass}, f"mass: {mass!r} given; allowed: a finite number > 0")
      for mass in (0, float("nan"), True)),
    ({"poses_after": [(5.0, 1.4, True)]}, "poses_after: [(5.0, 1.4, True)] given; allowed: an array of"),
    ({"force": np.ma.masked_array([[1.0, 2.0]], [[True, True]])}, "force: masked_array(data=[[--, --]]"),
])  # fmt: skip
def test_wrong_input(changes, said):
    with pytest.raises(pp.InvalidValue) as error:
        pp.pushes_from_poses(**GIVEN | changes)
    assert str(error.value).startswith(said), str(error.value)
    assert "\n" not in str(error.value)


STRAIGHT = [[(5.5, -1.0), (5.5, 0.0), (5.5, 0.5)]]


@pytest.mark.parametrize(("path", "times", "said"), [
    (STRAIGHT[0], [0, 1, 2], "finger_path: 'shape (3, 2)' given; allowed: shape (1, samples, 2)"),
    (STRAIGHT, [[0, 1]], "path_time: 'shape (1, 2)' given; allowed: shape (1, 3)"),
    ([[(5.5, -1.0), (5.5, 0.0), (5.5, np.nan)]], [[0, 1, 2]],
     "finger_path: 'a sample that is missing' given"),
    ([[(5.5, -1.0), (np.nan, 0.0), (5.5, 0.5)]], [[0, 1, 2]],
     "finger_path: '[[5.5, -1.0], [nan, 0.0]] of push 0"),
    (STRAIGHT, [[0, 1, 1]], "path_time: '[0., 0.] of push 0' given; allowed: times that increase"),
])  # fmt: skip
def test_wrong_paths(path, times, said):
    given = {name: each for name, each in GIVEN.items() if "finger" not in name}
    with pytest.raises(pp.InvalidValue) as error:
        pp.pushes_from_poses(**given, finger_path=path, path_time=times)
    assert str(error.value).startswith(said), str(error.value)
