"""The ring's integrals, Eqs. (2)-(3), by quadrature rules that know nothing of their closed form.

All use ``|v|^2 = (1 - k)^2 + 4 k cos^2(theta / 2)`` for the square of a point's speed, which keeps its sign
next to the ring, and count the evaluations of an integrand.
"""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
from scipy.integrate import quad, tanhsinh

from planar_pushing.mechanics.plane import Array

#: Force, torque and evaluations of an integrand for each spin ratio.
Wrenches = tuple[Array, Array, Array]


def _square(k: Array, theta: Array) -> Array:
    return np.asarray((1 - k) ** 2 + 4 * k * np.cos(theta / 2) ** 2)


def _force(theta: Array, k: Array) -> Array:
    return np.asarray((1 + k * np.cos(theta)) / np.sqrt(_square(k, theta)))


def _torque(theta: Array, k: Array) -> Array:
    return np.asarray((k + np.cos(theta)) / np.sqrt(_square(k, theta)))


def _scalar_speed(theta: float, k: float) -> float:
    half = math.cos(theta / 2)
    return math.sqrt((1 - k) ** 2 + 4 * k * half * half)


def _scalar_force(theta: float, k: float) -> float:
    return (1 + k * math.cos(theta)) / _scalar_speed(theta, k)


def _scalar_torque(theta: float, k: float) -> float:
    return (k + math.cos(theta)) / _scalar_speed(theta, k)


def _weighted(k: Array, theta: Array, weight: Array) -> Wrenches:
    column = k[:, None]
    cosine, speed = np.cos(theta), np.sqrt(_square(column, theta))
    # Not a matrix product: its threads would wait for one another, and its order of sums varies.
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
    """`scipy.integrate.quad` on half the ring, one spin ratio after the other."""
    rows = [_adaptive(float(each), tolerance) for each in k]
    force, torque, count = np.array(rows).T
    return force, torque, count.astype(int)


def _adaptive(k: float, tolerance: float) -> tuple[float, float, int]:
    limits = {"epsabs": tolerance, "epsrel": tolerance, "limit": 200, "full_output": 1}
    force, torque = (
        quad(function, 0, math.pi, args=(k,), **limits)
        for function in (_scalar_force, _scalar_torque)
    )
    return force[0] / math.pi, torque[0] / math.pi, force[2]["neval"] + torque[2]["neval"]


def tanh_sinh(k: Array, tolerance: float) -> Wrenches:
    """`scipy.integrate.tanhsinh` on half the ring."""
    force, torque = (
        tanhsinh(function, 0, np.pi, args=(k,), rtol=tolerance, atol=tolerance)
        for function in (_force, _torque)
    )
    return (
        force.integral / np.pi,
        torque.integral / np.pi,
        np.asarray(force.nfev + torque.nfev, dtype=int),
    )
