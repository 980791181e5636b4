"""The ring's integrals, Eqs. (2)-(3), by quadrature rules that do not use their closed form.

The squared speed of a point is ``(1 - k)^2 + 4 k cos^2(theta / 2)``, which cannot become negative near
the ring. Each rule returns force, torque and evaluations of an integrand, all of shape (n,).
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any

import numpy as np
from scipy.integrate import quad, tanhsinh

from planar_pushing.mechanics.plane import Array

#: Force, torque and evaluations of an integrand for each spin ratio.
Wrenches = tuple[Array, Array, Array]


def _speed(theta: Any, k: Any, cos: Any, sqrt: Any) -> Any:
    half = cos(theta / 2)
    return sqrt((1 - k) ** 2 + 4 * k * half * half)


def _force(theta: Any, k: Any, cos: Any = np.cos, sqrt: Any = np.sqrt) -> Any:
    return (1 + k * cos(theta)) / _speed(theta, k, cos, sqrt)


def _torque(theta: Any, k: Any, cos: Any = np.cos, sqrt: Any = np.sqrt) -> Any:
    return (k + cos(theta)) / _speed(theta, k, cos, sqrt)


def _weighted(k: Array, theta: Array, weight: Array) -> Wrenches:
    column, cosine = k[:, None], np.cos(theta)
    speed = _speed(theta, column, np.cos, np.sqrt)
    # Not a matrix product: its threads would wait for one another, and its order of summation varies.
    force = ((1 + column * cosine) / speed * weight).sum(axis=1)
    torque = ((column + cosine) / speed * weight).sum(axis=1)
    return force, torque, np.full(k.shape, 2 * theta.size)


def trapezoid(k: Array, points: float) -> Wrenches:
    """Trapezoid rule with N points, shifted by half a step: the ring as N point supports."""
    count = int(points)
    theta = 2 * np.pi * (np.arange(count) + 0.5) / count
    return _weighted(k, theta, np.full(count, 1 / count))


@lru_cache
def _legendre(count: int) -> tuple[Array, Array]:
    nodes, weights = np.polynomial.legendre.leggauss(count)
    return np.pi * (nodes + 1) / 2, weights / 2


def gauss_legendre(k: Array, points: float) -> Wrenches:
    """Gauss-Legendre rule on half the ring; nodes and weights are computed once."""
    return _weighted(k, *_legendre(int(points)))


def adaptive(k: Array, tolerance: float) -> Wrenches:
    """`scipy.integrate.quad` on half the ring, one spin ratio at a time."""
    rows = [_adaptive(float(each), tolerance) for each in k]
    force, torque, count = np.array(rows).T
    return force, torque, count.astype(int)


def _adaptive(k: float, tolerance: float) -> tuple[float, float, int]:
    limits = {"epsabs": tolerance, "epsrel": tolerance, "limit": 200, "full_output": 1}
    force, torque = (
        quad(integrand, 0, math.pi, args=(k, math.cos, math.sqrt), **limits)
        for integrand in (_force, _torque)
    )
    return force[0] / math.pi, torque[0] / math.pi, force[2]["neval"] + torque[2]["neval"]


def tanh_sinh(k: Array, tolerance: float) -> Wrenches:
    """`scipy.integrate.tanhsinh` on half the ring."""
    force, torque = (
        tanhsinh(integrand, 0, np.pi, args=(k,), rtol=tolerance, atol=tolerance)
        for integrand in (_force, _torque)
    )
    count = np.asarray(force.nfev + torque.nfev, dtype=int)
    return force.integral / np.pi, torque.integral / np.pi, count
