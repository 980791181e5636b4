"""Several contacts: their frames, and the twists that they allow in given modes.

Everything is in one frame, the body frame, with twists and wrenches about its origin and lengths in radii.
The tangent of a contact is its normal rotated by -90 degrees. A closed contact gives linear equations for
the twist: two if it sticks, one if it slips.
"""

from __future__ import annotations

from math import fabs, sqrt
from typing import NamedTuple

from planar_pushing.core._record import (
    Record,
    size_of,
)
from planar_pushing.core.contacts.twist_line import (
    dot_vectors,
    length_of_twist,
    scale_vector,
)
from planar_pushing.core.instant.directions import (
    unit_x,
    unit_y,
)
from planar_pushing.core.instant.solution import (
    SEPARATE,
    SLIP_LEFT,
    SLIP_RIGHT,
    STICK,
    Pair,
    Twist,
)
from planar_pushing.core.numbers import (
    Numbers,
    zeros,
)
from planar_pushing.core.supports.resistance import load_wrench
from planar_pushing.core.supports.rows import (
    Effects,
    Vector,
)
from planar_pushing.core.supports.tolerances import (
    COINCIDENT,
)

#: Maximum number of contacts, of their equations, and of the solutions of one problem.
MOST_CONTACTS, MOST_EQUATIONS, MOST_OF_SEVERAL = 4, 8, 16
#: Equations are independent if what the others leave of one, relative to its length, exceeds this.
RANK = 1e-10


class SeveralRow(Record):
    """A contact in a row of inputs.

    Attributes
    ----------
    point, normal, velocity : Pair
        Position, unit normal into the slider, and motion of the pusher there.
    right, left : float
        Angles of the edges of the law, from the tangent.
    slips, closed, rough : bool
        As in `Law`.
    """

    point: Pair
    normal: Pair
    velocity: Pair
    right: float
    left: float
    slips: bool
    closed: bool
    rough: bool


class ContactFrame(Record):
    """A contact with what follows from its row.

    Attributes
    ----------
    inputs : SeveralRow
    across, along : Twist
        Wrenches of unit forces along the normal and along the tangent. Their scalar product with a twist is
        the motion of the slider there.
    right, left : Twist
        Those along the edges of the law.
    pusher_across, pusher_along : float
        Motion of the pusher.
    """

    inputs: SeveralRow
    across: Twist
    along: Twist
    right: Twist
    left: Twist
    pusher_across: float
    pusher_along: float


class Equation(Twist):
    """A linear equation for a twist: its scalar product with a row has a value."""

    value: float


CONTACT_ROW, CONTACT_FRAME = size_of(SeveralRow), size_of(ContactFrame)
EQUATION = size_of(Equation)


class Several(NamedTuple):
    """A slider with several contacts: effects, their number and frames, and whether loads act."""

    effects: Effects
    number: int
    frames: Numbers
    loaded: bool


class MotionSet(NamedTuple):
    """The twists that the closed contacts allow: one of them, how many directions, and one direction."""

    twist: Vector
    dimension: int
    direction: Vector


def several_at(effects: Effects, number: int, frames: Numbers) -> Several:
    """A slider with several contacts; compiled code puts no row of zeros into a tuple."""
    load = load_wrench(effects)
    loaded: bool = load.x != 0.0 or load.y != 0.0 or load.spin != 0.0
    return Several(effects, number, frames, loaded)


def frame_of(several: Several, i: int) -> ContactFrame:
    """The frame of a contact."""
    return ContactFrame(several.frames[CONTACT_FRAME * i :])


def as_vector(twist: Twist) -> Vector:
    """A twist or a wrench in a row as a vector."""
    return Vector(twist.x, twist.y, twist.spin)


def write_frame(contact: SeveralRow, frame: ContactFrame) -> None:
    """Write the frame of a contact."""
    for k in range(CONTACT_ROW):
        frame[k] = contact[k]
    n_x, n_y = contact.normal.x, contact.normal.y
    _write_unit(contact, 0.0, 1.0, frame.across)
    _write_unit(contact, 1.0, 0.0, frame.along)
    _write_unit(contact, unit_x(contact.right), unit_y(contact.right), frame.right)
    _write_unit(contact, unit_x(contact.left), unit_y(contact.left), frame.left)
    frame.pusher_across = n_x * contact.velocity.x + n_y * contact.velocity.y
    frame.pusher_along = n_y * contact.velocity.x - n_x * contact.velocity.y


def _write_unit(contact: SeveralRow, along: float, across: float, wrench: Twist) -> None:
    """Write the wrench of a force with components along the tangent and the normal of a contact."""
    n_x, n_y = contact.normal.x, contact.normal.y
    wrench.x, wrench.y = along * n_y + across * n_x, across * n_y - along * n_x
    wrench.spin = contact.point.x * wrench.y - contact.point.y * wrench.x


def gap_rate(frame: ContactFrame, twist: Vector) -> float:
    """How fast the slider moves away from the pusher."""
    return dot_vectors(as_vector(frame.across), twist) - frame.pusher_across


def slip_rate(frame: ContactFrame, twist: Vector) -> float:
    """How fast the slider moves along the tangent relative to the pusher."""
    return dot_vectors(as_vector(frame.along), twist) - frame.pusher_along


def reach_of_rows(frame: ContactFrame) -> float:
    """Length of the rows of a contact."""
    x, y = frame.inputs.point.x, frame.inputs.point.y
    return sqrt(1.0 + x * x + y * y)


def keeps_modes(several: Several, modes: Numbers, twist: Vector) -> bool:
    """Whether no open contact closes, and each slip has its sign, to rounding."""
    size = 1.0 + length_of_twist(twist)
    for i in range(several.number):
        frame, mode = frame_of(several, i), int(modes[i])
        slack = COINCIDENT * size * reach_of_rows(frame)
        if mode == SEPARATE and gap_rate(frame, twist) < -slack:
            return False
        if mode == SLIP_RIGHT and slip_rate(frame, twist) < -slack:
            return False
        if mode == SLIP_LEFT and slip_rate(frame, twist) > slack:
            return False
    return True


def motions_of_modes(several: Several, modes: Numbers) -> MotionSet:
    """The twists that the closed contacts allow; no dimension, -1, if the pushers do not fit together."""
    rows, lengths = zeros(MOST_EQUATIONS * EQUATION), zeros(MOST_EQUATIONS)
    count = 0
    for i in range(several.number):
        frame, mode = frame_of(several, i), int(modes[i])
        if mode != SEPARATE:
            _write_equation(frame.across, frame.pusher_across, Equation(rows[EQUATION * count :]))
            lengths[count] = length_of_twist(as_vector(frame.across))
            count += 1
        if mode == STICK:
            _write_equation(frame.along, frame.pusher_along, Equation(rows[EQUATION * count :]))
            lengths[count] = length_of_twist(as_vector(frame.along))
            count += 1
    twist, rank = Vector(0.0, 0.0, 0.0), 0
    first, second = Vector(0.0, 0.0, 0.0), Vector(0.0, 0.0, 0.0)
    for _ in range(3):
        best, chosen = RANK, -1
        for k in range(count):
            size = length_of_twist(as_vector(Equation(rows[EQUATION * k :]))) / lengths[k]
            if size > best:
                best, chosen = size, k
        if chosen < 0:
            break
        best_row = Equation(rows[EQUATION * chosen :])
        length = length_of_twist(as_vector(best_row))
        unit, value = scale_vector(as_vector(best_row), 1.0 / length), best_row.value / length
        twist = Vector(
            twist.x + value * unit.x, twist.y + value * unit.y, twist.spin + value * unit.spin
        )
        for k in range(count):
            row = Equation(rows[EQUATION * k :])
            part = dot_vectors(as_vector(row), unit)
            row.x, row.y = row.x - part * unit.x, row.y - part * unit.y
            row.spin, row.value = row.spin - part * unit.spin, row.value - part * value
        for m in range(EQUATION):
            best_row[m] = 0.0
        if rank == 0:
            first = unit
        elif rank == 1:
            second = unit
        rank += 1
    size = 1.0 + length_of_twist(twist)
    for k in range(count):
        if fabs(Equation(rows[EQUATION * k :]).value) > COINCIDENT * lengths[k] * size:
            return MotionSet(twist, -1, first)
    return MotionSet(twist, 3 - rank, cross_vectors(first, second))


def _write_equation(wrench: Twist, value: float, equation: Equation) -> None:
    """Write the equation that a twist has a given power with a unit force."""
    equation.x, equation.y, equation.spin = wrench.x, wrench.y, wrench.spin
    equation.value = value


def cross_vectors(one: Vector, other: Vector) -> Vector:
    """The vector product of two wrenches: the rotation about the meeting point of their lines."""
    return Vector(
        one.y * other.spin - one.spin * other.y,
        one.spin * other.x - one.x * other.spin,
        one.x * other.y - one.y * other.x,
    )
