"""Logs as tables: every number of the log is in its row and column."""

import numpy as np
import pytest
import xarray as xr

import planar_pushing as pp
from mechanics.builders import BOTH, make_scene
from simulation.runs import heading, run

LOG = run(
    make_scene(2, 0.5, BOTH), [(0, heading(60)), (0.5, heading(-60))], 1, object_pose=(1, 2, 0)
)


def test_a_row_an_instant_and_a_column_a_component():
    table = pp.to_pandas(LOG)
    assert table.index.name == "time"
    assert table.index.tolist() == LOG.time.values.tolist()
    for name, dim in (("position", "xy"), ("twist", "twist_component"), ("object_position", "xy"),
                      ("dissipated", "effect")):  # fmt: skip
        for i, label in enumerate(LOG[dim].values):
            np.testing.assert_array_equal(table[f"{name}_{label}"], LOG[name].values[:, i])
    for name in ("rod_angle", "slip", "work", "solutions", "adhesive"):
        np.testing.assert_array_equal(table[name], LOG[name])
    count = sum(int(np.prod(variable.shape[1:])) for variable in LOG.data_vars.values())
    assert table.shape == (LOG.sizes["time"], count)
    assert {"twist_omega", "dissipated_inertia", "object_position_x", "object_angle"} <= set(
        table.columns
    )


def test_flags_are_categories_by_name():
    table = pp.to_pandas(LOG)
    for name, enum in (("mode", pp.ContactMode), ("event", pp.Event), ("outcome", pp.Outcome)):
        assert table[name].dtype == "category"
        assert table[name].tolist() == [enum(value).name for value in LOG[name].values]
    assert {"SLIP_LEFT", "SEPARATE"} <= set(table["mode"])
    assert "NONE" in table["mode"].cat.categories


def test_a_log_from_a_file_is_the_same_table(tmp_path):
    LOG.to_netcdf(tmp_path / "log.nc", engine="h5netcdf")
    with xr.open_dataset(tmp_path / "log.nc", engine="h5netcdf") as log:
        assert pp.to_pandas(log).equals(pp.to_pandas(LOG))


def test_something_else_is_refused():
    batch = pp.simulate_batch(make_scene(2, 0.5), pp.Pusher(velocity=(0, 1)), duration=0.1)
    for given in (batch, LOG.rod_angle, 3):
        with pytest.raises(pp.InvalidValue, match=r"log: .* given; allowed: a log of simulate"):
            pp.to_pandas(given)
