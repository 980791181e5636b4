"""Regions of acceleration centers: ends of the paper's bound and of the exact set (Sec. 4, Fig. 12)."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from planar_pushing.certified.doubled.angles import cosine_sine, radians
from planar_pushing.certified.doubled.numbers import Doubled, Floats, doubled
from planar_pushing.evidence.golden.residual.centers import center, distance, gap
from planar_pushing.evidence.golden.residual.finding import EPSILON, Finding
from planar_pushing.evidence.golden.residual.grids import along, slider_of
from planar_pushing.evidence.golden.residual.motion import line_at
from planar_pushing.evidence.golden.residual.spin import spin_ratio, steady
from planar_pushing.study.files.study_model import StudyFile

#: Roundings of a center, and of the moment arm of a line that touches the ring.
CENTER, TOUCH = 64, 64


class Lines(NamedTuple):
    """Lines of force through the contact: their angle, moment arm in units of R, and the ring center."""

    angle: Doubled
    arm: Doubled
    length: Floats
    ring: list[Doubled]


def residuals(dataset: xr.Dataset, study: StudyFile) -> Iterable[Finding]:
    """Findings of every variable."""
    length, psi, phi = along(dataset, "rod_length", "rod_angle", "force_angle")
    radius, slider = study.slider.radius, slider_of(study)
    ring = [part * length for part in cosine_sine(radians(psi))]
    arm = line_at(psi, phi).aside * (length / radius)
    lines = Lines(radians(phi), arm, length, ring)
    yield from _findings(dataset, "bound", lines, _bound(lines, radius))
    kinds = dataset["exact_end"].values.astype(str)
    spins = [spin_ratio(steady(each, slider), slider, arm) for each in kinds]
    yield from _findings(dataset, "exact", lines, [distance(k, radius) for k in spins])


def _bound(lines: Lines, radius: float) -> list[Doubled]:
    """Distances of the inner and the outer end from the ring center along x' (Sec. 4).

    A line that misses the ring has its centers inside the ring, one that meets it outside, one that
    touches it on the ring; they lie on the side of x' that the moment arm turns to.
    """
    size = abs(lines.arm)
    beyond = (size - 1.0).value()
    touches = np.abs(beyond) <= TOUCH * EPSILON * np.maximum(lines.length / radius, 1.0)
    misses, through = (beyond > 0) & ~touches, (beyond < 0) & ~touches
    still = size.high == 0
    inner = np.where(still, np.inf, np.where(misses, 0.0, 1.0))
    outer = np.where(through, np.inf, 1.0)
    side = np.where(lines.arm.high < 0, 1.0, -1.0)
    return [doubled(each * side * radius) for each in (inner, outer)]


def _findings(
    dataset: xr.Dataset, name: str, lines: Lines, ends: list[Doubled]
) -> Iterable[Finding]:
    """Errors of a region's ends, along the last dimension, and what rounding k and angles explains."""
    wanted = [center(lines.ring, lines.angle, each) for each in ends]
    rounding = [_rounding(lines, each) for each in ends]
    for i, across in enumerate("xy"):
        stored = dataset[f"{name}_{across}"].values
        points = np.stack([each[i] for each in wanted], axis=-1)
        allowed = np.stack([each[i] for each in rounding], axis=-1)
        yield Finding(f"{name}_{across}", gap(stored, points), CENTER * EPSILON * allowed)


def _rounding(lines: Lines, away: Doubled) -> list[Any]:
    """Sizes of the parts of a center, along x and y, each with its own rounding."""
    reach = np.where(np.isfinite(away.high), np.abs(away.high), 0.0)
    cosine, sine = cosine_sine(lines.angle)
    sizes = zip(lines.ring, (sine, cosine), strict=True)
    return [np.abs(ring.high) + reach * np.abs(part.high) for ring, part in sizes]
