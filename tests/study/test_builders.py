"""Datasets built by name: bytes that depend on the content alone."""

import pytest

from planar_pushing.study.builders import BUILDERS, build_dataset
from planar_pushing.study.catalog import DATASETS, SLIDERS
from planar_pushing.study.describe import of_study
from planar_pushing.study.provenance import provenance
from planar_pushing.study.slices import study_slice
from planar_pushing.study.sliders_file import load_sliders
from planar_pushing.study.storage.store import write_dataset
from planar_pushing.study.study_file import load_study

SLIDERS_SMOKE = "workflow/config/sliders_smoke.yaml"


def test_every_dataset_has_its_builder():
    folder = "planar_pushing.study.datasets"
    expected = {name: f"{folder}.{name}" for name in DATASETS}
    expected |= {name: f"{folder}.sliders.{name}" for name in SLIDERS}
    assert expected == {name: build.__module__ for name, build in BUILDERS.items()}


@pytest.mark.parametrize("name", DATASETS)
def test_bytes_depend_on_the_content_alone(results, tmp_path, name):
    file = "workflow/config/smoke.yaml"
    study = load_study(file)
    built = build_dataset(name, study_slice(study, name))
    write_dataset(of_study(built, name, provenance(study, file)(name)), tmp_path / "again.nc")
    assert (tmp_path / "again.nc").read_bytes() == (results / f"data/{name}.nc").read_bytes()


@pytest.mark.parametrize("name", SLIDERS)
def test_bytes_of_a_study_of_sliders_depend_on_the_content_alone(sliders, tmp_path, name):
    study = load_sliders(SLIDERS_SMOKE)
    built = build_dataset(name, study_slice(study, name))
    write_dataset(
        of_study(built, name, provenance(study, SLIDERS_SMOKE)(name)), tmp_path / "again.nc"
    )
    first = sliders / f"studies/sliders/data/{name}.nc"
    assert (tmp_path / "again.nc").read_bytes() == first.read_bytes()
