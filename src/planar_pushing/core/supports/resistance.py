"""The resistance of the effects of a scene: the sum of their wrenches at a twist, and its derivatives."""

from __future__ import annotations

from math import copysign, fabs, sqrt
from typing import NamedTuple

from planar_pushing.core.supports.pieces import (
    Pressure,
    atom_of,
    head_of,
    pressure_moments,
)
from planar_pushing.core.supports.ring import ring_response
from planar_pushing.core.supports.rows import (
    LOAD,
    MASS,
    NO_POINT,
    RING,
    SUPPORT,
    Effects,
    LoadRow,
    MassRow,
    RingRow,
    SupportRow,
    Vector,
    column_of,
    feet_of_effect,
    kind_of,
    pressure_of,
    scale_effects,
)

#: A center of rotation farther away than this, in extents of the support, is moved to this distance; only
#: the torque still decreases with the true distance.
FARTHEST_CENTER = 1e9


#: Beyond this distance the force is along the motion of the center of pressure, accurately enough for a
#: slope.
FAR_CENTER = 1e3


#: Rounding error of a sum over pieces, in units of that of its largest term; measured on polygons (4e-15).
TERMS_OF_SUM = 8.0


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
            point = feet_of_effect(effects, effect) + total.point
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
        return _ring_resistance(effects.one * RingRow(numbers).weight, x, y, spin)
    if kind == SUPPORT:
        pressure = pressure_of(effects, effect)
        return support_resistance(
            weight=effects.one * SupportRow(numbers).weight,
            extent=SupportRow(numbers).extent,
            pressure=pressure,
            x=x,
            y=y,
            spin=spin,
            blur=blur,
        )
    if kind == MASS:
        return _mass_resistance(
            mass=effects.two * MassRow(numbers).mass,
            gyration=MassRow(numbers).gyration,
            c_x=MassRow(numbers).center_x,
            c_y=MassRow(numbers).center_y,
            x=x,
            y=y,
            spin=spin,
        )
    one, load = effects.one, LoadRow(numbers)
    return constant_wrench(-(one * load.x), -(one * load.y), -(one * load.torque))


def constant_wrench(f_x: float, f_y: float, torque: float) -> Resistance:
    """The `Resistance` of a wrench that does not depend on the motion."""
    return Resistance(
        f_x,
        f_y,
        torque,
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
        limit = weight * atom_of(pressure, moments.atom).share
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
    spread = head_of(pressure).spread
    return spread.xx * x * x + 2.0 * spread.xy * x * y + spread.yy * y * y


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
        return mass_at(effects.one * RingRow(numbers).weight / speed, 1.0, -x, -y)
    if kind == SUPPORT:
        support, pressure = SupportRow(numbers), pressure_of(effects, effect)
        weight, extent = support.weight, support.extent
        spread = head_of(pressure).spread
        gyration = (spread.xx + spread.yy) * extent * extent
        c_x, c_y = extent * pressure.center_x, extent * pressure.center_y
        return mass_at(effects.one * weight / speed, gyration, c_x - x, c_y - y)
    if kind == MASS:
        body = MassRow(numbers)
        return mass_at(effects.two * body.mass, body.gyration, body.center_x - x, body.center_y - y)
    return Mass(0.0, 0.0, 0.0, 0.0)


def has_friction(effects: Effects) -> bool:
    """Whether friction resists motion."""
    return rough_mass(scale_effects(effects, 1.0, 0.0), 1.0, 0.0, 0.0).mass > 0.0


def mass_at(mass: float, gyration: float, x: float, y: float) -> Mass:
    """A mass centered at (x, y) from a point; `gyration` is the square of its radius of gyration."""
    return Mass(mass, mass * x, mass * y, mass * (x * x + y * y + gyration))


def load_wrench(effects: Effects) -> Vector:
    """Wrench of all loads about the origin, the same at rest and in any motion."""
    x, y, torque = 0.0, 0.0, 0.0
    for i in range(effects.length):
        effect = effects.length - 1 - i
        if kind_of(effects.data, effect) == LOAD:
            load = LoadRow(effects.row[column_of(effects.data, effect) :])
            x, y = effects.one * load.x + x, effects.one * load.y + y
            torque = effects.one * load.torque + torque
    return Vector(x, y, torque)


def kinetic_energy(effects: Effects, x: float, y: float, spin: float) -> float:
    """Potential of degree 2 at a twist: for inertia, the kinetic energy."""
    energy = 0.0
    for i in range(effects.length):
        effect = effects.length - 1 - i
        if kind_of(effects.data, effect) == MASS:
            body = MassRow(effects.row[column_of(effects.data, effect) :])
            v_x, v_y = x - spin * body.center_y, y + spin * body.center_x
            square = v_x * v_x + v_y * v_y + body.gyration * spin * spin
            energy = effects.two * body.mass * square / 2.0 + energy
    return energy
