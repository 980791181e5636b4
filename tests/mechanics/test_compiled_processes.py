"""The core in new processes: what is compiled, and the formulas without the compiler."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import planar_pushing as pp
from mechanics.builders import EFFECT_SETS, make_scene, needs_compiler
from planar_pushing.mechanics.limit_curve import curve_of_unit_motions

SOURCES = Path(pp.__file__).parent
TESTS = Path(__file__).parents[1]
EPS = np.finfo(float).eps


def run(code, folder=SOURCES.parent, **environment):
    """What a process prints as JSON whose package is the one in a folder."""
    paths = os.pathsep.join([str(folder), str(TESTS)])
    found = subprocess.run(
        [sys.executable, "-W", "error", "-c", code], capture_output=True, text=True, check=False,
        env=os.environ | {"PYTHONPATH": paths} | environment,
    )  # fmt: skip
    assert found.returncode == 0, found.stderr
    return json.loads(found.stdout)


@pytest.fixture
def copy(tmp_path):
    """A copy of the package without anything compiled."""
    clean = shutil.ignore_patterns("__pycache__", "figures", "evidence", "report", "certified")
    shutil.copytree(SOURCES, tmp_path / SOURCES.name, ignore=clean)
    return tmp_path


# --- Only the effects that a scene calls for ---------------------------------------------------------

COMPILED = """
import json, numpy as np
import planar_pushing as pp
from mechanics.builders import make_scene
from planar_pushing.mechanics import solve, wrench

pp.solve(make_scene(2.0, 1.0, [pp.Inertia()]), 1.0)
pp.wrench(pp.RingFriction(), [1.0, 2.0, 3.0])
found = {}
for name, kernel in (("solve with inertia", solve._modes), ("wrench of friction", wrench._wrenches)):
    (signature,) = kernel.signatures
    code = kernel.inspect_llvm(signature)
    words = "supports4ring", "effects4ring", "llvm.log.f64", "unicode"
    found[name] = [word for word in words if word in code]
print(json.dumps(found))
"""


@pytest.mark.slow
@needs_compiler
def test_code_compiled_for_inertia_alone_holds_no_elliptic_integral(copy):
    """The second kernel shows that the names would be seen if they were there."""
    found = run(COMPILED, copy)
    assert found["solve with inertia"] == []
    assert {"supports4ring", "effects4ring"} <= set(found["wrench of friction"])
    # An array that is assigned to a slice compiles the formatting of numba's message for wrong shapes.
    assert "unicode" not in found["wrench of friction"]


COUNTED = """
import json
from collections import Counter
import numpy as np
import planar_pushing as pp
from mechanics.builders import EFFECT_SETS, make_scene
from planar_pushing.mechanics.effects import base
from planar_pushing.mechanics.limit_curve import curve_of_unit_motions
from planar_pushing.mechanics.supports import ring

calls = Counter()

def counted(name, function):
    def wrapped(*given):
        calls[name] += 1
        return function(*given)
    return wrapped

for module in set(base.KINDS.values()):
    name = module.__name__.rpartition(".")[2]
    module.resistance = counted(name, module.resistance)
ring.inner = counted("curves", ring.inner)
found = {}
square = pp.SupportFriction(support=pp.Polygon([(-1, -1), (1, -1), (1, 1), (-1, 1)]))
others = {"square": (square,), "square and inertia": (square, pp.Inertia())}
for name, effects in (EFFECT_SETS | others).items():
    calls.clear()
    scene = make_scene(2.0, 1.4, effects)
    given = {"both": {"inertia_share": 0.5}, "square and inertia": {"force_ratio": 2.0}}.get(name, {})
    for angle in (-0.2, 0.3, 1.0, 2.9):
        pp.solve(scene, angle)
        pp.spin_ratio(scene, angle, **given)
        curve_of_unit_motions(scene, angle)
        pp.motion_centers(scene, angle, **given)
    pp.motion_cone(scene)
    found[name] = calls.copy()
print(json.dumps(found))
"""


def test_an_absent_effect_is_not_evaluated():
    found = run(COUNTED, NUMBA_DISABLE_JIT="1")
    assert set(found["friction"]) == {"ring", "curves"}
    assert set(found["inertia"]) == {"inertia"}
    assert set(found["both"]) == {"ring", "inertia", "curves"}
    assert set(found["square"]) == {"any_support"}
    assert set(found["square and inertia"]) == {"any_support", "inertia"}
    assert all(count > 0 for counts in found.values() for count in counts.values())


# --- With and without the compiler -------------------------------------------------------------------

#: Tests of the formulas, in parts that can run beside one another; the others test what surrounds them.
FORMULAS = {
    "effects": ("supports/test_ring.py", "numerics", "test_plane.py", "test_wrench.py"),
    "cones": ("test_cones.py", "test_limit_curve.py", "test_centers.py"),
    "modes": ("test_modes.py", "test_modes_limits.py", "test_modes_hard.py"),
    "solve": ("test_solve.py", "test_solve_backward_error.py", "test_solve_arrays.py"),
}


@pytest.mark.slow
@needs_compiler
@pytest.mark.parametrize("part", FORMULAS)
def test_the_tests_of_the_mechanics_pass_without_the_compiler(part):
    files = [str(TESTS / "mechanics" / name) for name in FORMULAS[part]]
    found = subprocess.run(
        [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", *files],
        capture_output=True, text=True, check=False, cwd=TESTS.parent,
        env=os.environ | {"NUMBA_DISABLE_JIT": "1", "PYTHONPATH": str(SOURCES.parent)},
    )  # fmt: skip
    assert found.returncode == 0, found.stdout[-3000:]


def sample():
    """Numbers of each function at generic scenes, relative to their own size."""
    random = np.random.default_rng(2)
    length, psi = 10 ** random.uniform(-2, 2, 40), random.uniform(0.1, 3.0, 40)
    mu, angle = 10 ** random.uniform(-1, 1, 40), random.uniform(-3.0, 3.0, 40)
    found = {}
    for name, effects in EFFECT_SETS.items():
        scene, share = (
            make_scene(length, pp.Coulomb(mu), effects, psi),
            0.3 if name == "both" else None,
        )
        cone, curve = pp.motion_cone(scene), curve_of_unit_motions(scene, angle)
        solved = pp.solve(scene, angle, 1.3)
        found[name] = {
            "cone": np.array([cone.right, cone.left]),
            "curve": np.array([curve.magnitude, curve.spin_ratio, curve.motion_angle]),
            "spin ratio": pp.spin_ratio(scene, angle, share),
            "mode": solved.mode,
            "twist": solved.twist,
            "force": solved.force,
        }
    return found


SAMPLED = """
import json
from mechanics.test_compiled_processes import sample
print(json.dumps({
    name: {key: value.tolist() for key, value in each.items()} for name, each in sample().items()
}))
"""


@needs_compiler
def test_both_modes_give_the_same_numbers_to_a_few_ulp():
    python = run(SAMPLED, NUMBA_DISABLE_JIT="1")
    for name, each in sample().items():
        assert np.array_equal(each.pop("mode"), python[name]["mode"])
        for key, value in each.items():
            np.testing.assert_allclose(value, python[name][key], rtol=16 * EPS, atol=8 * EPS)
