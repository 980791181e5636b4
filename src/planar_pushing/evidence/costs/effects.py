"""Cost of the effects that a scene lists: evaluations over time, and times by the number of effects.

The core loops over the listed effects, and a log counts the evaluations of each of them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from planar_pushing.evidence.costs.times import seconds, stamped
from planar_pushing.mechanics.cones import motion_cone
from planar_pushing.mechanics.contact import Coulomb
from planar_pushing.mechanics.effects import SupportFriction
from planar_pushing.mechanics.limit_curve import curve_of_unit_motions
from planar_pushing.mechanics.plane import direction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.solve import solve
from planar_pushing.mechanics.supports import Polygon
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.simulation.simulate import simulate
from planar_pushing.study.build import build_dataset
from planar_pushing.study.describe import describe
from planar_pushing.study.files.scenes import load_scene_file
from planar_pushing.study.files.study_model import StudyFile
from planar_pushing.study.slices import study_slice
from planar_pushing.terms.options import EFFECT_CLASSES, STUDIED, EffectSet, Method
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
#: Numbers of equal squares among which friction is divided, and the number of steps of their simulation.
NUMBERS, DIVIDED_STEPS = (1, 2, 4, 8, 16), 3000
SQUARE = Polygon([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)])
REPEATS = 7


def one_slider(study: StudyFile, effects: Any) -> Scene:
    """The study's slider with its longest rod, under a set of effects."""
    return Scene(
        slider=study.ring(max(study.grid.rod_length)),
        contact=Coulomb(FRICTION_COEFFICIENT),
        effects=study.effects(effects),
    )


def divided(study: StudyFile, number: int) -> Scene:
    """The slider on squares that share the weight equally, so that it moves as on one of them."""
    part = SupportFriction(support=SQUARE, weight=1.0 / number)
    return replace(one_slider(study, EffectSet.SUPPORT_FRICTION), effects=(part,) * number)


def followed(scene: Scene, method: Method, steps: int = STEPS) -> xr.Dataset:
    """Log of a scene that the fence moves from rest."""
    step = DURATION / steps if method is Method.TIME_STEPPING else None
    fence = Pusher(velocity=tuple(direction(PUSHER_ANGLE)))
    return simulate(scene, pusher=fence, duration=DURATION, method=method, step=step)


def evaluations(study: StudyFile) -> xr.Dataset:
    """Evaluations of each effect for one slider.

    Returns
    -------
    xarray.Dataset
        Over `integrator`, `effects`, the sets of effects that the study lists, and `effect`: `evaluations`,
        the number of evaluations of the motion under the effect in a log; 0 if the log has no such effect.
    """
    scenes = [one_slider(study, effects) for effects in study.grid.effects]
    logged = [[_logged(followed(scene, method)) for scene in scenes] for method in Method]
    dataset = xr.Dataset(
        {"evaluations": (("integrator", "effects", "effect"), logged)},
        coords={
            "integrator": [str(method) for method in Method],
            "effects": list(study.grid.effects),
            "effect": [str(kind) for kind in STUDIED],
        },
    )
    return describe(
        dataset,
        title="Evaluations of each effect over time",
        source="Secs. 3-4",
        parameters={"duration": DURATION, "steps": STEPS},
        quantities=EVALUATIONS,
    )


def _logged(log: xr.Dataset) -> list[int]:
    """Evaluations of each effect at the end of a log."""
    listed = dict(zip(log.effect.values.tolist(), log.evaluations.values[-1].tolist(), strict=True))
    return [listed.get(str(kind), 0) for kind in STUDIED]


class Case(NamedTuple):
    """A timed call: labels of its scene, operation and effects, the number of listed effects, the call."""

    scene: str
    operation: str
    effects: str
    number: int
    call: Callable[[], object]


def cases(study: StudyFile) -> Iterator[Case]:
    """The timed cases.

    These are each operation on one slider with each set of effects and on the study's scenes; as scene
    "grid", datasets with one rod angle and every tenth coefficient of friction and pusher angle; and, as
    scene "equal supports", simulations of friction that is divided among 1 to 16 supports.
    """
    few: dict[str, Sequence[object]] = {"rod_angle": (study.slider.rod_angle,)}
    for axis in ("contact_friction_coefficient", "pusher_angle"):
        few[axis] = getattr(study.grid, axis)[::10]
    for effects in study.grid.effects:
        yield from _on("one slider", one_slider(study, effects))
        grid = study.grid.model_copy(update=few | {"effects": (effects,)})
        small = study.model_copy(update={"grid": grid})
        for name in TIMED:
            build = partial(build_dataset, name, study_slice(small, name))
            yield Case("grid", name, effects, effects.count("+") + 1, build)
    for name, push in study.scenes.items():
        yield from _on(name, load_scene_file(push.file).build())
    for number in NUMBERS:
        run = partial(followed, divided(study, number), Method.TIME_STEPPING, DIVIDED_STEPS)
        yield Case("equal supports", "simulate", EffectSet.SUPPORT_FRICTION, number, run)


def _on(name: str, scene: Scene) -> Iterator[Case]:
    listed = {EFFECT_CLASSES[type(effect).__name__] for effect in scene.effects}
    effects = "+".join(kind for kind in STUDIED if kind in listed)
    for operation, run in OPERATIONS.items():
        yield Case(name, operation, effects, len(scene.effects), partial(run, scene))


def effects(study: StudyFile) -> xr.Dataset:
    """Times of each case on this machine, over `case` and `repeat`."""
    *columns, calls = map(list, zip(*cases(study), strict=True))
    labels = dict(zip(Case._fields, columns, strict=False))
    dataset = xr.Dataset(
        {"time": (("case", "repeat"), seconds(calls, REPEATS))},
        coords={name: ("case", each) for name, each in labels.items()},
    )
    measured = describe(
        dataset,
        title="Times by the listed effects and by their number on one machine",
        source="scenes and grid of the study",
        parameters={"study": study.title, "steps": DIVIDED_STEPS},
    )
    return stamped(measured)
