"""Datasets built by name: bytes that depend on the content alone."""

import pytest

from planar_pushing.study.build import build_dataset
from planar_pushing.study.catalog import DATASETS
from planar_pushing.study.describe import of_study
from planar_pushing.study.provenance import provenance
from planar_pushing.study.slices import study_slice
from planar_pushing.study.store import write_dataset
from planar_pushing.study.study_file import load_study


@pytest.mark.slow
@pytest.mark.parametrize("name", DATASETS)
def test_bytes_depend_on_the_content_alone(results, tmp_path, name):
    file = "workflow/config/smoke.yaml"
    study = load_study(file)
    built = build_dataset(name, study_slice(study, name))
    write_dataset(of_study(built, name, provenance(study, file)(name)), tmp_path / "again.nc")
    assert (tmp_path / "again.nc").read_bytes() == (results / f"data/{name}.nc").read_bytes()
