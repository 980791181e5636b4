"""Results with the datasets of the smoke studies."""

import shutil
from pathlib import Path

import pytest

import planar_pushing as pp
from planar_pushing.scenes.files import load_scene_file
from planar_pushing.scenes.simulate import simulate_file
from planar_pushing.terms.netcdf import group_names, write_dataset
from pulling_by_pushing.study.catalog import DATASETS
from pulling_by_pushing.study.describe import of_study
from pulling_by_pushing.study.provenance import provenance
from pulling_by_pushing.study.running import build
from pulling_by_pushing.study.slices import computes, study_slice
from pulling_by_pushing.study.study_file import load_study

SMOKE = "workflow/config/smoke.yaml"
SLIDERS_SMOKE = "workflow/config/sliders_smoke.yaml"
#: The datasets of a grid of each study.
OF_PAPER = (
    "limit_curves",
    "motion_cones",
    "contact_modes",
    "acceleration_centers",
    "center_regions",
)
OF_SLIDERS = ("supports", "support_cones", "support_modes")


def built(file, folder):
    """Build the datasets of a study in a folder."""
    study = load_study(file)
    marks = provenance(study, file)
    for name in DATASETS:
        if computes(study, name):
            path, values = folder / f"data/{name}.nc", study_slice(study, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            build.dataset(path, name=name, study=values, marks=marks(name))
    return study, marks


@pytest.fixture(scope="session")
def results(tmp_path_factory):
    """Folder of results with the datasets of the smoke study."""
    folder = tmp_path_factory.mktemp("results")
    study, marks = built(SMOKE, folder)
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
    return [(name, pp.open_dataset(name, results)) for name in (*OF_PAPER, *scenes)]


@pytest.fixture(scope="session")
def sliders(results):
    """The same folder, with the datasets of the smoke study of sliders beside them."""
    built(SLIDERS_SMOKE, results / "studies/sliders")
    return results


@pytest.fixture
def study_text(tmp_path):
    """Text of the smoke study, and its scenes where a copy in tmp_path/config finds them."""
    shutil.copytree("workflow/scenes", tmp_path / "scenes")
    (tmp_path / "config").mkdir()
    return Path(SMOKE).read_text(encoding="utf-8")
