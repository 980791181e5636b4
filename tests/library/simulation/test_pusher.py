"""The pusher's motion in a log: pieces, waypoints, and functions of time as polynomials."""

from __future__ import annotations

import io
import math
import pickle
import time
from dataclasses import replace

import numpy as np
import pandas as pd
import pytest
import xarray as xr
from mechanics.builders import make_scene
from simulation.runs import final, run

import planar_pushing as pp

SCENE = make_scene(2, 0.5)
#: Far from a pusher that may come down to the slider.
FAR = {"gap": 50.0}


def displacement(velocity, duration, samples=101, breakpoints=(), **options):
    """Times and displacement of a pusher that is far from the slider."""
    pusher = pp.Pusher(velocity=velocity, breakpoints=breakpoints)
    log = run(SCENE, pusher, duration, samples=samples, **options, **FAR)
    return log.time.values, np.add(log.pusher.values, (0.0, FAR["gap"]))


def test_the_acceleration_of_a_function_is_that_of_its_polynomials():
    """A mass that sticks has no force but that of the acceleration."""
    scene = make_scene(2, pp.PerfectlyRough(), (pp.Inertia(mass=2.0),), psi=np.pi / 2)
    log = run(scene, pp.Pusher(velocity=lambda t: (0.0, 0.4 * t + math.sin(5 * t))), 1.0)
    wanted = 2.0 * (0.4 + 5 * np.cos(5 * log.time.values))
    assert log.force.values[:, 1] == pytest.approx(wanted, abs=1e-9)
    assert log.twist.values[:, 1] == pytest.approx(0.4 * log.time + np.sin(5 * log.time), abs=1e-9)


def test_each_side_of_a_breakpoint_has_its_own_polynomials():
    def velocity(t):
        return 0.0, 1.0 if t < 1 else t

    times, path = displacement(velocity, 2.0, breakpoints=(1.0,))
    wanted = np.where(times < 1, times, 0.5 + times**2 / 2)
    assert path[:, 1] == pytest.approx(wanted, abs=2e-14)
    log = run(
        make_scene(1, 0.5, psi=np.pi / 2), pp.Pusher(velocity=velocity, breakpoints=(1.0,)), 2.0
    )
    assert log.twist[:, 1].values == pytest.approx(np.maximum(1, log.time.values), abs=1e-13)


def test_a_function_with_a_jump_takes_no_forever():
    start = time.perf_counter()
    for gap in (0.0, FAR["gap"]):
        log = run(
            SCENE, pp.Pusher(velocity=lambda t: (0.0, 1.0 if t < 1 / 3 else 2.0)), 1.0, gap=gap
        )
        assert final(log, "pusher") == pytest.approx((0, 5 / 3 - gap), abs=1e-8)
        assert final(log, "evaluations").max() < 10_000
    assert time.perf_counter() - start < 30


def test_what_rounding_leaves_of_a_velocity_is_zero():
    """So that a slider is not pushed at once by a fence that starts from rest."""
    log = run(SCENE, pp.Pusher(velocity=lambda t: (0.0, t * t)), 1.0, samples=3)
    assert not log.twist[0].values.any()
    assert log["mode"][0] == pp.ContactMode.SEPARATE
    assert log["mode"][-1] != pp.ContactMode.SEPARATE


@pytest.mark.parametrize("method", ["event-driven", "time-stepping"])
@pytest.mark.parametrize(
    "velocity",
    [(1.0, -0.2), [(0, (1.0, -0.2)), (0.2, (0.9, -0.2))], lambda t: (1.0, -0.2 - 0.1 * t)],
    ids=["constant", "pieces", "function"],
)
def test_each_policy_begins_at_its_time(velocity, method):
    """Also between the pieces of the velocity, and at their breaks."""
    scene, pusher = make_scene(2, 2.0), pp.Pusher(velocity=velocity)
    policies = [(0, "stick"), (0.1, "slip-left"), (0.2, "separate"), (3.0, "stick")]
    log = run(scene, pusher, 0.3, on_ambiguity=policies, method=method)
    for mode, start, end in ((1, 0.0, 0.1), (3, 0.1, 0.2), (0, 0.2, 0.3)):
        assert set(log.sel(time=slice(start + 1e-3, end - 1e-3))["mode"].values) == {mode}
    times, path = log.time.values, log.pusher.values
    alone = run(scene, pusher, 0.3)
    for axis in (0, 1):
        wanted = np.interp(times, alone.time.values, alone.pusher.values[:, axis])
        assert path[:, axis] == pytest.approx(wanted, abs=1e-5)


def test_arrays_are_velocities():
    log = run(SCENE, np.array([0.0, 1.0]), 0.5)
    assert final(log, "pusher") == pytest.approx([0, 0.5], abs=1e-12)


# --- Waypoints -----------------------------------------------------------------------------------

#: There and back, a stop, the same place again, and a jump in speed.
WAYPOINTS = [
    (0, (2, 1)),
    (0.4, (2.1, 1.4)),
    (0.7, (2.1, 1.4)),
    (1.0, (1.9, 1.8)),
    (1.1, (1.9, 1.7)),
]


@pytest.mark.parametrize("shape", ["fence", "finger"])
@pytest.mark.parametrize("method", ["event-driven", "time-stepping"])
@pytest.mark.parametrize("gap", [0.0, 0.25])
def test_the_pusher_is_on_the_straight_way_between_the_waypoints(shape, method, gap):
    pusher = pp.Pusher(waypoints=WAYPOINTS, shape=shape)
    log = run(SCENE, pusher, 1.5, method=method, gap=gap)
    times, places = [t for t, _ in WAYPOINTS], np.array([p for _, p in WAYPOINTS]) - (2, 1 + gap)
    for axis in (0, 1):
        way = np.interp(log.time, times, places[:, axis])
        np.testing.assert_allclose(log.pusher[:, axis], way, atol=4e-15)
    assert set(times) <= set(log.time.values)


def test_waypoints_are_pieces_of_constant_velocity():
    velocity = [(0, (0.0, 1.0)), (0.5, (-0.5, 0.25)), (1.5, (0.0, 0.0))]
    waypoints = [(0, (0, 0)), (0.5, (0, 0.5)), (1.5, (-0.5, 0.75))]
    pushers = [pp.Pusher(velocity=velocity), pp.Pusher(waypoints=waypoints)]
    xr.testing.assert_identical(*(run(SCENE, each, 2.0) for each in pushers))
    xr.testing.assert_identical(*(pp.simulate_batch(SCENE, each, duration=2.0) for each in pushers))


ROWS = [(0.0, 0.1, 1.0), (0.2, 0.0, 0.5), (0.5, -0.1, 0.0)]
PIECES = [(start, (x, y)) for start, x, y in ROWS]
#: The same velocities in the forms in which tables are read.
TABLES = {
    "array": np.array(ROWS),
    "labeled": xr.DataArray(ROWS),
    "frame": pd.DataFrame(ROWS, columns=["time", "v_x", "v_y"], index=[7, 8, 9]),
    "other order": pd.DataFrame(ROWS, columns=["time", "v_x", "v_y"])[["v_y", "time", "v_x"]],
    "records": np.array(ROWS, dtype=[("time", "f4"), ("v_x", "f8"), ("v_y", "f8")]),
    "csv": pd.read_csv(io.StringIO("time,v_x,v_y\n0,0.1,1\n0.2,0,0.5\n0.5,-0.1,0\n")),
}


@pytest.mark.parametrize("name", TABLES)
def test_a_table_of_velocities_is_a_sequence_of_pieces(name):
    single = pytest.approx(np.float32(0.2), abs=0) if name == "records" else 0.2
    pusher = pp.Pusher(velocity=TABLES[name], shape="finger")
    assert [start for start, _ in pusher.pieces] == [0.0, single, 0.5]
    assert [velocity for _, velocity in pusher.pieces] == [(0.1, 1.0), (0.0, 0.5), (-0.1, 0.0)]
    if name != "records":
        assert pusher == pp.Pusher(velocity=PIECES, shape="finger")
    assert pickle.loads(pickle.dumps(pusher)) == replace(pusher) == pusher


@pytest.mark.parametrize("name", ["array", "frame"])
def test_runs_and_batches_with_a_table_are_those_with_pieces(name):
    table, pieces = (pp.Pusher(velocity=value) for value in (TABLES[name], PIECES))
    assert run(SCENE, table, 0.8).identical(run(SCENE, pieces, 0.8))
    angles = make_scene(2, 0.5, psi=np.array([0.8, 1.1]))
    batches = [pp.simulate_batch(angles, pusher, duration=0.8) for pusher in (table, pieces)]
    assert batches[0].identical(batches[1])


def test_an_assessment_with_a_table_is_that_with_pieces():
    table, pieces = (
        pp.assess_push(SCENE, pp.Pusher(velocity=value), duration=0.8)
        for value in (TABLES["frame"], PIECES)
    )
    assert table.effects.identical(pieces.effects)
    assert table.inputs.identical(pieces.inputs)


def test_waypoints_are_a_table_too():
    path = [(0.0, (0.0, 0.0)), (0.5, (0.0, 0.4)), (1.0, (0.2, 0.6))]
    rows = pd.DataFrame([(time, *position) for time, position in path], columns=["time", "x", "y"])
    wanted = pp.Pusher(waypoints=path)
    assert pp.Pusher(waypoints=rows) == pp.Pusher(waypoints=rows.to_numpy()) == wanted


FRAME = TABLES["csv"]
WRONG_TABLES = {
    "unknown": (
        FRAME.rename(columns={"v_x": "vx"}),
        "a table with the columns time, vx, v_y' given; allowed: time, v_x, v_y; did you mean v_x?",
    ),
    "one more": (FRAME.assign(omega=0.0), "time, v_x, v_y, omega' given; allowed: time, v_x, v_y; name"),
    "one less": (FRAME[["time", "v_x"]], "time, v_x' given; allowed: time, v_x, v_y; name"),
    "twice": (FRAME[["time", "v_x", "v_x"]], "time, v_x, v_x' given; allowed: time, v_x, v_y; name"),
    "shape": (np.ones((2, 5)), "an array of shape (2, 5)' given; allowed: shape (rows, 3); give time,"),
    "empty": (np.ones((0, 3)), "velocity: [] given; allowed: (v_x, v_y), a sequence of"),
    "gap": (FRAME.replace({"v_y": {0.5: np.nan}}), "nan in row 1 of v_y' given; allowed: finite numbers"),
    "text": (FRAME.astype({"v_x": str}), "a column v_x of other values' given; allowed: finite"),
    "masked": (np.ma.masked_equal(ROWS, 0.5), "a column time of other values' given; allowed: finite"),
    "order": (FRAME[::-1], "start times that begin at 0 and increase"),
    "fast": (FRAME.replace({"v_y": {0.5: 1e200}}), "1e+200 given; allowed: a speed of 0, or a number in"),
}  # fmt: skip


@pytest.mark.parametrize("name", WRONG_TABLES)
def test_a_wrong_table_is_refused_in_one_line(name):
    table, words = WRONG_TABLES[name]
    with pytest.raises(pp.InvalidValue) as refusal:
        pp.Pusher(velocity=table)
    assert words in str(refusal.value)
    assert str(refusal.value).startswith("velocity: ")
    assert "\n" not in str(refusal.value)
