"""Models in which a finger follows the outline: around corners, along arcs, and back after a parting."""

from __future__ import annotations

import numpy as np
import pytest
from pushes.pushed_ellipse import push_ellipse, uniform_places
from pushes.written import SQUARE, touching, turn

import planar_pushing as pp
from planar_pushing.pushes.fit import limit_surface
from planar_pushing.pushes.fit.ellipsoid import Ellipsoid
from planar_pushing.pushes.fit.quartic import Quartic
from planar_pushing.pushes.fit.supported import OnSupport
from planar_pushing.pushes.logs.measured import measurements_of

ROUND, SKEW = (
    np.diag([1.0, 1.0, 0.5]),
    np.array([[1, 0.3, -0.2], [0.3, 0.7, 0.25], [-0.2, 0.25, 0.9]]),
)
PAIRS = np.einsum("ij,kl->ijkl", SKEW, SKEW)
MODELS = {
    "support": OnSupport(pp.Points(SQUARE, [1, 2, 1, 1])), "ellipsoid": Ellipsoid(SKEW),
    "quartic": Quartic((PAIRS + PAIRS.transpose(0, 2, 1, 3) + PAIRS.transpose(0, 3, 2, 1)) / 3.0),
}  # fmt: skip
MODEL = pytest.mark.parametrize("name", MODELS)


def regular(count, angle):
    """Corners on the unit circle, the first at an angle."""
    angles = angle + 2.0 * np.pi * np.arange(count) / count
    return np.column_stack([np.cos(angles), np.sin(angles)])


def along(angle):
    """Unit vector."""
    return np.array([np.cos(angle), np.sin(angle)])


HEXAGON, DOZEN = regular(6, np.pi / 3.0), regular(12, np.pi / 12.0)
BOX = 0.1 * np.array(SQUARE)
LOW = np.deg2rad(-75.0)
#: Outline, support, contact, normal, velocity in the frame of the contact, duration, radius, friction, and
#: the pose at the end: by integrations of the full pose with the nearest point of the outline, and
#: for a ring with elliptic integrals.
ENDS = {
    "a mug that slips away": (
        pp.Disc(0.04), pp.Ring(0.04), 0.04 * along(LOW), -along(LOW), (0.02, 0.05), 2.0, 0.008, 0.1,
        (-0.0247368076, 0.0473748111, np.deg2rad(15.552942592)),
    ),
    "a mug": (
        pp.Disc(0.04), pp.Ring(0.04), 0.04 * along(LOW), -along(LOW), (0.02, 0.05), 2.0, 0.008, 0.4,
        (-0.0222303647, 0.0680912296, np.deg2rad(49.388399592)),
    ),
    "around the corner of a square": (
        SQUARE, pp.Polygon(SQUARE), (0.6, -1.0), (0.0, 1.0), (0.9, 1.0), 2.0, 0.5, 0.2,
        (-0.0235642668, 0.4120213289, 0.5503997571),
    ),
    "around the corner of a hexagon": (
        HEXAGON, pp.Polygon(HEXAGON), (0.4, -np.sqrt(0.75)), (0.0, 1.0), (0.45, 1.0), 2.0, 0.3, 0.1,
        (-0.21179966, 0.61002822, 0.78735561),
    ),
    "off the corner of a hexagon": (
        HEXAGON, pp.Polygon(HEXAGON), (0.4, -np.sqrt(0.75)), (0.0, 1.0), (0.45, 1.0), 2.0, 0.0, 0.1,
        (-0.10961034, 0.43511051, 0.57266291),
    ),
    "past the corner of a dodecagon": (
        DOZEN, pp.Ring(1.0), (0.1, -np.cos(np.pi / 12.0)), (0.0, 1.0), (0.5, 1.0), 1.2, 0.0, 0.1,
        (-0.1047392052, 0.7806176454, 0.3317569126),
    ),
    "from a corner on": (
        BOX, pp.Polygon(BOX), (0.1, -0.1), (0.0, 1.0), (0.05, 0.1), 0.9, 0.01, 0.1,
        (None, None, np.deg2rad(18.81252193)),
    ),
    "a point from a corner on": (
        BOX, pp.Polygon(BOX), (0.1, -0.1), (0.0, 1.0), (0.05, 0.1), 0.9, 0.0, 0.1,
        (None, None, np.deg2rad(8.14054)),
    ),
}  # fmt: skip


@pytest.mark.parametrize("scene", ENDS)
def test_final_poses_on_a_support(scene):
    outline, support, point, normal, velocity, duration, radius, mu, end = ENDS[scene]
    axes = np.array([(normal[1], -normal[0]), normal])
    pushes = touching(outline, point, normal, duration * np.array(velocity) @ axes, radius)
    pose = OnSupport(support).poses(pushes, mu)[0]
    size = pushes.size
    if end[0] is not None:
        assert pose[:2] == pytest.approx(end[:2], abs=1e-5 * size)
    assert pose[2] == pytest.approx(end[2], abs=1e-5)


#: Outlines, first contacts, and radii of pushes without friction and rotation, of a disc of radius 1 and of
#: a hole of radius 0.8 in one, and the displacement for a path of 1.5 or 0.7 upward, in closed form.
SLIDES = {
    "a disc": (pp.Disc(1.0), along(np.deg2rad(-100.0)), 0.25, 1.5, (0.4526176399, 1.3244672441)),
    "a hole": (
        pp.Outline(pp.Disc(1.0), holes=[pp.Disc(0.8)]), 0.8 * along(np.deg2rad(50.0)), 0.3, 0.7,
        (0.2323571095, 0.5910136171),
    ),
}  # fmt: skip


@pytest.mark.parametrize(
    "model", [OnSupport(pp.Disc(1.0)), Ellipsoid(ROUND)], ids=["support", "ellipsoid"]
)
@pytest.mark.parametrize("wall", SLIDES)
def test_slides_along_an_arc_in_closed_form(model, wall):
    outline, point, radius, distance, displacement = SLIDES[wall]
    normal = point / np.hypot(*point) * (1.0 if wall == "a hole" else -1.0)
    pushes = touching(outline, point, normal, (0.0, distance), radius)
    pose = model.poses(pushes, 0.0)[0]
    assert pose == pytest.approx([*displacement, 0.0], abs=1e-4)


def by_small_steps(matrix, axes, start, direction, distance, mu, steps=3000):
    """Pose of an ellipse on an ellipsoid after a point finger has moved, by the cases of Coulomb's law."""
    pose, place = np.zeros(3), start
    for _ in range(steps):
        finger = turn(pose[2]).T @ (direction * distance / steps)
        contact = axes * along(place)
        tangent = axes * (-np.sin(place), np.cos(place))
        speed = np.hypot(*tangent)
        tangent = tangent / speed
        normal = np.array([-tangent[1], tangent[0]])
        reach = np.array([[1.0, 0.0, -contact[1]], [0.0, 1.0, contact[0]]])
        mobility = reach @ matrix @ reach.T
        force = np.linalg.solve(mobility, finger)
        sign = np.sign(force @ tangent)
        if abs(force @ tangent) > mu * (force @ normal):
            edge = normal + mu * sign * tangent
            force = edge * (finger @ normal) / (normal @ mobility @ edge)
        if force @ normal <= 0.0:
            break
        twist = matrix @ reach.T @ force
        place += (finger - mobility @ force) @ tangent / speed
        pose = pose + np.append(turn(pose[2]) @ twist[:2], twist[2])
    return pose


@pytest.mark.parametrize("mu", [0.0, 0.15])
@pytest.mark.parametrize("matrix", [ROUND, SKEW], ids=["round", "skew"])
@pytest.mark.parametrize("start", [0.3, 1.9, 4.4])
def test_an_ellipsoid_pushed_along_an_ellipse(matrix, start, mu):
    axes = np.array([1.3, 1.0])
    inward = -axes[::-1] * along(start)
    direction = turn(0.6) @ (inward / np.hypot(*inward))
    end = by_small_steps(matrix, axes, start, direction, 0.6, mu)
    pushes = touching(
        pp.Outline.ellipse(*axes), axes * along(start), inward / np.hypot(*inward), 0.6 * direction
    )
    assert Ellipsoid(matrix).poses(pushes, mu)[0] == pytest.approx(end, abs=6e-4)


@MODEL
@pytest.mark.parametrize("way", [(0.9, 0.6), (0.5, 1.2), (-0.9, 0.5)])
def test_a_smooth_disc_moves_the_object_as_a_point_moves_the_grown_one(name, way):
    """The force is along the normal, through both contacts."""
    radius = 0.4
    grown = pp.rounded((1.0 + radius) * np.array(SQUARE), radius)
    disc = touching(SQUARE, (0.7, -1.0), (0.0, 1.0), way, radius)
    point = touching(grown, (0.7, -1.0 - radius), (0.0, 1.0), way)
    poses = [MODELS[name].poses(pushes, 0.0)[0] for pushes in (disc, point)]
    assert poses[0] == pytest.approx(poses[1], abs=1e-5)
    assert np.hypot(*poses[0][:2]) > 0.1


@MODEL
@pytest.mark.parametrize("radius", [0.0, 0.2])
@pytest.mark.parametrize("outline", [SQUARE, pp.Disc(1.0)], ids=["square", "disc"])
def test_a_finger_that_parts_and_returns_elsewhere(name, outline, radius):
    """The second push is that of the object where the first one has left it."""
    step, mu = 0.1, 0.2
    legs = [(0, step)] * 2 + [(0, -step)] + [(-step, 0)] * 2 + [(0, step)] * 3
    whole = touching(outline, (0.0, -1.0), (0.0, 1.0), legs, radius)
    first = MODELS[name].poses(
        touching(outline, (0.0, -1.0), (0.0, 1.0), (0, 2 * step), radius), mu
    )[0]
    start = np.array([0.0, -1.0 - radius]) + np.sum(legs[:5], axis=0)
    local = turn(-first[2]) @ (start - first[:2])
    up = turn(-first[2]) @ (0.0, 3 * step)
    touch = pp.first_touch(outline, local, up, radius)
    rest = (1.0 - touch.fraction) * up
    second = MODELS[name].poses(touching(outline, touch.contact, touch.normal, rest, radius), mu)[0]
    end = [*(first[:2] + turn(first[2]) @ second[:2]), first[2] + second[2]]
    assert 0.0 < touch.fraction < 1.0
    slack = 1e-5 if name == "support" else 2e-3
    assert MODELS[name].poses(whole, mu)[0] == pytest.approx(end, abs=slack)


@pytest.mark.parametrize(("radius", "reach"), [(0.0, 0.5), (0.1, 0.4), (0.25, 0.25)])
def test_a_finger_in_a_notch_stops_where_it_touches_two_sides(radius, reach):
    """In the notch of an L, it comes no closer to the corner than its radius; then the object rests."""
    ell = [(-1, -1), (1, -1), (1, 0), (0, 0), (0, 1), (-1, 1)]
    pushes = touching(
        ell, [(0.0, 0.5), (0.5, 0.0)], [(-1.0, 0.0), (0.0, -1.0)],
        np.array([(-0.01, -0.5), (-0.5, -0.01)])[:, None], radius,
    )  # fmt: skip
    meets = touching(
        ell, pushes.contact, pushes.normal, 2.0 * reach * pushes.path, radius
    )  # fmt: skip
    for model, slack in ((OnSupport(pp.Points(ell, [1] * 6)), 1e-6), (Ellipsoid(ROUND), 0.01 / 60)):
        poses = model.poses(pushes, 0.0)
        assert poses == pytest.approx(model.poses(meets, 0.0), abs=slack)
        # The finger does little more than slide.
        assert np.abs(poses).max() < 0.02
        assert np.abs(poses).max(axis=1).min() > 0.001


@MODEL
def test_a_push_that_begins_at_an_inner_corner_has_a_pose(name):
    tee = [(-2, 0), (-2, 1), (2, 1), (2, 0), (0.5, 0), (0.5, -2), (-0.5, -2), (-0.5, 0)]
    pushes = touching(tee, [(0.5, 0.0)] * 2, [(0.0, 1.0), (-1.0, 0.0)], (-0.1, 0.2))
    assert np.isfinite(MODELS[name].poses(pushes, 0.2)).all()


@MODEL
@pytest.mark.parametrize("turned", [0, 1, 2, 3])
def test_pushes_of_a_corner(name, turned):
    """With much friction the corner goes with the finger, and with little the finger goes along a side."""
    matrix = turn(turned * np.pi / 2.0)
    corner, way = np.array([1.0, 1.0]), np.array([-0.3, -0.1])
    bisector = -np.sqrt([0.5, 0.5])
    square = np.array(SQUARE) @ matrix.T
    model = MODELS[name] if name == "support" else Ellipsoid(ROUND)
    for radius in (0.0, 0.3):
        pushes = touching(square, matrix @ corner, matrix @ bisector, matrix @ way, radius)
        x, y, angle = model.poses(pushes, 1e6)[0]
        end = turn(angle) @ matrix @ corner + [x, y]
        # A round finger rolls around the corner and keeps its distance from it.
        center = matrix @ (corner - radius * bisector + way)
        assert np.hypot(*(end - center)) == pytest.approx(radius, abs=2e-3)
        assert abs(model.poses(pushes, 0.05)[0][2]) > 0.01


def test_more_steps_change_little(monkeypatch):
    pushes = touching(SQUARE, (0.6, -1.0), (0.0, 1.0), (0.6, 0.6), 0.3)
    few = Ellipsoid(SKEW).poses(pushes, 0.2)
    monkeypatch.setattr(limit_surface, "STEPS", 2000)
    assert Ellipsoid(SKEW).poses(pushes, 0.2) == pytest.approx(few, abs=5e-3)


#: Half axes of an ellipse with a uniform pressure in mm, standard deviations of the noise, and the truth.
AXES, NOISE, MU = np.array([65.445, 52.5]), np.array([0.1, 0.1, np.deg2rad(0.1)]), 0.15


def ellipse_pushes(count, distance, random):
    """Places of a uniform pressure, contacts, directions, and the poses after pushes that slip along it."""
    places = uniform_places(AXES, 10, 24)
    start = 6.0 * np.pi * (np.arange(count) + 0.3) / count
    contact = AXES * np.column_stack([np.cos(start), np.sin(start)])
    inward = -contact / AXES**2
    inward /= np.hypot(*inward.T)[:, None]
    lean = random.choice([-1.0, 1.0], count) * random.uniform(0.35, 0.87, count)
    direction = np.array([turn(a) @ n for a, n in zip(lean, inward, strict=True)])
    poses, last = push_ellipse(AXES, places, MU, start, direction, distance, steps=40)
    assert (np.abs(last - start) > 2.0 * np.pi / 48).sum() > 0.2 * count
    # The predictions of the true support, without noise.
    exact = touching(pp.Outline.ellipse(*AXES), contact, inward, distance * direction[:, None])
    truth = OnSupport(pp.Points(places, np.ones(len(places)))).poses(exact, MU)
    assert truth == pytest.approx(poses, abs=2e-3)
    return places, contact, direction, poses


def test_an_ellipse_with_a_uniform_pressure_pushed_along_it():
    """A point slips by up to 18 mm along it: sums and Newton's method against the library."""
    ellipse_pushes(5, 20.0, np.random.default_rng(0))


@pytest.mark.slow
def test_identify_the_friction_of_an_ellipse():
    count, distance = 24, 20.0
    random = np.random.default_rng(0)
    places, contact, direction, poses = ellipse_pushes(count, distance, random)
    pushes = pp.pushes_from_poses(
        outline=pp.Outline.ellipse(*AXES, arcs=48), poses_before=np.zeros((count, 3)),
        poses_after=poses + NOISE * random.normal(size=poses.shape), finger_start=contact - direction,
        finger_end=contact + distance * direction, noise=(0.1, 0.1, 0.0),
    )  # fmt: skip
    found = pp.identify(pushes, family="ellipse", resamples=100)
    low, high = found.intervals["contact_friction"]
    assert low < MU < high
    assert high - low < 0.01
    low, high = found.intervals["spin_torque"]
    assert low < np.hypot(*places.T).mean() < high
    assert high - low < 1.0
    measured = measurements_of(pushes)
    errors = OnSupport(found.support).poses(measured, found.contact_friction) - measured.observed
    # Two standard deviations of chi square for 72 numbers of which 4 are fitted.
    assert ((errors / NOISE) ** 2).sum() / (3 * count - 4) == pytest.approx(1.0, abs=0.34)


TEE = 10.0 * np.array(
    [(-6, 0), (-6, 3), (6, 3), (6, 0), (1.5, 0), (1.5, -9), (-1.5, -9), (-1.5, 0)]
)
#: Outlines, feet and pushes: contacts, directions of the finger, and its radius.
OBJECTS = {
    "a finger passes corners of a T": (
        TEE, [(-50, 15), (50, 15), (0, -70)],
        [(60, 8), (60, 10), (-60, 8), (-60, 10), (-55, 30), (55, 30), (-8, -90), (8, -90)],
        [(-20, -14), (-20, -12), (20, -14), (20, -12), (-12, -20), (12, -20), (-12, 20), (12, 20)], 5.0,
    ),
    "a mug": (
        pp.Disc(40.0), 30.0 * regular(6, 0.2), 40.0 * regular(8, 0.1),
        [turn(0.7 * (-1) ** k) @ way for k, way in enumerate(-25.0 * regular(8, 0.1))], 6.0,
    ),
}  # fmt: skip


@pytest.mark.parametrize("kind", OBJECTS)
def test_identify_where_fingers_go_around(kind):
    """From simulations one by one."""
    outline, feet, points, ways, radius = OBJECTS[kind]
    random = np.random.default_rng(1)
    friction = (pp.SupportFriction(support=pp.Points(feet)),)
    starts, ends, poses, pieces = [], [], [], []
    for point, way in zip(np.array(points, dtype=float), np.array(ways), strict=True):
        scene = pp.scene_at(point, effects=friction, contact=pp.Coulomb(0.15), outline=outline)
        finger = pp.Pusher(velocity=tuple(way), shape="finger", radius=radius, frame="world")
        log = pp.simulate(scene, finger, duration=1.0, object_pose=(0, 0, 0))
        assert log.attrs["stopped"] == ""
        turned = np.deg2rad(log["object_angle"].values[-1])
        poses.append([*log["object_position"].values[-1], turned])
        starts.append(log["pusher_position"].values[0])
        ends.append(log["pusher_position"].values[-1])
        pieces.append(len(set(log["contact_piece"].values.tolist()) - {-1}))
    assert kind == "a mug" or np.sum(np.array(pieces) > 1) >= 4
    pushes = pp.pushes_from_poses(
        outline=outline, poses_before=np.zeros((8, 3)),
        poses_after=poses + NOISE * random.normal(size=(8, 3)),
        finger_start=starts, finger_end=ends, finger_radius=radius, noise=(0.1, 0.1, 0.0),
    )  # fmt: skip
    found = pp.identify(pushes, known=feet, resamples=50)
    assert found.contact_friction == pytest.approx(0.15, abs=0.01)
    measured = measurements_of(pushes)
    errors = OnSupport(found.support).poses(measured, found.contact_friction) - measured.observed
    assert np.sqrt(((errors / NOISE) ** 2).mean()) < 1.3
