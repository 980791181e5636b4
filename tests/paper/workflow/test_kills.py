"""Commands and builds that are ended at random moments, by Ctrl-C, SIGTERM and a kill.

After each of them, nothing that is half written is read as whole, and afterwards a plain run ends with the
same files as one that nothing disturbed.
"""

import contextlib
import os
import random
import shutil
import signal
import subprocess
import sys
import time

import pytest
import xarray as xr
from core.building import hook, write
from workflow.conftest import PROJECT

from planar_pushing.terms.netcdf import read_dataset
from signals import interruptible

pytestmark = pytest.mark.alone

#: Seed of the moments, and their number; `KILLS=20 make test-all` tries more.
SEED, KILLS = 0, int(os.environ.get("KILLS", "3"))
COMMAND = [sys.executable, "-m", "planar_pushing"]
ENVIRONMENT = os.environ | {"PYTHONPATH": str(PROJECT / "src"), "PYTHONDONTWRITEBYTECODE": "1"}
SIGNALS = (signal.SIGKILL, signal.SIGTERM, signal.SIGINT)
CODES = {signal.SIGKILL: -signal.SIGKILL, signal.SIGTERM: 143, signal.SIGINT: 130}
#: Seconds after which a command that was sent a signal hangs, also on a machine that has other work.
HANGS = 60.0
#: A grid that is computed in blocks, and one in one piece.
STUDY = """title: Two rods
slider: {rod_angle: 45}
support_friction: {weight: 1}
grid:
  effects: [support_friction]
  rod_length: [1, 2]
  rod_angle: [45]
  friction_coefficient: [0.5, inf]
  contact_friction_coefficient: [0.5]
  pusher_magnitude: [1]
  pusher_angle: {start: -180, stop: 180, step: 0.01}
"""


def start(words, folder):
    return subprocess.Popen(
        words, cwd=folder, env=ENVIRONMENT, start_new_session=True, preexec_fn=interruptible,
        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
    )  # fmt: skip


def seconds_of(words, folder):
    begin = time.monotonic()
    with start(words, folder) as process:
        said = process.communicate()[1]
    assert process.returncode == 0, said
    return time.monotonic() - begin


def is_running(group):
    with contextlib.suppress(ProcessLookupError):
        os.killpg(group, 0)
        return True
    return False


def end(process, number, seconds, group=False):
    """Send a signal after so long, to a process or its group; its exit code, and what it said."""
    time.sleep(seconds)
    if process.poll() is None:
        (os.killpg if group else os.kill)(process.pid, number)
        begin = time.monotonic()
        said = process.communicate(timeout=HANGS)[1]
        while is_running(process.pid):
            assert time.monotonic() - begin < HANGS, "processes go on"
            time.sleep(0.05)
        return process.returncode, said
    return process.returncode, process.communicate()[1]


def hidden(folder):
    return [str(path) for path in folder.rglob(".*") if ".snakemake" not in str(path)]


def test_a_simulation(tmp_path):
    scene = str(PROJECT / "workflow/scenes/pulling.yaml")
    words = [*COMMAND, "simulate", scene, "--samples", "100000", "--no-progress", "-o", "log.nc"]
    seconds = seconds_of(words, tmp_path)
    whole = (tmp_path / "log.nc").read_bytes()
    moments = random.Random(SEED)
    for i in range(KILLS):
        (tmp_path / "log.nc").unlink(missing_ok=True)
        number = SIGNALS[i % 3]
        code, said = end(start(words, tmp_path), number, moments.uniform(0.2, 1.1) * seconds)
        # Before the command begins, Python itself ends at a signal.
        assert code in (0, CODES[number], -number), said
        if code == CODES[number] > 0:
            assert said.startswith("planar-pushing: ")
            assert not hidden(tmp_path)
        with contextlib.suppress(OSError), xr.open_dataset(tmp_path / "log.nc") as log:
            assert log.attrs["finished"] == ((tmp_path / "log.nc").read_bytes() == whole)
    seconds_of(words, tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["log.nc"]
    assert (tmp_path / "log.nc").read_bytes() == whole


def built(folder):
    """The datasets of the study, each of which is readable as a whole."""
    files = (folder / "results/studies/study").glob("data/*.nc")
    return {path.name: read_dataset(path) for path in sorted(files)}


def test_a_study(tmp_path):
    """SIGTERM is sent to the command alone, as `kill` does, and the others to all of its processes."""
    for name in ("undisturbed", "killed"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "study.yaml").write_text(STUDY, encoding="utf-8")
    words = [*COMMAND, "run", "study.yaml", "--cores", "2"]
    seconds = seconds_of(words, tmp_path / "undisturbed")
    whole = built(tmp_path / "undisturbed")
    assert "contact_modes.nc" in whole
    folder, moments = tmp_path / "killed", random.Random(SEED)
    for i in range(KILLS):
        number = SIGNALS[i % 3]
        is_alone = number == signal.SIGTERM
        code, said = end(
            start(words, folder), number, moments.uniform(0.1, 1.0) * seconds, group=not is_alone
        )
        assert code in (0, CODES[number], -number), said
        for name, dataset in built(folder).items():
            xr.testing.assert_identical(dataset, whole[name])
        if i % 7 == 6:
            shutil.rmtree(folder / "results", ignore_errors=True)
    seconds_of(words, folder)
    assert built(folder).keys() == whole.keys()
    for name, dataset in built(folder).items():
        xr.testing.assert_identical(dataset, whole[name])
    assert not hidden(folder)


BUILD = """
import sys
from pathlib import Path
from joiner import hook
sys.exit(hook.build(Path(sys.argv[1])) is None)
"""


def test_an_installation(tmp_path):
    """The compiler and all that waits for it; two at once; one whose compiler alone is killed."""
    folder, moments = write(tmp_path / "core"), random.Random(SEED)
    words = [sys.executable, "-c", BUILD, str(folder)]
    seconds = seconds_of(words, PROJECT)
    whole = (folder / hook.TARGET).read_bytes()
    for i in range(KILLS):
        (folder / hook.TARGET).unlink(missing_ok=True)
        pair = [start(words, PROJECT) for _ in range(1 + i % 2)]
        end(pair[0], signal.SIGKILL, moments.uniform(0.1, 1.0) * seconds, group=True)
        for other in pair[1:]:
            said = other.communicate()[1]
            assert other.returncode == 0, said
            assert (folder / hook.TARGET).exists()
        assert not (folder / hook.TARGET).exists() or (folder / hook.TARGET).read_bytes() == whole
    compiler = tmp_path / "compiler"
    compiler.write_text('#!/bin/sh\ncase "$*" in *--version*) exit 0;; esac\nkill -9 $$\n')
    compiler.chmod(0o755)
    failed = subprocess.run(
        words, cwd=PROJECT, env=ENVIRONMENT | {"CC": str(compiler)}, capture_output=True, text=True,
        check=False,
    )  # fmt: skip
    assert failed.returncode == 1
    assert failed.stderr.startswith("planar-pushing: the C compiler failed")
    assert not (folder / hook.TARGET).exists()
    seconds_of(words, PROJECT)
    assert (folder / hook.TARGET).read_bytes() == whole
    assert not [path for path in folder.iterdir() if path.name.startswith(".")]


LONG = """
import numpy as np, signal, sys, threading, time
import planar_pushing as pp
from planar_pushing.terms.signals import termination_as_interrupt
scene = pp.Scene(
    slider=pp.Slider(rod_length=2.0, rod_angle=1.0), contact=pp.Coulomb(0.5),
    effects=(pp.RingFriction(), pp.Inertia()),
)
pusher, speeds = pp.Pusher(velocity=(0.3, 1.0)), np.linspace(0.2, 2, 20_000)
calls = {{
    "solve": lambda: pp.solve(scene, np.linspace(0, 3, 5_000_000)),
    "simulate": lambda: pp.simulate(scene, pusher, duration=1.0, method="time-stepping", step=1e-9),
    "batch": lambda: pp.simulate_batch(
        scene, pp.Pusher(velocity=(speeds * 0.3, speeds)), duration=50.0
    ),
}}
sent = []
def send():
    sent.append(time.perf_counter())
    signal.raise_signal(signal.{number})
threading.Timer(1.0, send).start()
try:
    with termination_as_interrupt():
        calls["{call}"]()
except KeyboardInterrupt:
    print(time.perf_counter() - sent[0])
"""


@pytest.mark.parametrize("number", ["SIGINT", "SIGTERM"])
@pytest.mark.parametrize("call", ["solve", "simulate", "batch"])
def test_a_signal_ends_a_long_computation(call, number):
    done = subprocess.run(
        [sys.executable, "-c", LONG.format(call=call, number=number)], env=ENVIRONMENT,
        capture_output=True, text=True, check=False, preexec_fn=interruptible,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert float(done.stdout) < HANGS
