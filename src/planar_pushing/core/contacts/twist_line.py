"""A line of twists, and the power of the load along a given twist, with exact ranges for friction of feet.

The friction of a support depends on the angle of the line alone, as only the direction of a twist counts:
``F(xi_0 + tan(a) d) = F(cos(a) xi_0 + sin(a) d)``. The power of a foot is the cosine of an angle that turns
one way along the line, so it has one extremum at most, and so has the numerator of its slope.
"""

from __future__ import annotations

from math import atan2, cos, fabs, sin, sqrt
from typing import NamedTuple

from planar_pushing.core.numbers import (
    INFINITY,
)
from planar_pushing.core.supports.pieces import (
    atom_of,
    count_atoms,
    head_of,
)
from planar_pushing.core.supports.resistance import (
    load_wrench,
    resistance,
)
from planar_pushing.core.supports.rows import (
    RING,
    SUPPORT,
    Effects,
    RingRow,
    SupportRow,
    Vector,
    column_of,
    foot_position,
    kind_of,
    pressure_of,
    scale_effects,
)
from planar_pushing.core.supports.tolerances import (
    COINCIDENT,
    RESOLUTION,
)

#: Rounding errors of the sum over a support, in those of its largest term.
SUM_NOISE = 8.0


class TwistLine(NamedTuple):
    """A line of twists, and the twist along which the load vanishes.

    Attributes
    ----------
    effects : Effects
    start, step : Vector
        Twists of unit size; the twist at an angle is ``size * (start + tan(angle) * step)``.
    size : float
    probe : Vector
        The twist q, of unit size.
    constant, linear : float
        Power along the probe of loads and masses: ``constant + linear * tan(angle)``.
    noise : float
        Rounding error of the power.
    on_feet : bool
        Whether all friction is that of feet.
    given : float
        Power along the probe of given forces, which the constant contains, too.
    """

    effects: Effects
    start: Vector
    step: Vector
    size: float
    probe: Vector
    constant: float
    linear: float
    noise: float
    on_feet: bool
    given: float


class FootTerm(NamedTuple):
    """Velocities of a foot under the start, the step and the probe, and the rotation ``v_0 x v_1``.

    The rotation is zero if the foot keeps its direction of motion, or reverses it where it rests.
    """

    start_x: float
    start_y: float
    step_x: float
    step_y: float
    probe_x: float
    probe_y: float
    turn: float


class Power(NamedTuple):
    """The power along the probe at an angle, and its derivative."""

    value: float
    slope: float


class Ranges(NamedTuple):
    """Bounds on the values and on the slopes between two angles."""

    low: float
    high: float
    least_slope: float
    most_slope: float


class Turned(NamedTuple):
    """Cosine and sine of an angle."""

    c: float
    s: float


def length_of_twist(twist: Vector) -> float:
    """Size of a twist whose lengths are in radii."""
    return sqrt(twist.x * twist.x + twist.y * twist.y + twist.spin * twist.spin)


def scale_vector(vector: Vector, factor: float) -> Vector:
    """A multiple of a twist or a wrench."""
    return Vector(factor * vector.x, factor * vector.y, factor * vector.spin)


def dot_vectors(one: Vector, other: Vector) -> float:
    """The power of a wrench and a twist, or the scalar product of two of them."""
    return one.x * other.x + one.y * other.y + one.spin * other.spin


def tangent_of(angle: float) -> float:
    """The tangent of an angle, finite at the double nearest to a right angle."""
    return sin(angle) / cos(angle)


def line_through(effects: Effects, start: Vector, step: Vector, probe: Vector) -> TwistLine:
    """The line through a twist along another one; none of the three is zero."""
    size, length, probe_size = length_of_twist(start), length_of_twist(step), length_of_twist(probe)
    start, step = scale_vector(start, 1.0 / size), scale_vector(step, 1.0 / length)
    probe = scale_vector(probe, 1.0 / probe_size)
    loads = load_wrench(effects)
    constant, linear = -dot_vectors(Vector(loads.x, loads.y, loads.spin), probe), 0.0
    terms, on_feet = fabs(constant), True
    for effect in range(effects.length):
        kind, numbers = (
            kind_of(effects.data, effect),
            effects.row[column_of(effects.data, effect) :],
        )
        if kind == RING:
            on_feet = False
            terms += effects.one * RingRow(numbers).weight
        elif kind == SUPPORT:
            head = head_of(pressure_of(effects, effect))
            if head.segments != head.edges:
                on_feet = False
            terms += effects.one * SupportRow(numbers).weight
    if effects.massive:
        masses = scale_effects(effects, 0.0, 1.0)
        constant += size * _power_at(masses, start, probe)
        linear = size * _power_at(masses, step, probe)
        terms += fabs(constant) + fabs(linear)
    return TwistLine(
        effects=effects,
        start=start,
        step=step,
        size=size,
        probe=probe,
        constant=constant,
        linear=linear,
        noise=SUM_NOISE * RESOLUTION * terms,
        on_feet=on_feet,
        given=0.0,
    )


def give_force(line: TwistLine, force: Vector) -> TwistLine:
    """The line with a given force on the slider, which bears a part of the load."""
    power = dot_vectors(force, line.probe)
    return TwistLine(
        line.effects, line.start, line.step, line.size, line.probe,
        constant=line.constant - power, linear=line.linear,
        noise=line.noise + SUM_NOISE * RESOLUTION * fabs(power), on_feet=line.on_feet, given=power,
    )  # fmt: skip


def _power_at(effects: Effects, twist: Vector, probe: Vector) -> float:
    """Power along the probe of the load of a twist."""
    total = resistance(effects, x=twist.x, y=twist.y, spin=twist.spin, blur=0.0)
    return dot_vectors(Vector(total.f_x, total.f_y, total.torque), probe)


def direction_on_line(line: TwistLine, angle: float) -> Vector:
    """The twist at an angle, divided by its size and multiplied by the cosine."""
    c, s = cos(angle), sin(angle)
    return Vector(
        c * line.start.x + s * line.step.x,
        c * line.start.y + s * line.step.y,
        c * line.start.spin + s * line.step.spin,
    )


def twist_on_line(line: TwistLine, angle: float) -> Vector:
    """The twist at an angle."""
    part = line.size * tangent_of(angle)
    return Vector(
        line.size * line.start.x + part * line.step.x,
        line.size * line.start.y + part * line.step.y,
        line.size * line.start.spin + part * line.step.spin,
    )


def power_on_line(line: TwistLine, angle: float, inside: float) -> Power:
    """The power at an angle and its derivative, on the side of a pivot on which `inside` is.

    With masses and a support that is not on feet, it is multiplied by the cosine and stays finite.
    """
    if line.on_feet:
        return _feet_power(line, angle, inside)
    friction = scale_effects(line.effects, 1.0, 0.0)
    twist = direction_on_line(line, angle)
    c, s, probe = cos(angle), sin(angle), line.probe
    turn = Vector(
        c * line.step.x - s * line.start.x,
        c * line.step.y - s * line.start.y,
        c * line.step.spin - s * line.start.spin,
    )
    total = resistance(friction, x=twist.x, y=twist.y, spin=twist.spin, blur=0.0)
    value = dot_vectors(Vector(total.f_x, total.f_y, total.torque), probe)
    bend = Vector(
        total.xx * turn.x + total.xy * turn.y + total.xs * turn.spin,
        total.xy * turn.x + total.yy * turn.y + total.ys * turn.spin,
        total.xs * turn.x + total.ys * turn.y + total.ss * turn.spin,
    )
    slope = dot_vectors(bend, probe)
    if not line.effects.massive:
        return Power(value - line.given, slope)
    load = load_wrench(line.effects)
    mass = line.constant + dot_vectors(load, probe)
    return Power(
        c * value + c * mass + s * line.linear,
        c * slope - s * value - s * mass + c * line.linear,
    )


def _foot_term(line: TwistLine, x: float, y: float) -> FootTerm:
    """The velocities of a foot."""
    start, step, probe = line.start, line.step, line.probe
    start_x, start_y = start.x - start.spin * y, start.y + start.spin * x
    step_x, step_y = step.x - step.spin * y, step.y + step.spin * x
    turn = start_x * step_y - start_y * step_x
    size = start_x * start_x + start_y * start_y + step_x * step_x + step_y * step_y
    if fabs(turn) <= COINCIDENT * size:
        turn = 0.0
    return FootTerm(
        start_x=start_x,
        start_y=start_y,
        step_x=step_x,
        step_y=step_y,
        probe_x=probe.x - probe.spin * y,
        probe_y=probe.y + probe.spin * x,
        turn=turn,
    )


def term_of_foot(line: TwistLine, number: int) -> FootTerm:
    """The velocities of a foot with a number."""
    foot = foot_position(line.effects, number)
    return _foot_term(line, foot.x, foot.y)


def angle_of_rest(line: TwistLine, term: FootTerm) -> float:
    """The angle at which a foot rests that reverses its motion; infinite if it does not."""
    along = term.start_x * term.step_x + term.start_y * term.step_y
    square = term.step_x * term.step_x + term.step_y * term.step_y
    still = term.start_x * term.start_x + term.start_y * term.start_y
    if term.turn != 0.0 or square <= COINCIDENT * COINCIDENT * (square + still) or square == 0.0:
        return INFINITY
    return atan2(-along, square)


def _term_power(term: FootTerm, turned: Turned) -> Power:
    """The power of a foot of unit share."""
    v_x = turned.c * term.start_x + turned.s * term.step_x
    v_y = turned.c * term.start_y + turned.s * term.step_y
    speed = sqrt(v_x * v_x + v_y * v_y)
    if speed == 0.0:
        return Power(0.0, 0.0)
    ahead = (term.probe_x * v_x + term.probe_y * v_y) / speed
    across = (v_x * term.probe_y - v_y * term.probe_x) / speed
    return Power(ahead, term.turn * across / (speed * speed))


def _feet_power(line: TwistLine, angle: float, inside: float) -> Power:
    """The power of feet, loads and masses."""
    value, slope = line.constant, 0.0
    turned, within = Turned(cos(angle), sin(angle)), Turned(cos(inside), sin(inside))
    if line.linear != 0.0:
        tangent = turned.s / turned.c
        value, slope = value + line.linear * tangent, line.linear * (1.0 + tangent * tangent)
    total = _add_feet(line, Ranges(value, value, slope, slope), turned, turned, within, False)
    return Power(total.low, total.least_slope)


def feet_ranges(line: TwistLine, low: float, high: float, inside: float) -> Ranges:
    """Ranges of the sum of all feet between two angles within a quarter turn, exact for each foot."""
    first, last = Turned(cos(low), sin(low)), Turned(cos(high), sin(high))
    within = Turned(cos(inside), sin(inside))
    lowest, highest, least_slope, most_slope = line.constant, line.constant, 0.0, 0.0
    if line.linear != 0.0:
        one, other = line.linear * first.s / first.c, line.linear * last.s / last.c
        lowest, highest = lowest + min(one, other), highest + max(one, other)
        one, other = line.linear / (first.c * first.c), line.linear / (last.c * last.c)
        least_slope, most_slope = min(one, other), max(one, other)
        if low < 0.0 < high:
            least_slope, most_slope = min(least_slope, line.linear), max(most_slope, line.linear)
    rest = Ranges(lowest, highest, least_slope, most_slope)
    return _add_feet(line, rest, first, last, within, True)


def _add_feet(
    line: TwistLine, rest: Ranges, first: Turned, last: Turned, within: Turned, between: bool
) -> Ranges:
    """Add the power of all feet, at the first angle or in its ranges between two, to those of the rest.

    A foot that keeps its direction of motion has the power of an angle within.
    """
    effects, lowest, highest = line.effects, rest.low, rest.high
    least_slope, most_slope = rest.least_slope, rest.most_slope
    for effect in range(effects.length):
        if kind_of(effects.data, effect) == SUPPORT:
            support = SupportRow(effects.row[column_of(effects.data, effect) :])
            pressure = pressure_of(effects, effect)
            for i in range(count_atoms(pressure)):
                atom = atom_of(pressure, i)
                share = effects.one * support.weight * atom.share
                term = _foot_term(line, support.extent * atom.x, support.extent * atom.y)
                if between and term.turn != 0.0:
                    part = _term_ranges(term, first, last)
                else:
                    power = _term_power(term, within if term.turn == 0.0 else first)
                    part = Ranges(power.value, power.value, power.slope, power.slope)
                lowest, highest = lowest + share * part.low, highest + share * part.high
                least_slope += share * part.least_slope
                most_slope += share * part.most_slope
    return Ranges(lowest, highest, least_slope, most_slope)


def _term_ranges(term: FootTerm, first: Turned, last: Turned) -> Ranges:
    """Ranges of the power of a foot of unit share, between two angles within a quarter turn.

    The direction of the foot's motion turns one way. The power is extremal where it is that of the probe,
    and the slope is ``turn (v x u) / |v|^3``.
    """
    a_x = first.c * term.start_x + first.s * term.step_x
    a_y = first.c * term.start_y + first.s * term.step_y
    da_x = first.c * term.step_x - first.s * term.start_x
    da_y = first.c * term.step_y - first.s * term.start_y
    b_x = last.c * term.start_x + last.s * term.step_x
    b_y = last.c * term.start_y + last.s * term.step_y
    db_x = last.c * term.step_x - last.s * term.start_x
    db_y = last.c * term.step_y - last.s * term.start_y
    u_x, u_y = term.probe_x, term.probe_y
    slow, fast = a_x * a_x + a_y * a_y, b_x * b_x + b_y * b_y
    one = (u_x * a_x + u_y * a_y) / sqrt(slow)
    other = (u_x * b_x + u_y * b_y) / sqrt(fast)
    lowest, highest = min(one, other), max(one, other)
    at_a, at_b = a_x * u_y - a_y * u_x, b_x * u_y - b_y * u_x
    if at_a * at_b < 0.0:
        z_x, z_y = fabs(at_b) * a_x + fabs(at_a) * b_x, fabs(at_b) * a_y + fabs(at_a) * b_y
        longest = sqrt(u_x * u_x + u_y * u_y)
        if z_x * u_x + z_y * u_y > 0.0:
            highest = longest
        else:
            lowest = -longest
    up_a, up_b = term.turn * (da_x * u_y - da_y * u_x), term.turn * (db_x * u_y - db_y * u_x)
    bottom, top = min(term.turn * at_a, term.turn * at_b), max(term.turn * at_a, term.turn * at_b)
    if up_a * up_b < 0.0:
        x = term.start_x * u_y - term.start_y * u_x
        y = term.step_x * u_y - term.step_y * u_x
        peak = fabs(term.turn) * sqrt(x * x + y * y)
        if up_a > 0.0:
            top = peak
        else:
            bottom = -peak
    rise_a, rise_b = a_x * da_x + a_y * da_y, b_x * db_x + b_y * db_y
    slow, fast = min(slow, fast), max(slow, fast)
    if rise_a * rise_b < 0.0:
        start = term.start_x * term.start_x + term.start_y * term.start_y
        step = term.step_x * term.step_x + term.step_y * term.step_y
        both = term.start_x * term.step_x + term.start_y * term.step_y
        spread = sqrt((start - step) * (start - step) / 4.0 + both * both)
        largest = (start + step) / 2.0 + spread
        if rise_a < 0.0:
            slow = min(slow, term.turn * term.turn / largest)
        else:
            fast = max(fast, largest)
    steep, mild = 1.0 / (slow * sqrt(slow)), 1.0 / (fast * sqrt(fast))
    return Ranges(
        lowest,
        highest,
        least_slope=bottom * (steep if bottom < 0.0 else mild),
        most_slope=top * (steep if top > 0.0 else mild),
    )
