"""A finger: a point against a flat side of the slider.

Its frame is fixed to the side and turns with the slider. In it body x keeps its direction, and the contact,
which is the finger, travels along the side.
"""

from __future__ import annotations

from math import cos, inf, nan, sin
from typing import NamedTuple

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.reduced.psi import contact_at
from planar_pushing.simulation.systems.frame import pose_at


class Finger(NamedTuple):
    """Length, angle and direction of the rod at time 0; ends of the side, from the contact at time 0."""

    length: float
    angle: float
    x: float
    y: float
    start: float
    end: float


@compiled
def made(shape, length, angle, start, end):
    return Finger(length, angle, cos(angle), sin(angle), start, end)


@compiled
def frame_angle(shape, angle):
    return shape.angle


@compiled
def pose(shape, body, frame, along, gap):
    # The finger is at (-along, -gap) from the end of the rod.
    x = -shape.length - (along * shape.x + gap * shape.y)
    return pose_at(frame, contact_at(x, along * shape.y - gap * shape.x), body.center)


@compiled
def seen(shape, angle, x, y):
    c, s = cos(angle - shape.angle), sin(angle - shape.angle)
    return c * x + s * y, c * y - s * x


@compiled
def shown(shape, angle, x, y):
    c, s = cos(angle - shape.angle), sin(angle - shape.angle)
    return c * x - s * y, c * y + s * x


@compiled
def relative(shape, spin, slip, rise, a_x, a_y):
    return a_x + 2.0 * spin * rise, a_y - 2.0 * spin * slip


@compiled
def center(shape, angle, now, along, gap, x, y):
    x_there, y_there = shown(shape, angle, now.x, now.y)
    return x + x_there, y + y_there


@compiled
def flown(shape, now, along, gap, x, y, way_x, way_y, turn):
    c, s = cos(turn), sin(turn)
    x, y = now.x + x - way_x, now.y + y - way_y
    return c * x + s * y - shape.length * shape.x, c * y - s * x - shape.length * shape.y


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
def height(shape, body, corners, angle, gap):
    return nan


@compiled
def room(shape, along):
    left = min(shape.end + along, -along - shape.start)
    return left if left < inf else nan
