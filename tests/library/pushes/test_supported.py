"""Pushes of an object on a support: final poses, wrenches and motions against single scenes."""

import numpy as np
import pytest
from pushes.written import TRIANGLE, touching
from simulation.runs import pose_at_the_end

import planar_pushing as pp
from planar_pushing.pushes.fit.supported import OnSupport, body_frames
from planar_pushing.pushes.logs.measured import measurements_of

#: Feet that do not coincide with the frame's origin, a plate, and both.
SUPPORTS = {
    "points": pp.Points([(10, 10), (130, 10), (10, 130)], [1, 2, 3]),
    "polygon": pp.Polygon([(5, 5), (90, 5), (5, 120)]),
    "both": pp.Composite([(1, pp.Polygon([(20, 20), (60, 20), (20, 60)])), (2, pp.Points([(90, 20)]))]),
}  # fmt: skip


def pushed(support, count, radius=0.0, **options):
    effects = (pp.SupportFriction(support=support, weight=3.0),)
    return pp.simulate_pushes(effects, TRIANGLE, count, finger_radius=radius, **options)


@pytest.mark.parametrize("radius", [0.0, 5.0])
@pytest.mark.parametrize("kind", SUPPORTS)
def test_final_poses_are_those_of_single_simulations(kind, radius):
    """`simulate_pushes` runs `simulate` of `scene_at` one by one; its poses have no noise."""
    pushes = measurements_of(pushed(SUPPORTS[kind], 8, radius, seed=3))
    found = OnSupport(SUPPORTS[kind]).poses(pushes, 0.25)
    assert found[:, :2] == pytest.approx(pushes.displacement, abs=2e-3)
    assert found[:, 2] == pytest.approx(pushes.rotation, abs=2e-5)


def test_infinite_friction_and_none():
    """The contact that sticks goes with the finger; without friction the force is along the normal."""
    support = SUPPORTS["points"]
    pushes = measurements_of(pushed(support, 6, contact=pp.InfiniteFriction()))
    found = OnSupport(support).poses(pushes, 1e6)
    assert found == pytest.approx(pushes.observed, abs=2e-3)
    smooth = measurements_of(pushed(support, 6, contact=pp.Coulomb(0.0)))
    assert OnSupport(support).poses(smooth, 0.0) == pytest.approx(smooth.observed, abs=2e-3)


def test_a_push_through_the_center_of_a_symmetric_object_does_not_turn_it():
    square = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    support = pp.Points(square, [1, 1, 1, 1])
    pushes = measurements_of(pp.pushes_from_poses(
        outline=square, poses_before=np.zeros((1, 3)), poses_after=[(0, 0.5, 0)],
        finger_start=[(0, -1)], finger_end=[(0, -0.5)], finger_radius=0.0, units=("mm", "N"),
    ))  # fmt: skip
    found = OnSupport(support).poses(pushes, 0.3)
    assert found[0] == pytest.approx([0, 0.5, 0], abs=1e-6)


@pytest.mark.filterwarnings("ignore:outline:planar_pushing.SceneWarning")
def test_a_path_is_followed_part_by_part():
    """Two straight parts, along the normal and then aside."""
    support = SUPPORTS["points"]
    way = np.array([(0, 6.0), (3.0, 3.0)])
    found = OnSupport(support).poses(touching(TRIANGLE, (60.0, 0.0), (0.0, 1.0), way), 0.25)
    scene = pp.scene_at(
        (60, 0), (0, 1), effects=(pp.SupportFriction(support=support),), contact=pp.Coulomb(0.25)
    )
    pusher = pp.Pusher(velocity=[(0.0, (0, 12.0)), (0.5, (6.0, 6.0))], shape="finger")
    log = pp.simulate(scene, pusher=pusher, duration=1.0, object_pose=(0, 0, 0))
    end = pose_at_the_end(log)
    assert found[0] == pytest.approx(end, abs=1e-3)


@pytest.mark.parametrize("kind", SUPPORTS)
def test_wrenches_are_sums_over_the_support(kind):
    """Those of `pp.wrench`, whose torque is about the object's origin."""
    twists = np.random.default_rng(1).normal(size=(6, 3)) * [50, 50, 1]
    found = OnSupport(SUPPORTS[kind]).wrenches(twists)
    friction = pp.SupportFriction(support=SUPPORTS[kind], weight=1.0)
    assert found == pytest.approx(np.array([pp.wrench(friction, each) for each in twists]))


@pytest.mark.parametrize("kind", SUPPORTS)
def test_the_motion_under_a_wrench_has_that_wrench(kind):
    """Parallel, but for pivots about a point, where it is in the load set of the point."""
    random = np.random.default_rng(2)
    model, scale = OnSupport(SUPPORTS[kind]), np.array([1, 1, 60.0])
    wrenches = random.normal(size=(20, 3)) * scale
    again = model.wrenches(model.motions(wrenches)) / scale
    given = wrenches / scale
    apart = np.linalg.norm(np.cross(again, given), axis=1)
    apart /= np.linalg.norm(again, axis=1) * np.linalg.norm(given, axis=1)
    powers = (model.motions(wrenches) * wrenches).sum(axis=1)
    assert (powers > 0.0).all()
    pivots = np.zeros(20, dtype=bool)
    if kind != "polygon":
        places = np.array([(10, 10), (130, 10), (10, 130)] if kind == "points" else [(90, 20)])
        v_x, v_y, omega = model.motions(wrenches).T[..., None]
        speed = np.hypot(v_x - omega * places[:, 1], v_y + omega * places[:, 0])
        pivots = (speed < 1e-6 * abs(omega)).any(axis=1)
    assert (~pivots).sum() >= 4
    assert apart[~pivots] == pytest.approx(0.0, abs=1e-7)


def test_a_torque_without_a_force_has_no_line():
    found = OnSupport(SUPPORTS["points"]).motions(np.array([[0.0, 0.0, 1.0], [0.0, 1.0, 50.0]]))
    assert np.isnan(found[0]).all()
    assert np.isfinite(found[1]).all()
    assert np.isnan(OnSupport(SUPPORTS["points"]).motions(np.array([[0.0, 0.0, 1.0]]))).all()


def test_body_frames_have_their_origin_above_the_side():
    """A center that is not above its side is replaced by a point that is: the poses stay the same."""
    pushes = measurements_of(pushed(SUPPORTS["points"], 8, seed=5))
    places = pushes.first_places
    for center in (np.array([50.0, 50.0]), np.array([-40.0, -40.0])):
        frames = body_frames(pushes, center, 150.0)
        assert ((frames.origin - places.point) * places.normal).sum(axis=1).min() > 0.0
        assert places.point + frames.length[:, None] * frames.axis == pytest.approx(frames.origin)
