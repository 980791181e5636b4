"""The functions that machine code contains, seen from outside."""

import json
import os
import subprocess
import sys
from pathlib import Path

import numba
import pytest

from planar_pushing.simulation import machine_code
from planar_pushing.simulation.legacy.mass import Mass
from planar_pushing.simulation.legacy.own_ring import RingSupport
from planar_pushing.terms.options import EffectKind
from simulation.kernels import force

TESTS = Path(__file__).parents[1]
PACKAGE = Path(machine_code.__file__).parents[1]
pytestmark = pytest.mark.skipif(
    bool(numba.config.DISABLE_JIT), reason="the compiler is off: NUMBA_DISABLE_JIT is set"
)


def test_the_formulas_of_effects_are_in_modules_of_the_package():
    for modules in machine_code.FORMULAS.values():
        for module in modules:
            path = PACKAGE.parent.joinpath(*module.split(".")).with_suffix(".py")
            assert "@compiled\n" in path.read_text() or "@owning\n" in path.read_text()


def test_code_of_one_effect_would_show_in_that_of_another():
    """The same look at kernels that hold one effect each tells them apart."""
    kinds = {
        EffectKind.SUPPORT_FRICTION: RingSupport(1.0),
        EffectKind.INERTIA: Mass(1.0, 1.0, 0.0, 0.0),
    }
    for kind, effect in kinds.items():
        force((effect,), 1.0, 2.0, 3.0)
        (code,) = (each for each in force.overloads if type(effect).__name__ in str(each[0]))
        linked = machine_code.linked(force, code)
        assert any("10resistance" in name for name in linked)
        assert any("legacy4ring" in name for name in linked) == isinstance(effect, RingSupport)
        assert any("legacy4mass" in name for name in linked) == isinstance(effect, Mass)
        for other, modules in machine_code.FORMULAS.items():
            mangled = tuple(map(machine_code._mangled, modules))
            assert any(name.startswith(mangled) for name in linked) == (other == kind)


#: Counts functions of inertia's force in code that is new, and then from the cache.
TWICE = """
import json, sys
from pathlib import Path
from planar_pushing.simulation.legacy import compiled
compiled.CACHE = Path(sys.argv[1])
from planar_pushing.simulation.legacy.mass import Mass
from planar_pushing.simulation.machine_code import linked
from simulation.kernels import force
force((Mass(1.0, 1.0, 0.0, 0.0),), 1.0, 2.0, 3.0)
(code,) = force.overloads
print(json.dumps([sum(force.stats.cache_hits.values()), sorted(linked(force, code))]))
"""


def test_new_code_and_code_from_the_cache_hold_the_same_functions(tmp_path):
    paths = os.pathsep.join([str(PACKAGE.parent), str(TESTS)])
    (none, new), (one, cached) = (
        json.loads(
            subprocess.run(
                [sys.executable, "-c", TWICE, tmp_path], check=True, capture_output=True,
                text=True, env=os.environ | {"PYTHONPATH": paths},
            ).stdout
        )
        for _ in range(2)
    )  # fmt: skip
    assert (none, one) == (0, 1)
    assert new == cached
    assert new
