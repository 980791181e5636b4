"""Friction of the ring on boxes [low, high] of the spin ratio within [0, 1].

On it the power series in k of t, of t / k and of (1 - f) / k^2 have positive coefficients: all three
rise, and the ends of a box enclose them. Duality, f(k) = t(1 / k), carries what is said to k > 1.
"""

from __future__ import annotations

from flint import arb, fmpq

from planar_pushing.certified import ring


def force(low: arb, high: arb) -> arb:
    """Enclose f; it falls."""
    return ring.profile(high)[0].union(ring.profile(low)[0])


def torque(low: arb, high: arb) -> arb:
    """Enclose t."""
    return ring.profile(low)[1].union(ring.profile(high)[1])


def turn(low: arb, high: arb) -> arb:
    """Lower bound of t / k, 1/2 at k = 0."""
    return arb(fmpq(1, 2)) if low == 0 else ring.profile(low)[1] / low


def loss(low: arb, high: arb) -> arb:
    """Lower bound of (1 - f) / k^2, 1/4 at k = 0."""
    return arb(fmpq(1, 4)) if low == 0 else (1 - ring.profile(low)[0]) / low**2


def slope(low: arb, high: arb) -> arb:
    """Lower bound of t', which rises from 1/2."""
    return arb(fmpq(1, 2)) if low == 0 else ring.slope(low) if low < 1 else arb.pos_inf()


def arm_slope(low: arb, high: arb) -> arb:
    """Lower bound of the slope of the moment arm H = t / f, ``H' = t' (f + k t) / f^2``."""
    (falling, rising), (last, _) = ring.profile(low), ring.profile(high)
    return slope(low, high) * (last + low * rising) / falling**2
