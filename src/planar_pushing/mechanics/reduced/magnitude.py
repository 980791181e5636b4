"""The motions under forces of one direction and any magnitude.

With effects of several degrees, the direction of a motion changes with its magnitude. The motions are
ordered by their component along the line of force: the force increases with it, because Psi is convex.
"""

from __future__ import annotations

from collections.abc import Callable
from math import atan2, exp, inf, sinh, sqrt
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.angles import RESOLUTION
from planar_pushing.mechanics.compiled import compiled, generic, generic_owning, owning
from planar_pushing.mechanics.effects.base import energy, is_steady, scaled
from planar_pushing.mechanics.effects.inertia import Mass
from planar_pushing.mechanics.effects.ring import RingSupport
from planar_pushing.mechanics.numerics.root import dip, increasing_root
from planar_pushing.mechanics.plane import contact_motion_angle, moment_arm
from planar_pushing.mechanics.reduced.psi import Contact
from planar_pushing.mechanics.reduced.under import not_found, pushed, pushed_ends
from planar_pushing.mechanics.supports.ring import ring_spin_ratio

#: Number of magnitudes at which the angle of the contact's motion is evaluated, on either side of the one
#: at which the effects have equal magnitudes. Their logarithms are hyperbolic sines of multiples of APART.
NODES, APART = 32, 0.11
#: Logarithm of a component along the line of force at which inertia is negligible relative to friction.
SLOWEST = -34.0
#: Number of steps between the two neighbors of a node with an extreme angle.
FINER = 16
#: Offset that makes angles from the force positive.
POSITIVE = 2.0


class Pull(NamedTuple):
    """A line of force at the contact, and the target value of a quantity."""

    effects: tuple[Any, ...]
    at: Contact
    e_x: float
    e_y: float
    goal: float


@compiled
def moved_by(of, z):
    """The motion with a component exp(z) along the line of force."""
    return pushed(of.effects, of.at, of.e_x, of.e_y, exp(z))


@compiled
def _speed(of, z):
    moved = moved_by(of, z)
    return sqrt(moved.v_x * moved.v_x + moved.v_y * moved.v_y) - of.goal


@compiled
def _force(of, z):
    moved = moved_by(of, z)
    return sqrt(moved.f_x * moved.f_x + moved.f_y * moved.f_y) - of.goal


@compiled
def _energy(of, z):
    moved = moved_by(of, z)
    return energy(of.effects, moved.v_x, moved.v_y, moved.spin) - of.goal


@generic
def at_speed(kinds: Any) -> Callable[..., Any]:
    """Motion under a line of force, with unit speed of the origin if the speed matters.

    Arguments: effects, contact, e_x, e_y.
    """
    return _any if is_steady(kinds) else _at_unit_speed


@compiled
def _any(effects, at, e_x, e_y):
    return pushed(effects, at, e_x, e_y, 1.0)


@compiled
def _at_unit_speed(effects, at, e_x, e_y):
    of = Pull(effects, at, e_x, e_y, 1.0)
    return moved_by(of, increasing_root(_speed, of, 0.0, 1.0))


@compiled
def at_force(effects, at, e_x, e_y, size):
    """The motion under a force of magnitude `size`; not found if friction holds the slider."""
    of = Pull(effects, at, e_x, e_y, size)
    if _force(of, SLOWEST) >= 0.0:
        return not_found(moved_by(of, SLOWEST))
    return moved_by(of, increasing_root(_force, of, 0.0, 1.0))


@compiled
def on_curve(effects, at, e_x, e_y):
    """The motion at a force on the limit curve; with inertia, it has the energy of a unit translation."""
    goal = energy(effects, 1.0, 0.0, 0.0)
    if goal == 0.0:
        return pushed(effects, at, e_x, e_y, 1.0)
    of = Pull(effects, at, e_x, e_y, goal)
    return moved_by(of, increasing_root(_energy, of, 0.0, 1.0))


class Turned(NamedTuple):
    """Direction of a motion: spin ratio, angle of the contact's motion, twist, and whether it was found."""

    ratio: float
    angle: float
    v_x: float
    v_y: float
    spin: float
    found: bool


@compiled
def aside_of(moved, e_x, e_y):
    """Angle from a line of force to the contact's motion, within 90 degrees."""
    return atan2(e_x * moved.u_y - e_y * moved.u_x, e_x * moved.u_x + e_y * moved.u_y)


@compiled
def turned(moved, force):
    """The direction of a motion under a force."""
    speed = sqrt(moved.v_x * moved.v_x + moved.v_y * moved.v_y)
    ratio = moved.spin / speed if speed > 0.0 else inf if moved.spin > 0.0 else -inf
    angle = force.angle + aside_of(moved, force.along, -force.aside)
    return Turned(ratio, angle, moved.v_x, moved.v_y, moved.spin, moved.found)


@generic
def direction_under(kinds: Any) -> Callable[..., Any]:
    """Direction of the motion under a force, origin at unit speed: effects, rod, contact, force."""
    return _under_on_ring if kinds == (RingSupport,) else _under


@compiled
def direction_at(effects, at, force, size):
    """Direction of the motion under a force of magnitude `size`."""
    return turned(at_force(effects, at, force.along, -force.aside, size), force)


@compiled
def _under(effects, own, at, force):
    return turned(at_speed(effects, at, force.along, -force.aside), force)


@compiled
def _under_on_ring(effects, own, at, force):
    """Direction from the closed inverse of Eq. (7): the force is along the center's motion."""
    ratio = ring_spin_ratio(moment_arm(own, force))
    angle = contact_motion_angle(own, force, ratio)
    if abs(ratio) < inf:
        return Turned(ratio, angle, force.along, -force.aside, ratio, True)
    return Turned(ratio, angle, 0.0, 0.0, 1.0 if ratio > 0.0 else -1.0, True)


class Angles(NamedTuple):
    """Minimum and maximum angle of the contact's motion; whether it pivots, is a continuum, was found."""

    least: float
    greatest: float
    pivots: bool
    continuum: bool
    found: bool


@generic_owning
def angles_under(kinds: Any) -> Callable[..., Any]:
    """`Angles` under a force in one direction, over all magnitudes: effects, rod, contact, force."""
    if kinds == (RingSupport,):
        return _one_angle
    return _steady_angles if is_steady(kinds) else _all_angles


@compiled
def _one_angle(effects, own, at, force):
    angle = _under_on_ring(effects, own, at, force).angle
    return Angles(angle, angle, False, False, True)


@compiled
def _steady_angles(effects, own, at, force):
    e_x, e_y = force.along, -force.aside
    first, last = pushed_ends(effects, at, e_x, e_y, 1.0)
    low, high = aside_of(first, e_x, e_y), aside_of(last, e_x, e_y)
    found = first.found and last.found
    return Angles(force.angle + low, force.angle + high, first.point >= 0, first.continuum, found)


@owning
def _all_angles(effects, own, at, force):
    slow = _steady_angles(scaled(effects, 1.0, 0.0), own, at, force)
    fast = _steady_angles(scaled(effects, 0.0, 1.0), own, at, force)
    # Of a continuum, the slow limit of the motions is the one nearest to the fast motions.
    near = min(max(slow.least, fast.least), slow.greatest)
    low, high = min(near, fast.least), max(near, fast.least)
    if not _turns_one_way(effects):
        right, left = _between(Pull(effects, at, force.along, -force.aside, 0.0))
        low, high = min(low, force.angle - right), max(high, force.angle + left)
    return Angles(low, high, slow.pivots, False, slow.found and fast.found)


@generic
def _turns_one_way(kinds: Any) -> Callable[..., Any]:
    """Whether the direction of the contact's motion is monotone from slow to fast."""
    return _is_isotropic if set(kinds) == {RingSupport, Mass} and len(kinds) == 2 else _unknown


@compiled
def _unknown(effects):
    return False


@compiled
def _is_isotropic(effects):
    return _is_centered(effects[0]) and _is_centered(effects[1])


@generic
def _is_centered(kind: Any) -> Callable[..., Any]:
    return _mass_is_centered if kind is Mass else _ring_is_centered


@compiled
def _mass_is_centered(effect):
    return effect.x == 0.0 and effect.y == 0.0


@compiled
def _ring_is_centered(effect):
    return True


@compiled
def _right(of, z):
    return POSITIVE + aside_of(moved_by(of, z), of.e_x, of.e_y)


@compiled
def _left(of, z):
    return POSITIVE - aside_of(moved_by(of, z), of.e_x, of.e_y)


@compiled
def _node(i):
    return sinh((i - NODES) * APART)


@owning
def _between(of):
    """Maximum angles of the contact's motion to the right and to the left of the force."""
    aside = np.empty(2 * NODES + 1)
    for i in range(len(aside)):
        aside[i] = _right(of, _node(i)) - POSITIVE
    return -_least(_right, of, aside), -_least(_left, of, -aside)


@compiled
def _least(function, of, asides):
    """The minimum angle over all magnitudes, searched in dips around nodes and at both ends."""
    found = min(asides[0], asides[-1])
    for i in range(1, len(asides) - 1):
        here, before, after = asides[i], asides[i - 1], asides[i + 1]
        level = max(before, after) - here <= RESOLUTION
        if here <= before + RESOLUTION and here <= after + RESOLUTION and not level:
            found = min(found, _deepest(function, of, _node(i - 1), _node(i + 1)) - POSITIVE)
    return found


@compiled
def _deepest(function, of, low, high):
    """The minimum value in a dip, which can be narrow next to a plateau."""
    step = (high - low) / FINER
    least, place = inf, low
    for i in range(1, FINER):
        value = function(of, low + i * step)
        if value < least:
            least, place = value, low + i * step
    return dip(function, of, place - step, place, place + step, least)[1]
