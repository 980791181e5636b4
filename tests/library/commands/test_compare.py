"""The command `compare`: its tables, its dataset, and wrong input."""

import inspect
import json

import numpy as np
import pytest
import xarray as xr
from commands.calls import called_once

import planar_pushing as pp
from planar_pushing.commands import compare as command
from planar_pushing.pushes.models import MODELS
from pulling_by_pushing.study.store import read_dataset

SQUARE = [(-50.0, -50.0), (50.0, -50.0), (50.0, 50.0), (-50.0, 50.0)]
FEET = pp.Points([(-40, -40), (40, -40), (0, 40)], [1, 1, 2])
#: Options that the command passes on by default, and the seed of the tests.
OPTIONS = {"splits": 1, "workers": 1, "seed": 2, "progress": False}
FAST = [name for name in MODELS if name != "identified"]


@pytest.fixture(scope="module")
def pushes():
    """Ten pushes of a square on three feet, with noise, and as many without forces of a plate."""
    options = {"noise": (0.5, 0.3, 0.05), "seed": 1}
    table = (pp.SupportFriction(support=FEET, weight=5.0),)
    plate = (pp.SupportFriction(support=pp.Polygon(SQUARE)),)
    feet = pp.simulate_pushes(table, SQUARE, 10, name="tripod", **options)
    even = pp.simulate_pushes(plate, SQUARE, 10, name="plate", **options)
    return feet, even.drop_vars("force")


@pytest.fixture(scope="module")
def files(pushes, tmp_path_factory):
    folder = tmp_path_factory.mktemp("pushes")
    for name, each in zip(("tripod", "plate"), pushes, strict=True):
        pp.save_pushes(each, folder / f"{name}.nc")
    two = [each.isel(push=slice(8)) for each in pushes]
    pp.save_pushes(pp.concat_pushes(two), folder / "two.nc")
    pp.save_pushes(pushes[0].isel(push=slice(5)), folder / "few.nc")
    table = (pp.SupportFriction(support=FEET, weight=5.0),)
    many = pp.simulate_pushes(table, SQUARE, 18, noise=(0.5, 0.3, 0.05), seed=3)
    pp.save_pushes(many, folder / "many.nc")
    return folder


@pytest.fixture(scope="module", autouse=True)
def compare():
    """As the commands call it: once for the same pushes, models and options."""
    with called_once("compare") as call:
        yield call


@pytest.fixture(scope="module")
def known(files, compare):
    """With the support that is identified."""
    return compare(pp.load_pushes(files / "tripod.nc"), list(MODELS), **OPTIONS)


@pytest.fixture(scope="module")
def found(files, compare):
    return compare(pp.load_pushes(files / "tripod.nc"), FAST, **OPTIONS)


def tables(out):
    """The rows of each table that is printed, by its heading."""
    rows = {}
    for line in out.splitlines():
        words = line.split()
        if words[-1] == "to":
            table = rows.setdefault(" ".join(words[:2]), {})
        elif rows:
            table[words[0]] = np.array(words[1:], float)
    return rows


def test_tables_hold_what_compare_returns(run, files, found):
    code, out, err = run("compare", str(files / "tripod.nc"), "--seed", "2")
    assert (code, err) == (0, "")
    lines = ["objects: tripod", "pushes: 10", "seed: 2", "splits: 1", "reference: fitted_ellipsoid"]
    assert out.splitlines()[:5] == lines
    printed = tables(out)
    assert list(printed) == ["wrench [degree]", "motion [degree]", "pose [mm]"]
    for heading, rows in printed.items():
        one = found.sel(quantity=heading.split()[0])
        assert list(rows) == FAST
        for model, row in rows.items():
            each = one.sel(model=model)
            np.testing.assert_allclose(row[:2], [each["median"], each["percentile_90"]], rtol=6e-3)
            np.testing.assert_allclose(row[2], each["ratio"], atol=6e-4)
            np.testing.assert_allclose(row[3:], each["ratio_interval"], atol=6e-4)


def test_json_and_dataset(run, files, tmp_path, found):
    path = tmp_path / "comparison.nc"
    given = ("compare", str(files / "tripod.nc"), "--seed", "2", "--json", "-o", str(path))
    code, out, err = run(*given)
    told = json.loads(out)
    assert (code, err) == (0, "")
    assert told["written"] == str(path)
    assert told["units"] == {"wrench": "degree", "motion": "degree", "pose": "mm"}
    one = told["comparison"]["pose"]["known_feet"]
    each = found.sel(quantity="pose", model="known_feet")
    assert one["median"] == pytest.approx(float(each["median"]), rel=1e-9)
    assert one["difference_interval"] == pytest.approx(each["difference_interval"].values, rel=1e-9)
    xr.testing.assert_allclose(read_dataset(path), found)


def test_the_command_has_the_defaults_of_the_function():
    parameters = inspect.signature(pp.compare).parameters
    assert {name: parameters[name].default for name in OPTIONS} | {"seed": 2} == OPTIONS


def test_a_support_is_identified_where_that_is_asked_for(run, files, known):
    file = str(files / "tripod.nc")
    code, out, _ = run("compare", file, "--identify", "--seed", "2", "--json")
    assert code == 0
    told = json.loads(out)["comparison"]
    assert list(told["pose"]) == list(MODELS)
    expected = known.sel(quantity="pose", model="identified")
    got = told["pose"]["identified"]["median"]
    assert got == pytest.approx(float(expected["median"]), rel=1e-6)


def test_several_splits_are_means_with_wider_intervals(run, files, tmp_path, monkeypatch):
    """The numbers that are printed are those of `compare` for these splits, here of few models."""
    scores = []

    def recorded(pushes, models, **options):
        assert pushes.identical(pp.load_pushes(files / "many.nc"))
        assert (models, options["splits"]) == (FAST, 2)
        scores.append(pp.compare(pushes, ["known_feet"], **options))
        return scores[-1]

    monkeypatch.setattr("planar_pushing.pushes.compare.compare", recorded)
    path = tmp_path / "comparison.nc"
    given = ("compare", str(files / "many.nc"), "--splits", "2", "--json", "-o", str(path))
    code, out, err = run(*given)
    assert (code, err) == (0, "")
    told, kept = json.loads(out), read_dataset(path)
    assert told["splits"] == kept.attrs["splits"] == 2
    (expected,) = scores
    xr.testing.assert_allclose(kept, expected)
    one = expected.sel(quantity="motion", model="known_feet")
    assert told["comparison"]["motion"]["known_feet"]["ratio_90"] == pytest.approx(one["ratio_90"])


def test_quantities_and_models_that_are_not_known_are_left_out(found):
    known = found.copy(deep=True)
    for name in ("median", "ratio"):
        known[name].loc[{"quantity": ["wrench", "motion"]}] = np.nan
        known[name].loc[{"model": "known_feet"}] = np.nan
    told = command.summary(known)
    assert told["units"] == {"pose": "mm"}
    assert {name: list(rows) for name, rows in told["comparison"].items()} == {"pose": FAST[1:]}
    assert list(tables(command.lines(told))) == ["pose [mm]"]


@pytest.mark.slow
def test_several_objects_and_one_of_them_without_forces(run, files):
    code, out, _ = run("compare", str(files / "two.nc"), "--object", "plate")
    assert code == 0
    assert out.splitlines()[:2] == ["objects: plate", "pushes: 8"]
    (rows,) = tables(out).values()
    assert list(rows) == ["uniform", "uniform_ellipsoid", "fitted_ellipsoid"]
    assert "nan" not in out
    out = run("compare", str(files / "two.nc"))[1]
    assert out.splitlines()[:2] == ["objects: tripod plate", "pushes: 16"]
    assert list(tables(out)) == ["wrench [degree]", "motion [degree]", "pose [mm]"]


def test_wrong_input_is_refused_before_any_work(refused, files, tmp_path, monkeypatch):
    def never(*_, **__):
        raise AssertionError("work has begun")

    monkeypatch.setattr("planar_pushing.pushes.halves.errors_of", never)
    path = tmp_path / "comparison.nc"
    tripod, two = str(files / "tripod.nc"), str(files / "two.nc")
    for arguments, said in (
        ([two, "--object", "plato"], "object: 'plato' given; allowed: tripod, plate; did you mean plate?"),
        ([tripod, "--seed", "-1"], "seed: -1 given; allowed: a whole number >= 0; "),
        ([tripod, "--splits", "0"], "splits: 0 given; allowed: a whole number >= 1, at most 1e+07; "),
        ([tripod, "--workers", "0"], "workers: 0 given; allowed: a whole number >= 1; "),
        ([tripod, "--splits", "2"],
         "pushes: '10 pushes of tripod to which a model can be fitted' given; allowed: at least 16; "),
        ([tripod, "-o", "table.csv"],
         "output: 'table.csv' given; allowed: a name ending in .nc or .h5; rename the file"),
        ([str(files / "few.nc"), "-o", str(path)],
         "pushes: '5 pushes of tripod to which a model can be fitted' given; allowed: at least 8; "),
    ):  # fmt: skip
        refused(["compare", *arguments], said)
    assert not path.exists()
