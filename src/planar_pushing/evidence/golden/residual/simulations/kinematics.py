"""Kinematics of each entry: the fence's way, the contact's gap and slip, and its velocity."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
import xarray as xr

from planar_pushing.evidence.golden.residual.finding import Finding
from planar_pushing.evidence.golden.residual.simulations.entries import (
    SEPARATE,
    STICK,
    Floats,
    Log,
    rounding,
)
from planar_pushing.terms.options import EffectSet

#: Roundings of a position, and of a velocity.
PLACE, VELOCITY = 32, 64
#: Part of the relative tolerance of a run that a way apart from the fence loses.
DRIFT = 0.02


def kinematics(dataset: xr.Dataset, log: Log, radius: float) -> Iterable[Finding]:
    """Findings of the variables of place and velocity."""
    size = radius * (np.abs(log.position).max(axis=1) + np.abs(log.fence).max(axis=1) + log.length)
    yield Finding(
        "fence",
        np.abs(dataset["fence"].values - radius * log.fence),
        rounding(np.abs(radius * log.fence), 4),
    )
    apart = radius * (log.contact - log.fence)
    gap = np.abs(dataset["gap"].values - apart[:, 1])
    yield Finding("gap", gap, rounding(size, PLACE))
    slip = np.abs(_slips(dataset["slip"].values, apart[:, 0], log))
    yield Finding("slip", slip, rounding(size, PLACE))
    yield Finding("rod_angle", np.maximum(gap, slip), rounding(size, PLACE))
    free = np.maximum(gap[:, None], _free(dataset["time"].values, log) * radius)
    drift = rounding(size, PLACE) + DRIFT * dataset.attrs["rtol"] * size
    yield Finding("position", np.maximum(free, slip[:, None]), drift[:, None])
    yield _twist(dataset, log)


def _slips(slip: Floats, apart: Floats, log: Log) -> Floats:
    """Change of the slip, less that of the contact over the fence; it rests while they are apart."""
    touches = log.mode[:-1] != SEPARATE
    lack = np.diff(slip) - np.where(touches, np.diff(apart), 0.0)
    return np.concatenate([[slip[0]], lack])


def _free(time: Floats, log: Log) -> Floats:
    """Way of the center apart from the fence, less that of its velocity; shape (n, 2).

    It is known in closed form at rest and without friction.
    """
    apart = log.mode[:-1] == SEPARATE
    rests = (log.pace[:-1] == 0) | (log.effects == EffectSet.SUPPORT_FRICTION)
    known = apart & (rests | (log.effects == EffectSet.INERTIA))
    lack = np.diff(log.position, axis=0) - log.velocity[:-1] * np.diff(time)[:, None]
    return np.concatenate([[[0.0, 0.0]], np.abs(np.where(known[:, None], lack, 0.0))])


def _twist(dataset: xr.Dataset, log: Log) -> Finding:
    """The contact moves with the fence: in both directions where it sticks, else normal to it."""
    lack = np.abs(log.contact_velocity - log.fence_velocity)
    error = np.where(log.mode >= STICK, lack[:, 1], 0.0)
    error = np.maximum(error, np.where(log.mode == STICK, lack[:, 0], 0.0))
    size = log.pace + np.hypot(*log.fence_velocity.T)
    shape = dataset["twist"].shape
    allowed = rounding(size, VELOCITY)[:, None]
    return Finding("twist", np.broadcast_to(error[:, None], shape), allowed)
