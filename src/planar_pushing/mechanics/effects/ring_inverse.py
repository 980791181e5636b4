"""Spin ratio of a ring's friction from the moment arm, the inverse of ``H(k) = t(k) / f(k)`` (Eq. 7)."""

from __future__ import annotations

from functools import cache

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.effects.ring_profile import blocks, inner_profile
from planar_pushing.mechanics.planar import Array

#: Below this moment arm the spin ratio is twice the arm to the last place.
SMALL = 1e-9


@cache
def _table() -> tuple[Array, Array]:
    """H's graph on [0, 1] read sideways, with nodes that crowd towards k = 1.

    Moment arms, shape (n,), and from each to the next the coefficients of a cubic Hermite polynomial in
    the distance from it, shape (n - 1, 4), the constant last.
    """
    k = np.append(np.linspace(0, 0.9, 256), 1 - np.append(np.geomspace(0.099, 1e-13, 480), 0))
    force, torque, slope = inner_profile(k)
    arm = torque / force
    rate = force / (slope * (1 + arm * k))
    step = np.diff(arm)
    chord = np.diff(k) / step
    first, last = rate[:-1] - chord, rate[1:] - chord
    return arm, np.stack(
        [(first + last) / step**2, -(2 * first + last) / step, rate[:-1], k[:-1]], -1
    )


def _first_guess(arm: Array) -> Array:
    """Spin ratio to 1e-9, and next to k = 1 to 1e-7 of 1 - k: one Newton step is enough."""
    nodes, coefficients = _table()
    piece = np.searchsorted(nodes[1:-1], arm, side="right")
    cubic, square, rate, k = coefficients[piece].T
    step = arm - nodes[piece]
    return np.asarray(((cubic * step + square) * step + rate) * step + k)


def _inner_spin_ratio(arm: Array) -> Array:
    """Solve ``t(k) - arm f(k) = 0`` on [0, 1] by one Newton step from the table, with f' = -k t'."""
    k = np.clip(_first_guess(arm), 0, 1)
    force, torque, slope = inner_profile(k)
    k -= (torque - arm * force) / (slope * (1 + arm * k))
    return np.where(arm < SMALL, 2 * arm, np.clip(k, 0, 1, out=k))


def _spin_ratio(arm: Array) -> Array:
    size = np.abs(arm)
    outside = np.flatnonzero(size > 1)
    k = _inner_spin_ratio(np.minimum(size, 1 / size))
    k[outside] = 1 / k[outside]
    return np.copysign(k, arm, out=k)


def ring_spin_ratio(moment_arm: npt.ArrayLike) -> Array:
    """Inverse of ``H(k) = t(k) / f(k)``, the moment arm in units of R; self-dual like H."""
    arm = np.asarray(moment_arm, dtype=float)
    flat, k = arm.ravel(), np.empty(arm.size)
    with np.errstate(divide="ignore", over="ignore"):
        for part in blocks(arm.size):
            k[part] = _spin_ratio(flat[part])
    return k.reshape(arm.shape)
