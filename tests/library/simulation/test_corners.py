"""Fingers at corners: round an outer one, a refusal at an inner one."""

from __future__ import annotations

import numpy as np
import pytest
from simulation.scenes import METHODS as BOTH

import planar_pushing as pp

pytestmark = [
    pytest.mark.filterwarnings("ignore::planar_pushing.EarlyEndWarning"),
    pytest.mark.filterwarnings("ignore:pusher:planar_pushing.SceneWarning"),
]

BOX = [(-0.1, -0.1), (0.1, -0.1), (0.1, 0.1), (-0.1, 0.1)]
TEE = [(-60, 0), (-60, 30), (60, 30), (60, 0), (15, 0), (15, -90), (-15, -90), (-15, 0)]
FRICTION = (pp.SupportFriction(support=pp.Polygon(BOX)),)
INERTIA = (*FRICTION, pp.Inertia(mass=1e-3, gyration_radius=0.08))
METHODS = pytest.mark.parametrize("method", BOTH)
SETS = pytest.mark.parametrize("effects", [FRICTION, INERTIA])
BISECTOR = (-np.sqrt(0.5), np.sqrt(0.5))


def box_at(x, normal=(0, 1), law=0.1, effects=FRICTION):
    return pp.scene_at((x, -0.1), normal, effects=effects, contact=pp.Coulomb(law), outline=BOX)


def pushed(scene, velocity, radius=0.0, **options):
    finger = pp.Pusher(velocity=velocity, shape="finger", radius=radius, frame="world")
    return pp.simulate(scene, finger, duration=0.8, object_pose=(0, 0, 0), **options)


#: Contacts, radii, and times and angles at the end of the contact: from the corner by an own integration of
#: the full pose, and beside it by the motion along an endless side.
ENDS = [
    (0.1, 0.0, 0.2481737, 8.14054, 1e-6),
    (0.1 - 1e-7, 0.0, 0.2481737, 8.14054, 1e-6),
    (0.0999, 0.0, 0.2707436, 8.8670521, 1e-6),
    (0.1, 0.01, 0.6487640813, 18.81252193, 1e-9),
]


@pytest.mark.parametrize(("x", "radius", "time", "angle", "slack"), ENDS)
@METHODS
def test_a_finger_that_starts_at_a_corner_goes_round_it(method, x, radius, time, angle, slack):
    log = pushed(box_at(x), (0.05, 0.1), radius, method=method)
    assert log.attrs["stopped"] == ""
    slack = slack if method == "event-driven" else 2e-3
    leaves = log.time.values[np.flatnonzero(log["mode"].values == pp.ContactMode.SEPARATE)[0]]
    assert leaves == pytest.approx(time, abs=slack)
    assert log.object_angle[-1].item() == pytest.approx(angle, abs=30 * slack)


def test_a_stream_goes_round_it_too(tmp_path):
    log = pushed(box_at(0.1), (0.05, 0.1), path=tmp_path / "log.nc")
    assert log.attrs["stopped"] == ""
    assert log.object_angle[-1].item() == pytest.approx(8.14054, abs=1e-5)
    log.close()


@METHODS
@SETS
@pytest.mark.parametrize(
    ("normal", "velocity", "law"),
    [((0, 1), (0.3, 0.1), 0.1), ((-1, 0), (-0.1, -0.3), 0.1), (BISECTOR, (0.03, 0.1), 0.3)],
)
def test_a_point_that_slips_off_a_corner_leaves_the_object_at_rest(
    method, effects, normal, velocity, law
):
    log = pushed(box_at(0.1, normal, law, effects), velocity, method=method)
    assert log.attrs["stopped"] == ""
    steps = 0 if method == "event-driven" else 1
    # Friction, of a torque of 0.0765 for a uniform square, uses up the energy of an impact.
    energy = 1e-3 * np.hypot(*velocity) ** 2 / 2 if effects is INERTIA else 0.0
    assert abs(log.object_angle[-1].item()) <= steps * 0.05 + np.rad2deg(energy / 0.0765)
    assert log.gap.values[-1] > 0.0
    assert not log.twist.values[-1].any()


@METHODS
@SETS
@pytest.mark.parametrize(
    ("normal", "velocity", "law", "angle"),
    [
        (BISECTOR, (-0.1, 0.1), 0.9, 0.0),
        ((0, 1), (0, 0.1), 2.0, 22.0),
        ((0, 1), (-0.03, 0.1), 5.0, 17.07),
    ],
)
def test_a_finger_that_sticks_to_a_corner_stays_there(
    method, effects, normal, velocity, law, angle
):
    log = pushed(box_at(0.1, normal, law, effects), velocity, method=method)
    assert log.attrs["stopped"] == ""
    assert log.object_angle[-1].item() == pytest.approx(angle, abs=5e-3)
    turn = np.deg2rad(log.object_angle.values) * 1j
    corner = log.object_position.values @ (1, 1j) + np.exp(turn) * (0.1 - 0.1j)
    finger = log.pusher_position.values @ (1, 1j)
    assert np.abs(corner - finger).max() < 1e-9


def test_a_finger_arrives_at_a_corner():
    log = pushed(box_at(0.1, law=0.5), (0, 0.1), gap=0.01)
    assert log.attrs["stopped"] == ""
    wanted = pushed(box_at(0.1, law=0.5), (0, 0.1))
    at = np.interp(0.7, wanted.time.values, wanted.object_angle.values)
    assert log.object_angle[-1].item() == pytest.approx(at, abs=1e-3)


def test_a_finger_that_passes_a_corner_meets_the_side_behind_it():
    """From 0.01 off the corner it comes to the side after 0.01 sqrt(1/2) / 0.1."""
    velocity, touches = (-0.1, 0.3), 0.1 * np.sqrt(0.5)
    log = pushed(box_at(0.1, BISECTOR, 0.5), velocity, gap=0.01)
    assert log.attrs["stopped"] == ""
    (lands,) = np.flatnonzero(log.event.values == pp.Event.TOUCHES)
    assert log.time.values[lands] == pytest.approx(touches, abs=1e-9)
    point = (0.1, -0.1 - 0.01 * np.sqrt(0.5) + 0.3 * touches)
    beside = pp.scene_at(point, effects=FRICTION, contact=pp.Coulomb(0.5), outline=BOX)
    finger = pp.Pusher(velocity=velocity, shape="finger", frame="world")
    wanted = pp.simulate(beside, finger, duration=0.8 - touches, object_pose=(0, 0, 0))
    assert log.object_angle[-1].item() == pytest.approx(wanted.object_angle[-1].item(), abs=1e-7)


@pytest.mark.parametrize("point", [(15, 0), (15, -1e-4), [(30, 0), (15, 1e-5)]])
def test_a_contact_at_an_inner_corner_has_the_bisector_as_its_normal(point):
    tee = {"effects": (pp.SupportFriction(support=pp.Polygon(TEE)),), "contact": pp.Coulomb(0.2)}
    scene = pp.scene_at(point, outline=TEE, **tee)
    normal = np.stack(scene.placement.normal, axis=-1).reshape(-1, 2)[-1]
    assert normal == pytest.approx([-np.sqrt(0.5), np.sqrt(0.5)])
    assert np.ravel(scene.slider.pocket)[-1] == pytest.approx(np.pi / 4)
    for other in ((0, 1), (1, 0), (0.6, 0.8)):
        with pytest.raises(pp.InvalidValue, match=r"normal: .* (leave the normal out|of the side)"):
            pp.scene_at(point, other, outline=TEE, **tee)


def test_a_rod_at_an_inner_corner_is_beside_the_bisector_of_its_sides():
    corners = [(-1, 0), (-0.8, 0.2), (-0.8, 1), (1, 1), (1, -1), (-0.8, -1), (-0.8, -0.2)]
    outer = pp.Slider(rod_length=1.0, rod_angle=np.pi / 2, outline=corners)
    assert len(outer.outline.corners) == 7
    assert outer.pocket == 0.0
    dented = [(0.5 if corner == (-1, 0) else corner[0], corner[1]) for corner in corners]
    outline = [(x - 2, y) for x, y in dented]
    for length in (-0.5 + 1e-7, np.array([0.1, -0.5])):
        slider = pp.Slider(rod_length=length + 2.0, rod_angle=np.pi / 2, outline=outline)
        assert np.ravel(slider.pocket)[-1] == pytest.approx(np.pi / 2 - np.arctan2(0.2, 1.3))
        with pytest.raises(pp.InvalidValue, match="bisector of the normals of both sides"):
            pp.Slider(rod_length=length + 2.0, rod_angle=np.pi / 3, outline=outline)


@METHODS
def test_a_point_that_slides_into_an_inner_corner_goes_on(method):
    tee = {"effects": (pp.SupportFriction(support=pp.Polygon(TEE)),), "contact": pp.Coulomb(0.0)}
    scene = pp.scene_at((30, 0), outline=TEE, **tee)
    finger = pp.Pusher(velocity=(-10, 1), frame="world", shape="finger")
    log = pp.simulate(scene, finger, duration=3.0, object_pose=(0, 0, 0), method=method)
    assert log.attrs["stopped"] == ""
    assert (log["mode"].values[-5:] == pp.ContactMode.STICK).all()
    assert abs(log.contact_position[-1].item()) == pytest.approx(15.0, abs=1e-6)


def test_proposed_pushes_at_corners_can_be_simulated():
    """The motion of a push that sticks at a corner is proposed there, with the normal of each side."""
    count = 0
    for corner in (0, 3):
        for normal in (1, -1):
            away = np.array(BOX[corner]) / 0.1
            inward = (0.0, -away[1]) if normal == 1 else (-away[0], 0.0)
            given = {"effects": FRICTION, "contact": pp.Coulomb(3.0), "outline": BOX}
            scene = pp.scene_at(BOX[corner], inward, **given)
            (solution,) = pp.solve(scene, np.deg2rad(85.0), 0.1)
            twist = scene.to_object(solution.twist, "twist")
            for push in pp.pushes_for(FRICTION, twist, BOX):
                near = np.abs(push.point - BOX[corner]).max() < 1e-9
                if not near or push.friction_coefficient > 2.9:
                    continue
                again = pp.scene_at(push.point, push.normal, **given)
                x, y = again.to_fence(push.velocity, "vector")
                ones = pp.solve(again, np.arctan2(y, x), np.hypot(x, y))
                errors = [abs(again.to_object(one.twist, "twist") - twist).max() for one in ones]
                assert min(errors) < 1e-9
                finger = pp.Pusher(velocity=(x, y), shape="finger")
                assert pp.simulate(again, finger, duration=0.1).attrs["stopped"] == ""
                count += 1
    assert count >= 4


class TestArraysOfContacts:
    POINTS = np.array([(0.1, -0.1), (0.0999, -0.1), (0.1 - 1e-7, -0.1), (0.03, -0.1)])

    def scenes(self, points, normals=(0, 1)):
        return pp.scene_at(points, normals, effects=FRICTION, contact=pp.Coulomb(0.1), outline=BOX)

    @pytest.mark.parametrize("radius", [0.0, 0.01])
    def test_a_finger_goes_round_the_corner_as_in_a_single_run(self, radius):
        finger = pp.Pusher(velocity=(0.05, 0.1), shape="finger", radius=radius)
        batch = pp.simulate_batch(self.scenes(self.POINTS), finger, duration=0.8)
        for i, point in enumerate(self.POINTS):
            log = pp.simulate(self.scenes(tuple(point)), finger, duration=0.8)
            turn = np.deg2rad((log.rod_angle[-1] - log.rod_angle[0]).item())
            assert np.deg2rad(
                (batch.rod_angle - batch.initial_rod_angle)[i].item()
            ) == pytest.approx(turn, abs=1e-12)
            assert batch.gap[i].item() == pytest.approx(log.gap[-1].item(), abs=1e-12)
            assert not batch.stopped[i].item()
            assert not batch.parted[i].item()

    @pytest.mark.parametrize("count", [1, 2, 4])
    def test_a_fence_pushes_a_side_as_in_a_single_run(self, count):
        """Any contact of a side that lies on the fence is the side."""
        points, fence = self.POINTS[:count], pp.Pusher(velocity=(0.05, 0.05))
        batch = pp.simulate_batch(self.scenes(points), fence, duration=1.0)
        for i, point in enumerate(points):
            log = pp.simulate(self.scenes(tuple(point)), fence, duration=1.0)
            assert log.flush.all()
            assert (batch.rod_angle == batch.initial_rod_angle)[i].item()
            for name in ("position", "slip"):
                wanted = log[name].values[-1]
                assert batch[name].values[i] == pytest.approx(wanted, rel=0, abs=1e-14)
            # The cone's edge is 0.1 beside the normal: it slips to the left.
            assert batch.slip[i].item() == pytest.approx(-0.045, abs=1e-12)

    def test_arrays_of_more_dimensions_are_refused(self):
        with pytest.raises(pp.InvalidValue, match=r"shapes: .* allowed: \(\) or \(scenes,\)"):
            pp.simulate_batch(
                self.scenes(self.POINTS[None]), pp.Pusher(velocity=(0, 0.05)), duration=1
            )

    @pytest.mark.parametrize("count", [1, 2, 5])
    def test_a_fence_at_corners_lies_down_on_sides_as_in_a_single_run(self, count):
        points, fence = np.array([BOX[1]] * count), pp.Pusher(velocity=(0.01, 0.05))
        normal = (-np.sin(0.5), np.cos(0.5))
        batch = pp.simulate_batch(self.scenes(points, normal), fence, duration=3.0)
        log = pp.simulate(self.scenes(BOX[1], normal), fence, duration=3.0)
        assert log.flush.any()
        assert batch.rod_angle.values == pytest.approx(log.rod_angle[-1].item(), rel=0, abs=1e-12)

    @pytest.mark.parametrize("count", [1, 2, 5])
    def test_a_fence_through_the_object_is_refused(self, count):
        """In all scenes of the array or in one alone: the stem is below a fence on the bar."""
        tee = {
            "effects": (pp.SupportFriction(support=pp.Polygon(TEE)),),
            "contact": pp.Coulomb(0.2),
        }
        fence, through = pp.Pusher(velocity=(0, 0.05)), (30, 0)
        for points in ([through] * count, [(0, -90)] * (count - 1) + [through]):
            scenes = pp.scene_at(np.array(points), outline=TEE, **tee)
            with pytest.raises(pp.InvalidValue, match="a point 90 below the fence"):
                pp.simulate_batch(scenes, fence, duration=0.2)

    def test_sides_of_ones_own_and_arrays_of_laws_are_as_they_were(self):
        slider = pp.Slider(
            rod_length=0.1, rod_angle=np.array([1.2, 1.5]), side=(-0.1, 0.02), radius=0.1
        )
        scene = pp.Scene(slider=slider, contact=pp.Coulomb(0.0), effects=(pp.RingFriction(),))
        finger = pp.Pusher(velocity=(0.1, 0.02), shape="finger")
        assert pp.simulate_batch(scene, finger, duration=1.0).parted.all()
        laws = pp.scene_at(
            (0.03, -0.1), effects=FRICTION, contact=pp.Coulomb(np.array([0.1, 0.2])), outline=BOX
        )
        assert len(laws.slider.outline_in_body().corners) == 4
        fence = pp.simulate_batch(laws, pp.Pusher(velocity=(0, 0.05)), duration=1.0)
        assert (fence.rod_angle == fence.initial_rod_angle).all()


def test_runs_at_corners_are_drawn_and_stored(tmp_path):
    for normal, velocity in (
        ((0, 1), (0.05, 0.1)),
        (BISECTOR, (0.03, 0.1)),
        (BISECTOR, (-0.1, 0.1)),
    ):
        scene = box_at(0.1, normal, 0.3)
        pp.save_scene(scene, tmp_path / "scene.yaml")
        assert pp.load_scene(tmp_path / "scene.yaml") == scene
        assert len(pp.plot_log(pushed(scene, velocity)).axes) > 1
