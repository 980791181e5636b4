"""Means over uniform rings and discs, for any center of rotation."""

from __future__ import annotations

from math import sqrt

from planar_pushing.core.supports.ring import inner_ring, polynomial, ring_wrench
from planar_pushing.core.supports.sums import Piece, radial_piece

#: Beyond this distance, in radii, the torque of a disc is a power series, because the closed form loses
#: digits to cancellation.
DISC_SERIES = 4.0
#: ``2F1(1/2, 1/2; 3; y) / 4``, the torque times the distance, in powers of y = 1 / c^2, and ``-c^3`` times
#: the derivative of the torque with respect to c; accurate to 1e-17 for y below 1 / DISC_SERIES^2.
DISC_TORQUE = (
    0.25, 0.020833333333333332, 0.005859375, 0.00244140625, 0.0012461344401041665,
    0.000720977783203125, 0.00045436620712280273, 0.0003047138452529907, 0.0002142519224435091,
    0.0001563606201671064, 0.00011759621641734459, 9.06642158042814e-05,
)  # fmt: skip
DISC_SLOPE = (
    0.25, 0.0625, 0.029296875, 0.01708984375, 0.011215209960937498, 0.007930755615234375,
    0.0059067606925964355, 0.004570707678794861, 0.0036422826815396547, 0.0029708517831750214,
    0.0024695205447642365, 0.002085276963498472,
)  # fmt: skip


def ring_piece(x: float, y: float, radius: float) -> Piece:
    """The piece of a uniform ring: Eqs. (2)-(3) at the spin ratio R / c."""
    c = sqrt(x * x + y * y) / radius
    curve = ring_wrench(c, 1.0)
    force, torque, slope = curve.force, curve.torque, curve.slope
    along = slope if c < 1.0 else slope / (c * c * c)
    across = force / c if c > 0.0 else 0.5
    distance = radius * (torque + c * force)
    return radial_piece(
        x,
        y,
        distance,
        slope=force,
        torque=radius * torque,
        along=along / radius,
        across=across / radius,
    )


def disc_piece(x: float, y: float, radius: float) -> Piece:
    """The piece of a uniform disc.

    The formulas use f and t of the ring at the ratio of c and R instead of E and K, so that D and G contain
    no differences. The mean of 1 / rho, 2 f inside and 2 t outside, is the sum of the two curvatures.
    """
    c = sqrt(x * x + y * y) / radius
    distance, slope, torque, along, across = inner_disc(c) if c <= 1.0 else outer_disc(c)
    return radial_piece(
        x,
        y,
        distance=radius * distance,
        slope=slope,
        torque=radius * torque,
        along=along / radius,
        across=across / radius,
    )


def inner_disc(c: float) -> tuple[float, float, float, float, float]:
    """D, its radial derivative, torque and curvatures along and across, c <= 1 radii from the center."""
    curve = inner_ring(c, 1.0)
    f, t = curve.force, curve.torque
    across = 2.0 / 3.0 * (f + (t / c if c > 0.0 else 0.5))
    distance = 2.0 / 9.0 * ((3.0 + c * c) * f + 4.0 * c * t)
    torque = 2.0 / 9.0 * ((3.0 - 2.0 * c * c) * f + c * t)
    return distance, 2.0 / 3.0 * (c * f + t), torque, 2.0 * f - across, across


def outer_disc(c: float) -> tuple[float, float, float, float, float]:
    """The numbers of `inner_disc` at a point more than one radius from the center."""
    curve = inner_ring(1.0, c)
    f, t = curve.force, curve.torque
    slope = 2.0 / 3.0 * (f + c * t)
    distance = 2.0 / 9.0 * (4.0 * c * f + (3.0 + c * c) * t)
    if c < DISC_SERIES:
        torque = 2.0 / 9.0 * (c * f + (3.0 - 2.0 * c * c) * t)
        return distance, slope, torque, 2.0 * t - slope / c, slope / c
    y = 1.0 / (c * c)
    torque = polynomial(DISC_TORQUE, len(DISC_TORQUE), y) / c
    return distance, slope, torque, polynomial(DISC_SLOPE, len(DISC_SLOPE), y) / c * y, slope / c
