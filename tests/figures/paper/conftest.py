"""Numbers and pictures of the figures: of the grid, of scenes, and of motion."""

import contextlib
import io
from contextlib import chdir
from pathlib import Path

import pytest

from planar_pushing.figures import render, style
from planar_pushing.figures.style import paper_style
from planar_pushing.study import slices, store, study_file
from planar_pushing.study.datasets import motion_cones, scenes
from planar_pushing.study.models import FigureEntry, Grid
from planar_pushing.study.store import write_dataset
from planar_pushing.study.study_file import load_study

ROOT = Path(__file__).parents[3]
#: Figures of the grid, and of scenes.
GRID = [f"figure_{number}" for number in ("05", "06", "07", "10", "12", "13")]
SCENES = ("figure_01", "figure_02", "figure_03", "figure_04", "figure_08", "figure_09", "figure_11")
DATASETS = ("limit_curves", "motion_cones", "acceleration_centers", "contact_modes", "scenes")


@pytest.fixture(scope="session")
def study():
    with contextlib.chdir(ROOT):
        return study_file.load_study("workflow/config/smoke.yaml")


@pytest.fixture(scope="session")
def grid_results(study, tmp_path_factory):
    folder = tmp_path_factory.mktemp("results")
    (folder / "data").mkdir()
    with contextlib.chdir(ROOT):
        for name in DATASETS:
            built = slices.build_dataset(name, slices.study_slice(study, name))
            store.write_dataset(built, folder / "data" / f"{name}.nc")
    return folder


@pytest.fixture(scope="session")
def plotted(study, grid_results):
    return {name: render.select(name, grid_results, study.figures[name]) for name in GRID}


@pytest.fixture(scope="session")
def pictures(plotted):
    with paper_style():
        return {name: render.picture(name, data) for name, data in plotted.items()}


@pytest.fixture(scope="session")
def scene_results(tmp_path_factory):
    """Results folder with the datasets that the scene figures read."""
    folder = tmp_path_factory.mktemp("results")
    with chdir(ROOT):
        study = load_study("workflow/config/paper.yaml")
        write_dataset(scenes.build(study), folder / "data" / "scenes.nc")
    grid = Grid.model_construct(
        effects=("support_friction",),
        rod_length=(2.0, 3.0),
        rod_angle=(45.0,),
        friction_coefficient=(0.5, 2.0),
    )
    cones = motion_cones.build(study.model_copy(update={"grid": grid}))
    write_dataset(cones, folder / "data" / "motion_cones.nc")
    return folder


@pytest.fixture
def data(scene_results, request):
    return render.select(request.param, scene_results, FigureEntry())


@pytest.fixture
def picture(scene_results, request):
    with style.paper_style():
        data = render.select(request.param, scene_results, FigureEntry())
        figure = render.picture(request.param, data)
        figure.savefig(io.BytesIO(), format="png", dpi="figure")
        yield figure


@pytest.fixture(scope="session")
def motion_results(logs, tmp_path_factory):
    folder = tmp_path_factory.mktemp("results")
    for name, log in logs.items():
        write_dataset(log, folder / f"data/simulations/{name}.nc")
    return folder


@pytest.fixture(scope="session")
def motions(motion_results):
    return {
        name: render.select(name, motion_results, FigureEntry())
        for name in ("figure_14", "figure_15")
    }
