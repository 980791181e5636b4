r"""Force and torque of a ring's friction in closed form (Eqs. 2-3), elementwise.

With ``m = k^2``, ``x = 1 - m`` and complete elliptic integrals K, E of parameter m, inside the ring::

    f(k) = (2/pi) E                    force along the motion, in units of W
    t(k) = (2/pi) (E - x K) / k        torque, in units of W R
    t'(k) = (2/pi) (K - E) / m         and f' = -k t'

and outside the ring is self-dual: ``f(k) = t(1/|k|)``, ``t(k) = sign(k) f(1/|k|)``. As written the torque
cancels for small k. There a Landen step, m -> q^2 with ``q = (1 - k') / (1 + k')`` and ``k' = sqrt(x)``,
gives E and K as two power series in q^2 whose leading terms cancel on paper.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import numpy.typing as npt
import scipy
from numpy.polynomial import Chebyshev, Polynomial

from planar_pushing.mechanics.planar import Array

#: From this spin ratio on the torque comes from scipy's E and K, below it from the Landen series.
NEAR_RING = 0.9
#: Terms of the power series, and the degree that represents them as well on the range of q^2.
TERMS = 32
DEGREE = 10
#: Elements that a kernel takes at once: its temporaries stay in a core's cache.
BLOCK = 16384
TINY = np.finfo(float).tiny


def blocks(size: int) -> Iterator[slice]:
    """Slices of at most `BLOCK` elements that cover `size` elements."""
    return (slice(start, start + BLOCK) for start in range(0, size, BLOCK))


def _landen_coefficients() -> tuple[Array, Array]:
    """Series in y = q^2 of ``(Q - 1) / y`` and of ``(Q - P) / y^2``, economised.

    P = 2F1(-1/2, -1/2; 1; y) is E's series (Gauss-Kummer), Q = 2F1(1/2, 1/2; 1; y) is K's.
    """
    n = np.arange(TERMS)
    p = np.cumprod(np.append(1.0, (n - 0.5) / (n + 1))) ** 2
    q = np.cumprod(np.append(1.0, (n + 0.5) / (n + 1))) ** 2
    complement = np.sqrt(1 - NEAR_RING**2)
    domain = [0.0, ((1 - complement) / (1 + complement)) ** 2]
    return _economised(q[1:], domain), _economised(q[2:] - p[2:], domain)


def _economised(series: Array, domain: list[float]) -> Array:
    """Coefficients of a polynomial of low degree that equals the series on the domain to rounding."""
    found = Chebyshev.interpolate(Polynomial(series), DEGREE, domain)
    return np.asarray(found.convert(kind=Polynomial).coef, dtype=float)


_FIRST, _SECOND = _landen_coefficients()


def _horner(coefficients: Array, x: Array) -> Array:
    total = np.full_like(x, coefficients[-1])
    for coefficient in coefficients[-2::-1]:
        total *= x
        total += coefficient
    return total


def _by_series(size: Array) -> tuple[Array, Array, Array]:
    """f, t and t' at min(size, 1/size) < NEAR_RING.

    ``f = (1 + k') / 2 P``, ``t = k B`` with ``B = ((1 - q/2) Q - q/2 (Q - P) / q^2) / (1 + k')``, and
    ``t' = 2 Q / (1 + k') - B``. What is added to the leading terms is small, and so is its rounding.
    """
    k = np.minimum(size, 1 / size)
    m, x = k * k, (1 - k) * (1 + k)
    ends = np.sqrt(x, out=x)
    ends += 1
    half = m / (2 * ends * ends)  # q / 2
    y = np.multiply(half, half, out=m)
    y *= 4
    first, second = _horner(_FIRST, y), _horner(_SECOND, y)
    bracket, slope = 1 - half, 2 + 2 * y * first
    force = y * (first - y * second)
    first *= bracket
    half *= second
    first -= half
    first *= y
    bracket += first
    slope -= bracket
    slope /= ends
    k *= bracket
    k /= ends
    ends *= 0.5
    force *= ends
    force += ends
    return force, k, slope


def _by_integrals(size: Array) -> tuple[Array, Array, Array]:
    """f, t and t' at min(size, 1/size) >= NEAR_RING; at 1, where t' is infinite, it is large."""
    small, large = np.minimum(size, 1), np.maximum(size, 1)
    m = small / large
    m *= m
    x = large - small
    x *= large + small
    x /= large * large
    np.maximum(x, TINY, out=x)
    second, first = scipy.special.ellipe(m), scipy.special.ellipkm1(x)
    slope = first - second
    slope *= 2 / np.pi
    slope /= m
    # E' = (E - K) / (2 m) carries E over from the rounded m to 1 - x.
    m -= 1
    m += x
    m *= slope
    m *= np.pi / 4
    second += m
    x *= first
    torque = np.subtract(second, x, out=x)
    torque *= 2 / np.pi
    torque *= large
    torque /= small
    second *= 2 / np.pi
    return second, torque, slope


def inner_profile(size: Array) -> tuple[Array, Array, Array]:
    """f, t and t' at the spin ratios min(size, 1/size), for size >= 0 of shape (n,)."""
    values = np.empty((3, size.size))
    near = (size >= NEAR_RING) & (size <= 1 / NEAR_RING)
    for mask, formula in ((near, _by_integrals), (~near, _by_series)):
        if mask.all():
            return formula(size)
        part = np.flatnonzero(mask)
        for row, value in zip(values, formula(size[part]), strict=True):
            row[part] = value
    force, torque, slope = values
    return force, torque, slope


def _swap(a: Array, b: Array, where: npt.NDArray[np.bool_]) -> None:
    """Swap elements in place, by their bits: to pick them costs half as much as an integral."""
    bits, others = a.view(np.int64), b.view(np.int64)
    change = bits ^ others
    change *= where
    bits ^= change
    others ^= change


def _profile(k: Array) -> tuple[Array, Array]:
    size = np.abs(k)
    force, torque, _ = inner_profile(size)
    _swap(force, torque, size > 1)
    return force, np.copysign(torque, k, out=torque)


def ring_profile(spin_ratio: npt.ArrayLike) -> tuple[Array, Array]:
    """f(k) and t(k) of Eqs. (2)-(3) per unit weight and radius, for any k including infinities."""
    k = np.asarray(spin_ratio, dtype=float)
    flat, (force, torque) = k.ravel(), np.empty((2, k.size))
    with np.errstate(divide="ignore", over="ignore"):
        for part in blocks(k.size):
            force[part], torque[part] = _profile(flat[part])
    return force.reshape(k.shape), torque.reshape(k.shape)
