r"""Mean distance to a distant plate, in powers of the plate's size divided by the distance.

Let z be positions in the complex plane relative to the plate's center of pressure, in units of its radius,
and zeta the radius divided by the center of rotation c, relative to the same point. Then

    |r - c| = |c| |1 - z zeta| = |c| sum of a_j a_k (z zeta)^j conj(z zeta)^k

with the coefficients of ``sqrt(1 - z) = sum of a_j z^j``. The mean over the plate follows from its moments
``M_jk``, the means of z^j conj(z)^k. D, the torque and all derivatives are sums of the same terms with
factors of n = j + k and m = j - k, so nothing cancels: the torque starts at n = 2. Terms are stored for
m = 0, 1, ... and, for each m, for k = 0, 1, ...; an m whose terms are all rounding errors is skipped, as in
a plate that is symmetric under rotation by 180 or 90 degrees. Complex numbers are pairs of floats.
"""

from __future__ import annotations

from math import fabs, log, sqrt
from typing import NamedTuple

from planar_pushing.core._record import Record
from planar_pushing.core.numbers import EPSILON, Numbers, zeros
from planar_pushing.core.supports.piece_rows import COLUMNS, LineRow
from planar_pushing.core.supports.sums import Piece

#: Half of the highest power n, which is enough for 1e-16 beyond `PLATE_FAR` of `pieces`.
HALF_ORDER = 26
ORDER = 2 * HALF_ORDER
#: Number of terms of a plate, and number of pairs: its terms, and for each m whether they count.
TERMS = (HALF_ORDER + 1) * (HALF_ORDER + 1)
ROWS = TERMS + ORDER + 1
#: Terms of power n count while ``n log(|c| / radius)`` is below this. Beyond it they were below 1e-16 in
#: measurements on polygons with many kinds of corners.
DIGITS = 28.0
#: Distance from one power n to the next in an array of moments M_jk with n = j + k, where those of k are at
#: 2 k, and size of the array.
MOMENT_STEP = 2 * (HALF_ORDER + 1)
MOMENT_COUNT = MOMENT_STEP * (ORDER + 1)
POWER_COUNT = 2 * (ORDER + 1)


class PlateTerms(Record):
    """Radius of a plate, and the places in the data at which its edges begin and end."""

    radius: float
    first: int
    last: int


class PowerSums(NamedTuple):
    """Sums of the terms: real parts times 1, n, n^2; imaginary parts times m, m n; real parts times m^2."""

    one: float
    n: float
    nn: float
    m_i: float
    mn_i: float
    mm: float


class OrderSums(NamedTuple):
    """Real and imaginary sums over the terms of one m, times 1, n and n^2."""

    a: float
    b: float
    n_a: float
    n_b: float
    nn_a: float
    nn_b: float


def terms_of_order(order: int, m: int) -> int:
    """Number of terms k with m + 2 k <= order, for m <= order."""
    return int(0.5 * (order - m)) + 1


def distant_piece(data: Numbers, terms: int, x: float, y: float, radius: float) -> Piece:
    """The piece of the plate whose terms begin at `terms`, for a center of rotation far from it."""
    distance = sqrt(x * x + y * y)
    ratio, u_x, u_y = radius / distance, x / distance, y / distance
    total = sum_powers(data, terms, ratio, cosine=u_x, sine=-u_y)
    # grad D = (c / |c|) (sum of (1 - n) + i m); applied twice, it gives the second derivatives.
    g_x, g_y = total.one - total.n, total.m_i
    mean = (total.nn - 2.0 * total.n + total.one - total.mm) / (2.0 * distance)
    p, q = (total.nn + total.mm - total.one) / (2.0 * distance), -total.mn_i / distance
    c2, s2 = u_x * u_x - u_y * u_y, 2.0 * u_x * u_y
    half, xy = c2 * p - s2 * q, s2 * p + c2 * q
    unit_x, unit_y = g_y * u_y - g_x * u_x, -g_x * u_y - g_y * u_x
    torque = distance * total.n
    return Piece(
        distance=distance * total.one,
        unit_x=unit_x,
        unit_y=unit_y,
        torque=torque,
        xx=mean + half,
        xy=xy,
        yy=mean - half,
    )


def highest_order(ratio: float) -> int:
    """Highest power that counts at a ratio, below 1, of the radius to the distance."""
    if ratio <= 0.0:
        return 2
    order = DIGITS / -log(ratio)
    return min(ORDER, int(order) + 2) if order < ORDER else ORDER


def sum_powers(data: Numbers, terms: int, ratio: float, cosine: float, sine: float) -> PowerSums:
    """The sums over all terms at a ratio and a direction."""
    order = highest_order(ratio)
    y, re, im = ratio * ratio, 1.0, 0.0
    first, step, drop = terms, MOMENT_STEP, 2
    one, n, nn, m_i, mn_i, mm = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    for m in range(order + 1):
        if data[terms + 2 * (TERMS + m)] > 0.0:
            row = sum_order(data, first, m, terms_of_order(order, m), y)
            real, imaginary = re * row.a - im * row.b, re * row.b + im * row.a
            one += real
            n += re * row.n_a - im * row.n_b
            nn += re * row.nn_a - im * row.nn_b
            m_i += m * imaginary
            mn_i += m * (re * row.n_b + im * row.n_a)
            mm += m * m * real
        re, im = ratio * (re * cosine - im * sine), ratio * (re * sine + im * cosine)
        # An odd m has as many terms as the next one.
        first, step, drop = first + step, step - drop, 2 - drop
    return PowerSums(one, n, nn, m_i, mn_i, mm)


def sum_order(data: Numbers, first: int, m: int, count: int, y: float) -> OrderSums:
    """Sums over k at one m: polynomials in y and their derivatives."""
    a, b, first_a, first_b, second_a, second_b = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    i = first + 2 * count
    while i > first:
        i -= 2
        second_a, second_b = second_a * y + first_a, second_b * y + first_b
        first_a, first_b = first_a * y + a, first_b * y + b
        a, b = a * y + data[i], b * y + data[i + 1]
    # With the factors k and k^2.
    k_a, k_b = y * first_a, y * first_b
    kk_a, kk_b = k_a + 2.0 * y * y * second_a, k_b + 2.0 * y * y * second_b
    n_a, n_b = m * a + 2.0 * k_a, m * b + 2.0 * k_b
    nn_a, nn_b = m * (n_a + 2.0 * k_a) + 4.0 * kk_a, m * (n_b + 2.0 * k_b) + 4.0 * kk_b
    return OrderSums(a, b, n_a, n_b, nn_a, nn_b)


def plate_terms(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """Terms of plates, as `sum_powers` reads them.

    Parameters
    ----------
    data : array
        Edges of the plates, as in the layout of a pressure.
    rows : array
        A `PlateTerms` for each plate.
    results : array
        ``2 * ROWS`` numbers for each plate: real and imaginary parts of its terms, and for each m a pair
        whose first number tells whether the terms count.
    """
    sums, means = zeros(MOMENT_COUNT), zeros(MOMENT_STEP)
    powers, starts = zeros(POWER_COUNT), zeros(POWER_COUNT)
    squares, roots = zeros(ORDER + 1), zeros(ORDER + 1)
    # Coefficients of sqrt(1 - z).
    roots[0] = 1.0
    for j in range(1, ORDER + 1):
        roots[j] = roots[j - 1] * ((2 * j - 3) / (2.0 * j))
    for i in range(count):
        row = PlateTerms(rows[i * columns :])
        radius, k, last = row.radius, row.first, row.last
        for j in range(MOMENT_COUNT):
            sums[j] = 0.0
        while k < last:
            add_edge(
                sums,
                LineRow(data[k:]),
                radius,
                means=means,
                starts=starts,
                powers=powers,
                squares=squares,
            )
            k += COLUMNS
        store_terms(sums, roots, results[i * width :])


def add_edge(
    sums: Numbers, edge: LineRow, radius: float,
    means: Numbers, starts: Numbers, powers: Numbers, squares: Numbers,
) -> None:  # fmt: skip
    """Add an edge's contribution to the moments, over the triangle of the edge and the center.

    The means of z^j conj(z)^k over the edge follow from those of lower powers by integration by parts.
    """
    x, y, t_x, t_y, half = edge.x, edge.y, edge.t_x, edge.t_y, edge.half
    along_x, along_y = t_x * half / radius, t_y * half / radius
    start_x, start_y = x / radius - along_x, y / radius - along_y
    store_powers(x / radius + along_x, y / radius + along_y, powers, squares)
    for n in range(ORDER + 1):
        starts[2 * n], starts[2 * n + 1] = n * start_x, n * start_y
    area = (x * t_y - y * t_x) * (2.0 * half) * edge.share
    for n in range(ORDER + 1):
        # A product is faster than a division.
        part, share, k = 1.0 / (n + 1.0), area / (n + 2.0), n // 2
        moments_of_n = sums[n * MOMENT_STEP :]
        # The means of power n replace those of power n - 1, from the last one.
        if 0 < n == 2 * k:
            p, q, a, b = starts[2 * k], starts[2 * k + 1], means[2 * k - 2], means[2 * k - 1]
            re, im = squares[k] * powers[0], squares[k] * powers[1]
            re, im = re + (p * a + q * b), im + (q * a - p * b)
            re, im = part * (re + (p * a + q * b)), part * (im + (p * b - q * a))
            means[2 * k], means[2 * k + 1] = re, im
            moments_of_n[2 * k] += share * re
            moments_of_n[2 * k + 1] += share * im
            k -= 1
        while k > 0:
            i, m, j = 2 * k, 2 * (n - 2 * k), 2 * (n - k)
            re, im = squares[k] * powers[m], squares[k] * powers[m + 1]
            p, q, a, b = starts[j], starts[j + 1], means[i], means[i + 1]
            re, im = re + (p * a - q * b), im + (p * b + q * a)
            p, q, a, b = starts[i], starts[i + 1], means[i - 2], means[i - 1]
            re, im = part * (re + (p * a + q * b)), part * (im + (p * b - q * a))
            means[i], means[i + 1] = re, im
            moments_of_n[i] += share * re
            moments_of_n[i + 1] += share * im
            k -= 1
        re, im = powers[2 * n], powers[2 * n + 1]
        if n > 0:
            p, q, a, b = starts[2 * n], starts[2 * n + 1], means[0], means[1]
            re, im = re + (p * a - q * b), im + (p * b + q * a)
        means[0], means[1] = part * re, part * im
        moments_of_n[0] += share * means[0]
        moments_of_n[1] += share * means[1]


def store_powers(x: float, y: float, powers: Numbers, squares: Numbers) -> None:
    """Store powers of z = x + i y, and of its squared absolute value."""
    square = x * x + y * y
    powers[0], powers[1], squares[0] = 1.0, 0.0, 1.0
    for n in range(ORDER):
        a, b = powers[2 * n], powers[2 * n + 1]
        powers[2 * n + 2], powers[2 * n + 3] = a * x - b * y, a * y + b * x
        squares[n + 1] = squares[n] * square


def store_terms(sums: Numbers, roots: Numbers, terms: Numbers) -> None:
    """Store the terms of a plate from sums over its edges; those of power 1 are zero about the center."""
    total, i = sums[0], 0
    sums[MOMENT_STEP], sums[MOMENT_STEP + 1], terms[2] = 0.0, 0.0, 0.0
    for m in range(ORDER + 1):
        terms[2 * (TERMS + m)], terms[2 * (TERMS + m) + 1] = 0.0, 0.0
        for k in range(terms_of_order(ORDER, m)):
            factor = roots[m + k] * roots[k] / total * (2.0 if m > 0 else 1.0)
            j = (m + 2 * k) * MOMENT_STEP + 2 * k
            terms[i], terms[i + 1] = factor * sums[j], factor * sums[j + 1]
            # The second term is the largest in the torque.
            if max(fabs(terms[i]), fabs(terms[i + 1])) > EPSILON * fabs(terms[2]):
                terms[2 * (TERMS + m)] = 1.0
            i += 2
