"""A file for HDF5: on a disk that fills up, and under several writers and readers."""

import errno
import re
import resource
import subprocess
import sys
from contextlib import contextmanager

import h5py
import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.simulation.disk import Disk, new_file, undisturbed
from planar_pushing.study.files.replacing import replacing


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
    with new_file(path) as disk, undisturbed(), h5py.File(disk, "w") as file:
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


def test_hdf5_reads_what_it_wrote_even_if_the_disk_is_full(tmp_path):
    written = b""
    with Disk(tmp_path / "file.nc") as disk:
        # The last data would fit on the disk again, below older data in memory.
        for place, size in ((0, 130), (100, 130), (50, 130), (140, 130), (120, 1000)):
            data = bytes(range(place // 2, place // 2 + 100))
            disk.seek(place)
            with room(size):
                assert disk.write(memoryview(data)) == len(data)
            assert disk.tell() == place + len(data)
            written = written[:place] + data + written[place + len(data) :]
            for start, count in ((0, 240), (95, 10), (120, 20), (230, 30), (500, 4)):
                found = bytearray(b"x" * count)
                disk.seek(start)
                assert disk.readinto(found) == count
                assert disk.tell() == start + count
                assert found == written[start:][:count].ljust(count, b"\0")
    with pytest.raises(OSError, match="File too large"):
        disk.check()


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


def test_a_second_writer_is_refused_before_anything_is_lost(tmp_path):
    path, link = tmp_path / "file.nc", tmp_path / "link.nc"
    link.symlink_to(path)
    with new_file(path) as disk, undisturbed(), h5py.File(disk, "w") as file:
        file["part"] = np.arange(3)
        file.flush()
        content = path.read_bytes()
        for name in (path, link):
            said = f"{name}: another process is writing it; name another file"
            with pytest.raises(pp.InvalidFile, match=re.escape(said)):
                write(name, 1)
        assert path.read_bytes() == content
        file["other"] = np.arange(5)
    with h5py.File(path) as file:
        assert sorted(file) == ["other", "part"]
    write(link, 2)
    assert link.is_symlink()
    with h5py.File(path) as file:
        assert sorted(file) == ["part_0", "part_1"]
    assert sorted(each.name for each in tmp_path.iterdir()) == ["file.nc", "link.nc"]


def test_another_process_reads_while_it_is_written(tmp_path):
    reads = "import h5py; print(h5py.File('file.nc')['part'][:].tolist())"
    with new_file(tmp_path / "file.nc") as disk, undisturbed(), h5py.File(disk, "w") as file:
        file["part"] = np.arange(3)
        file.flush()
        found = subprocess.run(
            [sys.executable, "-c", reads], cwd=tmp_path, capture_output=True, text=True, check=True
        )
    assert found.stdout == "[0, 1, 2]\n"


def test_a_dataset_and_a_log_of_one_name_are_not_written_at_once(tmp_path):
    path = tmp_path / "file.nc"
    busy = pytest.raises(pp.InvalidFile, match="another process is writing it")
    with new_file(path), busy, replacing(path):
        pass
    with replacing(path), busy, new_file(path):
        pass
    assert path.stat().st_size == 0


def test_a_link_in_the_place_of_the_lock_is_not_followed(tmp_path):
    victim = tmp_path / "victim"
    victim.write_text("keep")
    (tmp_path / ".file.nc.lock").symlink_to(victim)
    write(tmp_path / "file.nc", 1)
    assert victim.read_text() == "keep"
    assert sorted(each.name for each in tmp_path.iterdir()) == ["file.nc", "victim"]
