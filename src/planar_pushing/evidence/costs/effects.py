"""Count and time what scenes and datasets of each set of effects cost."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial

import numpy as np
import xarray as xr

from planar_pushing.evidence.costs.counted import counting
from planar_pushing.evidence.costs.timing import seconds, stamped
from planar_pushing.mechanics.cones import motion_cone
from planar_pushing.mechanics.contact import Coulomb
from planar_pushing.mechanics.limit_curve import limit_curve
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.solve import solve
from planar_pushing.study.datasets import contact_modes, limit_curves, motion_cones
from planar_pushing.study.describe import describe
from planar_pushing.study.files.scenes import load_scene_file
from planar_pushing.study.files.study_model import StudyFile
from planar_pushing.terms.options import EFFECT_CLASSES, STUDIED

#: What is asked of a scene: the cone, a curve of 361 points, and every mode of one push.
FORCE_ANGLES = np.deg2rad(np.arange(361.0))
PUSHER_ANGLE = np.deg2rad(-10.0)
OPERATIONS: dict[str, Callable[[Scene], object]] = {
    "motion_cone": motion_cone,
    "limit_curve": lambda scene: limit_curve(scene, FORCE_ANGLES),
    "solve": lambda scene: solve(scene, PUSHER_ANGLE),
}
BUILDERS: dict[str, Callable[[StudyFile], xr.Dataset]] = {
    "limit_curves": limit_curves.build,
    "motion_cones": motion_cones.build,
    "contact_modes": contact_modes.build,
}
REPEATS = 7


@dataclass(frozen=True, slots=True)
class Case:
    """Something that is computed with a set of effects.

    Attributes
    ----------
    scene : str
        Name of the scene, or "grid" for a dataset.
    operation : str
        What is computed.
    effects : str
        Effects that are listed.
    run : callable
        Computes it.
    """

    scene: str
    operation: str
    effects: str
    run: Callable[[], object]


def _listed(scene: Scene) -> str:
    listed = {EFFECT_CLASSES[type(effect).__name__] for effect in scene.effects}
    return "+".join(kind for kind in STUDIED if kind in listed)


def _scene_case(name: str, operation: str, scene: Scene) -> Case:
    return Case(name, operation, _listed(scene), partial(OPERATIONS[operation], scene))


def _dataset_case(name: str, study: StudyFile) -> Case:
    return Case("grid", name, study.grid.effects[0], partial(BUILDERS[name], study))


def cases(study: StudyFile) -> Iterator[Case]:
    """Every operation on one slider with each set of effects, on the study's scenes, and on its grid.

    The grid has one rod angle, and every tenth coefficient of friction and pusher angle.
    """
    for effects in study.grid.effects:
        scene = Scene(
            slider=study.ring(max(study.grid.rod_length)),
            contact=Coulomb(2.0),
            effects=study.effects(effects),
        )
        for operation in OPERATIONS:
            yield _scene_case("one slider", operation, scene)
        few = {"effects": (effects,), "rod_angle": (study.slider.rod_angle,)}
        for axis in ("contact_friction_coefficient", "pusher_angle"):
            few[axis] = getattr(study.grid, axis)[::10]
        grid = study.grid.model_copy(update=few)
        for name in BUILDERS:
            yield _dataset_case(name, study.model_copy(update={"grid": grid}))
    for name, push in study.scenes.items():
        scene = load_scene_file(push.file).build()
        for operation in OPERATIONS:
            yield _scene_case(name, operation, scene)


def _tally(run: Callable[[], object]) -> Counter[str]:
    with counting() as tally:
        run()
    return tally


def evaluations(study: StudyFile) -> xr.Dataset:
    """Evaluations of each effect in each case, over `case` and `effect`; the same on every machine.

    Raises
    ------
    PlanarPushingError
        Where the mechanics are compiled, as in `counting`.
    """
    found, names = list(cases(study)), [str(kind) for kind in STUDIED]
    tallies = [_tally(case.run) for case in found]
    counts = np.array([[tally[name] for name in names] for tally in tallies])
    dataset = xr.Dataset(
        {"evaluations": (("case", "effect"), counts)},
        coords={
            "effect": names,
            "scene": ("case", [case.scene for case in found]),
            "operation": ("case", [case.operation for case in found]),
            "effects": ("case", [case.effects for case in found]),
        },
    )
    return describe(
        dataset,
        title="How often each effect is evaluated",
        source="scenes and grid of the study",
        parameters={"study": study.title},
    )


def measure(study: StudyFile, counted: xr.Dataset) -> xr.Dataset:
    """Evaluations of a study, with the time of each case in each repeat on this machine."""
    taken = seconds([case.run for case in cases(study)], REPEATS)
    measured = describe(
        counted.assign(time=(("case", "repeat"), taken)),
        title="What each effect costs: evaluations counted, time measured on one machine",
        source="scenes and grid of the study",
        parameters={"study": study.title},
    )
    return stamped(measured)
