"""The results of the paper's study against the golden data, as in the pipeline, and its pictures."""

from pathlib import Path

import pytest

from planar_pushing.evidence.golden.check import check_results, golden_names
from planar_pushing.evidence.golden.verdict import verdict, verdict_text
from planar_pushing.figures.images import TOLERANCE, difference
from planar_pushing.figures.render import picture, save, select
from planar_pushing.figures.style import paper_style
from planar_pushing.study.builders import build_dataset
from planar_pushing.study.catalog import DATASETS
from planar_pushing.study.figures import FIGURES
from planar_pushing.study.files.models import FigureEntry
from planar_pushing.study.files.scenes import load_scene_file
from planar_pushing.study.simulations import simulate_file
from planar_pushing.study.slices import study_slice
from planar_pushing.study.store import read_dataset, write_dataset
from planar_pushing.study.study_file import load_study
from planar_pushing.terms.errors import InvalidFile

STUDY = load_study("workflow/config/paper.yaml")
GOLDEN = Path("tests/golden")


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    """Datasets of the paper's study, and the numbers of its figures."""
    folder = tmp_path_factory.mktemp("results")
    for name in DATASETS:
        write_dataset(build_dataset(name, study_slice(STUDY, name)), folder / f"data/{name}.nc")
    for name, scene in STUDY.simulations.items():
        log = simulate_file(load_scene_file(scene))
        write_dataset(log, folder / f"data/simulations/{name}.nc")
    for name in FIGURES:
        settings = STUDY.figures.get(name, FigureEntry())
        write_dataset(select(name, folder, settings), folder / f"figures/data/{name}.nc")
    return folder


def test_every_dataset_scene_and_figure_has_golden_data():
    scenes = {f"scenes.{name}" for name in STUDY.scenes}
    grids = set(DATASETS) - {"scenes"}
    assert set(golden_names(GOLDEN)) == grids | scenes | set(FIGURES)


def test_every_variable_of_a_dataset_has_golden_data(results):
    for name in set(DATASETS) - {"scenes"}:
        stored = read_dataset(GOLDEN / f"{name}.nc")
        assert set(read_dataset(results / f"data/{name}.nc").data_vars) <= set(stored.data_vars)


def test_every_tolerance_is_of_a_golden_variable():
    variables = {
        name for each in golden_names(GOLDEN) for name in read_dataset(GOLDEN / f"{each}.nc")
    }
    assert set(STUDY.tolerances) <= variables


def test_results_agree_with_the_golden_data(results):
    checks = check_results(results, GOLDEN, STUDY.tolerances)
    assert all(check.passed for check in checks), verdict_text(verdict(checks))
    assert sum(check.count for check in checks) > 500_000


@pytest.mark.parametrize("name", FIGURES)
def test_picture(results, tmp_path, name):
    with paper_style():
        data = read_dataset(results / f"figures/data/{name}.nc")
        save(picture(name, data), tmp_path / "figure.png")
    assert difference(tmp_path / "figure.png", GOLDEN / "images" / f"{name}.png") <= TOLERANCE


def test_golden_data_are_small():
    assert sum(path.stat().st_size for path in GOLDEN.rglob("*.*")) < 5e6


def test_a_folder_without_golden_data_is_refused(tmp_path):
    with pytest.raises(InvalidFile, match="holds no golden data; name the folder that does"):
        golden_names(tmp_path)


def test_a_missing_result_fails(tmp_path):
    write_dataset(read_dataset(GOLDEN / "motion_cones.nc"), tmp_path / "golden/motion_cones.nc")
    (check,) = check_results(tmp_path / "results", tmp_path / "golden", {})
    assert not check.passed
    assert "cannot be compared" in check.problem
