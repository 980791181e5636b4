"""Results with the datasets of the smoke study."""

import pytest

from planar_pushing.study.builders import build_dataset
from planar_pushing.study.catalog import DATASETS
from planar_pushing.study.files.scenes import load_scene_file
from planar_pushing.study.simulations import simulate_file
from planar_pushing.study.slices import study_slice
from planar_pushing.study.store import write_dataset
from planar_pushing.study.study_file import load_study


@pytest.fixture(scope="session")
def results(tmp_path_factory):
    """Folder of results with the datasets of the smoke study."""
    folder = tmp_path_factory.mktemp("results")
    study = load_study("workflow/config/smoke.yaml")
    for name in DATASETS:
        write_dataset(build_dataset(name, study_slice(study, name)), folder / f"data/{name}.nc")
    log = simulate_file(load_scene_file(study.simulations["figure_15"]))
    write_dataset(log, folder / "data/simulations/figure_15.nc")
    return folder
