"""Friction of any support pressure."""

from __future__ import annotations

from math import copysign, sqrt
from typing import NamedTuple

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.effects.base import SUPPORT, WEIGHT
from planar_pushing.mechanics.supports.moments import moments
from planar_pushing.mechanics.supports.pressure.record import Pressure

#: A centre of rotation further away than this, in largest distances of the support, acts like one there, but
#: for its torque, which falls with the distance.
FARTHEST = 1e9
#: From here on the force follows the motion of the centre of pressure to what a slope needs.
FAR = 1e3
#: Square of the radius of gyration that stands for a support in a first guess, in its largest distances.
ROUGH = 0.6


class Support(NamedTuple):
    """Friction of a pressure in the compiled core."""

    weight: float
    pressure: Pressure


@compiled
def made(effect, row):
    return Support(row[WEIGHT], effect.pressure)


@compiled
def gradient(effect, x, y, spin):
    pressure, weight = effect.pressure, effect.weight
    p_x, p_y = pressure.center_x, pressure.center_y
    w_x, w_y = x - spin * p_y, y + spin * p_x
    speed = sqrt(w_x * w_x + w_y * w_y)
    turn = copysign(max(abs(spin), speed / (FARTHEST * pressure.extent)), spin)
    c_x, c_y = -w_y / turn, w_x / turn
    _, g_x, g_y, torque, h_xx, h_xy, h_yy, _ = moments(pressure, p_x + c_x, p_y + c_y)
    sign, part = copysign(weight, turn), weight / abs(turn)
    f_x, f_y = -sign * g_y, sign * g_x
    xx, xy, yy = part * h_yy, -part * h_xy, part * h_xx
    if c_x * c_x + c_y * c_y > (FAR * pressure.extent) ** 2:
        b_x, b_y, bend = 0.0, 0.0, part * torque
    else:
        b_x, b_y = -(xx * w_x + xy * w_y) / turn, -(xy * w_x + yy * w_y) / turn
        bend = -(b_x * w_x + b_y * w_y) / turn
    torque *= part * spin
    # From the centre of pressure, whose motion is w, to the origin.
    a_x, a_y = -xx * p_y + xy * p_x, -xy * p_y + yy * p_x
    bend += -p_y * (2.0 * b_x + a_x) + p_x * (2.0 * b_y + a_y)
    return f_x, f_y, torque + p_x * f_y - p_y * f_x, xx, xy, yy, b_x + a_x, b_y + a_y, bend


@compiled
def wrench_about(effect, c_x, c_y, spin):
    pressure = effect.pressure
    _, g_x, g_y, torque, _, _, _, _ = moments(pressure, c_x, c_y)
    sign = copysign(effect.weight, spin)
    f_x, f_y = -sign * g_y, sign * g_x
    return f_x, f_y, sign * torque + pressure.center_x * f_y - pressure.center_y * f_x


@compiled
def rough(effect):
    pressure = effect.pressure
    return pressure.center_x, pressure.center_y, ROUGH * pressure.extent * pressure.extent


@compiled
def fastest(effect, length):
    # A faster rotation costs more than the whole translation without one.
    return 2.0 / moments(effect.pressure, -length, 0.0)[0]
