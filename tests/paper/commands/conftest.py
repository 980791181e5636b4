"""The command line in this process, and results that it queries."""

import pytest

from command_line import refused as refused
from command_line import run as run
from planar_pushing.terms.netcdf import write_dataset
from pulling_by_pushing.study.running.build import build_dataset
from pulling_by_pushing.study.slices import study_slice
from pulling_by_pushing.study.study_file import load_study


@pytest.fixture(scope="session")
def results(tmp_path_factory):
    folder = tmp_path_factory.mktemp("results")
    study = load_study("workflow/config/smoke.yaml")
    for name in ("motion_cones", "contact_modes"):
        built = build_dataset(name, study_slice(study, name))
        write_dataset(built, folder / f"data/{name}.nc")
    return str(folder)
