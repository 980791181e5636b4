"""Motion cones: edges of the friction cone, and the motions and forces there (Secs. 3.1, 3.2 and 4)."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.certified.doubled.numbers import Doubled
from planar_pushing.evidence.golden.residual.edges import (
    ALONG,
    SIDES,
    friction_edge,
    least_normal_motion,
    motion_edge,
    spin_ratios,
)
from planar_pushing.evidence.golden.residual.finding import Finding, relative, same
from planar_pushing.evidence.golden.residual.grids import along, over_effects
from planar_pushing.evidence.golden.residual.motion import (
    Slider,
    edge,
    force_and_torque,
    line_on_edge,
)
from planar_pushing.evidence.golden.residual.spin import on_limit_curve, spin_ratio
from planar_pushing.study.files.study_model import StudyFile

#: Roundings of a force, for a rod of no length.
FORCE = 64


def residuals(dataset: xr.Dataset, study: StudyFile) -> Iterable[Finding]:
    """Findings of every variable."""
    return over_effects(_part, dataset, study)


def _part(dataset: xr.Dataset, effects: str, slider: Slider, study: StudyFile) -> Iterable[Finding]:
    length, psi, mu = along(dataset, "rod_length", "rod_angle", "friction_coefficient")
    length, normal = length / study.slider.radius, []
    for side, sign in SIDES.items():
        line = line_on_edge(psi, mu, sign)
        spins = spin_ratios(effects, slider, line.aside * length)
        normal.append(least_normal_motion(psi, edge(mu, sign), length, spins))
        forces, motions = (dataset[f"{kind}_cone_{side}"] for kind in ("friction", "motion"))
        yield friction_edge(str(forces.name), forces.values, mu, sign)
        yield motion_edge(
            str(motions.name), motions.values, forces.values, line, length, spins, sign
        )
        yield _force(dataset[f"limit_force_{side}"], effects, slider, line.aside * length, length)
    away, into = np.minimum(*normal) < -ALONG, np.maximum(*normal) > ALONG
    yield same("pulls", dataset["pulls"].values, away)
    yield same("slips_while_pushing", dataset["slips_while_pushing"].values, into)


def _force(
    stored: xr.DataArray, effects: str, slider: Slider, arm: Doubled, length: Any
) -> Finding:
    """Force on the limit curve at an edge."""
    parts = on_limit_curve(effects, slider)
    k = spin_ratio(parts, slider, arm)
    force, _ = force_and_torque(parts(k), slider.gyration, k)
    return relative(str(stored.name), stored.values, force, FORCE * (1 + length))
