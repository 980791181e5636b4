"""A dataset that is written block by block is the one that is written whole."""

import threading

import h5py
import numpy as np
import pytest
import xarray as xr
from planar_pushing.study.grids.streaming import stream_dataset
from planar_pushing.study.storage.parts import cut, sizes

from planar_pushing.mechanics.numerics.arrays import CORES
from planar_pushing.study import store
from planar_pushing.study.build import build_dataset
from planar_pushing.study.catalog import SPLIT
from planar_pushing.study.slices import study_slice
from planar_pushing.study.store import write_dataset
from planar_pushing.study.study_file import load_study
from planar_pushing.terms.errors import InvalidFile

STUDY = load_study("workflow/config/smoke.yaml")
#: Numbers of a stored piece, and points of a block.
STORED, MOST = 32, 256


@pytest.fixture(autouse=True)
def _small_pieces(monkeypatch):
    monkeypatch.setattr(store, "STORED", STORED)


def stream(name, path, **settings):
    values = study_slice(STUDY, name)
    stream_dataset(
        lambda part: build_dataset(name, cut(values, part)),
        sizes(name, values), path, **{"most": MOST} | settings,
    )  # fmt: skip


def assert_same_file(one, other):
    """The same variables, attributes and types, stored alike, in the same order."""
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
            assert set(node.attrs) == set(b[name].attrs)


@pytest.mark.parametrize("name", [*SPLIT, "scenes"])
def test_a_streamed_file_is_the_whole_one(tmp_path, name):
    one, other = tmp_path / "streamed.nc", tmp_path / "whole.nc"
    stream(name, one)
    write_dataset(build_dataset(name, study_slice(STUDY, name)), other)
    if name == "scenes":
        assert one.read_bytes() == other.read_bytes()
    else:
        assert_same_file(one, other)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["streamed.nc", "whole.nc"]


def test_the_bytes_do_not_depend_on_the_threads(tmp_path):
    for threads in (1, 3):
        stream("contact_modes", tmp_path / f"{threads}.nc", threads=threads)
    assert (tmp_path / "1.nc").read_bytes() == (tmp_path / "3.nc").read_bytes()


@pytest.mark.parametrize("threads", [1, 3])
def test_each_thread_uses_one_core(tmp_path, threads):
    cores = {}

    def noting(part):
        cores[threading.current_thread()] = CORES.get(None)
        return grid(part)

    stream_dataset(noting, {"a": 70, "b": 90}, tmp_path / "a.nc", most=500, threads=threads)
    assert cores.pop(threading.main_thread()) is None
    assert set(cores.values()) == {1}


def grid(part):
    """A grid whose variables lie along some of its dimensions."""
    a, b = (np.arange(n)[part.get(dim, slice(None))] for dim, n in (("a", 70), ("b", 90)))
    return xr.Dataset(
        {
            "both": (("a", "b"), np.add.outer(a, b / 8)),
            "turned": (("b", "a"), np.add.outer(b / 8, a)),
            "first": ("a", np.sqrt(a)),
            "held": (("a", "b"), np.add.outer(a, b) % 3 == 0),
        },
        coords={"a": a, "label": ("b", [f"of {each}" for each in b])},
    )


@pytest.mark.parametrize("most", [64, 700, 6299, 10**6])
def test_variables_along_other_dimensions(tmp_path, most):
    stream_dataset(grid, {"a": 70, "b": 90}, tmp_path / "streamed.nc", most=most)
    write_dataset(grid({}), tmp_path / "whole.nc")
    assert_same_file(tmp_path / "streamed.nc", tmp_path / "whole.nc")


def test_a_block_that_fails_leaves_the_old_file(tmp_path):
    path = tmp_path / "a.nc"
    path.write_bytes(b"old")

    def failing(part):
        if part["a"].start > 20:
            raise InvalidFile("no more")
        return grid(part)

    with pytest.raises(InvalidFile, match="no more"):
        stream_dataset(failing, {"a": 70, "b": 90}, path, most=500, threads=2)
    assert path.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [path]
