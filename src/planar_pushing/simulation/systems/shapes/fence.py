"""A fence: a line that stays parallel to x, against the rod's free end. Its frame is the world's."""

from __future__ import annotations

from math import cos, nan, sin
from typing import NamedTuple

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.simulation.systems.motion import arm_of, mass_offset
from planar_pushing.simulation.systems.shapes.base import Pose


class Fence(NamedTuple):
    """A fence has no parameters."""


@compiled
def made(shape, own, start, end):
    return shape


@compiled
def pose(shape, effects, body, own, along, gap):
    x, y = mass_offset(body, own)
    return Pose(effects, own, arm_of(body, own), x, y)


@compiled
def seen(shape, angle, x, y):
    return x, y


shown = seen


@compiled
def relative(shape, spin, slip, rise, a_x, a_y):
    return a_x, a_y


@compiled
def center(shape, own, angle, along, gap, x, y):
    return x + along + own.length * own.x, y + gap + own.length * own.y


@compiled
def flown(shape, own, along, gap, x, y, way_x, way_y, turn):
    turned, length = own.angle + turn, own.length
    x, y = x - length * (cos(turned) - own.x), y - length * (sin(turned) - own.y)
    return along + (x - way_x), gap + (y - way_y)


@compiled
def steady(shape, during):
    return during.constant


@compiled
def clearance(shape, body, gap):
    return gap


@compiled
def upright(shape, body, angle, gap):
    return gap / body.length + sin(angle) if body.length > 0.0 else nan


@compiled
def room(shape, along):
    return nan
