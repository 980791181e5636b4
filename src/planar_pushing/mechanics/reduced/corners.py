"""Supports on one line: one force then belongs to an interval of motions, a corner of the limit curve.

Every rotation about a place on the line beyond the support, and the translation across the line, has the
same friction: the weight, across the line and through the centre of pressure. Where that force passes
through the contact, it alone sustains all these motions.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

from planar_pushing.mechanics.compiled import compiled, generic
from planar_pushing.mechanics.effects.any_support import Support
from planar_pushing.mechanics.reduced.general import Motion
from planar_pushing.mechanics.reduced.pivots import DIRECTION

#: In the place of a support point's number: the motion is an end of an interval of motions.
CONTINUUM = -2


class Extent(NamedTuple):
    """A support on a line: unit tangent, 0 where it is on none; ends from the centre of pressure."""

    x: float
    y: float
    low: float
    high: float


class Corner(NamedTuple):
    """Whether a force belongs to an interval of motions, and the motions at its ends."""

    exists: bool
    first: Motion
    last: Motion


@compiled
def _tangent(pressure):
    """Direction of the line that a support of points and segments may be on."""
    if len(pressure.segments) > 0:
        return pressure.segments[0, 2], pressure.segments[0, 3]
    x, y, most = 0.0, 0.0, 0.0
    for a, b, _ in pressure.atoms:
        d_x, d_y = a - pressure.center_x, b - pressure.center_y
        away = (d_x * d_x + d_y * d_y) ** 0.5
        if away > most:
            x, y, most = d_x / away, d_y / away, away
    return x, y


@compiled
def extent(pressure):
    """The line of a support."""
    nowhere = Extent(0.0, 0.0, 0.0, 0.0)
    if len(pressure.rings) + len(pressure.discs) + len(pressure.plates) > 0:
        return nowhere
    x, y = _tangent(pressure)
    low, high, count = 0.0, 0.0, len(pressure.atoms)
    for i in range(count + 2 * len(pressure.segments)):
        if i < count:
            p_x, p_y = pressure.atoms[i, 0], pressure.atoms[i, 1]
        else:
            m_x, m_y, t_x, t_y, half, _ = pressure.segments[(i - count) // 2]
            sign = half if (i - count) % 2 else -half
            p_x, p_y = m_x + sign * t_x, m_y + sign * t_y
        p_x, p_y = p_x - pressure.center_x, p_y - pressure.center_y
        if abs(x * p_y - y * p_x) > DIRECTION * pressure.extent:
            return nowhere
        low, high = min(low, x * p_x + y * p_y), max(high, x * p_x + y * p_y)
    return Extent(x, y, low, high) if low < 0.0 < high else nowhere


@generic
def corner_under(kinds: Any) -> Callable[..., Any]:
    """The corner of a line of force, of motions with a given part along it: effects, line."""
    return _corner_under if len(kinds) == 1 and kinds[0] is Support else _no_corner


@compiled
def no_corner():
    """No corner."""
    rest = Motion(0.0, 0.0, 0.0)
    return Corner(False, rest, rest)


@compiled
def _no_corner(effects, line):
    return no_corner()


@compiled
def _corner_under(effects, line):
    effect = effects[0]
    x, y, low, high = extent(effect.pressure)
    r_x = effect.extent * effect.pressure.center_x + line.length
    r_y = effect.extent * effect.pressure.center_y
    if low == high or abs(line.x * x + line.y * y) > DIRECTION:
        return no_corner()
    if abs(r_x * x + r_y * y) > DIRECTION * (abs(r_x) + abs(r_y)):
        return no_corner()
    rate = (line.x * y - line.y * x) * line.along / effect.extent
    first, last = _turning(line, r_x, r_y, rate / low), _turning(line, r_x, r_y, rate / high)
    return Corner(True, first, last)


@compiled
def _turning(line, r_x, r_y, spin):
    """Motion of the contact that the centre of pressure leaves along the line of force."""
    return Motion(line.along * line.x + spin * r_y, line.along * line.y - spin * r_x, spin)
