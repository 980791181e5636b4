"""Supports over time: a ring by both of its routes, pivots, bars, and supports of a user's own class."""

from __future__ import annotations

import json

import numpy as np
import pytest
from mechanics.supports.cases import FRAME
from mechanics.supports.test_own_kinds import Own
from mechanics.supports.test_own_kinds import scene as scene_of
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from simulation.runs import check, final, heading, run
from simulation.scenes import HEAVY, METHODS, RING, TRIPOD, friction, scene

import planar_pushing as pp
from planar_pushing.drawing.timeline import path_data

STICK, LEFT = pp.ContactMode.STICK, pp.ContactMode.SLIP_LEFT


@pytest.mark.parametrize("masses", [(), (HEAVY,)], ids=["friction", "both"])
@pytest.mark.parametrize(
    ("shape", "mu", "modes"), [("fence", 0.4, {STICK, LEFT}), ("finger", 0.2, {LEFT})]
)
@pytest.mark.parametrize("method", METHODS)
def test_a_ring_that_takes_the_general_route_moves_as_the_ring(masses, shape, mu, modes, method):
    general = friction(pp.Composite([(1.0, pp.Ring(1.0))]))
    pusher, step = pp.Pusher(velocity=(0.3, 1.0), shape=shape), {"step": 0.02}
    ring, other = (
        run(scene(each, *masses, mu=mu), pusher, 0.8, samples=5, method=method,
            **(step if method == "time-stepping" else {}))
        for each in (RING, general)
    )  # fmt: skip
    assert {int(mode) for mode in ring.mode} >= modes
    assert np.array_equal(other.mode, ring.mode)
    for name in ("time", "rod_angle", "position", "slip", "twist", "force", "work"):
        # The last entry before an event lies as near to it as the tolerance says.
        assert np.allclose(other[name], ring[name], rtol=1e-8, atol=1e-8), name


# --- Feet ----------------------------------------------------------------------------------------


def slipping(psi, mu):
    """A tripod that slips."""
    return scene(TRIPOD, mu=mu, psi=psi)


@pytest.mark.parametrize(
    ("psi", "mu", "velocity", "duration"),
    [(2.0, 0.2, (-0.2, 1.0), 2.0), (1.2, 0.3, (0.3, 1.0), 2.5)],
    ids=["right", "left"],
)
def test_a_pivot_starts_at_an_event(psi, mu, velocity, duration):
    log = check(run(slipping(psi, mu), velocity, duration, samples=2))
    assert log.sizes["time"] == 3
    event, angle = float(log.time[1]), np.deg2rad(float(log.rod_angle[1]))
    towards = np.arctan2(*velocity[::-1])
    for side in (-1, 1):
        turned = np.sign(log.rod_angle[-1] - log.rod_angle[0]).item() * side
        (slip,) = pp.solve(slipping(angle + 1e-9 * turned, mu), towards)
        assert (slip.pivot >= 0) == (side > 0)

    def turns(_, state):
        (slip,) = pp.solve(slipping(state[0], mu), towards, np.hypot(*velocity))
        return [slip.twist[2]]

    state, rtol = [psi], {"method": "DOP853", "rtol": 1e-12, "atol": 1e-12}
    for span in ((0.0, event), (event, duration)):
        state = solve_ivp(turns, span, state, **rtol).y[:, -1]
    assert final(log, "rod_angle") == pytest.approx(np.rad2deg(state[0]), abs=1e-8)


@pytest.mark.parametrize("method", METHODS)
def test_a_slider_pivots_about_a_foot_for_a_while_and_rests(method):
    """About foot 0 from 0.934 on, at rest from 1.093 on, by an integration of its own."""
    pivoting = scene(TRIPOD, pp.Inertia(), length=1.0, psi=np.pi / 2, mu=0.5)
    step = {"step": 5.0 / 4000} if method == "time-stepping" else {}
    log = run(pivoting, (0.0, -1.0), 5.0, twist=(0.2, 0.1, 1.0), method=method, **step)
    exact = method == "event-driven"
    angle, place = final(log, "rod_angle"), final(log, "position") - log.position.values[0]
    assert angle == pytest.approx(119.369131, abs=2e-6 if exact else 0.1)
    assert place == pytest.approx([0.147276, 0.070000], abs=1e-6 if exact else 1e-3)
    rests = log.time.values[log.kinetic_energy.values > 1e-12].max()
    assert rests == pytest.approx(1.093, abs=0.06)
    if exact:
        turns = log.time.values[log.pivot.values == 0]
        assert turns.min() == pytest.approx(0.934, abs=2e-3)
        assert set(log.pivot.values) == {-1, 0}
        assert {pp.Event.MOTION_CENTER_AT_POINT, pp.Event.SLIDER_STOPS} <= set(log.event.values)


# --- Bars, pushed across the line of their feet, where the rotation at an instant is an interval ---


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
    pivoting = pp.Scene(
        slider=slider, contact=pp.PerfectlyRough(), effects=(pp.SupportFriction(support=feet),)
    )
    log = check(run(pivoting, heading(towards), 1.0, samples=3))
    assert log.attrs["stopped"] == ""

    def rate(_time, angle):
        return [rotation(angle[0], np.deg2rad(towards))]

    exact = solve_ivp(rate, (0, 1.0), [start], method="LSODA", rtol=1e-10, atol=1e-12).y[0, -1]
    assert np.deg2rad(final(log, "rod_angle")) == pytest.approx(exact, abs=1e-7)


# --- A user's own class --------------------------------------------------------------------------


@pytest.mark.parametrize(
    "own", [Own(FRAME), pp.Composite([(2.0, Own(FRAME))])], ids=["own", "member"]
)
def test_it_is_simulated_and_no_file_holds_it(own, tmp_path):
    push = {"pusher": pp.Pusher(velocity=(0.1, 1.0)), "duration": 0.2, "samples": 3}
    log, wanted = (pp.simulate(scene_of(each), **push) for each in (own, FRAME))
    assert np.array_equal(log["rod_angle"], wanted["rod_angle"])
    (effect,) = json.loads(log.attrs["scene"])["effects"]
    alone = own.__class__ is Own
    entry = effect["support"] if alone else effect["support"]["members"][0]["support"]
    (plate,) = FRAME.pieces().plates
    assert entry == {"shape": "Own", "pieces": {"plates": [plate.tolist()]}}
    assert pp.draw(scene_of(own), 1.4).figure
    with pytest.raises(pp.InvalidFile, match=r"support of your own class.* Composite of them"):
        path_data(log)
    with pytest.raises(
        pp.InvalidValue, match=r"support: .*allowed: the shapes of scene files: .*Composite"
    ):
        pp.save_scene(scene_of(own), tmp_path / "scene.yaml")
    assert not list(tmp_path.iterdir())
