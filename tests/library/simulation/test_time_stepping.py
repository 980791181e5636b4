"""The time-stepping method: order 1, stops, and configurations in which no force will do."""

from __future__ import annotations

import math

import numpy as np
import pytest
from mechanics.builders import BOTH, make_scene
from simulation.runs import REFERENCES, check, final, heading, run

import planar_pushing as pp

FRICTION, INERTIA = pp.RingFriction(weight=0.7), pp.Inertia(mass=1.3, gyration_radius=0.8)
EFFECTS = {"friction": (FRICTION,), "inertia": (INERTIA,), "both": (FRICTION, INERTIA)}


def stepped(scene, velocity, duration, count, samples=2, **options):
    """The log of a run in so many steps."""
    step = {"method": "time-stepping", "step": duration / count, "samples": samples}
    return run(scene, velocity, duration, **step, **options)


def rates(errors):
    return np.log2(np.abs(errors[:-1]) / np.abs(errors[1:]))


@pytest.mark.parametrize("reference", REFERENCES, ids=["infinite", "left", "right", "turning"])
def test_order_one_to_the_quasi_static_references(reference):
    length, mu, fence, degrees, duration, angle, slip = reference
    scene = make_scene(length, mu, psi=math.radians(degrees))
    logs = [stepped(scene, heading(fence), duration, count) for count in (100, 200, 400)]
    errors = np.array([(final(x, "rod_angle") - angle, final(x, "slip") - slip) for x in logs])
    assert rates(errors) == pytest.approx(np.ones((2, 2)), abs=0.02)
    assert np.abs(errors[-1]) == pytest.approx(0, abs=0.1)


def test_slow_pushing_with_inertia_is_quasi_static():
    pushed = [
        stepped(make_scene(2, 2.0, EFFECTS["both"]), heading(60, speed), 3 / speed, 200)
        for speed in (0.1, 0.05)
    ]
    slow = stepped(make_scene(2, 2.0, (FRICTION,)), heading(60), 3, 200)
    errors = np.array(
        [[final(x, n) - final(slow, n) for n in ("rod_angle", "slip")] for x in pushed]
    )
    assert rates(errors) == pytest.approx(np.full((1, 2), 2), abs=0.1)


@pytest.mark.parametrize(
    "twist", [(0.3, 0.2, 1.0), (0.0, 0.5, 0.0), (0.0, 0.0, 1.5), (1.0, 1.0, 1e-4)]
)
def test_a_released_slider_stops_and_stays(twist):
    scene = make_scene(2, 2.0, EFFECTS["both"])
    log = check(stepped(scene, (0.0, -5.0), 6.0, 1200, samples=61, twist=twist))
    rests = ~log.twist.values.any(axis=1)
    assert rests.any()
    assert rests[rests.argmax() :].all()
    assert log.dissipated[-1].sum() == pytest.approx(float(log.kinetic_energy[0]), rel=1e-12, abs=0)
    assert final(log, "kinetic_energy") == 0


def test_times_that_rounding_parts_are_one_time():
    scene, times = make_scene(2, 2.0, EFFECTS["both"]), np.linspace(0, 1, 11)
    log = stepped(scene, [(0, (0.5, 1)), (0.3, (0, 1)), (0.6, (0, 0))], 1.0, 20, samples=11)
    assert 0.3 not in times
    assert log.attrs["stopped"] == ""
    assert np.diff(log.time).min() > 0.01


@pytest.mark.parametrize("name", ["inertia", "both"])
def test_a_sliding_painleve_configuration_is_survived(name):
    """The contact slides left over a fence that comes up: no finite force keeps it sliding.

    The step finds the impulse that makes it stick.
    """
    scene, pusher = make_scene(2, 3.0, EFFECTS[name]), pp.Pusher(velocity=lambda t: (0.0, t))
    twist = {"twist": (-1.0, 0.0, 0.0)}
    assert run(scene, pusher, 0.5, **twist).attrs["stopped"] == "no contact mode is consistent"
    logs = [stepped(scene, pusher, 0.5, count, **twist) for count in (50, 100, 200)]
    for log in logs:
        assert log.attrs["stopped"] == ""
        assert final(log, "mode") == pp.ContactMode.STICK
        assert final(log, "gap") == 0
    assert rates(np.diff([final(log, "rod_angle") for log in logs])) == pytest.approx([1], abs=0.1)


def test_without_a_consistent_mode_the_run_stops_and_says_so():
    scene = make_scene(5, pp.InfiniteFriction(at_zero_normal="none"))
    log = stepped(scene, heading(165), 1.0, 100)
    assert log.attrs["stopped"] == "no contact mode is consistent"
    assert log["mode"].values.tolist() == [-1]
    assert log.solutions.values.tolist() == log.time.values.tolist() == [0]


def test_a_rough_contact_holds_on_to_the_slider_that_it_pulls():
    log = stepped(make_scene(2, pp.PerfectlyRough(), EFFECTS["both"]), heading(-90), 1.0, 100)
    assert final(log, "mode") == pp.ContactMode.STICK
    assert final(log, "force")[1] < 0
    assert final(log, "gap") == 0
    assert final(log, "adhesive")


def test_large_friction_converges_to_infinite_friction():
    laws = 1e4, 1e5, np.inf
    ends = [
        final(stepped(make_scene(5, mu, EFFECTS["both"]), heading(165), 1.0, 100), "rod_angle")
        for mu in laws
    ]
    errors = np.deg2rad(np.abs(np.subtract(ends[:2], ends[2])))
    assert errors[0] < 1e-4
    assert errors[1] < 0.11 * errors[0]


@pytest.mark.parametrize(
    "twist", [(-0.4955911336775569, -0.46708788228066356, 0.49), (0.5, -0.5, 0.1)]
)
def test_the_impulse_of_a_slip_in_the_middle_of_its_range_is_found(twist):
    """Without a rod friction on the support shifts the bounds of the impulse by the same amount."""
    scene = make_scene(0, 0.4, BOTH, psi=math.radians(60))
    log = stepped(scene, (1.0, 0.0), 0.01, 1, twist=twist)
    assert log["mode"][0] == pp.ContactMode.SLIP_LEFT
    assert final(log, "twist")[1] == pytest.approx(0, abs=1e-15)
    f_x, f_y = final(log, "force")
    assert f_x == pytest.approx(0.4 * f_y, rel=1e-12, abs=0)
