"""The mechanics need no numba, which only simulations import, and no compiler."""

import os
import subprocess
import sys

import numpy as np
import pytest

import planar_pushing as pp

PROGRAM = """
import sys

class Refuse:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in ("numba", "llvmlite"):
            raise ImportError(f"{name} is refused")

sys.meta_path.insert(0, Refuse())
import numpy as np
import planar_pushing as pp

box = pp.Polygon.rectangle(0.2, 0.1)
friction = pp.SupportFriction(support=box)
scene = pp.scene_at((0.02, -0.05), (0.0, 1.0), effects=[friction], contact=pp.Coulomb(0.3))
(solution,) = pp.solve(scene, np.pi / 2, derivatives=True)
pp.solve(scene, np.linspace(0, 3, 5))
pp.motion_cone(scene), pp.limit_curve(scene, 1.0), pp.motion_of_force(scene, 1.0)
pp.wrench(friction, (1.0, 0.0, 2.0))
print(solution.mode.name, repr(float(solution.twist[2])), solution.derivatives.status.name)
"""


@pytest.mark.parametrize("plain", ["0", "1"])
def test_the_public_mechanics_without_numba(plain):
    environment = os.environ | {"PLANAR_PUSHING_PLAIN": plain, "PYTHONWARNINGS": "error"}
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM],
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.stderr == ""
    friction = pp.SupportFriction(support=pp.Polygon.rectangle(0.2, 0.1))
    scene = pp.scene_at((0.02, -0.05), (0.0, 1.0), effects=[friction], contact=pp.Coulomb(0.3))
    (solution,) = pp.solve(scene, np.pi / 2)
    assert done.stdout.split() == ["STICK", repr(float(solution.twist[2])), "SMOOTH"]
