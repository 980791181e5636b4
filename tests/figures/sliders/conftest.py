"""Numbers and pictures of the figures of the smoke study of sliders."""

import pytest

from planar_pushing.figures import render
from planar_pushing.figures.style import paper_style
from planar_pushing.study.build import build_dataset
from planar_pushing.study.figures import GALLERY
from planar_pushing.study.files.scenes import load_scene_file
from planar_pushing.study.simulations import simulate_file
from planar_pushing.study.slices import study_slice
from planar_pushing.study.store import write_dataset
from planar_pushing.study.study_file import load_study


@pytest.fixture(scope="session")
def study():
    return load_study("workflow/config/sliders_smoke.yaml")


@pytest.fixture(scope="session")
def results(study, tmp_path_factory):
    """Folder of results with what the figures read."""
    folder = tmp_path_factory.mktemp("results")
    for name in ("supports", "support_cones"):
        write_dataset(build_dataset(name, study_slice(study, name)), folder / f"data/{name}.nc")
    log = simulate_file(load_scene_file(study.simulations["tripod"]))
    write_dataset(log, folder / "data/simulations/tripod.nc")
    return folder


@pytest.fixture(scope="session")
def plotted(results, study):
    return {name: render.select(name, results, study.slider) for name in GALLERY}


@pytest.fixture(scope="session")
def pictures(plotted):
    found = {}
    with paper_style():
        for name, data in plotted.items():
            found[name] = render.picture(name, data)
            found[name].draw_without_rendering()
    return found
