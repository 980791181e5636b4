"""Supports on one line: one force then belongs to an interval of motions, a corner of the limit curve.

Every rotation about a place on the line beyond the support, and the translation across the line, has the
same friction: the weight, across the line and through the centre of pressure. Where that force passes
through the contact, it alone sustains all these motions.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

from planar_pushing.mechanics.compiled import compiled, generic
from planar_pushing.mechanics.effects.any_support import Support, outward
from planar_pushing.mechanics.reduced.pivots import DIRECTION
from planar_pushing.mechanics.reduced.rotation import Motion
from planar_pushing.mechanics.supports.pressure.record import ATOMS, EDGES, RINGS, SEGMENTS

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
    rows, first = pressure.rows, pressure.starts[SEGMENTS]
    if pressure.starts[RINGS] > first:
        return rows[first, 2], rows[first, 3]
    x, y, most = 0.0, 0.0, 0.0
    for i in range(pressure.starts[ATOMS], first):
        d_x, d_y = rows[i, 0] - pressure.center_x, rows[i, 1] - pressure.center_y
        away = (d_x * d_x + d_y * d_y) ** 0.5
        if away > most:
            x, y, most = d_x / away, d_y / away, away
    return x, y


@compiled
def _end(rows, i, sign):
    """An end of a segment, or a point."""
    away = sign * rows[i, 4]
    return rows[i, 0] + away * rows[i, 2], rows[i, 1] + away * rows[i, 3]


@compiled
def extent(pressure):
    """The line of a support."""
    nowhere = Extent(0.0, 0.0, 0.0, 0.0)
    starts = pressure.starts
    if starts[EDGES] > starts[RINGS]:
        return nowhere
    x, y = _tangent(pressure)
    low, high, line = 0.0, 0.0, starts[SEGMENTS]
    for i in range(starts[ATOMS], starts[RINGS]):
        for sign in (-1.0, 1.0):
            p_x, p_y = _end(pressure.rows, i, sign if i >= line else 0.0)
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
    x, y = outward(effect, x, y)
    p_x, p_y = outward(effect, effect.pressure.center_x, effect.pressure.center_y)
    r_x, r_y = effect.extent * p_x + line.length, effect.extent * p_y
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
