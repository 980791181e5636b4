"""Mean distance to a distant plate, in powers of the plate's size divided by the distance.

Let z be positions in the complex plane relative to the plate's center of pressure, in units of its radius,
and zeta the radius divided by the center of rotation c, relative to the same point. Then

    |r - c| = |c| |1 - z zeta| = |c| sum of a_j a_k (z zeta)^j conj(z zeta)^k

with the coefficients of ``sqrt(1 - z) = sum of a_j z^j``. The mean over the plate follows from its moments
``M_jk``, the means of z^j conj(z)^k. D, the torque and all derivatives are sums of the same terms with
factors of n = j + k and m = j - k, so nothing cancels: the torque starts at n = 2. Terms are stored for
m = 0, 1, ... and, for each m, for k = 0, 1, ...; an m whose terms are all rounding errors is skipped, as in
a plate that is symmetric under rotation by 180 or 90 degrees.
"""

from __future__ import annotations

from math import log, sqrt

from planar_pushing.simulation.legacy.compiled import compiled

#: Highest power n, enough for 1e-16 beyond `FAR` of `plate`.
ORDER = 52
TERMS = sum((ORDER - m) // 2 + 1 for m in range(ORDER + 1))
#: Terms of power n count while ``n log(|c| / radius)`` is below this. Beyond it they were below 1e-16 in
#: measurements on polygons with many kinds of corners.
DIGITS = 28.0


@compiled
def far(multipoles, i, x, y, radius):
    """The piece of plate i for a center of rotation far from it."""
    distance = sqrt(x * x + y * y)
    ratio, u_x, u_y = radius / distance, x / distance, y / distance
    one, n1, bend, m_i, mn_i, turn = _sums(multipoles, i, ratio, u_x, -u_y)
    # grad D = (c / |c|) (sum of (1 - n) + i m); applied twice, it gives the second derivatives.
    g_x, g_y = one - n1, m_i
    mean = (bend - 2.0 * n1 + one - turn) / (2.0 * distance)
    p, q = (bend + turn - one) / (2.0 * distance), -mn_i / distance
    c2, s2 = u_x * u_x - u_y * u_y, 2.0 * u_x * u_y
    half, xy = c2 * p - s2 * q, s2 * p + c2 * q
    unit_x, unit_y = g_y * u_y - g_x * u_x, -g_x * u_y - g_y * u_x
    return distance * one, unit_x, unit_y, distance * n1, mean + half, xy, mean - half


@compiled
def _sums(multipoles, i, ratio, cosine, sine):
    """Sums of the terms' real parts times 1, n and n^2, imaginary parts times m and m n, real times m^2."""
    order = min(ORDER, int(DIGITS / -log(ratio)) + 2)
    y, re, im, start = ratio * ratio, 1.0, 0.0, 0
    one, first, second, slide, shear, turn = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    for m in range(order + 1):
        if multipoles[i, TERMS + m, 0] > 0.0:
            a, b, n_a, n_b, nn_a, nn_b = _row(multipoles, i, start, m, (order - m) // 2 + 1, y)
            real, imaginary = re * a - im * b, re * b + im * a
            one += real
            first += re * n_a - im * n_b
            second += re * nn_a - im * nn_b
            slide += m * imaginary
            shear += m * (re * n_b + im * n_a)
            turn += m * m * real
        re, im = ratio * (re * cosine - im * sine), ratio * (re * sine + im * cosine)
        start += (ORDER - m) // 2 + 1
    return one, first, second, slide, shear, turn


@compiled
def _row(multipoles, i, start, m, count, y):
    """Real and imaginary sums over k at one m, times 1, n and n^2: polynomials in y and derivatives."""
    a, b, first_a, first_b, second_a, second_b = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    for k in range(count):
        place = start + count - 1 - k
        second_a, second_b = second_a * y + first_a, second_b * y + first_b
        first_a, first_b = first_a * y + a, first_b * y + b
        a, b = a * y + multipoles[i, place, 0], b * y + multipoles[i, place, 1]
    # With the factors k and k^2.
    k_a, k_b = y * first_a, y * first_b
    kk_a, kk_b = k_a + 2.0 * y * y * second_a, k_b + 2.0 * y * y * second_b
    n_a, n_b = m * a + 2.0 * k_a, m * b + 2.0 * k_b
    nn_a, nn_b = m * (n_a + 2.0 * k_a) + 4.0 * kk_a, m * (n_b + 2.0 * k_b) + 4.0 * kk_b
    return a, b, n_a, n_b, nn_a, nn_b
