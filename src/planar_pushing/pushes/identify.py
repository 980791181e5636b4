"""`identify`: the support of a slider from its measured pushes."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.supports import Points
from planar_pushing.pushes.fit.candidates import FAMILIES, Family
from planar_pushing.pushes.fit.estimate import Estimate, from_forces, from_motions
from planar_pushing.pushes.identified import Identified, moments_of, summary
from planar_pushing.pushes.logs.arguments import MOST, whole_number
from planar_pushing.pushes.logs.combine import with_outline
from planar_pushing.pushes.logs.measured import Index, Mask, Measured, measurements_of
from planar_pushing.pushes.logs.schema import require_pushes
from planar_pushing.terms.errors import (
    InvalidValue,
    number_of,
    require_flag,
    require_name,
    require_number,
)

#: Default candidates along the outline's extent, with and without forces; fewer if there are few pushes.
WITH_FORCES, WITHOUT = 15, 5
#: Most columns of a family per push; with forces, the condition of weights >= 0 determines the others.
COLUMNS_WITH_FORCES, COLUMNS_WITHOUT = 12.0, 2.5
#: Ends of the intervals, in percent.
ENDS = 5.0, 95.0
#: A weight below this fraction of the whole counts as zero.
LEAST = 1e-4
#: Most candidates along the outline's extent.
MOST_PARTS = 100


def identify(
    pushes: xr.Dataset,
    outline: Any = None,
    *,
    spacing: float | None = None,
    known: Any = None,
    family: str = "points",
    resamples: int = 200,
    seed: int = 0,
    progress: bool = False,
) -> Identified:
    """Identify the support of an object from measured pushes.

    Parameters
    ----------
    pushes : xarray.Dataset
        Pushes of one object (`load_pushes`, `pushes_from_poses`).
    outline : array_like, shape (n, 2), Polygon, Disc, Outline, or a polygon of shapely, optional
        Outline of the object in its frame; by default that of the dataset.
    spacing : float, optional
        Distance between candidate points, from a hundredth of the outline's extent to the full extent; by
        default a fifteenth of it with forces and a fifth without, or more if there are few pushes.
    known : Points, or array_like of shape (n, 2), optional
        Positions of the feet, if only their weights are unknown.
    family : {"points", "uniform_and_corners", "ellipse", "map"}
        Family of supports to search: a weight at each candidate; a uniform pressure and a weight at each
        corner, and along arcs; uniform pressures within ellipses; or a pressure that varies linearly
        between candidates.
    resamples : int
        Number of resamples of the pushes for the intervals.
    seed : int
        Seed of the resampling.
    progress : bool
        Whether to show a progress bar.

    Returns
    -------
    Identified

    Raises
    ------
    InvalidValue
        If the pushes are of several objects or too few for the candidates, or a value is not allowed.

    Notes
    -----
    At a measured twist t, each load is linear in the weights, ``w = sum_j p_j l(r_j, t)``. With forces, the
    weights therefore follow by least squares over p >= 0, with residuals in standard deviations. A point
    that moves less than the uncertainty of its motion carries any force up to p_j. The residual is then the
    distance from the set of these loads, and the problem is a cone program. Without forces, the weights and
    the contact friction are those for which simulated pushes (`simulate_batch`) end closest to the measured
    poses; in them the finger follows the outline, around corners and arcs. If only some pushes have forces,
    both methods are combined. Final poses of pushes that touch a corner first are not used.
    """
    checked = require_pushes(pushes)
    every = measurements_of(checked if outline is None else with_outline(checked, outline))
    return identify_measured(
        every, spacing=spacing, known=known, family=family, resamples=resamples, seed=seed,
        progress=progress,
    )  # fmt: skip


def identify_measured(
    every: Measured,
    *,
    spacing: float | None = None,
    known: Any = None,
    family: str = "points",
    resamples: int = 200,
    seed: int = 0,
    progress: bool = False,
) -> Identified:
    """The support of an object from its pushes as arrays; options and errors as in `identify`."""
    count = whole_number("resamples", resamples, 1, MOST)
    require_flag("progress", progress)
    generator = np.random.default_rng(whole_number("seed", seed, 0))
    forced = every.has_force
    posed = ~forced & ~every.at_corner
    if not (forced | posed).any():
        raise InvalidValue(
            "pushes", "pushes that touch a corner first", "some that touch a side or have a force",
            "push the sides of the object",
        )  # fmt: skip
    chosen, distance = _family(every, forced, posed, spacing, known, family)
    parts, first = [], None
    if forced.any():
        first = from_forces(every.part(forced), chosen, count, generator)
        parts.append((forced, first[0]))
    if posed.any():
        parts.append(
            (posed, from_motions(every.part(posed), chosen, first, count, generator, progress))
        )
    residuals, facet = np.full(len(every), np.nan), np.full(len(every), -1)
    for rows, part in parts:
        residuals[rows], facet[rows] = part.residuals, part.facet
    return _result(every, chosen, distance, parts[-1][1], residuals, facet)


def _family(
    pushes: Measured, forced: Mask, posed: Mask, spacing: float | None, known: Any, name: str
) -> tuple[Family, float]:
    """Candidates that are few enough for the pushes, and their spacing."""
    distance = None if spacing is None else _required_spacing(spacing, pushes.size)
    if known is not None:
        places = np.array((known if isinstance(known, Points) else Points(known)).positions)
        return Family(places, np.eye(len(places))), distance or pushes.size / WITH_FORCES
    require_name("family", name, FAMILIES, "name one of these families")
    with_forces, without = int(forced.sum()), int(posed.sum())
    most = COLUMNS_WITH_FORCES * with_forces + COLUMNS_WITHOUT * without
    if distance is not None:
        family = FAMILIES[name](pushes.outline, distance)
        _require_enough(family, most, with_forces + without)
        return family, distance
    for parts in range(WITH_FORCES if with_forces else WITHOUT, 0, -1):
        family = FAMILIES[name](pushes.outline, pushes.size / parts)
        if family.columns.shape[1] <= most:
            break
    _require_enough(family, most, with_forces + without)
    return family, pushes.size / parts


def _required_spacing(value: Any, size: float) -> float:
    """Return a spacing from a hundredth of the outline's extent to its extent, or raise `InvalidValue`."""
    smallest, largest = (float(f"{bound:.6g}") for bound in (size / MOST_PARTS, size))
    return require_number(
        "spacing",
        value,
        lambda x: smallest <= x <= largest,
        f"a number from {smallest:g} to {largest:g}, a hundredth of the outline's extent to all of it",
        "give a distance in the outline's unit",
    )


def _require_enough(family: Family, most: float, pushes: int) -> None:
    """Refuse more candidates than the pushes can distinguish."""
    count = family.columns.shape[1]
    if count > most:
        raise InvalidValue(
            "pushes", f"{number_of(pushes, 'push')} for {number_of(count, 'candidate')}",
            f"at most {number_of(int(most), 'candidate')} for them",
            "measure more pushes, give a larger spacing, or choose the family uniform_and_corners",
        )  # fmt: skip


def _result(
    pushes: Measured,
    family: Family,
    spacing: float,
    estimate: Estimate,
    residuals: Array,
    facet: Index,
) -> Identified:
    """Result with the places that carry weight."""
    weights = family.columns @ estimate.amounts
    kept = weights > LEAST * weights.sum()
    places, carried = family.places[kept], weights[kept] / weights[kept].sum()
    drawn = estimate.draws @ family.columns.T
    forces = not any(doubt.startswith("weight") for doubt in estimate.doubts)
    rows = [
        summary(family.places, row, float(row.sum()) if forces else np.nan, mu)
        for row, mu in zip(drawn, estimate.frictions, strict=True)
    ]
    intervals = {
        name: (float(low), float(high))
        for name in rows[0]
        for low, high in (np.percentile([row[name] for row in rows], ENDS),)
    }
    center, torque = moments_of(family.places, weights)
    shares = np.maximum(drawn[:, kept] / drawn.sum(axis=1, keepdims=True), 0.0)
    number = np.cumsum(kept) - 1
    return Identified(
        support=Points(places, carried), weight=float(weights.sum()) if forces else np.nan,
        contact_friction=estimate.friction, center_of_pressure=center, spin_torque=torque,
        intervals=intervals, weight_intervals=np.percentile(shares, ENDS, axis=0).T,
        residuals=residuals, facet=np.where((facet >= 0) & kept[facet], number[facet], -1),
        length=pushes.length, spacing=spacing, optimality=estimate.optimality,
        undetermined=(*estimate.doubts, *_undetermined_weights(estimate)),
    )  # fmt: skip


def _undetermined_weights(estimate: Estimate) -> tuple[str, ...]:
    """A sentence if the pushes determine fewer combinations of weights than there are candidates."""
    count, combinations = len(estimate.amounts), int((estimate.signals > 1.0).sum())
    if combinations >= count:
        return ()
    return (
        f"weights of single points: the pushes determine {combinations} combinations of {count} "
        "candidates; the others follow from weights >= 0",
    )  # fmt: skip
