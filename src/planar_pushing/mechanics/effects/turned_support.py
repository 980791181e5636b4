"""Friction of any support whose body frame is turned against the rod, and centres of mass in such a frame.

A finger travels along the side that it pushes, so the line from it to the slider's centre turns in the
slider.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

from planar_pushing.mechanics.compiled import compiled, generic
from planar_pushing.mechanics.effects import any_support
from planar_pushing.mechanics.effects.any_mass import MassAt
from planar_pushing.mechanics.effects.any_support import Support
from planar_pushing.mechanics.supports.moments import moments
from planar_pushing.mechanics.supports.pressure.record import Pressure


class TurnedSupport(NamedTuple):
    """A `Support`, and the body frame's first axis as it is seen from the rod."""

    weight: float
    extent: float
    pressure: Pressure
    x: float
    y: float


#: The kinds of friction that are not isotropic.
PRESSED = (Support, TurnedSupport)


@compiled
def _plain(effect):
    return Support(effect.weight, effect.extent, effect.pressure)


@compiled
def outward(effect, x, y):
    return effect.x * x - effect.y * y, effect.y * x + effect.x * y


@compiled
def gradient(effect, x, y, spin):
    c, s = effect.x, effect.y
    own = any_support.gradient(_plain(effect), c * x + s * y, c * y - s * x, spin)
    f_x, f_y, torque, xx, xy, yy, xs, ys, ss = own
    f_x, f_y = outward(effect, f_x, f_y)
    xs, ys = outward(effect, xs, ys)
    across = c * s * (xx - yy) + (c * c - s * s) * xy
    one = c * c * xx - 2.0 * c * s * xy + s * s * yy
    other = s * s * xx + 2.0 * c * s * xy + c * c * yy
    return f_x, f_y, torque, one, across, other, xs, ys, ss


@compiled
def wrench_about(effect, i, spin, c_x, c_y):
    f_x, f_y, torque = any_support.wrench_about(_plain(effect), i, spin, c_x, c_y)
    f_x, f_y = outward(effect, f_x, f_y)
    return f_x, f_y, torque


@compiled
def rough(effect):
    x, y, gyration = any_support.rough(_plain(effect))
    x, y = outward(effect, x, y)
    return x, y, gyration


@compiled
def fastest(effect, length):
    reach = length / effect.extent
    mean = moments(effect.pressure, -reach * effect.x, reach * effect.y)[0]
    return 2.0 / (effect.extent * mean)


@compiled
def count_points(effect):
    return any_support.count_points(_plain(effect))


@compiled
def point(effect, i):
    x, y, most = any_support.point(_plain(effect), i)
    x, y = outward(effect, x, y)
    return x, y, most


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
    weight, extent, pressure = effects[0]
    return (TurnedSupport(weight, extent, pressure, x, y),)


@compiled
def _mass_alone(effects, x, y):
    mass, gyration, own_x, own_y = effects[0]
    return (MassAt(mass, gyration, own_x * x - own_y * y, own_x * y + own_y * x),)


@compiled
def _support_and_mass(effects, x, y):
    return (*_support_alone(effects[:1], x, y), *_mass_alone(effects[1:], x, y))
