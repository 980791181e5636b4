r"""Mean distance to a distant plate, in powers of the plate's size divided by the distance.

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
from typing import Any

import numpy as np

from planar_pushing.mechanics.compiled import compiled, kernel, owning
from planar_pushing.mechanics.numerics.arrays import in_threads
from planar_pushing.mechanics.numerics.root import EPSILON
from planar_pushing.mechanics.supports.pressure.record import Array

#: Highest power n, enough for 1e-16 beyond `FAR` of `plate`.
ORDER = 52
TERMS = sum((ORDER - m) // 2 + 1 for m in range(ORDER + 1))
#: Rows of a plate: its terms, and for each m whether they count.
ROWS = TERMS + ORDER + 1
#: Terms of power n count while ``n log(|c| / radius)`` is below this. Beyond it they were below 1e-16 in
#: measurements on polygons with many kinds of corners.
DIGITS = 28.0
#: Coefficients of sqrt(1 - z).
ROOT = tuple(np.cumprod([1.0] + [(2 * j - 3) / (2 * j) for j in range(1, ORDER + 1)]).tolist())


#: Plates per block: a few milliseconds of work.
BLOCK = 512


def of_all(rows: Array, plates: Any) -> Array:
    """Terms of all plates, given the rows of a record that hold them; shape (plates, ROWS, 2)."""
    found = np.zeros((len(plates), ROWS, 2))

    def block(start: int) -> None:
        part = slice(start, start + BLOCK)
        _expand(rows, plates[part], found[part])

    block(0)
    if len(plates) > BLOCK:
        in_threads(block, range(BLOCK, len(plates), BLOCK))
    return found


@kernel
@owning
def _expand(rows, plates, found):
    for i in range(len(plates)):
        row = rows[plates[i]]
        multipoles(rows[int(row[4]) : int(row[5])], row[2], found[i])


@owning
def multipoles(edges, radius, found):
    """Write the terms of a plate, real and imaginary, into an array of zeros of shape (ROWS, 2)."""
    sums = np.zeros((ORDER + 1, ORDER // 2 + 1), dtype=np.complex128)
    for i in range(len(edges)):
        x, y, t_x = edges[i, 0], edges[i, 1], edges[i, 2]
        t_y, half, jump = edges[i, 3], edges[i, 4], edges[i, 5]
        middle, along = complex(x, y) / radius, complex(t_x, t_y) * half / radius
        area = (x * t_y - y * t_x) * (2.0 * half) * jump
        _add_edge(sums, middle - along, middle + along, area)
    _terms(sums, found)


@owning
def _add_edge(sums, start, end, area):
    """Add an edge's contribution to the moments, over the triangle of the edge and the center.

    The means of z^j conj(z)^k over the edge follow from those of lower powers by integration by parts.
    """
    means, power, square = np.empty_like(sums), _powers(end), _powers(end * end.conjugate())
    for n in range(ORDER + 1):
        # Division of a complex by a real number is slow.
        part, whole = 1.0 / (n + 1.0), area / (n + 2.0)
        for k in range(n // 2 + 1):
            m = n - 2 * k
            mean = square[k] * power[m]
            if m > 0:
                mean += (m + k) * start * means[m - 1, k]
            elif k > 0:
                mean += k * start * means[1, k - 1].conjugate()
            if k > 0:
                mean += k * start.conjugate() * means[m + 1, k - 1]
            means[m, k] = part * mean
            sums[m, k] += whole * means[m, k]


@owning
def _powers(z):
    found = np.ones(ORDER + 1, dtype=np.complex128)
    for n in range(ORDER):
        found[n + 1] = found[n] * z
    return found


@compiled
def _terms(sums, found):
    """Coefficients of the series from the moments; those of power 1 are zero about the center."""
    whole, place = sums[0, 0].real, 0
    sums[1, 0] = 0.0
    for m in range(ORDER + 1):
        for k in range((ORDER - m) // 2 + 1):
            factor = ROOT[m + k] * ROOT[k] / whole * (2.0 if m > 0 else 1.0)
            found[place, 0] = factor * sums[m, k].real
            found[place, 1] = factor * sums[m, k].imag
            # The second term is the largest in the torque.
            size = max(abs(found[place, 0]), abs(found[place, 1]))
            if size > EPSILON * abs(found[1, 0]):
                found[TERMS + m, 0] = 1.0
            place += 1


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
