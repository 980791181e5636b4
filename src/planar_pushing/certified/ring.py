"""Friction of the ring (Eqs. 2-3), with W = R = 1, by either of two routes.

Force `f` and torque `t` are given at the spin ratio k >= 0. The friction potential is convex and
homogeneous: as k increases, f decreases from 1 to 0, t increases from 0 to 1, and ``f' = -k t'``. Wide
balls are therefore enclosed by their ends. A process evaluates exact arguments by Arb's elliptic
integrals until `use` selects another route.
"""

from __future__ import annotations

from collections.abc import Callable

from flint import acb, arb, ctx

#: Relative accuracy, in bits, to which an exact argument is evaluated.
_ACCURACY = 160

#: Below this ratio t is summed as a series, since the closed form suffers from cancellation.
_SMALL = arb(2) ** -6

Profile = tuple[arb, arb]
#: Evaluates Eqs. (2)-(3) at an exact k > 0.
Route = Callable[[arb], Profile]


def profile(k: arb) -> Profile:
    """Force f and torque t of the ring at the spin ratio k >= 0, exact or a ball."""
    if not k.is_exact():
        (f_low, t_low), (f_high, t_high) = profile(k.lower()), profile(k.upper())
        return f_high.union(f_low), t_low.union(t_high)
    return _route(k) if k > 0 else (arb(1), arb(0))


def elliptic(k: arb) -> Profile:
    """Eqs. (2)-(3) by elliptic integrals; duality, f(k) = t(1/k), extends them to k > 1."""
    if k == 1:
        return 2 / arb.pi(), 2 / arb.pi()
    precision = ctx.prec
    while True:  # near k = 1 the parameter cancels
        with ctx.workprec(precision):
            found = _inside(k) if k < 1 else _inside(1 / k)[::-1]
        if min(int(each.rel_accuracy_bits()) for each in found) >= _ACCURACY:
            return found
        precision *= 2


_route: Route = elliptic


def use(route: Route) -> None:
    """Evaluate the ring by this route from now on; call it first in a process."""
    global _route
    _route = route


def slope(k: arb) -> arb:
    """Derivative t'(k) at an exact k > 0 other than 1, where it is infinite.

    ``k (1 - k^2) t' = k f - t`` is Legendre's equation for E and K in terms of f and t.
    """
    force, torque = profile(k)
    return (k * force - torque) / (k * (1 - k) * (1 + k))


def least_slope(low: arb, high: arb) -> arb:
    """Lower bound of t' over [low, high], with exact ends on one side of k = 1.

    Below 1, t' is a power series with positive coefficients; above 1 it is t'(1/k) / k^3. It increases
    to infinity at 1 and decreases from there.
    """
    return slope(low if high <= 1 else high).lower()


def greatest_slope(low: arb, high: arb) -> arb:
    """Upper bound of t' over [low, high], infinite if an end is 1."""
    peak = high if high <= 1 else low
    return arb.pos_inf() if peak == 1 else slope(peak).upper()


def _inside(k: arb) -> Profile:
    """Eqs. (2)-(3) for 0 < k < 1: f = 2/pi E, t = 2/pi (E - (1 - m) K) / k with m = k^2."""
    m = k * k
    if k < _SMALL:
        return m.hypgeom_2f1(arb(-0.5), arb(0.5), arb(1)), k / 2 * m.hypgeom_2f1(
            arb(0.5), arb(0.5), arb(2)
        )
    first, second = acb(m).elliptic_k().real, acb(m).elliptic_e().real
    scale = 2 / arb.pi()
    return scale * second, scale * (second - (1 - k) * (1 + k) * first) / k
