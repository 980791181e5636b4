"""A slider between two fingers on one line, one of which is driven by force, and its solutions."""

from __future__ import annotations

from math import cos, fabs, sin, sqrt
from typing import NamedTuple

from planar_pushing.core._record import Record, size_of
from planar_pushing.core.contacts.force_sets import HeldLoad, balance_load
from planar_pushing.core.contacts.limit_line import add_multiple
from planar_pushing.core.contacts.several_frames import (
    MOST_CONTACTS,
    MOST_OF_SEVERAL,
    ContactFrame,
    Several,
    as_vector,
    frame_of,
    several_at,
)
from planar_pushing.core.contacts.several_solutions import (
    SEVERAL_SOLUTION,
    SeveralSolution,
    settle_solution,
    unit_forces,
    write_unit_force,
)
from planar_pushing.core.contacts.twist_line import length_of_twist, scale_vector
from planar_pushing.core.contacts.unit_forces import (
    END_OF_FORCES,
    FORCE_END,
    MOST_UNITS,
    UNIT_FORCE,
    ForceEnd,
    UnitForce,
)
from planar_pushing.core.instant.solution import SEPARATE, SLIP_LEFT, SLIP_RIGHT, STICK, UNSOLVED
from planar_pushing.core.numbers import INFINITY, Numbers, zeros
from planar_pushing.core.supports.rows import Effects, Vector
from planar_pushing.core.supports.tolerances import BALANCED

#: An edge of a cone closer than this to the tangent, in radians, belongs to infinite friction.
ROUGH_EDGE = 1e-12


class GripRow(Record):
    """What precedes the contacts in a row of inputs.

    Attributes
    ----------
    pressed : int
        Number of the finger that is driven by force, 0 or 1.
    force : float
        Its normal force.
    load_x, load_y, load_torque : float
        Wrench of all loads about the origin.
    """

    pressed: int
    force: float
    load_x: float
    load_y: float
    load_torque: float


GRIP_ROW = size_of(GripRow)


class Grip(NamedTuple):
    """A slider between two fingers.

    Attributes
    ----------
    several : Several
    held, pressed : int
        Numbers of the finger that moves as given, and of the one that is driven by force.
    force : float
        Normal force of the latter.
    load : Vector
        Wrench of all loads.
    """

    several: Several
    held: int
    pressed: int
    force: float
    load: Vector


def grip_at(frames: Numbers, effects: Effects, row: GripRow) -> Grip:
    """The slider of a row; compiled code puts no row of zeros into a tuple."""
    several = several_at(effects, 2, frames)
    pressed = row.pressed
    load = Vector(row.load_x, row.load_y, row.load_torque)
    return Grip(several, 1 - pressed, pressed, row.force, load)


def pull_of(frame: ContactFrame, mode: int) -> float:
    """Tangential force of a slip for each unit of normal force; infinite with infinite friction."""
    angle = frame.inputs.left if mode == SLIP_RIGHT else frame.inputs.right
    if fabs(sin(angle)) < ROUGH_EDGE or frame.inputs.rough:
        return -INFINITY if mode == SLIP_RIGHT else INFINITY
    return cos(angle) / sin(angle)


def force_of_press(grip: Grip, mode: int) -> Vector:
    """Wrench of the finger that is driven by force in a mode; without the friction of a stick."""
    frame = frame_of(grip.several, grip.pressed)
    press = scale_vector(as_vector(frame.across), grip.force)
    if mode == STICK:
        return press
    return add_multiple(press, grip.force * pull_of(frame, mode), as_vector(frame.along))


def can_slip(grip: Grip, i: int) -> bool:
    """Whether a finger can slip; one that presses needs a bounded friction."""
    frame = frame_of(grip.several, i)
    if i == grip.pressed and not pull_of(frame, SLIP_LEFT) < INFINITY:
        return False
    return frame.inputs.slips


def add_gripped(
    grip: Grip, modes: Numbers, twist: Vector, pivot: int, forces: Numbers, continuum: bool,
    solutions: Numbers, count: int,
) -> int:  # fmt: skip
    """Add a solution with the forces of both fingers at both ends of their range; return the number."""
    if count < 0 or count == MOST_OF_SEVERAL:
        return UNSOLVED
    solution = SeveralSolution(solutions[SEVERAL_SOLUTION * count :])
    for m in range(SEVERAL_SOLUTION):
        solution[m] = 0.0
    one, other = frame_of(grip.several, 0), frame_of(grip.several, 1)
    r_x = other.inputs.point.x - one.inputs.point.x
    r_y = other.inputs.point.y - one.inputs.point.y
    distance = 2.0 * sqrt(r_x * r_x + r_y * r_y)
    for i in range(2):
        solution.modes[i] = modes[i]
    low, high = 0.0, 0.0
    if int(modes[grip.held]) != SEPARATE:
        low = ((forces[0] - forces[2]) * r_x + (forces[1] - forces[3]) * r_y) / distance
        high = ((forces[4] - forces[6]) * r_x + (forces[5] - forces[7]) * r_y) / distance
    turned: bool = high < low
    for m in range(4):
        solution.low_forces[m] = forces[m + 4] if turned else forces[m]
        solution.high_forces[m] = forces[m] if turned else forces[m + 4]
    solution.twist.x, solution.twist.y, solution.twist.spin = twist.x, twist.y, twist.spin
    solution.pivot, solution.continuum = pivot, continuum
    solution.low_inner, solution.high_inner = min(low, high), max(low, high)
    return settle_solution(grip.several, solutions, count)


def write_grip_force(force: Vector, i: int, forces: Numbers) -> None:
    """Add a force of a finger to both ends."""
    for end in range(2):
        forces[4 * end + 2 * i] += force.x
        forces[4 * end + 2 * i + 1] += force.y


def unit_forces_of_grip(grip: Grip, modes: Numbers, units: Numbers) -> int:
    """Write the unit forces that are not given: of the finger that moves as given, and of a stick.

    What they add to the inner force is the friction of the finger that presses, or if that is given, the
    normal force of the other one.
    """
    held, press = frame_of(grip.several, grip.held), frame_of(grip.several, grip.pressed)
    mode = int(modes[grip.pressed])
    alone = zeros(MOST_CONTACTS)
    alone[grip.held] = modes[grip.held]
    number = unit_forces(grip.several, alone, units)
    for k in range(number):
        unit = UnitForce(units[UNIT_FORCE * k :])
        unit.inner = unit.x * held.across.x + unit.y * held.across.y if mode != STICK else 0.0
    if mode == STICK:
        x, y = press.along.x, press.along.y
        number = write_unit_force(units, number, grip.pressed, 1.0, press.along, x, y)
        number = write_unit_force(units, number, grip.pressed, -1.0, press.along, x, y)
    return number


def balance_grip(
    grip: Grip, modes: Numbers, borne: HeldLoad, slack: float, forces: Numbers
) -> bool:
    """Write the forces with which both fingers balance a load within their laws; whether there are any."""
    press, mode = frame_of(grip.several, grip.pressed), int(modes[grip.pressed])
    units = zeros(MOST_UNITS * UNIT_FORCE)
    low, high = zeros(END_OF_FORCES), zeros(END_OF_FORCES)
    number, given = unit_forces_of_grip(grip, modes, units), force_of_press(grip, mode)
    load = HeldLoad(
        x=borne.x - grip.load.x - given.x,
        y=borne.y - grip.load.y - given.y,
        torque=borne.torque - grip.load.spin - given.spin,
        limit=borne.limit,
        foot_x=borne.foot_x,
        foot_y=borne.foot_y,
        size=borne.size + length_of_twist(grip.load) + length_of_twist(given),
    )
    if not balance_load(units, number, load, slack, low, high):
        return False
    least, most = -INFINITY, INFINITY
    if mode == STICK:
        pull, noise = grip.force * (1.0 + BALANCED), BALANCED * load.size
        least = pull * pull_of(press, SLIP_RIGHT) - noise
        most = pull * pull_of(press, SLIP_LEFT) + noise
    first, last = ForceEnd(low).inner, ForceEnd(high).inner
    if first > most or last < least or ForceEnd(low).is_infinite or ForceEnd(high).is_infinite:
        return False
    write_grip_force(given, grip.pressed, forces)
    for end in range(2):
        inner = min(max(first if end == 0 else last, least), most)
        part = (inner - first) / (last - first) if last > first else 0.0
        for k in range(number):
            unit = UnitForce(units[UNIT_FORCE * k :])
            multiple = (1.0 - part) * low[FORCE_END + k] + part * high[FORCE_END + k]
            forces[4 * end + 2 * unit.contact] += multiple * unit.x
            forces[4 * end + 2 * unit.contact + 1] += multiple * unit.y
    return True
