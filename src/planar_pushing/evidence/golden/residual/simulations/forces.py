"""Force law of each entry: the force carries friction and inertia, within the law of the contact."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
import xarray as xr

from planar_pushing.certified.doubled.ring import wrench
from planar_pushing.evidence.golden.residual.finding import Finding
from planar_pushing.evidence.golden.residual.simulations.entries import (
    SLIP_LEFT,
    SLIP_RIGHT,
    STICK,
    Floats,
    Log,
    rounding,
)
from planar_pushing.terms.options import EffectSet

#: Roundings of a force, for a rod of no length.
FORCE, RATIO = 64, 64


def forces(dataset: xr.Dataset, log: Log) -> Iterable[Finding]:
    """Findings of the force and of the spin ratio."""
    pace = np.hypot(*log.velocity.T)
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.where(log.spin == 0, 0.0, log.spin / pace)
    k = dataset["spin_ratio"].values
    gap = np.where(k == ratio, 0.0, np.abs(k - ratio))
    yield Finding(
        "spin_ratio", gap, np.where(np.isfinite(ratio), rounding(np.abs(ratio), RATIO), 0.0)
    )
    friction, torque = _friction(log, pace, k)
    steady = log.effects == EffectSet.SUPPORT_FRICTION
    found = _balance(log, friction, torque) if steady else _acceleration(log, friction, torque)
    error = np.maximum(found, _off_edge(log))
    error = np.where((log.mode >= STICK), error, np.abs(log.force).max(axis=1))
    size = rounding(np.hypot(*log.force.T) * (1 + log.length) ** 2, FORCE)
    yield Finding("force", np.broadcast_to(error[:, None], log.force.shape), size[:, None])


def _friction(log: Log, pace: Floats, k: Floats) -> tuple[Floats, Floats]:
    """Force that sustains the motion against the support's friction, and its torque over R."""
    force, torque = (part.value() for part in wrench(np.where(np.isfinite(k), np.abs(k), 0.0)))
    spins, moves = ~np.isfinite(k), (pace > 0) | (log.spin != 0)
    force, torque = np.where(spins, 0.0, force), np.where(spins, 1.0, torque) * np.sign(log.spin)
    heading = log.velocity / np.where(pace > 0, pace, 1.0)[:, None]
    return log.slider.weight * heading * force[:, None], log.slider.weight * torque * moves


def _torque(log: Log) -> Floats:
    """Torque of the fence's force about the ring center, over R."""
    x, y = log.lever.T
    return np.asarray(log.force[:, 0] * y - log.force[:, 1] * x)


def _balance(log: Log, friction: Floats, torque: Floats) -> Floats:
    """What friction alone leaves of the force and of the torque."""
    lack = np.abs(log.force - friction).max(axis=1)
    return np.asarray(np.maximum(lack, np.abs(_torque(log) - torque)))


def _acceleration(log: Log, friction: Floats, torque: Floats) -> Floats:
    """Force of the contact's acceleration: none where it sticks, else none normal to the fence."""
    mass, gyration = log.slider.mass, log.slider.gyration
    turning = (_torque(log) - torque) / gyration
    spin = mass * log.spin**2
    x, y = log.lever.T
    lack = (
        log.force - friction + np.stack([turning * y + spin * x, spin * y - turning * x], axis=-1)
    )
    along = np.where(log.mode == STICK, np.abs(lack[:, 0]), 0.0)
    return np.asarray(np.maximum(np.abs(lack[:, 1]), along))


def _off_edge(log: Log) -> Floats:
    """Part of a force off the edge of the friction cone, where the contact slips."""
    x, y = log.force.T
    endless = np.isinf(log.friction)
    mu = 0.0 if endless else log.friction
    side = np.where(log.mode == SLIP_LEFT, 1.0, -1.0)
    off = np.abs(y) if endless else np.abs(x - side * mu * y)
    return np.where((log.mode == SLIP_RIGHT) | (log.mode == SLIP_LEFT), off, 0.0)
