"""Where a line of wrenches meets the limit surface of friction, on which those of all motions are.

The share of a wrench in the largest that friction bears along its ray is convex, so a line meets the
surface twice at most. The normal of the surface there is the direction of the motion.
"""

from __future__ import annotations

from math import fabs, sqrt
from typing import NamedTuple

from planar_pushing.core.contacts.twist_line import length_of_twist
from planar_pushing.core.instant.force import ContactMotion, motion_under_force
from planar_pushing.core.instant.kernels import FAR
from planar_pushing.core.numbers import INFINITY, Numbers
from planar_pushing.core.supports.contact import contact_at
from planar_pushing.core.supports.descent import (
    continue_descent,
    is_found,
    lowest_number,
    open_descent,
)
from planar_pushing.core.supports.roots import (
    ITERATIONS,
    best_number,
    is_narrow,
    narrow_bracket,
    next_number,
    open_bracket,
)
from planar_pushing.core.supports.rows import Effects, Vector
from planar_pushing.core.supports.tolerances import RESOLUTION, SHARE

#: Maximum number of times that a force is doubled in a search.
DOUBLINGS = 60


class Surface(NamedTuple):
    """A wrench relative to the limit surface: its share of the largest on its ray, and the motion there."""

    share: float
    motion: ContactMotion


def add_multiple(one: Vector, part: float, other: Vector) -> Vector:
    """A wrench and a multiple of another one."""
    return Vector(one.x + part * other.x, one.y + part * other.y, one.spin + part * other.spin)


def surface_at(effects: Effects, wrench: Vector) -> Surface:
    """A wrench that friction alone bears, as a force at the point of its line next to the origin."""
    x, y = wrench.x, wrench.y
    if fabs(x) + fabs(y) <= fabs(wrench.spin) / FAR:
        x, y = fabs(wrench.spin) / FAR, 0.0
    size = sqrt(x * x + y * y)
    if size == 0.0:
        none = motion_under_force(effects, contact_at(0.0, 0.0), e_x=1.0, e_y=0.0, along=1.0)
        return Surface(0.0, none)
    contact = contact_at(y * wrench.spin / (size * size), -x * wrench.spin / (size * size))
    motion = motion_under_force(effects, contact, e_x=x / size, e_y=y / size, along=1.0)
    force = sqrt(motion.f_x * motion.f_x + motion.f_y * motion.f_y)
    return Surface(size / force if force > 0.0 else INFINITY, motion)


def slope_at(surface: Surface, unit: Vector) -> float:
    """Sign of the change of the share along a unit wrench: its power in the motion."""
    motion = surface.motion
    power = unit.x * motion.v_x + unit.y * motion.v_y + unit.spin * motion.spin
    return power if surface.share > 0.0 else 1.0


def least_multiple(effects: Effects, start: Vector, unit: Vector, most: float) -> float:
    """The multiple of a unit wrench, up to a largest one, with the smallest share; the share is convex."""
    at_start = slope_at(surface_at(effects, start), unit)
    descent = open_descent(at_start, length_of_twist(start), most)
    for _ in range(ITERATIONS):
        if is_found(descent):
            break
        there = surface_at(effects, add_multiple(start, descent.trial, unit))
        descent = continue_descent(descent, slope_at(there, unit))
    return lowest_number(descent)


def _crossing_of(effects: Effects, start: Vector, unit: Vector, low: float, high: float) -> float:
    """The multiple of a unit wrench at which a line meets the limit surface, between two."""
    at_low = surface_at(effects, add_multiple(start, low, unit)).share - 1.0
    at_high = surface_at(effects, add_multiple(start, high, unit)).share - 1.0
    bracket = open_bracket(low, high, at_low, at_high, RESOLUTION)
    for _ in range(ITERATIONS):
        if is_narrow(bracket):
            break
        part = next_number(bracket)
        value = surface_at(effects, add_multiple(start, part, unit)).share - 1.0
        bracket = narrow_bracket(bracket, part, value)
    return best_number(bracket)


def write_crossings(effects: Effects, start: Vector, unit: Vector, parts: Numbers) -> int:
    """Write the multiples of a unit wrench at which a line meets the limit surface, and their number."""
    least = least_multiple(effects, start, unit, INFINITY)
    if surface_at(effects, add_multiple(start, least, unit)).share > 1.0 + SHARE:
        return 0
    count = 0
    if least > 0.0 and surface_at(effects, start).share >= 1.0:
        parts[count] = _crossing_of(effects, start, unit, 0.0, least)
        count += 1
    step = 1.0 + length_of_twist(start)
    high = least + step
    for _ in range(DOUBLINGS):
        if surface_at(effects, add_multiple(start, high, unit)).share >= 1.0:
            break
        step = 2.0 * step
        high = least + step
    parts[count] = _crossing_of(effects, start, unit, least, high)
    return count + 1
