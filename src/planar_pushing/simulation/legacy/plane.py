"""Geometry of the plane: frame, signs and the kinematics of a pushed slider."""

from __future__ import annotations

from math import cos, inf, pi, sin
from typing import NamedTuple

import numpy as np

from planar_pushing.simulation.legacy.compiled import compiled

QUARTER_TURN = pi / 2


class Rod(NamedTuple):
    """Length in radii, angle, and unit vector from the contact to the slider's center."""

    length: float
    angle: float
    x: float
    y: float


class Seen(NamedTuple):
    """An angle and its unit vector along the rod and along the rod's right-hand normal."""

    angle: float
    along: float
    aside: float


class Direction(NamedTuple):
    """As `Seen`, and the unit vector along x and y."""

    angle: float
    x: float
    y: float
    along: float
    aside: float


@compiled
def is_quarter(angle):
    """Whether an angle is the double nearest to a multiple of 90 degrees."""
    return np.rint(angle / QUARTER_TURN) * QUARTER_TURN == angle


@compiled
def unit_vector(angle):
    """Unit vector at an angle, exact if the angle is the double nearest to a multiple of 90 degrees.

    A fence that moves along its own line then has exactly zero normal motion.
    """
    x, y = cos(angle), sin(angle)
    if is_quarter(angle):
        return np.rint(x), np.rint(y)
    return x, y


@compiled
def rod(length, angle):
    """The rod of a slider."""
    x, y = unit_vector(angle)
    return Rod(length, angle, x, y)


@compiled
def seen(own, angle):
    """The direction at an angle, relative to a rod.

    If the direction or the rod is along an axis, the products of the components are exact. Elsewhere these
    products cancel, so the difference of the angles, corrected for the rounding error of the subtraction,
    is used instead: a long rod multiplies an error by its length.
    """
    if is_quarter(angle) or own.x == 0.0 or own.y == 0.0:
        x, y = unit_vector(angle)
        return Seen(angle, x * own.x + y * own.y, x * own.y - y * own.x)
    lean = own.angle - angle
    back = lean - own.angle
    rounding = (own.angle - (lean - back)) - (angle + back)
    c, s = cos(lean), sin(lean)
    return Seen(angle, c - rounding * s, s + rounding * c)


@compiled
def toward(own, angle):
    """The direction at an angle, also along x and y; it costs twice the sines and cosines of `seen`."""
    x, y = unit_vector(angle)
    _, along, aside = seen(own, angle)
    return Direction(angle, x, y, along, aside)


@compiled
def spin_ratio(speed, spin):
    """R omega / v, 0 at rest."""
    if spin == 0.0:
        return 0.0
    return spin / speed if speed > 0.0 else inf if spin > 0.0 else -inf
