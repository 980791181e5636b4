"""Moments of a pressure that determine friction at a center of rotation (manual: theory, any support)."""

from __future__ import annotations

from typing import NamedTuple

from planar_pushing.simulation.legacy.compiled import compiled
from planar_pushing.simulation.legacy.disc import of_discs
from planar_pushing.simulation.legacy.pieces import of_atoms, of_plates, of_rings, of_segments


class Moments(NamedTuple):
    """Mean distance to a center of rotation c, its gradient, the torque, and second derivatives.

    Parameters
    ----------
    distance : float
        D, the mean of rho = |r - c|.
    unit_x, unit_y : float
        G, the mean of (r - c) / rho; minus the gradient of D with respect to c.
    torque : float
        T, about the center of pressure p of a slider that turns counterclockwise: ``D + (c - p) . G``.
    xx, xy, yy : float
        Second derivatives of D with respect to c.
    atom : int
        Index of the record's atom at c, or -1. That atom has no direction: it counts in D, and as zero in
        everything else.
    """

    distance: float
    unit_x: float
    unit_y: float
    torque: float
    xx: float
    xy: float
    yy: float
    atom: int


@compiled
def moments_within(pressure, c_x, c_y, blur):
    """As `moments`, for a center known to within `blur`, which is on every atom within that distance."""
    total, atom = of_atoms(pressure, c_x, c_y, blur * blur)
    total = of_segments(total, pressure, c_x, c_y)
    total = of_rings(total, pressure, c_x, c_y)
    total = of_discs(total, pressure, c_x, c_y)
    total = of_plates(total, pressure, c_x, c_y)
    distance, unit_x, unit_y, torque, xx, xy, yy = total
    return Moments(distance, unit_x, unit_y, torque, xx, xy, yy, atom)
