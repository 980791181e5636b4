"""How friction of any support slows a free slider in a step: the least of ``|v+ - v|_M^2 / 2 + h D(v+)``.

Newton's method in the three parts of the motion of the centre of mass, seen from the body frame. A step
after which the convex potential rises is cut to where the secant of its slope is zero.
"""

from __future__ import annotations

from math import sqrt

import numpy as np

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.effects.base import gradient

#: Newton steps at most, and trials of one; what a step has to leave of the slope at most; relative size of
#: a step after which the error is far below the scheme's own; and the part of the motion that is rest.
STEPS, CUTS, ENOUGH, SETTLED, REST = 60, 12, 0.5, 1e-11, 1e-9


@compiled
def _slopes(effects, before, now, size, slopes, bend):
    """Slopes of the potential at a motion, and its second derivatives."""
    mass, gyration, c_x, c_y = effects[1]
    x, y, spin = now[0] + now[2] * c_y, now[1] - now[2] * c_x, now[2]
    f_x, f_y, torque, xx, xy, yy, xs, ys, ss = gradient(effects[0], x, y, spin)
    torque -= c_x * f_y - c_y * f_x
    a_x, a_y = xx * c_y - xy * c_x, xy * c_y - yy * c_x
    slopes[0] = mass * (now[0] - before[0]) + size * f_x
    slopes[1] = mass * (now[1] - before[1]) + size * f_y
    slopes[2] = mass * gyration * (now[2] - before[2]) + size * torque
    bend[0, 0], bend[0, 1], bend[0, 2] = mass + size * xx, size * xy, size * (xs + a_x)
    bend[1, 0], bend[1, 1], bend[1, 2] = size * xy, mass + size * yy, size * (ys + a_y)
    turn = ss + c_y * (2.0 * xs + a_x) - c_x * (2.0 * ys + a_y)
    bend[2, 0], bend[2, 1], bend[2, 2] = bend[0, 2], bend[1, 2], mass * gyration + size * turn


@compiled
def slowed(effects, own, v_x, v_y, spin, size):
    """As `slowing.slowed`."""
    before = np.array([v_x * own.x + v_y * own.y, v_y * own.x - v_x * own.y, spin])
    whole = sqrt(before[0] ** 2 + before[1] ** 2 + effects[1].gyration * spin * spin)
    if whole == 0.0:
        return 0.0, 0.0, 0.0
    now, slopes, bend = before.copy(), np.empty(3), np.empty((3, 3))
    _slopes(effects, before, now, size, slopes, bend)
    for _ in range(STEPS):
        step = np.linalg.solve(bend, -slopes)
        slope, part, start = (slopes * step).sum(), 1.0, now.copy()
        for _ in range(CUTS):
            now[:] = start + part * step
            _slopes(effects, before, now, size, slopes, bend)
            last = (slopes * step).sum()
            if abs(last) <= ENOUGH * abs(slope):
                break
            part *= slope / (slope - last) if last > 0.0 else 2.0
        if np.abs(part * step).max() <= SETTLED * np.abs(now).max():
            break
    left = sqrt(now[0] ** 2 + now[1] ** 2 + effects[1].gyration * now[2] ** 2)
    if left <= REST * whole:
        return 0.0, 0.0, 0.0
    return now[0] * own.x - now[1] * own.y, now[0] * own.y + now[1] * own.x, now[2]
