"""Edges of the cones: motions under the forces on the edges of the friction cone (Secs. 3.1 and 4)."""

from __future__ import annotations

from typing import Any

import numpy as np

from planar_pushing.certified.doubled.angles import cosine_sine, off_direction, radians
from planar_pushing.certified.doubled.numbers import Doubled, Floats, choose
from planar_pushing.evidence.golden.residual.finding import DEGREE, EPSILON, Finding
from planar_pushing.evidence.golden.residual.motion import (
    Line,
    Slider,
    angle_error,
    contact_motion,
    edge,
)
from planar_pushing.evidence.golden.residual.spin import spin_ratio, steady

#: Roundings of an edge in radians.
EDGE = 16
#: Motions closer to the fence than this, in radians, are along it.
ALONG = 8 * EPSILON
SIDES = {"right": 1, "left": -1}


def spin_ratios(effects: str, slider: Slider, arm: Doubled) -> list[Doubled]:
    """Spin ratios under a moment arm, of each effect alone."""
    return [spin_ratio(steady(each, slider), slider, arm) for each in effects.split("+")]


def friction_edge(name: str, stored: Any, friction_coefficient: Any, side: int) -> Finding:
    """An edge of the friction cone, degrees."""
    error = np.abs(off_direction(radians(stored), *edge(friction_coefficient, side)).value())
    return Finding(name, error * DEGREE, EDGE * EPSILON * DEGREE)


def motion_edge(
    name: str,
    stored: Any,
    force_angle: Any,
    line: Line,
    length: Any,
    spins: list[Doubled],
    side: int,
) -> Finding:
    """An edge of the motion cone, degrees: the outermost motion under the effects.

    A rounding of the force angle turns the motion by up to twice the square of the rod's length.
    """
    k = _outermost(line, length, spins, side)
    error = angle_error(stored, force_angle, line, length, k)
    return Finding(name, error * DEGREE, EDGE * (1 + length**2) * EPSILON * DEGREE)


def _outermost(line: Line, length: Any, spins: list[Doubled], side: int) -> Doubled:
    found = spins[0]
    for other in spins[1:]:
        turns = [_turn(line, length, k) * side for k in (found, other)]
        found = choose(turns[0] >= turns[1], found, other)
    return found


def _turn(line: Line, length: Any, k: Doubled) -> Floats:
    """Angle from the contact's motion to the force, radians."""
    ahead, right = contact_motion(line, length, k)
    return np.asarray(np.arctan2(right.value(), ahead.value()))


def least_normal_motion(
    rod_angle: Any, force: tuple[Doubled, Doubled], length: Any, spins: list[Doubled]
) -> Floats:
    """Least sine of the contact's motion, from the fence, over the effects."""
    cosine, sine = cosine_sine(radians(rod_angle))
    found = []
    for k in spins:
        pull = k * length
        x, y = force[0] + pull * sine, force[1] - pull * cosine
        found.append((y / (x * x + y * y).sqrt()).value())
    return np.asarray(np.min(np.broadcast_arrays(*found), axis=0))
