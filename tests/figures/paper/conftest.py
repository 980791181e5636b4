"""Numbers and pictures of the figures: of the grid, of scenes, and of motion."""

import contextlib
from pathlib import Path

import pytest

from planar_pushing.figures import render
from planar_pushing.figures.style import paper_style
from planar_pushing.study.build import build_dataset
from planar_pushing.study.files.study_model import FigureEntry
from planar_pushing.study.slices import study_slice
from planar_pushing.study.store import write_dataset
from planar_pushing.study.study_file import load_study

ROOT = Path(__file__).parents[3]
#: Figures of the grid, of scenes, and of motion.
GRID = [f"figure_{number}" for number in ("05", "06", "07", "10", "12", "13")]
SCENES = [f"figure_{number}" for number in ("01", "02", "03", "04", "08", "09", "11")]
MOTION = ["figure_14", "figure_15"]
DATASETS = ("limit_curves", "motion_cones", "acceleration_centers", "scenes")


@pytest.fixture(scope="session")
def grid_figures(tmp_path_factory):
    """Results folder of the smoke study, and what it says of the figures."""
    folder = tmp_path_factory.mktemp("results")
    with contextlib.chdir(ROOT):
        study = load_study("workflow/config/smoke.yaml")
        for name in DATASETS:
            write_dataset(build_dataset(name, study_slice(study, name)), folder / f"data/{name}.nc")
    return {name: (folder, study.figures[name]) for name in GRID}


@pytest.fixture(scope="session")
def scene_figures(tmp_path_factory):
    """Results folder with the datasets that the scene figures read."""
    folder = tmp_path_factory.mktemp("results")
    with contextlib.chdir(ROOT):
        study = load_study("workflow/config/paper.yaml")
        few = {"rod_length": (2.0, 3.0), "rod_angle": (45.0,), "friction_coefficient": (0.5, 2.0)}
        grid = study.grid.model_copy(update={"effects": ("support_friction",), **few})
        study = study.model_copy(update={"grid": grid})
        for name in ("scenes", "motion_cones"):
            write_dataset(build_dataset(name, study_slice(study, name)), folder / f"data/{name}.nc")
    return dict.fromkeys(SCENES, (folder, FigureEntry()))


@pytest.fixture(scope="session")
def motion_figures(logs, tmp_path_factory):
    folder = tmp_path_factory.mktemp("results")
    for name, log in logs.items():
        write_dataset(log, folder / f"data/simulations/{name}.nc")
    return dict.fromkeys(MOTION, (folder, FigureEntry()))


@pytest.fixture(scope="session")
def sources(grid_figures, scene_figures, motion_figures):
    """Results folder and settings of each figure."""
    return grid_figures | scene_figures | motion_figures


@pytest.fixture(scope="session")
def plotted(sources):
    return {name: render.select(name, *source) for name, source in sources.items()}


@pytest.fixture(scope="session")
def pictures(plotted):
    found = {}
    with paper_style():
        for name, data in plotted.items():
            found[name] = render.picture(name, data)
            found[name].draw_without_rendering()
    return found
