"""A slider between two fingers, one of which is driven by force, that friction holds at rest.

Friction bears any wrench within the limit surface. Of the forces that the laws allow, those that need the
smallest share of friction are found; the share is convex.
"""

from __future__ import annotations

from math import fabs

from planar_pushing.core.contacts.force_sets import HeldLoad
from planar_pushing.core.contacts.gripped_frames import (
    Grip,
    add_gripped,
    balance_grip,
    can_slip,
    force_of_press,
    pull_of,
    unit_forces_of_grip,
    write_grip_force,
)
from planar_pushing.core.contacts.limit_line import (
    add_multiple,
    least_multiple,
    slope_at,
    surface_at,
)
from planar_pushing.core.contacts.several_frames import MOST_CONTACTS, as_vector, frame_of
from planar_pushing.core.contacts.twist_line import length_of_twist, scale_vector
from planar_pushing.core.contacts.unit_forces import MOST_UNITS, UNIT_FORCE, UnitForce
from planar_pushing.core.instant.solution import SEPARATE, SLIP_LEFT, SLIP_RIGHT, STICK
from planar_pushing.core.numbers import INFINITY, Numbers, zeros
from planar_pushing.core.supports.descent import (
    continue_descent,
    is_found,
    lowest_number,
    open_descent,
)
from planar_pushing.core.supports.roots import ITERATIONS
from planar_pushing.core.supports.rows import NO_POINT, Effects, Vector
from planar_pushing.core.supports.tolerances import BALANCED, COINCIDENT, SHARE


def add_grip_at_rest(grip: Grip, solutions: Numbers, count: int) -> int:
    """Add the slider at rest if friction can bear the forces, with those that need its smallest share.

    The finger that moves as given leaves, or slips or sticks at the slider.
    """
    several = grip.several
    held, press = frame_of(several, grip.held), frame_of(several, grip.pressed)
    if held.pusher_across > COINCIDENT or count < 0:
        return count
    modes = zeros(MOST_CONTACTS)
    for i in range(2):
        along = press.pusher_along if i == grip.pressed else held.pusher_along
        modes[i] = float(STICK)
        if fabs(along) > COINCIDENT:
            modes[i] = float(SLIP_LEFT if along > 0.0 else SLIP_RIGHT)
    slips: bool = int(modes[grip.held]) != STICK
    if held.pusher_across < -COINCIDENT or (slips and not can_slip(grip, grip.held)):
        modes[grip.held] = float(SEPARATE)
    mode = int(modes[grip.pressed])
    if mode != STICK and not can_slip(grip, grip.pressed):
        return count
    nothing = HeldLoad(0.0, 0.0, 0.0, limit=0.0, foot_x=0.0, foot_y=0.0, size=0.0)
    forces = zeros(8)
    held_alone: bool = balance_grip(grip, modes, nothing, BALANCED, forces)
    if not held_alone and not _write_least_forces(grip, modes, forces):
        return count
    return add_gripped(
        grip, modes, Vector(0.0, 0.0, 0.0), NO_POINT, forces, continuum=False, solutions=solutions,
        count=count,
    )  # fmt: skip


def _write_least_forces(grip: Grip, modes: Numbers, forces: Numbers) -> bool:
    """Write the forces that need the smallest share of friction; whether friction bears it.

    If all forces that the laws allow leave some wrench, that of the smallest share is on the boundary of
    theirs: two unit forces suffice, beside the largest or no friction of the finger that presses.
    """
    effects, mode = grip.several.effects, int(modes[grip.pressed])
    press = frame_of(grip.several, grip.pressed)
    units = zeros(MOST_UNITS * UNIT_FORCE)
    multiples, trial = zeros(2), zeros(2)
    number, given = unit_forces_of_grip(grip, modes, units), force_of_press(grip, mode)
    most = grip.force * pull_of(press, SLIP_LEFT)
    best, best_friction, first, second = INFINITY, 0.0, -1, -1
    for side in range(-1, 2 if mode == STICK and most < INFINITY else 0):
        # Without friction, and with the largest one to either side.
        friction = 0.0
        if side >= 0:
            friction = most if side == 1 else grip.force * pull_of(press, SLIP_RIGHT)
        own = add_multiple(given, friction, as_vector(press.along))
        start = add_multiple(own, 1.0, grip.load)
        share = surface_at(effects, start).share
        if share < best:
            best, best_friction, first = share, friction, -1
        for k in range(number):
            for m in range(k, number):
                one, other = UnitForce(units[UNIT_FORCE * k :]), UnitForce(units[UNIT_FORCE * m :])
                if side >= 0 and (one.contact == grip.pressed or other.contact == grip.pressed):
                    continue
                share = _least_of_units(grip, start, one, other, m > k, trial)
                if share < best:
                    best, best_friction, first, second = share, friction, k, m
                    multiples[0], multiples[1] = trial[0], trial[1]
    if best > 1.0 + SHARE:
        return False
    write_grip_force(
        add_multiple(given, best_friction, as_vector(press.along)), grip.pressed, forces
    )
    if first >= 0:
        one, other = UnitForce(units[UNIT_FORCE * first :]), UnitForce(units[UNIT_FORCE * second :])
        write_grip_force(scale_vector(_wrench_of_unit(one), multiples[0]), one.contact, forces)
        write_grip_force(scale_vector(_wrench_of_unit(other), multiples[1]), other.contact, forces)
    return True


def _wrench_of_unit(unit: UnitForce) -> Vector:
    """The wrench of a unit force."""
    return Vector(unit.x, unit.y, unit.torque)


def _most_of(grip: Grip, unit: UnitForce) -> float:
    """The largest multiple of a unit force: that of the finger that presses is bounded."""
    if unit.contact != grip.pressed:
        return INFINITY
    press = frame_of(grip.several, grip.pressed)
    ahead: bool = unit.x * press.along.x + unit.y * press.along.y > 0.0
    return grip.force * fabs(pull_of(press, SLIP_LEFT if ahead else SLIP_RIGHT))


def _least_of_units(
    grip: Grip, start: Vector, one: UnitForce, other: UnitForce, both: bool, multiples: Numbers
) -> float:
    """The smallest share with multiples of one unit force, or of two, which are written."""
    effects, first, second = grip.several.effects, _wrench_of_unit(one), _wrench_of_unit(other)
    most, more = _most_of(grip, one), 0.0
    if both:
        at_start = _slope_with(effects, start, first, most, second, 0.0)
        descent = open_descent(at_start, length_of_twist(start), _most_of(grip, other))
        for _ in range(ITERATIONS):
            if is_found(descent):
                break
            slope = _slope_with(effects, start, first, most, second, descent.trial)
            descent = continue_descent(descent, slope)
        more = lowest_number(descent)
    there = add_multiple(start, more, second)
    part = least_multiple(effects, there, first, most)
    multiples[0], multiples[1] = part, more
    return surface_at(effects, add_multiple(there, part, first)).share


def _slope_with(
    effects: Effects, start: Vector, first: Vector, most: float, second: Vector, more: float
) -> float:
    """Slope of the smallest share over multiples of a force, along another one."""
    there = add_multiple(start, more, second)
    part = least_multiple(effects, there, first, most)
    return slope_at(surface_at(effects, add_multiple(there, part, first)), second)
