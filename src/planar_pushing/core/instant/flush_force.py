"""The force on a flat side that lies on the fence, and its share at both ends.

Any pressure between the ends is equivalent to forces at the ends, each within the friction cone. The total
force is then within the cone, and its line of action crosses the fence between the ends. In a translation
all points of the slider move alike, and the force has a closed form.
"""

from __future__ import annotations

from math import fabs, sqrt
from typing import NamedTuple

from planar_pushing.core.instant.cone import Law
from planar_pushing.core.instant.solution import (
    MOST_SOLUTIONS,
    SOLUTION,
    UNSOLVED,
    Push,
    Solution,
)
from planar_pushing.core.numbers import Numbers
from planar_pushing.core.supports.resistance import Mass, load_wrench, rough_mass
from planar_pushing.core.supports.rows import NO_POINT, Vector, scale_effects
from planar_pushing.core.supports.tolerances import SHARE

#: Maximum number of flush solutions: those that move, and one at rest in each mode.
MOST_FLUSH = MOST_SOLUTIONS + 3


class FlatSide(NamedTuple):
    """Ends of a side along the fence, measured from its origin, which is the contact of the push."""

    start: float
    end: float


class Translation(NamedTuple):
    """What resists a translation, with first moments about the origin of the side, in the fence frame.

    Attributes
    ----------
    weight, weight_x, weight_y : float
        Friction: its magnitude, and the magnitude times the coordinates of the center of pressure.
    mass, mass_x, mass_y : float
        The same of inertia or viscous friction.
    load : Vector
        Wrench of the loads.
    lever : float
        Length whose rounding error is that of the coordinates.
    """

    weight: float
    weight_x: float
    weight_y: float
    mass: float
    mass_x: float
    mass_y: float
    load: Vector
    lever: float


class SideForce(NamedTuple):
    """The force that sustains a motion, in the fence frame.

    Attributes
    ----------
    s : float
        Motion along the fence of the origin of the side.
    f_x, f_y, torque : float
        Force, and torque about the origin.
    size : float
        Magnitude of the terms of the force.
    """

    s: float
    f_x: float
    f_y: float
    torque: float
    size: float


class FlushPush(NamedTuple):
    """A push of a flat side.

    Attributes
    ----------
    push : Push
        Its contact is the origin of the side.
    side : FlatSide
    law : Law
    w_x, w_y : float
        Motion of the fence along itself, and motion of the origin across the fence.
    spin : float
        Rotation of the slider.
    translation : Translation
    """

    push: Push
    side: FlatSide
    law: Law
    w_x: float
    w_y: float
    spin: float
    translation: Translation


def resist_translation(push: Push) -> Translation:
    """What resists a translation of the slider of a push."""
    t_x, t_y, contact, effects = push.t_x, push.t_y, push.contact, push.effects
    one = rough_mass(scale_effects(effects, 1.0, 0.0), 1.0, contact.x, contact.y)
    two = rough_mass(scale_effects(effects, 0.0, 1.0), 1.0, contact.x, contact.y)
    load = load_wrench(effects)
    turn = load.spin - (contact.x * load.y - contact.y * load.x)
    wrench = Vector(t_x * load.x + t_y * load.y, t_x * load.y - t_y * load.x, turn)
    return Translation(
        weight=one.mass,
        weight_x=t_x * one.x + t_y * one.y,
        weight_y=t_x * one.y - t_y * one.x,
        mass=two.mass,
        mass_x=t_x * two.x + t_y * two.y,
        mass_y=t_x * two.y - t_y * two.x,
        load=wrench,
        lever=contact.reach + _arm_of(one) + _arm_of(two),
    )


def _arm_of(mass: Mass) -> float:
    """Distance of the center of a mass, or of a pressure, from the point to which its moments refer."""
    return (fabs(mass.x) + fabs(mass.y)) / mass.mass if mass.mass > 0.0 else 0.0


def translation_force(translation: Translation, x: float, y: float) -> SideForce:
    """The force that sustains a translation of the slider, which is not zero."""
    most, load = max(fabs(x), fabs(y)), translation.load
    e_x, e_y = x / most, y / most  # the squares of the slowest motions underflow
    length = sqrt(e_x * e_x + e_y * e_y)
    e_x, e_y = e_x / length, e_y / length
    f_x = translation.weight * e_x + translation.mass * x - load.x
    f_y = translation.weight * e_y + translation.mass * y - load.y
    torque = translation.weight_x * e_y - translation.weight_y * e_x - load.spin
    torque += translation.mass_x * y - translation.mass_y * x
    size = translation.weight + translation.mass * most * length + fabs(load.x) + fabs(load.y)
    return SideForce(x, f_x, f_y, torque, size)


def noise_at_ends(flush: FlushPush, force: SideForce) -> float:
    """Rounding error of the normal forces at the ends of the side."""
    a, b = flush.side.start, flush.side.end
    lever = max(b, -a) + flush.translation.lever
    return SHARE * (force.size * lever + fabs(force.torque)) / (b - a)


def force_at_start(side: FlatSide, force: SideForce) -> float:
    """Normal force at the start of a side."""
    return (side.end * force.f_y - force.torque) / (side.end - side.start)


def force_at_end(side: FlatSide, force: SideForce) -> float:
    """Normal force at the end of a side."""
    return (force.torque - side.start * force.f_y) / (side.end - side.start)


def is_between_ends(flush: FlushPush, force: SideForce) -> bool:
    """Whether both ends of the side push, to rounding: the force crosses the fence between them."""
    noise, side = noise_at_ends(flush, force), flush.side
    return force_at_start(side, force) >= -noise and force_at_end(side, force) >= -noise


def write_flush(
    flush: FlushPush, mode: int, force: SideForce, continuum: bool, solutions: Numbers, count: int
) -> int:
    """Write a solution, and return the number of solutions."""
    if count < 0 or count == MOST_FLUSH:
        return UNSOLVED
    push, spin, y = flush.push, flush.spin, flush.w_y
    solution = Solution(solutions[SOLUTION * count :])
    c_x = -(push.t_x * push.contact.x + push.t_y * push.contact.y)
    c_y = -(push.t_x * push.contact.y - push.t_y * push.contact.x)
    solution.mode, solution.pivot = mode, NO_POINT
    solution.continuum = continuum
    solution.twist.x = force.s - spin * c_y
    solution.twist.y, solution.twist.spin = y + spin * c_x, spin
    solution.motion.x, solution.motion.y = force.s, y
    solution.force.x, solution.force.y = force.f_x, force.f_y
    solution.force_end.x, solution.force_end.y = force.f_x, force.f_y
    noise = noise_at_ends(flush, force)
    at_start, at_end = force_at_start(flush.side, force), force_at_end(flush.side, force)
    solution.start_force = 0.0 if fabs(at_start) <= noise else at_start
    solution.end_force = 0.0 if fabs(at_end) <= noise else at_end
    return count + 1
