"""Values that a simulation cannot have are refused in one line, before any work."""

from __future__ import annotations

import itertools
from decimal import Decimal

import numpy as np
import pytest
from mechanics.builders import INERTIA, make_scene

import planar_pushing as pp

AHEAD = pp.Pusher(velocity=(0.0, 1.0))
SPEEDS = "a speed of 0, or a number in [1e-140, 1e140]"


def refused(call, name):
    with pytest.raises(pp.InvalidValue) as caught:
        call()
    assert caught.value.name == name
    assert "\n" not in str(caught.value)
    return caught.value


@pytest.mark.parametrize("velocity", [
    (10**400, 1), ("0", "1"), (b"0", 1.0), (np.True_, 1.0), (Decimal(1), 0.0), ([0.0], [1.0]),
    itertools.count(), iter((0.0, 1.0)), "ab", {0.0, 1.0, 2.0}, [(0, (0, 10**400))], [(0, (0, "1"))],
    np.ma.masked, np.array(1.0), {0.0: 1, 1.0: 0}, (np.ma.masked, 1.0),
])  # fmt: skip
def test_a_velocity_is_two_numbers(velocity):
    refused(lambda: pp.Pusher(velocity=velocity), "velocity")


@pytest.mark.parametrize("velocity", [
    (1e308, 1e308), (0.0, 1.1e140), (0.9e-140, 0.0), (5e-324, 0.0), [(0, (0, 1)), (1, (0, 1e200))],
], ids=repr)  # fmt: skip
def test_a_speed_whose_square_is_no_double_is_refused(velocity):
    assert refused(lambda: pp.Pusher(velocity=velocity), "velocity").allowed == SPEEDS


@pytest.mark.parametrize("speed", [0.0, 1e-140, 1.0, 1e140])
def test_other_speeds_are_simulated(speed):
    scene = make_scene(2.0, 0.5)
    duration = 0.01 / speed if speed else 1.0
    pusher = pp.Pusher(velocity=(0.0, speed))
    log = pp.simulate(scene, pusher=pusher, duration=duration, samples=2, rtol=1e-6)
    assert np.isfinite(log.rod_angle).all()
    assert log.pusher[-1, 1] == pytest.approx(speed * duration, rel=1e-12, abs=0)


def test_a_function_of_time_that_returns_such_a_speed_is_refused():
    pusher = pp.Pusher(velocity=lambda _: (0.0, 1e200))
    call = lambda: pp.simulate(make_scene(2.0, 0.5), pusher=pusher, duration=1.0)  # noqa: E731
    assert refused(call, "velocity").allowed == SPEEDS
    huge = pp.Pusher(velocity=lambda _: (0, 10**400))
    refused(lambda: pp.simulate(make_scene(2.0, 0.5), pusher=huge, duration=1.0), "velocity")


@pytest.mark.parametrize(
    "times", [5, "12", (1.0, 1.0), (-1.0,), (np.nan,), (10**400,), (True,)], ids=repr
)
def test_breakpoints_are_increasing_times(times):
    error = refused(lambda: pp.Pusher(velocity=lambda _: (0, 1), breakpoints=times), "breakpoints")
    assert error.allowed == "increasing times >= 0"


@pytest.mark.parametrize(("name", "given"), [
    ("rtol", Decimal("1e-8")), ("rtol", b"1e-8"), ("rtol", np.True_), ("rtol", "1e-8"),
    ("samples", np.True_), ("samples", 10**12), ("samples", 10**400), ("samples", Decimal(3)),
    ("duration", np.array([1.0, 2.0])), ("duration", Decimal(1)), ("duration", np.True_),
    ("gap", np.zeros(2)), ("gap", b"1"), ("method", ["event-driven"]), ("method", None),
    ("on_ambiguity", b"separate"), ("on_ambiguity", 1), ("path", 5), ("path", b"log.nc"),
    ("scene", make_scene(np.array([1.0, 2.0]), 0.5)), ("pusher", (0.0, 1.0)),
], ids=str)  # fmt: skip
def test_values_of_another_type(name, given):
    values = {"scene": make_scene(2.0, 0.5), "pusher": AHEAD, "duration": 1.0} | {name: given}
    refused(lambda: pp.simulate(values.pop("scene"), **values), name)


@pytest.mark.parametrize(
    "twist",
    [("0", 0, 0), (0, 0), 5, None, (1e200, 0, 0), (np.nan, 0, 0), (True, 0, 0), "abc"],
    ids=repr,
)
def test_a_twist_is_three_numbers(twist):
    scene = make_scene(2.0, 0.5, INERTIA)
    call = lambda: pp.simulate(scene, pusher=AHEAD, duration=1.0, twist=twist)  # noqa: E731
    assert refused(call, "twist").allowed == "three finite numbers of at most 1e+140"


@pytest.mark.parametrize(
    "step", [5e-324, 0.9e-9, 0.0, -1.0, np.inf, np.nan, "fine", Decimal("0.1"), np.True_]
)
def test_a_step_cuts_the_duration_into_parts_that_can_be_counted(step):
    call = lambda: pp.simulate(  # noqa: E731
        make_scene(2.0, 0.5), pusher=AHEAD, duration=1.0, method="time-stepping", step=step
    )
    assert refused(call, "step").allowed in ("a finite number > 0", "at most 1e+09 steps")


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"scene": 3}, "scene: 3 given"),
        ({"pusher": (1, 0)}, "pusher: (1, 0) given"),
        ({"duration": 0}, "duration: 0 given; allowed: a finite number > 0"),
        ({"duration": np.nan}, "duration: nan given"),
        ({"method": "euler"}, "method: 'euler' given; allowed: event-driven, time-stepping"),
        ({"rtol": 1e-20}, "rtol: 1e-20 given; allowed: a number in [1e-13, 1e-2]"),
        ({"on_ambiguity": "guess"}, "allowed: keep-contact, separate, stay-in-mode"),
        (
            {"on_ambiguity": "stik"},
            "stick, slip-right, slip-left, or a sequence of (start_time, policy)",
        ),
        ({"on_ambiguity": ["stick", "separate"]}, "on_ambiguity: ['stick', 'separate'] given"),
        ({"on_ambiguity": [(0, "guess")]}, "on_ambiguity: 'guess' given; allowed: keep-contact, "),
        ({"on_ambiguity": [(0.1, "stick")]}, "allowed: start times that begin at 0 and increase"),
        ({"on_ambiguity": []}, "allowed: start times that begin at 0 and increase"),
        ({"on_ambiguity": [(0, "stick"), (0, "separate")]}, "put the pieces in order"),
        ({"on_ambiguity": [(-1, "stick")]}, "on_ambiguity: -1 given; allowed: times >= 0"),
        ({"samples": 1}, "samples: 1 given; allowed: a whole number >= 2"),
        ({"samples": 2.5}, "samples: 2.5 given"),
        ({"twist": (1, 0)}, "twist: (1, 0) given; allowed: three finite numbers"),
        ({"twist": (1, 0, 0)}, "allowed: (0, 0, 0) for a scene without inertia"),
        ({"gap": -1}, "gap: -1 given; allowed: a finite number >= 0"),
        ({"step": 0.1}, "step: 0.1 given; allowed: a number for the time-stepping method only"),
    ],
    ids=str,
)
def test_bad_values_are_refused_before_any_work(tmp_path, change, message):
    values = {
        "scene": make_scene(2, 0.5), "pusher": pp.Pusher(velocity=(0, 1)), "duration": 1.0,
        "path": tmp_path / "log.nc",
    }  # fmt: skip
    values |= change
    with pytest.raises(pp.InvalidValue) as caught:
        pp.simulate(values.pop("scene"), **values)
    assert message in str(caught.value)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(("name", "given"), [
    ("scene", 5), ("scene", pp.Scene), ("pusher", (0.0, 1.0)), ("pusher", None), ("duration", "1"),
    ("duration", [True]), ("duration", None), ("gap", np.array(["0"])), ("twist", "abc"),
    ("twist", (0.0, 1.0)), ("twist", 5), ("samples", 10**12), ("rtol", "1e-8"),
], ids=str)  # fmt: skip
def test_values_of_a_batch(name, given):
    values = {"scene": make_scene(np.array([1.0, 2.0]), 1.0), "pusher": AHEAD, "duration": 1.0}
    refused(lambda: pp.simulate_batch(**(values | {name: given})), name)


@pytest.mark.parametrize(("name", "given"), [
    ("rod_length", ["1", "2"]), ("rod_length", [Decimal(1)]), ("rod_angle", None),
], ids=str)  # fmt: skip
def test_values_of_arrays_of_sliders(name, given):
    values = {"rod_length": [1.0, 2.0], "rod_angle": 1.0} | {name: given}
    refused(lambda: pp.Slider(**values), name)


@pytest.mark.parametrize("given", [Decimal(1), [[1], [1, 2]]], ids=str)
def test_values_of_arrays_of_coefficients(given):
    refused(lambda: pp.Coulomb(given), "friction_coefficient")


@pytest.mark.parametrize("velocity", [
    (0.0, Decimal(1)), None, (0.0, 1e200), (np.array([0.0, 1e-200]), 0.0), (np.ones(2), None),
    (np.ones(2), Decimal(1)), (np.ones(2), np.ones(3)), (np.ma.masked_array([1.0, 2.0], [0, 1]), 0.0),
    (np.array([True, False]), 0.0), (np.array([1e308, 0.0]), 1e308),
], ids=str)  # fmt: skip
def test_velocities_of_a_batch(velocity):
    refused(lambda: pp.Pusher(velocity=velocity), "velocity")


def test_a_batch_of_whole_numbers():
    whole, real = (
        pp.simulate_batch(
            make_scene(np.array([1, 2], dtype), pp.Coulomb(one), psi=one),
            pp.Pusher(velocity=(0 * one, one)), duration=one, rtol=1e-6,
        )
        for dtype, one in ((int, 1), (float, 1.0))
    )  # fmt: skip
    assert whole.identical(real)
