"""Motions under a line of force, of effects that see only the centre's speed and the rotation.

Their force lies along the centre's motion, so one relation, moment arm <-> spin ratio, carries everything
(Eqs. 7 and 10, Sec. 4)::

    friction   h = t(k) / f(k)
    inertia    h = rho^2 k
    both       h (f + s) = t + s rho^2 k,  s the ratio of the two forces in translation

Lengths are in radii. `effects` is a tuple of one effect, whose motion keeps its direction as it grows, or
of friction and inertia in this order.
"""

from __future__ import annotations

from collections.abc import Callable
from math import atan2, copysign, hypot, inf, sqrt
from typing import Any, NamedTuple

from planar_pushing.mechanics.angles import RESOLUTION
from planar_pushing.mechanics.compiled import compiled, generic
from planar_pushing.mechanics.effects.base import response, spin_ratio_alone
from planar_pushing.mechanics.effects.inertia import Mass
from planar_pushing.mechanics.numerics.root import EQUATIONS, root
from planar_pushing.mechanics.plane import Rod, contact_motion_angle, moment_arm, motion_center

#: Speed that stands for one below the smallest double, so that its force has a direction.
SLOWEST = 1e-300


class SpinOfSpeed(NamedTuple):
    """Torque about the contact that a motion with a given centre speed leaves, over the spin."""

    effects: tuple[Any, ...]
    arm: float
    speed: float


@compiled
def _spin_of_speed(of, spin):
    force, torque, _, vs, ss = response(of.effects, of.speed, spin)
    return torque - of.arm * force, ss - of.arm * vs


class CurveImbalance(NamedTuple):
    """Torque about the contact on the limit curve over the spin ratio."""

    effects: tuple[Any, ...]
    arm: float


@compiled
def _curve_imbalance(of, k):
    arm, (mass, gyration) = of.arm, of.effects[1]
    speed = _curve_speed(of.effects, k)
    friction, slope = _spin_of_speed(SpinOfSpeed(of.effects[:1], arm, 1.0), k)
    lean = mass * gyration * speed * speed * speed * (1.0 + arm * k)
    return friction + mass * speed * (gyration * k - arm), slope + lean


EQUATIONS.update({SpinOfSpeed: _spin_of_speed, CurveImbalance: _curve_imbalance})


@compiled
def spin_ratios(effects, arm):
    """Ends of the spin ratios under a force of a moment arm >= 0, over all magnitudes of the motion."""
    one = spin_ratio_alone(effects[0], arm)
    other = spin_ratio_alone(effects[-1], arm) if len(effects) > 1 else one
    return min(one, other), max(one, other)


@compiled
def ratio_under(effects, arm):
    """Spin ratio under a force of a moment arm >= 0, the centre at unit speed."""
    low, high = spin_ratios(effects, arm)
    if low == high:
        return low
    return root(SpinOfSpeed(effects, arm, 1.0), low, high, sqrt(low * high))[0]


@compiled
def spin_ratio(effects, own, force):
    """As `base.spin_ratio`."""
    arm = moment_arm(own, force)
    return copysign(ratio_under(effects, abs(arm)), arm)


@compiled
def motion_angle(effects, own, force):
    """As `base.motion_angle`."""
    return contact_motion_angle(own, force, spin_ratio(effects, own, force))


@compiled
def motion_angles(effects, own, force):
    """As `base.motion_angles`."""
    arm = moment_arm(own, force)
    low, high = spin_ratios(effects, abs(arm))
    one = contact_motion_angle(own, force, copysign(low, arm))
    other = contact_motion_angle(own, force, copysign(high, arm)) if high > low else one
    return min(one, other), max(one, other)


@compiled
def edge_motion(effects, own, edge):
    """As `base.edge_motion`."""
    ratio = spin_ratio(effects, own, edge)
    speed, spin = (1.0, ratio) if abs(ratio) <= 1.0 else (1.0 / abs(ratio), copysign(1.0, ratio))
    force = response(effects, speed, spin)[0]
    return speed * edge.x, speed * edge.y, spin, force * edge.x, force * edge.y


@compiled
def without_noise(part, other):
    """Difference of two numbers, zero where nothing but rounding is left of it."""
    difference = part - other
    return 0.0 if abs(difference) <= RESOLUTION * (abs(part) + abs(other)) else difference


@compiled
def write_slip(effects, edge, speed, ratio, found):
    """Write down a motion under a force on an edge, as `base.slips` does."""
    pace = max(speed, SLOWEST)
    force = response(effects, pace, ratio * pace)[0]
    found[0], found[1], found[2] = speed * edge.x, speed * edge.y, speed * ratio
    found[3], found[4] = force * edge.x, force * edge.y
    found[5], found[6], found[7] = found[3], found[4], -1.0


@compiled
def steady_slips(effects, own, edge, normal, start, found):
    """As `base.slips`: the motion under one effect keeps its direction, so there is one at most."""
    ratio = spin_ratio(effects, own, edge)
    advance = without_noise(edge.y, own.length * own.x * ratio)
    if not ((normal > 0.0 and advance > 0.0) or (normal < 0.0 and advance < 0.0)):
        return 0
    write_slip(effects, edge, normal / advance, ratio, found[0])
    return 1


@generic
def _curve_speed(kinds: Any) -> Callable[..., Any]:
    """Centre speed on the limit curve: that of the kinetic energy of a unit translation, or any."""
    return _speed_of_unit_energy if Mass in kinds else _unit_speed


@compiled
def _unit_speed(effects, ratio):
    return 1.0


@compiled
def _speed_of_unit_energy(effects, ratio):
    return 1.0 / sqrt(1.0 + effects[-1].gyration * ratio * ratio)


@generic
def _curve_spin_ratio(kinds: Any) -> Callable[..., Any]:
    """Spin ratio on the limit curve under a force of a moment arm >= 0."""
    return ratio_under if len(kinds) == 1 else _curve_spin_ratio_of_both


@compiled
def _curve_spin_ratio_of_both(effects, arm):
    low, high = spin_ratios(effects, arm)
    return root(CurveImbalance(effects, arm), low, high, sqrt(low * high))[0]


@compiled
def limit_motion(effects, own, force):
    """As `base.limit_motion`."""
    arm = moment_arm(own, force)
    ratio = copysign(_curve_spin_ratio(effects, abs(arm)), arm)
    speed = _curve_speed(effects, ratio)
    magnitude = response(effects, speed, speed * ratio)[0]
    return magnitude, ratio, contact_motion_angle(own, force, ratio)


@compiled
def center_of(effects, own, motion):
    """As `base.center_of`."""
    speed, spin = hypot(motion[0], motion[1]), motion[2]
    ratio = spin / speed if speed > 0.0 else copysign(inf, spin) if spin != 0.0 else 0.0
    return motion_center(own, atan2(motion[4], motion[3]), ratio)


@compiled
def center_under(effects, own, force):
    """As `base.center_under`."""
    return motion_center(
        Rod(0.0, own.angle, own.x, own.y), force.angle, spin_ratio(effects, own, force)
    )
