"""The integrals of Eqs. (2)-(3) as printed, enclosed by `acb.integral`, with W = R = 1."""

from __future__ import annotations

from collections.abc import Callable

from flint import acb, arb

Integrand = Callable[[acb], acb]


def printed(k: arb) -> tuple[arb, arb]:
    """Force and torque for an exact omega / v = k > 0 other than 1; both integrands are even."""
    return _mean(k, lambda theta: 1 + k * theta.cos()), _mean(k, lambda theta: k + theta.cos())


def sideways(k: arb) -> arb:
    """Force along x', Eq. (1), over the whole circle."""
    first, second = (
        _integral(k, lambda theta: -k * theta.sin(), start, start + 1) for start in (0, 1)
    )
    return (first + second) / (2 * arb.pi())


def _mean(k: arb, numerator: Integrand) -> arb:
    return _integral(k, numerator, 0, 1) / arb.pi()


def _integral(k: arb, numerator: Integrand, start: int, end: int) -> arb:
    """Integral of numerator / speed between multiples of pi."""

    def integrand(theta: acb, analytic: bool) -> acb:
        # 1 + k^2 + 2 k cos(theta), written so that balls keep its minimum at theta = pi.
        square = (1 - k) ** 2 + 4 * k * (theta / 2).cos() ** 2
        return numerator(theta) / square.sqrt(analytic=analytic)

    return acb.integral(integrand, start * arb.pi(), end * arb.pi()).real
