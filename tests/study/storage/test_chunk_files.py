"""Chunks of a dataset, gathered into one file or opened as one."""

import pytest
import xarray as xr
from planar_pushing.study.grids.chunks import chunk_parts, chunk_slice, chunk_steps
from planar_pushing.study.grids.streaming import stream_dataset
from planar_pushing.study.storage.chunk_files import index_of, open_chunks
from planar_pushing.study.storage.parts import sizes

import planar_pushing as pp
from planar_pushing.study.build import build_dataset
from planar_pushing.study.describe import of_study
from planar_pushing.study.provenance import provenance
from planar_pushing.study.slices import study_slice
from planar_pushing.study.store import write_dataset
from planar_pushing.study.study_file import load_study

SMOKE = "workflow/config/smoke.yaml"
CHUNKS = {
    "contact_modes": {"pusher_angle": 10, "contact": 3},
    "acceleration_centers": {"force_angle": 5},
    "motion_cones": {"effects": 1, "friction_coefficient": 3},
}
STUDY = load_study(SMOKE).model_copy(update={"chunks": CHUNKS})


@pytest.fixture(scope="session")
def chunked(tmp_path_factory):
    """Results in which datasets stay in their chunks."""
    folder = tmp_path_factory.mktemp("chunked")
    for name in CHUNKS:
        for chunk, part in chunk_parts(STUDY, name).items():
            built = build_dataset(name, chunk_slice(STUDY, name, part))
            write_dataset(built, folder / f"chunks/{name}/{chunk}.nc")
        index = of_study(
            index_of(opened(folder, name), chunk_steps(STUDY, name)), name, MARKS(name)
        )
        write_dataset(index, folder / f"data/{name}.nc")
    return folder


MARKS = provenance(load_study(SMOKE), SMOKE)


def opened(folder, name):
    lengths, steps = sizes(name, study_slice(STUDY, name)), chunk_steps(STUDY, name)
    return open_chunks(folder / "chunks" / name, lengths, steps)


@pytest.mark.parametrize("name", CHUNKS)
def test_chunks_open_as_the_whole_dataset(chunked, results, name):
    found = pp.open_dataset(name, chunked)
    assert all(each.chunks for each in found.data_vars.values())
    expected = pp.open_dataset(name, results)
    xr.testing.assert_identical(found.compute(), expected)
    assert list(found.variables) == list(expected.variables)
    assert list(found.attrs) == list(expected.attrs)


@pytest.mark.parametrize("name", CHUNKS)
def test_gathered_chunks_are_the_whole_file(chunked, results, tmp_path, name):
    marked = of_study(opened(chunked, name), name, MARKS(name))
    path = tmp_path / "gathered.nc"
    lengths = sizes(name, study_slice(STUDY, name))
    stream_dataset(lambda part: marked.isel(part).load(), lengths, path, most=10**6)
    assert path.read_bytes() == (results / f"data/{name}.nc").read_bytes()


def test_a_part_of_what_stays_in_chunks_is_read_alone(chunked):
    modes = pp.open_dataset("contact_modes", chunked).sel(effects="inertia", rod_length=2)
    found = modes.consistent.sel(contact="coulomb_1.4", pusher_angle=[-15, 0])
    assert found.sizes == {"pusher_magnitude": 1, "pusher_angle": 2, "mode": 4}
    assert found.sum() > 0


def test_a_chunk_that_is_missing_is_named(chunked, tmp_path):
    index = (chunked / "data/motion_cones.nc").read_bytes()
    (tmp_path / "data").mkdir()
    (tmp_path / "data/motion_cones.nc").write_bytes(index)
    missing = r"motion_cones/effects_0.friction_coefficient_0.nc: no such dataset; build it"
    with pytest.raises(pp.InvalidFile, match=missing):
        pp.open_dataset("motion_cones", tmp_path)


@pytest.mark.parametrize("steps", ["3", "{}", '{"mode": 1}', '{"contact": 0}', "no JSON"])
def test_an_index_that_names_no_chunks_is_refused(tmp_path, steps):
    write_dataset(xr.Dataset(attrs={"chunks": steps}), tmp_path / "data/contact_modes.nc")
    with pytest.raises(
        pp.InvalidFile, match=r"modes\.nc: names no chunks; remove it and build it anew"
    ):
        pp.open_dataset("contact_modes", tmp_path)


def test_chunks_of_another_grid_are_refused(chunked, tmp_path):
    (tmp_path / "chunks").symlink_to(chunked / "chunks")
    index = xr.load_dataset(chunked / "data/motion_cones.nc", engine="h5netcdf")
    other = index.assign_coords(friction_coefficient=index.friction_coefficient + 1)
    write_dataset(other, tmp_path / "data/motion_cones.nc")
    with pytest.raises(pp.InvalidFile, match="its chunks are those of another grid"):
        pp.open_dataset("motion_cones", tmp_path)
