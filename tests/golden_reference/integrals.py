"""Second route of the golden data: the integrals of Eqs. (2)-(3) as printed, enclosed by `acb.integral`."""

from flint import acb, arb, ctx

PRECISION = 192


def profile(k):
    """Force and torque of the ring over W (and W R), with omega / v = k > 0 and k != 1 exact."""

    def root(theta, analytic):
        # 1 + k^2 + 2 k cos(theta), written so that balls keep its minimum at theta = pi.
        return ((1 - k) ** 2 + 4 * k * (theta / 2).cos() ** 2).sqrt(analytic=analytic)

    def force(theta, analytic):
        return (1 + k * theta.cos()) / root(theta, analytic)

    def torque(theta, analytic):
        return (k + theta.cos()) / root(theta, analytic)

    # Both integrands are even about theta = pi.
    return tuple(acb.integral(each, 0, arb.pi()).real / arb.pi() for each in (force, torque))


def imbalance(k, arm):
    """Torque about the contact of Eq. (6), over W R, at a spin ratio and a moment arm."""
    with ctx.workprec(PRECISION):
        force, torque = profile(k)
        return torque - arm * force
