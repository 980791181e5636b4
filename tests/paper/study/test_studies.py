"""Studies side by side: which one is chosen, what it is called, and the folder that it fills."""

import shutil
from pathlib import Path

import pytest

import planar_pushing as pp
from planar_pushing.terms.netcdf import write_dataset
from pulling_by_pushing.study.studies import (
    chosen_results,
    chosen_studies,
    chosen_study,
    file_name,
    study_folder,
    study_name,
)
from pulling_by_pushing.study.study_file import load_study

PAPER = "workflow/config/paper.yaml"


def test_both_studies_are_built_unless_one_is_chosen():
    assert chosen_studies({}) == (PAPER, "workflow/config/sliders.yaml")
    assert chosen_studies({"study": "a/b.yaml"}) == ("a/b.yaml",)
    with pytest.raises(pp.InvalidValue, match="did you mean study"):
        chosen_studies({"studdy": "x"})


def test_the_papers_study_is_the_default():
    assert chosen_study({}) == PAPER
    assert chosen_study({"study": "a/b.yaml"}) == "a/b.yaml"


@pytest.mark.parametrize(
    ("config", "said"),
    [
        (
            {"studdy": "x"},
            "config: 'studdy' given; allowed: the keys study, results and data; did you",
        ),
        (
            {"golden": 3},
            "config: 'golden' given; allowed: the keys study, results and data; leave it out",
        ),
        ({"study": 5}, "study: 5 given; allowed: the path of a study file, without braces"),
        ({"study": ""}, "study: '' given; allowed: the path of a study file"),
        ({"study": None}, "study: None given; allowed: the path of a study file"),
        ({"study": "{a}.yaml"}, "study: '{a}.yaml' given; allowed: the path of a study file"),
    ],
)
def test_a_wrong_configuration_is_refused(config, said):
    with pytest.raises(pp.InvalidValue) as caught:
        chosen_study(config)
    assert str(caught.value).startswith(said)


def test_the_folder_of_all_results_is_chosen_too():
    assert chosen_results({}) == "results"
    assert chosen_results({"study": "a.yaml", "results": "out"}) == "out"
    with pytest.raises(pp.InvalidValue, match="results: 5 given; allowed: the path of a folder"):
        chosen_results({"results": 5})


def test_the_papers_study_is_built_in_the_projects_folder_alone(tmp_path):
    with pytest.raises(
        pp.InvalidFile, match=r"names the paper's study, workflow/config/paper\.yaml"
    ):
        study_name(tmp_path / "paper.yaml")
    assert file_name(tmp_path / "paper.yaml") == "paper"


def test_a_study_is_named_by_its_file():
    assert study_name("some/where/smoke.yaml") == "smoke"
    assert study_name(PAPER) == "paper"


@pytest.mark.parametrize("name", ["a b", "a.b", "paper", "..", "ä"])
def test_a_name_that_is_no_folder_of_its_own_is_refused(tmp_path, name):
    with pytest.raises(pp.InvalidFile, match="rename the file"):
        study_name(tmp_path / f"{name}.yaml")


def test_each_study_fills_a_folder_of_its_own():
    assert study_folder("paper") == study_folder(None) == Path("results")
    assert study_folder("smoke", "out") == Path("out/studies/smoke")


def test_a_dataset_of_another_study_is_opened_by_the_studys_name(results, tmp_path):
    ours = pp.open_dataset("motion_cones", results)
    write_dataset(ours, tmp_path / "studies/mine/data/motion_cones.nc")
    assert pp.open_dataset("motion_cones", tmp_path, study="mine").identical(ours)
    with pytest.raises(pp.InvalidFile, match="no such dataset; built for the study mine: give "):
        pp.open_dataset("motion_cones", tmp_path)
    with pytest.raises(pp.InvalidFile, match="holds no folder data; name the folder"):
        pp.open_dataset("contact_modes", tmp_path)


@pytest.mark.parametrize(("study", "remedy"), [
    ("../mine", r"did you mean mine\?"), ("a/b", "name a study that was built"),
    ("", "name a study that was built"), (5, "name a study that was built"),
])  # fmt: skip
def test_a_study_outside_of_the_results_is_refused(tmp_path, study, remedy):
    (tmp_path / "studies/mine").mkdir(parents=True)
    with pytest.raises(pp.InvalidValue, match=f"allowed: paper, mine; {remedy}$"):
        pp.open_dataset("motion_cones", tmp_path, study=study)


def test_paths_in_a_study_are_relative_to_its_file(tmp_path, monkeypatch):
    shutil.copytree("workflow/scenes", tmp_path / "scenes")
    shutil.copytree("workflow/config", tmp_path / "config")
    monkeypatch.chdir(tmp_path)
    found = load_study("config/smoke.yaml")
    assert found.scenes["figure_02"].file == "scenes/figure_02.yaml"
    assert found.simulations["slipping"] == "scenes/slipping.yaml"
    monkeypatch.chdir(tmp_path / "scenes")
    assert load_study("../config/smoke.yaml").scenes["figure_02"].file == "../scenes/figure_02.yaml"


def test_a_study_that_was_not_built_is_answered_by_those_that_were(tmp_path):
    (tmp_path / "studies" / "mine").mkdir(parents=True)
    with pytest.raises(pp.InvalidValue, match="'yours' given; allowed: paper, mine; name a study"):
        pp.open_dataset("limit_curves", tmp_path, study="yours")
