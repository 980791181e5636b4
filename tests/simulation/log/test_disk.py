"""A file for HDF5 on a disk that fills up."""

import errno
import resource
from contextlib import contextmanager

import h5py
import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.simulation.log.disk import new_file


@contextmanager
def room(size):
    """A limit on the size of files, which stands for a full disk: every write beyond it fails."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


def write(path, count):
    with new_file(path) as disk, h5py.File(disk, "w") as file:
        for i in range(count):
            file[f"part_{i}"] = np.full(1000, float(i))
            file.flush()
            disk.check()


def test_what_is_written_is_what_h5py_reads(tmp_path):
    path = tmp_path / "new" / "file.nc"
    write(path, 20)
    with h5py.File(path) as file:
        assert len(file) == 20
        assert all((file[f"part_{i}"][:] == i).all() for i in range(20))


@pytest.mark.parametrize("size", [0, 100, 50_000])
def test_a_full_disk_is_an_error_that_names_the_file_and_leaves_none(tmp_path, size):
    said = r"file\.nc: cannot be written \(File too large\); name another file"
    with pytest.raises(pp.InvalidFile, match=said), room(size):
        write(tmp_path / "file.nc", 20)
    assert not list(tmp_path.iterdir())


def test_another_error_is_not_taken_for_one_of_the_disk(tmp_path):
    def work():
        with new_file(tmp_path / "file.nc"):
            raise OSError(errno.ENOENT, "another file")

    with pytest.raises(OSError, match="another file"):
        work()


def test_a_place_that_cannot_be_written(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(pp.InvalidFile, match="cannot be written"):
        write(tmp_path / "file" / "log.nc", 1)
