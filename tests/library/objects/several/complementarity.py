"""Solutions of several contacts by Newton's method on complementarity conditions, which know no modes.

The friction of feet is smoothed: a foot that moves by v resists along ``v / sqrt(v . v + e e)``. A contact
has a force across (p) and along (q) its tangent, and rates a and b of its gap and its slip, with
``p = max(0, p - r a)`` and ``q = clip(q - r b, -mu p, mu p)``. All starts move at once, each with a number
r of its own. No code of the package is used.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np


class Problem(NamedTuple):
    """Feet with shares, a mass matrix, and contacts: points, unit normals, velocities, coefficients."""

    feet: np.ndarray
    shares: np.ndarray
    mass: np.ndarray
    points: np.ndarray
    normals: np.ndarray
    velocities: np.ndarray
    friction: np.ndarray


def resistance(problem, twists, smooth, slopes):
    """Wrenches of twists of shape (k, 3), and their derivatives if they are needed."""
    jac = np.zeros((len(problem.feet), 2, 3))
    jac[:, 0, 0] = jac[:, 1, 1] = 1.0
    jac[:, 0, 2], jac[:, 1, 2] = -problem.feet[:, 1], problem.feet[:, 0]
    v = np.einsum("jai,ki->kja", jac, twists)
    speed = np.sqrt((v**2).sum(-1) + smooth**2)
    e = v / speed[..., None]
    wrench = np.einsum("j,kja,jai->ki", problem.shares, e, jac) + twists @ problem.mass.T
    if not slopes:
        return wrench, None
    across = np.eye(2) - e[..., :, None] * e[..., None, :]
    across *= (problem.shares / speed)[..., None, None]
    slope = np.einsum("jai,kjab,jbm->kim", jac, across, jac) + problem.mass
    return wrench, slope


def rows_of(problem):
    """Rows of the motions across and along each contact, and the motions of the pushers."""
    n = problem.normals
    t = np.stack([n[:, 1], -n[:, 0]], -1)
    p = problem.points

    def row(d):
        return np.column_stack([d, p[:, 0] * d[:, 1] - p[:, 1] * d[:, 0]])

    w = problem.velocities
    return row(n), row(t), (n * w).sum(1), (t * w).sum(1)


def conditions(problem, z, r, smooth, slopes=False):
    """Residuals of the unknowns (twist, p, q) of shape (k, 3 + 2 n), and derivatives if needed."""
    n = len(problem.points)
    normal, tangent, across, along = rows_of(problem)
    twists, p, q = z[:, :3], z[:, 3 : 3 + n], z[:, 3 + n :]
    wrench, slope = resistance(problem, twists, smooth, slopes)
    a, b = twists @ normal.T - across, twists @ tangent.T - along
    residual = np.empty_like(z)
    residual[:, :3] = wrench - p @ normal - q @ tangent
    pressed = p - r * a
    shut = pressed > 0.0
    residual[:, 3 : 3 + n] = p - np.where(shut, pressed, 0.0)
    bound = problem.friction * np.where(shut, pressed, 0.0)
    moved = q - r * b
    side = np.where(moved > bound, 1.0, np.where(moved < -bound, -1.0, 0.0))
    residual[:, 3 + n :] = q - np.where(side == 0.0, moved, side * bound)
    if not slopes:
        return residual, None
    jac = np.zeros((len(z), 3 + 2 * n, 3 + 2 * n))
    jac[:, :3, :3], jac[:, :3, 3 : 3 + n], jac[:, :3, 3 + n :] = slope, -normal.T, -tangent.T
    for i in range(n):
        jac[:, 3 + i, :3] = np.where(shut[:, i, None], r * normal[i], 0.0)
        jac[:, 3 + i, 3 + i] = np.where(shut[:, i], 0.0, 1.0)
        slides = side[:, i] * problem.friction[i] * shut[:, i]
        stick = (side[:, i] == 0.0)[:, None]
        jac[:, 3 + n + i, :3] = np.where(stick, r * tangent[i], slides[:, None] * r * normal[i])
        jac[:, 3 + n + i, 3 + i] = -slides
        jac[:, 3 + n + i, 3 + n + i] = np.where(side[:, i] == 0.0, 0.0, 1.0)
    return residual, jac


def newton_step(jac, residual):
    """The steps of Newton's method; the shortest ones if a derivative is singular."""
    right = residual[..., None]
    try:
        return np.linalg.solve(jac + 1e-12 * np.eye(jac.shape[-1]), right)[..., 0]
    except np.linalg.LinAlgError:
        return (np.linalg.pinv(jac) @ right)[..., 0]


def roots(problem, starts=600, steps=70, smooth=1e-7, seed=0, near=()):
    """Twists and forces that satisfy all conditions, shape (m, 3 + 2 n), from random starts.

    Each of `near` is a twist around which there are starts, too.
    """
    rng = np.random.default_rng(seed)
    n, weight = len(problem.points), problem.shares.sum() + np.trace(problem.mass)
    speed = np.hypot(*problem.velocities.T).max()
    sizes = 10.0 ** rng.uniform(-1.0, 1.0, (starts, 1))
    twists = rng.normal(size=(starts, 3)) * speed * sizes
    normal, tangent, across, along = rows_of(problem)
    for k in range(starts // 2):  # the nearest twists that meet some of the pushers
        rows, values = [], []
        for i in range(n):
            kind = rng.integers(0, 3)
            if kind > 0:
                rows.append(normal[i])
                values.append(across[i])
            if kind > 1:
                rows.append(tangent[i])
                values.append(along[i])
        if rows:
            rows, values = np.array(rows), np.array(values)
            twists[k] += np.linalg.lstsq(rows, values - rows @ twists[k], rcond=1e-9)[0]
    twists[:3] *= 1e-9
    p = weight * rng.exponential(1.0, (starts, n)) * 10.0 ** rng.uniform(-0.5, 1.0, (starts, 1))
    p *= rng.integers(0, 2, (starts, n))
    q = rng.uniform(-1.0, 1.0, (starts, n)) * problem.friction * p
    z = np.concatenate([twists, p, q], 1)
    for i, twist in enumerate(near):
        z[3 + 5 * i : 8 + 5 * i, :3] = twist * (1.0 + 1e-4 * rng.normal(size=(5, 3)))
    r = 10.0 ** rng.uniform(-1.0, 1.0, (starts, 1)) * weight / speed
    enough = 1e-11 * max(weight, speed)
    active = np.arange(starts)
    for _ in range(steps):
        now, scale = z[active], r[active]
        residual, jac = conditions(problem, now, scale, smooth, slopes=True)
        before = np.abs(residual).max(1)
        step = newton_step(jac, residual)
        step[~np.isfinite(step)] = 0.0
        best = now - step
        size = np.abs(conditions(problem, best, scale, smooth)[0]).max(1)
        for part in (0.5, 0.2, 0.05):
            poor = np.flatnonzero(size > 0.9 * before)
            trial = now[poor] - part * step[poor]
            value = np.abs(conditions(problem, trial, scale[poor], smooth)[0]).max(1)
            better = value < size[poor]
            best[poor[better]], size[poor[better]] = trial[better], value[better]
        best[~np.isfinite(best)] = 0.0
        z[active] = best
        active = active[size > enough]
        if not len(active):
            break
    residual = np.abs(conditions(problem, z, r, smooth)[0]).max(1)
    solved = z[(residual < 1e-9 * max(weight, speed)) & (np.abs(z).max(1) < 1e5)]
    distinct = []
    for one in solved:
        if not any(np.abs(one - o).max() < 1e-5 * (1.0 + np.abs(o).max()) for o in distinct):
            distinct.append(one)
    return distinct
