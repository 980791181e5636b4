"""Quasi-static motion within one mode as integrals over the spin ratio, enclosed by `acb.integral`.

With friction alone the moment arm is ``h = H(k)``, ``H = t / f``, so a mode in which the fence's velocity
is constant is known in terms of k. Angles are radians, lengths in units of R, 0 < k < 1 throughout.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

from flint import acb, arb, fmpq

from planar_pushing.certified import ring
from planar_pushing.certified.balls import Undecided
from planar_pushing.certified.roots import increasing_root

#: Ends of the range of spin ratios that the quadrature covers.
LEAST, MOST = arb(2) ** -20, 1 - arb(2) ** -20
#: Parts of a span of k on which a condition is shown by balls.
PARTS = 32


def arm(k: arb) -> arb:
    """Moment arm H(k) of a real spin ratio."""
    force, torque = ring.profile(k)
    return torque / force


def _arm(k: acb, analytic: bool) -> tuple[acb, acb]:
    """H and its derivative at a complex k, by Gauss's series, which stay narrow on wide balls."""
    m, half = k * k, acb(0.5)
    if analytic and m.imag.contains(0) and not m.real < 1:
        return acb("nan"), acb("nan")
    force = m.hypgeom_2f1(-half, half, acb(1))
    torque = k / 2 * m.hypgeom_2f1(half, half, acb(2))
    rise = m.hypgeom_2f1(half, 3 * half, acb(2)) / 2
    return torque / force, rise * (force + k * torque) / (force * force)


def _integral(integrand: Callable[[acb, bool], acb], start: arb, end: arb) -> arb:
    found = acb.integral(integrand, start, end).real
    if not found.is_finite():
        raise Undecided(f"no enclosure of an integral from {start} to {end}")
    return found


def stick_angle(length: fmpq, k: arb) -> arb:
    """Angle from the contact's velocity to the rod, below a quarter turn, where the contact sticks.

    In the axes of the rod the contact moves by ``(cos g, sin g + k l)`` with ``l sin g = H(k)``.
    """
    sine = arm(k) / length
    return ((sine + k * length) / (1 - sine * sine).sqrt()).atan()


def stick_spin(length: fmpq, angle: arb, width: arb) -> arb:
    """Spin ratio at an angle from the contact's velocity to the rod; it increases with it."""
    return increasing_root(lambda k: stick_angle(length, k) - angle, LEAST, MOST, width)


def stick_time(length: fmpq, start: arb, end: arb) -> arb:
    """Path of the fence, or time at unit speed, while k goes from one value to another.

    ``d path = d angle / omega``, where omega is ``k / size`` for a contact of unit speed.
    """

    def integrand(k: acb, analytic: bool) -> acb:
        h, rise = _arm(k, analytic)
        sine, slope = h / length, rise / length
        cosine = (1 - sine * sine).sqrt(analytic=analytic)
        across, square = sine + k * length, 1 + 2 * k * h + (k * length) ** 2
        turn = ((slope + length) * cosine + across * sine * slope / cosine) / square
        return turn * square.sqrt(analytic=analytic) / k

    return _integral(integrand, start, end)


def slide_path(length: fmpq, start: arb, end: arb) -> arb:
    """Path of the ring center under a force along the fence, while 1 / |k| goes between two values.

    It is the integral of ``d psi / k`` with ``l sin psi = H(|k|) = 1 / H(1 / |k|)``, a rod angle below
    90 degrees.
    """

    def integrand(q: acb, analytic: bool) -> acb:
        h, rise = _arm(q, analytic)
        sine = 1 / (length * h)
        cosine = (1 - sine * sine).sqrt(analytic=analytic)
        return q * rise / (length * h * h * cosine)

    return _integral(integrand, start, end)


def slide_spin(length: fmpq, sine: arb) -> arb:
    """Inverse spin ratio 1 / |k| under a force along the fence, at a sine of the rod angle."""
    wanted = 1 / (length * sine)
    return increasing_root(lambda q: arm(q) - wanted, LEAST, MOST)


def holds(condition: Callable[[arb], bool], low: arb, high: arb) -> None:
    """Show a condition on a span of k by balls that cover it.

    Raises
    ------
    Undecided
        Where a ball does not meet the condition.
    """
    ends = [low.lower() + (high.upper() - low.lower()) * i / PARTS for i in range(PARTS + 1)]
    for a, b in pairwise(ends):
        if not condition(a.union(b)):
            raise Undecided(f"the condition of the mode is open at k in {a.union(b)}")
