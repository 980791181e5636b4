"""Cost of the effects that a scene lists: in machine code, in the logs of motion over time, and in time.

The compiler generates machine code of the simulations for each list of effects, and a log counts the
evaluations of each effect that its scene lists.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.evidence.costs.times import seconds, stamped
from planar_pushing.mechanics.cones import motion_cone
from planar_pushing.mechanics.contact import Coulomb
from planar_pushing.mechanics.limit_curve import curve_of_unit_motions
from planar_pushing.mechanics.plane import direction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.solve import solve
from planar_pushing.simulation import machine_code
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.simulation.simulate import simulate
from planar_pushing.study.build import build_dataset
from planar_pushing.study.describe import describe
from planar_pushing.study.files.scenes import load_scene_file
from planar_pushing.study.files.study_model import StudyFile
from planar_pushing.study.slices import study_slice
from planar_pushing.terms.options import EFFECT_CLASSES, STUDIED, Method
from planar_pushing.terms.quantities import EVALUATIONS

#: A push, and the duration and the number of steps of its simulation.
FRICTION_COEFFICIENT, PUSHER_ANGLE = 2.0, np.deg2rad(-10.0)
DURATION, STEPS = 1.0, 100
FORCE_ANGLES = np.deg2rad(np.arange(361.0))
#: Timed operations on a scene: the cone, a curve of 361 points, and every mode of one push.
OPERATIONS: dict[str, Callable[[Scene], object]] = {
    "motion_cone": motion_cone,
    "limit_curve": lambda scene: curve_of_unit_motions(scene, FORCE_ANGLES),
    "solve": lambda scene: solve(scene, PUSHER_ANGLE),
}
#: Timed datasets of a study.
TIMED = ("limit_curves", "motion_cones", "contact_modes")
REPEATS = 7


def one_slider(study: StudyFile, effects: Any) -> Scene:
    """The study's slider with its longest rod, under a set of effects."""
    return Scene(
        slider=study.ring(max(study.grid.rod_length)),
        contact=Coulomb(FRICTION_COEFFICIENT),
        effects=study.effects(effects),
    )


def followed(scene: Scene, method: Method) -> xr.Dataset:
    """Log of a scene that the fence moves from rest."""
    step = DURATION / STEPS if method is Method.TIME_STEPPING else None
    fence = Pusher(velocity=tuple(direction(PUSHER_ANGLE)))
    return simulate(scene, pusher=fence, duration=DURATION, method=method, step=step)


#: Methods of the operations that are compiled, by the names that the library gives them.
COMPILED = {
    "simulate": Method.EVENT_DRIVEN,
    "simulate by time-stepping": Method.TIME_STEPPING,
}


def evaluations(study: StudyFile) -> xr.Dataset:
    """Functions and evaluations of each effect for one slider.

    Returns
    -------
    xarray.Dataset
        Over `effects`, the sets of effects that the study lists, and `effect`: `functions`, the number of
        the effect's functions in the machine code of each `operation`, and `evaluations`, the number of
        evaluations of the motion under the effect in the log of each `integrator`; 0 if the log has no such
        effect.

    Raises
    ------
    PlanarPushingError
        If nothing is compiled.
    """
    machine_code.require_machine_code()
    scenes = [one_slider(study, effects) for effects in study.grid.effects]
    counted = [[functions(each, scene) for scene in scenes] for each in COMPILED]
    logged = [[_logged(followed(scene, method)) for scene in scenes] for method in Method]
    dataset = xr.Dataset(
        {
            "functions": (("operation", "effects", "effect"), counted),
            "evaluations": (("integrator", "effects", "effect"), logged),
        },
        coords={
            "operation": list(COMPILED),
            "integrator": [str(method) for method in Method],
            "effects": list(study.grid.effects),
            "effect": [str(kind) for kind in STUDIED],
        },
    )
    return describe(
        dataset,
        title="Functions of each effect in machine code, and its evaluations over time",
        source="Secs. 3-4",
        parameters={"duration": DURATION, "steps": STEPS},
        quantities=EVALUATIONS,
    )


def functions(operation: str, scene: Scene) -> list[int]:
    """Number of functions of each effect in the machine code of an operation on a scene."""
    followed(scene, COMPILED[operation])
    found = machine_code.count_functions(scene, COMPILED[operation])
    return [found[kind] for kind in STUDIED]


def _logged(log: xr.Dataset) -> list[int]:
    """Evaluations of each effect at the end of a log."""
    listed = dict(zip(log.effect.values.tolist(), log.evaluations.values[-1].tolist(), strict=True))
    return [listed.get(str(kind), 0) for kind in STUDIED]


def cases(study: StudyFile) -> Iterator[tuple[str, str, str, Callable[[], object]]]:
    """Scene, operation, effects and call of each timed case.

    These are each operation on one slider with each set of effects and on the study's scenes, and, as
    scene "grid", datasets with one rod angle and every tenth coefficient of friction and pusher angle.
    """
    few: dict[str, Sequence[object]] = {"rod_angle": (study.slider.rod_angle,)}
    for axis in ("contact_friction_coefficient", "pusher_angle"):
        few[axis] = getattr(study.grid, axis)[::10]
    for effects in study.grid.effects:
        yield from _on("one slider", one_slider(study, effects))
        grid = study.grid.model_copy(update=few | {"effects": (effects,)})
        small = study.model_copy(update={"grid": grid})
        for name in TIMED:
            yield "grid", name, effects, partial(build_dataset, name, study_slice(small, name))
    for name, push in study.scenes.items():
        yield from _on(name, load_scene_file(push.file).build())


def _on(name: str, scene: Scene) -> Iterator[tuple[str, str, str, Callable[[], object]]]:
    listed = {EFFECT_CLASSES[type(effect).__name__] for effect in scene.effects}
    effects = "+".join(kind for kind in STUDIED if kind in listed)
    for operation, run in OPERATIONS.items():
        yield name, operation, effects, partial(run, scene)


def effects(study: StudyFile) -> xr.Dataset:
    """Times of each case on this machine, over `case` and `repeat`."""
    scene, operation, listed, calls = map(list, zip(*cases(study), strict=True))
    labels = {"scene": scene, "operation": operation, "effects": listed}
    dataset = xr.Dataset(
        {"time": (("case", "repeat"), seconds(calls, REPEATS))},
        coords={name: ("case", each) for name, each in labels.items()},
    )
    measured = describe(
        dataset,
        title="Times of each set of effects on one machine",
        source="scenes and grid of the study",
        parameters={"study": study.title},
    )
    return stamped(measured)
