"""A fence: a line that stays parallel to x and touches the rod's free end. Its frame is the world's."""

from __future__ import annotations

from math import cos, inf, nan, sin
from typing import NamedTuple

from planar_pushing.simulation.legacy.compiled import compiled
from planar_pushing.simulation.legacy.motion import contact_at
from planar_pushing.simulation.systems.frame import pose_at


class Fence(NamedTuple):
    """A fence has no parameters."""


@compiled
def made(shape, length, angle, start, end, radius):
    return shape


@compiled
def frame_angle(shape, angle):
    return angle


@compiled
def pose(shape, body, frame, along, gap):
    return pose_at(frame, contact_at(-body.length, 0.0), body.center)


@compiled
def seen(shape, angle, x, y):
    return x, y


shown = seen


@compiled
def travel(shape, slip, spin):
    return slip


@compiled
def relative(shape, spin, slip, rise, a_x, a_y):
    return a_x, a_y


@compiled
def pinned(shape, spin, x, y):
    return x, y


@compiled
def center(shape, angle, now, along, gap, x, y):
    return x + along + now.x, y + gap + now.y


@compiled
def flown(shape, now, along, gap, x, y, way_x, way_y, turn):
    c, s = cos(turn) - 1.0, sin(turn)
    x, y = x - (c * now.x - s * now.y), y - (s * now.x + c * now.y)
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
def confine(shape, body, corners, along):
    pass


@compiled
def height(shape, body, corners, angle, along, gap, touching):
    if len(corners) == 0:
        return nan
    c, s, least = cos(angle), sin(angle), inf
    for k in range(len(corners)):
        least = min(least, s * corners[k, 0] + c * corners[k, 1])
    return least + body.fine * (gap + body.length * s) + 1.0


@compiled
def stride(shape, body, height, speed):
    return inf


@compiled
def room(shape, along):
    return nan
