"""Evaluations of the effects that a scene lists, in runs over time.

The core loops over the listed effects, and a log counts the evaluations of each of them.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.contact import Coulomb
from planar_pushing.mechanics.plane import direction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.simulation.early_end import quietly
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.simulation.simulate import simulate
from planar_pushing.terms.options import STUDIED, Method
from planar_pushing.terms.replacing import PathLike
from pulling_by_pushing.study.catalog import EVIDENCE
from pulling_by_pushing.study.describe import describe
from pulling_by_pushing.study.model import StudyFile
from pulling_by_pushing.study.quantities import EFFECT_COSTS
from pulling_by_pushing.study.running.build import Attributes, write_built
from pulling_by_pushing.study.study_file import load_study

#: A push, and the duration and the number of steps of its simulation.
FRICTION_COEFFICIENT, PUSHER_ANGLE = 2.0, np.deg2rad(-10.0)
DURATION, STEPS = 1.0, 100


def pushed_slider(study: StudyFile, effects: Any) -> Scene:
    """The study's slider with its longest rod, under a set of effects."""
    return Scene(
        slider=study.ring(max(study.grid.rod_length)),
        contact=Coulomb(FRICTION_COEFFICIENT),
        effects=study.effects(effects),
    )


def run(scene: Scene, method: Method) -> xr.Dataset:
    """Log of a scene that the fence moves from rest."""
    step = DURATION / STEPS if method is Method.TIME_STEPPING else None
    fence = Pusher(velocity=tuple(direction(PUSHER_ANGLE)))
    return quietly(simulate)(scene, pusher=fence, duration=DURATION, method=method, step=step)


def write_effects(path: PathLike, *, study: str, marks: Attributes) -> None:
    """Count evaluations of each effect, and write the dataset.

    Parameters
    ----------
    path : path
    study : str
        Study file with the slider on which the effects act.
    marks : mapping
        Attributes that identify the study.
    """
    write_built(effects(load_study(study)), path, "effects", marks)


def effects(study: StudyFile) -> xr.Dataset:
    """Evaluations of each effect for one slider.

    Returns
    -------
    xarray.Dataset
        `evaluations` over `integrator`, `effects`, the sets of effects that the study lists, and `effect`:
        the number of evaluations of the motion under the effect in a log, 0 if the log has no such effect.
    """
    scenes = [pushed_slider(study, effect_set) for effect_set in study.grid.effects]
    counts = [[_evaluations(run(scene, method)) for scene in scenes] for method in Method]
    dataset = xr.Dataset(
        {"evaluations": (("integrator", "effects", "effect"), counts)},
        coords={
            "integrator": [str(method) for method in Method],
            "effects": list(study.grid.effects),
            "effect": [str(kind) for kind in STUDIED],
        },
    )
    return describe(
        dataset,
        title=EVIDENCE["effects"].capitalize(),
        source="Secs. 3-4",
        parameters={"duration": DURATION, "steps": STEPS},
        quantities=EFFECT_COSTS,
    )


def _evaluations(log: xr.Dataset) -> list[int]:
    """Total of each effect that a study can have; 0 for one that the log lacks."""
    counts = dict(zip(log.effect.values.tolist(), log.evaluations.values[-1].tolist(), strict=True))
    return [counts.get(str(kind), 0) for kind in STUDIED]
