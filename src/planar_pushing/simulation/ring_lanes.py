"""Fast path of the batch: the ring's closed form on arrays, with the slope that Newton's method needs.

The same functions as in `mechanics.effects.ring_friction`, to a relative 3e-14 instead of the last
place: a direct formula down to |k| = 0.1 and a short series below, where the direct one cancels.
"""

from __future__ import annotations

import numpy as np
from scipy.special import ellipe, ellipkm1

from planar_pushing.mechanics.plane import Array

SERIES_BELOW = 0.1
TERMS = np.arange(8)
#: ``2F1(1/2, 1/2; 2; m)``, the torque over k/2.
TORQUE = np.cumprod(np.append(1.0, (TERMS + 0.5) ** 2 / ((TERMS + 2) * (TERMS + 1))))
#: Derivative of the torque over 1/2: ``d(k m^n)/dk = (2 n + 1) m^n``.
BEND = TORQUE * (2 * np.arange(len(TORQUE)) + 1)
TINY = np.finfo(float).tiny


def ring_kernel(spin_ratio: Array) -> tuple[Array, Array, Array]:
    """f(k), t(k) and t'(k) of Eqs. (2)-(3) per unit weight and radius, for k >= 0, any shape (n,).

    ``t' = (2/pi) (K - E) / m`` inside the ring; outside, t is the f of 1/k and ``f' = -k t'``.
    """
    outside = spin_ratio > 1
    k = np.divide(1.0, spin_ratio, out=spin_ratio.copy(), where=outside)
    m, complement = k * k, np.maximum((1 - k) * (1 + k), TINY)
    e, first = ellipe(m), ellipkm1(complement)
    small = k < SERIES_BELOW
    divisor = np.where(small, 1.0, k)
    torque, bend = (e - complement * first) / divisor, (first - e) / divisor**2
    force = 2 / np.pi * e
    torque, bend = 2 / np.pi * torque, 2 / np.pi * bend
    if small.any():
        powers = m[small]
        torque[small] = k[small] / 2 * np.polynomial.polynomial.polyval(powers, TORQUE)
        bend[small] = np.polynomial.polynomial.polyval(powers, BEND) / 2
    return (
        np.where(outside, torque, force),
        np.where(outside, force, torque),
        np.where(outside, bend * k**3, bend),
    )
