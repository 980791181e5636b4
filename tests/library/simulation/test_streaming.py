"""Logs that are streamed to a file: killed and interrupted runs, full disks, other writers and readers."""

from __future__ import annotations

import gc
import re
import resource
import signal
import subprocess
import sys
import threading
import time
from contextlib import contextmanager

import numpy as np
import pytest
import xarray as xr
from mechanics.builders import make_scene
from simulation.runs import final, heading, run

import planar_pushing as pp
from planar_pushing.simulation.storage.disk import block_interrupts
from planar_pushing.terms.netcdf import write_dataset
from planar_pushing.terms.quantities import unit_of
from planar_pushing.terms.replacing import replacing
from planar_pushing.terms.signals import Termination, termination_as_interrupt
from signals import interruptible, uninterruptible

SCENE, FENCE = make_scene(2, 0.5), [(0, heading(60)), (0.5, heading(100))]
BUSY = "another process is writing it; name another file"
#: Instants of a log that is written in several blocks.
ROWS = 1500


def streamed(path, samples=ROWS, **options):
    return run(SCENE, FENCE, 1, path=path, samples=samples, **options)


def once_written(path, act, size=50_000):
    """A condition that never holds; it acts once, when so many bytes of a file are written."""
    done = []

    def until(_):
        if not done and path.exists() and path.stat().st_size > size:
            done.append(True)
            act()
        return False

    return until


def test_the_same_run_writes_the_same_bytes(tmp_path):
    for name in ("a.nc", "new/b.nc"):
        streamed(tmp_path / name, 101).close()
    assert (tmp_path / "a.nc").read_bytes() == (tmp_path / "new" / "b.nc").read_bytes()


def test_a_file_grows_while_the_run_goes_on(tmp_path):
    """Memory holds a part of the log only."""
    path, sizes = tmp_path / "log.nc", set()

    def until(_):
        sizes.add(path.stat().st_size)
        return False

    streamed(path, until=until).close()
    assert len(sizes) > 4


def require_part(path):
    """The file is the log of a run that has not ended, up to a time."""
    with xr.open_dataset(path, engine="h5netcdf") as log:
        assert log.attrs["finished"] == 0
        assert 100 < log.sizes["time"] < ROWS
        assert np.isfinite(log.rod_angle).all()
        assert log.rod_angle[0] == pytest.approx(45)
        assert (np.diff(log.time) >= 0).all()
        assert unit_of(log.force.attrs) == "force"


KILLED = """
import os, signal
from pathlib import Path
from simulation.test_streaming import once_written, streamed
path = Path("log.nc")
streamed(path, until=once_written(path, lambda: os.kill(os.getpid(), signal.SIGKILL)))
"""


def test_a_killed_run_leaves_a_readable_log(tmp_path):
    ended = subprocess.run(
        [sys.executable, "-c", f"import sys; sys.path[:0] = {sys.path!r}\n" + KILLED],
        cwd=tmp_path, check=False, capture_output=True, text=True,
    )  # fmt: skip
    assert ended.returncode == -9, ended.stderr
    require_part(tmp_path / "log.nc")


def test_another_process_reads_while_it_is_written(tmp_path):
    path = tmp_path / "log.nc"
    reads = "import h5py, sys; print(len(h5py.File(sys.argv[1])['time'][:]))"
    found = []

    def read():
        found.append(
            subprocess.run(
                [sys.executable, "-c", reads, path], capture_output=True, text=True, check=True
            )
        )

    streamed(path, until=once_written(path, read)).close()
    assert 0 < int(found[0].stdout) < ROWS


# --- Ctrl-C --------------------------------------------------------------------------------------


@pytest.fixture
def heard(monkeypatch):
    """Ctrl-C is an exception, also where Python drops it: in a destructor it comes again a moment later."""

    def repeat(dropped, former=sys.unraisablehook):
        if issubclass(dropped.exc_type, KeyboardInterrupt):
            threading.Timer(0.01, signal.raise_signal, [signal.SIGINT]).start()
        else:
            former(dropped)

    monkeypatch.setattr(sys, "unraisablehook", repeat)
    before = signal.getsignal(signal.SIGINT)
    interruptible()
    yield
    signal.signal(signal.SIGINT, before)


def test_ctrl_c_leaves_a_readable_log(tmp_path, heard):
    path = tmp_path / "log.nc"
    with pytest.raises(KeyboardInterrupt):
        streamed(path, until=once_written(path, lambda: signal.raise_signal(signal.SIGINT)))
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    require_part(path)
    with streamed(path, 11) as log:
        assert log.attrs["finished"] == 1


def stream_forever(path, timer):
    timer.start()  # a timer of no time can interrupt its own start
    while True:
        streamed(path).close()


# Interrupted while it opens or closes a file, xarray complains when its object is destroyed.
@pytest.mark.filterwarnings(
    "ignore:Exception ignored in.*CachingFileManager:pytest.PytestUnraisableExceptionWarning"
)
def test_ctrl_c_at_any_time_leaves_a_log_or_none(tmp_path, heard):
    """It comes from a timer, also while the file is written."""
    for i in range(4):
        path = tmp_path / f"{i}.nc"
        timer = threading.Timer(0.04 * i, signal.raise_signal, [signal.SIGINT])
        with pytest.raises(KeyboardInterrupt):
            stream_forever(path, timer)
        timer.join()
        if path.exists() and path.stat().st_size:
            with xr.open_dataset(path, engine="h5netcdf") as log:
                assert log.attrs["finished"] in (0, 1)
    assert gc.isenabled()


def test_sigterm_leaves_a_readable_log(tmp_path):
    """Where it is an exception, as in a command; it comes while the file is written, too."""
    path = tmp_path / "log.nc"
    with pytest.raises(Termination), termination_as_interrupt():
        streamed(path, until=once_written(path, lambda: signal.raise_signal(signal.SIGTERM)))
    assert signal.getsignal(signal.SIGTERM) is signal.SIG_DFL
    require_part(path)


def test_sigterm_waits_for_the_end_of_a_write():
    steps = []

    def write():
        with block_interrupts():
            signal.raise_signal(signal.SIGTERM)
            steps.append("written")
        steps.append("never reached")

    with pytest.raises(Termination), termination_as_interrupt():
        write()
    assert steps == ["written"]


def test_ctrl_c_that_is_ignored_stays_so(tmp_path, heard):
    uninterruptible()
    path = tmp_path / "log.nc"
    act = once_written(path, lambda: signal.raise_signal(signal.SIGINT))
    with streamed(path, until=act) as log:
        assert log.attrs["finished"] == 1
    assert signal.getsignal(signal.SIGINT) is signal.SIG_IGN


def test_ctrl_c_ends_a_run_of_a_billion_steps(heard):
    timer = threading.Timer(0.3, signal.raise_signal, [signal.SIGINT])
    start = time.perf_counter()
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        run(SCENE, FENCE, 1, method="time-stepping", step=1e-9)
    assert time.perf_counter() - start < 10


def test_runs_in_threads_write_their_logs(tmp_path):
    """Threads receive no signals, and share the pause of the collection of garbage."""
    wanted = run(SCENE, FENCE, 1, samples=ROWS)
    paths = [tmp_path / f"{i}.nc" for i in range(2)]
    threads = [threading.Thread(target=lambda p=p: streamed(p).close()) for p in paths]
    before = signal.getsignal(signal.SIGINT)
    for each in threads:
        each.start()
    for each in threads:
        each.join()
    assert signal.getsignal(signal.SIGINT) is before
    assert gc.isenabled()
    for path in paths:
        with xr.open_dataset(path, engine="h5netcdf") as log:
            xr.testing.assert_equal(log.load(), wanted)


@pytest.mark.parametrize("enabled", [True, False])
def test_garbage_is_collected_afterwards_as_before(tmp_path, enabled):
    """HDF5 crashes where objects are destroyed while it calls the file."""
    before = gc.get_threshold()
    gc.set_threshold(1)
    try:
        if not enabled:
            gc.disable()
        streamed(tmp_path / "log.nc", 300).close()
        assert gc.isenabled() == enabled
    finally:
        gc.enable()
        gc.set_threshold(*before)


# --- The disk ------------------------------------------------------------------------------------


@contextmanager
def room(size):
    """A limit on the size of files, which stands for a full disk: every write beyond it fails."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


def test_a_full_disk_is_an_error_that_names_the_file_and_leaves_none(tmp_path):
    """Wherever it fills up: in the header, between two flushes, at the end."""
    path = tmp_path / "log.nc"
    streamed(path, 800).close()
    whole = path.stat().st_size
    path.unlink()
    said = r"log\.nc: cannot be written \(File too large\); name another file"
    for size in (0, 100, *np.linspace(1000, whole - 1, 5).astype(int).tolist()):
        with pytest.raises(pp.InvalidFile, match=said), room(size):
            streamed(path, 800)
        assert not list(tmp_path.iterdir())
    with room(whole), streamed(path, 800) as log:
        assert log.attrs["finished"] == 1


def test_an_error_of_the_run_is_not_taken_for_one_of_the_disk(tmp_path):
    def until(now):
        if now["time"] > 0.5:
            raise OSError("another file")
        return False

    with pytest.raises(OSError, match="another file"):
        streamed(tmp_path / "log.nc", until=until)


def test_a_file_that_cannot_be_written(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(pp.InvalidFile, match="cannot be written"):
        streamed(tmp_path / "file" / "log.nc")


# --- Several writers -----------------------------------------------------------------------------


def test_two_runs_do_not_write_one_log(tmp_path):
    """The second run, started while the first is writing, is refused; the first one is complete."""
    path, link, refusals = tmp_path / "log.nc", tmp_path / "link.nc", []
    link.symlink_to(path)

    def refused(write, *names):
        for name in names:
            with pytest.raises(pp.InvalidFile) as caught:
                write(name)
            refusals.append((name, str(caught.value)))

    def begin():
        refused(streamed, path, link)
        thread = threading.Thread(target=refused, args=(streamed, path))
        thread.start()
        thread.join()
        refused(lambda name: write_dataset(wanted, name), path)

    wanted = run(SCENE, FENCE, 1, samples=ROWS)
    streamed(path, 11).close()
    with streamed(path, until=once_written(path, begin)) as log:
        xr.testing.assert_equal(log.load(), wanted)
    assert refusals == [(name, f"{name}: {BUSY}") for name in (path, link, path, path)]
    streamed(link, 21).close()
    assert link.is_symlink()
    with xr.open_dataset(path, engine="h5netcdf") as log:
        assert log.sizes["time"] < 100
    assert sorted(each.name for each in tmp_path.iterdir()) == ["link.nc", "log.nc"]


def test_a_log_is_not_written_where_a_dataset_is(tmp_path):
    path = tmp_path / "file.nc"
    with replacing(path), pytest.raises(pp.InvalidFile, match=re.escape(BUSY)):
        streamed(path)
    assert not path.exists() or path.stat().st_size == 0


def test_a_link_in_the_place_of_the_lock_is_not_followed(tmp_path):
    victim = tmp_path / "victim"
    victim.write_text("keep")
    (tmp_path / ".log.nc.lock").symlink_to(victim)
    streamed(tmp_path / "log.nc", 11).close()
    assert victim.read_text() == "keep"
    assert sorted(each.name for each in tmp_path.iterdir()) == ["log.nc", "victim"]


def test_progress_is_shown_on_demand(capsys):
    run(SCENE, FENCE, 1, progress=True)
    assert "time" in capsys.readouterr().err
    run(SCENE, FENCE, 1)
    assert capsys.readouterr().err == ""
    assert final(run(SCENE, FENCE, 1), "time") == 1
