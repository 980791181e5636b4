"""The effects of a scene as rows of numbers, and their sum at a twist.

A call has one flat array `data` for all its scenes, and a row of numbers for each. The data begin with four
numbers for each effect: its kind; the column of the row at which its numbers begin; for a support, the
place at which its table of pressures begins; and an unused one. Places in a table are relative to its
beginning. The kind `LAST` ends the list, and its column is the first one after the effects. Only the listed
effects are evaluated: an absent effect takes no time.
"""

from __future__ import annotations

from math import copysign, fabs, sqrt
from typing import NamedTuple

from planar_pushing.core.numbers import Numbers
from planar_pushing.core.supports.pieces import (
    EDGES,
    HEAD,
    RINGS,
    SPREAD,
    Pressure,
    count_atoms,
    place_of,
    place_of_atom,
    pressure_at,
    pressure_moments,
)
from planar_pushing.core.supports.ring import ring_response

#: Kinds of effects: friction of the slider's own ring, friction of any pressure, a constant wrench, and a
#: mass, which is also the form of viscous friction.
RING, SUPPORT, LOAD, MASS = range(4)
LAST = -1
#: Number of entries of an effect at the beginning of the data.
ENTRY = 4
#: Number of a support point if there is none.
NO_POINT = -1
#: A center of rotation farther away than this, in extents of the support, is moved to this distance; only
#: the torque still decreases with the true distance.
FARTHEST_CENTER = 1e9
#: Beyond this distance the force is along the motion of the center of pressure, accurately enough for a
#: slope.
FAR_CENTER = 1e3
#: Rounding error of a sum over pieces, in units of that of its largest term; measured on polygons (4e-15).
TERMS_OF_SUM = 8.0


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


class Resistance(NamedTuple):
    """Gradient and Hessian of a potential at a twist (x, y, spin) about a point.

    Attributes
    ----------
    f_x, f_y, torque : float
        The wrench that sustains the twist, without friction of support points at the center of rotation.
    xx, xy, yy, xs, ys, ss : float
        Second derivatives.
    limit : float
        Maximum friction of the points at the center of rotation.
    point : int
        Number of the first of these points, `NO_POINT` without one.
    terms : float
        Magnitude of the terms of the force, whose rounding error is a few units in the last place of this
        magnitude.
    """

    f_x: float
    f_y: float
    torque: float
    xx: float
    xy: float
    yy: float
    xs: float
    ys: float
    ss: float
    limit: float
    point: int
    terms: float


class Mass(NamedTuple):
    """Mass, first moments, and moment of inertia about a point."""

    mass: float
    x: float
    y: float
    inertia: float


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
            linear = linear and place_of(pressure, RINGS) == place_of(pressure, EDGES)
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
    return int(data[ENTRY * effect])


def column_of(data: Numbers, effect: int) -> int:
    """Column at which the numbers of an effect begin."""
    return int(data[ENTRY * effect + 1])


def pressure_in(data: Numbers, row: Numbers, effect: int) -> Pressure:
    """The pressure of a support; its places are indices into the support's table of pressures."""
    table = data[int(data[ENTRY * effect + 2]) :]
    return pressure_at(table, HEAD * int(row[column_of(data, effect) + 2]))


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


def resistance(effects: Effects, x: float, y: float, spin: float, blur: float) -> Resistance:
    """`Resistance` of all effects at a nonzero twist, about the origin.

    Parameters
    ----------
    effects : Effects
    x, y, spin : float
    blur : float
        Rounding error of x and y, within which points are at the center of rotation.
    """
    effect = effects.length - 1
    total = effect_resistance(effects, effect, x, y, spin, blur)
    while effect > 0:
        effect -= 1
        part = effect_resistance(effects, effect, x, y, spin, blur)
        point = part.point
        if point < 0 and total.point >= 0:
            point = _count_feet(effects, effect) + total.point
        total = Resistance(
            f_x=part.f_x + total.f_x,
            f_y=part.f_y + total.f_y,
            torque=part.torque + total.torque,
            xx=part.xx + total.xx,
            xy=part.xy + total.xy,
            yy=part.yy + total.yy,
            xs=part.xs + total.xs,
            ys=part.ys + total.ys,
            ss=part.ss + total.ss,
            limit=part.limit + total.limit,
            point=point,
            terms=part.terms + total.terms,
        )
    return total


def effect_resistance(
    effects: Effects, effect: int, x: float, y: float, spin: float, blur: float
) -> Resistance:
    """`Resistance` of one effect; arguments as in `resistance`."""
    kind, numbers = kind_of(effects.data, effect), effects.row[column_of(effects.data, effect) :]
    if kind == RING:
        return _ring_resistance(effects.one * numbers[0], x, y, spin)
    if kind == SUPPORT:
        pressure = pressure_of(effects, effect)
        return support_resistance(
            weight=effects.one * numbers[0],
            extent=numbers[1],
            pressure=pressure,
            x=x,
            y=y,
            spin=spin,
            blur=blur,
        )
    if kind == MASS:
        return _mass_resistance(
            mass=effects.two * numbers[0],
            gyration=numbers[1],
            c_x=numbers[2],
            c_y=numbers[3],
            x=x,
            y=y,
            spin=spin,
        )
    one = effects.one
    return Resistance(
        f_x=-(one * numbers[0]),
        f_y=-(one * numbers[1]),
        torque=-(one * numbers[2]),
        xx=0.0,
        xy=0.0,
        yy=0.0,
        xs=0.0,
        ys=0.0,
        ss=0.0,
        limit=0.0,
        point=NO_POINT,
        terms=0.0,
    )


def _ring_resistance(weight: float, x: float, y: float, spin: float) -> Resistance:
    """Friction of the slider's own ring, of unit radius about the origin (Eqs. 2-3)."""
    speed = sqrt(x * x + y * y)
    response = ring_response(speed, spin)
    c, s, across = 0.0, 0.0, response.vv
    if speed > 0.0:
        c, s, across = x / speed, y / speed, response.force / speed
    bend = response.vv - across
    return Resistance(
        f_x=weight * across * x,
        f_y=weight * across * y,
        torque=weight * response.torque,
        xx=weight * (across + bend * c * c),
        xy=weight * bend * c * s,
        yy=weight * (across + bend * s * s),
        xs=weight * response.vs * c,
        ys=weight * response.vs * s,
        ss=weight * response.ss,
        limit=0.0,
        point=NO_POINT,
        terms=0.0,
    )


def _mass_resistance(
    mass: float, gyration: float, c_x: float, c_y: float, x: float, y: float, spin: float
) -> Resistance:
    """Inertia of a mass at (c_x, c_y) with a squared radius of gyration (Eqs. 8-10)."""
    f_x, f_y = mass * (x - spin * c_y), mass * (y + spin * c_x)
    torque = mass * gyration * spin + c_x * f_y - c_y * f_x
    inertia = mass * (gyration + c_x * c_x + c_y * c_y)
    terms = mass * fabs(spin) * (fabs(c_x) + fabs(c_y))
    return Resistance(
        f_x,
        f_y,
        torque,
        xx=mass,
        xy=0.0,
        yy=mass,
        xs=-mass * c_y,
        ys=mass * c_x,
        ss=inertia,
        limit=0.0,
        point=NO_POINT,
        terms=terms,
    )


def support_resistance(
    weight: float, extent: float, pressure: Pressure,
    x: float, y: float, spin: float, blur: float,
) -> Resistance:  # fmt: skip
    """Friction of a pressure whose lengths are in units of its extent; the extent is in radii."""
    p_x, p_y, rate = pressure.center_x, pressure.center_y, spin * extent
    w_x, w_y = x - rate * p_y, y + rate * p_x
    speed = sqrt(w_x * w_x + w_y * w_y)
    turn = copysign(max(fabs(rate), speed / FARTHEST_CENTER), rate)
    c_x, c_y = -w_y / turn, w_x / turn
    moments = pressure_moments(pressure, p_x + c_x, p_y + c_y, blur / fabs(turn))
    limit = 0.0
    if moments.atom >= 0:
        limit = weight * pressure.data[place_of_atom(pressure, moments.atom) + 2]
    sign, part = copysign(weight, turn), weight / fabs(turn)
    f_x, f_y = -sign * moments.unit_y, sign * moments.unit_x
    xx, xy, yy = part * moments.yy, -part * moments.xy, part * moments.xx
    if c_x * c_x + c_y * c_y > FAR_CENTER * FAR_CENTER:
        b_x, b_y = 0.0, 0.0
        bend = weight / speed * _spread_along(pressure, w_x / speed, w_y / speed)
    else:
        b_x, b_y = -(xx * w_x + xy * w_y) / turn, -(xy * w_x + yy * w_y) / turn
        bend = -(b_x * w_x + b_y * w_y) / turn
    # Transfer from the center of pressure, whose motion is w, to the origin, and from extents to radii.
    torque = part * rate * moments.torque + p_x * f_y - p_y * f_x
    a_x, a_y = -xx * p_y + xy * p_x, -xy * p_y + yy * p_x
    bend += -p_y * (2.0 * b_x + a_x) + p_x * (2.0 * b_y + a_y)
    return Resistance(
        f_x,
        f_y,
        torque=extent * torque,
        xx=xx,
        xy=xy,
        yy=yy,
        xs=extent * (b_x + a_x),
        ys=extent * (b_y + a_y),
        ss=extent * extent * bend,
        limit=limit,
        point=moments.atom,
        terms=TERMS_OF_SUM * weight,
    )


def _spread_along(pressure: Pressure, x: float, y: float) -> float:
    """Mean square of the positions along a direction: the stiffness of a translation to rotation."""
    spread = pressure.data[pressure.head + SPREAD :]
    return spread[0] * x * x + 2.0 * spread[1] * x * y + spread[2] * y * y


def rough_mass(effects: Effects, speed: float, x: float, y: float) -> Mass:
    """A mass that roughly matches the effects at a speed, about (x, y), for first guesses."""
    effect = effects.length - 1
    total = _rough_mass_of(effects, effect, speed, x, y)
    while effect > 0:
        effect -= 1
        part = _rough_mass_of(effects, effect, speed, x, y)
        total = Mass(
            part.mass + total.mass, part.x + total.x, part.y + total.y, part.inertia + total.inertia
        )
    return total


def _rough_mass_of(effects: Effects, effect: int, speed: float, x: float, y: float) -> Mass:
    """`rough_mass` of one effect."""
    kind, numbers = kind_of(effects.data, effect), effects.row[column_of(effects.data, effect) :]
    if kind == RING:
        return mass_at(effects.one * numbers[0] / speed, 1.0, -x, -y)
    if kind == SUPPORT:
        extent, pressure = numbers[1], pressure_of(effects, effect)
        spread = pressure.data[pressure.head + SPREAD :]
        gyration = (spread[0] + spread[2]) * extent * extent
        c_x, c_y = extent * pressure.center_x, extent * pressure.center_y
        return mass_at(effects.one * numbers[0] / speed, gyration, c_x - x, c_y - y)
    if kind == MASS:
        return mass_at(effects.two * numbers[0], numbers[1], numbers[2] - x, numbers[3] - y)
    return Mass(0.0, 0.0, 0.0, 0.0)


def has_friction(effects: Effects) -> bool:
    """Whether friction resists motion."""
    return rough_mass(scale_effects(effects, 1.0, 0.0), 1.0, 0.0, 0.0).mass > 0.0


def mass_at(mass: float, gyration: float, x: float, y: float) -> Mass:
    """A mass centered at (x, y) from a point; `gyration` is the square of its radius of gyration."""
    return Mass(mass, mass * x, mass * y, mass * (x * x + y * y + gyration))


def _count_feet(effects: Effects, effect: int) -> int:
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
                extent = effects.row[column_of(effects.data, effect) + 1]
                atom = pressure.data[place_of_atom(pressure, number) :]
                return Position(extent * atom[0], extent * atom[1])
            number -= count
    return Position(0.0, 0.0)


def load_wrench(effects: Effects) -> Vector:
    """Wrench of all loads about the origin, the same at rest and in any motion."""
    x, y, torque = 0.0, 0.0, 0.0
    for i in range(effects.length):
        effect = effects.length - 1 - i
        if kind_of(effects.data, effect) == LOAD:
            numbers = effects.row[column_of(effects.data, effect) :]
            x, y = effects.one * numbers[0] + x, effects.one * numbers[1] + y
            torque = effects.one * numbers[2] + torque
    return Vector(x, y, torque)


def kinetic_energy(effects: Effects, x: float, y: float, spin: float) -> float:
    """Potential of degree 2 at a twist: for inertia, the kinetic energy."""
    energy = 0.0
    for i in range(effects.length):
        effect = effects.length - 1 - i
        if kind_of(effects.data, effect) == MASS:
            numbers = effects.row[column_of(effects.data, effect) :]
            v_x, v_y = x - spin * numbers[3], y + spin * numbers[2]
            square = v_x * v_x + v_y * v_y + numbers[1] * spin * spin
            energy = effects.two * numbers[0] * square / 2.0 + energy
    return energy
