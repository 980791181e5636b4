"""Moments of the supports over centers of rotation, enclosed anew, and the ellipsoids in their place."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
import xarray as xr
from flint import arb

from planar_pushing.certified.balls import precise, rational
from planar_pushing.certified.supports.pressure.moments import moments
from planar_pushing.certified.supports.pressure.pieces import Pieces
from planar_pushing.evidence.golden.residual.finding import DEGREE, EPSILON, Finding
from planar_pushing.evidence.golden.residual.sliders.ellipsoid import ERRORS, errors
from planar_pushing.evidence.golden.residual.sliders.gallery import gallery, gap

#: Roundings of a moment, of a number of a support as a whole, and of a mean over motions.
MOMENT, WHOLE = 32, 8
#: Difference of an ellipsoid's errors, radians, from those by other formulas in doubles: means, maxima.
SAME, LARGEST = 2e-13, 2e-11
MOMENTS = ("mean_distance", "force_x", "force_y", "torque")


def residuals(dataset: xr.Dataset, study: Any) -> Iterable[Finding]:
    """Findings of every variable."""
    supports = [gallery(study)[str(name)] for name in dataset["support"].values]
    yield from _over_centers(dataset, supports)
    yield from _numbers(dataset, supports)
    found = np.array([errors(support) for support in supports])
    for i, name in enumerate(ERRORS):
        allowed = LARGEST if name.startswith("worst") else SAME
        yield Finding(name, np.abs(dataset[name].values - found[:, i] * DEGREE), allowed * DEGREE)


@precise
def _over_centers(dataset: xr.Dataset, supports: list[Pieces]) -> list[Finding]:
    """Mean distance and the wrench that sustains a rotation, at every center."""
    x, y = dataset["center_x"].values, dataset["center_y"].values
    shape = (len(supports), len(x), len(y))
    places = [(rational(a), rational(b)) for a in x for b in y]
    stored = [dataset[name].values.reshape(len(supports), -1) for name in MOMENTS]
    error = np.zeros((len(MOMENTS), len(supports), len(places)))
    for i, support in enumerate(supports):
        for j, place in enumerate(places):
            for part, ball in enumerate(wrench(support, place)):
                error[part, i, j] = gap(stored[part][i, j], ball)
    far = np.hypot(*np.meshgrid(x, y, indexing="ij")) + 1.0
    allowed = {"force_x": 1.0, "force_y": 1.0}
    return [
        Finding(
            name, error[part].reshape(shape), MOMENT * EPSILON * np.asarray(allowed.get(name, far))
        )
        for part, name in enumerate(MOMENTS)
    ]


def wrench(support: Pieces, place: tuple[Any, Any]) -> tuple[arb, arb, arb, arb]:
    """D, and the wrench about the origin of a counter-clockwise rotation about a place, of unit weight."""
    c = arb(place[0]), arb(place[1])
    now = moments(support, c)
    return now.distance, -now.y, now.x, now.torque(c, (arb(0), arb(0)))


@precise
def _numbers(dataset: xr.Dataset, supports: list[Pieces]) -> list[Finding]:
    """Center, extent, integration constant and ellipsoid of each support."""
    rows = [numbers(support) for support in supports]
    found = []
    for name in rows[0]:
        stored = dataset[name].values
        wanted = np.array([row[name] for row in rows], dtype=object).reshape(stored.shape)
        error = np.vectorize(gap, otypes=[float])(stored, wanted)
        size = np.maximum(1.0, np.abs(np.vectorize(float, otypes=[float])(wanted)))
        found.append(Finding(name, error, WHOLE * EPSILON * size))
    return found


def numbers(support: Pieces) -> dict[str, Any]:
    """Numbers of a support as a whole, by their names in the dataset."""
    x, y = support.center
    extent, here = support.extent, moments(support, (arb(x), arb(y))).distance
    zero = arb(0)
    matrix = [[arb(1), zero, zero], [zero, arb(1), zero], [zero, zero, 1 / (here * here)]]
    return {
        "center_of_pressure_x": arb(x),
        "center_of_pressure_y": arb(y),
        "extent": extent,
        "integration_constant": here / extent,
        "ellipsoid": matrix,
    }
