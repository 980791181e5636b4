"""Limit curves: spin ratio, force and motion under each line of force (Eqs. 2-7, Sec. 4)."""

from __future__ import annotations

from collections.abc import Iterable

import xarray as xr

from planar_pushing.certified.doubled.angles import cosine_sine, radians
from planar_pushing.certified.doubled.numbers import doubled
from planar_pushing.evidence.golden.residual.finding import DEGREE, EPSILON, Finding, relative
from planar_pushing.evidence.golden.residual.grids import along, over_effects
from planar_pushing.evidence.golden.residual.motion import (
    Slider,
    angle_error,
    force_and_torque,
    line_at,
    torque_error,
)
from planar_pushing.evidence.golden.residual.spin import on_limit_curve
from planar_pushing.study.files.study_model import StudyFile

#: Roundings of a balance of torques, of a force, of its parts and of an angle in radians.
BALANCE, FORCE, PARTS, ANGLE = 64, 64, 4, 32


def residuals(dataset: xr.Dataset, study: StudyFile) -> Iterable[Finding]:
    """Findings of every variable."""
    return over_effects(_part, dataset, study)


def _part(dataset: xr.Dataset, effects: str, slider: Slider, study: StudyFile) -> Iterable[Finding]:
    length, psi, phi = along(dataset, "rod_length", "rod_angle", "force_angle")
    length = length / study.slider.radius
    line, k = line_at(psi, phi), dataset["spin_ratio"].values
    parts = on_limit_curve(effects, slider)(doubled(k))
    yield Finding(
        "spin_ratio",
        torque_error(parts, slider.gyration, k, line.aside * length),
        BALANCE * EPSILON,
    )
    force, _ = force_and_torque(parts, slider.gyration, k)
    yield relative("force", dataset["force"].values, force, FORCE)
    for name, part in zip(("force_x", "force_y"), cosine_sine(radians(phi)), strict=True):
        yield relative(name, dataset[name].values, part * dataset["force"].values, PARTS)
    motion = dataset["motion_angle"].values
    error = angle_error(motion, phi, line, length, k)
    yield Finding("motion_angle", error * DEGREE, ANGLE * EPSILON * DEGREE)
