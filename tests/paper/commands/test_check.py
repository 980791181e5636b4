"""The command `check` away from the project's folder, and where there is nothing to check."""

import json
import shutil
from pathlib import Path

import pytest
from commands.test_run import TINY

from pulling_by_pushing.study.running import build
from pulling_by_pushing.study.slices import study_slice
from pulling_by_pushing.study.study_file import load_study


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    """A folder with a study of one's own, and its results."""
    folder = tmp_path_factory.mktemp("built")
    (folder / "tiny.yaml").write_text(TINY, encoding="utf-8")
    values = study_slice(load_study(folder / "tiny.yaml"), "motion_cones")
    path = folder / "results/studies/tiny/data/motion_cones.nc"
    path.parent.mkdir(parents=True)
    build.dataset(path, name="motion_cones", study=values, marks={})
    return folder


@pytest.fixture
def away(built, tmp_path, monkeypatch):
    """A copy of it, in which no file of the project is found."""
    shutil.copytree(built, tmp_path, dirs_exist_ok=True)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("pulling_by_pushing.study.studies.__file__", str(tmp_path / "a/b/c/d.py"))
    return tmp_path


def test_points_of_results_of_ones_own_are_certified(run, away):
    code, out, _ = run("check", "--study", "tiny.yaml", "--points", "2")
    assert code == 0
    assert out.startswith("passed: every value agrees\n")
    assert not [line for line in out.splitlines() if line.startswith("ok ")]
    assert out.endswith(" variables agree; --json lists them\n")
    _, out, _ = run("check", "--study", "tiny.yaml", "--points", "2", "--json")
    assert len(json.loads(out)["checks"]) > 3


@pytest.mark.parametrize(("arguments", "said"), [
    ([], "results: holds results of tiny only; give the file of a study with --study"),
    (["nowhere"], "nowhere: no such folder; name the folder of the results, or build them with "),
    (["nowhere", "--study", "tiny.yaml"], "nowhere: no such folder; name the folder of the results"),
    (["empty"], "workflow/config/paper.yaml: no such file; go to the project's folder, or give the "),
    (["empty", "--study", "tiny.yaml"], "empty/studies/tiny: no such folder; name the folder of "),
    (["--study", "absent.yaml"], "absent.yaml: no such file"),
    (["--study", "tiny"], "study: 'tiny' given; allowed: the path of a study file, or of the project's "
     "studies the name paper or sliders; give the file from which results/studies/tiny was built"),
    (["--study", "slider"], "study: 'slider' given; allowed: the path of a study file, or of the project's "
     "studies the name paper or sliders; did you mean sliders?"),
    (["--study", "sliders"], "study: 'sliders' given; allowed: the path of a study file, or of the "
     "project's studies the name paper or sliders; go to the project's folder, which has "
     "workflow/config/sliders.yaml, or give the path of its file"),
    (["--study", "mine"], "study: 'mine' given; allowed: the path of a study file, or of the project's "
     "studies the name paper or sliders; give the path of its file"),
    (["--study", "tiny.yaml"], "tiny.yaml: golden: missing; allowed: a folder of golden data; "),
], ids=str)  # fmt: skip
def test_what_is_missing_is_named(refused, away, arguments, said):
    (away / "empty").mkdir()
    refused(["check", *arguments], said)


def test_a_copy_of_the_papers_study_is_checked_wherever_it_is(refused, away):
    """It is read as it stands: nothing says to rename it."""
    shutil.move("tiny.yaml", "paper.yaml")
    refused(
        ["check", "results/studies/tiny", "--study", str(away / "paper.yaml")],
        f"{away}/paper.yaml: golden: missing",
    )


def test_a_file_without_an_ending_goes_before_a_name(refused, away):
    shutil.copy("tiny.yaml", "sliders")
    refused(["check", "results", "--study", "sliders"], "results/studies/sliders: no such folder; ")


@pytest.mark.parametrize(("study", "folder"), [
    ("paper", "mine"), ("sliders", "mine/studies/sliders"),
])  # fmt: skip
def test_a_study_of_the_project_is_found_by_its_name(refused, tmp_path, monkeypatch, study, folder):
    monkeypatch.chdir(tmp_path)
    Path(folder).mkdir(parents=True)
    refused(
        ["check", "mine", "--study", study], f"{folder}: contains no datasets; name the folder "
    )


def test_the_papers_study_is_found_beside_the_package(refused, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("mine").mkdir()
    refused(
        ["check", "mine"], "mine: contains no datasets; name the folder of the results, or build "
    )
