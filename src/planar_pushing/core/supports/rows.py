"""The effects of a scene as rows of numbers.

A call has one flat array `data` for all its scenes, and a row of numbers for each. The data begin with an
`EffectHead` for each effect. The kind `LAST` ends the list, and its column is the first one after the
effects. Only the listed effects are evaluated: an absent effect takes no time.
"""

from __future__ import annotations

from typing import NamedTuple

from planar_pushing.core._record import Record, size_of
from planar_pushing.core.numbers import Numbers
from planar_pushing.core.supports.piece_rows import HEAD
from planar_pushing.core.supports.pieces import (
    Pressure,
    atom_of,
    count_atoms,
    head_of,
    pressure_at,
)

#: Kinds of effects: friction of the slider's own ring, friction of any pressure, a constant wrench, and a
#: mass, which is also the form of viscous friction.
RING, SUPPORT, LOAD, MASS = range(4)
LAST = -1
#: Number of a support point if there is none.
NO_POINT = -1


class Effects(NamedTuple):
    """The effects of a scene.

    Attributes
    ----------
    row, data : Numbers
    length : int
        Number of effects.
    feet : int
        Number of support points.
    frictional, massive : bool
        Whether there are potentials of degree 1, and of degree 2.
    linear : bool
        Whether all effects are loads and friction of points and segments, which can be on one line.
    one, two : float
        Factors of the forces of degree 1 and of degree 2.
    """

    row: Numbers
    data: Numbers
    length: int
    feet: int
    frictional: bool
    massive: bool
    linear: bool
    one: float
    two: float


class EffectHead(Record):
    """An effect in the list with which the data begin.

    Attributes
    ----------
    kind : int
        `RING` to `MASS`, or `LAST`.
    column : int
        Column of the row at which its numbers begin.
    table : int
        Place in the data at which the table of pressures of a support begins; places in a table are
        relative to it.
    """

    kind: int
    column: int
    table: int


#: Numbers of an effect at the beginning of the data.
EFFECT = size_of(EffectHead)


class RingRow(Record):
    """The weight on the slider's own ring."""

    weight: float


class SupportRow(RingRow):
    """The numbers of a support with friction.

    Attributes
    ----------
    weight, extent : float
    pressure : int
        Number of its pressure in the table.
    """

    extent: float
    pressure: int


class MassRow(Record):
    """The numbers of inertia, or of viscous friction in the form of a mass.

    Attributes
    ----------
    mass, gyration : float
        Mass, and square of its radius of gyration.
    center_x, center_y : float
    """

    mass: float
    gyration: float
    center_x: float
    center_y: float


class LoadRow(Record):
    """The numbers of a load, its wrench about the origin.

    Attributes
    ----------
    x, y, torque : float
    """

    x: float
    y: float
    torque: float


class Vector(NamedTuple):
    """A twist or a wrench: its components along x and y, and its rotation or torque."""

    x: float
    y: float
    spin: float


class Position(NamedTuple):
    """A position in the body frame."""

    x: float
    y: float


def read_effects(data: Numbers, row: Numbers) -> Effects:
    """The effects in a row of numbers."""
    frictional: bool = False
    massive: bool = False
    linear: bool = True
    count, feet = 0, 0
    while kind_of(data, count) != LAST:
        kind = kind_of(data, count)
        if kind == MASS:
            massive = True
        else:
            frictional = True
        if kind == SUPPORT:
            pressure = pressure_in(data, row, count)
            feet += count_atoms(pressure)
            head = head_of(pressure)
            linear = linear and head.rings == head.edges
        elif kind != LOAD:
            linear = False
        count += 1
    return Effects(row, data, count, feet, frictional, massive, linear, one=1.0, two=1.0)


def count_columns(data: Numbers) -> int:
    """Number of columns of a row that belong to the effects."""
    effect = 0
    while kind_of(data, effect) != LAST:
        effect += 1
    return column_of(data, effect)


def kind_of(data: Numbers, effect: int) -> int:
    """Kind of an effect."""
    return EffectHead(data[EFFECT * effect :]).kind


def column_of(data: Numbers, effect: int) -> int:
    """Column at which the numbers of an effect begin."""
    return EffectHead(data[EFFECT * effect :]).column


def pressure_in(data: Numbers, row: Numbers, effect: int) -> Pressure:
    """The pressure of a support; its places are indices into the support's table of pressures."""
    head = EffectHead(data[EFFECT * effect :])
    return pressure_at(data[head.table :], HEAD * SupportRow(row[head.column :]).pressure)


def pressure_of(effects: Effects, effect: int) -> Pressure:
    """The pressure of a support."""
    return pressure_in(effects.data, effects.row, effect)


def scale_effects(effects: Effects, one: float, two: float) -> Effects:
    """The effects with forces multiplied by a factor for each degree; a factor of zero removes a degree."""
    return Effects(
        effects.row,
        effects.data,
        effects.length,
        effects.feet,
        effects.frictional,
        effects.massive,
        effects.linear,
        one=one * effects.one,
        two=two * effects.two,
    )


def is_steady(effects: Effects) -> bool:
    """Whether all potentials have one degree, so that directions do not depend on magnitudes."""
    return effects.frictional != effects.massive


def feet_of_effect(effects: Effects, effect: int) -> int:
    """Number of support points of an effect."""
    if kind_of(effects.data, effect) != SUPPORT:
        return 0
    return count_atoms(pressure_of(effects, effect))


def foot_position(effects: Effects, number: int) -> Position:
    """Position of a support point in the body frame."""
    for effect in range(effects.length):
        if kind_of(effects.data, effect) == SUPPORT:
            pressure = pressure_of(effects, effect)
            count = count_atoms(pressure)
            if number < count:
                extent = SupportRow(effects.row[column_of(effects.data, effect) :]).extent
                atom = atom_of(pressure, number)
                return Position(extent * atom.x, extent * atom.y)
            number -= count
    return Position(0.0, 0.0)
