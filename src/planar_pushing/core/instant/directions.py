"""Directions at the contact: the rod, and unit vectors relative to it.

Angles are counterclockwise from the fence; the body frame's x axis is along the rod. A `Direction` with
components (along, across) is the vector (along, -across) in the body frame.
"""

from __future__ import annotations

from math import copysign, cos, fabs, floor, sin, sqrt
from typing import NamedTuple

from planar_pushing.core.numbers import INFINITY
from planar_pushing.core.supports.tolerances import RESOLVED, UNDERFLOW

QUARTER_TURN = 1.5707963267948966


class Rod(NamedTuple):
    """Length in radii, angle, and unit vector from the contact to the slider's center."""

    length: float
    angle: float
    x: float
    y: float


class Direction(NamedTuple):
    """An angle, and its unit vector in two frames: x and y; along the rod and its right-hand normal."""

    angle: float
    x: float
    y: float
    along: float
    across: float


def nearest_integer(x: float) -> float:
    """The nearest integer, with the sign of x."""
    return copysign(floor(fabs(x) + 0.5), x)


def is_quarter(angle: float) -> bool:
    """Whether an angle is the double nearest to a multiple of 90 degrees."""
    return nearest_integer(angle / QUARTER_TURN) * QUARTER_TURN == angle


def unit_x(angle: float) -> float:
    """Cosine of an angle, exact if the angle is the double nearest to a multiple of 90 degrees.

    A fence that moves along its own line then has exactly zero normal motion.
    """
    return nearest_integer(cos(angle)) if is_quarter(angle) else cos(angle)


def unit_y(angle: float) -> float:
    """Sine of an angle, exact in the same cases as `unit_x`."""
    return nearest_integer(sin(angle)) if is_quarter(angle) else sin(angle)


def rod_at(length: float, angle: float) -> Rod:
    """The rod of a slider."""
    return Rod(length, angle, unit_x(angle), unit_y(angle))


def direction_at(rod: Rod, angle: float) -> Direction:
    """The direction at an angle.

    If the direction or the rod is along an axis, the products of the components are exact. Elsewhere these
    products cancel, so the difference of the angles, corrected for the rounding error of the subtraction,
    is used instead, because a long rod multiplies an error by its length.
    """
    x, y = unit_x(angle), unit_y(angle)
    if is_quarter(angle) or rod.x == 0.0 or rod.y == 0.0:
        return Direction(angle, x, y, along=x * rod.x + y * rod.y, across=x * rod.y - y * rod.x)
    difference = rod.angle - angle
    back = difference - rod.angle
    rounding = (rod.angle - (difference - back)) - (angle + back)
    c, s = cos(difference), sin(difference)
    return Direction(angle, x, y, along=c - rounding * s, across=s + rounding * c)


def length_of(x: float, y: float) -> float:
    """The length of a vector, even if its square underflows."""
    square = x * x + y * y
    if square > UNDERFLOW:
        return sqrt(square)
    size = max(fabs(x), fabs(y))
    return size * sqrt((x / size) * (x / size) + (y / size) * (y / size)) if size > 0.0 else 0.0


class Center(NamedTuple):
    """A center of rotation."""

    x: float
    y: float


def motion_center(v_x: float, v_y: float, spin: float) -> Center:
    """Motion center of a twist, relative to the point whose velocity the twist contains.

    The center of a translation, exact or to rounding, is at infinity. In a translation along an axis the
    coordinate along that axis is zero.
    """
    if fabs(spin) > RESOLVED * length_of(v_x, v_y):
        return Center(-v_y / spin, v_x / spin)
    x, y = 0.0, 0.0
    if fabs(v_y) > RESOLVED * fabs(v_x):
        x = -copysign(INFINITY, v_y)
    if fabs(v_x) > RESOLVED * fabs(v_y) or x == 0.0:
        # Adding zero turns a negative zero into a positive one.
        y = copysign(INFINITY, v_x + 0.0)
    return Center(x, y)


def spin_ratio(v_x: float, v_y: float, spin: float) -> float:
    """R omega / v, 0 at rest."""
    if spin == 0.0:
        return 0.0
    speed = length_of(v_x, v_y)
    return spin / speed if speed > 0.0 else copysign(INFINITY, spin)
