"""The reduced potential of effects that see only the centre's speed and the rotation.

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
from math import copysign, sqrt
from typing import Any, NamedTuple

from planar_pushing.mechanics.angles import RESOLUTION
from planar_pushing.mechanics.compiled import compiled, generic
from planar_pushing.mechanics.effects.base import (
    leverages_alone,
    response,
    spin_ratio_alone,
)
from planar_pushing.mechanics.effects.inertia import Mass
from planar_pushing.mechanics.numerics.root import EQUATIONS, root
from planar_pushing.mechanics.plane import contact_motion_angle, moment_arm

#: Speed that stands for one below the smallest double, so that its force has a direction.
SLOWEST = 1e-300


class Sustained(NamedTuple):
    """A motion of the slider, and the force through the contact that sustains it.

    Attributes
    ----------
    v_x, v_y, spin : float
        Twist at the ring centre, the rotation as R omega.
    f_x, f_y : float
        Force of the pusher.
    along, aside : float
        A vector parallel to the force, along the rod and along its right-hand normal.
    blur : float
        Part of the rounding of the pusher's direction that `aside` carries; `along` carries all of it.
    """

    v_x: float
    v_y: float
    spin: float
    f_x: float
    f_y: float
    along: float
    aside: float
    blur: float


class SpinOfSpeed(NamedTuple):
    """Torque about the contact that a motion with a given centre speed leaves, over the spin."""

    effects: tuple[Any, ...]
    arm: float
    speed: float


@compiled
def _spin_of_speed(of, spin):
    force, torque, _, vs, ss = response(of.effects, of.speed, spin)
    return torque - of.arm * force, ss - of.arm * vs


EQUATIONS[SpinOfSpeed] = _spin_of_speed


@generic
def spin_ratios(kinds: Any) -> Callable[..., Any]:
    """Ends of the spin ratios under a force of a moment arm >= 0, over all magnitudes of the motion."""
    return _spin_ratios_of_one if len(kinds) == 1 else _spin_ratios_of_all


@compiled
def _spin_ratios_of_one(effects, arm):
    ratio = spin_ratio_alone(effects[0], arm)
    return ratio, ratio


@compiled
def _spin_ratios_of_all(effects, arm):
    low, high = spin_ratios(effects[:1], arm)
    other_low, other_high = spin_ratios(effects[1:], arm)
    return min(low, other_low), max(high, other_high)


@compiled
def spin_ratio(effects, arm):
    """Spin ratio under a force of a moment arm >= 0, the centre at unit speed."""
    low, high = spin_ratios(effects, arm)
    if low == high:
        return low
    return root(SpinOfSpeed(effects, arm, 1.0), low, high, sqrt(low * high))[0]


@compiled
def signed_spin_ratio(effects, own, force):
    """Spin ratio under a force in a direction."""
    arm = moment_arm(own, force)
    return copysign(spin_ratio(effects, abs(arm)), arm)


@compiled
def motion_angle(effects, own, force):
    """As `base.motion_angle`."""
    return contact_motion_angle(own, force, signed_spin_ratio(effects, own, force))


@compiled
def edge_motion(effects, own, edge):
    """As `base.edge_motion`."""
    ratio = signed_spin_ratio(effects, own, edge)
    speed, spin = (1.0, ratio) if abs(ratio) <= 1.0 else (1.0 / abs(ratio), copysign(1.0, ratio))
    force = response(effects, speed, spin)[0]
    return speed * edge.x, speed * edge.y, spin, force * edge.x, force * edge.y


@compiled
def motion_angles(effects, own, force):
    """As `base.motion_angles`."""
    arm = moment_arm(own, force)
    low, high = spin_ratios(effects, abs(arm))
    one = contact_motion_angle(own, force, copysign(low, arm))
    other = contact_motion_angle(own, force, copysign(high, arm)) if high > low else one
    return min(one, other), max(one, other)


@generic
def _leverages(kinds: Any) -> Callable[..., Any]:
    """Least and greatest moment arm per spin ratio, ``h / k``, of any motion."""
    return _leverages_of_one if len(kinds) == 1 else _leverages_of_all


@compiled
def _leverages_of_one(effects):
    return leverages_alone(effects[0])


@compiled
def _leverages_of_all(effects):
    low, high = _leverages(effects[:1])
    other_low, other_high = _leverages(effects[1:])
    return min(low, other_low), max(high, other_high)


class ContactTorque(NamedTuple):
    """Torque about the contact that a sticking motion lacks, over its h / k."""

    effects: tuple[Any, ...]
    length: float
    along: float
    aside: float


@compiled
def _contact_torque(of, leverage):
    effects, length, along, aside = of
    total = length * length + leverage
    across, spin = leverage / total * aside, length * (aside / total)
    speed = sqrt(along * along + across * across)
    force, torque, vv, vs, ss = response(effects, speed, spin)
    sine, cosine = across / speed, along / speed
    turn, slow = length * spin / total, -spin / total  # of `across` and of the spin over h / k
    change = length * (
        (vv * sine * turn + vs * slow) * sine + force * turn * cosine * cosine / speed
    )
    return length * force * sine - torque, change - (vs * sine * turn + ss * slow)


EQUATIONS[ContactTorque] = _contact_torque


@compiled
def _leverage(effects, length, along, aside):
    """H / k of the motion that sticks: of all twists with this contact motion that of least potential.

    The torque about the contact, the potential's slope, increases with the rotation. The root is sought
    in h / k, which has narrow bounds whatever the length of the rod, and from which neither part of the
    motion across the rod is a difference. `aside` >= 0.
    """
    low, high = _leverages(effects)
    if low == high:
        return low
    return root(ContactTorque(effects, length, along, aside), low, high, sqrt(low * high))[0]


@compiled
def stick(effects, own, towards):
    """As `base.stick`."""
    along, aside, length = towards.along, towards.aside, own.length
    leverage = _leverage(effects, length, along, abs(aside))
    total = length * length + leverage
    carried = leverage / total
    return sustained(effects, own, along, carried * aside, length * (aside / total), carried)


@compiled
def sustained(effects, own, along, aside, spin, blur):
    """The motion whose centre moves by (along, aside) in the rod's axes, with its force."""
    speed = sqrt(along * along + aside * aside)
    part = response(effects, speed, spin)[0] / speed
    v_x, v_y = along * own.x + aside * own.y, along * own.y - aside * own.x
    return Sustained(v_x, v_y, spin, part * v_x, part * v_y, along, aside, blur)


class SpeedOfSpin(NamedTuple):
    """Torque about the contact that a motion with a given spin lacks, over the centre's speed."""

    effects: tuple[Any, ...]
    arm: float
    spin: float


@compiled
def _speed_of_spin(of, speed):
    force, torque, vv, vs, _ = response(of.effects, speed, of.spin)
    return of.arm * force - torque, of.arm * vv - vs


EQUATIONS[SpeedOfSpin] = _speed_of_spin


@compiled
def held_on_edge(effects, own, edge, moved):
    """As `base.held_on_edge`."""
    arm, spin = abs(moment_arm(own, edge)), abs(moved.spin)
    low, high = spin_ratios(effects, arm)
    speed = moved.along * edge.along + moved.aside * edge.aside
    if own.length * spin > speed:
        at_spin = SpeedOfSpin(effects, arm, spin)
        speed = root(at_spin, spin / high, spin / low, spin / sqrt(low * high))[0]
    else:
        at_speed = SpinOfSpeed(effects, arm, speed)
        spin = root(at_speed, speed * low, speed * high, speed * sqrt(low * high))[0]
    return sustained(
        effects, own, speed * edge.along, speed * edge.aside, copysign(spin, edge.aside), 0.0
    )


@compiled
def without_noise(part, other):
    """Difference of two numbers, zero where nothing but rounding is left of it."""
    difference = part - other
    return 0.0 if abs(difference) <= RESOLUTION * (abs(part) + abs(other)) else difference


@compiled
def slip(effects, edge, speed, ratio, found):
    """Write down a motion under a force on an edge: v_x, v_y, R omega, f_x, f_y."""
    pace = max(speed, SLOWEST)
    force = response(effects, pace, ratio * pace)[0]
    found[0], found[1], found[2] = speed * edge.x, speed * edge.y, speed * ratio
    found[3], found[4] = force * edge.x, force * edge.y


@compiled
def steady_slips(effects, own, edge, normal, found):
    """The motion under one effect keeps its direction, so there is one at most."""
    ratio = signed_spin_ratio(effects, own, edge)
    advance = without_noise(edge.y, own.length * own.x * ratio)
    if not ((normal > 0.0 and advance > 0.0) or (normal < 0.0 and advance < 0.0)):
        return 0
    slip(effects, edge, normal / advance, ratio, found[0])
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


EQUATIONS[CurveImbalance] = _curve_imbalance


@generic
def _curve_spin_ratio(kinds: Any) -> Callable[..., Any]:
    """Spin ratio on the limit curve under a force of a moment arm >= 0."""
    return spin_ratio if len(kinds) == 1 else _curve_spin_ratio_of_both


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
