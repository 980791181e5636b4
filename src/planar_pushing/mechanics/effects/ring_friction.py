r"""Friction of a ring on the support, in closed form (Eqs. 2-3).

With ``m = k^2`` and the complete elliptic integrals K and E of parameter m, for |k| <= 1::

    f(k) = (2/pi) E(m)                         force along the motion, in units of W
    t(k) = (2/pi) (E(m) - (1 - m) K(m)) / k    torque, in units of W R

and outside the ring is self-dual: ``f(k) = t(1/|k|)``, ``t(k) = sign(k) f(1/|k|)``. As written the
torque cancels for small k. There a Landen step, m -> q^2 with ``q = (1 - k') / (1 + k')`` and
``k' = sqrt(1 - m)``, gives E and K as two power series in q^2 whose leading terms cancel on paper.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache

import numpy as np
import numpy.typing as npt
from scipy.special import ellipe, ellipkm1

from planar_pushing.mechanics.effects.base import isotropic_wrench
from planar_pushing.mechanics.errors import require_positive
from planar_pushing.mechanics.planar import Array

#: Below this spin ratio the torque comes from the Landen series, above it from E and K.
SERIES_BELOW = 0.9
TERMS = 20
#: Below this moment arm the spin ratio is twice the arm to the last place.
SMALL = 1e-9
TINY = np.finfo(float).tiny


def _landen_coefficients() -> tuple[Array, Array]:
    """Series in q^2 of ``2 Q`` and of ``Q + (Q - P) / q^2``.

    P = 2F1(-1/2, -1/2; 1; q^2) is E's series (Gauss-Kummer), Q = 2F1(1/2, 1/2; 1; q^2) is K's, and
    the torque is ``t = k (1 + q) / 4 * (2 Q - q (Q + (Q - P) / q^2))``.
    """
    n = np.arange(TERMS)
    p = np.cumprod(np.append(1.0, (n - 0.5) / (n + 1))) ** 2
    q = np.cumprod(np.append(1.0, (n + 0.5) / (n + 1))) ** 2
    return 2 * q[:-1], q[:-1] + q[1:] - p[1:]


_EVEN, _ODD = _landen_coefficients()


def _horner(coefficients: Array, x: Array) -> Array:
    total = np.full_like(x, coefficients[-1])
    for coefficient in coefficients[-2::-1]:
        total *= x
        total += coefficient
    return total


def _inner_profile(k: Array) -> tuple[Array, Array]:
    """Force f and torque t for 0 <= k <= 1, shape of `k`."""
    m, complement = k * k, (1 - k) * (1 + k)
    e = ellipe(m)
    torque = (e - complement * ellipkm1(np.maximum(complement, TINY))) / np.maximum(k, 0.5)
    small = k < SERIES_BELOW
    q = m[small] / (1 + np.sqrt(complement[small])) ** 2
    series = _horner(_EVEN, q * q) - q * _horner(_ODD, q * q)
    torque *= 2 / np.pi
    torque[small] = k[small] * (1 + q) / 4 * series
    return 2 / np.pi * e, torque


def ring_profile(spin_ratio: npt.ArrayLike) -> tuple[Array, Array]:
    """f(k) and t(k) of Eqs. (2)-(3) per unit weight and radius, for any k including infinities."""
    k = np.asarray(spin_ratio, dtype=float)
    size = np.abs(k)
    with np.errstate(divide="ignore", over="ignore"):
        inner = np.atleast_1d(np.minimum(size, 1 / size))
    force, torque = (part.reshape(k.shape) for part in _inner_profile(inner))
    outside = size > 1
    return (
        np.where(outside, torque, force),
        np.copysign(np.where(outside, force, torque), k),
    )


def _inner_slope(k: Array) -> Array:
    """dH/dk for 0 < k <= 1, to the few digits that a Newton step needs."""
    force, torque = _inner_profile(k)
    m, complement = k * k, np.maximum((1 - k) * (1 + k), TINY)
    bend = 2 / np.pi * (ellipkm1(complement) - ellipe(m)) / np.maximum(m, 1e-6)
    return np.where(m > 1e-6, bend, 0.5) * (force + k * torque) / force**2


@cache
def _first_guess() -> Callable[[Array], Array]:
    """Spin ratio as a function of H on [0, 1]: H's graph read sideways, with nodes that crowd towards 1."""
    # Importing it takes longer than the rest of the mechanics, and many jobs never invert H.
    from scipy.interpolate import CubicHermiteSpline

    k = np.append(np.linspace(0, 0.9, 128), 1 - np.append(np.geomspace(0.09, 1e-15, 160), 0))
    force, torque = _inner_profile(k)
    spline: Callable[[Array], Array] = CubicHermiteSpline(torque / force, k, 1 / _inner_slope(k))
    return spline


def _inner_spin_ratio(arm: Array) -> Array:
    """Solve H(k) = arm on [0, 1] by two Newton steps from the table."""
    k = np.clip(_first_guess()(arm), 0, 1)
    for _ in range(2):
        force, torque = _inner_profile(k)
        k = np.clip(k - (torque / force - arm) / _inner_slope(k), 0, 1)
    return np.where(arm < SMALL, 2 * arm, k)


def ring_spin_ratio(moment_arm: npt.ArrayLike) -> Array:
    """Inverse of ``H(k) = t(k) / f(k)``, the moment arm in units of R; self-dual like H."""
    arm = np.asarray(moment_arm, dtype=float)
    size = np.abs(arm)
    with np.errstate(divide="ignore", over="ignore"):
        inner = _inner_spin_ratio(np.atleast_1d(np.minimum(size, 1 / size))).reshape(arm.shape)
        return np.asarray(np.copysign(np.where(size > 1, 1 / inner, inner), arm))


@dataclass(frozen=True, slots=True, kw_only=True)
class RingFriction:
    """Coulomb friction between the ring and the support, its pressure even around the ring.

    Parameters
    ----------
    weight : float
        W > 0: the slider's weight times the coefficient of support friction.

    Raises
    ------
    InvalidValue
        Where the weight is not a positive finite number.
    """

    weight: float = 1.0

    def __post_init__(self) -> None:
        require_positive(
            "weight",
            self.weight,
            "leave the effect out of the scene if the support is frictionless",
        )

    @property
    def degree(self) -> int:
        return 1

    @property
    def kinks(self) -> tuple[float, ...]:
        return (1.0,)

    def scaled(self, length: float, force: float = 1.0) -> RingFriction:
        return replace(self, weight=self.weight / force)

    def potential(self, twist: Array) -> Array:
        """``(2 W / pi) (|v| + R |omega|) E(m)``, ``m = 4 |v| R |omega| / (|v| + R |omega|)^2``."""
        speed, spin = np.hypot(twist[..., 0], twist[..., 1]), np.abs(twist[..., 2])
        total = speed + spin
        share = np.divide(speed, total, out=np.ones_like(total), where=total > 0)
        return np.asarray(2 / np.pi * self.weight * total * ellipe(4 * share * (1 - share)))

    def wrench(self, twist: Array) -> Array:
        return isotropic_wrench(self, twist)

    def profile(self, spin_ratio: npt.ArrayLike) -> tuple[Array, Array]:
        force, torque = ring_profile(spin_ratio)
        return self.weight * force, self.weight * torque

    def spin_ratio(self, moment_arm: npt.ArrayLike) -> Array:
        return ring_spin_ratio(moment_arm)
