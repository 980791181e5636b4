"""Friction of a ring for one motion at a time, without arrays: the fast path of the simulation.

Below `SMALL` the two terms of the torque would cancel. There the arithmetic-geometric mean of 1 and k'
gives K, and a sum of squares gives E (Abramowitz and Stegun, 17.6), whose leading parts cancel on paper::

    K = pi / (2 agm(1, k')),   S = sum of 2^(n-1) c_n^2 for n >= 1,
    E = K (1 - m/2 - S),   E - (1 - m) K = K (m/2 - S),   K - E = K (m/2 + S)
"""

from __future__ import annotations

from math import pi, sqrt

from scipy.special import cython_special

ellipe, ellipkm1 = cython_special.ellipe, cython_special.ellipkm1

#: Below this k the mean is taken, above it scipy's functions of one number.
SMALL = 0.25
#: Below this the complement of k^2 is taken for it: K grows like its logarithm and stays finite.
LEAST = 1e-150


def inner_point(k: float) -> tuple[float, float, float]:
    """f(k), t(k) and t'(k) of Eqs. (2)-(3) for 0 <= k <= 1, per unit weight and radius."""
    if k < SMALL:
        return _small_point(k)
    m, complement = k * k, (1.0 - k) * (1.0 + k)
    e, total = ellipe(m), ellipkm1(complement or LEAST)
    scale = 2.0 / pi
    return scale * e, scale * (e - complement * total) / k, scale * (total - e) / m


def _small_point(k: float) -> tuple[float, float, float]:
    m = k * k
    if m < 1e-60:
        return 1.0, k / 2, 0.5
    a, b = 1.0, sqrt((1.0 - k) * (1.0 + k))
    total, power = 0.0, 1.0
    c = (a - b) / 2
    while c > 1e-9 * a:
        total += power * c * c
        a, b = (a + b) / 2, sqrt(a * b)
        c, power = (a - b) / 2, 2 * power
    total += power * c * c
    k_over, half = 2.0 / (a + b), m / 2  # (2 / pi) K
    return k_over * (1.0 - half - total), k_over * (half - total) / k, k_over * (half + total) / m


def ring_point(speed: float, spin: float) -> tuple[float, float, float]:
    """Force along the motion, torque, and curvature of the potential.

    Parameters
    ----------
    speed, spin : float
        ``v >= 0`` and ``R omega``, not both zero.

    Returns
    -------
    force, torque : float
        Per unit weight and radius.
    curvature : float
        The c in the potential's second derivative, ``c (s, -v) (s, -v)^T`` over (v, s).
    """
    size = spin if spin >= 0.0 else -spin
    if size <= speed:
        force, torque, slope = inner_point(size / speed)
        return force, torque if spin >= 0.0 else -torque, slope / speed**3
    torque, force, slope = inner_point(speed / size)
    return force, torque if spin >= 0.0 else -torque, slope / size**3
