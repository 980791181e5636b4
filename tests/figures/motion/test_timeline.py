"""What pictures of motion show of a log."""

import numpy as np
import pytest
import xarray as xr
from numpy.testing import assert_allclose

from figures.conftest import LOGS
from planar_pushing.figures.motion.timeline import contact, plotted, rows, runs
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
