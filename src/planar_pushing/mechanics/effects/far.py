"""Second derivatives of support friction for a slider that nearly translates.

If the center of rotation is far away, the sums for the second derivatives with respect to the rotation
cancel. Those of `resistance` are good enough for Newton's method only, with relative errors up to 1e-3. The
wrench itself is accurate and smooth there, and its differences over small rotations give these derivatives
to ten digits.
"""

from __future__ import annotations

from collections.abc import Callable
from math import sqrt
from typing import Any

from planar_pushing.mechanics.compiled import compiled, generic
from planar_pushing.mechanics.effects.any_support import FAR, Support
from planar_pushing.mechanics.effects.base import resistance

#: Step of the rotation, in speeds per extent, of the fourth-order differences.
STEP = 1e-3


@compiled
def _none(effect, x, y, spin):
    return 0.0, 0.0, 0.0


@compiled
def _turned(effect, w_x, w_y, rate):
    """Force, and torque about the center of pressure, which moves by (w_x, w_y); lengths in extents."""
    p_x, p_y = effect.pressure.center_x, effect.pressure.center_y
    x, y = w_x + rate * p_y, w_y - rate * p_x
    now = resistance(effect, x, y, rate / effect.extent, 0.0)
    return now.f_x, now.f_y, now.torque / effect.extent - (p_x * now.f_y - p_y * now.f_x)


@compiled
def _of_support(effect, x, y, spin):
    extent, p_x, p_y = effect.extent, effect.pressure.center_x, effect.pressure.center_y
    rate = spin * extent
    w_x, w_y = x - rate * p_y, y + rate * p_x
    speed = sqrt(w_x * w_x + w_y * w_y)
    if speed <= FAR * abs(rate):
        return 0.0, 0.0, 0.0
    b_x, b_y, bend, step = 0.0, 0.0, 0.0, STEP * speed
    for k, part in ((1.0, 8.0), (-1.0, -8.0), (2.0, -1.0), (-2.0, 1.0)):
        f_x, f_y, torque = _turned(effect, w_x, w_y, rate + k * step)
        size = part / (12.0 * step)
        b_x, b_y, bend = b_x + size * f_x, b_y + size * f_y, bend + size * torque
    now = resistance(effect, x, y, spin, 0.0)
    a_x, a_y = now.xy * p_x - now.xx * p_y, now.yy * p_x - now.xy * p_y
    whole = bend - p_y * (2.0 * b_x + a_x) + p_x * (2.0 * b_y + a_y)
    return (
        extent * (b_x + a_x) - now.xs, extent * (b_y + a_y) - now.ys, extent * extent * whole - now.ss
    )  # fmt: skip


@compiled
def _first(effects, x, y, spin):
    return far_terms(effects[0], x, y, spin)


@compiled
def _all(effects, x, y, spin):
    one, other = far_terms(effects[0], x, y, spin), far_terms(effects[1:], x, y, spin)
    return one[0] + other[0], one[1] + other[1], one[2] + other[2]


@generic
def far_terms(kinds: Any) -> Callable[..., Any]:
    """Corrections to xs, ys and ss of `resistance`: effect or effects, x, y, spin."""
    if isinstance(kinds, tuple):
        return _first if len(kinds) == 1 else _all
    return _of_support if kinds is Support else _none
