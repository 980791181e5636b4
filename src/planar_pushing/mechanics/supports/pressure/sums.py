"""Sums over pieces: moments of a piece about its own center, transferred to the support's center.

A piece is a tuple ``D, G_x, G_y, T, D_xx, D_xy, D_yy`` per unit share, for a center of rotation (x, y)
relative to its own center of pressure: mean distance, mean unit vector away from the center of rotation,
torque about the piece's own center of pressure, and second derivatives of D.
"""

from __future__ import annotations

from math import sqrt

from planar_pushing.mechanics.compiled import compiled

NOTHING = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


@compiled
def added(total, share, piece, arm_x, arm_y):
    """Add a piece to the totals; `arm` is its center relative to the point of the total torque."""
    distance, unit_x, unit_y, torque, xx, xy, yy = piece
    return (
        total[0] + share * distance,
        total[1] + share * unit_x,
        total[2] + share * unit_y,
        total[3] + share * (torque + (arm_x * unit_x + arm_y * unit_y)),
        total[4] + share * xx,
        total[5] + share * xy,
        total[6] + share * yy,
    )


@compiled
def turned(x, y, distance, slope, torque, along, across):
    """A piece symmetric about its center, from D and its derivatives along the radius to (x, y).

    `along` is the second radial derivative of D, and `across` the first one divided by the distance.
    """
    far = sqrt(x * x + y * y)
    u_x, u_y = (x / far, y / far) if far > 0.0 else (0.0, 0.0)
    bend = along - across
    xx, xy, yy = across + bend * u_x * u_x, bend * u_x * u_y, across + bend * u_y * u_y
    return distance, -slope * u_x, -slope * u_y, torque, xx, xy, yy
