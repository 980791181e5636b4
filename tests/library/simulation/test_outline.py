"""Outlines: other points of the slider meet the fence, or the finger's side ends."""

from dataclasses import replace

import numpy as np
import pytest
from mechanics.builders import BOTH, FRICTION, INERTIA
from scipy.optimize import brentq
from simulation.runs import check, final, heading, run
from simulation.scenes import METHODS as BOTH_METHODS
from simulation.scenes import SQUARE as CORNERS

import planar_pushing as pp

#: The scenes are plain or random numbers, not real objects.
pytestmark = pytest.mark.filterwarnings("ignore:pusher:planar_pushing.SceneWarning")

SQUARE = np.array(CORNERS)
#: A table with two legs, and its slot between them.
BENCH = np.array(
    [(-1, -1), (-0.8, -1), (-0.8, 0.5), (0.7, 0.5), (0.7, -0.6), (1, -0.6), (1, 1), (-1, 1)]
)
METHODS = pytest.mark.parametrize("method", BOTH_METHODS)
EFFECTS = pytest.mark.parametrize(
    "effects", [FRICTION, BOTH, INERTIA], ids=["friction", "both", "inertia"]
)


def turned(points, angle):
    return np.asarray(points) @ np.array(
        [[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]]
    )


def standing(shape, contact, tilt, law, effects=FRICTION, side=(-np.inf, np.inf)):
    """A slider whose outline is turned by an angle; its contact is a point of the shape."""
    x, y = -turned(contact, tilt)
    angle = np.arctan2(y, x)
    slider = pp.Slider(
        rod_length=np.hypot(x, y), rod_angle=angle, radius=1.0, side=side,
        outline=turned(shape, tilt - angle),
    )  # fmt: skip
    return pp.Scene(slider=slider, contact=pp.Coulomb(law), effects=effects)


def heights(log, shape, tilt):
    """Heights of the corners over the fence, shape (instants, corners), by complex numbers."""
    spin = np.exp(1j * (tilt + np.deg2rad(log.rod_angle.values - log.rod_angle.values[0])))
    center = log.position.values @ (1, 1j)
    corners = center[:, None] + spin[:, None] * (np.asarray(shape) @ (1, 1j))
    return corners.imag - log.pusher.values[:, 1:]


def without(scene):
    """The scene without its outline."""
    return replace(scene, slider=replace(scene.slider, outline=None))


@METHODS
@EFFECTS
@pytest.mark.parametrize("law", [0.0, 0.5])
def test_a_side_that_lies_on_the_fence_is_pushed_on_without_an_event(method, effects, law):
    scene = standing(SQUARE, (0, -1), 0.0, law, effects)
    log = run(scene, [(0, (0, 1)), (1, (0, 0.5)), (2, (0, 0.7))], 5.0, method=method)
    assert log.attrs["stopped"] == ""
    assert final(log, "time") == 5
    assert np.all(log.rod_angle == 90)


def first(log, event):
    """Number of the first entry of a log with an event."""
    return int(np.argmax(log.event.values == event))


@METHODS
@EFFECTS
def test_a_side_on_the_fence_slips_over_it(method, effects):
    """A contact in the middle of a side that lies on the fence is the whole side."""
    scene = standing(SQUARE, (0, -1), 0.0, 0.5, effects)
    log = check(run(scene, heading(60), 1.0, method=method), 1e-8)
    assert log.attrs["stopped"] == ""
    assert (
        log.flush.all() or effects is INERTIA
    )  # with inertia alone there is no force after the start
    assert np.abs(heights(log, SQUARE, 0.0)[:, :2]).max() < 1e-12
    if effects is INERTIA:
        return
    slips = np.cos(np.pi / 3) - 0.5 * np.sin(np.pi / 3)
    assert final(log, "slip") == pytest.approx(
        -slips, abs=1e-12 if method == "event-driven" else 2e-3
    )


@METHODS
@pytest.mark.parametrize("effects", [FRICTION, BOTH], ids=["friction", "both"])
@pytest.mark.parametrize(
    ("shape", "contact", "tilt", "left"),
    [
        (SQUARE, (-1, -1), 0.3, -0.3),
        (SQUARE, (-1, -1), 0.7, -0.7),
        (SQUARE, (1, -1), -0.3, 0.3),
        (BENCH, (-1, -1), 0.1, -0.1),
        (BENCH, (1, -0.6), -0.9, 0.9 - np.arctan2(0.4, 1.8)),
    ],
)
def test_a_corner_comes_down_where_its_side_is_along_the_fence(
    method, effects, shape, contact, tilt, left
):
    """The slider turns about its contact until the next corner is at its height."""
    scene = standing(shape, contact, tilt, 2.0, effects)
    steps = {} if method == "event-driven" else {"step": 5e-3}
    log = check(run(scene, (0, 1), 20.0, method=method, **steps))
    assert log.attrs["stopped"] == ""
    over = heights(log, shape, tilt)
    assert over.min() > (-1e-14 if method == "event-driven" else -1e-4)
    rotation = np.deg2rad(log.rod_angle.values - log.rod_angle.values[0])
    if method == "time-stepping":
        assert rotation.min() - 2e-2 < left < rotation.max() + 2e-2
        return
    arrives = first(log, pp.Event.PENETRATES)
    assert rotation[arrives] == pytest.approx(left, abs=1e-14)

    def behind(duration):
        alone = run(without(scene), (0, 1), duration, samples=2)
        return np.deg2rad(final(alone, "rod_angle") - alone.rod_angle[0].item()) - left

    time = log.time.values[arrives]
    assert time == pytest.approx(brentq(behind, 0.01, time + 0.01, xtol=1e-11), abs=1e-9)


@pytest.mark.parametrize("spin", [1.0, -0.5])
def test_a_corner_of_a_slider_in_flight_meets_the_fence_at_a_known_time(spin):
    """It spins about its center at a height of 1.3: sqrt 2 cos(pi / 4 - t |spin|) = 1.3."""
    scene = standing(SQUARE, (0, -1), 0.0, 0.5, INERTIA)
    log = check(run(scene, (0, 0), 3.0, gap=0.3, twist=(0.2, 0, spin)))
    assert log.attrs["stopped"] == ""
    meets = first(log, pp.Event.PENETRATES)
    assert log.time.values[meets] == pytest.approx(
        (np.pi / 4 - np.arccos(1.3 / np.sqrt(2))) / abs(spin), abs=1e-10
    )
    assert log.gap.values[meets - 1] > 0 == log.gap.values[meets]
    assert heights(log, SQUARE, 0.0).min() > -1e-14


@METHODS
def test_a_fence_that_rises_to_a_slider_at_rest_meets_its_lowest_corner(method):
    """The contact is 0.5 above the fence, and another corner 0.4 below the contact."""
    lower = np.array([(-1, -1), (1, -1.4), (1, 1), (-1, 1)])
    log = check(run(standing(lower, (-1, -1), 0.0, 0.5), (0.3, 1), 1.0, gap=0.5, method=method))
    assert log.attrs["stopped"] == ""
    assert log.gap.values[0] == pytest.approx(0.1, abs=1e-14)
    pushed = np.argmax(log["mode"].values != pp.ContactMode.SEPARATE)
    assert log.time.values[pushed] == pytest.approx(
        0.1, abs=1e-12 if method == "event-driven" else 2.1e-3
    )
    assert heights(log, lower, 0.0).min() > -1e-4


def test_a_slider_that_lands_flush_touches_at_both_ends():
    """With inertia alone it stops, also if its center is not above the contact."""
    for x in (0, 0.5, -0.99):
        scene = standing(SQUARE, (x, -1), 0.0, 0.5, INERTIA)
        log = check(run(scene, (0, 0), 1.0, gap=0.3, twist=(0, -1, 0)))
        assert log.attrs["stopped"] == ""
        assert log.time.values[first(log, pp.Event.TOUCHES)] == pytest.approx(0.3, abs=1e-14)
        assert np.abs(heights(log, SQUARE, 0.0)[-1, :2]).max() < 1e-14
        assert final(log, "contact_dissipated") == pytest.approx(0.5, rel=1e-14, abs=0)


def test_a_slider_that_falls_on_a_corner_turns_until_the_next_comes_down():
    scene = standing(SQUARE, (-1, -1), 0.4, 1.0, BOTH)
    log = check(run(scene, (0, 0.2), 9.0, gap=0.2, twist=(0, -0.5, 0)), 1e-8)
    assert pp.Event.TOUCHES in log.event.values
    assert log.attrs["stopped"] == ""
    rotation = np.deg2rad(log.rod_angle.values - log.rod_angle.values[0])
    assert rotation[first(log, pp.Event.PENETRATES)] == pytest.approx(-0.4, abs=1e-12)
    assert log.flush.values[-1]
    assert rotation[-1] == pytest.approx(-0.4, abs=1e-12)


@pytest.mark.parametrize("seed", range(20))
def test_no_corner_of_a_random_outline_is_ever_below_the_fence(seed):
    random = np.random.default_rng(seed)
    count = int(random.integers(3, 9))
    angles = 2 * np.pi * (np.arange(count) + random.uniform(0, 0.4, count)) / count
    radii = random.uniform(0.3, 1.5, count)  # hooks among them
    shape = radii[:, None] * np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    tilt = random.uniform(0, 2 * np.pi)
    contact = shape[turned(shape, tilt)[:, 1].argmin()]
    if turned(contact, tilt)[1] > -0.05:
        pytest.skip("the center is below the fence")
    effects = (FRICTION, BOTH)[seed % 2]
    scene = standing(shape, contact, tilt, random.uniform(0.1, 2), effects)
    log = check(run(scene, heading(random.uniform(30, 150)), 8.0), 1e-8)
    assert heights(log, shape, tilt).min() > -1e-12
    assert log.attrs["stopped"] == ""


@METHODS
@pytest.mark.parametrize("degrees", [60, 120])
def test_a_finger_that_comes_to_the_end_of_its_side_goes_on(method, degrees):
    """A point that slips off the corner of a square leaves it."""
    scene = standing(SQUARE, (0.3, -1), 0.0, 0.1, side=(-1.3, 0.7))
    pusher = pp.Pusher(velocity=heading(degrees), shape="finger")
    log = run(scene, pusher, 9.0, method=method)
    assert log.attrs["stopped"] == ""
    assert not log.parted.any()
    plain = run(without(scene), pusher, 9.0, method=method)
    assert plain.attrs["stopped"] == ""
    parts = plain.time.values[plain.parted.values][0]
    leaves = log.time.values[np.flatnonzero(log["mode"].values == pp.ContactMode.SEPARATE)[0]]
    exact = method == "event-driven"
    assert leaves == pytest.approx(parts, abs=1e-12 if exact else 1e-2)
    assert final(log, "gap") > 0.0
    if exact:
        (end, *_) = np.flatnonzero(log.event.values == pp.Event.END_OF_SIDE)
        assert min(abs(log.contact_position.values[end] - np.array([-1.3, 0.7]))) < 1e-9


def test_a_finger_takes_no_notice_of_the_height_of_corners():
    scene = standing(SQUARE, (0, -1), 0.0, 0.5, side=(-1, 1))
    log = run(scene, pp.Pusher(velocity=heading(80), shape="finger"), 0.5)
    assert log.attrs["stopped"] == ""
    assert abs(final(log, "rod_angle") - 90) > 1


def test_a_contact_that_is_written_with_seven_digits_is_on_the_side():
    """It is up to a millionth of the outline off the side, within or outside."""
    random, law = np.random.default_rng(1), pp.Coulomb(0.5)
    for _ in range(10):
        corners = np.round(turned(SQUARE, random.uniform(0, 2)), 4)
        given = {"effects": (pp.SupportFriction(support=pp.Polygon(corners)),), "contact": law}
        point = np.round(0.5 * (corners[0] + corners[1]) + random.uniform(-1e-7, 1e-7, 2), 7)
        scene = pp.scene_at(point, outline=corners, **given)
        assert np.array(scene.placement.point) == pytest.approx(point, abs=3e-7)
        corner = pp.scene_at(corners[0] + (1e-7, -1e-7), -corners[0], outline=corners, **given)
        assert corner.placement.point == tuple(corners[0])
        assert all(final(run(each, (0, 0.1), 1e-6), "time") > 0 for each in (scene, corner))
