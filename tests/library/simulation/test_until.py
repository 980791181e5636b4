"""`until`: where a run stops, against the whole log, closed forms and scipy."""

import numpy as np
import pytest
import xarray as xr
from mechanics.builders import BOTH, make_scene
from scipy.optimize import brentq
from simulation.runs import final, heading, run

import planar_pushing as pp

TURNING = make_scene(2, 0.5)
PULLED = [(0, heading(60)), (0.5, heading(-10))]
METHODS = pytest.mark.parametrize("method", ["event-driven", "time-stepping"])


@pytest.mark.parametrize("shape", ["fence", "finger"])
def test_a_run_until_a_mode_ends_where_the_mode_begins(shape):
    pusher = pp.Pusher(velocity=[(0, heading(60)), (0.5, heading(-60))], shape=shape)
    whole = run(TURNING, pusher, 1.0, on_ambiguity="separate")
    row = int((whole.mode.values == pp.ContactMode.SEPARATE).argmax())
    assert 0 < row < whole.sizes["time"] - 1
    log = run(TURNING, pusher, 1.0, on_ambiguity="separate", until="SEPARATE")
    assert log.attrs["stopped"] == "until: mode SEPARATE"
    xr.testing.assert_equal(log, whole.isel(time=slice(row + 1)))


@pytest.mark.parametrize("samples", [2, 3, 101])
@pytest.mark.parametrize("effects", [make_scene(2, 0.5), make_scene(2, 0.5, BOTH)])
def test_a_rotation_is_reached_at_the_root_of_the_rotation(effects, samples):
    log = run(effects, heading(75), 3.0, samples=samples, until=pp.Until(rotation=0.25))
    turned = np.deg2rad(log.rod_angle.values) - np.pi / 4
    assert abs(turned[-1]) == pytest.approx(0.25, abs=1e-13)
    assert np.all(abs(turned[:-1]) < 0.25)

    def left(duration):
        alone = run(effects, heading(75), duration, samples=2)
        return abs(np.deg2rad(final(alone, "rod_angle")) - np.pi / 4) - 0.25

    assert log.time[-1] == pytest.approx(brentq(left, 0.01, 3.0, xtol=1e-12), abs=1e-8)


@METHODS
def test_distances_of_a_translation_are_speed_times_time(method):
    """Pushed through its center by a fence at rest against it, the slider moves with the fence."""
    scene = make_scene(1, 0.5, psi=np.pi / 2)
    for until in (pp.Until(distance=0.3), pp.Until(pusher_distance=0.3)):
        log = run(scene, (0, 0.5), 2.0, method=method, until=until)
        assert log.time[-1] == pytest.approx(0.6, abs=1e-12 if method == "event-driven" else 2e-3)
    first = pp.Until(pusher_distance=0.2, distance=0.3, rotation=0.1)
    assert final(run(scene, (0, 0.5), 2.0, until=first), "time") == pytest.approx(0.4, abs=1e-12)


def test_the_distance_of_the_pusher_counts_from_its_place_below_a_gap():
    log = run(TURNING, (0, 1), 1.0, gap=0.5, until=pp.Until(pusher_distance=0.25))
    assert final(log, "time") == pytest.approx(0.25, abs=1e-12)
    assert final(log, "gap") == pytest.approx(0.25, abs=1e-12)


def test_a_function_sees_the_instants_of_the_log():
    seen = {}

    def until(now):
        seen.update({now["time"]: now})
        return now["time"] >= 0.123

    log = run(TURNING, PULLED, 1.0, until=until)
    assert final(log, "time") == 0.123
    assert log.attrs["stopped"] == "until: the function returns True"
    for i, time in enumerate(log.time.values):
        assert set(seen[time]) == {"time", *log.data_vars}
        for name in log.data_vars:
            np.testing.assert_array_equal(seen[time][name], log[name].values[i])


def test_a_condition_that_holds_only_between_two_samples_that_see_it_is_found_at_its_start():
    log = run(TURNING, PULLED, 1.0, until=lambda now: 0.305 < now["time"] < 0.4)
    assert final(log, "time") == np.nextafter(0.305, 1)


@METHODS
def test_a_condition_that_holds_at_the_start_leaves_one_instant(method):
    log = run(TURNING, PULLED, 1.0, method=method, until=lambda now: True)
    assert log.time.values.tolist() == [0]
    log = run(TURNING, PULLED, 1.0, method=method, until=pp.ContactMode(int(log.mode[0])))
    assert log.time.values.tolist() == [0]


@METHODS
def test_a_condition_that_never_holds_leaves_the_whole_run(method):
    log = run(TURNING, PULLED, 1.0, method=method, until=pp.Until(rotation=12))
    xr.testing.assert_identical(log, run(TURNING, PULLED, 1.0, method=method))


def test_a_run_that_cannot_go_on_says_so_and_not_until():
    until = pp.Until(pusher_distance=0.8)
    log = run(make_scene(2, psi=np.deg2rad(15)), (0, 1), 9.0, until=until)
    assert log.attrs["stopped"] == "the slider's center comes down to the fence"
    assert final(log, "time") < 0.8


@METHODS
def test_a_streamed_run_ends_there_too(tmp_path, method):
    given = {"method": method, "samples": 400, "until": pp.Until(rotation=0.15)}
    kept = run(TURNING, PULLED, 1.0, **given)
    assert kept.attrs["stopped"] == "until: rotation 0.15"
    with run(TURNING, PULLED, 1.0, path=tmp_path / "a.nc", **given) as streamed:
        xr.testing.assert_identical(
            kept.drop_attrs(deep=False), streamed.load().drop_attrs(deep=False)
        )
        assert streamed.attrs["stopped"] == kept.attrs["stopped"]


def test_time_stepping_stops_at_the_end_of_a_step_and_goes_the_same_way_until_then():
    given = {"method": "time-stepping", "step": 0.013}
    log = run(TURNING, PULLED, 1.0, **given, until=pp.Until(rotation=0.15))
    turned = abs(np.deg2rad(log.rod_angle.values) - np.pi / 4)
    assert turned[-1] >= 0.15
    whole = run(TURNING, PULLED, 1.0, **given)
    np.testing.assert_allclose(log.rod_angle[:-1], whole.rod_angle[: log.sizes["time"] - 1])
    between = run(TURNING, PULLED, 1.0, **given, samples=2)
    assert log.time[-1] < between.time[-1]
    # The samples are 0.01 apart, and so is a step between two of them.
    assert np.isclose(log.time[-1] * 100, np.round(log.time[-1] * 100))
    alone = run(TURNING, PULLED, 1.0, **given, samples=2, until=pp.Until(rotation=0.15))
    assert abs(np.deg2rad(final(alone, "rod_angle")) - np.pi / 4) < 0.15 + 0.02
