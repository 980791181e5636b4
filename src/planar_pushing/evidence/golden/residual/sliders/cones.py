"""Motion cones of any support: every edge enclosed anew, pivots decided by the force at the point."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.certified.balls import precise
from planar_pushing.certified.effects.cone_edges import Edge
from planar_pushing.evidence.golden.residual.edges import ALONG, EDGE
from planar_pushing.evidence.golden.residual.finding import DEGREE, EPSILON, Finding, same
from planar_pushing.evidence.golden.residual.sliders.gallery import (
    SIDES,
    edges,
    expected_pivot,
    gap,
    rods,
)


@precise
def residuals(dataset: xr.Dataset, study: Any) -> Iterable[Finding]:
    """Findings of every variable."""
    stored, stored_pivot = dataset["motion_angle"].values, dataset["pivot"].values
    angle, middle, pivot = np.zeros(stored.shape), np.zeros(stored.shape), np.zeros(stored.shape)
    for rod in rods(dataset, study):
        for i, friction in enumerate(dataset["friction_coefficient"].values):
            found = edges(rod, friction)
            for j, name in enumerate(dataset["edge"].values.astype(str)):
                at, place = found[SIDES[name]], (*rod.place, i, j)
                angle[place] = outside(stored[place], at)
                middle[place] = float(at.angle)
                pivot[place] = expected_pivot(rod, friction, SIDES[name], stored_pivot[place])
    length = dataset["rod_length"].values.reshape(1, -1, 1, 1, 1)
    rounding = EDGE * (1 + length**2) * EPSILON * DEGREE
    right, left = middle[..., 0], middle[..., 1]
    return [
        Finding("motion_angle", angle, rounding),
        same("pivot", stored_pivot, pivot),
        Finding("width", np.abs(dataset["width"].values - (left - right)), 2 * rounding[..., 0]),
        same("pulls", dataset["pulls"].values, _leaves(right, left)),
        same("slips_while_pushing", dataset["slips_while_pushing"].values, _omits(right, left)),
    ]


def outside(stored: float, at: Edge) -> float:
    """How far an angle is off the motions at an edge, degrees."""
    if at.low < stored < at.high:
        return 0.0
    return min(gap(stored, at.low), gap(stored, at.high))


def _leaves(right: Any, left: Any) -> Any:
    """Whether a cone holds motions away from the slider."""
    return (right < -ALONG * DEGREE) | (left > 180 + ALONG * DEGREE)


def _omits(right: Any, left: Any) -> Any:
    """Whether a cone leaves out motions into the slider."""
    return (right > ALONG * DEGREE) | (left < 180 - ALONG * DEGREE)
