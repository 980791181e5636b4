"""Damaged and foreign files end in one line, whatever the libraries below make of them."""

import random

import h5py
import numpy as np
import pytest
import xarray as xr

import planar_pushing as pp
from planar_pushing.study.store import (
    group_names,
    read_attributes,
    read_dataset,
    write_dataset,
)

WHOLE = xr.Dataset(
    {"angle": (("side", "step"), np.arange(6.0).reshape(2, 3), {"units": "degree"})},
    coords={"side": ["right", "left"], "step": [1.0, 2.0, 3.0]},
    attrs={"title": "something small"},
)


@pytest.fixture
def path(tmp_path):
    write_dataset(WHOLE, tmp_path / "data.nc")
    return tmp_path / "data.nc"


def flipped(content, rng):
    """The bytes with one to twenty bits turned over."""
    damaged = bytearray(content)
    for _ in range(rng.choice([1, 1, 2, 5, 20])):
        place = rng.randrange(8 * len(damaged))
        damaged[place // 8] ^= 1 << place % 8
    return bytes(damaged)


def complaint(read, path):
    """What is said of a file that is refused; nothing of one that is read."""
    try:
        read(path)
    except pp.InvalidFile as error:
        return str(error)
    return ""


def test_flipped_bits_end_in_one_line(path, tmp_path):
    rng, content, refused = random.Random(13), path.read_bytes(), 0
    for i in range(150):
        damaged = tmp_path / f"{i}.nc"
        damaged.write_bytes(flipped(content, rng))
        for read in (read_dataset, group_names, read_attributes):
            said = complaint(read, damaged)
            assert not said or said.startswith(f"{damaged}: ")
            assert "\n" not in said
            refused += bool(said)
    assert refused > 50


@pytest.mark.parametrize("size", [0, 7, 100, 1000])
def test_a_cut_file_ends_in_one_line(path, size):
    path.write_bytes(path.read_bytes()[:size])
    with pytest.raises(pp.InvalidFile, match="is not a netCDF4 file; remove it and build it anew"):
        read_dataset(path)


@pytest.mark.parametrize("window", [2**24, 97])
@pytest.mark.parametrize(("index", "size"), [(0, 0), (1, 2**64 - 16), (1, 2**40)])
def test_a_heap_in_which_the_library_goes_round_is_refused(path, index, size, window, monkeypatch):
    """An object whose size leads back to itself, or out of the heap, wherever a search begins."""
    monkeypatch.setattr("planar_pushing.study.storage.hdf5.WINDOW", window)
    content = bytearray(path.read_bytes())
    place = content.index(b"GCOL") + 16
    content[place : place + 2] = index.to_bytes(2, "little")
    content[place + 8 : place + 16] = size.to_bytes(8, "little")
    path.write_bytes(content)
    with pytest.raises(pp.InvalidFile, match="has a damaged heap; remove it and build it anew"):
        read_dataset(path)


def test_bad_units_of_time_are_text_like_any_other(path):
    write_dataset(
        WHOLE.assign_coords(step=("step", [1, 2, 3], {"units": "days since never"})), path
    )
    assert read_dataset(path).step.attrs["units"] == "days since never"


def test_a_huge_sparse_array_is_refused_before_it_is_read(path):
    with h5py.File(path, "a") as file:
        file.create_dataset("huge", shape=(10**6, 10**6), dtype="f8", chunks=(100, 100))
    assert path.stat().st_size < 10**5
    with pytest.raises(
        pp.InvalidFile, match="declares more than it holds; remove it and build it anew"
    ):
        read_dataset(path)


def test_external_storage_is_not_followed(path, tmp_path):
    (tmp_path / "secret").write_bytes(bytes(64))
    with h5py.File(path, "a") as file:
        file.create_dataset("out", (8,), "f8", external=[(str(tmp_path / "secret"), 0, 64)])
    with pytest.raises(
        pp.InvalidFile, match="/out is stored elsewhere; remove it and build it anew"
    ):
        read_dataset(path)


def test_a_virtual_dataset_is_not_followed(path, tmp_path):
    layout = h5py.VirtualLayout((3,), "f8")
    layout[:] = h5py.VirtualSource(str(tmp_path / "other.nc"), "step", (3,))
    with h5py.File(path, "a") as file:
        file.create_virtual_dataset("out", layout)
    with pytest.raises(
        pp.InvalidFile, match="/out is stored elsewhere; remove it and build it anew"
    ):
        read_dataset(path)


@pytest.mark.parametrize("link", [h5py.ExternalLink("other.nc", "/"), h5py.SoftLink("/")])
def test_links_are_not_followed(path, link):
    with h5py.File(path, "a") as file:
        file["elsewhere"] = link
    with pytest.raises(pp.InvalidFile, match="elsewhere is a link; remove it and build it anew"):
        read_dataset(path)


@pytest.mark.parametrize(
    "name", ["simulations/../limit_curves", "../limit_curves", "figures/../../x", "scenes/a/b",
             "simulations/", "simulations", "figures", 5, None, "limit_curves/", "a\0b"],
)  # fmt: skip
def test_a_name_does_not_leave_the_results(tmp_path, name):
    with pytest.raises(pp.InvalidValue, match=r"allowed: limit_curves, .*name one of these"):
        pp.open_dataset(name, tmp_path)
