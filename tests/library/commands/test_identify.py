"""The command `identify`: what it prints, the scene file that other commands take, and wrong input."""

import contextlib
import inspect
import io
import json
import re
from dataclasses import replace

import numpy as np
import pytest
from commands.calls import called_once
from ruamel.yaml import YAML

import planar_pushing as pp
from planar_pushing.commands import identify as command
from planar_pushing.commands import main
from planar_pushing.pushes.fit.candidates import FAMILIES

SQUARE = [(-50.0, -50.0), (50.0, -50.0), (50.0, 50.0), (-50.0, 50.0)]
FEET = pp.Points([(-40, -40), (40, -40), (0, 40)], [1, 1, 2])
#: Options that the command passes on by default, and the seed of the tests.
OPTIONS = {"spacing": None, "family": "points", "seed": 3, "progress": False}
OFF = [(-50, -50), (90, -50), (90, 90), (-50, 90)]


@pytest.fixture(scope="module")
def pushes():
    """Eight pushes of a square on three feet, with noise."""
    table = (pp.SupportFriction(support=FEET, weight=5.0),)
    return pp.simulate_pushes(
        table, SQUARE, 8, noise=(0.5, 0.3, 0.05), seed=1, name="tripod", units=("mm", "N")
    )


@pytest.fixture(scope="module")
def files(pushes, tmp_path_factory):
    """Pushes with forces, without, and of two objects."""
    folder = tmp_path_factory.mktemp("pushes")
    other = pushes.assign_coords(object=["other"]).assign(pushed=("push", ["other"] * 8))
    pp.save_pushes(pushes, folder / "forces.nc")
    few = pushes.drop_vars("force").isel(push=slice(3))
    pp.save_pushes(few, folder / "poses.nc")
    pp.save_pushes(pp.concat_pushes([pushes, other]), folder / "two.nc")
    return folder


@pytest.fixture(scope="module", autouse=True)
def identify():
    """As the commands call it: once for the same pushes and options."""
    with called_once("identify") as call:
        yield call


@pytest.fixture(scope="module")
def printed(files, identify):
    """What the command prints as it writes scene files.

    With forces, on any points, and without, on a uniform pressure and corners.
    """
    options = {"forces": ("--seed", "3"), "poses": ("--family", "uniform_and_corners", "--json")}
    said = {name: io.StringIO() for name in options}
    for name, given in options.items():
        output = ("-o", str(files / f"{name}.yaml"))
        with contextlib.redirect_stdout(said[name]):
            assert main(["identify", str(files / f"{name}.nc"), *given, *output]) == 0
    return {name: each.getvalue() for name, each in said.items()}


@pytest.fixture(scope="module")
def supports(files, printed):
    return {name: files / f"{name}.yaml" for name in printed}


@pytest.fixture(scope="module")
def found(files, identify):
    pushes = pp.load_pushes(files / "forces.nc")
    return identify(pushes, **OPTIONS)


def content(path):
    return YAML(typ="safe", pure=True).load(path)


def test_the_command_has_the_defaults_of_the_function():
    parameters = inspect.signature(pp.identify).parameters
    assert {name: parameters[name].default for name in OPTIONS} | {"seed": 3} == OPTIONS


def test_what_is_printed_is_what_identify_finds(printed, found):
    out = printed["forces"]
    said = dict(re.findall(r"^(\w+)(?: \[.*?\])?:? +(.*)$", out, re.MULTILINE))
    x, y = found.center_of_pressure
    values = {
        "weight": found.weight, "contact_friction": found.contact_friction,
        "center_of_pressure_x": x, "center_of_pressure_y": y, "spin_torque": found.spin_torque,
    }  # fmt: skip
    for name, value in values.items():
        printed = list(map(float, said[name].split()))
        np.testing.assert_allclose(printed, [value, *found.intervals[name]], rtol=1e-3)
    assert said["points"] == str(len(found.support.positions))
    assert said["pushes"] == "8"
    assert said["in_a_facet"] == f"{(found.facet >= 0).sum()} of 8 pushes"
    assert float(said["residual_of_wrench"]) == pytest.approx(np.median(found.residuals), rel=1e-3)
    assert out.count("undetermined: ") == len(found.undetermined) > 0


def test_feet_are_joined_and_a_patch_has_none(pushes, found):
    beside = [(x + 5.0, y) for x, y in FEET.positions]
    places, loads = [*FEET.positions, *beside], [0.2, 0.2, 0.35, 0.05, 0.05, 0.15]
    feet = replace(found, support=pp.Points(places, loads), spacing=5.0, spin_torque=47.0)
    printed = command.lines({"written": "support.yaml"} | command.summary(feet, pushes))
    rows = printed.partition("fraction\n")[2].splitlines()[:3]
    np.testing.assert_allclose(
        sorted([float(each) for each in row.split()] for row in rows),
        [[-39, -40, 0.25], [1.5, 40, 0.5], [41, -40, 0.25]],
    )
    patch = replace(feet, spacing=60.0)
    assert command.summary(patch, pushes)["feet"] is None


def test_as_json(run, files, tmp_path, found):
    path = tmp_path / "support.yaml"
    given = ("identify", str(files / "two.nc"), "--object", "tripod", "--seed", "3", "--json")
    code, out, _ = run(*given, "-o", str(path))
    told = json.loads(out)
    assert code == 0
    assert told["object"] == "tripod"
    assert told["units"] == {"length": "mm", "force": "N"}
    assert told["weight"] == pytest.approx(found.weight, rel=1e-12)
    assert set(told["intervals"]) == set(found.intervals)
    for name, ends in found.intervals.items():
        assert told["intervals"][name] == pytest.approx(list(ends), rel=1e-9)
    assert told["undetermined"] == list(found.undetermined)


def test_the_scene_is_on_the_support_that_was_found(supports, found):
    scene = pp.load_scene(supports["forces"])
    friction = scene.contact.friction_coefficient
    assert friction == pytest.approx(found.contact_friction, rel=1e-8)
    assert scene.units == pp.Units(length="mm", force="N")
    twist = (0.3, -0.2, 0.02)
    own = pp.wrench(pp.SupportFriction(support=found.support, weight=found.weight), twist)
    (friction,), turn = scene.effects, scene.slider.rod_angle
    x, y, omega = scene.to_fence(twist, "twist")
    body = pp.wrench(friction, (*turned((x, y), -turn), omega))
    force = scene.to_object(turned(body[:2], turn), "vector")
    np.testing.assert_allclose(force, own[:2], rtol=1e-7)


def turned(vector, angle):
    """A vector turned by an angle in radians."""
    (x, y), c, s = vector, np.cos(angle), np.sin(angle)
    return c * x - s * y, s * x + c * y


@pytest.mark.parametrize("name", ["forces", "poses"])
def test_other_commands_take_the_scene(run, supports, tmp_path, name):
    path = str(supports[name])
    assert "outcome: UNIQUE" in run("solve", path, "--pusher-angle", "90")[1]
    push = ("--pusher-shape", "finger", "--pusher-angle", "90", "--duration", "5")
    assert run("simulate", path, *push, "-o", str(tmp_path / "log.nc"))[0] == 0
    assert run("draw", path, "-o", str(tmp_path / "scene.svg"))[0] == 0
    assert run("cone", path)[0] == 0
    assert {each.name for each in tmp_path.iterdir()} == {"log.nc", "scene.svg"}


def test_without_forces_the_weight_is_1_and_is_said_to_be_unknown(printed, supports):
    path, told = supports["poses"], json.loads(printed["poses"])
    assert told["weight"] is None
    assert told["intervals"]["weight"] == [None, None]
    assert (told["feet"], told["in_a_facet"]) == (None, None)
    written = content(path)
    assert written["effects"] == [{"type": "support_friction", "weight": 1.0}]
    assert written["title"].endswith("the weight is unknown and set to 1")
    said = command.lines(told).splitlines()
    assert f"weight: 1 in {path}, since no force was measured" in said
    assert "undetermined: weight: no force was measured" in said
    assert "feet: none; neighboring points form a patch" in said
    assert not [each for each in said if each.startswith(("in_a_facet", "weight ["))]
    (residual,) = (each for each in said if each.startswith("residual_of_pose [mm]: "))
    assert float(residual.split()[-1]) == pytest.approx(told["residual"]["pose"], rel=1e-3)


def test_an_outline_from_a_list_and_from_a_scene_file(run, files, tmp_path):
    path, corners = tmp_path / "support.yaml", tmp_path / "corners.yaml"
    wide = [*SQUARE[:2], (50.5, 50.0), (-50.5, 50.0)]
    corners.write_text(json.dumps(wide))
    given = ("identify", str(files / "forces.nc"), "--family", "uniform_and_corners", "-o")
    assert run(*given, str(path), "--outline", str(corners))[0] == 0
    assert content(path)["object"]["outline"] == [list(each) for each in wide]
    again = tmp_path / "again.yml"
    assert run(*given, str(again), "--outline", str(path))[0] == 0
    assert content(again) == content(path)


@pytest.mark.parametrize(("text", "said"), [
    ("[[0, 0], [1, 0", "not YAML: line "),
    ("", "holds no outline; allowed: a list of corners [x, y], or a scene file with object.outline; "),
    ("[[0, 0], [1, 0]]", "outline: [[0, 0], [1, 0]] given; allowed: at least three vertices; "),
    (json.dumps(OFF), "contact: "),
    (json.dumps([(x / 1000, y / 1000) for x, y in SQUARE]),
     "contact: 'a typical length of 58.39, where the outline reaches to 0.05' given; allowed: lengths of "
     "tripod in one unit; check the units: these look like meters and millimeters"),
], ids=str)  # fmt: skip
def test_an_outline_that_is_none(refused, files, tmp_path, text, said):
    file, path = tmp_path / "outline.yaml", tmp_path / "support.yaml"
    file.write_text(text)
    given = ["identify", str(files / "forces.nc"), "--outline", str(file), "-o", str(path)]
    refused(given, f"{file}: {said}")
    assert not path.exists()


def test_wrong_input_is_refused_before_any_work(refused, files, tmp_path, monkeypatch):
    def never(*_, **__):
        raise AssertionError("work has begun")

    monkeypatch.setattr("planar_pushing.pushes.identify.from_forces", never)
    path, none, text = tmp_path / "support.yaml", tmp_path / "none.nc", tmp_path / "text.nc"
    text.write_text("pushes")
    forces, out = str(files / "forces.nc"), ["-o", str(path)]
    for arguments, said in (
        ([str(none), *out], f"{none}: no such file; write one with save_pushes or "),
        ([str(text), *out], f"{text}: is not a netCDF4 file of pushes; "),
        ([str(files / "two.nc"), *out],
         "object: missing; allowed: tripod, other; name one of them with --object"),
        ([forces, "--object", "tripot", *out],
         "object: 'tripot' given; allowed: tripod; did you mean tripod?"),
        ([forces, "-o", "support.nc"],
         "output: 'support.nc' given; allowed: a name ending in .yaml or .yml; rename the file"),
        ([forces, "--family", "point", *out],
         "family: 'point' given; allowed: points, uniform_and_corners, ellipse, map; did you mean points?"),
        ([forces, "--spacing", "-1", *out], "spacing: -1.0 given; allowed: a finite number > 0; "),
        ([forces, "--spacing", "2", *out], "pushes: '8 pushes for 2601 candidates' given; "),
        ([forces, "--outline", str(none), *out], f"{none}: no such file; give the path of a YAML file"),
    ):  # fmt: skip
        refused(["identify", *arguments], said)
    assert not path.exists()


def test_a_log_is_no_dataset_of_pushes(refused, log, tmp_path):
    path = tmp_path / "support.yaml"
    refused(["identify", str(log), "-o", str(path)], f"{log}: pushes: 'a log of simulate, ")


def test_the_families_are_those_of_identify():
    assert list(command.FAMILIES) == list(FAMILIES)
