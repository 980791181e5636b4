"""Results with the datasets of the smoke studies."""

import shutil
from pathlib import Path

import pytest

import planar_pushing as pp
from planar_pushing.terms.netcdf import group_names
from smoke import SLIDERS_SMOKE as SLIDERS_SMOKE
from smoke import SMOKE as SMOKE
from smoke import smoke_results

#: The datasets of a grid of each study.
OF_PAPER = (
    "limit_curves",
    "curves",
    "motion_cones",
    "contact_modes",
    "mode_maps",
    "acceleration_centers",
    "center_regions",
)
OF_SLIDERS = ("supports", "support_cones", "support_modes", "support_curves", "support_rods")


@pytest.fixture(scope="session")
def results(tmp_path_factory):
    """Folder of results with those of both smoke studies."""
    return smoke_results(tmp_path_factory)


@pytest.fixture(scope="session")
def every(results):
    """Every dataset of a grid, and every scene, by its name; none may be changed."""
    scenes = [f"scenes/{group}" for group in group_names(results / "data/scenes.nc")]
    return [(name, pp.open_dataset(name, results)) for name in (*OF_PAPER, *scenes)]


@pytest.fixture(scope="session")
def sliders(results):
    """The same folder, named for the smoke study of sliders in it."""
    return results


@pytest.fixture
def study_text(tmp_path):
    """Text of the smoke study, and its scenes where a copy in tmp_path/config finds them."""
    shutil.copytree("workflow/scenes", tmp_path / "scenes")
    (tmp_path / "config").mkdir()
    return Path(SMOKE).read_text(encoding="utf-8")
