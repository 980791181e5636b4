"""The log: its variables and attributes, and logs that are streamed to a file."""

from __future__ import annotations

import json
import subprocess
import sys
import threading
from dataclasses import replace

import h5py
import numpy as np
import pytest
import xarray as xr

import planar_pushing as pp
from mechanics.builders import BOTH, FRICTION, make_scene
from planar_pushing.simulation.problem import Problem
from planar_pushing.simulation.runs import Run
from planar_pushing.study.store import write_dataset
from planar_pushing.terms.quantities import unit_of
from simulation.runs import final, heading, run

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


@EFFECTS
def test_dissipation_grows_and_geometry_agrees(effects):
    scene = make_scene(2, 0.5, effects, radius=0.5)
    log = run(scene, FENCE, 1)
    assert np.all(np.diff(log.dissipated.values, axis=0) >= -1e-12)
    assert np.all(np.diff(log.contact_dissipated.values) >= -1e-12)
    psi = np.deg2rad(log.rod_angle.values)
    contact = log.position.values - 2 * np.stack([np.cos(psi), np.sin(psi)], axis=-1)
    assert contact[:, 1] - log.pusher.values[:, 1] == pytest.approx(log.gap.values, abs=1e-12)
    touching = np.all(log.gap.values == 0)
    if touching:
        along = contact[:, 0] - log.pusher.values[:, 0]
        assert along == pytest.approx(log.slip.values, abs=1e-10)


@METHODS
@EFFECTS
def test_streamed_log_is_the_log(tmp_path, method, effects):
    scene = make_scene(2, 0.5, effects)
    options = {"method": method, "samples": 300}
    kept = run(scene, FENCE, 1, **options)
    with run(scene, FENCE, 1, path=tmp_path / "a.nc", **options) as streamed:
        xr.testing.assert_identical(
            kept.drop_attrs(deep=False), streamed.load().drop_attrs(deep=False)
        )
        assert set(streamed.attrs) == set(kept.attrs)
        assert streamed.attrs["finished"] == 1
        assert streamed.attrs["scene"] == kept.attrs["scene"]


def test_streamed_log_is_the_same_bytes_again(tmp_path):
    for name in ("a.nc", "b.nc"):
        run(make_scene(2, 0.5), FENCE, 1, path=tmp_path / name).close()
    assert (tmp_path / "a.nc").read_bytes() == (tmp_path / "b.nc").read_bytes()


def test_records_are_handed_on_in_bounded_batches():
    problem = Problem(scene=make_scene(2, 0.5), pusher=pp.Pusher(velocity=FENCE), duration=1)
    sizes = [len(each) for each in Run(problem, np.linspace(0, 1, 5000))]
    assert sum(sizes) >= 5000
    assert len(sizes) > 3
    assert max(sizes) < 1000


KILLED = """
import os
import planar_pushing as pp
from planar_pushing.simulation import stream
scene = pp.Scene(slider=pp.Slider(rod_length=2, rod_angle=0.8), contact=pp.Coulomb(0.5),
                 effects=(pp.RingFriction(),))
append, count = stream.Stream.append, 0
def dies(self, records):
    global count
    append(self, records)
    count += 1
    if count == 2:
        os.kill(os.getpid(), 9)
stream.Stream.append = dies
pp.simulate(scene, pusher=pp.Pusher(velocity=lambda t: (0.0, 1.0)), duration=1, samples=5000,
            path="log.nc")
"""


def test_killed_run_leaves_a_readable_log(tmp_path):
    ended = subprocess.run([sys.executable, "-c", KILLED], cwd=tmp_path, check=False)
    assert ended.returncode == -9
    with xr.open_dataset(tmp_path / "log.nc", engine="h5netcdf") as log:
        assert log.attrs["finished"] == 0
        assert 256 < log.sizes["time"] < 5000
        assert np.isfinite(log.rod_angle).all()
        assert log.rod_angle[-1] < 45.9
        assert unit_of(log.force.attrs) == "force"


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


@pytest.mark.parametrize("kind", [int, float, np.int32, np.float32, np.asarray])
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


def test_two_runs_do_not_write_one_log(tmp_path):
    """The second run, started while the first is writing, is refused; the first one is complete."""
    path, refusals = tmp_path / "log.nc", []

    def begin():
        with pytest.raises(pp.InvalidFile) as caught:
            run(make_scene(2, 0.5), FENCE, 1, path=path)
        refusals.append(str(caught.value))

    def until(now):
        if not refusals:
            begin()
            thread = threading.Thread(target=begin)
            thread.start()
            thread.join()
        return False

    run(make_scene(2, 0.5), FENCE, 1, path=path).close()
    with run(make_scene(2, 0.5), FENCE, 1, path=path, until=until) as log:
        assert log.attrs["finished"] == 1
        assert np.all(np.diff(log.time) > 0)
    assert refusals == [f"{path}: another process is writing it; name another file"] * 2
    assert [each.name for each in tmp_path.iterdir()] == ["log.nc"]


def test_progress_is_shown_on_demand(capsys):
    run(make_scene(2, 0.5), FENCE, 1, progress=True)
    assert "time" in capsys.readouterr().err
    run(make_scene(2, 0.5), FENCE, 1)
    assert capsys.readouterr().err == ""


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


@pytest.mark.parametrize(
    "velocity",
    [
        3, None, "ab", (1,), (1, 2, 3), (1, np.nan), [], [(0, 1)], [(1, (0, 1))],
        [(0, (0, 1)), (0, (0, 2))], [(0, (0, np.inf))],
    ],
    ids=str,
)  # fmt: skip
def test_velocities_of_another_shape_are_refused(velocity):
    with pytest.raises(pp.InvalidValue, match=r"velocity: .* given; allowed: "):
        pp.Pusher(velocity=velocity)


def test_function_that_returns_no_velocity_is_refused():
    with pytest.raises(pp.InvalidValue, match=r"velocity: 1\.0 given"):
        run(make_scene(2, 0.5), pp.Pusher(velocity=lambda _: 1.0), 1)


def test_breakpoints_in_disorder_are_refused():
    with pytest.raises(pp.InvalidValue, match="breakpoints"):
        pp.Pusher(velocity=lambda _: (0, 1), breakpoints=(2, 1))


def test_file_that_cannot_be_written(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(pp.InvalidFile, match="cannot be written"):
        run(make_scene(2, 0.5), FENCE, 1, path=tmp_path / "file" / "log.nc")


def test_arrays_are_velocities():
    log = run(make_scene(2, 0.5), np.array([0.0, 1.0]), 0.5)
    assert final(log, "pusher") == pytest.approx([0, 0.5], abs=1e-12)
