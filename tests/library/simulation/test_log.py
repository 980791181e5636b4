"""The log: its variables, attributes and units, in memory, in files and as a table."""

from __future__ import annotations

import json
from dataclasses import replace

import h5py
import numpy as np
import pytest
import xarray as xr
from mechanics.builders import BOTH, FRICTION, make_scene
from simulation.runs import heading, run

import planar_pushing as pp
from planar_pushing.terms.netcdf import write_dataset
from planar_pushing.terms.quantities import unit_of

FENCE = [(0, heading(60)), (0.5, heading(100))]
METHODS = pytest.mark.parametrize("method", ["event-driven", "time-stepping"])
EFFECTS = pytest.mark.parametrize("effects", [FRICTION, BOTH], ids=["friction", "both"])


@METHODS
@EFFECTS
def test_every_variable_has_units_and_a_name(method, effects):
    log = run(make_scene(2, 0.5, effects), FENCE, 1, method=method, samples=11)
    for name, variable in log.variables.items():
        assert variable.attrs["long_name"], name
        if "units" in variable.attrs:
            assert variable.attrs["units"], name
        else:  # each component has its own
            assert all(log[variable.attrs["component_units"]].values), name
    assert list(log.effect.values) == ["support_friction", "inertia"][: len(effects)]
    assert json.loads(log.attrs["scene"])["contact"]["friction_coefficient"] == 0.5
    assert log.attrs["method"] == method
    assert log.attrs["finished"] == 1
    assert log.attrs["stopped"] == ""
    assert "STICK" in log.mode.attrs["flag_meanings"]


@METHODS
def test_log_holds_the_samples_and_the_jumps_of_the_fence(method):
    log = run(make_scene(2, 0.5), FENCE, 1, method=method, samples=11)
    assert np.all(np.isin(np.linspace(0, 1, 11), log.time))
    assert log.time[0] == 0
    assert log.time[-1] == 1
    assert np.all(np.diff(log.evaluations[:, 0]) >= 0)


LENGTHS = pp.Units(length="mm", force="kN", time="ms")


@pytest.mark.parametrize(("units", "twist", "pose"), [
    (None, ["length/time", "length/time", "radian/time"], "length, length, radian"),
    (LENGTHS, ["mm ms-1", "mm ms-1", "radian ms-1"], "mm, mm, radian"),
], ids=["scaled", "named"])  # fmt: skip
def test_no_variable_mixes_units(tmp_path, units, twist, pose):
    """A twist has a unit for each component, and a pose in the world is two variables."""
    scene = replace(make_scene(2, 0.5), units=units)
    kept = run(scene, FENCE, 0.1, samples=3, object_pose=(1, 2, 3))
    with run(scene, FENCE, 0.1, samples=3, object_pose=(1, 2, 3), path=tmp_path / "a.nc") as file:
        for log in (kept, file.load()):
            assert "units" not in log.twist.attrs
            assert log.twist.attrs["component_units"] == "twist_unit"
            assert log.twist_unit.dims == ("twist_component",)
            assert log.twist_unit.values.tolist() == twist
            assert log.twist.sel(twist_component="omega").twist_unit.item() == twist[2]
            assert log.attrs["initial_twist_units"] == ", ".join(twist)
            assert log.attrs["object_pose_units"] == pose
            assert unit_of(log.object_position.attrs) == pose.partition(",")[0]
            assert unit_of(log.object_angle.attrs) == "degree"
            assert "pose" not in log.dims


ATTRIBUTES = {
    "duration": "f8", "initial_gap": "f8", "initial_twist": "f8", "object_pose": "f8", "rtol": "f8",
    "stopped_time": "f8", "finished": "i1",
}  # fmt: skip


@pytest.mark.parametrize("kind", [int, np.float32, np.asarray])
def test_types_of_attributes_do_not_depend_on_what_is_given(tmp_path, kind):
    two, zero = kind(2), kind(0)
    options = {
        "gap": zero, "twist": (zero, zero, zero), "samples": 3, "rtol": np.float32(1e-8),
        "object_pose": (two, two, zero),
    }  # fmt: skip
    run(make_scene(2, 0.5), (0, 0.1), two, path=tmp_path / "file.nc", **options).close()
    run(make_scene(2, 0.5), (0, 0.1), two, **options).to_netcdf(
        tmp_path / "saved.nc", engine="h5netcdf"
    )
    write_dataset(run(make_scene(2, 0.5), (0, 0.1), two, **options), tmp_path / "written.nc")
    for name in ("file", "saved", "written"):
        with h5py.File(tmp_path / f"{name}.nc") as file:
            found = {each: file.attrs.get_id(each).dtype for each in ATTRIBUTES}
            assert found == ATTRIBUTES, name
            assert file.attrs["duration"] == 2


def test_a_log_that_the_user_writes_has_no_fill_values_of_coordinates(tmp_path):
    log = run(make_scene(2, 0.5), FENCE, 1, samples=3)
    batch = pp.simulate_batch(
        make_scene(2, 0.5), pp.Pusher(velocity=(0, 0.1)), duration=1, samples=3
    )
    with run(make_scene(2, 0.5), FENCE, 1, samples=3, path=tmp_path / "a.nc") as streamed:
        for name, dataset in (("log", log), ("batch", batch), ("streamed", streamed)):
            dataset.to_netcdf(tmp_path / f"{name}.nc", engine="h5netcdf")
            with h5py.File(tmp_path / f"{name}.nc") as file:
                filled = {each for each in dataset.coords if "_FillValue" in file[each].attrs}
                assert not filled, name


# --- Tables --------------------------------------------------------------------------------------

LOG = run(
    make_scene(2, 0.5, BOTH), [(0, heading(60)), (0.5, heading(-60))], 1, object_pose=(1, 2, 0)
)


def test_the_attributes_of_one_log_are_not_those_of_the_next():
    first = run(make_scene(2, 0.5), FENCE, 1, samples=3)
    first.mode.attrs["flag_values"][0] = 99
    first.mode.attrs["long_name"] = "another"
    again = run(make_scene(2, 0.5), FENCE, 1, samples=3)
    assert 99 not in again.mode.attrs["flag_values"]
    assert again.mode.attrs["long_name"] != "another"


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
