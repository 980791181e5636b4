"""What pictures of motion show of a log."""

import numpy as np
import pytest
import xarray as xr
from numpy.testing import assert_allclose

from figures.conftest import LOGS, OTHERS
from planar_pushing.figures.motion.timeline import contact, impacts, pivots, plotted, rows, runs
from planar_pushing.figures.parts.bodies import body_of
from planar_pushing.figures.parts.supports import Pose
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.terms.errors import InvalidFile


@pytest.mark.parametrize("name", LOGS)
def test_the_motion_centre_is_the_point_that_stands_still(logs, name):
    log = logs[name]
    found = plotted(log).path_center.values
    v_x, v_y, omega = log.twist.values.T  # the radius is 1
    arm = found - log.position.values
    turning = omega != 0
    velocity = np.stack([v_x - omega * arm[:, 1], v_y + omega * arm[:, 0]])[:, turning]
    assert turning.any()
    assert_allclose(velocity, 0, atol=1e-12)


@pytest.mark.parametrize("name", LOGS)
def test_the_contact_is_the_end_of_the_rod_above_the_fence(logs, name):
    motion = plotted(logs[name])
    height = contact(motion)[:, 1] - motion.path_fence.sel(xy="y").values
    assert_allclose(height, motion.path_gap, rtol=0, atol=1e-9)


def test_runs_cover_the_time_and_tell_a_choice(logs):
    found = list(runs(plotted(logs["figure_14a"])))
    assert [(run.start, run.stop, run.several) for run in found] == [(0, 32, False), (32, 96, True)]
    modes = [ContactMode(run.mode).name for run in runs(plotted(logs["pulling_with_inertia"]))]
    assert modes[-3:] == ["STICK", "SLIP_RIGHT", "SEPARATE"]


def test_rows_are_spread_over_the_time(logs):
    assert rows(plotted(logs["figure_15"]), 5) == [0, 24, 48, 72, 96]


def test_a_dataset_that_is_no_log_is_refused(logs):
    with pytest.raises(InvalidFile, match=r"the dataset lacks position, .*a log of planar-pushing"):
        plotted(xr.Dataset())
    broken = logs["figure_15"].assign_attrs(scene="Scene(...)")
    with pytest.raises(InvalidFile, match="the dataset lacks scene"):
        plotted(broken)


@pytest.mark.parametrize("name", OTHERS)
def test_a_log_of_another_support_keeps_its_scene(others, name):
    data = plotted(others[name])
    assert data.attrs["scene"] == others[name].attrs["scene"]
    assert body_of(data) == body_of(others[name])


def test_a_log_of_a_ring_is_as_it_was(logs):
    data = plotted(logs["figure_15"])
    assert not data.attrs
    assert "path_pivot" not in data


def test_a_pivot_is_a_support_point_that_stands_still(others):
    log = others["stool"]
    data = plotted(log)
    (span,) = pivots(data)
    pivoting = data.isel(time=slice(span.start, span.stop + 1))
    assert set(pivoting.path_pivot.values) == {2}
    foot = body_of(log).support.positions[2]
    places = [
        Pose(origin, np.deg2rad(angle)).at(foot)
        for origin, angle in zip(pivoting.path_position.values, pivoting.path_rod_angle, strict=True)
    ]  # fmt: skip
    assert np.ptp(places, axis=0) == pytest.approx([0, 0], abs=1e-6)
    assert_allclose(pivoting.path_center, places, rtol=0, atol=1e-6)
    assert (data.path_pivot.values[: span.start] == -1).all()
    assert (data.path_pivot.values[span.stop + 1 :] == -1).all()


def test_an_area_has_no_pivots(others):
    data = plotted(others["box"])
    assert (data.path_pivot.values == -1).all()
    assert not any(pivots(data))


def test_the_velocity_that_jumps_is_that_of_the_centre_of_mass(others):
    assert impacts(others["box"]) == []
    assert impacts(others["stool"]) == []
