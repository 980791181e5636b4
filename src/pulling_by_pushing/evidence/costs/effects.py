"""Cost of the effects that a scene lists: evaluations over time, and times by the effects and their number.

The core loops over the listed effects, and a log counts the evaluations of each of them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.contact import Coulomb
from planar_pushing.mechanics.effects import SupportFriction
from planar_pushing.mechanics.force.cones import motion_cone
from planar_pushing.mechanics.force.limit_curve import curve_of_unit_motions
from planar_pushing.mechanics.plane import direction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.solve import solve
from planar_pushing.mechanics.supports import Polygon
from planar_pushing.simulation.early_end import quietly
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.simulation.simulate import simulate
from planar_pushing.terms.options import STUDIED, EffectSet, Method
from planar_pushing.terms.quantities import EFFECT_COSTS
from planar_pushing.terms.replacing import PathLike
from pulling_by_pushing.evidence.costs.measure import accuracy_time, add_machine, seconds
from pulling_by_pushing.study.catalog import EVIDENCE
from pulling_by_pushing.study.describe import describe
from pulling_by_pushing.study.model import StudyFile
from pulling_by_pushing.study.running.build import Attributes, write_built
from pulling_by_pushing.study.study_file import load_study

#: A push, and the duration and the number of steps of its simulation.
FRICTION_COEFFICIENT, PUSHER_ANGLE = 2.0, np.deg2rad(-10.0)
DURATION, RUN_STEPS = 1.0, 100
FORCE_ANGLES = np.deg2rad(np.arange(361.0))
#: Numbers of equal squares among which friction is divided, and the number of steps of their simulation.
SUPPORTS, DIVIDED_STEPS = (1, 2, 4, 8, 16), 1000
SQUARE = Polygon([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)])
#: Number of times that each computation is timed, and how often it then runs.
REPEATS, COPIES = 5, 10


def pushed_slider(study: StudyFile, effects: Any) -> Scene:
    """The study's slider with its longest rod, under a set of effects."""
    return Scene(
        slider=study.ring(max(study.grid.rod_length)),
        contact=Coulomb(FRICTION_COEFFICIENT),
        effects=study.effects(effects),
    )


def divided_slider(study: StudyFile, number: int) -> Scene:
    """The slider on squares that share the weight equally, so that it moves as on one of them."""
    part = SupportFriction(support=SQUARE, weight=1.0 / number)
    return replace(pushed_slider(study, EffectSet.SUPPORT_FRICTION), effects=(part,) * number)


def run(scene: Scene, method: Method, steps: int = RUN_STEPS) -> xr.Dataset:
    """Log of a scene that the fence moves from rest."""
    step = DURATION / steps if method is Method.TIME_STEPPING else None
    fence = Pusher(velocity=tuple(direction(PUSHER_ANGLE)))
    return quietly(simulate)(scene, pusher=fence, duration=DURATION, method=method, step=step)


#: Timed computations: the cone, a curve of 361 points, every mode of one push, and a run by each method.
COMPUTATIONS: dict[str, Callable[[Scene], object]] = {
    "motion cone": motion_cone,
    "limit curve": lambda scene: curve_of_unit_motions(scene, FORCE_ANGLES),
    "contact modes": lambda scene: solve(scene, PUSHER_ANGLE),
    **{str(method): partial(run, method=method) for method in Method},
}


def write_times(
    times: PathLike, costs: PathLike, *, study: str, marks: Mapping[str, Attributes]
) -> None:
    """Measure times on this machine, of every method and of each effect, and count evaluations.

    Parameters
    ----------
    times, costs : path
        The datasets `accuracy_time` and `effects`.
    study : str
        Study file with the slider on which the effects act.
    marks : mapping
        Attributes that identify the study in each of the two datasets.
    """
    write_built(accuracy_time(), times, "accuracy_time", marks["accuracy_time"])
    write_built(effects(load_study(study)), costs, "effects", marks["effects"])


def effects(study: StudyFile) -> xr.Dataset:
    """Evaluations of each effect for one slider, and times on this machine.

    Returns
    -------
    xarray.Dataset
        `evaluations` over `integrator`, `effects`, the sets of effects that the study lists, and `effect`:
        the number of evaluations of the motion under the effect in a log, 0 if the log has no such effect.
        `computation_seconds` over `computation` and `effects`, and `supports_seconds` over `supports`, for
        friction that is divided among equal supports; both over `repeat`.
    """
    scenes = [pushed_slider(study, effect_set) for effect_set in study.grid.effects]
    by_effects = seconds(
        [partial(_repeat, compute, scene) for compute in COMPUTATIONS.values() for scene in scenes],
        REPEATS,
    )
    by_supports = seconds(
        [
            partial(run, divided_slider(study, number), Method.TIME_STEPPING, DIVIDED_STEPS)
            for number in SUPPORTS
        ],
        REPEATS,
    )
    shape = len(COMPUTATIONS), len(scenes), REPEATS
    counts = [[_evaluations(run(scene, method)) for scene in scenes] for method in Method]
    dataset = xr.Dataset(
        {
            "evaluations": (("integrator", "effects", "effect"), counts),
            "computation_seconds": (
                ("computation", "effects", "repeat"),
                by_effects.reshape(shape) / COPIES,
            ),
            "supports_seconds": (("supports", "repeat"), by_supports),
        },
        coords={
            "integrator": [str(method) for method in Method],
            "effects": list(study.grid.effects),
            "effect": [str(kind) for kind in STUDIED],
            "computation": list(COMPUTATIONS),
            "supports": list(SUPPORTS),
        },
    )
    costs = describe(
        dataset,
        title=EVIDENCE["effects"].capitalize(),
        source="Secs. 3-4",
        parameters={"duration": DURATION, "steps": RUN_STEPS, "divided_steps": DIVIDED_STEPS},
        quantities=EFFECT_COSTS,
    )
    return add_machine(costs)


def _repeat(compute: Callable[[Scene], object], scene: Scene) -> None:
    for _ in range(COPIES):
        compute(scene)


def _evaluations(log: xr.Dataset) -> list[int]:
    """Total of each effect that a study can have; 0 for one that the log lacks."""
    counts = dict(zip(log.effect.values.tolist(), log.evaluations.values[-1].tolist(), strict=True))
    return [counts.get(str(kind), 0) for kind in STUDIED]
