"""Results with the datasets of the smoke studies."""

import shutil
from pathlib import Path

import pytest

import planar_pushing as pp
from planar_pushing.study.build import build_dataset
from planar_pushing.study.catalog import AXES, DATASETS, SLIDERS
from planar_pushing.study.describe import of_study
from planar_pushing.study.files.scenes import load_scene_file
from planar_pushing.study.provenance import provenance
from planar_pushing.study.simulations import simulate_file
from planar_pushing.study.slices import study_slice
from planar_pushing.study.store import group_names, write_dataset
from planar_pushing.study.study_file import load_study

SMOKE = "workflow/config/smoke.yaml"
SLIDERS_SMOKE = "workflow/config/sliders_smoke.yaml"


@pytest.fixture(scope="session")
def results(tmp_path_factory):
    """Folder of results with the datasets of the smoke study."""
    folder = tmp_path_factory.mktemp("results")
    study = load_study(SMOKE)
    marks = provenance(study, SMOKE)
    for name in DATASETS:
        built = of_study(build_dataset(name, study_slice(study, name)), name, marks(name))
        write_dataset(built, folder / f"data/{name}.nc")
    log = simulate_file(load_scene_file(study.simulations["figure_15"]))
    write_dataset(
        of_study(log, "figure_15", marks("simulations/figure_15")),
        folder / "data/simulations/figure_15.nc",
    )
    return folder


@pytest.fixture(scope="session")
def every(results):
    """Every dataset of a grid, and every scene, by its name; none may be changed."""
    scenes = [f"scenes/{group}" for group in group_names(results / "data/scenes.nc")]
    return [(name, pp.open_dataset(name, results)) for name in (*AXES, *scenes)]


@pytest.fixture(scope="session")
def sliders(results):
    """The same folder, with the datasets of the smoke study of sliders beside them."""
    study = load_study(SLIDERS_SMOKE)
    marks = provenance(study, SLIDERS_SMOKE)
    for name in SLIDERS:
        built = of_study(build_dataset(name, study_slice(study, name)), name, marks(name))
        write_dataset(built, results / f"studies/sliders/data/{name}.nc")
    return results


@pytest.fixture
def study_text(tmp_path):
    """Text of the smoke study, and its scenes where a copy in tmp_path/config finds them."""
    shutil.copytree("workflow/scenes", tmp_path / "scenes")
    (tmp_path / "config").mkdir()
    return Path(SMOKE).read_text(encoding="utf-8")
