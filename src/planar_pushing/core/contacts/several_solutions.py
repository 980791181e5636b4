"""The solutions of several contacts: forces that balance the load of a twist, and the list of solutions.

Solutions with one twist count once. Of them a contact is closed rather than open, even without a force, and
sticks rather than slips: the range of its forces contains the others.
"""

from __future__ import annotations

from math import fabs, sqrt
from typing import NamedTuple

from planar_pushing.core._record import (
    Record,
    size_of,
)
from planar_pushing.core.contacts.force_sets import (
    HeldLoad,
    balance_load,
)
from planar_pushing.core.contacts.several_frames import (
    MOST_OF_SEVERAL,
    Several,
    as_vector,
    frame_of,
)
from planar_pushing.core.contacts.twist_line import (
    length_of_twist,
)
from planar_pushing.core.contacts.unit_forces import (
    FORCE_END,
    FORCES_INSIDE,
    MOST_UNITS,
    UNIT_FORCE,
    ForceEnd,
    UnitForce,
)
from planar_pushing.core.instant.solution import (
    SEPARATE,
    SLIP_LEFT,
    SLIP_RIGHT,
    STICK,
    UNSOLVED,
    Pair,
    Twist,
)
from planar_pushing.core.numbers import (
    INFINITY,
    Numbers,
    zeros,
)
from planar_pushing.core.supports.resistance import (
    resistance,
)
from planar_pushing.core.supports.rows import (
    NO_POINT,
    Vector,
    foot_position,
)
from planar_pushing.core.supports.tolerances import (
    COINCIDENT,
    SHARE,
    SLOW,
)

#: Solutions whose twists differ by less are the same, relative to the larger of the twist and the pushers.
SAME_TWIST = 1e-9
#: Angle between the edges of a cone, in radians, beyond which its normal is one of its unit forces.
WIDE_CONE = 3.0


class FourModes(Record):
    """A contact mode for each contact."""

    first: int
    second: int
    third: int
    fourth: int


class FourForces(Record):
    """A force on the slider for each contact."""

    first: Pair
    second: Pair
    third: Pair
    fourth: Pair


class SeveralSolution(Record):
    """A solution with several contacts.

    Attributes
    ----------
    modes : FourModes
    twist : Twist
        Of the origin.
    pivot, continuum : int, bool
        As in `Solution`.
    low_inner, high_inner : float
        Range of the inner force.
    low_infinite, high_infinite : bool
        Whether it has no bound. The forces of that end are then a direction, of a unit inner force.
    low_forces, high_forces : FourForces
        The forces at both ends of the range.
    """

    modes: FourModes
    twist: Twist
    pivot: int
    continuum: bool
    low_inner: float
    high_inner: float
    low_infinite: bool
    high_infinite: bool
    low_forces: FourForces
    high_forces: FourForces


class SeveralResults(Record):
    """Head of a row of results: how many solutions follow it, their status, and why there are none."""

    count: int
    status: int
    reason: int


SEVERAL_SOLUTION, HEAD_OF_SEVERAL = size_of(SeveralSolution), size_of(SeveralResults)


class Sharing(NamedTuple):
    """The modes of contacts, their unit forces, and room for both ends of the range of the inner force."""

    modes: Numbers
    units: Numbers
    number: int
    low: Numbers
    high: Numbers


def sharing_of(
    several: Several, modes: Numbers, units: Numbers, low: Numbers, high: Numbers
) -> Sharing:
    """How contacts in given modes share a load."""
    return Sharing(modes, units, number=unit_forces(several, modes, units), low=low, high=high)


def unit_forces(several: Several, modes: Numbers, units: Numbers) -> int:
    """Write the unit forces of the closed contacts, and return their number."""
    first, last, count = -1, -1, 0
    for i in range(several.number):
        if int(modes[i]) != SEPARATE:
            first, last = i if first < 0 else first, i
    r_x, r_y = 0.0, 0.0
    if first >= 0:
        one, other = frame_of(several, first), frame_of(several, last)
        r_x = other.inputs.point.x - one.inputs.point.x
        r_y = other.inputs.point.y - one.inputs.point.y
        length = sqrt(r_x * r_x + r_y * r_y)
        if length <= COINCIDENT:
            r_x, r_y = one.along.x, one.along.y
        else:
            r_x, r_y = r_x / length, r_y / length
    for i in range(several.number):
        frame, mode = frame_of(several, i), int(modes[i])
        inner = 0.0
        if first != last:
            inner = 0.5 if i == first else -0.5 if i == last else 0.0
        x, y = inner * r_x, inner * r_y
        if mode == STICK and frame.inputs.rough:
            count = write_unit_force(units, count, i, 1.0, frame.along, x, y)
            count = write_unit_force(units, count, i, -1.0, frame.along, x, y)
            count = write_unit_force(units, count, i, 1.0, frame.across, x, y)
            count = write_unit_force(units, count, i, -1.0, frame.across, x, y)
        elif mode == STICK:
            single: bool = frame.inputs.left == frame.inputs.right
            count = write_unit_force(units, count, i, 1.0, frame.right, x, y)
            if not single:
                count = write_unit_force(units, count, i, 1.0, frame.left, x, y)
            if frame.inputs.left - frame.inputs.right > WIDE_CONE:
                count = write_unit_force(units, count, i, 1.0, frame.across, x, y)
        elif mode == SLIP_RIGHT:
            count = write_unit_force(units, count, i, 1.0, frame.left, x, y)
        elif mode == SLIP_LEFT:
            count = write_unit_force(units, count, i, 1.0, frame.right, x, y)
    return count


def write_unit_force(
    units: Numbers, count: int, i: int, sign: float, wrench: Twist, x: float, y: float
) -> int:
    """Write a unit force of a contact, with its part of the inner force along (x, y)."""
    force = UnitForce(units[UNIT_FORCE * count :])
    force.x, force.y, force.torque = sign * wrench.x, sign * wrench.y, sign * wrench.spin
    force.inner, force.contact = x * force.x + y * force.y, i
    return count + 1


def load_of(several: Several, twist: Vector) -> HeldLoad:
    """The wrench that sustains a twist, and the foot that rests at its center of rotation."""
    effects, size = several.effects, length_of_twist(twist)
    total = resistance(effects, x=twist.x, y=twist.y, spin=twist.spin, blur=SLOW * size)
    limit, x, y = 0.0, 0.0, 0.0
    if total.point >= 0 and fabs(twist.spin) > SLOW * size:
        foot = foot_position(effects, total.point)
        limit, x, y = total.limit, foot.x, foot.y
    magnitude = fabs(total.f_x) + fabs(total.f_y) + fabs(total.torque) + limit
    return HeldLoad(
        x=total.f_x, y=total.f_y, torque=total.torque, limit=limit, foot_x=x, foot_y=y,
        size=max(magnitude, total.terms),
    )  # fmt: skip


def balances(several: Several, sharing: Sharing, twist: Vector, slack: float) -> bool:
    """Whether the contacts can balance the load of a twist; both ends of their forces are written."""
    load = load_of(several, twist)
    return balance_load(sharing.units, sharing.number, load, slack, sharing.low, sharing.high)


def add_balanced(
    several: Several, sharing: Sharing, twist: Vector, slack: float,
    continuum: bool, solutions: Numbers, count: int,
) -> int:  # fmt: skip
    """Add a solution if the contacts can balance the load of its twist; return the number of solutions."""
    if count < 0 or not balances(several, sharing, twist, slack):
        return count
    idle = _contact_on_edge(several, sharing)
    if idle >= 0:
        units = zeros(MOST_UNITS * UNIT_FORCE)
        others = _without_contact(sharing, idle, units)
        return add_balanced(
            several, others, twist, slack, continuum=continuum, solutions=solutions, count=count
        )
    size = SLOW * length_of_twist(twist)
    pivot = NO_POINT
    if fabs(twist.spin) > size:
        pivot = resistance(several.effects, twist.x, twist.y, twist.spin, size).point
    return add_solution(
        several, sharing, twist, pivot, continuum=continuum, solutions=solutions, count=count
    )


def _contact_on_edge(several: Several, sharing: Sharing) -> int:
    """Number of a contact with all its forces on edges that its cone lacks, -1 without one.

    Such a contact is closed without a force.
    """
    force = zeros(2)
    for i in range(several.number):
        frame = frame_of(several, i)
        if int(sharing.modes[i]) != STICK or frame.inputs.closed or frame.inputs.rough:
            continue
        pushes = False
        for k in range(sharing.number):
            pushes = pushes or UnitForce(sharing.units[UNIT_FORCE * k :]).contact == i
        if not pushes:
            continue
        _write_force_of(sharing, i, sharing.low[FORCES_INSIDE:], force)
        x, y = force[0], force[1]
        slack = SHARE * (fabs(x) + fabs(y))
        right, left = frame.right, frame.left
        if right.x * y - right.y * x <= slack or x * left.y - y * left.x <= slack:
            return i
    return -1


def _without_contact(sharing: Sharing, idle: int, units: Numbers) -> Sharing:
    """How all contacts but one share a load; their unit forces are copied."""
    number = 0
    for k in range(sharing.number):
        if UnitForce(sharing.units[UNIT_FORCE * k :]).contact != idle:
            for m in range(UNIT_FORCE):
                units[UNIT_FORCE * number + m] = sharing.units[UNIT_FORCE * k + m]
            number += 1
    return Sharing(sharing.modes, units, number, sharing.low, sharing.high)


def _write_force_of(sharing: Sharing, i: int, coefficients: Numbers, force: Numbers) -> None:
    """Write the force of a contact with given coefficients of the unit forces."""
    force[0], force[1] = 0.0, 0.0
    for k in range(sharing.number):
        unit = UnitForce(sharing.units[UNIT_FORCE * k :])
        if unit.contact == i:
            force[0] += coefficients[k] * unit.x
            force[1] += coefficients[k] * unit.y


def add_solution(
    several: Several, sharing: Sharing, twist: Vector, pivot: int,
    continuum: bool, solutions: Numbers, count: int,
) -> int:  # fmt: skip
    """Add a solution, and return the number of solutions."""
    if count < 0 or count == MOST_OF_SEVERAL:
        return UNSOLVED
    solution = SeveralSolution(solutions[SEVERAL_SOLUTION * count :])
    for m in range(SEVERAL_SOLUTION):
        solution[m] = 0.0
    for i in range(several.number):
        solution.modes[i] = sharing.modes[i]
        _write_force_of(sharing, i, sharing.low[FORCE_END:], solution.low_forces[2 * i :])
        _write_force_of(sharing, i, sharing.high[FORCE_END:], solution.high_forces[2 * i :])
    solution.twist.x, solution.twist.y, solution.twist.spin = twist.x, twist.y, twist.spin
    solution.pivot, solution.continuum = pivot, continuum
    low, high = ForceEnd(sharing.low), ForceEnd(sharing.high)
    solution.low_infinite, solution.high_infinite = low.is_infinite, high.is_infinite
    solution.low_inner = -INFINITY if low.is_infinite else low.inner
    solution.high_inner = INFINITY if high.is_infinite else high.inner
    return settle_solution(several, solutions, count)


def settle_solution(several: Several, solutions: Numbers, count: int) -> int:
    """Drop the last solution or an earlier one if both have one twist; return the number of solutions."""
    last = SeveralSolution(solutions[SEVERAL_SOLUTION * count :])
    twist = as_vector(last.twist)
    for k in range(count):
        other = SeveralSolution(solutions[SEVERAL_SOLUTION * k :])
        apart = fabs(other.twist.x - twist.x) + fabs(other.twist.y - twist.y)
        apart += fabs(other.twist.spin - twist.spin)
        if apart > SAME_TWIST * (1.0 + length_of_twist(twist)):
            continue
        continuum: bool = last.continuum or other.continuum
        if _looseness(several, last) < _looseness(several, other):
            for m in range(SEVERAL_SOLUTION):
                other[m] = last[m]
        other.continuum = continuum
        return count
    return count + 1


def _looseness(several: Several, solution: SeveralSolution) -> int:
    """Number of open contacts, and of slips: of solutions with one twist the smallest counts."""
    total = 0
    for i in range(several.number):
        mode = int(solution.modes[i])
        total += 10 if mode == SEPARATE else 0 if mode == STICK else 1
    return total


def sort_solutions(several: Several, solutions: Numbers, count: int) -> int:
    """Sort the solutions by the modes of the contacts, and return their number."""
    copy = zeros(SEVERAL_SOLUTION)
    for k in range(1, count):
        index = k
        while index > 0 and _code(several, solutions, index) < _code(several, solutions, index - 1):
            one = solutions[SEVERAL_SOLUTION * index :]
            other = solutions[SEVERAL_SOLUTION * (index - 1) :]
            for m in range(SEVERAL_SOLUTION):
                copy[m] = one[m]
                one[m], other[m] = other[m], copy[m]
            index -= 1
    return count


def _code(several: Several, solutions: Numbers, k: int) -> int:
    """The modes of a solution as one number, whose first digit is the first contact."""
    code = 0
    for i in range(several.number):
        code = 4 * code + int(solutions[SEVERAL_SOLUTION * k + i])
    return code
