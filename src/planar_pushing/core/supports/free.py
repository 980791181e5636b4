"""The motion of a slider without a pusher: rest, or a motion caused by loads.

It is the minimum of the total potential over all twists, which is strictly convex with inertia. The
potential of friction has kinks at rest and at rotations about each support point. The minimum over the
rotations about one of them has a closed form. Newton's method with descent steps starts from the lowest of
these minima and therefore meets no kink.

If no start is below rest, friction may hold the loads. Half the square of friction's potential D, minus the
power of the loads, has no kink at rest. Its minimum is at the twist whose friction is proportional to the
loads.
"""

from __future__ import annotations

from math import copysign, fabs, sqrt
from typing import NamedTuple

from planar_pushing.core.numbers import EPSILON, INFINITY
from planar_pushing.core.supports.resistance import (
    Resistance,
    kinetic_energy,
    load_wrench,
    resistance,
    rough_mass,
)
from planar_pushing.core.supports.rows import (
    NO_POINT,
    Effects,
    Vector,
    foot_position,
    scale_effects,
)
from planar_pushing.core.supports.tolerances import RESOLUTION, ROUNDING, SHARE, SLIGHTEST_LOAD

#: Maximum number of Newton steps, and of trials along one.
DESCENTS = 60
TRIALS = 120
#: Maximum number of Newton steps, and one, by which a twist of minimum value is polished.
POLISHES_OF_TWIST = 5
#: A line search ends where the slope of the potential has fallen to this fraction of its initial value, or
#: where the position of the minimum is known to this relative error.
SLOPE_LEFT = 0.3
STEP_LEFT = 1e-6


class Level(NamedTuple):
    """A twist, and the value of the potential there."""

    twist: Vector
    value: float


class Loads(NamedTuple):
    """The wrench of all loads about the origin, and the part of it that is not among the effects."""

    total: Vector
    more: Vector


def free_twist(effects: Effects, more: Vector) -> Vector:
    """The twist at which the net wrench is zero; a zero twist if friction holds the loads.

    Parameters
    ----------
    effects : Effects
    more : Vector
        Wrench about the origin that acts on the slider besides the effects.
    """
    rest = Vector(0.0, 0.0, 0.0)
    if not effects.massive:
        return rest
    listed = load_wrench(effects)
    total = Vector(listed.x + more.x, listed.y + more.y, listed.spin + more.spin)
    if _size_of(total) < SLIGHTEST_LOAD:
        return rest
    loads, fall = Loads(total, more), _frictionless_twist(effects, total)
    level = _lowest_start(effects, loads, fall, False)
    if not level.value < 0.0:
        start = _lowest_start(effects, loads, fall, True).twist
        level = _minimum_on_ray(effects, loads, _descend(effects, loads, start, True), False)
    return _descend(effects, loads, level.twist, False) if level.value < 0.0 else rest


def foot_at_center(effects: Effects, twist: Vector) -> int:
    """Number of the support point about which the slider rotates, `NO_POINT` without one."""
    if twist.spin == 0.0:
        return NO_POINT
    slack = ROUNDING * (fabs(twist.x) + fabs(twist.y))
    return resistance(effects, twist.x, twist.y, twist.spin, slack).point


def friction_share(effects: Effects, more: Vector) -> Level:
    """The twist whose friction is proportional to all loads, and their ratio to the largest that it holds.

    Parameters
    ----------
    effects : Effects
        Among them friction and a mass, which only guides the search.
    more : Vector
        Wrench about the origin that acts on the slider besides the effects.
    """
    listed = load_wrench(effects)
    total = Vector(listed.x + more.x, listed.y + more.y, listed.spin + more.spin)
    if _size_of(total) < SLIGHTEST_LOAD:
        return Level(Vector(0.0, 0.0, 0.0), 0.0)
    loads, fall = Loads(total, more), _frictionless_twist(effects, total)
    start = _lowest_start(effects, loads, fall, True).twist
    twist = _descend(effects, loads, start, True)
    friction = _net_resistance(effects, loads, twist, 0.0)
    wrench = Vector(friction.f_x + total.x, friction.f_y + total.y, friction.torque + total.spin)
    held = _power(wrench, twist)
    return Level(twist, _power(total, twist) / held if held > 0.0 else INFINITY)


def _frictionless_twist(effects: Effects, load: Vector) -> Vector:
    """The twist that loads would cause without friction."""
    mass = rough_mass(effects, INFINITY, 0.0, 0.0)
    x, y = mass.x / mass.mass, mass.y / mass.mass
    # About the center of mass, which can be far away, the moment of inertia keeps all its digits.
    inertia = rough_mass(effects, INFINITY, x, y).inertia
    spin = (load.spin - (x * load.y - y * load.x)) / inertia
    return Vector(load.x / mass.mass + spin * y, load.y / mass.mass - spin * x, spin)


def _solve_symmetric(
    xx: float, xy: float, yy: float, xs: float, ys: float, ss: float, wrench: Vector
) -> Vector:
    """The twist that a positive-definite matrix maps to a wrench; its rotation can be lost in rounding."""
    part, swing = xy / xx, xs / xx
    rest_yy, rest_ys = yy - part * xy, ys - part * xs
    right, turn = wrench.y - part * wrench.x, rest_ys / rest_yy
    rest_ss, spin = ss - swing * xs - turn * rest_ys, 0.0
    if rest_ss > 0.0:
        spin = (wrench.spin - swing * wrench.x - turn * right) / rest_ss
    y = right / rest_yy - turn * spin
    return Vector(wrench.x / xx - part * y - swing * spin, y, spin)


def _power(wrench: Vector, twist: Vector) -> float:
    return wrench.x * twist.x + wrench.y * twist.y + wrench.spin * twist.spin


def _size_of(vector: Vector) -> float:
    return fabs(vector.x) + fabs(vector.y) + fabs(vector.spin)


def _step_from(twist: Vector, step: Vector, part: float) -> Vector:
    return Vector(
        twist.x + part * step.x, twist.y + part * step.y, twist.spin + part * step.spin
    )  # fmt: skip


def _net_resistance(effects: Effects, loads: Loads, twist: Vector, two: float) -> Resistance:
    """`Resistance` minus all loads, with a factor for the effects of degree 2."""
    scaled, more = scale_effects(effects, 1.0, two), loads.more
    total = resistance(scaled, twist.x, twist.y, twist.spin, EPSILON * _size_of(twist))
    return Resistance(
        f_x=total.f_x - more.x,
        f_y=total.f_y - more.y,
        torque=total.torque - more.spin,
        xx=total.xx,
        xy=total.xy,
        yy=total.yy,
        xs=total.xs,
        ys=total.ys,
        ss=total.ss,
        limit=total.limit,
        point=total.point,
        terms=total.terms,
    )


def _potential_value(effects: Effects, loads: Loads, twist: Vector, square: bool) -> float:
    """The potential, or half the square of D minus the power of the loads."""
    total, load = _net_resistance(effects, loads, twist, 0.0 if square else 1.0), loads.total
    power = _power(Vector(total.f_x, total.f_y, total.torque), twist)
    if not square:
        return power - kinetic_energy(effects, twist.x, twist.y, twist.spin)
    wrench = Vector(total.f_x + load.x, total.f_y + load.y, total.torque + load.spin)
    held = _power(wrench, twist)
    return power + held * (held / 2.0 - 1.0)


def _potential_gradient(effects: Effects, loads: Loads, twist: Vector, square: bool) -> Resistance:
    """Derivatives of `_potential_value`; `limit` is the largest force that a point at rest can balance."""
    total, load = _net_resistance(effects, loads, twist, 0.0 if square else 1.0), loads.total
    if not square:
        return total
    f_x, f_y, torque = total.f_x + load.x, total.f_y + load.y, total.torque + load.spin
    held = _power(Vector(f_x, f_y, torque), twist)
    xx, yy = f_x * f_x + held * total.xx, f_y * f_y + held * total.yy
    ss = torque * torque + held * total.ss
    # This adds stiffness in directions in which the square of D is flat.
    stiff = SHARE * (xx + yy + ss)
    return Resistance(
        f_x=held * f_x - load.x,
        f_y=held * f_y - load.y,
        torque=held * torque - load.spin,
        xx=xx + stiff,
        xy=f_x * f_y + held * total.xy,
        yy=yy + stiff,
        xs=f_x * torque + held * total.xs,
        ys=f_y * torque + held * total.ys,
        ss=ss + stiff,
        limit=held * total.limit,
        point=total.point,
        terms=total.terms,
    )


def _minimum_on_ray(effects: Effects, loads: Loads, ray: Vector, square: bool) -> Level:
    """The twist of minimum value along a ray or along the opposite ray."""
    rest, load, power = Vector(0.0, 0.0, 0.0), loads.total, _power(loads.total, ray)
    total = _net_resistance(effects, loads, ray, 0.0)
    wrench = Vector(total.f_x + load.x, total.f_y + load.y, total.torque + load.spin)
    held = _power(wrench, ray)
    if square:
        if held == 0.0:
            return Level(rest, 0.0)
        part = power / held
        return Level(_step_from(rest, ray, power / (held * held)), -(part * part) / 2.0)
    lack = fabs(power) - held
    part = max(lack, 0.0) / (2.0 * kinetic_energy(effects, ray.x, ray.y, ray.spin))
    twist = _step_from(rest, ray, copysign(part, power))
    # A load that exceeds friction by a smaller fraction counts as held.
    return Level(twist, -lack * part / 2.0 if lack > SHARE * fabs(power) else 0.0)


def _lowest_start(effects: Effects, loads: Loads, ray: Vector, square: bool) -> Level:
    """The twist of minimum value along a ray or about any support point."""
    lowest = _minimum_on_ray(effects, loads, ray, square)
    for i in range(effects.feet):
        foot = foot_position(effects, i)
        level = _minimum_on_ray(effects, loads, Vector(foot.y, -foot.x, 1.0), square)
        if level.value < lowest.value:
            lowest = level
    return lowest


def _descend(effects: Effects, loads: Loads, twist: Vector, square: bool) -> Vector:
    """The twist of minimum value, from a start no higher than the minimum about any support point."""
    for _ in range(DESCENTS):
        value = _potential_value(effects, loads, twist, square)
        total = _potential_gradient(effects, loads, twist, square)
        if total.limit > 0.0:
            force = sqrt(total.f_x * total.f_x + total.f_y * total.f_y)
            if force <= total.limit:
                return twist
            step, slope = Vector(-total.f_x / force, -total.f_y / force, 0.0), total.limit - force
        else:
            wrench = Vector(-total.f_x, -total.f_y, -total.torque)
            step = _solve_symmetric(
                total.xx, total.xy, total.yy, total.xs, total.ys, total.ss, wrench
            )
            slope = -_power(wrench, step)
        rounding = RESOLUTION * _size_of(loads.total) * _size_of(twist)
        part = _part_of_step(effects, loads, twist, step, value + rounding, slope, square)
        twist = _step_from(twist, step, part)
        if -slope <= rounding or part == 0.0:
            break
    return twist if square else _polish_twist(effects, loads, twist)


def _polish_twist(effects: Effects, loads: Loads, twist: Vector) -> Vector:
    """The twist after Newton steps that lower the net wrench, whose last digits the value does not show."""
    best, least = twist, INFINITY
    for _ in range(POLISHES_OF_TWIST):
        total = _potential_gradient(effects, loads, twist, False)
        wrench = Vector(-total.f_x, -total.f_y, -total.torque)
        size = _size_of(wrench)
        if total.limit > 0.0 or not size < least:
            break
        best, least = twist, size
        if size <= SHARE * _size_of(loads.total):
            break
        step = _solve_symmetric(total.xx, total.xy, total.yy, total.xs, total.ys, total.ss, wrench)
        twist = _step_from(twist, step, 1.0)
    return best


def _part_of_step(
    effects: Effects, loads: Loads, twist: Vector, step: Vector,
    value: float, slope: float, square: bool,
) -> float:  # fmt: skip
    """Fraction of a step at which the value is nearly minimal; the full step if it is good enough."""
    low, high, part = 0.0, INFINITY, 1.0
    if not slope < 0.0:  # from rounding
        return part
    for _ in range(TRIALS):
        trial = _step_from(twist, step, part)
        reached = _potential_value(effects, loads, trial, square)
        total = _potential_gradient(effects, loads, trial, square)
        trial_slope = _power(Vector(total.f_x, total.f_y, total.torque), step)
        if fabs(trial_slope) <= -SLOPE_LEFT * slope and reached <= value:
            return part
        if trial_slope < 0.0:
            low = part
        else:
            high = part
        if high - low <= STEP_LEFT * low:
            return low
        part = 4.0 * part if high == INFINITY else (low + high) / 2.0
    return low
