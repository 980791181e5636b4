"""Friction of the ring by the integrals of Eqs. (1)-(3) as printed: the second route of the golden data.

`acb.integral` encloses them rigorously and shares nothing with the elliptic integrals of the first
route.
"""

from __future__ import annotations

from collections.abc import Callable

from flint import acb, arb, ctx

from planar_pushing.certified.ring import Profile

Integrand = Callable[[acb], acb]


def printed(k: arb) -> Profile:
    """Force and torque over W (and W R), for an exact omega / v = k > 0; both integrands are even."""
    force = _integral(k, lambda theta: 1 + k * theta.cos(), 0, 1)
    torque = _integral(k, lambda theta: k + theta.cos(), 0, 1)
    return force / arb.pi(), torque / arb.pi()


def sideways(k: arb) -> arb:
    """Force along x' over W, Eq. (1), around the whole circle, for an exact k > 0 other than 1."""
    halves = (_integral(k, lambda theta: -k * theta.sin(), start, start + 1) for start in (0, 1))
    return sum(halves, arb(0)) / (2 * arb.pi())


def _integral(k: arb, numerator: Integrand, start: int, end: int) -> arb:
    """Integral of numerator / speed between multiples of pi."""

    def integrand(theta: acb, analytic: bool) -> acb:
        # 1 + k^2 + 2 k cos(theta), written so that balls retain its minimum at theta = pi.
        square = (1 - k) ** 2 + 4 * k * (theta / 2).cos() ** 2
        return numerator(theta) / square.sqrt(analytic=analytic)

    # At most 1 in magnitude, as a component of a unit vector; for k = 1 it is 0/0 at pi.
    gap = arb(2) ** (32 - ctx.prec) if k == 1 else arb(0)
    return acb.integral(integrand, start * arb.pi(), end * arb.pi() - gap).real + arb(0, gap)
