"""Results to query."""

import pytest

from planar_pushing.terms.netcdf import write_dataset
from pulling_by_pushing.study.running.build import build_dataset
from pulling_by_pushing.study.slices import study_slice
from pulling_by_pushing.study.study_file import load_study


@pytest.fixture(scope="session")
def cones(tmp_path_factory):
    """A folder of results with the motion cones of the small study."""
    folder = tmp_path_factory.mktemp("results")
    values = study_slice(load_study("workflow/config/smoke.yaml"), "motion_cones")
    write_dataset(build_dataset("motion_cones", values), folder / "data/motion_cones.nc")
    return str(folder)
