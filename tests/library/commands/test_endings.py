"""How a command ends that cannot go on: a full disk, Ctrl-C, a reader that has gone."""

import os
import resource
import signal
import subprocess
import sys
import time
from contextlib import contextmanager

import pytest
import xarray as xr

from signals import interruptible

SCENE = "workflow/scenes/pulling.yaml"
COMMAND = [sys.executable, "-m", "planar_pushing"]
#: A limit on the size of files stands for a full disk: every write beyond it fails.
SMALL = 8192


@contextmanager
def full_disk(limit=SMALL):
    """Let writes fail in this process, which may not leave the first part of Python's bytecode either."""
    before, written = resource.getrlimit(resource.RLIMIT_FSIZE), sys.dont_write_bytecode
    sys.dont_write_bytecode = True
    resource.setrlimit(resource.RLIMIT_FSIZE, (limit, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
        sys.dont_write_bytecode = written


@pytest.mark.parametrize(("command", "name"), [
    (["simulate", SCENE], "log.nc"),
    (["draw", SCENE], "scene.svg"),
    (["animate", "LOG", "--frames", "20"], "motion.gif"),
], ids=str)  # fmt: skip
def test_a_full_disk_is_one_line_and_leaves_no_file(run, log, tmp_path, command, name):
    path = tmp_path / name
    words = [str(log) if word == "LOG" else word for word in command]
    with full_disk():
        found = run(*words, "-o", str(path))
    said = f"planar-pushing {command[0]}: {path}: cannot be written (File too large); name another file"
    assert found == (2, "", said + "\n")
    assert not list(tmp_path.iterdir())


def test_a_full_disk_behind_the_output_is_one_line(tmp_path):
    command = [*COMMAND, "solve", SCENE, "--pusher-angle", "1", "--json"]
    environment = os.environ | {"PYTHONDONTWRITEBYTECODE": "1"}
    with (tmp_path / "out").open("w") as out, full_disk(64):
        found = subprocess.run(
            command, stdout=out, stderr=subprocess.PIPE, text=True, check=False, env=environment
        )
    assert (found.returncode, found.stderr) == (2, "planar-pushing: File too large\n")


@pytest.mark.parametrize("arguments", [
    ["--help"], ["completion", "bash"], ["solve", SCENE, "--pusher-angle", "1"],
], ids=str)  # fmt: skip
def test_a_reader_that_has_gone_ends_the_command_in_silence(arguments):
    buffered = {name: value for name, value in os.environ.items() if name != "PYTHONUNBUFFERED"}
    process = subprocess.Popen(
        [*COMMAND, *arguments],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=buffered,
    )
    process.stdout.close()
    said = process.stderr.read()
    process.stderr.close()
    assert (process.wait(), said) == (141, "")


def test_ctrl_c_in_a_destructor_ends_the_command_too():
    program = """
import sys, time
from planar_pushing import commands
class Dropped:
    def __del__(self):
        raise KeyboardInterrupt
def run(arguments):
    Dropped()
    time.sleep(60)
commands._run = run
sys.exit(commands.main())
"""
    found = subprocess.run(
        [sys.executable, "-c", program],
        stderr=subprocess.PIPE,
        text=True,
        check=False,
        preexec_fn=interruptible,
    )
    assert (found.returncode, found.stderr) == (130, "planar-pushing: interrupted\n")


def test_ctrl_c_is_one_line_and_leaves_what_was_logged(tmp_path):
    path = tmp_path / "log.nc"
    words = ["simulate", SCENE, "-o", str(path), "--samples", "3000000"]
    process = subprocess.Popen(
        [*COMMAND, *words], stderr=subprocess.PIPE, text=True, preexec_fn=interruptible
    )
    while not path.is_file() or path.stat().st_size < 200_000:
        assert process.poll() is None
        time.sleep(0.02)
    process.send_signal(signal.SIGINT)
    said = process.communicate()[1]
    assert (process.returncode, said) == (130, "planar-pushing: interrupted\n")
    with xr.open_dataset(path, engine="h5netcdf") as found:
        assert (found.attrs["finished"], found.sizes["time"] > 0) == (0, True)


def test_what_is_written_takes_the_place_of_what_is_there_whole_or_not_at_all(run, tmp_path):
    path = tmp_path / "scene.svg"
    path.write_text("old", encoding="utf-8")
    with full_disk():
        assert run("draw", SCENE, "-o", str(path))[0] == 2
    assert [each.name for each in tmp_path.iterdir()] == ["scene.svg"]
    assert path.read_text(encoding="utf-8") == "old"


def test_a_folder_is_no_file_to_write(refused, tmp_path):
    path = tmp_path / "scene.svg"
    path.mkdir()
    refused(["draw", SCENE, "-o", str(path)], f"{path}: cannot be written (Is a directory)")
