"""Friction of the ring by the integrals of Eqs. (2)-(3) as printed: the second route of the golden data.

`acb.integral` encloses them rigorously and shares nothing with the elliptic integrals of the first.
"""

from __future__ import annotations

from flint import acb, arb, ctx

from planar_pushing.golden.ring import Profile


def printed(k: arb) -> Profile:
    """Force and torque of the ring over W (and W R), with omega / v = k > 0 exact."""

    def root(theta: acb, analytic: bool) -> acb:
        # 1 + k^2 + 2 k cos(theta), written so that balls keep its minimum at theta = pi.
        return ((1 - k) ** 2 + 4 * k * (theta / 2).cos() ** 2).sqrt(analytic=analytic)

    def force(theta: acb, analytic: bool) -> acb:
        return (1 + k * theta.cos()) / root(theta, analytic)

    def torque(theta: acb, analytic: bool) -> acb:
        return (k + theta.cos()) / root(theta, analytic)

    # Both are even about theta = pi and parts of a unit vector; at k = 1 they are 0/0 at pi itself.
    gap = arb(2) ** (32 - ctx.prec) if k == 1 else arb(0)
    rest = arb(0, gap)
    found = (acb.integral(each, 0, arb.pi() - gap).real + rest for each in (force, torque))
    first, second = (each / arb.pi() for each in found)
    return first, second
