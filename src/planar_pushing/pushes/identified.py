"""The result of `identify`: the support of an object and how well its pushes determine it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.cluster.hierarchy import fcluster, linkage

from planar_pushing.mechanics.kernels.arrays import same
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.supports import Points
from planar_pushing.pushes.logs.measured import Index
from planar_pushing.terms.errors import number_of

#: A point with less than this fraction of the heaviest point's weight does not belong to a foot.
LIGHT = 0.1


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Identified:
    """The support of an object as identified from its pushes, in the object's frame.

    Attributes
    ----------
    support : Points
        Candidates that carry weight, with weights that add up to 1.
    weight : float
        W = mu_s m g, the weight times the coefficient of support friction, in the unit of force; NaN if no
        force was measured.
    contact_friction : float
        Friction coefficient between finger and object; only a lower bound if `undetermined` says so.
    center_of_pressure : ndarray, shape (2,)
    spin_torque : float
        Mean distance of the pressure from its center, which is the friction torque when spinning about it,
        divided by `weight`.
    intervals : dict
        90 percent confidence intervals (low, high) of `weight`, `contact_friction`, `center_of_pressure_x`,
        `center_of_pressure_y` and `spin_torque`, from resampled pushes.
    weight_intervals : ndarray, shape (points, 2)
        90 percent confidence interval of the weight of each point of the support.
    residuals : ndarray, shape (pushes,)
        Error of each push: of its wrench in standard deviations if its force was measured, otherwise of the
        final pose as a length (distance plus `length` times the angle); NaN for a push that was not used.
    facet : ndarray of int, shape (pushes,)
        Number of the support point about which the object turned, with less than full friction at that
        point; -1 otherwise, and if no force was measured.
    length : float
        Half the outline's extent, which converts angles to lengths and torques to forces.
    spacing : float
        Distance between candidates.
    optimality : float
        Largest violation of the optimality (Karush-Kuhn-Tucker) conditions, relative to the data. With
        forces the problem is convex, so that no better support exists among the candidates.
    undetermined : tuple of str
        One sentence for each quantity that the pushes do not determine.
    """

    support: Points
    weight: float
    contact_friction: float
    center_of_pressure: Array
    spin_torque: float
    intervals: dict[str, tuple[float, float]]
    weight_intervals: Array
    residuals: Array
    facet: Index
    length: float
    spacing: float
    optimality: float
    undetermined: tuple[str, ...]

    def __eq__(self, other: object) -> Any:
        return same(self, other)

    def __repr__(self) -> str:
        x, y = self.center_of_pressure
        return (
            f"Identified({number_of(len(self.support.positions), 'point')}, weight={self.weight:.4g}, "
            f"contact_friction={self.contact_friction:.4g}, center_of_pressure=({x:.4g}, {y:.4g}), "
            f"spin_torque={self.spin_torque:.4g})"
        )

    @property
    def feet(self) -> Points:
        """The support with neighboring points joined, because a foot between candidates loads several.

        Points within two spacings of each other along both axes form one foot at their center of pressure.
        Points with less than a tenth of the weight of the heaviest are omitted because they would link
        separate feet.
        """
        places, weights = np.array(self.support.positions), np.array(self.support.weights)
        kept = weights >= LIGHT * weights.max()
        places, weights = places[kept], weights[kept]
        if len(places) == 1:
            return Points(places, weights)
        groups = fcluster(
            linkage(places, "single", metric="chebyshev"), 2.01 * self.spacing, criterion="distance"
        )
        loads = np.bincount(groups, weights)[1:]
        centers = [np.bincount(groups, weights * column)[1:] / loads for column in places.T]
        return Points(np.column_stack(centers), loads)


def moments_of(places: Array, weights: Array) -> tuple[Array, float]:
    """Center of pressure and mean distance of the pressure from it."""
    share = weights / weights.sum()
    center = share @ places
    return center, float(share @ np.hypot(*(places - center).T))


def summary(places: Array, weights: Array, weight: float, friction: float) -> dict[str, float]:
    """Numbers of a support for which `intervals` has entries."""
    (x, y), torque = moments_of(places, weights)
    return {
        "weight": weight, "contact_friction": friction, "center_of_pressure_x": float(x),
        "center_of_pressure_y": float(y), "spin_torque": torque,
    }  # fmt: skip
