"""How a command ends that cannot go on: a full disk, Ctrl-C, a reader that has gone."""

import os
import resource
import signal
import subprocess
import sys
import time
from contextlib import contextmanager

import h5py
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


#: By signal: exit code, message, and what it raises.
SIGNALS = {
    signal.SIGINT: (130, "planar-pushing: interrupted\n", "KeyboardInterrupt"),
    signal.SIGTERM: (143, "planar-pushing: terminated\n", "Termination"),
}


@pytest.mark.parametrize("number", SIGNALS)
def test_ctrl_c_in_a_destructor_ends_the_command_too(number):
    code, message, raised = SIGNALS[number]
    program = f"""
import sys, time
from planar_pushing import commands
from planar_pushing.terms.signals import Termination
class Dropped:
    def __del__(self):
        raise {raised}
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
    assert (found.returncode, found.stderr) == (code, message)


@pytest.mark.parametrize("number", SIGNALS)
def test_ctrl_c_is_one_line_and_leaves_what_was_logged(tmp_path, number):
    path = tmp_path / "log.nc"
    words = ["simulate", SCENE, "-o", str(path), "--samples", "3000000"]
    process = subprocess.Popen(
        [*COMMAND, *words], stderr=subprocess.PIPE, text=True, preexec_fn=interruptible
    )
    while not path.is_file() or path.stat().st_size < 200_000:
        assert process.poll() is None
        time.sleep(0.02)
    process.send_signal(number)
    said = process.communicate()[1]
    assert (process.returncode, said) == SIGNALS[number][:2]
    assert [each.name for each in tmp_path.iterdir()] == ["log.nc"]
    with xr.open_dataset(path, engine="h5netcdf") as found:
        assert (found.attrs["finished"], found.sizes["time"] > 0) == (0, True)


def test_sigterm_that_is_ignored_stays_so(run, monkeypatch):
    before = signal.signal(signal.SIGTERM, signal.SIG_IGN)
    try:
        assert run("completion", "bash")[0] == 0
        assert signal.getsignal(signal.SIGTERM) is signal.SIG_IGN
    finally:
        signal.signal(signal.SIGTERM, before)


#: Commands, their exit codes, and the streams that are closed in every test run; the others are slow.
ENDINGS = [
    (["--version"], 0, [(0, 1, 2)]),
    (["solve", SCENE, "--pusher-angle", "90", "--json"], 0, [(1,), (2,), (0, 1, 2)]),
    (["solve", "nowhere.yaml"], 2, [(1,), (2,)]),
    (["solve"], 2, [(2,), (0, 1, 2)]),
    (["simulate", SCENE, "-o", "LOG"], 0, [(0, 1, 2)]),
]


@pytest.mark.parametrize(("arguments", "code", "closed"), [
    pytest.param(arguments, code, closed, marks=() if closed in fast else pytest.mark.slow)
    for arguments, code, fast in ENDINGS for closed in [(1,), (2,), (0, 1, 2)]
], ids=str)  # fmt: skip
def test_closed_streams_change_no_exit_code_and_no_file(tmp_path, arguments, code, closed):
    """What is printed goes nowhere, and not to a file that is opened in the place of the stream."""
    path = tmp_path / "log.nc"
    words = [str(path) if word == "LOG" else word for word in arguments]
    found = subprocess.run(
        [*COMMAND, *words], capture_output=True, text=True, check=False,
        preexec_fn=lambda: [os.close(number) for number in closed],
    )  # fmt: skip
    assert found.returncode == code
    assert "Traceback" not in found.stdout + found.stderr
    if 2 in closed:
        assert "planar-pushing: " not in found.stdout
    if "LOG" in arguments:
        with h5py.File(path) as log:
            assert log.attrs["finished"] == 1


def test_what_is_written_takes_the_place_of_what_is_there_whole_or_not_at_all(run, tmp_path):
    path = tmp_path / "scene.svg"
    path.write_text("old", encoding="utf-8")
    with full_disk():
        assert run("draw", SCENE, "-o", str(path))[0] == 2
    assert [each.name for each in tmp_path.iterdir()] == ["scene.svg"]
    assert path.read_text(encoding="utf-8") == "old"


def test_the_file_behind_a_link_is_written(run, tmp_path):
    path = tmp_path / "scene.svg"
    path.symlink_to("real.svg")
    assert run("draw", SCENE, "-o", str(path))[0] == 0
    assert path.is_symlink()
    assert (tmp_path / "real.svg").read_text(encoding="utf-8").startswith("<?xml")


@pytest.mark.parametrize("command", [
    ["simulate", SCENE], ["draw", SCENE], ["animate", "log.nc"], ["assess", SCENE],
    ["convert", "csv", "box.csv"], ["identify", "pushes.nc"],
], ids=str)  # fmt: skip
def test_a_device_is_refused_before_any_work(refused, tmp_path, command):
    path = tmp_path / "device"
    path.symlink_to(os.devnull)
    refused([*command, "-o", str(path)], f"{path}: cannot be written (Is a device); name another")
    assert path.is_char_device()


def test_a_folder_is_no_file_to_write(refused, tmp_path):
    path = tmp_path / "scene.svg"
    path.mkdir()
    refused(["draw", SCENE, "-o", str(path)], f"{path}: cannot be written (Is a directory)")
