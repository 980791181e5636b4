"""Motions of a contact that sticks, of effects that see only the centre's speed and the rotation.

Of all twists with one motion of the contact the one of least potential is taken: the torque about the
contact, the potential's slope, increases with the rotation.
"""

from __future__ import annotations

from collections.abc import Callable
from math import copysign, sqrt
from typing import Any, NamedTuple

from planar_pushing.mechanics.compiled import compiled, generic
from planar_pushing.mechanics.effects.base import leverages_alone, response
from planar_pushing.mechanics.effects.inertia import Mass
from planar_pushing.mechanics.effects.support_friction import RingSupport
from planar_pushing.mechanics.numerics.root import EQUATIONS, root
from planar_pushing.mechanics.plane import moment_arm
from planar_pushing.mechanics.reduced import sticking_ring
from planar_pushing.mechanics.reduced.isotropic import SpinOfSpeed, spin_ratios


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
    free_along, free_aside : float
        What the force is known up to, times -1 to 1: zero but for a pivot about a point of the support.
    pivot : int
        Number of that point, -1 without one.
    """

    v_x: float
    v_y: float
    spin: float
    f_x: float
    f_y: float
    along: float
    aside: float
    blur: float
    free_along: float
    free_aside: float
    pivot: int


class ContactTorque(NamedTuple):
    """Torque about the contact that a sticking motion lacks, over its h / k; `aside` >= 0.

    The root has narrow bounds whatever the length of the rod, and neither part of the motion across the
    rod is a difference.
    """

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


class SpeedOfSpin(NamedTuple):
    """Torque about the contact that a motion with a given spin lacks, over the centre's speed."""

    effects: tuple[Any, ...]
    arm: float
    spin: float


@compiled
def _speed_of_spin(of, speed):
    force, torque, vv, vs, _ = response(of.effects, speed, of.spin)
    return of.arm * force - torque, of.arm * vv - vs


EQUATIONS.update({ContactTorque: _contact_torque, SpeedOfSpin: _speed_of_spin})


@generic
def _held(kinds: Any) -> Callable[..., Any]:
    """The motion that sticks: effects, length, and the contact's motion along the rod and aside, >= 0.

    Returns
    -------
    carried, swing, part : float
        The centre's motion aside and the rotation, both over the contact's motion aside; and the force over
        the centre's speed.
    """
    alone = {(RingSupport,): _held_ring, (Mass,): _held_mass}
    return alone.get(kinds, _held_by_both)


@compiled
def _held_ring(effects, length, along, aside):
    carried, swing, part = sticking_ring.held(length, along, aside)
    return carried, swing, effects[0].weight * part


@compiled
def _held_mass(effects, length, along, aside):
    leverage = leverages_alone(effects[0])[0]
    total = length * length + leverage
    return leverage / total, length / total, response(effects, 1.0, 0.0)[0]


@compiled
def _held_by_both(effects, length, along, aside):
    one, other = leverages_alone(effects[0]), leverages_alone(effects[1])
    low, high = min(one[0], other[0]), max(one[1], other[1])
    torque = ContactTorque(effects, length, along, aside)
    leverage = root(torque, low, high, sqrt(low * high))[0]
    total = length * length + leverage
    carried, swing = leverage / total, length / total
    across = carried * aside
    speed = sqrt(along * along + across * across)
    return carried, swing, response(effects, speed, swing * aside)[0] / speed


@compiled
def stick(effects, own, towards):
    """As `base.stick`."""
    along, aside = towards.along, towards.aside
    carried, swing, part = _held(effects, own.length, along, abs(aside))
    return _sustained(own, along, carried * aside, swing * aside, part, carried)


@compiled
def _sustained(own, along, aside, spin, part, blur):
    """The motion whose centre moves by (along, aside) in the rod's axes, with its force over its speed."""
    v_x, v_y = along * own.x + aside * own.y, along * own.y - aside * own.x
    return Sustained(v_x, v_y, spin, part * v_x, part * v_y, along, aside, blur, 0.0, 0.0, -1)


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
    part = response(effects, speed, spin)[0] / speed
    along, aside = speed * edge.along, speed * edge.aside
    return _sustained(own, along, aside, copysign(spin, edge.aside), part, 0.0)
