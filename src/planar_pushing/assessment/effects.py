"""Which effects a push calls for: runs without each of them, and without as many as possible."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.assessment.estimate import (
    FACTOR,
    UNKNOWN,
    Estimate,
    estimate_pose_change,
    jump_times,
    way_of,
)
from planar_pushing.assessment.trial import SIDES, Trial, evaluations_of, modes_of
from planar_pushing.assessment.variants import Push, moved_contact
from planar_pushing.mechanics.contact import Outcome
from planar_pushing.mechanics.effects import Inertia, Load
from planar_pushing.mechanics.scene import Scene
from planar_pushing.terms.errors import InvalidValue

#: The error of leaving inertia out grows as the square of the speed while it is within these parts of
#: the way.
LAW = (1e-6, 0.1)
#: What a run does that is refused: nothing resists, or friction does not hold a load.
REFUSED = "no motion"


@dataclass(frozen=True, slots=True)
class Runs:
    """Runs of a push and of its neighbors, with some of the effects; each is simulated once.

    Attributes
    ----------
    trial : Trial
    pushes : list of (Scene, Pusher)
        The push with all effects, and its neighbors.
    logs : dict
        Logs of all pushes by the indices of their effects; None if a run is refused.
    """

    trial: Trial
    pushes: list[Push]
    logs: dict[tuple[int, ...], list[xr.Dataset] | None] = field(default_factory=dict)

    @property
    def full(self) -> tuple[int, ...]:
        """Indices of all effects."""
        return tuple(range(len(self.pushes[0][0].effects)))

    def of(self, kept: tuple[int, ...]) -> list[xr.Dataset] | None:
        """Logs with some of the effects, or None if they move nothing."""
        if kept not in self.logs:
            try:
                self.logs[kept] = [
                    self.trial.run(with_effects(scene, kept), pusher)
                    for scene, pusher in self.pushes
                ]
            except InvalidValue:
                self.logs[kept] = None
        return self.logs[kept]

    def changes(self, kept: tuple[int, ...]) -> list[float]:
        """Changes of the pose without the other effects, of the push and of its neighbors."""
        logs, full = self.of(kept), self.of(self.full)
        if logs is None or full is None:
            return [np.inf]
        return [self.trial.change(log, other) for log, other in zip(logs, full, strict=True)]


def with_effects(scene: Scene, kept: Sequence[int]) -> Scene:
    """The scene with some of its effects."""
    effects = tuple(scene.effects[i] for i in kept)
    if all(isinstance(effect, Load) for effect in effects):
        raise InvalidValue("effects", effects, "one that resists", "list friction or inertia")
    return replace(scene, effects=effects)


def start_runs(trial: Trial, scene: Scene, change: float) -> Runs:
    """The runs of a push, and of its neighbors: those whose contact is a little off to either side.

    A symmetric push hides what its neighbors show: through the center, no effect turns the object.

    Raises
    ------
    InvalidValue
        If the push itself is refused.
    """
    pushes: list[Push] = [(scene, trial.pusher)]
    logs = [trial.run(scene)]
    for side in () if scene.slider.flush else SIDES:
        try:
            push = moved_contact(scene, trial.pusher, side * change * trial.size, side * change)
            log = trial.run(*push)
        except InvalidValue:
            continue
        pushes.append(push)
        logs.append(log)
    runs = Runs(trial, pushes)
    runs.logs[runs.full] = logs
    return runs


def assess_effects(runs: Runs, tolerance: float) -> tuple[xr.Dataset, Scene, list[str]]:
    """The change that each effect makes, the scene with those that are needed, and warnings.

    Effects are left out one after the other, Coulomb friction last, and those that change little first.
    An effect is left out if the push and its neighbors then stay within the tolerance of those with all
    effects.
    """
    scene, names = runs.pushes[0][0], effect_names(runs.pushes[0][0])
    rows = [_row(runs, index, tolerance) for index in runs.full]
    order = sorted(
        runs.full,
        key=lambda i: (scene.effects[i] in scene.friction, max(rows[i]["pose_change_near"], 0.0)),
    )
    kept, off = runs.full, 0.0
    for index in order:
        rest = tuple(i for i in kept if i != index)
        if rest and rows[index]["pose_change_near"] <= tolerance:
            together = max(runs.changes(rest))
            if together <= tolerance:
                kept, off = rest, together
                rows[index]["needed"] = False
    every, lean = runs.of(runs.full), runs.of(kept)
    assert every
    assert lean
    variables = {name: ("effect", [row[name] for row in rows]) for name in rows[0]}
    effects = xr.Dataset(
        variables, {"effect": names},
        {"change_together": off, "modes": modes_of(every[0]), "modes_of_needed": modes_of(lean[0]),
         "evaluations": _evaluations(runs, runs.full), "evaluations_of_needed": _evaluations(runs, kept)},
    )  # fmt: skip
    messages = _doubts(lean[0], "the run with the needed effects")
    if kept != runs.full:
        messages += _doubts(every[0], "the run with all effects")
    return effects, with_effects(scene, kept), messages + _contradictions(effects, tolerance)


def _evaluations(runs: Runs, kept: tuple[int, ...]) -> int:
    """Evaluations of the push with some of the effects, without those of a log's samples."""
    scene, pusher = runs.pushes[0]
    return evaluations_of(runs.trial.run(with_effects(scene, kept), pusher, samples=2))


def _doubts(base: xr.Dataset, which: str) -> list[str]:
    """Warnings of a run on which one cannot rely."""
    warnings = []
    if (base["outcome"].values == Outcome.AMBIGUOUS).any():
        warnings.append(
            f"{which}: several contact modes are consistent on the way, and a policy chooses; do not trust "
            "one run"
        )
    if base.attrs["stopped"]:
        warnings.append(
            f"{which} ends early, at {base.attrs['stopped_time']:.4g}: {base.attrs['stopped']}"
        )
    return warnings


def effect_names(scene: Scene) -> list[str]:
    """Names of the effects, as in a log: those that occur several times are numbered."""
    kinds = [str(effect.kind) for effect in scene.effects]
    return [kind if kinds.count(kind) == 1 else f"{kind}_{i}" for i, kind in enumerate(kinds)]


def _row(runs: Runs, index: int, tolerance: float) -> dict[str, Any]:
    """An effect, and the change that it makes."""
    scene, pusher = runs.pushes[0]
    kept = tuple(i for i in runs.full if i != index)
    logs, changes = runs.of(kept), runs.changes(kept)
    estimate, modes = UNKNOWN, REFUSED
    if logs is not None:
        rest, circles = with_effects(scene, kept), runs.trial.circles
        effect = scene.effects[index]
        estimate = estimate_pose_change(logs[0], rest, effect, circles, jump_times(pusher))
        modes = modes_of(logs[0])
    near = max(changes)
    return _numbers(estimate) | {
        "pose_change": changes[0], "pose_change_near": near, "modes": modes, "needed": True,
        "speed_limit": _speed_limit(runs, index, near, tolerance),
    }  # fmt: skip


def _numbers(estimate: Estimate) -> dict[str, float]:
    return {
        "force_share": estimate.force_share, "torque_share": estimate.torque_share,
        "stopping": estimate.stopping, "estimate": estimate.total,
    }  # fmt: skip


def _speed_limit(runs: Runs, index: int, change: float, tolerance: float) -> float:
    """Speed of the pusher up to which inertia can be left out; NaN where no law gives it."""
    scene, logs = runs.pushes[0][0], runs.of(runs.full)
    if not isinstance(scene.effects[index], Inertia) or not logs:
        return np.nan
    way = way_of(logs[0], runs.trial.circles).sum()
    if not LAW[0] * way < change < LAW[1] * way:
        return np.nan
    times, places = logs[0]["time"].values, logs[0]["pusher"].values
    later = np.diff(times) > 1e-12 * times[-1]
    steps = np.hypot(*np.diff(places, axis=0)[later].T) / np.diff(times)[later]
    return float(steps.max() * np.sqrt(tolerance / change))


def _contradictions(effects: xr.Dataset, tolerance: float) -> list[str]:
    """Warnings of effects that change more than their estimates allow."""
    warnings = []
    for name in effects["effect"].values:
        row = effects.sel(effect=name)
        change, estimate = float(row["pose_change"]), float(row["estimate"])
        if np.isfinite(change) and change > max(FACTOR * estimate, tolerance):
            warnings.append(
                f"without {name} the pose changes by {change:.3g}, more than {FACTOR:g} times the estimate "
                f"{estimate:.3g}: a mode or a support near the center amplifies; do not trust one run"
            )
    return warnings
