"""Files are replaced whole or not at all."""

import errno

import pytest

from planar_pushing.study.files.replacing import replacing
from planar_pushing.terms.errors import InvalidFile


def test_replacing_keeps_the_old_file_when_the_work_fails(tmp_path):
    path = tmp_path / "file.txt"
    path.write_text("old")

    def work():
        with replacing(path) as temporary:
            temporary.write_text("ne")
            raise RuntimeError("half way")

    with pytest.raises(RuntimeError, match="half way"):
        work()
    assert path.read_text() == "old"
    assert list(tmp_path.iterdir()) == [path]


def test_a_full_disk_is_named(tmp_path):
    def work():
        with replacing(tmp_path / "file.txt"):
            raise OSError(errno.ENOSPC, "No space left on device")

    said = r"file\.txt: cannot be written \(No space left on device\); name another file"
    with pytest.raises(InvalidFile, match=said):
        work()
    assert not list(tmp_path.iterdir())


def test_a_folder_in_its_place_is_named(tmp_path):
    (tmp_path / "file.txt").mkdir()

    def work():
        with replacing(tmp_path / "file.txt") as temporary:
            temporary.write_text("new")

    with pytest.raises(InvalidFile, match=r"file\.txt: cannot be written \(Is a directory\)"):
        work()
    assert [each.name for each in tmp_path.iterdir()] == ["file.txt"]
