"""Poses in the world: the contact of the object is where the pusher is, whatever the frames."""

import numpy as np
import pytest
import xarray as xr
from simulation.runs import final, heading, run

import planar_pushing as pp

#: The scenes are plain or random numbers, not real objects.
pytestmark = pytest.mark.filterwarnings("ignore:outline:planar_pushing.SceneWarning")

ROUGH = pp.Coulomb(1.0)
BOX = [(-0.15, -0.1), (0.15, -0.1), (0.15, 0.1), (-0.15, 0.1)]
METHODS = pytest.mark.parametrize("method", ["event-driven", "time-stepping"])


def box(point=(0.03, -0.1), normal=(0, 1), contact=ROUGH):
    """A box in its own frame, whose origin is aside of its center."""
    corners = np.add(BOX, (0.4, -0.2))
    support = pp.SupportFriction(support=pp.Polygon(corners))
    place = np.add(point, (0.4, -0.2))
    return pp.scene_at(place, normal, effects=(support,), contact=contact)


def in_world(log, points):
    """Points of the object's frame in the world at every instant, by complex numbers."""
    x, y = log.object_position.values.T
    places = (x + 1j * y) + np.exp(1j * np.deg2rad(log.object_angle.values)) * (
        np.array(points) @ (1, 1j)
    )
    return np.stack([places.real, places.imag], axis=-1)


@METHODS
@pytest.mark.parametrize("shape", ["fence", "finger"])
@pytest.mark.parametrize(
    ("point", "normal"), [((0.03, -0.1), (0, 1)), ((0.15, 0.02), (-1, 0)), ((-0.15, -0.1), (0.6, 0.8))]
)  # fmt: skip
def test_a_contact_that_sticks_is_where_the_pusher_is(method, shape, point, normal):
    pose, scene = (3.0, -2.0, 2.3), box(point, normal, pp.InfiniteFriction())
    pusher = pp.Pusher(velocity=[(0, (0.02, 0.1)), (0.5, (-0.03, 0.1))], shape=shape)
    log = run(scene, pusher, 1.0, method=method, object_pose=pose)
    assert set(log.mode.values) == {pp.ContactMode.STICK}
    np.testing.assert_allclose(log.object_position[0], [3.0, -2.0], rtol=0, atol=1e-13)
    assert float(log.object_angle[0]) == pytest.approx(np.rad2deg(2.3), rel=0, abs=1e-13)
    contact = in_world(log, scene.placement.point)
    np.testing.assert_allclose(
        log.pusher_position, contact, atol=1e-9 if method == "event-driven" else 5e-4
    )
    assert np.ptp(log.object_angle.values) > 1


def test_a_finger_that_slips_is_on_the_side_where_the_log_says():
    scene = box((0.03, -0.1), (0, 1), pp.Coulomb(0.1))
    pusher = pp.Pusher(velocity=(0.1, 0.1), shape="finger")
    log = run(scene, pusher, 0.7, object_pose=(0.1, 0.2, -1.0))
    assert final(log, "contact_position") > 0.01
    places = np.array([(0.43 + along, -0.3) for along in log.contact_position.values])
    np.testing.assert_allclose(log.pusher_position, in_world(log, places), atol=1e-12)


def test_a_fence_keeps_its_angle_in_the_world_and_the_gap():
    """The contact is above the fence by the gap, along the normal that the side has at time 0."""
    scene, angle = box((0.15, 0.02), (-1, 0), pp.Coulomb(0.2)), 0.7
    log = run(scene, (0.02, 0.1), 1.0, gap=0.03, object_pose=(0.0, 0.0, angle))
    normal = np.array([-np.cos(angle), -np.sin(angle)])
    height = (in_world(log, scene.placement.point) - log.pusher_position.values) @ normal
    np.testing.assert_allclose(height, log.gap, atol=1e-12)
    assert height[0] == pytest.approx(0.03, abs=1e-15)


@pytest.mark.parametrize("shape", ["fence", "finger"])
@pytest.mark.parametrize("angle", [0.0, np.pi / 2, -2.0])
def test_a_pusher_moves_along_the_axes_of_the_world(shape, angle):
    scene, pose = box((0.15, 0.02), (-1, 0)), (5.0, 6.0, angle)
    start = np.array([5, 6]) + [
        [np.cos(angle), -np.sin(angle)],
        [np.sin(angle), np.cos(angle)],
    ] @ np.array(scene.placement.point)
    inward = -np.array([np.cos(angle), np.sin(angle)])
    places = [start, start + 0.05 * inward, start + 0.1 * inward + (0.001, 0.002)]
    waypoints = list(zip([0.0, 0.5, 1.0], map(tuple, places), strict=True))
    pusher = pp.Pusher(waypoints=waypoints, frame="world", shape=shape)
    log = run(scene, pusher, 1.0, object_pose=pose)
    for time, place in waypoints:
        there = log.pusher_position.sel(time=time).values
        np.testing.assert_allclose(there, place, rtol=0, atol=1e-14)
    # The same motion, along the fence and normal to it.
    along = np.array([inward[1], -inward[0]])
    turned = [(t, (np.dot(p, along), np.dot(p, inward))) for t, p in waypoints]
    own = run(scene, pp.Pusher(waypoints=turned, shape=shape), 1.0)
    np.testing.assert_allclose(log.rod_angle, own.rod_angle, atol=1e-9)


def test_a_function_of_time_moves_along_the_axes_of_the_world_too():
    given = {"breakpoints": [0.5], "frame": "world"}
    pusher = pp.Pusher(velocity=lambda t: (0.1 if t < 0.5 else 0.05, 0.1 * t), **given)
    log = run(box((-0.15, 0.02), (1, 0)), pusher, 1.0, object_pose=(0, 0, 0))
    moved = log.pusher_position[-1] - log.pusher_position[0]
    np.testing.assert_allclose(moved, [0.075, 0.05], atol=1e-14)


def test_pushes_along_the_fence_stay_exactly_along_it():
    """The world's axes are the fence's, turned by right angles: nothing of rounding is normal to it."""
    scene = box((0.15, 0.02), (-1, 0))
    for quarter, velocity in enumerate([(0, 1), (-1, 0), (0, -1), (1, 0)]):
        pusher = pp.Pusher(velocity=velocity, frame="world")
        log = run(scene, pusher, 0.1, object_pose=(0, 0, quarter * np.pi / 2))
        assert log.pusher[-1].values.tolist() == pytest.approx([0.1, 0], abs=1e-16)
        assert log.pusher[-1, 1] == 0


def test_the_pose_moves_by_the_twist():
    """Central differences of the pose against the log's twist, taken about the object's origin."""
    log = run(box(), heading(80, 0.1), 1.0, samples=2001, object_pose=(1.0, 2.0, 0.4))
    x, y = np.gradient(log.object_position.values, log.time.values, axis=0).T[:, 5:-5]
    angle = np.gradient(log.object_angle.values, log.time.values)[5:-5]
    twist = log.twist.values[5:-5]
    np.testing.assert_allclose(np.deg2rad(angle), twist[:, 2], atol=1e-6)
    center = np.gradient(in_world(log, (0.4, -0.2)), log.time.values, axis=0)[5:-5]
    turned = np.array([[np.cos(0.4), np.sin(0.4)], [-np.sin(0.4), np.cos(0.4)]]) @ center.T
    np.testing.assert_allclose(turned.T, twist[:, :2], atol=1e-6)
    assert np.abs(x).max() > 0.01 < np.abs(y).max()


def test_a_log_without_a_pose_has_none_and_a_streamed_one_is_the_same(tmp_path):
    placed = {"object_position", "object_angle", "pusher_position"}
    assert not placed & set(run(box(), (0, 0.1), 0.1))
    given = {"object_pose": (1, 2, 3), "until": lambda now: now["object_position"][1] > 2.01}
    kept = run(box(), (0.02, -0.1), 0.3, **given)
    assert kept.attrs["object_pose"].tolist() == [1, 2, 3]
    assert kept.attrs["object_pose_units"] == "length, length, radian"
    assert placed <= set(kept)
    assert kept.object_angle.attrs["units"] == "degree"
    with run(box(), (0.02, -0.1), 0.3, path=tmp_path / "a.nc", **given) as streamed:
        xr.testing.assert_identical(
            kept.drop_attrs(deep=False), streamed.load().drop_attrs(deep=False)
        )
