"""How friction of any support slows a free slider in a step: the least of ``|v+ - v|_M^2 / 2 + h D(v+)``.

Motions are those of the centre of mass, seen from the body frame. The potential has its kink at rest, so
rest is tried first: a motion v leaves it if its power ``v . M v-`` is more than friction's, ``h D(v)``. If
one does, that of the least ``D(v)^2 / 2 - v . M v-`` does.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.compiled import compiled, generic, owning
from planar_pushing.mechanics.effects.base import gradient

#: Newton steps at most, and trials of one; what a step has to leave of the slope at most; and relative size
#: of a step after which the error is far below the scheme's own.
STEPS, CUTS, ENOUGH, SETTLED = 60, 12, 0.5, 1e-11
#: Curvature that a potential has in every direction, relative to its own: two points may leave it none.
FLAT = 1e-12


class Slowing(NamedTuple):
    """The potential of the step; masses in the three parts of the motion, the motion before, and h."""

    effects: tuple[Any, ...]
    masses: Any
    before: Any
    size: float


class Leaving(NamedTuple):
    """Half of the square of friction's power, less the power of the momentum."""

    effects: tuple[Any, ...]
    masses: Any
    before: Any


@compiled
def _friction(effects, now, slopes, bend):
    """Force and torque of friction about the centre of mass, and their derivatives by the motion."""
    _, _, c_x, c_y = effects[1]
    x, y, spin = now[0] + now[2] * c_y, now[1] - now[2] * c_x, now[2]
    f_x, f_y, torque, xx, xy, yy, xs, ys, ss = gradient(effects[0], x, y, spin)
    slopes[0], slopes[1], slopes[2] = f_x, f_y, torque - c_x * f_y + c_y * f_x
    a_x, a_y = xx * c_y - xy * c_x, xy * c_y - yy * c_x
    bend[0, 0], bend[0, 1], bend[0, 2] = xx, xy, xs + a_x
    bend[1, 0], bend[1, 1], bend[1, 2] = xy, yy, ys + a_y
    turn = ss + c_y * (2.0 * xs + a_x) - c_x * (2.0 * ys + a_y)
    bend[2, 0], bend[2, 1], bend[2, 2] = bend[0, 2], bend[1, 2], turn


@compiled
def _product(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@generic
def _slopes(kind: Any) -> Callable[..., Any]:
    """Slopes of a potential at a motion, and its second derivatives: potential, motion, and both."""
    return _of_slowing if kind is Slowing else _of_leaving


@compiled
def _of_slowing(of, now, slopes, bend):
    _friction(of.effects, now, slopes, bend)
    for i in range(3):
        slopes[i] = of.masses[i] * (now[i] - of.before[i]) + of.size * slopes[i]
        for j in range(3):
            bend[i, j] *= of.size
        bend[i, i] += of.masses[i]


@compiled
def _of_leaving(of, now, slopes, bend):
    _friction(of.effects, now, slopes, bend)
    power, scale = _product(slopes, now), 0.0
    for i in range(3):
        scale += of.masses[i] * now[i] * now[i]
    for i in range(3):
        for j in range(3):
            bend[i, j] = slopes[i] * slopes[j] + power * bend[i, j]
        bend[i, i] += FLAT * power * power / scale * of.masses[i]
    for i in range(3):
        slopes[i] = power * slopes[i] - of.masses[i] * of.before[i]


@owning
def _least(of, now):
    """Take a motion to the least of a potential: Newton's method.

    A step after which the convex potential rises is cut to where the secant of its slope is zero.
    """
    slopes, bend = np.empty(3), np.empty((3, 3))
    _slopes(of, now, slopes, bend)
    for _ in range(STEPS):
        step = np.linalg.solve(bend, -slopes)
        slope, part, start = _product(slopes, step), 1.0, now.copy()
        for _ in range(CUTS):
            now[:] = start + part * step
            _slopes(of, now, slopes, bend)
            last = _product(slopes, step)
            if abs(last) <= ENOUGH * abs(slope):
                break
            part *= slope / (slope - last) if last > 0.0 else 2.0
        if np.abs(part * step).max() <= SETTLED * np.abs(now).max():
            break


@owning
def _left(of, now):
    """Part of a motion that has the least potential of the step on its line; below 0 it is rest."""
    slopes, bend = np.empty(3), np.empty((3, 3))
    _friction(of.effects, now, slopes, bend)
    power = ((of.masses * of.before - of.size * slopes) * now).sum()
    return power / (of.masses * now * now).sum()


@owning
def slowed(effects, own, v_x, v_y, spin, size):
    """As `slowing.slowed`."""
    if v_x == 0.0 and v_y == 0.0 and spin == 0.0:
        return 0.0, 0.0, 0.0
    mass, gyration, _, _ = effects[1]
    before = np.array([v_x * own.x + v_y * own.y, v_y * own.x - v_x * own.y, spin])
    of = Slowing(effects, np.array([mass, mass, mass * gyration]), before, size)
    now = before.copy()
    left = _left(of, now)
    if left <= 0.0:
        _least(Leaving(effects, of.masses, before), now)
        left = _left(of, now)
    if left <= 0.0:
        return 0.0, 0.0, 0.0
    now *= left
    _least(of, now)
    return now[0] * own.x - now[1] * own.y, now[0] * own.y + now[1] * own.x, now[2]
