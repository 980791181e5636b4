"""Friction of an arbitrary pressure distribution in the compiled core."""

from __future__ import annotations

from math import copysign, sqrt
from typing import NamedTuple

from planar_pushing.simulation.legacy.base import Resistance, moment_of, no_energy, no_pull
from planar_pushing.simulation.legacy.compiled import compiled, owning
from planar_pushing.simulation.legacy.moments import moments_within
from planar_pushing.simulation.legacy.pressure import ATOMS, SEGMENTS, Pressure
from planar_pushing.simulation.legacy.table import Table, pressure_of

#: A center of rotation farther away than this, in extents of the support, is moved to this distance; only
#: the torque still decreases with the true distance.
FARTHEST = 1e9
#: Beyond this distance the force is along the motion of the center of pressure, to the accuracy of a slope.
FAR = 1e3
#: Rounding error of a sum over pieces, in units of that of its largest term; measured on polygons (4e-15).
TERMS = 8.0
#: Degree of homogeneity.
DEGREE = 1


class Supports(NamedTuple):
    """Table of pressures, one of which belongs to a scene."""

    table: Table


class Support(NamedTuple):
    """Friction of a pressure. The pressure is in units of the extent, and the extent in radii."""

    weight: float
    extent: float
    pressure: Pressure


@owning
def made(effect, row, i):
    return Support(row[i], row[i + 1], pressure_of(effect.table, int(row[i + 2])))


@compiled
def count_fields(effect):
    return 3


@compiled
def resistance(effect, x, y, spin, blur):
    weight, extent, pressure = effect
    p_x, p_y, rate = pressure.center_x, pressure.center_y, spin * extent
    w_x, w_y = x - rate * p_y, y + rate * p_x
    speed = sqrt(w_x * w_x + w_y * w_y)
    turn = copysign(max(abs(rate), speed / FARTHEST), rate)
    c_x, c_y = -w_y / turn, w_x / turn
    now = moments_within(pressure, p_x + c_x, p_y + c_y, blur / abs(turn))
    most = weight * pressure.rows[pressure.starts[ATOMS] + now.atom, 2] if now.atom >= 0 else 0.0
    sign, part = copysign(weight, turn), weight / abs(turn)
    f_x, f_y = -sign * now.unit_y, sign * now.unit_x
    xx, xy, yy = part * now.yy, -part * now.xy, part * now.xx
    if c_x * c_x + c_y * c_y > FAR * FAR:
        b_x, b_y, bend = (
            0.0,
            0.0,
            weight / speed * _spread_along(pressure, w_x / speed, w_y / speed),
        )
    else:
        b_x, b_y = -(xx * w_x + xy * w_y) / turn, -(xy * w_x + yy * w_y) / turn
        bend = -(b_x * w_x + b_y * w_y) / turn
    # From the center of pressure, whose motion is w, to the origin; and from extents to radii.
    torque = part * rate * now.torque + p_x * f_y - p_y * f_x
    a_x, a_y = -xx * p_y + xy * p_x, -xy * p_y + yy * p_x
    bend += -p_y * (2.0 * b_x + a_x) + p_x * (2.0 * b_y + a_y)
    xs, ys = extent * (b_x + a_x), extent * (b_y + a_y)
    ss = extent * extent * bend
    return Resistance(
        f_x, f_y, extent * torque, xx, xy, yy, xs, ys, ss, most, now.atom, TERMS * weight
    )


@compiled
def _spread_along(pressure, x, y):
    """Mean square of the positions along a direction: the stiffness of a translation to rotation."""
    xx, xy, yy = pressure.spread
    return xx * x * x + 2.0 * xy * x * y + yy * y * y


@compiled
def moment(effect, speed, x, y):
    extent, (xx, _, yy) = effect.extent, effect.pressure.spread
    own_x, own_y = extent * effect.pressure.center_x, extent * effect.pressure.center_y
    return moment_of(effect.weight / speed, (xx + yy) * extent * extent, own_x - x, own_y - y)


@compiled
def count_points(effect):
    return effect.pressure.starts[SEGMENTS] - effect.pressure.starts[ATOMS]


@compiled
def place(effect, i):
    row, extent = effect.pressure.starts[ATOMS] + i, effect.extent
    return extent * effect.pressure.rows[row, 0], extent * effect.pressure.rows[row, 1]


pull, energy = no_pull, no_energy
