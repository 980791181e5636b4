"""Run in a process of its own under NUMBA_DISABLE_JIT=1: counts of scenes and of a small study.

Arguments are a study file and the file that takes its dataset; the tallies of the scenes are printed.
"""

import json
import sys

import numpy as np

import planar_pushing as pp
from planar_pushing.evidence.costs.counted import counting
from planar_pushing.evidence.costs.effects import OPERATIONS, evaluations
from planar_pushing.study.store import write_dataset
from planar_pushing.study.study_file import load_study

FRICTION, INERTIA = pp.RingFriction(), pp.Inertia()
SETS = {
    "support_friction": (FRICTION,),
    "inertia": (INERTIA,),
    "support_friction+inertia": (FRICTION, INERTIA),
}
LAWS = [pp.Coulomb(2.0), pp.InfiniteFriction(), pp.InfiniteFriction("none"), pp.PerfectlyRough()]


def results(scene):
    cone = pp.motion_cone(scene)
    solved = [pp.solve(scene, np.deg2rad(angle)) for angle in (-10, 0, 90, 165, 180)]
    return [cone.right, cone.left, *([each.force.tolist() for each in found] for found in solved)]


def tallies():
    """Tally of each set of effects, law and computation, and whether counting changed no result."""
    for name, effects in SETS.items():
        for law in LAWS:
            slider = pp.Slider(rod_length=2.0, rod_angle=np.deg2rad(45))
            scene = pp.Scene(slider=slider, contact=law, effects=effects)
            with counting() as tally:
                found = results(scene)
            yield name, "results", tally, found == results(scene)
            for operation, run in OPERATIONS.items():
                with counting() as tally:
                    run(scene)
                yield name, operation, tally, True


study = load_study(sys.argv[1])
grid = study.grid.model_copy(update={"rod_length": (0.0, 2.0), "pusher_angle": (-10.0, 165.0)})
write_dataset(evaluations(study.model_copy(update={"grid": grid})), sys.argv[2])
print(json.dumps(list(tallies())))
