"""Bars over time, pushed across the line of their feet, where the rotation at an instant is an interval."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import planar_pushing as pp
from simulation.runs import check, final, heading, run


def bar(places, loads, beside=0.0):
    """Feet along the pusher, whose contact is at the body's origin."""
    feet = pp.Points([(beside * (i == 0), y) for i, y in enumerate(places)], loads)
    slider = pp.Slider(rod_length=0.0, rod_angle=np.pi / 2, radius=1.0)
    return pp.Scene(
        slider=slider, contact=pp.Coulomb(0.5), effects=(pp.SupportFriction(support=feet),)
    )


def centered(seed):
    """A bar with its center of pressure at the contact, to rounding."""
    random = np.random.default_rng(seed)
    places, loads = random.uniform(-1, 1, (2, random.integers(3, 5)))
    loads = np.abs(loads) + 0.1
    return places - np.average(places, weights=loads), loads


LITERAL = np.array([-0.6433333333333333, 0.2666666666666666, 0.3766666666666667])
BARS = [(LITERAL - LITERAL.mean(), np.ones(3)), *map(centered, range(1, 9))]


@pytest.mark.parametrize("shape", ["fence", "finger"])
@pytest.mark.parametrize(("places", "loads"), BARS)
def test_a_bar_pushed_at_its_center_of_pressure_translates(places, loads, shape):
    log = check(
        run(bar(places, loads), pp.Pusher(velocity=(0.0, 1.0), shape=shape), 2.0, samples=3)
    )
    assert log.attrs["stopped"] == ""
    assert final(log, "time") == 2.0
    assert final(log, "rod_angle") == pytest.approx(90, abs=1e-9)
    assert np.unique(log.mode) == pp.ContactMode.STICK


@pytest.mark.parametrize("size", [1e-14, 1e-12, 1e-10, 1e-8, 3e-8, 1e-7, 1e-6, 1e-4])
def test_a_foot_beside_the_line_turns_the_bar_with_the_square_root(size):
    """A foot beside the line moves the center of pressure ahead of the contact."""
    log = check(run(bar(*BARS[0], size), (0.0, 1.0), 0.5, samples=3))
    assert log.attrs["stopped"] == ""
    turned = abs(final(log, "rod_angle") - 90) / np.sqrt(size)
    assert turned == pytest.approx(72.35, rel=0.02)


def rotation(angle, towards):
    """Of feet at 1, 2 and 3 behind a contact that sticks, for a rod beside the motion's normal."""
    across, along = np.sin(towards - angle), np.cos(towards - angle)

    def torque(omega):
        w = across + omega * np.array([1.0, 2.0, 3.0])
        return np.sum([1.0, 2.0, 3.0] * w / np.hypot(w, along))

    return brentq(torque, -2.0, 2.0, xtol=1e-15, rtol=1e-14)


@pytest.mark.parametrize("start", [1.8, 2.1, 2.3])
@pytest.mark.parametrize("towards", [45.0, 225.0])
def test_a_bar_turns_through_the_instant_of_an_interval(start, towards):
    """The rod is across the motion at 135 degrees; an integration that ends there and starts beyond."""
    feet = pp.Points([(-1, 0), (0, 0), (1, 0)])
    slider = pp.Slider(rod_length=2.0, rod_angle=start, radius=1.0)
    scene = pp.Scene(
        slider=slider, contact=pp.PerfectlyRough(), effects=(pp.SupportFriction(support=feet),)
    )
    log = check(run(scene, heading(towards), 1.0, samples=3))
    assert log.attrs["stopped"] == ""

    def rate(_time, angle):
        return [rotation(angle[0], np.deg2rad(towards))]

    exact = solve_ivp(rate, (0, 1.0), [start], method="LSODA", rtol=1e-10, atol=1e-12).y[0, -1]
    assert np.deg2rad(final(log, "rod_angle")) == pytest.approx(exact, abs=1e-7)
