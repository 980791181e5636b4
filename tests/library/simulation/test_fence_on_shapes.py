"""Fences on arcs, corners and sides of an outline: values found without pieces, and closed forms."""

from __future__ import annotations

import numpy as np
import pytest
from numpy import cos, pi, sin, sqrt
from simulation.runs import pose_at_the_end

import planar_pushing as pp

SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
TILT = np.deg2rad(20)
ROUNDED = pp.rounded(SQUARE, 0.1)
DISC = pp.Outline(pp.Disc(1.0))


def scene_of(outline, effects, law, point, tilt=0.0):
    """A scene of an object turned by an angle, whose fence is along the x axis of the world."""
    law = law if isinstance(law, pp.PerfectlyRough) else pp.Coulomb(law)
    normal = (sin(tilt), cos(tilt))
    return pp.scene_at(point, normal, effects=effects, contact=law, outline=outline)


def push(scene, velocity, duration, tilt=0.0, **options):
    fence = pp.Pusher(velocity=velocity, frame="world")
    pose = (0, 0, tilt)
    return pp.simulate(scene, fence, duration=duration, object_pose=pose, **options)


def friction(support):
    return (pp.SupportFriction(support=support),)


def on_disc(law):
    return scene_of(pp.Disc(1.0), friction(pp.Ring(1.0)), law, (0, -1))


def on_square(radius, law):
    """A square turned by 20 degrees; its corner below is rounded."""
    corner = radius - 1
    point = (corner - radius * sin(TILT), corner - radius * cos(TILT))
    outline = pp.rounded(SQUARE, radius) if radius else SQUARE
    return scene_of(outline, friction(pp.Polygon(SQUARE)), law, point, TILT)


#: A scene, velocity, duration and angle at the start; the pose at the end, with the rotation, and the time
#: from which a side is flush. Those of a disc are constant twists; those of squares follow the lowest point
#: of the outline in an integration of the pose alone.
RUNS = {
    "disc that rolls": (
        on_disc(0.5), (0.3, 1), 2.0, 0.0, (0.2019895310, 2, 0.3980104690), None,
    ),
    "disc that slips": (
        on_disc(0.2), (1, 1), 2.0, 0.0, (0.4, 2, 0.7578228629), None,
    ),
    "rounded square": (
        on_square(0.1, 0.5), (0, 1), 6.0, TILT, (0.3356578664, 5.7464585123, 0), 0.99270865,
    ),
    "smooth rounded square": (
        on_square(0.1, 0.2), (-1, 1), 6.0, TILT, (-1.1477044668, 5.7464585123, 0), 0.4979630176,
    ),
    "square": (
        on_square(0.0, 0.5), (0, 1), 6.0, TILT, (0.3042988, 5.7182872, 0), 0.9193869,
    ),
    "square that slips": (
        on_square(0.0, 0.5), (0.4, 1), 6.0, TILT, (2.4250406, 5.7182872, 0), 1.8054820,
    ),
    "square that turns the other way": (
        on_square(0.0, 0.5), (1, 1), 6.0, TILT, (2.4478320, 5.7182872, pi / 2), 2.1655623,
    ),
    "smooth square": (
        on_square(0.0, 0.2), (-1, 1), 6.0, TILT, (-1.1423236, 5.7182872, 0), 0.5130504,
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", RUNS)
def test_a_fence_rolls_and_slips_over_an_outline(name):
    scene, velocity, duration, tilt, pose, flush = RUNS[name]
    log = push(scene, velocity, duration, tilt)
    slack = 1e-9 if "round" in name or "disc" in name else 6e-8  # the digits that are published
    assert log.attrs["stopped"] == ""
    assert pose_at_the_end(log) == pytest.approx(pose, rel=0, abs=slack)
    assert (log.gap.values == 0.0).all()
    if flush is None:
        assert not log.flush.any()
        return
    lies = log.time.values[np.flatnonzero(log.flush.values)[0]]
    assert lies == pytest.approx(flush, abs=max(slack, 6e-9))


@pytest.mark.parametrize(
    ("law", "velocity", "place"), [(0.5, (0.3, 1), -0.3980104690), (0.2, (1, 1), -1.6)]
)
def test_the_contact_of_a_disc_moves_along_the_fence(law, velocity, place):
    log = push(on_disc(law), velocity, 2.0)
    assert log.contact_position.values[-1] == pytest.approx(place, abs=1e-9)


@pytest.mark.parametrize("name", RUNS)
def test_steps_go_over_an_outline_with_an_error_of_first_order(name):
    """A constant twist is exact. A side lies down within a step, so that the step bounds the error."""
    scene, velocity, duration, tilt, pose, _ = RUNS[name]
    for step in (8e-3, 4e-3, 2e-3, 1e-3, 5e-4):
        log = push(scene, velocity, duration, tilt, method="time-stepping", step=step)
        assert log.attrs["stopped"] == ""
        error = np.abs(pose_at_the_end(log) - pose).max()
        assert error < (1e-10 if "disc" in name else 0.3 * step)


def test_a_small_radius_tends_to_a_corner():
    sharp = pose_at_the_end(push(on_square(0.0, 0.5), (0, 1), 6.0, TILT))
    errors = [
        np.abs(pose_at_the_end(push(on_square(radius, 0.5), (0, 1), 6.0, TILT)) - sharp).max()
        for radius in (2e-3, 1e-3)
    ]
    assert errors[0] / errors[1] == pytest.approx(2.0, abs=0.01)


def test_an_eccentric_disc_rolls_over_a_fence_under_gravity():
    """By a quadrature of the integral of energy: it begins with its mass center above, and passes over."""
    center = (0.4, 0.0)
    falls = (pp.Inertia(mass=1.0, gyration_radius=sqrt(0.3), center=center),
             pp.Load(force=(-1, 0), center=center))  # fmt: skip
    scene = scene_of(pp.Disc(1.0), falls, pp.PerfectlyRough(), (-1, 0), pi / 2)
    log = push(scene, (0, 0), 6.0, pi / 2, twist=(-0.9 * 1.4, 0, 0.9))
    assert log.attrs["stopped"] == ""
    assert pose_at_the_end(log)[2] == pytest.approx(9.0552278598, abs=1e-9)
    assert log.twist.values[-1, 2] == pytest.approx(1.1570998297, abs=1e-9)
    # Neither slip nor penetration: the center of the disc stays one radius above the fence.
    turn = np.deg2rad(log.object_angle.values)
    assert log.object_position.values == pytest.approx(
        np.stack([-(turn - pi / 2), 0 * turn], axis=-1), abs=1e-8
    )


@pytest.mark.parametrize("massive", [False, True], ids=["friction", "both"])
@pytest.mark.parametrize("shape", ["rounded", "disc", "square"])
def test_an_array_of_contacts_under_a_fence_moves_as_each_alone(shape, massive):
    outline = {"rounded": ROUNDED, "disc": DISC, "square": pp.Outline(SQUARE)}[shape]
    effects = friction(pp.Polygon(SQUARE) if shape != "disc" else pp.Disc(1.0))
    effects += (pp.Inertia(mass=1.0, gyration_radius=0.8),) * massive
    tilts = np.array([0.1, 0.4, 1.2, 2.0, -0.7])
    normals = np.stack([sin(tilts), cos(tilts)], axis=-1)
    radius = {"rounded": 0.1, "disc": 1.0, "square": 0.0}[shape]
    corners = (1 - radius) * np.sign(-normals)
    points = corners - radius * normals
    law, fence = pp.Coulomb(0.3), pp.Pusher(velocity=(0.3, 1.0))

    def scene(points, normals):
        return pp.scene_at(points, normals, effects=effects, contact=law, outline=outline)

    batch = pp.simulate_batch(scene(points, normals), fence, duration=3.0)
    lies = 0
    for i, (point, normal) in enumerate(zip(points, normals, strict=True)):
        log = pp.simulate(scene(tuple(point), tuple(normal)), fence, duration=3.0)
        assert log.attrs["stopped"] == ""
        lies += log.flush.any().item()
        for name in ("position", "rod_angle", "slip", "gap"):
            wanted = log[name].values[-1]
            assert batch[name].values[i] == pytest.approx(wanted, rel=0, abs=1e-9)
    assert (lies > 0) == (shape != "disc")


@pytest.mark.parametrize("step", [2e-3, 1e-3])
@pytest.mark.parametrize("radius", [0.02, 0.1, 0.15])
@pytest.mark.parametrize("tilt", [-20.0, 8.0, 20.0])
def test_in_steps_a_side_between_arcs_lies_down_after_an_impact(tilt, radius, step):
    """The far arc of a side arrives before it is parallel to the fence: its end is then a corner."""
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    normal = np.array([np.sin(np.deg2rad(tilt)), np.cos(np.deg2rad(tilt))])
    center = np.array([-np.sign(tilt) * (1.0 - radius), -1.0 + radius])
    scene = pp.scene_at(
        tuple(center - radius * normal),
        outline=pp.rounded(corners, radius),
        contact=pp.Coulomb(0.5),
        effects=[pp.SupportFriction(support=pp.Polygon(corners)), pp.Inertia(gyration_radius=0.8)],
    )
    pusher = pp.Pusher(velocity=(0, 1))
    exact = pp.simulate(scene, pusher, duration=3.0)
    log = pp.simulate(scene, pusher, duration=3.0, method="time-stepping", step=step)
    assert log.attrs["stopped"] == exact.attrs["stopped"] == ""
    assert bool(log.flush[-1]) == bool(exact.flush[-1])
    assert float(log.rod_angle[-1]) == pytest.approx(float(exact.rod_angle[-1]), abs=1e-6)
    away = log.position.values[-1] - exact.position.values[-1]
    # The instant of an impact within its step decides how far the side slips.
    assert np.hypot(*away) < 0.01


@pytest.mark.parametrize("aside", [1, -1])
def test_an_outline_of_arcs_alone_rolls_from_arc_to_arc(aside):
    """Over some joints, in both directions; the arcs leave nothing of the sides."""
    egg = pp.rounded(SQUARE, [0.5, 1.5, 0.5, 1.5] if aside > 0 else [1.5, 0.5, 1.5, 0.5])
    support = friction(pp.Polygon.rectangle(1.0, 1.0))
    scene = scene_of(egg, support, 2.0, (-0.5 * aside, -1.0))
    log = push(scene, (aside, 0.7), 6.0)
    assert log.attrs["stopped"] == ""
    assert (log.event == pp.Event.END_OF_SIDE).sum() >= 2
    stepped = push(scene, (aside, 0.7), 6.0, method="time-stepping", step=1e-3)
    assert pose_at_the_end(stepped) == pytest.approx(pose_at_the_end(log), abs=2e-3)


@pytest.mark.parametrize("massive", [False, True])
@pytest.mark.parametrize(("radius", "tilt"), [(0.9, 0.428), (0.6, 0.34), (0.9, 0.12)])
@pytest.mark.parametrize("velocity", [(-1, 1), (0, 1), (1, 1)])
def test_in_steps_an_object_goes_on_by_its_twist_where_a_contact_leaves_its_arc(
    velocity, radius, tilt, massive
):
    """Between two rows of a log, the object moves with a velocity between those of the rows."""
    corner, step, law = radius - 1, 0.01, 0.4
    point = (corner - radius * sin(tilt), corner - radius * cos(tilt))
    effects = friction(pp.Disc(0.6)) + massive * (pp.Inertia(mass=1, gyration_radius=0.5),)
    scene = scene_of(pp.rounded(SQUARE, radius), effects, law, point, tilt)
    options = {"method": "time-stepping", "step": step, "samples": 401}
    log = push(scene, velocity, 4.0, tilt, **options)
    mean = np.diff(log.object_position.values, axis=0) / np.diff(log.time.values)[:, None]
    ends = log.twist.values[:-1, :2], log.twist.values[1:, :2]
    outside = np.maximum(np.minimum(*ends) - mean, mean - np.maximum(*ends))
    assert outside.max() < step
