"""Datasets in files: in blocks, in chunks that are gathered or stay, each as if in one piece."""

import h5py
import numpy as np
import pytest
import xarray as xr
from study.conftest import OF_PAPER, SLIDERS_SMOKE, SMOKE

import planar_pushing as pp
from planar_pushing.terms.errors import InvalidFile
from planar_pushing.terms.netcdf import write_dataset
from pulling_by_pushing.study.chunks import blocks, chunk_parts, chunk_slice, chunk_steps
from pulling_by_pushing.study.provenance import provenance
from pulling_by_pushing.study.running import build
from pulling_by_pushing.study.slices import points, sizes, study_slice
from pulling_by_pushing.study.store import read_dataset
from pulling_by_pushing.study.study_file import load_study

CHUNKS = {
    "motion_cones": {"effects": 2, "friction_coefficient": 3},
    "support_rods": {"support": 2},
}
STUDIES = {file: load_study(file) for file in (SMOKE, SLIDERS_SMOKE)}


def of(name):
    """Study of a dataset with its chunks, and the attributes that name it."""
    file = SLIDERS_SMOKE if name.startswith("support") else SMOKE
    study = STUDIES[file]
    chunked = study.model_copy(update={"chunks": {name: CHUNKS.get(name, {})}})
    return chunked, provenance(study, file)(name)


def whole_file(results, name):
    folder = results / "studies/sliders" if name.startswith("support") else results
    return folder / f"data/{name}.nc"


def assert_same_content(one, other):
    """The same variables, attributes and types, compressed alike, in the same order."""
    with (
        xr.open_dataset(one, engine="h5netcdf") as a,
        xr.open_dataset(other, engine="h5netcdf") as b,
    ):
        xr.testing.assert_identical(a, b)
        assert list(a.variables) == list(b.variables)
        assert list(a.attrs) == list(b.attrs)
        assert all(list(a[name].attrs) == list(b[name].attrs) for name in a.variables)
    with h5py.File(one) as a, h5py.File(other) as b:
        for name, node in a.items():
            for kind in ("dtype", "shape", "chunks", "compression", "compression_opts", "shuffle"):
                assert getattr(node, kind) == getattr(b[name], kind), (name, kind)


@pytest.mark.parametrize("name", [*OF_PAPER, "support_modes"])
def test_a_grid_in_blocks_is_the_one_in_one_piece(sliders, tmp_path, monkeypatch, name):
    study, marks = of(name)
    values = study_slice(study, name)
    # A ring alone in a block has formulas of its own, which differ from a pressure's by rounding.
    most = 256 if name == "support_modes" else points(name, values) * 2 // 3
    monkeypatch.setattr(build, "blocks", lambda lengths: blocks(lengths, most))
    assert len(build.blocks(sizes(name, values))) > 1
    path = tmp_path / f"{name}.nc"
    build.dataset(path, name=name, study=values, marks=marks)
    assert_same_content(path, whole_file(sliders, name))
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.slow
@pytest.mark.parametrize("name", [*OF_PAPER, "scenes"])
def test_bytes_depend_on_the_content_alone(results, tmp_path, name):
    study, marks = of(name)
    build.dataset(tmp_path / "again.nc", name=name, study=study_slice(study, name), marks=marks)
    assert (tmp_path / "again.nc").read_bytes() == (results / f"data/{name}.nc").read_bytes()


def test_a_block_that_fails_leaves_the_old_file(tmp_path, monkeypatch):
    study, marks = of("motion_cones")
    monkeypatch.setattr(build, "blocks", lambda lengths: blocks(lengths, 20))
    path, given = tmp_path / "motion_cones.nc", study_slice(study, "motion_cones")
    path.write_bytes(b"old")
    cuts = iter(range(10))

    def failing(name, values):
        if next(cuts) == 2:
            raise InvalidFile("no more")
        return BUILD(name, values)

    monkeypatch.setattr(build, "build_dataset", failing)
    with pytest.raises(InvalidFile, match="no more"):
        build.dataset(path, name="motion_cones", study=given, marks=marks)
    assert path.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [path]


BUILD = build.build_dataset


@pytest.fixture(scope="session")
def chunked(tmp_path_factory):
    """Results in which datasets stay in their chunks."""
    folder = tmp_path_factory.mktemp("chunked")
    for name in CHUNKS:
        study, marks = of(name)
        files = []
        for chunk, part in chunk_parts(study, name).items():
            files.append(folder / f"chunks/{name}/{chunk}.nc")
            files[-1].parent.mkdir(parents=True, exist_ok=True)
            build.dataset(files[-1], name=name, study=chunk_slice(study, name, part))
        path = folder / f"data/{name}.nc"
        build.index(
            path, chunks=list(map(str, files)), name=name, chunking=gathering(name), marks=marks
        )
    return folder


def gathering(name):
    study, _ = of(name)
    lengths = sizes(name, study_slice(study, name))
    return {"lengths": lengths, "steps": chunk_steps(study, name)}


@pytest.mark.parametrize("name", CHUNKS)
def test_a_chunk_names_no_study(chunked, name):
    for path in (chunked / f"chunks/{name}").iterdir():
        assert "study" not in read_dataset(path).attrs


@pytest.mark.parametrize("name", CHUNKS)
def test_gathered_chunks_are_the_whole_file(chunked, sliders, tmp_path, name):
    _, marks = of(name)
    files = sorted(map(str, (chunked / f"chunks/{name}").iterdir()))
    path = tmp_path / f"{name}.nc"
    build.gather(path, chunks=files, name=name, chunking=gathering(name), marks=marks)
    assert_same_content(path, whole_file(sliders, name))


@pytest.mark.parametrize("name", CHUNKS)
def test_chunks_open_as_the_whole_dataset(chunked, sliders, name):
    found, expected = pp.open_dataset(name, chunked), read_dataset(whole_file(sliders, name))
    assert all(each.chunks for each in found.data_vars.values())
    xr.testing.assert_identical(found.compute(), expected.load())
    assert list(found.variables) == list(expected.variables)
    assert list(found.attrs) == list(expected.attrs)


def test_a_part_of_what_stays_in_chunks_is_read_alone(chunked):
    cones = pp.open_dataset("motion_cones", chunked).sel(effects="inertia", rod_length=2)
    edges = cones.motion_cone_left.sel(rod_angle=45, friction_coefficient=[1.5, np.inf])
    assert dict(edges.sizes) == {"friction_coefficient": 2}  # of two chunks
    assert np.isfinite(edges).all()


def test_a_chunk_that_is_missing_is_named(chunked, tmp_path):
    index = (chunked / "data/motion_cones.nc").read_bytes()
    (tmp_path / "data").mkdir()
    (tmp_path / "data/motion_cones.nc").write_bytes(index)
    with pytest.raises(pp.InvalidFile, match=r"chunks/motion_cones.*: no such dataset; build it"):
        pp.open_dataset("motion_cones", tmp_path)


@pytest.mark.parametrize("steps", ["3", "{}", '{"mode": 1}', '{"contact": 0}', "no JSON"])
def test_an_index_that_names_no_chunks_is_refused(tmp_path, steps):
    write_dataset(xr.Dataset(attrs={"chunks": steps}), tmp_path / "data/contact_modes.nc")
    with pytest.raises(
        pp.InvalidFile, match=r"modes\.nc: names no chunks; delete it and build it again"
    ):
        pp.open_dataset("contact_modes", tmp_path)


def test_chunks_of_another_grid_are_refused(chunked, tmp_path):
    (tmp_path / "chunks").symlink_to(chunked / "chunks")
    index = xr.load_dataset(chunked / "data/motion_cones.nc", engine="h5netcdf")
    other = index.assign_coords(friction_coefficient=index.friction_coefficient + 1)
    write_dataset(other, tmp_path / "data/motion_cones.nc")
    with pytest.raises(pp.InvalidFile, match="its chunks belong to another grid"):
        pp.open_dataset("motion_cones", tmp_path)
