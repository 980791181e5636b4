"""Motions of any support and any centre of mass, sticking or under a line of force, with their forces."""

from __future__ import annotations

from math import exp, hypot
from typing import Any, NamedTuple

from planar_pushing.mechanics.angles import RESOLUTION
from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.plane import Direction, Rod
from planar_pushing.mechanics.reduced.corners import CONTINUUM, corner_under
from planar_pushing.mechanics.reduced.line_of_force import (
    Line,
    force_of,
    motion_under,
    rough_motion,
)
from planar_pushing.mechanics.reduced.pivots import NOWHERE, pivot_of, pivot_under
from planar_pushing.mechanics.reduced.rotation import SETTLED, Motion, rough_spin, turned
from planar_pushing.mechanics.reduced.sticking import Sustained

#: Range of the logarithm of a motion's part along its line of force, in units in which friction and inertia
#: are of one size.
RANGE = 32.0


class Amount(NamedTuple):
    """Of the motions under a line of force, over the logarithm of their part along it."""

    effects: tuple[Any, ...]
    own: Rod
    edge: Direction


@compiled
def sustained(own, motion, f_x, f_y, free_x, free_y, index):
    """A motion with its force, from the body frame."""
    v_y = motion.y + own.length * motion.spin
    return Sustained(
        motion.x * own.x - v_y * own.y, motion.x * own.y + v_y * own.x, motion.spin,
        f_x * own.x - f_y * own.y, f_x * own.y + f_y * own.x, f_x, -f_y, 1.0,
        free_x, -free_y, index,
    )  # fmt: skip


@compiled
def write(moved, scale, force, found):
    """Write down a motion times a scale, its force times another."""
    found[0], found[1], found[2] = scale * moved.v_x, scale * moved.v_y, scale * moved.spin
    found[3], found[4] = force * moved.f_x, force * moved.f_y
    found[5], found[6], found[7] = found[3], found[4], float(moved.pivot)


@compiled
def stick(effects, own, towards):
    """As `base.stick`."""
    x, y, length = towards.along, -towards.aside, own.length
    pivot = pivot_of(effects, length, x, y)
    if pivot.atom != NOWHERE:
        _, motion, f_x, f_y, free_x, free_y = pivot
        return sustained(own, motion, f_x, f_y, free_x, free_y, pivot.atom)
    guess = rough_spin(effects, length, x, y)
    spin, now = turned(effects, length, x, y, guess, SETTLED)
    return sustained(own, Motion(x, y, spin), now.f_x, now.f_y, 0.0, 0.0, NOWHERE)


@compiled
def line_of(effects, own, edge, along):
    """The line of a force, of motions with a given part along it."""
    return Line(effects, own.length, edge.along, -edge.aside, along)


@compiled
def pushed(effects, own, edge, along):
    """The motion under a line of force that has a given part along it; of a corner the translation."""
    line = line_of(effects, own, edge, along)
    if corner_under(effects, line).exists:
        motion = Motion(along * line.x, along * line.y, 0.0)
        return of_line(own, line, motion, force_of(line, motion))
    pivot = pivot_under(effects, line)
    if pivot.atom != NOWHERE:
        return sustained(own, pivot.motion, pivot.f_x, pivot.f_y, 0.0, 0.0, pivot.atom)
    motion, force = motion_under(line, rough_motion(line))
    return of_line(own, line, motion, force)


@compiled
def of_line(own, line, motion, force):
    """A motion with its force, which is along a line and of this size."""
    return sustained(own, motion, force * line.x, force * line.y, 0.0, 0.0, NOWHERE)


@compiled
def at_end(own, motion, f_x, f_y):
    """A motion at an end of those that one force sustains."""
    return sustained(own, motion, f_x, f_y, 0.0, 0.0, CONTINUUM)


@compiled
def contact_of(own, moved):
    """Motion of the contact along the fence and normal to it."""
    lever = own.length * moved.spin
    return moved.v_x + lever * own.y, moved.v_y - lever * own.x


@compiled
def rise_of(own, moved):
    """Normal motion of the contact, zero where nothing but rounding is left of it."""
    normal, lever = contact_of(own, moved)[1], abs(own.length * moved.spin)
    noise = RESOLUTION * (hypot(moved.v_x, moved.v_y) + lever)
    return normal if abs(normal) > noise else 0.0


@compiled
def held_on_edge(effects, own, edge, moved):
    """As `base.held_on_edge`."""
    x, y = contact_of(own, moved)
    return pushed(effects, own, edge, x * edge.x + y * edge.y)


@compiled
def motion_of(amount, z):
    """The motion whose part along the line of force has a logarithm."""
    return pushed(amount.effects, amount.own, amount.edge, exp(z))
