"""Acceleration centers with friction and inertia, and the cones of infinite friction (Sec. 4, Fig. 12)."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.certified import cones, setting
from planar_pushing.certified.doubled.angles import cosine_sine, radians
from planar_pushing.certified.doubled.numbers import Doubled, Floats, choose, doubled
from planar_pushing.evidence.golden.residual.edges import (
    EDGE,
    SIDES,
    motion_edge,
    spin_ratios,
)
from planar_pushing.evidence.golden.residual.finding import DEGREE, EPSILON, Finding
from planar_pushing.evidence.golden.residual.grids import along, slider_of
from planar_pushing.evidence.golden.residual.motion import (
    Shares,
    angle_error,
    line_at,
    line_on_edge,
    torque_error,
)
from planar_pushing.study.files.study_model import StudyFile
from planar_pushing.terms.options import EffectSet

#: Roundings of a center, and of an angle in radians.
CENTER, ANGLE = 64, 32


def residuals(dataset: xr.Dataset, study: StudyFile) -> Iterable[Finding]:
    """Findings of every variable."""
    length, phi, share = along(dataset, "rod_length", "force_angle", "inertia_share")
    length, slider = length / study.slider.radius, slider_of(study)
    line = line_at(study.slider.rod_angle, phi)
    arm = line.aside * length + 0.0 * share
    k, off = _spins(_from_ring(dataset, study, length), phi, arm)
    found = np.maximum(off, torque_error(Shares(1 - share, share), slider.gyration, k, arm))
    reach = np.maximum(1.0, length * np.abs(k.high))
    for name in "xy":
        yield Finding(f"center_{name}", found, CENTER * EPSILON * reach)
    error = angle_error(dataset["motion_angle"].values, phi, line, length, k)
    yield Finding("motion_angle", error * DEGREE, ANGLE * EPSILON * DEGREE * reach)
    yield from _exact(dataset, study)
    yield from _conservative(dataset, study)


def _from_ring(dataset: xr.Dataset, study: StudyFile, length: Any) -> list[Doubled]:
    """Centers relative to the ring center, in units of R."""
    center = [doubled(dataset[f"center_{name}"].values / study.slider.radius) for name in "xy"]
    ring = cosine_sine(radians(study.slider.rod_angle))
    with np.errstate(invalid="ignore"):
        moved = [each - part * length for each, part in zip(center, ring, strict=True)]
    return [choose(np.isfinite(a.high), b, a) for a, b in zip(center, moved, strict=True)]


def _spins(center: list[Doubled], force_angle: Any, arm: Doubled) -> tuple[Doubled, Floats]:
    """Spin ratios that put the center at -1/k along x', and how far it is from this line.

    Without a moment arm the slider translates: the center is at infinity along -x', or has no such part.
    """
    cosine, sine = cosine_sine(radians(force_angle))
    x, y = center
    with np.errstate(invalid="ignore"):
        far = [np.where(part.high == 0, 0.0, -np.inf * part.high) for part in (sine, -cosine)]
    still = arm.high == 0
    lost = still & ~((x.high == far[0]) & (y.high == far[1]))
    x, y = (
        choose(still | ~np.isfinite(x.high), sine, x),
        choose(still | ~np.isfinite(y.high), 1.0, y),
    )
    across, beside = x * sine - y * cosine, x * cosine + y * sine
    size = (x * x + y * y).sqrt()
    k = choose(still, 0.0, -1.0 / choose(across.high == 0, 1.0, across))
    off = np.where(still, 0.0, np.abs((beside / size).value()))
    return k, np.where(lost, np.inf, off)


def _exact(dataset: xr.Dataset, study: StudyFile) -> Iterable[Finding]:
    """The exact cone: the union over all magnitudes of the motion."""
    length, psi = dataset["rod_length"].values / study.slider.radius, study.slider.rod_angle
    for side, sign in SIDES.items():
        line = line_on_edge(psi, math.inf, sign)
        spins = spin_ratios(EffectSet.BOTH, slider_of(study), line.aside * length)
        name, force = f"exact_cone_{side}", 90.0 - 90.0 * sign
        yield motion_edge(name, dataset[name].values, force, line, length, spins, sign)


def _conservative(dataset: xr.Dataset, study: StudyFile) -> Iterable[Finding]:
    """The paper's bound, as certified."""
    sliders = [
        setting.Slider.of(float(each), study.slider.rod_angle, radius=study.slider.radius)
        for each in dataset["rod_length"].values
    ]
    found = [cones.conservative_cone(each) for each in sliders]
    for side in SIDES:
        name = f"conservative_cone_{side}"
        wanted = [float(getattr(each, side).mid()) for each in found]
        error = np.abs(dataset[name].values - wanted)
        yield Finding(name, error, EDGE * EPSILON * DEGREE)
