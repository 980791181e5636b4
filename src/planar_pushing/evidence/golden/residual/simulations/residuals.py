"""Findings of every variable of a log."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
import xarray as xr

from planar_pushing.evidence.golden.residual.finding import Finding
from planar_pushing.evidence.golden.residual.simulations.entries import Log, read, rounding
from planar_pushing.evidence.golden.residual.simulations.forces import forces
from planar_pushing.evidence.golden.residual.simulations.kinematics import kinematics

#: Roundings of an energy at one instant; part of the relative tolerance of a run that sums lose.
ENERGY, PART = 16, 0.02


def residuals(dataset: xr.Dataset, study: object) -> Iterable[Finding]:
    """Findings of every variable that is no flag and no count."""
    log, radius = read(dataset)
    yield from kinematics(dataset, log, radius)
    yield from forces(dataset, log)
    yield from _energy(dataset, log, radius)


def _energy(dataset: xr.Dataset, log: Log, radius: float) -> Iterable[Finding]:
    """The work of the fence is dissipated, or kinetic energy."""
    half, weights = log.slider.mass * radius / 2, np.array([1.0, 1.0, log.slider.gyration])
    twist = np.column_stack([log.velocity, log.spin])
    kinetic, stored = half * twist**2 @ weights, dataset["kinetic_energy"].values
    yield Finding("kinetic_energy", np.abs(stored - kinetic), rounding(kinetic, ENERGY))
    initial = np.asarray(dataset.attrs["initial_twist"]) / [radius, radius, 1.0]
    given = half * initial**2 @ weights
    rubbed, lost, work = (dataset[n].values for n in ("dissipated", "contact_dissipated", "work"))
    lack = np.abs(work + given - stored - lost - rubbed.sum(axis=1))
    sums = np.abs(work) + given + stored + lost + rubbed.sum(axis=1)
    size = PART * dataset.attrs["rtol"] * sums
    yield Finding("work", lack, size)
    yield Finding("contact_dissipated", lack, size)
    stores = dataset["effect"].values.astype(str) == "inertia"
    idle = np.where(stores & (rubbed != 0), np.inf, 0.0)
    yield Finding("dissipated", np.maximum(lack[:, None], idle), size[:, None])
