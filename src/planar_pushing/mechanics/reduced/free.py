"""The motion of a slider that nothing pushes: rest, or where loads take it.

It is the minimum of the potential over all twists, which is strictly convex with inertia. It is rest, a pivot
about a support point whose friction holds what the others leave, or a smooth minimum: one closed form for
each point, then Newton's method, whose steps end where the potential is least along them.
"""

from __future__ import annotations

from math import inf
from typing import NamedTuple

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.effects.base import (
    count_points,
    energy,
    moment,
    place,
    pull,
    resistance,
)
from planar_pushing.mechanics.numerics.root import is_last
from planar_pushing.mechanics.reduced.psi import contact_at, turning

#: Momentum over load of a slider that rests.
SLOWEST = 1e-13
#: Newton steps at most, and trials along one.
STEPS, TRIALS = 100, 100
#: A step ends where the slope of the potential is this part of that at its start, or where the place of the
#: minimum is known to this part of the step.
SLOPE, NARROW = 0.3, 1e-9
#: Part of a twist that leaves a support point at which the potential has no gradient.
ASIDE = 1e-3


class Free(NamedTuple):
    """Twist of the origin, body frame."""

    x: float
    y: float
    spin: float


REST = Free(0.0, 0.0, 0.0)


@compiled
def _solved(xx, xy, yy, xs, ys, ss, f_x, f_y, torque):
    """The twist of a wrench by a positive matrix."""
    part, swing = xy / xx, xs / xx
    own, aside = yy - part * xy, ys - part * xs
    turn = aside / own
    right_y = f_y - part * f_x
    spin = (torque - swing * f_x - turn * right_y) / (ss - swing * xs - turn * aside)
    y = right_y / own - turn * spin
    return Free(f_x / xx - part * y - swing * spin, y, spin)


@compiled
def free(effects):
    """The twist at which effects exert no wrench; zero where friction holds the loads."""
    x, y, torque = pull(effects)
    mass = moment(effects, inf, 0.0, 0.0)
    if mass.mass == 0.0 or (x == 0.0 and y == 0.0 and torque == 0.0):
        return REST
    for i in range(count_points(effects)):
        p_x, p_y = place(effects, i)
        spin, now = turning(effects, contact_at(p_x, p_y))
        if spin != 0.0 and now.f_x * now.f_x + now.f_y * now.f_y <= now.most * now.most:
            return Free(spin * p_y, -spin * p_x, spin)
    return _smooth(
        effects,
        _solved(mass.mass, 0.0, mass.mass, -mass.y, mass.x, mass.whole, x, y, torque),
        abs(x) + abs(y) + abs(torque),
    )


@compiled
def _smooth(effects, at, load):
    """The minimum of the potential where it has a gradient, or rest, from a first twist."""
    last = inf
    for _ in range(STEPS):
        size = abs(at.x) + abs(at.y) + abs(at.spin)
        if 2.0 * energy(effects, at.x, at.y, at.spin) <= SLOWEST * load * size:
            return REST
        now = resistance(effects, at.x, at.y, at.spin, 0.0)
        if now.most > 0.0:
            at = Free(at.x + ASIDE * size, at.y, at.spin)
            continue
        step = _solved(
            now.xx, now.xy, now.yy, now.xs, now.ys, now.ss, -now.f_x, -now.f_y, -now.torque
        )
        part = _least_along(effects, at, step, _slope(now, step))
        at = Free(at.x + part * step.x, at.y + part * step.y, at.spin + part * step.spin)
        change = (abs(step.x) + abs(step.y) + abs(step.spin)) / size
        if is_last(change, last):
            return at
        last = change if part == 1.0 else inf
    return at


@compiled
def _slope(now, step):
    """Derivative of the potential along a step."""
    return now.f_x * step.x + now.f_y * step.y + now.torque * step.spin


@compiled
def _least_along(effects, at, step, start):
    """Part of a step after which the potential is nearly least: the whole step where that will do."""
    low, high, part = 0.0, inf, 1.0
    if not start < 0.0:  # by rounding
        return part
    for _ in range(TRIALS):
        x, y, spin = at.x + part * step.x, at.y + part * step.y, at.spin + part * step.spin
        slope = 0.0
        if x != 0.0 or y != 0.0 or spin != 0.0:
            slope = _slope(resistance(effects, x, y, spin, 0.0), step)
        if abs(slope) <= -SLOPE * start or high - low <= NARROW * part:
            break
        if slope < 0.0:
            low = part
        else:
            high = part
        part = 4.0 * part if high == inf else (low + high) / 2.0
    return part
