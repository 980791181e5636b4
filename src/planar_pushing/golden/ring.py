"""Friction of the ring (Eqs. 2-3) by Arb's elliptic integrals, with W = R = 1.

Force `f` and torque `t` at the spin ratio k >= 0. The friction potential is convex and homogeneous:
along increasing k, f falls from 1 to 0 and t rises from 0 to 1, and ``f' = -k t'``. Wide balls are
therefore enclosed by their ends. Duality, f(k) = t(1/k), carries k > 1.
"""

from __future__ import annotations

from flint import acb, arb, ctx

#: Relative accuracy, in bits, that an exact argument is evaluated to.
_ACCURACY = 160

#: Below this ratio t is summed as a series: its closed form cancels.
_SMALL = arb(2) ** -6

Profile = tuple[arb, arb]


def profile(k: arb) -> Profile:
    """Force f and torque t of the ring at the spin ratio k >= 0, exact or a ball."""
    if not k.is_exact():
        found = _closed_form(k)
        if found is not None and _accuracy(found) >= k.rel_accuracy_bits() - 20 >= 40:
            return found
        (f_low, t_low), (f_high, t_high) = profile(k.lower()), profile(k.upper())
        return f_high.union(f_low), t_low.union(t_high)
    if k == 0:
        return arb(1), arb(0)
    if k == 1:
        return 2 / arb.pi(), 2 / arb.pi()
    return _refined(k)


def slope(k: arb) -> arb:
    """Derivative t'(k) at an exact k > 0 other than 1, where it is infinite."""
    if k > 1:
        return slope(1 / k) / k**3
    _, torque = _inside(k)
    return 2 / arb.pi() * acb(k * k).elliptic_k().real - torque / k


def least_slope(low: arb, high: arb) -> arb:
    """Lower bound of t' over [low, high], exact ends on one side of k = 1.

    t' is a power series with positive coefficients below 1 and t'(1/k) / k^3 above it: it rises to
    infinity at 1 and falls from there.
    """
    return slope(low if high <= 1 else high).lower()


def greatest_slope(low: arb, high: arb) -> arb:
    """Upper bound of t' over [low, high], infinite where an end is 1."""
    peak = high if high <= 1 else low
    return arb.pos_inf() if peak == 1 else slope(peak).upper()


def _accuracy(pair: Profile) -> int:
    return min(int(each.rel_accuracy_bits()) for each in pair)


def _refined(k: arb) -> Profile:
    """Raise the precision until the closed form is accurate: next to k = 1 the parameter cancels."""
    precision = ctx.prec
    while True:
        with ctx.workprec(precision):
            found = _closed_form(k)
        if found is not None and _accuracy(found) >= _ACCURACY:
            return found
        precision *= 2


def _closed_form(k: arb) -> Profile | None:
    if k < 1:
        return _inside(k)
    if k > 1:
        force, torque = _inside(1 / k)
        return torque, force
    return None


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
