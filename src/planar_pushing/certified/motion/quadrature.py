"""Quasi-static motion within one mode as integrals over the spin ratio, enclosed by `acb.integral`.

With friction alone the moment arm is ``h = H(k)``, ``H = t / f``; a mode with a constant velocity of
the fence is therefore known in terms of k. Angles are in radians and lengths in units of R; 0 < k < 1
throughout.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import NamedTuple

from flint import acb, arb, fmpq

from planar_pushing.certified import ring
from planar_pushing.certified.balls import Undecided
from planar_pushing.certified.roots import increasing_root

Integrand = Callable[[acb, bool], acb]
#: Ends of the range of spin ratios that the quadrature covers.
LEAST, MOST = arb(2) ** -20, 1 - arb(2) ** -20
#: Maximum number of parts of a span of k on which balls show a condition.
PARTS = 32


def arm(k: arb) -> arb:
    """Moment arm H(k) of a real spin ratio."""
    force, torque = ring.profile(k)
    return torque / force


class _Profile(NamedTuple):
    """Force, torque, moment arm H and its derivative at a complex spin ratio."""

    force: acb
    torque: acb
    arm: acb
    rise: acb


def _profile(k: acb, analytic: bool) -> _Profile:
    """The ring by Gauss's series, which remain narrow on wide balls."""
    m, half = k * k, acb(0.5)
    if analytic and m.imag.contains(0) and not m.real < 1:
        return _Profile(*[acb("nan")] * 4)
    force = m.hypgeom_2f1(-half, half, acb(1))
    torque = k / 2 * m.hypgeom_2f1(half, half, acb(2))
    rise = m.hypgeom_2f1(half, 3 * half, acb(2)) / 2
    return _Profile(force, torque, torque / force, rise * (force + k * torque) / (force * force))


class Integral:
    """An integral from a start to a sequence of ends, all of them balls.

    It runs over exact places; their distance from the ends is bounded by the integrand there.
    """

    def __init__(self, integrand: Integrand, start: arb) -> None:
        self.integrand, self.place = integrand, start.mid()
        self.sum = (self.place - start) * self.rate(start)

    def rate(self, place: arb) -> arb:
        """The integrand at a place."""
        return self.integrand(acb(place), False).real

    def to(self, end: arb) -> arb:
        """The integral up to an end; the next one starts there."""
        middle = end.mid()
        if middle != self.place:
            self.sum += _integral(self.integrand, self.place, middle)
            self.place = middle
        return self.sum if end.is_exact() else self.sum + (end - middle) * self.rate(end)


def _integral(integrand: Integrand, start: arb, end: arb) -> arb:
    found = acb.integral(integrand, start, end).real
    if not found.is_finite():
        raise Undecided(f"no enclosure of an integral from {start} to {end}")
    return found


def stick_angle(length: fmpq, k: arb) -> arb:
    """Angle from the contact's velocity to the rod, below 90 degrees, if the contact sticks.

    In the axes of the rod the contact moves by ``(cos g, sin g + k l)`` with ``l sin g = H(k)``.
    """
    sine = arm(k) / length
    return ((sine + k * length) / (1 - sine * sine).sqrt()).atan()


def stick_spin(length: fmpq, angle: arb, width: arb) -> arb:
    """Spin ratio at an angle from the contact's velocity to the rod; it increases with this angle."""
    return increasing_root(lambda k: stick_angle(length, k) - angle, LEAST, MOST, width)


def stick_rates(length: fmpq) -> tuple[Integrand, Integrand]:
    """Derivatives by the spin ratio of the path of the fence, or time at unit speed, and of its work.

    ``d path = d angle / omega``, where omega is ``k / size`` for a contact of unit speed. The work on a
    path is the energy that friction dissipates: ``(f + k t) / size``.
    """

    def turn(k: acb, now: _Profile, analytic: bool) -> tuple[acb, acb]:
        sine, slope = now.arm / length, now.rise / length
        cosine = (1 - sine * sine).sqrt(analytic=analytic)
        across, square = sine + k * length, 1 + 2 * k * now.arm + (k * length) ** 2
        return ((slope + length) * cosine + across * sine * slope / cosine) / square, square

    def path(k: acb, analytic: bool) -> acb:
        rate, square = turn(k, _profile(k, analytic), analytic)
        return rate * square.sqrt(analytic=analytic) / k

    def work(k: acb, analytic: bool) -> acb:
        now = _profile(k, analytic)
        return turn(k, now, analytic)[0] * (now.force + k * now.torque) / k

    return path, work


def slide_rates(length: fmpq) -> tuple[Integrand, Integrand, Integrand]:
    """Derivatives by ``q = 1 / |k|`` for a slip under a force along the fence, rod angle below 90 degrees.

    They are those of the path of the ring's center, which is the integral of ``d psi / k`` with ``l sin
    psi = H(|k|) = 1 / H(q)``; of the energy that support friction dissipates; and of the integral of
    the force over the height of the fence. By duality ``f(|k|) = t(q)`` and ``t(|k|) = f(q)``.
    """

    def path_of(q: acb, now: _Profile, analytic: bool) -> acb:
        sine = 1 / (length * now.arm)
        cosine = (1 - sine * sine).sqrt(analytic=analytic)
        return q * now.rise / (length * now.arm * now.arm * cosine)

    def path(q: acb, analytic: bool) -> acb:
        return path_of(q, _profile(q, analytic), analytic)

    def rubbed(q: acb, analytic: bool) -> acb:
        now = _profile(q, analytic)
        return path_of(q, now, analytic) * (now.torque + now.force / q)

    def pull(q: acb, analytic: bool) -> acb:
        now = _profile(q, analytic)
        return now.torque * now.rise / (now.arm * now.arm)

    return path, rubbed, pull


def slide_spin(length: fmpq, sine: arb) -> arb:
    """Inverse spin ratio 1 / |k| under a force along the fence, at a given sine of the rod angle."""
    wanted = 1 / (length * sine)
    return increasing_root(lambda q: arm(q) - wanted, LEAST, MOST)


def holds(condition: Callable[[arb], bool], low: arb, high: arb) -> None:
    """Show a condition on a span of k by balls that cover it.

    Raises
    ------
    Undecided
        If the condition remains undecided on a ball.
    """
    ends = [low.lower() + (high.upper() - low.lower()) * i / PARTS for i in range(PARTS + 1)]
    for a, b in pairwise(ends):
        if not condition(a.union(b)):
            raise Undecided(f"the condition of the mode is undecided at k in {a.union(b)}")
