"""The mechanics need no numba, compiled or as plain Python; simulations still do, and say so."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import planar_pushing as pp

SOURCES = Path(pp.__file__).parents[1]
BLOCKED = """
import sys

class Blocked:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in ("numba", "llvmlite"):
            raise ModuleNotFoundError(f"No module named {name!r}", name=name)

sys.meta_path.insert(0, Blocked())
import numpy as np
import planar_pushing as pp

square = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
slider = pp.Slider(rod_length=2.0, rod_angle=1.0, radius=1.5)
friction, feet = pp.RingFriction(), pp.SupportFriction(support=pp.Points(square))
scenes = [
    pp.Scene(slider=slider, contact=pp.Coulomb(0.5), effects=effects)
    for effects in ((friction,), (feet, pp.Inertia()), (feet, pp.Load(force=(0.1, -0.2))))
]
"""
MECHANICS = """
for scene in scenes:
    print(pp.solve(scene, 1.0).to_json())
    print(pp.solve(scene, [0.1, 1.0, 3.0], derivatives=True).derivatives.twist_by_point.tolist())
    cone = pp.motion_cone(scene)
    print(cone.right, cone.left, pp.can_pull(scene), pp.slips_while_pushing(scene))
    more = (2.0,) if scene is scenes[1] else ()
    print(pp.motion_of_force(scene, [0.5, 2.5], *more).twist.tolist())
print(pp.limit_curve(scenes[0], np.linspace(0, 3, 5)).magnitude.tolist())
print(pp.motion_centers(scenes[0], 1.0).tolist(), pp.spin_ratio(scenes[0], 1.0))
print(pp.wrench(feet, [0.1, 0.2, 0.3]).tolist(), pp.potential(friction, [0.1, 0.2, 0.3]))
plate = (pp.SupportFriction(support=pp.Polygon(square)),)
plate = pp.scene_at((0.3, -1.0), outline=square, contact=pp.Coulomb(0.4), effects=plate)
print(pp.solve(plate, 1.2).to_json())
print([name for name in sys.modules if name.partition(".")[0] in ("numba", "llvmlite")])
"""
SIMULATION = """
try:
    pp.simulate(scenes[0], pp.Pusher(velocity=(0.0, 1.0)), duration=1.0)
except ModuleNotFoundError as error:
    print(error.name)
"""


def run(code, **environment):
    ran = subprocess.run(
        [sys.executable, "-W", "error", "-c", BLOCKED + code], capture_output=True, text=True,
        check=False, env=os.environ | {"PYTHONPATH": str(SOURCES)} | environment,
    )  # fmt: skip
    assert ran.returncode == 0, ran.stderr
    return ran.stdout.splitlines()


def test_the_mechanics_work_without_numba():
    compiled = run(MECHANICS)
    assert compiled[-1] == "[]"
    assert run(MECHANICS, PLANAR_PUSHING_PLAIN="1") == compiled


def test_a_simulation_names_what_it_lacks():
    assert run(SIMULATION)[0] in ("numba", "llvmlite")
