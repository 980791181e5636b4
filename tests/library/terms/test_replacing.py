"""Files are replaced whole or not at all, by one writer at a time."""

import errno
import fcntl
import os
import socket
import subprocess
import sys
import threading
import time

import numpy as np
import pytest
import xarray as xr
from mechanics.builders import make_scene
from simulation.runs import heading, run

import planar_pushing as pp
from planar_pushing.terms.errors import InvalidFile
from planar_pushing.terms.netcdf import write_dataset
from planar_pushing.terms.replacing import replacing, working_folder
from pulling_by_pushing.study.store import read_dataset

BUSY = r"file\.txt: another process is writing it; name another file"
#: A process that writes half of a file and then does what it is told.
WRITER = """
import os, signal, sys
from planar_pushing.terms.replacing import replacing, working_folder
with replacing("file.txt") as temporary:
    temporary.write_text("half")
    print("ready", flush=True)
    if sys.stdin.readline() == "die\\n":
        os.kill(os.getpid(), signal.SIGKILL)
    temporary.write_text("whole")
"""


def write(path, text="new"):
    with replacing(path) as temporary:
        temporary.write_text(text)


def names(folder):
    return sorted(each.name for each in folder.iterdir())


def started(folder):
    """A process that is writing a file."""
    process = subprocess.Popen(
        [sys.executable, "-c", WRITER],
        cwd=folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
    )  # fmt: skip
    assert process.stdout.readline() == "ready\n"
    return process


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
    with pytest.raises(InvalidFile, match=r"file\.txt: cannot be written \(Is a directory\)"):
        write(tmp_path / "file.txt")
    assert names(tmp_path) == ["file.txt"]


def test_a_second_writer_is_refused_in_one_process_also_from_a_thread(tmp_path):
    path, refusals = tmp_path / "file.txt", []
    path.write_text("old")

    def work():
        with pytest.raises(InvalidFile, match=BUSY) as caught:
            write(path, "second")
        refusals.append(caught.value)

    with replacing(path) as temporary:
        temporary.write_text("first")
        work()
        thread = threading.Thread(target=work)
        thread.start()
        thread.join()
        write(tmp_path / "other.txt")
        assert path.read_text() == "old"
    assert len(refusals) == 2
    assert path.read_text() == "first"
    assert names(tmp_path) == ["file.txt", "other.txt"]


def test_a_second_process_is_refused_and_the_first_one_finishes(tmp_path):
    process = started(tmp_path)
    before = names(tmp_path)
    with pytest.raises(InvalidFile, match=BUSY):
        write(tmp_path / "file.txt")
    assert names(tmp_path) == before
    process.communicate("go on\n")
    assert (tmp_path / "file.txt").read_text() == "whole"
    assert names(tmp_path) == ["file.txt"]


def test_what_a_killed_process_leaves_is_removed_by_the_next_one(tmp_path):
    process = started(tmp_path)
    process.communicate("die\n")
    (tmp_path / ".file.txt.notes.part").write_text("the user's own")
    assert len(names(tmp_path)) == 3
    write(tmp_path / "file.txt")
    assert names(tmp_path) == [".file.txt.notes.part", "file.txt"]


@pytest.mark.parametrize("name", [".file.txt.lock", ".file.txt.part", ".file.txt.30303030.part"])
def test_a_link_where_a_temporary_file_could_be_is_not_followed(tmp_path, monkeypatch, name):
    victim = tmp_path / "victim"
    victim.write_text("keep")
    (tmp_path / name).symlink_to(victim)
    monkeypatch.setattr(os, "urandom", lambda count: b"0" * count)
    write(tmp_path / "file.txt")
    assert victim.read_text() == "keep"
    assert not (tmp_path / "file.txt").is_symlink()
    assert (tmp_path / "file.txt").read_text() == "new"


def test_a_link_that_appears_at_the_temporary_name_is_not_followed(tmp_path, monkeypatch):
    victim = tmp_path / "victim"
    victim.write_text("keep")

    def plant(count):
        (tmp_path / ".file.txt.30303030.part").symlink_to(victim)
        return b"0" * count

    monkeypatch.setattr(os, "urandom", plant)
    with pytest.raises(InvalidFile, match=r"file\.txt: cannot be written \(File exists\)"):
        write(tmp_path / "file.txt")
    assert victim.read_text() == "keep"


@pytest.mark.parametrize("number", [errno.ENOLCK, errno.EOPNOTSUPP, errno.ENOSYS])
def test_a_file_system_without_locks_is_written_too(tmp_path, monkeypatch, number):
    def flock(*given):
        raise OSError(number, os.strerror(number))

    monkeypatch.setattr(fcntl, "flock", flock)
    left = tmp_path / ".file.txt.01234567.part"
    left.write_text("perhaps of a running process")
    write(tmp_path / "file.txt")
    assert (tmp_path / "file.txt").read_text() == "new"
    assert names(tmp_path) == [left.name, "file.txt"]


def test_permissions_are_those_that_the_user_gives_new_files(tmp_path):
    before = os.umask(0o027)
    try:
        write(tmp_path / "file.txt")
    finally:
        os.umask(before)
    assert (tmp_path / "file.txt").stat().st_mode & 0o777 == 0o640


# --- What stands in the place of the file ---------------------------------------------------------


def test_the_target_of_a_link_is_replaced(tmp_path):
    (tmp_path / "folder").mkdir()
    (tmp_path / "link").symlink_to("folder/file.txt")
    for text in ("new", "newer"):  # the target is missing, or there
        write(tmp_path / "link", text)
        assert (tmp_path / "link").is_symlink()
        assert (tmp_path / "folder" / "file.txt").read_text() == text
    assert names(tmp_path) == ["folder", "link"]
    assert names(tmp_path / "folder") == ["file.txt"]


def test_two_names_of_a_file_have_one_writer(tmp_path):
    (tmp_path / "link").symlink_to("file.txt")
    with replacing(tmp_path / "file.txt") as temporary:
        temporary.write_text("first")
        with pytest.raises(InvalidFile, match="link: another process is writing it"):
            write(tmp_path / "link")
    assert (tmp_path / "file.txt").read_text() == "first"


@pytest.mark.parametrize("mode", [0o600, 0o640, 0o666, 0o755])
def test_permissions_are_kept(tmp_path, mode):
    (tmp_path / "file.txt").write_text("old")
    (tmp_path / "file.txt").chmod(mode)
    with replacing(tmp_path / "file.txt") as temporary:
        assert temporary.stat().st_mode & 0o777 == 0o600
        temporary.write_text("new")
    assert (tmp_path / "file.txt").read_text() == "new"
    assert (tmp_path / "file.txt").stat().st_mode & 0o777 == mode


def special_file(kind, path):
    """Make something that is no regular file; its description in messages."""
    if kind == "device":
        path.symlink_to(os.devnull)
    elif kind == "pipe":
        os.mkfifo(path)
    elif kind == "socket":
        with socket.socket(socket.AF_UNIX) as server:
            server.bind(str(path))
    else:
        path.mkdir()
    return {"folder": "Is a directory"}.get(kind, f"Is a {kind}")


WRITERS = {
    "replacing": write,
    "save_scene": lambda path: pp.save_scene(make_scene(2, 0.5), path),
    "simulate": lambda path: run(make_scene(2, 0.5), [(0, heading(60))], 1, path=path),
}


@pytest.mark.parametrize("kind", ["device", "pipe", "socket", "folder"])
@pytest.mark.parametrize("writer", WRITERS)
def test_what_is_no_regular_file_is_refused_and_stays(tmp_path, writer, kind):
    description = special_file(kind, tmp_path / "f")
    before = (tmp_path / "f").stat()
    with pytest.raises(InvalidFile) as caught:
        WRITERS[writer](tmp_path / "f")
    assert str(caught.value) == (
        f"{tmp_path}/f: cannot be written ({description}); name another file"
    )
    assert os.path.samestat((tmp_path / "f").stat(), before)
    assert names(tmp_path) == ["f"]


def test_a_file_that_the_user_may_not_write_is_refused(tmp_path, monkeypatch):
    (tmp_path / "file.txt").write_text("old")
    monkeypatch.setattr(os, "access", lambda path, mode: False)
    with pytest.raises(InvalidFile, match=r"file\.txt: cannot be written \(Permission denied\)"):
        write(tmp_path / "file.txt")
    assert (tmp_path / "file.txt").read_text() == "old"


# --- A folder for what a file is made from --------------------------------------------------------


def test_a_working_folder_is_new_and_is_removed(tmp_path):
    with working_folder(tmp_path / "file.txt") as folder:
        (folder / "block").write_text("1")
        with (
            pytest.raises(InvalidFile, match=BUSY),
            working_folder(tmp_path / "file.txt"),
        ):
            pytest.fail("a second process makes the same file")
        write(tmp_path / "file.txt")
        assert names(folder) == ["block"]
    assert names(tmp_path) == ["file.txt"]


MAKER = """
import os, signal
from planar_pushing.terms.replacing import replacing, working_folder
with working_folder("file.txt") as folder, replacing(folder / "block") as temporary:
    temporary.write_text("half")
    os.kill(os.getpid(), signal.SIGKILL)
"""


def test_the_working_folder_of_a_killed_process_is_removed_by_the_next_one(tmp_path):
    subprocess.run([sys.executable, "-c", MAKER], cwd=tmp_path, check=False)
    assert names(tmp_path) == ["..file.txt.blocks.lock", ".file.txt.blocks"]
    with working_folder(tmp_path / "file.txt") as folder:
        assert names(folder) == []
    assert names(tmp_path) == []


def test_without_locks_the_working_folder_of_another_process_stays(tmp_path, monkeypatch):
    def flock(*given):
        raise OSError(errno.ENOLCK, os.strerror(errno.ENOLCK))

    monkeypatch.setattr(fcntl, "flock", flock)
    (tmp_path / ".file.txt.blocks").mkdir()
    with working_folder(tmp_path / "file.txt") as folder:
        assert names(folder) == []
    assert names(tmp_path) == [".file.txt.blocks"]


SAVER = """
import sys, time
import numpy as np, xarray as xr
from planar_pushing.terms.netcdf import write_dataset
from planar_pushing.terms.errors import InvalidFile
saved, refusals, start = 0, set(), time.monotonic()
while time.monotonic() < start + (0.7 if saved else 60.0):
    try:
        write_dataset(xr.Dataset({"a": ("x", np.full(20_000, float(sys.argv[1])))}), "o.nc")
        saved += 1
    except InvalidFile as error:
        refusals.add(str(error))
print(saved, *refusals, sep="|")
"""


def test_two_savers_never_show_a_reader_half_a_file(tmp_path):
    """Every read is one of the saved datasets; every refusal says that another process is writing."""
    write_dataset(xr.Dataset({"a": ("x", np.zeros(20_000))}), tmp_path / "o.nc")
    savers = [
        subprocess.Popen(
            [sys.executable, "-c", SAVER, number], cwd=tmp_path, stdout=subprocess.PIPE, text=True
        )
        for number in ("1", "2")
    ]
    seen = set()
    while any(each.poll() is None for each in savers):
        values = np.unique(read_dataset(tmp_path / "o.nc")["a"].values)
        assert len(values) == 1
        seen.update(values.tolist())
        time.sleep(0.002)
    for each in savers:
        saved, *refusals = each.communicate()[0].strip().split("|")
        assert int(saved) > 0
        assert set(refusals) <= {"o.nc: another process is writing it; name another file"}
    assert {1.0, 2.0} <= seen
    assert names(tmp_path) == ["o.nc"]
