"""A uniform disc: the flat base of a can."""

from __future__ import annotations

from math import sqrt

import numpy as np

from planar_pushing.simulation.legacy.compiled import compiled, inlined
from planar_pushing.simulation.legacy.pieces import added, turned
from planar_pushing.simulation.legacy.pressure import DISCS, PLATES
from planar_pushing.simulation.legacy.ring import inner, polynomial

#: Beyond this distance, in radii, the torque is a power series, because the closed form cancels.
SERIES = 4.0
#: ``2F1(1/2, 1/2; 3; y) / 4``, the torque times the distance, in powers of y = 1 / c^2, and ``-c^3`` times
#: the derivative of the torque with respect to c; accurate to 1e-17 for y below 1 / SERIES^2.
TORQUE = tuple(
    (np.cumprod([1.0, *((j + 0.5) ** 2 / ((j + 3) * (j + 1)) for j in range(11))]) / 4).tolist()
)
SLOPE = tuple((2 * j + 1) * each for j, each in enumerate(TORQUE))


@inlined
def of_discs(total, pressure, x, y):
    """Add the discs to the totals, whose torque is about p."""
    rows, p_x, p_y = pressure.rows, pressure.center_x, pressure.center_y
    for i in range(pressure.starts[DISCS], pressure.starts[PLATES]):
        q_x, q_y, radius, share = rows[i, 0], rows[i, 1], rows[i, 2], rows[i, 3]
        total = added(total, share, disc(x - q_x, y - q_y, radius), q_x - p_x, q_y - p_y)
    return total


@compiled
def disc(x, y, radius):
    """The piece of a uniform disc.

    The formulas use f and t of the ring at the ratio of c and R instead of E and K, so that D and G contain
    no differences. The mean of 1 / rho, 2 f inside and 2 t outside, is the sum of the two curvatures.
    """
    c = sqrt(x * x + y * y) / radius
    distance, slope, torque, along, across = _inside(c) if c <= 1.0 else _outside(c)
    return turned(x, y, radius * distance, slope, radius * torque, along / radius, across / radius)


@compiled
def _inside(c):
    f, t, _ = inner(c, 1.0)
    across = 2.0 / 3.0 * (f + (t / c if c > 0.0 else 0.5))
    distance = 2.0 / 9.0 * ((3.0 + c * c) * f + 4.0 * c * t)
    torque = 2.0 / 9.0 * ((3.0 - 2.0 * c * c) * f + c * t)
    return distance, 2.0 / 3.0 * (c * f + t), torque, 2.0 * f - across, across


@compiled
def _outside(c):
    f, t, _ = inner(1.0, c)
    slope = 2.0 / 3.0 * (f + c * t)
    distance = 2.0 / 9.0 * (4.0 * c * f + (3.0 + c * c) * t)
    if c < SERIES:
        torque = 2.0 / 9.0 * (c * f + (3.0 - 2.0 * c * c) * t)
        return distance, slope, torque, 2.0 * t - slope / c, slope / c
    y = 1.0 / (c * c)
    return distance, slope, polynomial(TORQUE, y) / c, polynomial(SLOPE, y) / c * y, slope / c
