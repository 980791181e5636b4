"""Motions of a contact that sticks, of effects that see only the centre's speed and the rotation.

Of all twists with one motion of the contact the one of least potential is taken: the torque about the
contact, the potential's slope, increases with the rotation.
"""

from __future__ import annotations

from math import copysign, sqrt
from typing import Any, NamedTuple

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.effects.base import leverages_alone, response, rough_leverage
from planar_pushing.mechanics.numerics.root import EQUATIONS, root
from planar_pushing.mechanics.plane import moment_arm
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


@compiled
def _rough_change(of, leverage):
    """What the rough h / k of the friction, in a motion with another h / k, differs from that one."""
    across, turn = leverage * of.aside, of.length * of.aside
    ahead = (of.length * of.length + leverage) * of.along
    return rough_leverage(of.effects[0], turn * turn, ahead * ahead + across * across) - leverage


@compiled
def _first_guess(of, middle):
    """A step to the rough h / k, and a secant step; friction and inertia begin in the middle."""
    if len(of.effects) > 1:
        return middle
    change = _rough_change(of, middle)
    near = middle + change
    left = _rough_change(of, near)
    return near + left * change / (change - left) if left != change else near


@compiled
def _leverage(effects, length, along, aside):
    """H / k of the motion that sticks."""
    one = leverages_alone(effects[0])
    other = leverages_alone(effects[-1])
    low, high = min(one[0], other[0]), max(one[1], other[1])
    if low == high:
        return low
    torque = ContactTorque(effects, length, along, aside)
    start = min(max(_first_guess(torque, sqrt(low * high)), low), high)
    return root(torque, low, high, start)[0]


@compiled
def stick(effects, own, towards):
    """As `base.stick`."""
    along, aside, length = towards.along, towards.aside, own.length
    leverage = _leverage(effects, length, along, abs(aside))
    total = length * length + leverage
    carried = leverage / total
    return _sustained(effects, own, along, carried * aside, length * (aside / total), carried)


@compiled
def _sustained(effects, own, along, aside, spin, blur):
    """The motion whose centre moves by (along, aside) in the rod's axes, with its force."""
    speed = sqrt(along * along + aside * aside)
    part = response(effects, speed, spin)[0] / speed
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
    return _sustained(
        effects, own, speed * edge.along, speed * edge.aside, copysign(spin, edge.aside), 0.0
    )
