"""How sure a push is: the change of its final pose if one of its inputs is a little off."""

from __future__ import annotations

import numpy as np
import xarray as xr

from planar_pushing.assessment.trial import SIDES, Trial, modes_of
from planar_pushing.assessment.variants import changed_inputs
from planar_pushing.mechanics.contact import Outcome
from planar_pushing.mechanics.scene import Scene
from planar_pushing.terms.errors import InvalidValue

#: One-sided slopes that differ by more than this part are a kink.
KINK = 0.5


def assess_inputs(
    trial: Trial, scene: Scene, change: float, tolerance: float
) -> tuple[xr.Dataset, list[str]]:
    """Changes of the final pose over `input` and `side`, and warnings.

    `kink` is the largest displacement by the sum of both changes, divided by the larger of them: 0 if the
    slopes to both sides are the same, 2 if the pose changes by the same to both sides.
    """
    base = trial.run(scene, samples=2)
    names, changes, kinks, same = [], [], [], []
    for name, push in changed_inputs(scene, trial.pusher, trial.size, change):
        logs: list[xr.Dataset | None] = []
        for side in SIDES:
            try:
                logs.append(trial.run(*push(side), samples=2))
            except InvalidValue:
                logs.append(None)
        known = [log for log in logs if log is not None]
        if not known:
            continue
        sizes = [np.nan if log is None else trial.end_change(base, log) for log in logs]
        names.append(name)
        changes.append(sizes)
        kinks.append(_kink(trial, base, known) / max(np.nanmax(sizes), np.finfo(float).tiny))
        same.append(all(modes_of(log) == modes_of(base) for log in known))
    inputs = xr.Dataset(
        {"change": (("input", "side"), np.reshape(changes, (-1, 2))), "kink": ("input", kinks),
         "same_modes": ("input", np.array(same, bool))},
        {"input": names, "side": ["+", "-"]},
        {"change_of_inputs": change, "change_together": float(np.nanmax(changes, axis=1).sum())},
    )  # fmt: skip
    return inputs, _kinks(inputs, tolerance)


def doubts(base: xr.Dataset, which: str) -> list[str]:
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


def _kink(trial: Trial, base: xr.Dataset, logs: list[xr.Dataset]) -> float:
    """Largest displacement by the sum of the changes to both sides; NaN if one is not known."""
    if len(logs) < len(SIDES):
        return np.nan
    one, other = (trial.end_displacement(base, log) for log in logs)
    both = type(one)(one.position + other.position, one.turn + other.turn)
    return float(both.reach(trial.circles)[0])


def _kinks(inputs: xr.Dataset, tolerance: float) -> list[str]:
    """Warnings of inputs with a kink, near which the pose changes by more than the tolerance."""
    warnings = []
    for name in inputs["input"].values:
        row = inputs.sel(input=name)
        more, less = row["change"].values
        if float(row["kink"]) > KINK and max(more, less) > tolerance:
            warnings.append(
                f"{name}: a little more and a little less change the pose by {more:.3g} and {less:.3g}, "
                "not symmetrically: near a change of mode; do not trust one run"
            )
    return warnings
