"""Rotations about a point of the support, whose own friction may then be any force up to its share.

One such motion belongs to an interval of forces. A point at r from the contact carries the force E that
leaves no torque about the contact; it is a pivot where E is within the point's share of the weight.
"""

from __future__ import annotations

from collections.abc import Callable
from math import inf, nan, sqrt
from typing import Any, NamedTuple

from planar_pushing.mechanics.compiled import compiled, generic
from planar_pushing.mechanics.effects.any_support import Support, count_points, point
from planar_pushing.mechanics.effects.base import wrench_about
from planar_pushing.mechanics.numerics.root import EPSILON
from planar_pushing.mechanics.reduced.rotation import Motion

#: Rounding of a direction, and of a force against the share of a point.
DIRECTION, SHARE = 16.0 * EPSILON, 1e-13
NOWHERE = -1


class Pivot(NamedTuple):
    """A motion about a support point with its force, body frame.

    Attributes
    ----------
    atom : int
        Number of the point, -1 where there is none.
    motion : Motion
    f_x, f_y : float
        Force at the contact; where it is not settled the middle of the interval.
    free_x, free_y : float
        Half of the interval: the force is known up to this, times -1 to 1.
    """

    atom: int
    motion: Motion
    f_x: float
    f_y: float
    free_x: float
    free_y: float


@compiled
def _about(effects, length, i, spin):
    """Motion of the contact about a point, and force and torque at the contact, the point's own apart."""
    x, y, _ = point(effects[0], i)
    f_x, f_y, torque = wrench_about(effects, i, spin, x, y)
    return Motion(spin * y, -spin * (x + length), spin), f_x, f_y, torque + length * f_y


@compiled
def none():
    """No pivot."""
    return Pivot(NOWHERE, Motion(0.0, 0.0, 0.0), 0.0, 0.0, 0.0, 0.0)


@generic
def pivot_under(kinds: Any) -> Callable[..., Any]:
    """The pivot under a line of force, of a motion with a given part along it: effects, line."""
    return _pivot_under if kinds[0] is Support else _no_pivot_under


@generic
def pivot_of(kinds: Any) -> Callable[..., Any]:
    """The pivot of a contact that moves by (x, y): effects, length, x, y."""
    return _pivot_of if kinds[0] is Support else _no_pivot_of


@compiled
def _no_pivot_under(effects, line):
    return none()


@compiled
def _no_pivot_of(effects, length, x, y):
    return none()


@compiled
def _pivot_under(effects, line):
    for i in range(count_points(effects[0])):
        excess, motion, f_x, f_y = held(effects, line, i)
        if excess <= SHARE:
            return Pivot(i, motion, f_x, f_y, 0.0, 0.0)
    return none()


@compiled
def held(effects, line, i):
    """Force that a point must exert under a line of force, over its share, less 1; motion, and force."""
    (x, y, most), t_x, t_y = point(effects[0], i), line.x, line.y
    r_x, r_y = x + line.length, y
    arm = t_x * r_y - t_y * r_x
    if most == 0.0 or abs(arm) <= DIRECTION * (abs(r_x) + abs(r_y)):
        return inf, Motion(0.0, 0.0, 0.0), 0.0, 0.0
    motion, f_x, f_y, torque = _about(effects, line.length, i, line.along / arm)
    across = t_x * f_y - t_y * f_x
    e_x, e_y = (torque * t_x - r_x * across) / arm, (torque * t_y - r_y * across) / arm
    return sqrt(e_x * e_x + e_y * e_y) / most - 1.0, motion, f_x + e_x, f_y + e_y


@compiled
def kink_under(effects, line):
    """Positive while a motion under a line of force is a pivot, zero where one starts or ends."""
    least = inf
    for i in range(count_points(effects[0])):
        least = min(least, held(effects, line, i)[0])
    return -least / (2.0 + least) if least < inf else nan


@compiled
def _pivot_of(effects, length, x, y):
    speed = sqrt(x * x + y * y)
    for i in range(count_points(effects[0])):
        p_x, p_y, most = point(effects[0], i)
        r_x, r_y = p_x + length, p_y
        reach = sqrt(r_x * r_x + r_y * r_y)
        if reach == 0.0 or abs(x * r_x + y * r_y) > DIRECTION * speed * reach:
            continue
        motion, f_x, f_y, torque = _about(effects, length, i, (x * r_y - y * r_x) / (reach * reach))
        part = -torque / reach
        if abs(part) <= most * (1.0 + SHARE):
            free = sqrt(max(most * most - part * part, 0.0)) / reach
            f_x, f_y = f_x - part * r_y / reach, f_y + part * r_x / reach
            return Pivot(i, motion, f_x, f_y, free * r_x, free * r_y)
    return none()
