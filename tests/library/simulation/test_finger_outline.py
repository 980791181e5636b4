"""A finger and the sides of its outline: never inside; with inertia, a run ends where it touches two."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import xarray as xr
from simulation.runs import check, final, run
from simulation.scenes import FINGER_MEETS as MEETS
from simulation.scenes import METHODS as BOTH

import planar_pushing as pp

#: The scenes are plain or random numbers, not real objects.
pytestmark = pytest.mark.filterwarnings("ignore:(support|radius):planar_pushing.SceneWarning")

ELL = [(0, 0), (0.3, 0), (0.3, 0.1), (0.1, 0.1), (0.1, 0.3), (0, 0.3)]
TEE = [(-0.15, 0), (0.15, 0), (0.15, 0.1), (0.05, 0.1), (0.05, 0.3), (-0.05, 0.3), (-0.05, 0.1),
       (-0.15, 0.1)]  # fmt: skip
#: A channel of width 0.1 in the lower side, and a point of its left wall.
CHANNEL = [(-0.3, 0), (-0.05, 0), (-0.05, 0.2), (0.05, 0.2), (0.05, 0), (0.3, 0), (0.3, 0.3),
           (-0.3, 0.3)]  # fmt: skip
#: A plate with a thin arm, of a width of 0.004, on its lower side.
ARMED = [(-0.3, 0), (0.1, 0), (0.1, -0.2), (0.104, -0.2), (0.104, 0), (0.3, 0), (0.3, 0.3),
         (-0.3, 0.3)]  # fmt: skip
EFFECTS = {
    "friction": (pp.RingFriction(),),
    "both": (pp.RingFriction(), pp.Inertia(mass=0.3, gyration_radius=0.15)),
}
METHODS = pytest.mark.parametrize("method", BOTH)
SETS = pytest.mark.parametrize("effects", EFFECTS)
#: Random outlines, most of them in the slow tests.
SEEDS = pytest.mark.parametrize(
    "seed", [*range(6), *(pytest.param(seed, marks=pytest.mark.slow) for seed in range(6, 30))]
)


def beside(outline, point, law=0.0, effects="friction", normal=None):
    """A scene of an object whose friction is that of a ring of radius 0.2 about its rod's end."""
    law = law if isinstance(law, pp.PerfectlyRough) else pp.Coulomb(law)
    ring = (pp.SupportFriction(support=pp.Ring(0.2)),)
    scene = pp.scene_at(point, normal, effects=ring, contact=law, outline=outline)
    return replace(scene, effects=EFFECTS[effects])


def pushed(scene, velocity, radius, duration=3.0, **options):
    finger = pp.Pusher(velocity=velocity, shape="finger", radius=radius)
    return run(scene, finger, duration, **options)


def depths(log, scene, radius):
    """Depth of the disc in the outline at each instant, by complex numbers; negative outside."""
    spin = np.exp(1j * np.deg2rad(log.rod_angle.values))
    own = np.asarray(scene.slider.outline_in_body().corners) @ (1, 1j)
    start = (log.position.values @ (1, 1j))[:, None] + spin[:, None] * own
    end, center = np.roll(start, -1, axis=1), (log.pusher.values @ (1, 1j) - 1j * radius)[:, None]
    part = np.clip(((center - start) / (end - start)).real, 0, 1)
    nearest = np.abs(center - start - part * (end - start)).min(axis=1)
    # A point that is on a corner has no winding number; its depth is zero anyway.
    around = np.angle((end - center) * np.conj(start - center)).sum(axis=1)
    return radius - np.where(np.abs(around) > 3.0, -nearest, nearest)


def require_meeting(log, scene, radius, slack=1e-9):
    """The disc touches two sides at an instant, and the run goes on; without inertia."""
    assert log.attrs["stopped"] == ""
    (meets, *_) = np.flatnonzero(log.event.values == pp.Event.PENETRATES)
    spin = np.exp(1j * np.deg2rad(log.rod_angle.values[meets]))
    own = np.asarray(scene.slider.outline_in_body().corners) @ (1, 1j)
    start = log.position.values[meets] @ (1, 1j) + spin * own
    along = np.roll(start, -1) - start
    away = (log.pusher.values[meets] @ (1, 1j) - 1j * radius - start) / along
    on_side = (away.real > -1e-9) & (away.real < 1 + 1e-9)
    gaps = np.abs(away.imag * np.abs(along)) - radius
    assert (np.abs(gaps[on_side]) < slack).sum() >= 2
    return int(meets)


def require_outside(log, scene, radius, first_order=2e-2):
    """The disc overlaps nothing before the end; where it meets another point, it touches it."""
    deep = depths(log, scene, radius)
    exact = log.attrs["method"] == "event-driven"
    assert deep[:-1].max() < (1e-9 if exact else 1e-5)  # steps in flight: gap of second order
    assert deep[-1] < (1e-9 if exact else first_order)
    if log.attrs["stopped"] == MEETS:
        assert deep[-1] > (-1e-9 if exact else -1e-12)
        if exact:
            # A point meets the second side where it comes to the corner.
            meeting = pp.Event.PENETRATES if radius else pp.Event.END_OF_SIDE
            assert pp.Event(final(log, "event")) == meeting
    assert final(log, "time") == log.attrs["duration"] or log.attrs["stopped"] == MEETS


# -- the start ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("outline", "point", "radius", "gap", "deep"),
    [
        (ELL, (0.1, 0.11), 0.04, 0.0, "0.03"),
        (ELL, (0.1, 0.11), np.float64(0.04), 0.0, "0.03"),
        (ELL, (0.1, 0.11), np.float32(0.15), 0.0, "0.14"),
        (ELL, (0.11, 0.1), 0.04, 0.0, "0.03"),
        (ELL, (0.1, 0.15), 0.04, 0.03, ""),
        (ELL, (0.1, 0.15), 0.06, 0.03, "0.01"),
        (ELL, (0.1, 0.15), 0.05, 0.0, ""),
        (ELL, (0.1, 0.15), 0.05 + 1e-9, 0.0, "1e-09"),
        (TEE, (0.05, 0.12), 0.05, 0.0, "0.03"),
        (TEE, (-0.05, 0.12), 0.02, 0.0, ""),
        (CHANNEL, (0.05, 0.1), 0.04, 0.0, ""),
        (CHANNEL, (0.05, 0.1), 0.05, 0.0, ""),
        (CHANNEL, (0.05, 0.1), 0.06, 0.0, "0.02"),
        (CHANNEL, (-0.2, 0), 0.3, 0.0, ""),
        (ARMED, (0.05, 0), 0.1, 0.0, "0.05"),
    ],
)
def test_a_disc_that_begins_in_another_side_is_refused(outline, point, radius, gap, deep):
    scene = beside(outline, point, 0.3)
    if not deep:
        log = pushed(scene, (0, 0.01), radius, 1e-4, gap=gap)
        assert log.attrs["stopped"] in ("", MEETS)  # a disc that is tangent to a side may meet it
        assert depths(log, scene, radius).max() < 1e-9
        return
    said = (
        f"outline: 'an overlap of {deep} with the finger' given; allowed: a finger outside the object; "
        "choose a smaller radius, or move the contact onto the outline and away from its other sides"
    )
    finger = pp.Pusher(velocity=(0, 0.01), shape="finger", radius=radius)
    for call in (pp.simulate, pp.simulate_batch):
        with pytest.raises(pp.InvalidValue) as caught:
            call(scene, pusher=finger, duration=1.0, gap=gap)
        assert str(caught.value) == said


def test_the_depth_at_the_start_is_that_of_the_first_touch():
    for radius in (0.02, 0.04, 0.3):
        overlap = pp.first_touch(ELL, (0.1 + radius, 0.11), (-1e-3, 0), radius).overlap
        with pytest.raises(pp.InvalidValue, match=f"an overlap of {float(overlap):.6g} with"):
            pushed(beside(ELL, (0.1, 0.11)), (0, 0.01), radius)


@pytest.mark.parametrize("labeled", [False, True])
def test_every_row_of_a_batch_is_checked(labeled):
    def array(*values):
        return xr.DataArray(list(values), dims="run") if labeled else np.array(values)

    scene = beside(ELL, (0.1, 0.15), 0.3)

    def batch(radius, gap=0.0, shorter=1.0):
        slider = replace(scene.slider, rod_length=scene.slider.rod_length * shorter)
        finger = pp.Pusher(velocity=(0, 0.01), shape="finger", radius=radius)
        return pp.simulate_batch(replace(scene, slider=slider), finger, duration=1e-4, gap=gap)

    assert (batch(array(0.0, 0.02, 0.045)).stopped == "").all()
    for deep, given in (
        (r"0\.02", {"radius": array(0.0, 0.02, 0.07)}),
        (r"0\.01", {"radius": 0.06, "gap": array(0.0, 0.5)}),
        (".*", {"radius": 0.01, "shorter": array(1.0, 0.9)}),
    ):
        with pytest.raises(pp.InvalidValue, match=f"an overlap of {deep} with the finger"):
            batch(**given)


@METHODS
def test_a_disc_that_begins_between_two_sides_may_leave_or_go_on_without_inertia(method):
    scene = beside(ELL, (0.1, 0.15))
    away = check(pushed(scene, (0.3, 0.05), 0.05, 0.1, method=method))
    assert away.attrs["stopped"] == ""
    on = pushed(scene, (-0.3, 0.05), 0.05, 0.1, method=method)
    assert on.attrs["stopped"] == ""
    require_outside(on, scene, 0.05, 1e-4)
    scene = beside(ELL, (0.1, 0.15), effects="both")
    into = pushed(scene, (-0.3, 0.05), 0.05, 0.1, method=method)
    assert into.attrs["stopped"] == MEETS
    assert final(into, "time") < (1e-8 if method == "event-driven" else 2.1e-4)
    require_outside(into, scene, 0.05, 1e-4)


@METHODS
def test_a_disc_that_begins_beside_an_inner_corner_is_refused(method):
    for point in ((0.1, 0.101), (0.101, 0.1)):
        scene = beside(ELL, point, 0.5)
        assert pushed(scene, (0, 0.05), 0.0, 0.01, method=method).attrs["stopped"] == ""
        with pytest.raises(pp.InvalidValue, match=r"an overlap of 0\.019 with the finger"):
            pushed(scene, (0, 0.05), 0.02, 0.01, method=method)


# -- the run -----------------------------------------------------------------------------------------


@METHODS
@SETS
@pytest.mark.parametrize("radius", [0.01, pytest.param(0.04, marks=pytest.mark.slow), 0.1])
@pytest.mark.parametrize(
    ("outline", "point", "along", "left"),
    [
        (ELL, (0.1, 0.25), -1, 0.15),
        (ELL, (0.25, 0.1), 1, 0.15),
        (TEE, (0.05, 0.25), -1, 0.15),
        (TEE, (-0.05, 0.25), 1, 0.15),
    ],
)
def test_the_contact_comes_no_closer_to_a_notch_than_the_radius(
    method, effects, radius, outline, point, along, left
):
    scene = beside(outline, point, effects=effects)
    log = pushed(scene, (along * 0.4, 0.05), radius, method=method)
    require_outside(log, scene, radius)
    if effects == "friction":
        assert log.attrs["stopped"] == ""
        if method == "event-driven":
            meets = require_meeting(log, scene, radius)
            before = along * log.contact_position.values[:meets]
            assert before.max() < left - radius + 1e-9
        return
    assert log.attrs["stopped"] == MEETS
    place, wanted = final(log, "contact_position"), along * (left - radius)
    assert place == pytest.approx(wanted, abs=1e-9 if method == "event-driven" else 5e-3)


@METHODS
@pytest.mark.parametrize("degrees", [20, 60, 90, 140, 175])
def test_a_disc_in_a_corner_of_any_angle_is_tangent_to_both_sides(method, degrees):
    """In a free angle, the contact is the radius over the tangent of half the angle from the corner."""
    angle = np.deg2rad(degrees)
    tip = 0.4 * np.exp(1j * (np.pi + angle))
    side, top = (tip.real, tip.imag), (0.3, 0.6)[degrees > 90]
    behind = [(tip.real, top)] if degrees > 90 else [(0.1, tip.imag), (0.1, top)]
    outline = [(0, 0), side, *behind, (-0.4, top), (-0.4, 0)]
    radius, scene = 0.02, beside(outline, (-0.3, 0))
    # Where the corner is almost straight, the contact moves far while the disc sinks in a little.
    slack = 1e-9 / np.sin(angle)
    if method == "event-driven":
        log = pushed(scene, (0.4, 0.02), radius)
        require_meeting(log, scene, radius)
        require_outside(log, scene, radius)
    scene = beside(outline, (-0.3, 0), effects="both")
    log = pushed(scene, (0.4, 0.02), radius, method=method)
    assert log.attrs["stopped"] == MEETS
    wanted = 0.3 - radius / np.tan(angle / 2)
    assert final(log, "contact_position") == pytest.approx(
        wanted, abs=slack if method == "event-driven" else 5e-3
    )
    require_outside(log, scene, radius)


@METHODS
@SETS
def test_a_contact_that_sticks_rolls_into_the_notch_by_the_turn(method, effects):
    scene = beside(ELL, (0.1, 0.16), pp.PerfectlyRough(), effects)
    log = pushed(scene, (-0.2, 0.4), 0.05, method=method, samples=1001)
    require_outside(log, scene, 0.05)
    assert (log.mode == pp.ContactMode.STICK).all()
    exact = method == "event-driven"
    if effects == "friction":
        # There it sticks at both sides, and translates.
        assert log.attrs["stopped"] == ""
        turned = log.rod_angle.values - log.rod_angle.values[0]
        assert np.deg2rad(turned[-1]) == pytest.approx(0.2, abs=1e-7 if exact else 5e-3)
        assert turned[-1] == pytest.approx(turned[500], abs=1e-9)
        return
    assert log.attrs["stopped"] == MEETS
    turn = np.deg2rad(final(log, "rod_angle") - log.rod_angle.values[0])
    assert turn == pytest.approx(0.01 / 0.05, abs=1e-7 if exact else 5e-3)


@METHODS
@pytest.mark.parametrize("radius", [0.01, 0.049, 0.05])
def test_a_disc_in_a_channel_goes_to_its_bottom(method, radius):
    scene = beside(CHANNEL, (0.05, 0.02))
    log, exact = pushed(scene, (-0.3, 1e-6), radius, method=method), method == "event-driven"
    require_outside(log, scene, radius)
    assert log.attrs["stopped"] == ""
    if radius == 0.05:
        # It fills the channel, and the object turns about its center.
        away = (log.pusher.values - (0.0, radius) - log.position.values) @ (1, 1j)
        there = away * np.exp(-1j * np.deg2rad(log.rod_angle.values))
        (meets, *_) = np.flatnonzero(np.abs(there - there[-1]) < (1e-9 if exact else 1e-3))
        assert 0.4 < log.time.values[meets] < 0.5
        assert abs(there[-1] - there[0]) == pytest.approx(
            0.18 - radius, abs=1e-9 if exact else 1e-3
        )
    scene = beside(CHANNEL, (0.05, 0.02), effects="both")
    log = pushed(scene, (-0.3, 1e-6), radius, method=method)
    assert log.attrs["stopped"] == MEETS
    bottom = pytest.approx(0.18 - radius, abs=1e-7 if exact else 2e-3)
    assert abs(final(log, "contact_position")) == bottom


@METHODS
@pytest.mark.parametrize("radius", [0.0, 0.03, 5.0])
def test_a_convex_corner_is_passed(method, radius):
    """A disc as large as the object comes to the side beyond the channel, and touches both."""
    scene = beside(CHANNEL, (-0.2, 0))
    for sense in (-1, 1):
        log = pushed(scene, (0.4 * sense, 0.02), radius, 1.0, method=method)
        assert log.attrs["stopped"] == ""
        require_outside(log, scene, radius)
        if method == "event-driven" and not (radius == 5.0 and sense > 0):
            (end, *_) = np.flatnonzero(log.event.values == pp.Event.END_OF_SIDE)
            place = 0.15 if sense > 0 else -0.1
            assert log.contact_position.values[end] == pytest.approx(place, abs=1e-10)
            closed = log.gap.values == 0.0
            assert np.abs(depths(log, scene, radius)[closed]).max() < 1e-9


# -- a finger that is free of the side ----------------------------------------------------------------


@METHODS
@pytest.mark.parametrize("radius", [0.0, 1e-3, 0.03])
@pytest.mark.parametrize("speed", [1.0, 300.0])
def test_a_free_finger_does_not_pass_through_a_thin_arm(method, radius, speed):
    """It leaves the side, and meets the arm in a step of any length."""
    scene = beside(ARMED, (-0.2, 0), 0.3)
    exact, away = method == "event-driven", [(0, (0, -0.5)), (0.2, (speed, 0))]
    step = {} if exact else {"step": 1e-3 / speed}
    log = pushed(scene, away, radius, 0.2 + 0.6 / speed, method=method, **step)
    assert log.attrs["stopped"] == ""
    wanted = 0.2 + (0.3 - radius) / speed
    closed = np.flatnonzero((log.mode.values != pp.ContactMode.SEPARATE) & (log.time.values > 0.2))
    touches = log.time.values[closed[0]]
    assert touches == pytest.approx(wanted, abs=(2e-9 if exact else 2e-3) / speed)
    require_outside(log, scene, radius)


@METHODS
def test_a_free_finger_that_comes_back_beside_meets_the_other_side(method):
    scene, radius = beside(ELL, (0.1, 0.2), 0.3), 0.03
    path = [(0, (0, -0.5)), (0.1, (-0.5, 0.0))]
    log = pushed(scene, path, radius, 1.0, method=method, on_ambiguity="separate")
    assert log.attrs["stopped"] == ""
    exact = method == "event-driven"
    moves = np.flatnonzero(log.rod_angle.values != log.rod_angle.values[0])[0]
    touches = log.time.values[moves - 1]
    slack = 1e-8 if exact else 2e-3
    assert touches == pytest.approx(0.1 + 0.07 / 0.5, abs=slack)
    require_outside(log, scene, radius)


@METHODS
def test_a_free_finger_can_come_back_to_its_side_behind_an_obstacle(method):
    """It goes around the arm, and pushes the side on the other side of it."""
    scene, radius = beside([(-0.3, 0), (0.3, 0), (0.3, 0.3), (-0.3, 0.3)], (-0.2, 0), 0.3), 0.03
    path = [(0, (0, -1)), (0.1, (1, 0)), (0.4, (0, 1)), (0.6, (0, 0.2))]
    log = check(pushed(scene, path, radius, 0.7, method=method), 1e-6)
    assert log.attrs["stopped"] == ""
    assert final(log, "contact_position") == pytest.approx(0.3, abs=0.05)
    # A hook hangs beside the side, and the finger comes from the other side of its end.
    hook = [(-0.3, 0), (-0.1, 0), (-0.1, -0.02), (0, -0.02), (0, 0), (0.3, 0), (0.3, 0.3),
            (-0.3, 0.3)]  # fmt: skip
    scene = beside(hook, (-0.2, 0), 0.3)
    log = pushed(scene, path, radius, 0.7, method=method)
    assert log.attrs["stopped"] == ""
    assert final(log, "gap") == 0.0
    require_outside(log, scene, radius)


# -- random outlines ---------------------------------------------------------------------------------


def star(random):
    """A random polygon about the origin, most of them not convex."""
    count = int(random.integers(5, 13))
    angles = 2 * np.pi * (np.arange(count) + random.uniform(-0.35, 0.35, count)) / count
    return random.uniform(0.08, 0.4, count) * np.exp(1j * angles)


def random_outline(random):
    """A random outline, and a point of one of its sides."""
    corners = star(random)
    side, part = int(random.integers(len(corners))), random.uniform(0.05, 0.95)
    point = corners[side - 1] + part * (corners[side] - corners[side - 1])
    return np.column_stack([corners.real, corners.imag]), (point.real, point.imag)


@METHODS
@SETS
@SEEDS
def test_no_disc_is_ever_inside_a_random_outline(method, effects, seed):
    random = np.random.default_rng(seed)
    outline, point = random_outline(random)
    radius, law = random.choice([0.01, 0.03, 0.1]), random.choice([0.0, 0.1, 0.5, 2.0])
    scene = beside(outline, point, law, effects)
    velocity = [(t, tuple(random.uniform((-1, -0.5), (1, 1.5)))) for t in (0.0, 0.6)]
    inward = np.array(scene.placement.normal)
    overlap = pp.first_touch(outline, np.array(point) - radius * inward, inward, radius).overlap
    if overlap > 1e-9:
        with pytest.raises(pp.InvalidValue, match=f"overlap of {float(overlap):.6g} with"):
            pushed(scene, velocity, radius, 1.0, method=method)
        return
    log = check(pushed(scene, velocity, radius, 1.0, method=method), 1e-6)
    require_outside(log, scene, radius)


@METHODS
@SETS
@SEEDS
def test_no_free_finger_is_ever_inside_a_random_outline(method, effects, seed):
    random = np.random.default_rng(seed)
    outline, point = random_outline(random)
    radius = random.choice([0.0, 0.01, 0.03])
    scene = beside(outline, point, random.choice([0.0, 0.5]), effects)
    inward = np.array(scene.placement.normal)
    if pp.first_touch(outline, np.array(point) - radius * inward, inward, radius).overlap > 0:
        pytest.skip("the disc begins in another side")
    aside = random.uniform(-2, 2)
    path = [(0, (0.1, -0.4)), (0.2, (aside, -0.2)), (0.4, (aside, 1.0)), (0.6, (-2 * aside, 1.0)),
            (0.8, (aside, 1.0))]  # fmt: skip
    log = pushed(scene, path, radius, 1.0, method=method, on_ambiguity="separate", samples=401)
    require_outside(log, scene, radius)
