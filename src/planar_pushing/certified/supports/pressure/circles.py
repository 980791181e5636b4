"""Rings and uniform discs: D, its slope, and its curvatures along and across the radius."""

from __future__ import annotations

from flint import acb, arb, ctx, fmpq

from planar_pushing.certified import ring as friction

Radial = tuple[arb, arb, arb, arb]
#: Distances, in radii, between which a disc is evaluated by K and E; elsewhere it is evaluated by series.
NEAR = fmpq(1, 2), fmpq(2)


def ring(distance: arb, radius: fmpq) -> Radial:
    """A ring at a distance from its center, by Eqs. (2)-(3) at the spin ratio R / c."""
    c = distance / radius
    if c.is_zero():
        return arb(radius), arb(0), arb(fmpq(1, 2)) / radius, arb(fmpq(1, 2)) / radius
    k = 1 / c
    slope, torque = friction.profile(k)
    along = k * k * k * _rise(k)
    return radius * (torque + c * slope), slope, along / radius, slope / distance


def _rise(k: arb) -> arb:
    """t'(k) over a ball, which is infinite at 1."""
    low, high = k.lower(), k.upper()
    if not (high < 1 or low > 1):
        return arb.pos_inf()
    return friction.least_slope(low, high).union(friction.greatest_slope(low, high))


def disc(distance: arb, radius: fmpq) -> Radial:
    """A uniform disc at a distance from its center."""
    c = distance / radius
    if c.is_zero():
        return arb(radius) * 2 / 3, arb(0), 1 / arb(radius), 1 / arb(radius)
    if c < NEAR[0]:
        whole, slope, along = _inside(c)
    elif c > NEAR[1]:
        whole, slope, along = _outside(c)
    else:
        whole, slope, inverse = _at_rim(c)
        along = inverse - slope / c
    return radius * whole, slope, along / radius, slope / distance


def _inside(c: arb) -> tuple[arb, arb, arb]:
    """D, |G| and its slope, by power series in the distance."""
    m, half = c * c, fmpq(1, 2)
    slope, rise = _series(-half, half, 2, m), -_series(half, 3 * half, 3, m) / 8
    return _series(-half, -3 * half, 1, m) * 2 / 3, c * slope, slope + 2 * m * rise


def _outside(c: arb) -> tuple[arb, arb, arb]:
    """D, |G| and its slope, by power series in the inverse distance."""
    y, half = 1 / (c * c), fmpq(1, 2)
    slope, rise = _series(-half, half, 2, y), -_series(half, 3 * half, 3, y) / 8
    return c * _series(-half, -half, 2, y), slope, -2 * rise * y / c


def _series(a: fmpq, b: fmpq, c: int, z: arb) -> arb:
    return z.hypgeom_2f1(arb(a), arb(b), arb(c))


def _at_rim(c: arb) -> tuple[arb, arb, arb]:
    """D, |G| and the mean of 1 / rho, by elliptic integrals.

    On the rim K is infinite, but its factors vanish, and the limits are exact. D and |G| increase with
    the distance and the mean of 1 / rho decreases, so that the ends of a ball across the rim enclose
    them.
    """
    if not c.is_exact() and (c * c).contains(1):
        with ctx.workprec(3 * ctx.prec):  # separates the ends from the rim
            ends = list(zip(_at_rim(c.lower()), _at_rim(c.upper()), strict=True))
        whole, slope, inverse = (low.union(high) for low, high in ends)
        return whole, slope, inverse
    if c == 1:
        return 32 / (9 * arb.pi()), 8 / (3 * arb.pi()), 4 / arb.pi()
    m = c * c if c < 1 else 1 / (c * c)
    first, second = acb(m).elliptic_k().real, acb(m).elliptic_e().real
    square = c * c
    if c < 1:
        whole = ((7 + square) * second - 4 * (1 - square) * first) * 4 / (9 * arb.pi())
        slope = ((1 + square) * second - (1 - square) * first) * 4 / (3 * arb.pi() * c)
        return whole, slope, 4 * second / arb.pi()
    falls = (square * square + 2 * square - 3) * first / c
    whole = (c * (7 + square) * second - falls) * 4 / (9 * arb.pi())
    slope = ((1 + square) * second - (square - 1) * first) * 4 / (3 * arb.pi())
    return whole, slope, (c * second - (c - 1 / c) * first) * 4 / arb.pi()
