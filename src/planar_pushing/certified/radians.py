"""References in balls for inputs in radians: Arb's elliptic integrals and certified roots.

Lengths are in units of the ring's radius, `rho` is the radius of gyration, `share` that of `inverse`.
"""

from __future__ import annotations

from collections.abc import Callable

from flint import arb

from planar_pushing.certified.inverse import spin_of_arm, sticking_rotation
from planar_pushing.certified.ring import profile
from planar_pushing.certified.roots import increasing_root

#: Relative width of a root's enclosure.
WIDTH = arb(2) ** -145


def force(k: arb) -> arb:
    """f(k), Eq. (2)."""
    return profile(abs(k))[0]


def torque(k: arb) -> arb:
    """t(k), Eq. (3)."""
    size = profile(abs(k))[1]
    return size if k >= 0 else -size


def root(function: Callable[[arb], arb], low: arb, high: arb) -> arb:
    """Root of an increasing function, to the stored digits; the ends are rounded outward."""
    return increasing_root(function, low.lower(), high.upper(), WIDTH)


def friction_spin(arm: arb) -> arb:
    """Spin ratio under friction alone, Eq. (7)."""
    return spin_of_arm(arm, arb(1), arb(0), WIDTH)


def spin(length: arb, psi: arb, phi: arb, share: arb, rho: arb) -> arb:
    """Spin ratio under a force at the angle phi, Eq. (10) for the arm."""
    return spin_of_arm(length * (psi - phi).sin(), rho * rho, share, WIDTH)


def motion_angle(length: arb, psi: arb, phi: arb, share: arb, rho: arb) -> arb:
    """Angle of the contact's motion, Eqs. (11)-(12), on the branch within 90 degrees of the force."""
    pull = length * spin(length, psi, phi, share, rho)
    lean = psi - phi
    return phi - (pull * lean.cos() / (1 + pull * lean.sin())).atan()


def friction_edge(mu: arb, side: int) -> arb:
    """Edge of the friction cone, side 1 for the right and -1 for the left one."""
    half = arb.pi() / 2 if not mu.is_finite() else mu.atan()
    return arb.pi() / 2 - side * half


def motion_edge(length: arb, psi: arb, mu: arb, share: arb, rho: arb, side: int) -> arb:
    """Edge of the motion cone for one share."""
    return motion_angle(length, psi, friction_edge(mu, side), share, rho)


def sticking_spin(length: arb, psi: arb, pusher: arb, ratio: arb, rho: arb) -> arb:
    """Spin ratio of the motion whose contact moves as the pusher does, by ``m a / W = ratio``.

    The torque about the contact increases with the rotation; friction alone has the ratio 0.
    """
    along, aside = (psi - pusher).cos(), (psi - pusher).sin()
    omega = sticking_rotation(along, aside, length, rho * rho, ratio, WIDTH)
    across = aside - length * omega
    return omega / (along * along + across * across).sqrt()


def slip_spin(arm: arb, normal: arb, lever: arb, level: arb, low: arb, high: arb) -> arb:
    """Spin ratio between `low` and `high` at which ``n . u = level``, for rho = R, in units of W / m."""

    def surplus(k: arb) -> arb:
        f, t = profile(k)
        return (t - arm * f) * (normal - lever * k) + level * (k - arm)

    if surplus(low.mid()) < 0:
        return root(surplus, low, high)
    return root(lambda k: -surplus(k), low, high)
