"""Compiled functions in new processes: what they contain, what is cached, and what is announced."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import numba
import pytest

import planar_pushing as pp

PACKAGE = Path(pp.__file__).parent
TESTS = Path(__file__).parents[1]
pytestmark = pytest.mark.skipif(
    bool(numba.config.DISABLE_JIT), reason="the compiler is off: NUMBA_DISABLE_JIT is set"
)


def run(code, folder):
    """What a process prints as JSON whose package is the one in a folder."""
    paths = os.pathsep.join([str(folder), str(TESTS)])
    found = subprocess.run(
        [sys.executable, "-W", "error", "-c", code], capture_output=True, text=True, check=False,
        env=os.environ | {"PYTHONPATH": paths},
    )  # fmt: skip
    assert found.returncode == 0, found.stderr
    return json.loads(found.stdout)


@pytest.fixture
def copy(tmp_path):
    """A copy of the package without anything compiled."""
    clean = shutil.ignore_patterns("__pycache__", "figures", "evidence", "report", "certified")
    shutil.copytree(PACKAGE, tmp_path / PACKAGE.name, ignore=clean)
    return tmp_path


COMPILED = """
import json
import planar_pushing as pp
from mechanics.builders import make_scene
from planar_pushing.simulation.events import driver

found = {}
pp.simulate(
    make_scene(2.0, 1.0, [pp.Inertia()]), pusher=pp.Pusher(velocity=(0.0, 1.0)), duration=1e-3
)
(signature,) = driver.advance.signatures
code = driver.advance.inspect_llvm(signature)
words = "legacy4ring", "own_ring", "any_support", "unicode", "legacy4mass"
print(json.dumps([word for word in words if word in code]))
"""


@pytest.mark.slow
def test_code_compiled_for_inertia_alone_holds_no_friction(copy):
    # An array that is assigned to a slice compiles the formatting of numba's message for wrong shapes.
    assert run(COMPILED, copy) == ["legacy4mass"]


FORCE = """
import json
from planar_pushing.simulation.legacy.own_ring import RingSupport
from simulation.kernels import force

found = force((RingSupport(1.0),), 1.0, 0.0, 0.5)
print(json.dumps([found, sum(force.stats.cache_hits.values())]))
"""


def test_a_changed_callee_leaves_no_stale_code(copy):
    """Numba's cache looks at the caller's file alone, which stays as it is."""
    found, hits = run(FORCE, copy)
    assert (found, hits) == (pytest.approx(0.934215457667694, rel=1e-14, abs=0), 0)
    assert run(FORCE, copy) == [found, 1]
    callee = copy / PACKAGE.name / "simulation/legacy/own_ring.py"
    text = callee.read_text()
    changed = text.replace("weight * across * x,", "2.0 * (weight * across * x),")
    assert changed != text
    callee.write_text(changed)
    assert run(FORCE, copy) == [2.0 * found, 0]


FRESH = """
import sys
from pathlib import Path
from planar_pushing.simulation.legacy import compiled as core

core.CACHE = Path(sys.argv[1])
sys.path.append("tests")
"""
RESIST = """
core.SLOW["simulation.kernels.force"] = "force", 1
from planar_pushing.simulation.legacy.own_ring import RingSupport
from simulation.kernels import force

force((RingSupport(1.0),), 1.0, 0.0, 0.5)
force((RingSupport(1.0),), 2.0, 0.0, 0.5)
"""
SIMULATE = """
from planar_pushing.commands import main
from planar_pushing.simulation.events import driver

index = Path(driver.advance._cache._cache_file._index_path)
index.parent.mkdir(parents=True)
index.touch()
scene, log = "workflow/scenes/figure_14a.yaml", str(core.CACHE / "log.nc")
sys.exit(main(["simulate", scene, "-o", log]))
"""


def run_fresh(code, folder):
    """A process whose cache is in a folder."""
    return subprocess.run(
        [sys.executable, "-W", "error", "-c", FRESH + code, folder], capture_output=True, text=True,
        check=False, cwd=TESTS.parent,
    )  # fmt: skip


@pytest.fixture(scope="module")
def filled(tmp_path_factory):
    """A cache that a process has filled, and what that process said."""
    folder = tmp_path_factory.mktemp("filled")
    return folder, run_fresh(RESIST, folder).stderr


def test_a_long_compilation_is_announced_once(filled):
    folder, said = filled
    assert said == "compiling force for this kind of slider, once; this takes about 1 s\n"
    assert run_fresh(RESIST, folder).stderr == ""


@pytest.mark.parametrize("suffix", ["nbi", "nbc"])
def test_a_truncated_cache_is_named(filled, tmp_path, suffix):
    folder = shutil.copytree(filled[0], tmp_path / "cache")
    for path in folder.rglob(f"*.{suffix}"):
        path.write_bytes(path.read_bytes()[:20])
    found = run_fresh(RESIST, folder)
    assert found.stderr.endswith(f"OSError: {folder}: damaged compiled code; remove this folder\n")


def test_the_command_line_names_a_damaged_cache_in_a_line(tmp_path):
    found = run_fresh(SIMULATE, tmp_path)
    assert found.returncode == 2
    assert (
        found.stderr == f"planar-pushing: {tmp_path}: damaged compiled code; remove this folder\n"
    )
