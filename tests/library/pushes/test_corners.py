"""Fingers that go around corners: estimates warn of them once, with their number."""

import warnings

import numpy as np
import pytest
from pushes.written import turn

import planar_pushing as pp
from planar_pushing.pushes.logs.contacts import goes_around_corners
from planar_pushing.pushes.logs.measured import measurements_of

#: Semi-axes of an ellipse in mm, and the ratio of spin torque to force of its support.
AXES, SPIN = np.array([65.0, 52.0]), 39.0
WARNING = r"^pushes: in {} of {} pushes of object, the finger leaves the side"


def ellipse(corners):
    """Outline with corners on the ellipse."""
    angles = 2.0 * np.pi * (np.arange(corners) + 0.5) / corners
    return AXES * np.column_stack([np.cos(angles), np.sin(angles)])


def pushed(start, direction, distance, steps=400):
    """Pose of the ellipse after a smooth point finger has moved a distance.

    The limit surface is an ellipsoid about the middle. The finger stays on the ellipse, normal to it.
    """
    pose, finger = np.zeros(3), AXES * (np.cos(start), np.sin(start))
    step = direction * distance / steps
    for _ in range(steps):
        contact = turn(pose[2]).T @ (finger - pose[:2])
        normal = -contact / AXES**2
        normal /= np.linalg.norm(normal)
        arm = contact[0] * normal[1] - contact[1] * normal[0]
        twist = np.array([*normal, arm / SPIN**2])
        into = normal @ (turn(pose[2]).T @ step)
        if into <= 0.0:
            break
        twist *= into / (1.0 + arm**2 / SPIN**2)
        pose += [*(turn(pose[2]) @ twist[:2]), twist[2]]
        finger = finger + step
    return pose


def round_pushes(corners, distance=25.0):
    """Pushes of the ellipse, with an outline of this many corners."""
    starts = np.arange(10) * 0.61
    fingers = AXES * np.column_stack([np.cos(starts), np.sin(starts)])
    inward = -fingers / AXES**2
    inward /= np.linalg.norm(inward, axis=1, keepdims=True)
    directions = np.array([turn(0.6 * (-1) ** k) @ normal for k, normal in enumerate(inward)])
    after = [pushed(*pair, distance) for pair in zip(starts, directions, strict=True)]
    return pp.pushes_from_poses(
        outline=ellipse(corners), poses_before=np.zeros((10, 3)), poses_after=after,
        finger_start=fingers - 2.0 * directions, finger_end=fingers + distance * directions,
        noise=(0.1, 0.1, 0.0),
    )  # fmt: skip


def straight_pushes():
    """Pushes of an object with long sides, some of which leave it or touch a corner first."""
    box = np.array([(-60, -40), (60, -40), (60, 40), (-60, 40)])
    support = pp.SupportFriction(support=pp.Points([(-50, -30), (50, -30), (0, 30)]))
    return pp.simulate_pushes((support,), box, 10, seed=3, finger_radius=5.0, distance=20.0)


@pytest.mark.parametrize("corners", [36, 72, 360])
@pytest.mark.parametrize("estimate", [pp.identify, pp.compare])
def test_estimates_for_a_round_object_warn(corners, estimate):
    """Warnings are errors here, so that the estimate itself is not made."""
    pushes = round_pushes(corners)
    count = int(goes_around_corners(measurements_of(pushes)).sum())
    assert count >= 9
    with pytest.raises(pp.SceneWarning, match=WARNING.format(count, 10)) as error:
        estimate(pushes)
    assert "use an object with long sides" in str(error.value)


def test_the_warning_comes_once_and_names_the_line_of_the_caller():
    pushes = round_pushes(24).isel(push=[1, 2, 3])
    count = int(goes_around_corners(measurements_of(pushes)).sum())
    with pytest.warns(pp.SceneWarning, match=WARNING.format(count, 3)) as caught:
        pp.identify(pushes, known=[(-40, -20), (40, -20), (0, 40)], resamples=2)
    assert [warning.filename for warning in caught] == [__file__]


def test_short_pushes_of_a_round_object_do_not_go_around_a_corner():
    """Where the finger moves less than a side is long."""
    count = int(goes_around_corners(measurements_of(round_pushes(36, 1.0))).sum())
    assert count <= 3


def test_long_sides_do_not_warn():
    """Neither do fingers that leave the object behind, nor those that push a corner."""
    pushes = straight_pushes()
    feet = [(-50, -30), (50, -30), (0, 30)]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        pp.identify(pushes, known=feet, resamples=2)
    away = {
        "outline": [(-1, -1), (1, -1), (1, 1), (-1, 1)], "poses_before": np.zeros((2, 3)),
        "poses_after": [(0.0, 0.03, 0.0), (-0.2, -0.2, 0.0)],
        "finger_start": [(0.5, -1.1), (1.0, 1.0)], "finger_end": [(1.6, -0.8), (0.8, 0.8)],
    }  # fmt: skip
    assert not goes_around_corners(measurements_of(pp.pushes_from_poses(**away))).any()


def test_a_finger_that_passes_a_corner_and_pushes_on():
    """It touches the lower side and ends at (1, -0.8) of the object, on the right side, or not."""
    end = np.array([1.05, -0.5])
    for place, expected in (((1.0, -0.8), True), ((0.9, -1.0), False), ((1.1, -0.8), False)):
        pushes = pp.pushes_from_poses(
            outline=[(-1, -1), (1, -1), (1, 1), (-1, 1)], poses_before=[(0, 0, 0)],
            poses_after=[(*(end - turn(0.3) @ place), 0.3)], finger_start=[(0.8, -1.1)], finger_end=[end],
        )  # fmt: skip
        measured = measurements_of(pushes)
        assert measured.last_gaps == pytest.approx([max(0.0, place[0] - 1.0)], abs=1e-12)
        assert goes_around_corners(measured).tolist() == [expected]
