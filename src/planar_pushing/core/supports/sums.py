"""Sums over pieces: moments of a piece about its own center, transferred to the support's center.

All are for a center of rotation (x, y) relative to the piece's own center of pressure, and per unit share
of the weight.
"""

from __future__ import annotations

from math import sqrt
from typing import NamedTuple


class Piece(NamedTuple):
    """Mean distance to a center of rotation c, its gradient, the torque, and second derivatives.

    Parameters
    ----------
    distance : float
        D, the mean of rho = |r - c|.
    unit_x, unit_y : float
        G, the mean of (r - c) / rho; minus the gradient of D with respect to c.
    torque : float
        About the piece's own center of pressure, or for a sum about that of the support.
    xx, xy, yy : float
        Second derivatives of D with respect to c.
    """

    distance: float
    unit_x: float
    unit_y: float
    torque: float
    xx: float
    xy: float
    yy: float


def add_piece(total: Piece, share: float, piece: Piece, arm_x: float, arm_y: float) -> Piece:
    """Totals with a piece added; `arm` is its center relative to the reference point of the torque."""
    return Piece(
        distance=total.distance + share * piece.distance,
        unit_x=total.unit_x + share * piece.unit_x,
        unit_y=total.unit_y + share * piece.unit_y,
        torque=total.torque
        + share * (piece.torque + (arm_x * piece.unit_x + arm_y * piece.unit_y)),
        xx=total.xx + share * piece.xx,
        xy=total.xy + share * piece.xy,
        yy=total.yy + share * piece.yy,
    )


def radial_piece(
    x: float, y: float, distance: float, slope: float, torque: float, along: float, across: float
) -> Piece:
    """A piece symmetric about its center, from D and its derivatives along the radius to (x, y).

    `slope` is the first radial derivative of D, `along` the second one, and `across` the first one divided
    by the distance.
    """
    length = sqrt(x * x + y * y)
    u_x, u_y = 0.0, 0.0
    if length > 0.0:
        u_x, u_y = x / length, y / length
    bend = along - across
    xx, xy, yy = across + bend * u_x * u_x, bend * u_x * u_y, across + bend * u_y * u_y
    return Piece(
        distance, unit_x=-slope * u_x, unit_y=-slope * u_y, torque=torque, xx=xx, xy=xy, yy=yy
    )
