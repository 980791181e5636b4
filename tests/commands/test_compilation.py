"""The command `compile`: what it covers, and how it ends."""

from __future__ import annotations

import signal
import subprocess
import sys
import time
from pathlib import Path

import numba
import pytest

from planar_pushing.simulation import machine_code
from signals import interruptible

pytestmark = pytest.mark.skipif(
    bool(numba.config.DISABLE_JIT), reason="the compiler is off: NUMBA_DISABLE_JIT is set"
)
COMMAND = [sys.executable, "-m", "planar_pushing.commands"]
SCENES = Path("workflow/scenes").resolve()
FOLLOWED = (
    "box",
    "plate",
    "stool",
    "tripod",
    "figure_14a",
    "figure_15",
    "impact",
    "pulling_with_inertia",
)
EXAMPLES = [
    *(["simulate", f"{SCENES}/{name}.yaml", "-o", "a.nc"] for name in FOLLOWED),
    *(
        ["simulate", f"{SCENES}/{name}.yaml", "-o", "a.nc", "--pusher-shape", "finger"]
        for name in ("box", "plate", "stool", "tripod")
    ),
]  # fmt: skip


def compiled_files():
    """Names of the files of machine code, to which no other process may add."""
    return {path.name for path in machine_code.folder().rglob("*.nbc")}


@pytest.mark.alone
def test_the_examples_compile_nothing_after_compile(tmp_path):
    subprocess.run([*COMMAND, "compile"], check=True, capture_output=True)
    before = compiled_files()
    for arguments in EXAMPLES:
        found = subprocess.run(
            [*COMMAND, *arguments], check=True, cwd=tmp_path, capture_output=True, text=True
        )
        assert compiled_files() == before, arguments
        assert "compiling" not in found.stderr


def at_work(parent):
    """Processes of a process that have loaded the compiler."""
    children = Path(f"/proc/{parent}/task/{parent}/children").read_text().split()
    return [each for each in children if "llvmlite" in Path(f"/proc/{each}/maps").read_text()]


@pytest.mark.skipif(not Path("/proc").is_dir(), reason="processes are found in /proc")
@pytest.mark.parametrize(("number", "status"), [(signal.SIGTERM, 143), (signal.SIGINT, 130)])
def test_ctrl_c_and_a_termination_end_compile_with_its_processes(number, status):
    running = subprocess.Popen(
        [*COMMAND, "compile"],
        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, preexec_fn=interruptible,
    )  # fmt: skip
    while len(at_work(running.pid)) < 2:
        assert running.poll() is None
        time.sleep(0.05)
    children = at_work(running.pid)
    running.send_signal(number)
    _, said = running.communicate(timeout=60)
    assert running.returncode == status, said
    assert b"Traceback" not in said
    assert b"leaked" not in said
    assert not any(Path(f"/proc/{child}").exists() for child in children)
