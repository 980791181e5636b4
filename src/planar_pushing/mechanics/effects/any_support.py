"""Friction of any support pressure.

A finger travels along the side that it pushes, so the line from it to the slider's centre, the rod, turns
in the slider: a support knows its body frame's first axis as it is seen from the rod.
"""

from __future__ import annotations

from collections.abc import Callable
from math import copysign, sqrt
from typing import Any, NamedTuple

from planar_pushing.mechanics.compiled import compiled, generic, owning
from planar_pushing.mechanics.effects.any_mass import MassAt
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
    """Friction of a pressure.

    Attributes
    ----------
    weight : float
    extent : float
        Of the support, in radii.
    pressure : Pressure
        In units of the extent.
    x, y : float
        The body frame's first axis in the frame of the rod.
    """

    weight: float
    extent: float
    pressure: Pressure
    x: float
    y: float


@owning
def made(effect, row):
    pressure = pressure_of(effect.table, int(row[SUPPORT]))
    return Support(row[WEIGHT], row[SCALE], pressure, 1.0, 0.0)


@compiled
def outward(effect, x, y):
    """A vector of the support's body frame in the frame of the rod."""
    return effect.x * x - effect.y * y, effect.y * x + effect.x * y


@compiled
def gradient(effect, x, y, spin):
    c, s = effect.x, effect.y
    own = _gradient_in_body(effect, c * x + s * y, c * y - s * x, spin)
    if c == 1.0:  # as under every fence
        return own
    f_x, f_y, torque, xx, xy, yy, xs, ys, ss = own
    f_x, f_y = outward(effect, f_x, f_y)
    xs, ys = outward(effect, xs, ys)
    across = c * s * (xx - yy) + (c * c - s * s) * xy
    one = c * c * xx - 2.0 * c * s * xy + s * s * yy
    other = s * s * xx + 2.0 * c * s * xy + c * c * yy
    return f_x, f_y, torque, one, across, other, xs, ys, ss


@compiled
def _gradient_in_body(effect, x, y, spin):
    weight, extent, pressure, _, _ = effect
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
def count_points(effect):
    """How many support points there are."""
    return effect.pressure.starts[SEGMENTS] - effect.pressure.starts[ATOMS]


@compiled
def wrench_about(effect, i, spin, c_x, c_y):
    weight, extent, pressure, _, _ = effect
    _, g_x, g_y, torque, _, _, _, _ = moments(pressure, *_atom(pressure, i)[:2])
    sign = copysign(weight, spin)
    f_x, f_y = -sign * g_y, sign * g_x
    arm = pressure.center_x * f_y - pressure.center_y * f_x
    return *outward(effect, f_x, f_y), extent * (sign * torque + arm)


@compiled
def rough(effect):
    extent, pressure = effect.extent, effect.pressure
    (xx, _, yy), (x, y) = pressure.spread, outward(effect, pressure.center_x, pressure.center_y)
    return extent * x, extent * y, (xx + yy) * extent * extent


@compiled
def fastest(effect, length):
    # A faster rotation costs more than the whole translation without one.
    reach = length / effect.extent
    mean = moments(effect.pressure, -reach * effect.x, reach * effect.y)[0]
    return 2.0 / (effect.extent * mean)


@compiled
def point(effect, i):
    """Place of a support point, in radii, and the friction that it can take."""
    x, y, share = _atom(effect.pressure, i)
    x, y = outward(effect, x, y)
    return effect.extent * x, effect.extent * y, effect.weight * share


@generic
def aligned(kinds: Any) -> Callable[..., Any]:
    """The effects in the frame of a rod in which the body frame's first axis is (x, y): effects, x, y."""
    if kinds[0] is Support:
        return _support_alone if len(kinds) == 1 else _support_and_mass
    return _mass_alone if kinds[0] is MassAt else _isotropic


@compiled
def _isotropic(effects, x, y):
    return effects


@compiled
def _support_alone(effects, x, y):
    weight, extent, pressure, _, _ = effects[0]
    return (Support(weight, extent, pressure, x, y),)


@compiled
def _mass_alone(effects, x, y):
    mass, gyration, own_x, own_y = effects[0]
    return (MassAt(mass, gyration, own_x * x - own_y * y, own_x * y + own_y * x),)


@compiled
def _support_and_mass(effects, x, y):
    return (*_support_alone(effects[:1], x, y), *_mass_alone(effects[1:], x, y))
