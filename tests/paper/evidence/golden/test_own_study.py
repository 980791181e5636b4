"""Golden data and certified points of a study of one's own, from its file to the verdict."""

import re
import shutil
from pathlib import Path

import numpy as np
import pytest

from planar_pushing.commands import main
from planar_pushing.terms.netcdf import write_dataset
from pulling_by_pushing.evidence.golden import update
from pulling_by_pushing.study.catalog import DATASETS
from pulling_by_pushing.study.running import build
from pulling_by_pushing.study.slices import computes, study_slice
from pulling_by_pushing.study.store import read_dataset
from pulling_by_pushing.study.study_file import load_study

STUDY = """title: Mine
slider: {radius: 2, rod_length: 2, rod_angle: 60}
support_friction: {weight: 3}
inertia: {mass: 0.5, gyration_radius: 2}
supports:
  quadruped:
    shape: points
    positions: [[-0.8, -0.6], [0.8, -0.6], [0.8, 0.6], [-0.8, 0.6]]
    weights: [1, 1, 1, 1]
  disc: {shape: disc, radius: 1}
grid:
  effects: [support_friction, support_friction+inertia]
  rod_length: [2]
  rod_angle: [60, 90]
  friction_coefficient: [FRICTION, inf]
  force_angle: [0, 60, 100]
  inertia_share: [0, 1]
  pusher_angle: [-10, 80]
  pusher_magnitude: [2]
  contact_friction_coefficient: [0, 1.4]
  center_x: [0, 0.5]
  center_y: [0.25]
fine_grids:
  support_curves: {force_angle: [10, 70]}
  support_rods: {rod_length: [1, 2], rod_angle: [70, 90]}
"""
#: A part of it, of which two datasets are computed.
FEW = """title: Mine
slider: {radius: 2, rod_length: 2, rod_angle: 60}
support_friction: {weight: 3}
grid:
  effects: [support_friction]
  rod_length: [2]
  rod_angle: [60, 90]
  force_angle: [0, 60, 100]
  pusher_angle: [-10, 80]
  pusher_magnitude: [2]
  contact_friction_coefficient: [0, 1.4]
"""


def written(folder, friction):
    path = folder / "mine.yaml"
    path.write_text(STUDY.replace("FRICTION", str(friction)), encoding="utf-8")
    return path


def built(path, results, names=DATASETS):
    """The results of a study; its own folder among those of all."""
    study, folder = load_study(path), results / "studies/mine"
    for name in (each for each in names if computes(study, each)):
        marks = {"study": "mine", "study_digest": "sha256:0"}
        file = folder / f"data/{name}.nc"
        file.parent.mkdir(parents=True, exist_ok=True)
        build.dataset(file, name=name, study=study_slice(study, name), marks=marks)
    return folder


@pytest.fixture(scope="module")
def mine(tmp_path_factory):
    """A study, its results, and its golden data."""
    folder = tmp_path_factory.mktemp("mine")
    path = written(folder, 0.75)
    built(path, folder / "results")
    write_golden(path, "support_curves")
    return folder


def write_golden(path, *again):
    """Write golden data of a study in their folder, compute some of them again, and name the folder."""
    folder = path.parent
    arguments = [
        "--study", str(path), "--results", str(folder / "results"), "--golden", str(folder / "golden")
    ]  # fmt: skip
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(update.os, "cpu_count", lambda: 1)  # another takes longer to start
        assert update.main([*arguments, "--write"]) == 1
        assert update.main([*arguments, "--only", *again]) == 0
    with path.open("a", encoding="utf-8") as file:
        file.write("golden: golden\n")


@pytest.fixture
def copy(mine, tmp_path):
    shutil.copytree(mine, tmp_path, dirs_exist_ok=True)
    return tmp_path


@pytest.fixture(scope="module")
def two(tmp_path_factory):
    """As `mine`, with two datasets, which are compared in less time."""
    folder = tmp_path_factory.mktemp("two")
    path = folder / "mine.yaml"
    path.write_text(FEW, encoding="utf-8")
    built(path, folder / "results")
    names = ("limit_curves", "contact_modes")
    write_golden(path, *names)
    assert {file.stem for file in (folder / "golden").glob("*.nc")} == set(names)
    return folder


@pytest.fixture
def few(two, tmp_path):
    shutil.copytree(two, tmp_path, dirs_exist_ok=True)
    return tmp_path


def check(folder, capsys, *more):
    code = main(["check", str(folder / "results"), "--study", str(folder / "mine.yaml"), *more])
    said = capsys.readouterr()
    return code, said.out, said.err


def test_a_study_agrees_with_its_golden_data(mine, capsys):
    code, out, _ = check(mine, capsys)
    assert code == 0
    assert out.startswith("passed: every value agrees\n")


def test_a_change_is_found_and_named(few, capsys):
    path = few / "results/studies/mine/data/contact_modes.nc"
    data = read_dataset(path).load()
    at = np.unravel_index(np.nanargmax(data.force.values), data.force.shape)
    data.force.values[at] *= 1 + 1e-9
    write_dataset(data, path)
    code, out, _ = check(few, capsys)
    assert code == 1
    assert "FAIL contact_modes: force (enclosed): 1 of" in out


def test_a_result_that_is_missing_is_a_failed_check(few, capsys):
    (few / "results/studies/mine/data/limit_curves.nc").unlink()
    code, out, _ = check(few, capsys)
    assert code == 1
    assert "FAIL limit_curves cannot be read: " in out


@pytest.mark.parametrize(
    ("spoil", "said"),
    [
        (lambda path: path.unlink(), "limit_curves.nc: no such golden file; make it with "),
        (
            lambda path: path.write_bytes(b"no data" * 99),
            "limit_curves.nc: is a damaged golden file; take it from the repository",
        ),
        (
            lambda path: path.write_bytes(path.read_bytes()[: path.stat().st_size // 2]),
            "limit_curves.nc: is a damaged golden file; take it from the repository",
        ),
        (
            lambda path: (path.parent / "SHA256SUMS").unlink(),
            "golden/SHA256SUMS: no such list of digests; take it from the repository",
        ),
    ],
)
def test_golden_files_that_are_missing_or_damaged_are_one_line(few, capsys, spoil, said):
    spoil(few / "golden/limit_curves.nc")
    code, out, err = check(few, capsys)
    assert (code, out) == (2, "")
    assert said in err
    assert err.count("\n") == 1


@pytest.mark.parametrize(("exponent", "wide"), [(-45, False), (100, True)])
def test_a_golden_file_that_was_changed_is_a_failed_check(few, capsys, exponent, wide):
    """Digests find what is not wide, too; wide radii are found without them."""
    path = few / "golden/limit_curves.nc"
    data = read_dataset(path).load()
    data["force_radius"] = data["force_radius"] * 0 + np.int8(exponent)
    write_dataset(data, path)
    code, out, _ = check(few, capsys)
    assert code == 1
    digest = (
        f"FAIL limit_curves {path} is not the golden file of {path.parent / 'SHA256SUMS'}; take"
    )
    assert digest in out
    assert ("golden radii of force above 1e-09 of their numbers; take it" in out) == wide
    arguments = ["--study", str(few / "mine.yaml"), "--results", str(few / "results")]
    assert update.main([*arguments, "--only", "limit_curves"]) == 1


def test_golden_data_of_nothing_are_a_failed_check(few, capsys):
    shutil.copy(few / "golden/limit_curves.nc", few / "golden/more.nc")
    code, out, _ = check(few, capsys)
    assert code == 1
    assert "FAIL more is a golden file, but not a result of the study" in out


def test_a_study_without_golden_data_is_one_line(copy, capsys):
    path = copy / "mine.yaml"
    path.write_text(path.read_text(encoding="utf-8").replace("golden: golden\n", ""))
    code, out, err = check(copy, capsys)
    assert (code, out) == (2, "")
    assert err.startswith(f"planar-pushing check: {path}: golden: missing; ")
    assert "--points N" in err


def test_points_of_any_study_are_certified(copy, capsys):
    shutil.rmtree(copy / "golden")
    path = copy / "mine.yaml"
    path.write_text(path.read_text(encoding="utf-8").replace("golden: golden\n", ""))
    code, out, _ = check(copy, capsys, "--points", "5")
    assert code == 0
    assert "certified points, chosen at random: 5 of limit_curves" in out


def test_points_find_a_dataset_that_is_wrong(copy, capsys):
    path = copy / "results/studies/mine/data/motion_cones.nc"
    data = read_dataset(path).load()
    data["motion_cone_left"] = data["motion_cone_left"] * (1 + 1e-9)
    write_dataset(data, path)
    code, out, _ = check(copy, capsys, "--points", "5")
    assert code == 1
    assert "FAIL motion_cones: motion_cone_left" in out


def test_points_find_solutions_that_are_missing(copy, capsys):
    path = copy / "results/studies/mine/data/support_modes.nc"
    data = read_dataset(path).load().isel(solution=slice(0, 1))
    write_dataset(data, path)
    code, out, _ = check(copy, capsys, "--points", "12")
    assert code == 1
    assert "FAIL support_modes: mode" in out


def test_a_dataset_of_which_no_point_is_certified_has_not_passed(tmp_path, capsys):
    path = written(tmp_path, 0.5)
    text = path.read_text(encoding="utf-8").replace("[0.5, inf]", "[0.5]")
    text = text.replace("rod_angle: [60, 90]", "rod_angle: [90]")
    text = text.replace("  disc: {shape: disc, radius: 1}\n", "").partition("fine_grids:")[0]
    for axis in ("force_angle", "pusher_angle", "center_x"):  # of other datasets
        text = re.sub(rf"  {axis}: .*\n", "", text)
    path.write_text(text, encoding="utf-8")
    built(path, tmp_path / "results")
    code, out, _ = check(tmp_path, capsys, "--points", "3")
    assert code == 1
    assert "FAIL support_cones has no point that could be certified" in out


@pytest.mark.parametrize("number", ["0", "-3"])
def test_a_number_of_points_is_positive(mine, capsys, number):
    code, _, err = check(mine, capsys, "--points", number)
    assert code == 2
    assert err.startswith(f"planar-pushing check: points: {number} given; ")


def test_a_point_on_a_kink_is_named(tmp_path, capsys):
    """A foot of the quadruped takes its share to all digits: rounding decides what pivots."""
    path = written(tmp_path, 0.5)
    built(path, tmp_path / "results", ["support_cones"])
    arguments = ["--study", str(path), "--results", str(tmp_path / "results")]
    golden = tmp_path / "golden"
    with pytest.raises(Exception, match="choose another value of the grid") as raised:
        update.main([*arguments, "--golden", str(golden), "--only", "support_cones", "--write"])
    assert "friction_coefficient=0.5" in str(raised.value)
    assert str(raised.value).count("\n") == 0
    assert not Path(golden).exists()
