"""The motion of a slider without a pusher: rest, or a motion caused by loads.

It is the minimum of the total potential over all twists, which is strictly convex with inertia. The
potential of friction has kinks: at rest, and at rotations about each support point, among which the minimum
has a closed form. Newton's method with descent steps starts from the lowest of these and therefore meets no
kink.

If no start is below rest, friction may hold the loads. Half the square of friction's potential D, minus the
power of the loads, has no kink at rest. Its minimum is at the twist whose friction is proportional to the
loads.
"""

from __future__ import annotations

from math import copysign, inf, sqrt
from typing import NamedTuple

from planar_pushing.simulation.legacy.base import (
    Resistance,
    count_points,
    energy,
    moment,
    place,
    pull,
    resistance,
)
from planar_pushing.simulation.legacy.compiled import compiled
from planar_pushing.simulation.legacy.root import EPSILON

#: Maximum number of Newton steps, and of trials along one.
STEPS, TRIALS = 60, 120
#: A step ends where the slope of the potential has fallen to this fraction of that at the start, or where
#: the minimum is known to this fraction of the step.
SLOPE, NARROW = 0.3, 1e-6
#: Rounding error of a value, relative to the power of the loads.
ROUNDING = 8.0 * EPSILON
#: Largest ratio of momentum to load of a slider that counts as held by friction.
SLOWEST = 1e-13
#: Factor of a twist that makes its inertia negligible relative to friction.
SLOW = 1e-100
#: Stiffness added to directions in which the square of D is flat, relative to the total stiffness.
FLAT = 1e-13


class Free(NamedTuple):
    """Twist of the origin, in the body frame."""

    x: float
    y: float
    spin: float


REST = Free(0.0, 0.0, 0.0)


@compiled
def free(effects):
    """The twist without a net wrench of the effects; zero if friction holds the loads."""
    x, y, torque = pull(effects)
    load, mass = Free(x, y, torque), moment(effects, inf, 0.0, 0.0)
    if mass.mass == 0.0 or (x == 0.0 and y == 0.0 and torque == 0.0):
        return REST
    fall = _solved(mass.mass, 0.0, mass.mass, -mass.y, mass.x, mass.whole, load)
    start, value = _lowest(effects, load, fall, False)
    if not value < 0.0:
        start, _ = _lowest(effects, load, fall, True)
        start, value = _on_ray(effects, load, _least(effects, load, start, True), False)
    return _least(effects, load, start, False) if value < 0.0 else REST


@compiled
def _solved(xx, xy, yy, xs, ys, ss, wrench):
    """The twist that a positive-definite matrix maps to a wrench."""
    part, swing = xy / xx, xs / xx
    own, aside = yy - part * xy, ys - part * xs
    right, turn = wrench.y - part * wrench.x, aside / own
    spin = (wrench.spin - swing * wrench.x - turn * right) / (ss - swing * xs - turn * aside)
    y = right / own - turn * spin
    return Free(wrench.x / xx - part * y - swing * spin, y, spin)


@compiled
def _power(one, other):
    return one.x * other.x + one.y * other.y + one.spin * other.spin


@compiled
def _size(at):
    return abs(at.x) + abs(at.y) + abs(at.spin)


@compiled
def _moved(at, step, part):
    return Free(at.x + part * step.x, at.y + part * step.y, at.spin + part * step.spin)


@compiled
def _local(effects, load, at, square):
    """Value and derivatives of the potential, or of half the square of D minus the power of the loads.

    The derivatives are a `Resistance`; its `most` is the largest force that a support point at rest takes.
    """
    slow = SLOW if square else 1.0
    x, y, spin = slow * at.x, slow * at.y, slow * at.spin
    now = resistance(effects, x, y, spin, EPSILON * slow * _size(at))
    f_x, f_y, torque, b = now.f_x, now.f_y, now.torque, slow
    power = _power(at, Free(f_x, f_y, torque))
    if not square:
        return power - energy(effects, x, y, spin), now
    f_x, f_y, torque = f_x + load.x, f_y + load.y, torque + load.spin
    whole = _power(at, Free(f_x, f_y, torque))
    b *= whole
    xx, yy, ss = f_x * f_x + b * now.xx, f_y * f_y + b * now.yy, torque * torque + b * now.ss
    least = FLAT * (xx + yy + ss)
    return power + whole * (whole / 2.0 - 1.0), Resistance(
        whole * f_x - load.x, whole * f_y - load.y, whole * torque - load.spin,
        xx + least, f_x * f_y + b * now.xy, yy + least, f_x * torque + b * now.xs,
        f_y * torque + b * now.ys, ss + least, whole * now.most, now.point, now.gross,
    )  # fmt: skip


@compiled
def _on_ray(effects, load, ray, square):
    """The twist of minimum value along a ray, in either sense, and this value."""
    power, size = _power(ray, load), _size(ray)
    x, y, spin = SLOW * ray.x, SLOW * ray.y, SLOW * ray.spin
    now = resistance(effects, x, y, spin, EPSILON * SLOW * size)
    held = _power(ray, Free(now.f_x + load.x, now.f_y + load.y, now.torque + load.spin))
    if square:
        return _moved(REST, ray, power / held**2), -((power / held) ** 2) / 2.0
    lack = abs(power) - held
    part = max(lack, 0.0) / (2.0 * energy(effects, ray.x, ray.y, ray.spin))
    falls = lack > SLOWEST * abs(power)
    return _moved(REST, ray, copysign(part, power)), -lack * part / 2.0 if falls else 0.0


@compiled
def _lowest(effects, load, ray, square):
    """The twist of minimum value along a ray or about any support point, and this value."""
    found, least = _on_ray(effects, load, ray, square)
    for i in range(count_points(effects)):
        x, y = place(effects, i)
        at, value = _on_ray(effects, load, Free(y, -x, 1.0), square)
        if value < least:
            found, least = at, value
    return found, least


@compiled
def _least(effects, load, at, square):
    """The twist of minimum value, from a start not above the minimum about any support point."""
    for _ in range(STEPS):
        value, now = _local(effects, load, at, square)
        if now.most > 0.0:
            force = sqrt(now.f_x * now.f_x + now.f_y * now.f_y)
            if force <= now.most:
                return at
            step, slope = Free(-now.f_x / force, -now.f_y / force, 0.0), now.most - force
        else:
            wrench = Free(-now.f_x, -now.f_y, -now.torque)
            step = _solved(now.xx, now.xy, now.yy, now.xs, now.ys, now.ss, wrench)
            slope = -_power(wrench, step)
        rounding = ROUNDING * _size(load) * _size(at)
        part = _descent(effects, load, at, step, value + rounding, slope, square)
        at = _moved(at, step, part)
        if -slope <= rounding or part == 0.0:
            break
    return at


@compiled
def _descent(effects, load, at, step, value, slope, square):
    """Fraction of a step at which the value is nearly minimal; the whole step if it is good enough."""
    low, high, part = 0.0, inf, 1.0
    if not slope < 0.0:  # from rounding
        return part
    for _ in range(TRIALS):
        there = _moved(at, step, part)
        reached, now = _local(effects, load, there, square)
        rise = _power(Free(now.f_x, now.f_y, now.torque), step)
        if abs(rise) <= -SLOPE * slope and reached <= value:
            return part
        if rise < 0.0:
            low = part
        else:
            high = part
        if high - low <= NARROW * low:
            return low
        part = 4.0 * part if high == inf else (low + high) / 2.0
    return low
