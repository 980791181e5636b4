"""Waypoints: the pusher is at each of them at its time, and moves straight between them."""

import numpy as np
import pytest
import xarray as xr

import planar_pushing as pp
from mechanics.builders import make_scene
from simulation.runs import run

#: There and back, a stop, the same place again, and a jump in speed.
WAYPOINTS = [
    (0, (2, 1)),
    (0.4, (2.1, 1.4)),
    (0.7, (2.1, 1.4)),
    (1.0, (1.9, 1.8)),
    (1.1, (1.9, 1.7)),
]
SCENE = make_scene(2, 0.5)


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
    logs = [
        run(SCENE, pp.Pusher(**given), 2.0)
        for given in ({"velocity": velocity}, {"waypoints": waypoints})
    ]
    xr.testing.assert_identical(*logs)
    batches = [
        pp.simulate_batch(SCENE, pp.Pusher(**given), duration=2.0)
        for given in ({"velocity": velocity}, {"waypoints": waypoints})
    ]
    xr.testing.assert_identical(*batches)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"waypoints": [(0, (0, 0)), (1, (0, 1)), (0.5, (1, 1))]}, "times that begin at 0 and increase"),
        ({"waypoints": [(0, (0, 0)), (0, (0, 1))]}, "times that begin at 0 and increase"),
        ({"waypoints": [(1, (0, 0)), (2, (0, 1))]}, "times that begin at 0 and increase"),
        ({"waypoints": [(-1, (0, 0)), (2, (0, 1))]}, "waypoints: -1 given; allowed: times >= 0"),
        ({"waypoints": [(0, (0, 0))]}, "allowed: at least two (time, (x, y)) of finite numbers"),
        ({"waypoints": []}, "waypoints: [] given; allowed: at least two"),
        ({"waypoints": 3}, "waypoints: 3 given; allowed: at least two"),
        ({"waypoints": [(0, (0, 0)), (1, 2)]}, "allowed: at least two"),
        ({"waypoints": [(0, 0, 0), (1, 2, 3)]}, "allowed: at least two"),
        ({"waypoints": [(0, (0, 0)), (1, (0, np.nan))]}, "allowed: at least two"),
        ({"waypoints": [(0, (0, 0)), (1e-200, (0, 1))]}, "velocity"),
        ({"waypoints": WAYPOINTS, "velocity": (0, 1)}, "velocity: (0, 1) given; allowed: none with"),
        ({}, "velocity: None given; allowed: (v_x, v_y)"),
    ],
    ids=str,
)  # fmt: skip
def test_bad_waypoints_are_refused(given, message):
    with pytest.raises(pp.InvalidValue) as caught:
        pp.Pusher(**given)
    assert message in str(caught.value)
    assert "\n" not in str(caught.value)
