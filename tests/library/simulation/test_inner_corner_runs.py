"""A point in an inner corner over time: it sticks there, arrives along a side, and leaves along a side."""

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.mechanics.outline import require_outline
from planar_pushing.mechanics.outline.places import nearest_place

#: The T of the PushT task, in millimeters, and another T.
T = [(-60, 0), (-60, 30), (60, 30), (60, 0), (15, 0), (15, -90), (-15, -90), (-15, 0)]
OTHER_T = [(-2, -1), (2, -1), (2, 0), (0.5, 0), (0.5, 3), (-0.5, 3), (-0.5, 0), (-2, 0)]
METHODS = [({}, 1e-7), ({"method": "time-stepping", "step": 0.01}, 2e-3)]


def scene_of(outline, point, mu=0.2, effects=()):
    """A uniform object, pushed at a point."""
    return pp.scene_at(
        point,
        outline=outline,
        contact=pp.Coulomb(mu),
        effects=[pp.SupportFriction(support=pp.Polygon(outline)), *effects],
    )


def run(scene, velocity, duration, **options):
    """A run of a point with a velocity in the world, whose axes are at first those of the object."""
    pusher = pp.Pusher(shape="finger", radius=0.0, velocity=velocity, frame="world")
    return pp.simulate(scene, pusher, duration=duration, object_pose=(0, 0, 0), **options)


def finger_in_object(log):
    """Position of the finger in the object's frame, at each time."""
    away = log.pusher_position.values - log.object_position.values
    angle = np.deg2rad(log.object_angle.values)
    c, s = np.cos(angle), np.sin(angle)
    return np.stack([c * away[:, 0] + s * away[:, 1], c * away[:, 1] - s * away[:, 0]], axis=-1)


@pytest.mark.parametrize(("options", "error"), METHODS)
@pytest.mark.parametrize(
    ("outline", "point", "mu", "velocity", "duration", "pose"),
    [
        (T, (15.0, 0.0), 0.2, (-10, 10), 3.0, (-28.70529, 23.90369, 23.98020)),
        (OTHER_T, (0.5, 0.0), 0.3, (-0.6, -0.8), 2.5, (-1.3688358, -1.6624202, -42.466552)),
    ],
)
def test_a_point_stays_in_the_corner(options, error, outline, point, mu, velocity, duration, pose):
    log = run(scene_of(outline, point, mu), velocity, duration, **options)
    assert (log["mode"] == pp.ContactMode.STICK).all()
    assert finger_in_object(log) == pytest.approx(np.broadcast_to(point, (len(log.time), 2)))
    reached = [*log.object_position.values[-1], float(log.object_angle[-1])]
    assert reached == pytest.approx(pose, rel=max(error, 1e-6))


@pytest.mark.parametrize(("options", "error"), METHODS)
def test_it_leaves_along_a_side_when_its_force_reaches_the_outer_edge(options, error):
    log = run(scene_of(OTHER_T, (0.5, 0.0), 0.3), (-0.6, -0.8), 3.2, **options)
    slips = log["mode"].values == pp.ContactMode.SLIP_RIGHT
    assert slips[-1]
    left = float(log.time[slips.argmax()])
    assert 2.7 < left < 2.9
    # It is on the bar, to the right of the corner.
    x, y = finger_in_object(log)[-1]
    assert x > 0.5 + 1e-3
    assert y == pytest.approx(0.0, abs=1e-9)
    assert log.contact_piece[-1] != log.contact_piece[0]


@pytest.mark.parametrize(("options", "error"), METHODS)
def test_it_goes_through_the_corner_from_one_side_to_the_other(options, error):
    log = run(scene_of(T, (15.0, -20.0), 0.1), (-10.0, 25.0), 4.0, **options)
    x, y = finger_in_object(log).T
    modes = log["mode"].values
    on_stem, on_bar = y < -1e-6, x > 15.0 + 1e-6
    in_corner = ~on_stem & ~on_bar
    # Each of the three for a while, in this order.
    order = np.select([on_stem, in_corner], [0, 1], 2)
    assert (np.diff(order) >= 0).all()
    assert [int((order == k).sum() > 3) for k in range(3)] == [1, 1, 1]
    assert x[on_stem] == pytest.approx(15.0, abs=1e-6)
    assert y[on_bar] == pytest.approx(0.0, abs=1e-6)
    assert (modes[1:][in_corner[1:] & in_corner[:-1]][:-1] == pp.ContactMode.STICK).all()


@pytest.mark.parametrize(("options", "error"), METHODS)
def test_a_run_from_the_corner_separates_where_the_point_leaves_both_sides(options, error):
    log = run(scene_of(T, (15.0, 0.0)), (3.0, -5.0), 1.0, **options)
    assert (log["mode"] == pp.ContactMode.SEPARATE).all()
    assert log.object_angle.values == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize("seed", range(6))
def test_steps_approach_events_from_a_corner(seed):
    rng = np.random.default_rng([seed, 3])
    velocity = 20.0 * np.array([-np.cos(a := rng.uniform(-0.7, 2.0)), np.sin(a)])
    scene = scene_of(T, (15.0, 0.0), float(rng.choice([0.05, 0.2, 0.5])))
    exact = run(scene, tuple(velocity), 2.0)
    errors = []
    for step in (0.02, 0.005):
        log = run(scene, tuple(velocity), 2.0, method="time-stepping", step=step)
        away = log.object_position.values[-1] - exact.object_position.values[-1]
        turned = np.deg2rad(float(log.object_angle[-1] - exact.object_angle[-1]))
        errors.append(np.hypot(*away) / 60.0 + abs(turned))
    assert errors[1] < 0.4 * errors[0] + 1e-9
    assert errors[0] < 0.02
    gaps = nearest_place(require_outline(T), finger_in_object(exact)).gap
    assert gaps.min() > -1e-9 * 120.0


def test_a_batch_stands_for_its_runs():
    mu = np.array([0.05, 0.2, 0.6])
    scenes = scene_of(T, (15.0, 0.0), mu)
    pusher = pp.Pusher(shape="finger", radius=0.0, velocity=(-10.0, 10.0))
    batch = pp.simulate_batch(scenes, pusher, duration=3.0)
    for i, friction in enumerate(mu):
        alone = pp.simulate(scene_of(T, (15.0, 0.0), float(friction)), pusher, duration=3.0)
        assert float(batch.rod_angle[i]) == pytest.approx(float(alone.rod_angle[-1]), abs=1e-9)


@pytest.mark.parametrize("method", [{}, {"method": "time-stepping", "step": 0.01}])
def test_with_inertia_a_point_in_a_corner_is_a_stop(method):
    scene = scene_of(T, (15.0, 0.0), effects=[pp.Inertia()])
    with pytest.warns(pp.EarlyEndWarning, match="touches the object at two places"):
        run(scene, (-10.0, 10.0), 1.0, **method)


@pytest.mark.parametrize(
    ("pusher", "said"),
    [
        (pp.Pusher(velocity=(0, 1)), "a finger of radius 0"),
        (pp.Pusher(velocity=(0, 1), shape="finger", radius=5.0), "a finger outside the object"),
    ],
)
def test_other_pushers_are_refused_in_a_corner(pusher, said):
    with pytest.raises(pp.InvalidValue, match=said):
        pp.simulate(scene_of(T, (15.0, 0.0)), pusher, duration=1.0)


def test_the_policy_decides_between_sticking_and_leaving():
    corners = [(0, 0), (3, 0), (3, 2.5), (1.2, 0.8), (1, 3), (0, 3)]
    scene, modes = scene_of(corners, (1.2, 0.8), mu=2.0), {}
    found = [solution.mode for solution in pp.solve(scene, float(np.arctan2(-1.0, 0.3)))]
    assert found == [pp.ContactMode.SEPARATE, pp.ContactMode.STICK]
    for policy in ("keep-contact", "separate"):
        pusher = pp.Pusher(shape="finger", radius=0.0, velocity=(0.3, -1.0))
        log = pp.simulate(scene, pusher, duration=0.5, on_ambiguity=policy)
        modes[policy] = set(log["mode"].values)
    assert modes == {
        "keep-contact": {pp.ContactMode.STICK},
        "separate": {pp.ContactMode.SEPARATE},
    }


def test_a_point_that_approaches_one_side_does_not_separate():
    scene = scene_of(T, (15.0, 0.0))
    # Away from the corner along its bisector, but toward the bar.
    assert scene.to_fence(np.array([3.0, 1.0]), "vector")[1] < 0.0
    for options in ({}, {"method": "time-stepping"}):
        log = run(scene, (3.0, 1.0), 0.5, on_ambiguity="separate", **options)
        assert (log["mode"] == pp.ContactMode.SLIP_LEFT).all()
        assert float(log.object_angle[-1]) > 0.1
