"""A slider between two fingers on one line, one of which is driven by force, and its solutions."""

from __future__ import annotations

from math import cos, fabs, sin, sqrt
from typing import NamedTuple

from planar_pushing.core._record import Record, size_of
from planar_pushing.core.instant.limit_line import add_multiple
from planar_pushing.core.instant.several_frames import (
    MOST_OF_SEVERAL,
    ContactFrame,
    Several,
    as_vector,
    frame_of,
    several_at,
)
from planar_pushing.core.instant.several_solutions import (
    SEVERAL_SOLUTION,
    SeveralSolution,
    settle_solution,
)
from planar_pushing.core.instant.solution import SEPARATE, SLIP_LEFT, SLIP_RIGHT, STICK, UNSOLVED
from planar_pushing.core.instant.twist_line import scale_vector
from planar_pushing.core.numbers import INFINITY, Numbers
from planar_pushing.core.supports.rows import Effects, Vector

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
