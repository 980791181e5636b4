"""The time-stepping method: stops, and configurations in which no force will do."""

from __future__ import annotations

import math

import numpy as np
import pytest
from mechanics.builders import BOTH, make_scene
from simulation.runs import check, final, heading, run

import planar_pushing as pp

FRICTION, INERTIA = pp.RingFriction(weight=0.7), pp.Inertia(mass=1.3, gyration_radius=0.8)
EFFECTS = {"friction": (FRICTION,), "inertia": (INERTIA,), "both": (FRICTION, INERTIA)}


def stepped(scene, velocity, duration, count, samples=2, **options):
    """The log of a run in so many steps."""
    step = {"method": "time-stepping", "step": duration / count, "samples": samples}
    return run(scene, velocity, duration, **step, **options)


def rates(errors):
    return np.log2(np.abs(errors[:-1]) / np.abs(errors[1:]))


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


def test_a_rough_contact_holds_on_to_the_slider_that_it_pulls():
    log = stepped(make_scene(2, pp.PerfectlyRough(), EFFECTS["both"]), heading(-90), 1.0, 100)
    assert final(log, "mode") == pp.ContactMode.STICK
    assert final(log, "force")[1] < 0
    assert final(log, "gap") == 0
    assert final(log, "adhesive")


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
