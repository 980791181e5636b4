"""The results of the paper's study against the golden data, as in the pipeline, and its pictures."""

from pathlib import Path

import pytest

from evidence.golden.studies import write_results
from planar_pushing.evidence.golden import check
from planar_pushing.evidence.golden.rules import RULES
from planar_pushing.evidence.golden.tolerances import load_tolerances
from planar_pushing.evidence.golden.verdict import verdict, verdict_text
from planar_pushing.figures.images import TOLERANCE, difference
from planar_pushing.figures.render import picture, save
from planar_pushing.figures.style import paper_style
from planar_pushing.study.catalog import DATASETS, SLIDERS
from planar_pushing.study.figures import FIGURES
from planar_pushing.study.store import read_dataset, write_dataset
from planar_pushing.study.study_file import load_study
from planar_pushing.terms.errors import InvalidFile

PAPER = "workflow/config/paper.yaml"
STUDY = load_study(PAPER)
GOLDEN = Path("tests/golden")


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    """Datasets of the paper's study, and the numbers of its figures."""
    return write_results(PAPER, tmp_path_factory.mktemp("results"))


def test_every_dataset_scene_and_figure_has_golden_data():
    scenes = {f"scenes.{name}" for name in STUDY.scenes}
    grids = set(DATASETS) - {"scenes"}
    assert set(check.golden_names(GOLDEN)) == grids | scenes | set(FIGURES)


def test_every_variable_of_a_dataset_has_golden_data(results):
    for name in set(DATASETS) - {"scenes"}:
        stored = read_dataset(GOLDEN / f"{name}.nc")
        assert set(read_dataset(results / f"data/{name}.nc").data_vars) <= set(stored.data_vars)


def test_every_tolerance_is_of_a_golden_variable():
    variables = {
        name for each in check.golden_names(GOLDEN) for name in read_dataset(GOLDEN / f"{each}.nc")
    }
    assert set(load_tolerances(GOLDEN)) <= variables


def test_results_agree_with_the_golden_data(results):
    checks = check.check_enclosures(check.Results(results), STUDY)
    assert all(each.passed for each in checks), verdict_text(verdict(checks))
    assert sum(each.count for each in checks) > 500_000


def test_every_variable_of_a_dataset_has_one_rule(results):
    for name in set(RULES) - set(SLIDERS):
        file = {"scenes": "scenes", "simulations": "simulations/figure_15"}.get(name, name)
        dataset = check.Results(results).dataset(file, "figure_11" if name == "scenes" else "")
        assert set(RULES[name]) == set(dataset.data_vars)


@pytest.mark.parametrize("name", FIGURES)
def test_picture(results, tmp_path, name):
    with paper_style():
        data = read_dataset(results / f"figures/data/{name}.nc")
        save(picture(name, data), tmp_path / "figure.png")
    assert difference(tmp_path / "figure.png", GOLDEN / "images" / f"{name}.png") <= TOLERANCE


def test_a_folder_without_golden_data_is_refused(tmp_path):
    with pytest.raises(InvalidFile, match="holds no golden data; name the folder that does"):
        check.golden_names(tmp_path)


def test_a_missing_result_fails(tmp_path):
    write_dataset(read_dataset(GOLDEN / "motion_cones.nc"), tmp_path / "golden/motion_cones.nc")
    study = STUDY.model_copy(update={"golden": str(tmp_path / "golden")})
    (found,) = check.check_enclosures(check.Results(tmp_path), study)
    assert not found.passed
    assert "cannot be compared" in found.problem
