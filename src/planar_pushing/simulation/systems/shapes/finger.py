"""A finger: a disc that does not rotate, or a point, that touches a flat side of the slider.

The contact frame is fixed to the side and rotates with the slider. In this frame, the direction of body x
is constant. The contact, which is the finger's point nearest to the side, travels along the side. The
finger's center is one radius r below it. Let w be the velocity of the slider's contact point relative to
the finger. The contact, even if it sticks, travels along the side at ``-(w_x + r spin)``. With the
accelerations a of this point and a_F of the finger, ``dw/dt = a - a_F - 2 spin x w - spin x (r spin, 0)``.

In contact, the finger's center is on a line parallel to the side, so the disc meets other points of the
outline at fixed positions of the contact. Free of the side, its distance from the outline is followed.
"""

from __future__ import annotations

from math import cos, inf, nan, sin
from typing import NamedTuple

from planar_pushing.simulation.legacy.compiled import compiled
from planar_pushing.simulation.legacy.motion import contact_at
from planar_pushing.simulation.outlines import TOLERANCE, distance, free_part
from planar_pushing.simulation.systems.frame import pose_at

#: Distance, in tolerances of the outline, that a free finger may move in a step beyond that to the outline;
#: it is a thousandth of the outline's extent.
STRIDE = 1e-3 / TOLERANCE


class Finger(NamedTuple):
    """Length, angle and direction of the rod at time 0, ends of the side from the contact, and radius."""

    length: float
    angle: float
    x: float
    y: float
    start: float
    end: float
    radius: float


@compiled
def made(shape, length, angle, start, end, radius):
    return Finger(length, angle, cos(angle), sin(angle), start, end, radius)


@compiled
def frame_angle(shape, angle):
    return shape.angle


@compiled
def pose(shape, body, frame, along, gap):
    # The contact is at (-along, -gap) from the end of the rod.
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
def travel(shape, slip, spin):
    return slip + shape.radius * spin


@compiled
def relative(shape, spin, slip, rise, a_x, a_y):
    rolling = shape.radius * spin * spin
    return a_x + 2.0 * spin * rise, a_y - 2.0 * spin * slip - rolling


@compiled
def pinned(shape, spin, x, y):
    return x, y + shape.radius * spin * spin


@compiled
def center(shape, angle, now, along, gap, x, y):
    x_there, y_there = shown(shape, angle, now.x, now.y)
    turn = angle - shape.angle
    half = sin(turn / 2.0)
    # Seen from the finger's center, the contact rotates with the side.
    x, y = x - shape.radius * sin(turn), y - 2.0 * shape.radius * half * half
    return x + x_there, y + y_there


@compiled
def flown(shape, now, along, gap, x, y, way_x, way_y, turn):
    c, s = cos(turn), sin(turn)
    x, y = now.x + x - way_x, now.y + y - way_y
    along, across = c * x + s * y, c * y - s * x
    half = sin(turn / 2.0)
    # The side rotates about the finger's center, and the contact is again one radius above the center.
    along, across = along + shape.radius * s, across - 2.0 * shape.radius * half * half
    return along - shape.length * shape.x, across - shape.length * shape.y


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
def confine(shape, body, corners, along):
    body.low, body.high = -inf, inf
    if len(corners) == 0:
        return
    radius, length = body.fine * shape.radius, body.fine * shape.length
    place = -body.fine * along
    low, high = free_part(corners, -length, 0.0, shape.x, -shape.y, radius, 1.0, place)
    body.low, body.high = low / body.fine, high / body.fine


@compiled
def height(shape, body, corners, angle, along, gap, touching):
    if len(corners) == 0:
        return nan
    if touching:
        left = min(body.high + along, -along - body.low)
        return body.fine * left if left < inf else nan
    across = max(gap, 0.0) + shape.radius
    x = -shape.length - (along * shape.x + across * shape.y)
    y = along * shape.y - across * shape.x
    return distance(corners, body.fine * x, body.fine * y) - body.fine * shape.radius + 1.0


@compiled
def stride(shape, body, height, speed):
    return (height + STRIDE) / (body.fine * speed) if height == height and speed > 0.0 else inf


@compiled
def room(shape, along):
    left = min(shape.end + along, -along - shape.start)
    return left if left < inf else nan
