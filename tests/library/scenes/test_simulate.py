"""Scene files as arguments of `simulate`."""

import numpy as np
import pytest
import xarray as xr
from pydantic import TypeAdapter

from planar_pushing import InvalidValue, Until
from planar_pushing.scenes.entries import SupportEntry
from planar_pushing.scenes.files import load_scene_file
from planar_pushing.scenes.pusher_model import PieceEntry, velocity
from planar_pushing.scenes.simulate import arguments, simulate_file
from planar_pushing.scenes.simulate_model import SimulateEntry
from pulling_by_pushing.study.datasets.base import labeled_radians


def test_pieces_are_velocities_of_the_fence():
    pieces = [{"time": 0, "angle": 10}, {"time": 0.5, "angle": -10, "speed": 2}]
    found = arguments(SimulateEntry(pusher=pieces, duration=1.5))["pusher"].pieces
    assert [time for time, _ in found] == [0.0, 0.5]
    expected = [np.cos(np.deg2rad(10)), 2 * np.cos(np.deg2rad(10))]
    assert [each[0] for _, each in found] == pytest.approx(expected)
    assert [each[1] < 0 for _, each in found] == [False, True]


@pytest.mark.parametrize(
    ("angle", "expected"),
    [(0, (1, 0)), (90, (0, 1)), (180, (-1, 0)), (-90, (0, -1)), (540, (-1, 0))],
)
def test_along_and_across_the_fence_is_exact(angle, expected):
    assert velocity(PieceEntry(time=0, angle=angle)) == expected


@pytest.mark.parametrize("degrees", [7290.0, -7110.0, 1e6 + 170.0])
def test_any_finite_number_of_degrees_is_a_direction(degrees):
    pose = {"x": 1, "y": 2, "angle": degrees}
    entry = SimulateEntry(pusher_angle=degrees, duration=1, object_pose=pose)
    assert np.sin(arguments(entry)["object_pose"][2]) == pytest.approx(1.0)
    file = load_scene_file("workflow/scenes/slipping.yaml").model_copy(update={"simulate": entry})
    assert np.sin(file.build().push[0]) == pytest.approx(1.0)
    over = labeled_radians(xr.DataArray([degrees, 30.0], dims="pusher_angle"))
    assert np.sin(over.values) == pytest.approx([1.0, 0.5])
    entry = {"shape": "rectangle", "width": 2, "height": 1, "angle": degrees}
    support = TypeAdapter(SupportEntry).validate_python(entry).build()
    assert np.ptp(support.vertices, axis=0) == pytest.approx((1.0, 2.0))


def test_the_initial_twist_is_in_degrees():
    entry = SimulateEntry(pusher_angle=0, duration=1, initial_twist={"v_x": 1, "omega": 180})
    assert arguments(entry)["twist"] == (1, 0, np.pi)


def test_a_finger_is_one():
    entry = SimulateEntry(pusher_angle=90, pusher_shape="finger", duration=1)
    assert arguments(entry)["pusher"].shape == "finger"
    assert arguments(SimulateEntry(pusher_angle=90, duration=1))["pusher"].shape == "fence"


def test_a_finger_has_the_radius_of_the_file():
    finger = {"pusher_shape": "finger", "duration": 1}
    places = [{"time": 0, "x": 1, "y": 2}, {"time": 0.5, "x": 1, "y": 3}]
    for way in ({"pusher_angle": 90}, {"waypoints": places}):
        for given in (0.2, 0.0, None):
            entry = SimulateEntry(pusher_radius=given, **way, **finger)
            assert arguments(entry)["pusher"].radius == (given or 0.0)


def test_waypoints_are_those_of_the_pusher():
    places = [{"time": 0, "x": 1, "y": 2}, {"time": 0.5, "x": 1, "y": 3}]
    given = {"pusher_frame": "world", "object_pose": {"x": 1, "y": 2, "angle": 90}}
    found = arguments(SimulateEntry(waypoints=places, duration=1, **given))
    assert found["pusher"].waypoints == [(0, (1, 2)), (0.5, (1, 3))]
    assert found["pusher"].frame == "world"
    assert found["object_pose"] == (1, 2, np.pi / 2)


@pytest.mark.parametrize(
    ("until", "found"),
    [
        (None, None),
        ({"event": "KINK"}, "KINK"),
        ({"mode": "SLIP_LEFT"}, "SLIP_LEFT"),
        ({"rotation": 90, "pusher_distance": 2}, Until(rotation=np.pi / 2, pusher_distance=2)),
    ],
)
def test_until_is_a_name_or_goals_in_radians(until, found):
    assert arguments(SimulateEntry(pusher_angle=0, duration=1, until=until))["until"] == found


def test_a_scene_without_the_section_is_not_simulated():
    with pytest.raises(InvalidValue, match="simulate: None given; allowed: a section"):
        simulate_file(load_scene_file("workflow/scenes/figure_08.yaml"))
