"""Moments of a pressure that determine friction at a center of rotation (manual: theory, any support)."""

from __future__ import annotations

from typing import NamedTuple

from planar_pushing.mechanics.compiled import compiled, kernel
from planar_pushing.mechanics.supports.disc import of_discs
from planar_pushing.mechanics.supports.even_ring import of_rings
from planar_pushing.mechanics.supports.points import of_atoms
from planar_pushing.mechanics.supports.polygon import of_plates
from planar_pushing.mechanics.supports.segment import of_segments


class Moments(NamedTuple):
    """Mean distance to a center of rotation c, its gradient, the torque, and second derivatives.

    Parameters
    ----------
    distance : float
        D, the mean of rho = |r - c|.
    unit_x, unit_y : float
        G, the mean of (r - c) / rho; minus the gradient of D with respect to c.
    torque : float
        T, about the center of pressure p of a slider that turns counter-clockwise: ``D + (c - p) . G``.
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


@kernel
@compiled
def moments(pressure, c_x, c_y):
    """Moments of a pressure at a center of rotation in the body frame, per unit weight.

    Parameters
    ----------
    pressure : Pressure
    c_x, c_y : float
        In units of the slider's radius, up to 1e9 extents away; beyond that, use the limit of a
        translation.

    Returns
    -------
    Moments

    Notes
    -----
    A rotation about c at omega is sustained by the force ``sgn(omega) J G`` (J rotates by +90 degrees: x, y
    to -y, x) and the torque ``sgn(omega) T`` about the center of pressure; its potential is |omega| D. In
    the limit of a translation v, the potential is |v|, the force v / |v|, and the torque zero.
    """
    return moments_within(pressure, c_x, c_y, 0.0)


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
