"""Friction of any support pressure."""

from __future__ import annotations

from math import copysign, sqrt
from typing import NamedTuple

from planar_pushing.mechanics.compiled import compiled, owning
from planar_pushing.mechanics.effects.base import SCALE, SUPPORT, WEIGHT
from planar_pushing.mechanics.supports.moments import moments
from planar_pushing.mechanics.supports.pressure.record import ATOMS, SEGMENTS, Pressure
from planar_pushing.mechanics.supports.pressure.table import Table, pressure_of

#: A centre of rotation further away than this, in the support's extents, acts like one there, but for its
#: torque, which falls with the distance.
FARTHEST = 1e9
#: From here on the force follows the motion of the centre of pressure to what a slope needs.
FAR = 1e3


class Supports(NamedTuple):
    """Pressures, of which a scene has one."""

    table: Table


class Support(NamedTuple):
    """Friction of a pressure: weight, extent in radii, and the pressure in units of the extent."""

    weight: float
    extent: float
    pressure: Pressure


@owning
def made(effect, row):
    return Support(row[WEIGHT], row[SCALE], pressure_of(effect.table, int(row[SUPPORT])))


@compiled
def gradient(effect, x, y, spin):
    weight, extent, pressure = effect
    p_x, p_y, rate = pressure.center_x, pressure.center_y, spin * extent
    w_x, w_y = x - rate * p_y, y + rate * p_x
    speed = sqrt(w_x * w_x + w_y * w_y)
    turn = copysign(max(abs(rate), speed / FARTHEST), rate)
    c_x, c_y = -w_y / turn, w_x / turn
    _, g_x, g_y, torque, h_xx, h_xy, h_yy, _ = moments(pressure, p_x + c_x, p_y + c_y)
    sign, part = copysign(weight, turn), weight / abs(turn)
    f_x, f_y = -sign * g_y, sign * g_x
    xx, xy, yy = part * h_yy, -part * h_xy, part * h_xx
    if c_x * c_x + c_y * c_y > FAR * FAR:
        b_x, b_y, bend = (
            0.0,
            0.0,
            weight / speed * _spread_along(pressure, w_x / speed, w_y / speed),
        )
    else:
        b_x, b_y = -(xx * w_x + xy * w_y) / turn, -(xy * w_x + yy * w_y) / turn
        bend = -(b_x * w_x + b_y * w_y) / turn
    # From the centre of pressure, whose motion is w, to the origin; and from extents to radii.
    torque = part * rate * torque + p_x * f_y - p_y * f_x
    a_x, a_y = -xx * p_y + xy * p_x, -xy * p_y + yy * p_x
    bend += -p_y * (2.0 * b_x + a_x) + p_x * (2.0 * b_y + a_y)
    xs, ys = extent * (b_x + a_x), extent * (b_y + a_y)
    return f_x, f_y, extent * torque, xx, xy, yy, xs, ys, extent * extent * bend


@compiled
def _spread_along(pressure, x, y):
    """Mean square of the places' parts in a direction: what a translation resists a rotation with."""
    xx, xy, yy = pressure.spread
    return xx * x * x + 2.0 * xy * x * y + yy * y * y


@compiled
def _atom(pressure, i):
    """Place of an atom, and its share."""
    row = pressure.starts[ATOMS] + i
    return pressure.rows[row, 0], pressure.rows[row, 1], pressure.rows[row, 2]


@compiled
def outward(effect, x, y):
    return x, y


@compiled
def count_points(effect):
    return effect.pressure.starts[SEGMENTS] - effect.pressure.starts[ATOMS]


@compiled
def wrench_about(effect, i, spin, c_x, c_y):
    weight, extent, pressure = effect
    _, g_x, g_y, torque, _, _, _, _ = moments(pressure, *_atom(pressure, i)[:2])
    sign = copysign(weight, spin)
    f_x, f_y = -sign * g_y, sign * g_x
    arm = pressure.center_x * f_y - pressure.center_y * f_x
    return f_x, f_y, extent * (sign * torque + arm)


@compiled
def rough(effect):
    extent, pressure = effect.extent, effect.pressure
    xx, _, yy = pressure.spread
    return extent * pressure.center_x, extent * pressure.center_y, (xx + yy) * extent * extent


@compiled
def fastest(effect, length):
    # A faster rotation costs more than the whole translation without one.
    return 2.0 / (effect.extent * moments(effect.pressure, -length / effect.extent, 0.0)[0])


@compiled
def point(effect, i):
    x, y, share = _atom(effect.pressure, i)
    return effect.extent * x, effect.extent * y, effect.weight * share
