"""A finger: a point against a flat side of the slider.

Its frame is fixed to the side and turns with the slider. In it the slider's axis keeps its direction, and
the rod, here the line from the finger to the slider's centre, changes as the finger travels along the side.
"""

from __future__ import annotations

from math import atan2, cos, hypot, inf, nan, sin
from typing import NamedTuple

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.effects.any_support import aligned
from planar_pushing.mechanics.plane import Rod
from planar_pushing.simulation.systems.motion import mass_offset
from planar_pushing.simulation.systems.shapes.base import Pose


class Finger(NamedTuple):
    """The slider's own rod, as it is at time 0; ends of the side, from the contact at time 0 along it."""

    axis: Rod
    start: float
    end: float


@compiled
def made(shape, own, start, end):
    return Finger(own, start, end)


@compiled
def _line_to(x, y):
    length = hypot(x, y)
    if length == 0.0:
        return Rod(0.0, 0.0, 1.0, 0.0)
    return Rod(length, atan2(y, x), x / length, y / length)


@compiled
def pose(shape, effects, body, own, along, gap):
    axis, (m_x, m_y) = shape.axis, mass_offset(body, shape.axis)
    x, y = axis.length * axis.x + along, axis.length * axis.y + gap
    line = _line_to(x, y)
    c, s = line.x * axis.x + line.y * axis.y, line.x * axis.y - line.y * axis.x
    return Pose(aligned(effects, c, s), line, _line_to(x + m_x, y + m_y), m_x, m_y)


@compiled
def seen(shape, angle, x, y):
    c, s = cos(angle - shape.axis.angle), sin(angle - shape.axis.angle)
    return c * x + s * y, c * y - s * x


@compiled
def shown(shape, angle, x, y):
    c, s = cos(angle - shape.axis.angle), sin(angle - shape.axis.angle)
    return c * x - s * y, c * y + s * x


@compiled
def relative(shape, spin, slip, rise, a_x, a_y):
    return a_x + 2.0 * spin * rise, a_y - 2.0 * spin * slip


@compiled
def center(shape, own, angle, along, gap, x, y):
    way_x, way_y = shown(shape, angle, own.length * own.x, own.length * own.y)
    return x + way_x, y + way_y


@compiled
def flown(shape, own, along, gap, x, y, way_x, way_y, turn):
    axis, c, s = shape.axis, cos(turn), sin(turn)
    x, y = own.length * own.x + x - way_x, own.length * own.y + y - way_y
    return c * x + s * y - axis.length * axis.x, c * y - s * x - axis.length * axis.y


@compiled
def steady(shape, during):
    return False


@compiled
def clearance(shape, body, gap):
    return inf if body.parted else gap


@compiled
def upright(shape, body, angle, gap):
    return nan


@compiled
def room(shape, along):
    left = min(shape.end + along, -along - shape.start)
    return left if left < inf else nan
