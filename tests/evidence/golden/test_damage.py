"""A damaged results folder gives a verdict with a line for each damage, and never a crash."""

import shutil

import numpy as np
import pytest

from planar_pushing.commands import main
from planar_pushing.evidence.golden import check
from planar_pushing.evidence.golden.verdict import verdict, verdict_text
from planar_pushing.study.provenance import provenance
from planar_pushing.study.store import read_dataset, write_dataset
from planar_pushing.terms.errors import InvalidFile

pytestmark = pytest.mark.slow

SMOKE = "workflow/config/smoke.yaml"


@pytest.fixture
def folder(smoke_results, tmp_path):
    """A copy of the results that a test may damage."""
    return shutil.copytree(smoke_results, tmp_path / "results/studies/smoke")


def file_checks(name, study, folder):
    results = check.Results(folder)
    groups = dict(check.expectations(study, provenance(study, SMOKE), results))[name]
    return [each for each in check.check_file(name, groups, results) if not each.passed]


def flip(path, random):
    """Turn a byte of a file."""
    content = bytearray(path.read_bytes())
    content[random.integers(len(content))] ^= 1 << random.integers(8)
    path.write_bytes(content)


def test_a_missing_file(smoke, folder):
    (folder / "data/motion_cones.nc").unlink()
    (found,) = file_checks("motion_cones", smoke, folder)
    assert "cannot be read: InvalidFile" in found.problem


@pytest.mark.parametrize("content", [b"", b"no HDF5", b"\x89HDF\r\n\x1a\n" + bytes(2000)])
def test_a_file_that_is_none(smoke, folder, content):
    (folder / "data/limit_curves.nc").write_bytes(content)
    (found,) = file_checks("limit_curves", smoke, folder)
    assert "cannot be read" in found.problem


def test_a_truncated_file(smoke, folder):
    path = folder / "data/limit_curves.nc"
    path.write_bytes(path.read_bytes()[:-2000])
    assert file_checks("limit_curves", smoke, folder)


def test_turned_bits_never_crash(smoke, folder):
    random, whole = np.random.default_rng(3), (folder / "data/motion_cones.nc").read_bytes()
    for _ in range(15):
        (folder / "data/motion_cones.nc").write_bytes(whole)
        flip(folder / "data/motion_cones.nc", random)
        file_checks("motion_cones", smoke, folder)


def test_a_group_that_is_gone_and_one_too_many(smoke, folder):
    path = folder / "data/scenes.nc"
    groups = {name: read_dataset(path, name) for name in sorted(smoke.scenes)}
    groups["more"] = groups.pop("figure_02")
    write_dataset({"/": read_dataset(path)} | groups, path)
    found = {each.file: each.problem for each in file_checks("scenes", smoke, folder)}
    assert found["scenes.more"] == "is no group of this dataset"
    assert "has no group 'figure_02'" in found["scenes.figure_02"]


def test_a_figure_of_a_damaged_dataset(smoke, folder):
    (folder / "data/motion_cones.nc").write_bytes(b"")
    (found,) = file_checks("figure_07", smoke, folder)
    assert "cannot be read" in found.problem


def test_a_stale_figure_differs(smoke, folder):
    path = folder / "figures/data/figure_07.nc"
    stale = read_dataset(path)
    stale["motion_cone_left"] = stale["motion_cone_left"] + 1e-6
    write_dataset(stale, path)
    (found,) = file_checks("figure_07", smoke, folder)
    assert (found.variable, found.failed) == ("motion_cone_left", 3)


def test_another_study_is_seen(smoke, folder):
    """Results of a study whose file has changed since."""
    path = folder / "data/scenes.nc"
    groups = {name: read_dataset(path, name) for name in sorted(smoke.scenes)}
    above = read_dataset(path).assign_attrs(study_digest="sha256:0")
    write_dataset({"/": above} | groups, path)
    (found,) = file_checks("scenes", smoke, folder)
    assert found.problem.startswith("has study_digest 'sha256:0', not 'sha256:")


def test_no_datasets_are_refused(tmp_path):
    with pytest.raises(InvalidFile, match="holds no datasets; build them"):
        check.check_results(tmp_path, SMOKE)


def test_a_study_that_is_not_there_is_named_before_its_results(tmp_path):
    with pytest.raises(InvalidFile, match=r"none\.yaml: no such file"):
        check.check_results(tmp_path, "none.yaml")


def test_the_command_passes_fails_and_refuses(smoke_results, folder, tmp_path, capsys):
    assert main(["check", str(smoke_results.parents[1]), "--study", SMOKE]) == 0
    assert capsys.readouterr().out.startswith("passed: every value agrees\n")
    (folder / "data/limit_curves.nc").write_bytes(b"")
    assert main(["check", str(tmp_path / "results"), "--study", SMOKE]) == 1
    said = capsys.readouterr().out
    assert said.startswith("FAILED: ")
    assert "FAIL limit_curves cannot be read" in said
    assert main(["check", str(tmp_path / "none"), "--study", SMOKE]) == 2
    assert main(["check", str(tmp_path / "results"), "--study", "none.yaml"]) == 2


def test_outside_the_project_the_command_says_where_to_go(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(["check"]) == 2
    said = "workflow/config/paper.yaml: no such file; go to the project's folder, or give --study"
    assert capsys.readouterr().err == f"planar-pushing check: {said}\n"


def test_the_verdict_counts_by_rule(smoke_results):
    found = verdict(check.check_results(smoke_results, SMOKE))
    assert found["passed"], verdict_text(found)
    assert found["rules"]["enclosure"] == {"values": 0, "variables": 0}
    assert found["rules"]["residual"]["values"] > 30_000
