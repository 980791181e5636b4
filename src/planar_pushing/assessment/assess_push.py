"""`assess_push`: which effects a push calls for, what accuracy costs, and how sure the answer is."""

from __future__ import annotations

import math
import warnings
from collections.abc import Sequence

import numpy as np

from planar_pushing.assessment.effects import assess_effects, start_runs
from planar_pushing.assessment.estimate import outline_circles
from planar_pushing.assessment.inputs import assess_inputs
from planar_pushing.assessment.methods import assess_methods
from planar_pushing.assessment.result import PushAssessment
from planar_pushing.assessment.trial import Trial
from planar_pushing.assessment.variants import with_candidates
from planar_pushing.mechanics.effects import Effect, Inertia, Load, SupportFriction, Viscous
from planar_pushing.mechanics.scene import Scene, require_scene, require_single
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.terms.declared import Within, positive
from planar_pushing.terms.domain import DURATION
from planar_pushing.terms.errors import InvalidValue, SceneWarning, require_kind, require_number

#: Default tolerance, in sizes of the object.
TOLERANCE = 0.01
CHANGE = Within(
    lambda x: (x > 0.0) & (x <= 0.1), "a number in (0, 0.1]",
    "give a part of the object's size, for instance 0.01",
)  # fmt: skip


def assess_push(
    scene: Scene,
    pusher: Pusher,
    *,
    duration: float,
    candidates: Sequence[Effect] = (),
    tolerance: float | None = None,
    change: float = 0.01,
) -> PushAssessment:
    """Assess a push: which effects it calls for, which method is cheapest, and how sure the answer is.

    Parameters
    ----------
    scene : Scene
        One scene, from rest and with the contact on the pusher.
    pusher : Pusher
        The second argument, or by name. With a velocity in the world, it moves along the axes of the
        object's frame at time 0.
    duration : float
        Time to simulate, > 0.
    candidates : sequence of effects
        Effects that may matter beside those of the scene, in the object's frame as for `scene_at`.
    tolerance : float, optional
        Largest change of the pose that does not matter, > 0, in the scene's unit of length; by default
        a hundredth of the object's diagonal. The change of a pose is the largest displacement over the
        outline, or without an outline over the support's extent.
    change : float
        How far each input is off: lengths in sizes of the object, angles in radians, and numbers
        relative to themselves; in (0, 0.1].

    Returns
    -------
    PushAssessment
        It prints as a table, can be drawn, and holds the scene with the needed effects alone.

    Warns
    -----
    SceneWarning
        As in `simulate`.

    Raises
    ------
    InvalidValue
        If a value is not allowed, the scene is an array of scenes, or `simulate` refuses the push.

    Notes
    -----
    The run with all effects is compared with the run without each of them, with the contact in its
    place and moved by `change` to either side. Then the effects are left out one after the other, as
    long as all that is left out together changes the pose by no more than the tolerance. An effect
    without which nothing moves, or no friction holds a load, is needed. `estimate` explains the
    changes: leaving out inertia, viscous friction or a load changed the pose by less than 8 times the
    estimate in all of 1,400 random pushes.
    """
    require_single(require_scene(scene))
    require_kind("pusher", pusher, Pusher)
    if pusher.arrays or np.ndim(pusher.radius):
        raise InvalidValue("pusher", "arrays", "one pusher", "assess the pushes one by one")
    for name, declared, value in (
        ("duration", DURATION, duration), ("tolerance", positive("give a length"), tolerance),
        ("change", CHANGE, change),
    ):  # fmt: skip
        if value is not None or name != "tolerance":
            number = declared.require(name, value)
            require_number(name, number, math.isfinite, "one number", "give one")
    full = with_candidates(scene, _require_candidates(candidates))
    trial = Trial(pusher, float(duration), outline_circles(full))
    limit = TOLERANCE * trial.size if tolerance is None else float(tolerance)
    trial.run(full, samples=2)  # which refuses and warns
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", SceneWarning)
        return _assess(trial, full, limit, float(change))


def _assess(trial: Trial, full: Scene, tolerance: float, change: float) -> PushAssessment:
    """Assess a push that `simulate` accepts."""
    runs = start_runs(trial, full, change)
    effects, scene, messages = assess_effects(runs, tolerance)
    methods = assess_methods(trial, scene, tolerance)
    inputs, kinks = assess_inputs(trial, scene, change, tolerance)
    if methods.attrs["cheapest"] < 0:
        messages.append("no setting of a method holds the tolerance")
    return PushAssessment(
        effects=effects, methods=methods, inputs=inputs, scene=scene, tolerance=tolerance,
        duration=trial.duration, warnings=(*messages, *kinks),
    )  # fmt: skip


def _require_candidates(value: object) -> tuple[Effect, ...]:
    """Candidates, or `InvalidValue`."""
    kinds = SupportFriction | Viscous | Inertia | Load
    effects = tuple(value) if isinstance(value, (tuple, list)) else (value,)
    if not all(isinstance(effect, kinds) for effect in effects):
        raise InvalidValue(
            "candidates", value, "a sequence of SupportFriction, Viscous, Inertia and Load",
            "list effects that may matter, for instance [Inertia(mass=1.2)]",
        )  # fmt: skip
    return effects
