"""Limit curve, motion angles and motion centres of any support: members of the functions of `base`."""

from __future__ import annotations

from collections.abc import Callable
from math import copysign, hypot, inf
from typing import Any, NamedTuple

from planar_pushing.mechanics.compiled import compiled, generic
from planar_pushing.mechanics.effects.any_mass import MassAt
from planar_pushing.mechanics.numerics.bracket import bracketed
from planar_pushing.mechanics.numerics.root import EQUATIONS, excess
from planar_pushing.mechanics.reduced.corners import corner_under
from planar_pushing.mechanics.reduced.pressed.magnitudes import angle_of, between
from planar_pushing.mechanics.reduced.pressed.motions import (
    RANGE,
    Amount,
    at_end,
    line_of,
    motion_of,
    pushed,
)


class Speed(NamedTuple):
    """Speed of the origin, less 1."""

    amount: Amount


class Energy(NamedTuple):
    """Kinetic energy over that of a unit translation, less 1."""

    amount: Amount


@compiled
def _speed(of, z):
    moved = motion_of(of.amount, z)
    return hypot(moved.v_x, moved.v_y) - 1.0, 0.0


@compiled
def _energy(of, z):
    mass, moved = of.amount.effects[-1], motion_of(of.amount, z)
    own = of.amount.own
    x, y = moved.v_x * own.x + moved.v_y * own.y, moved.v_y * own.x - moved.v_x * own.y
    x, y = x - moved.spin * mass.y, y + moved.spin * mass.x
    return x * x + y * y + mass.gyration * moved.spin * moved.spin - 1.0, 0.0


EQUATIONS.update({Speed: _speed, Energy: _energy})


@generic
def _typical(kinds: Any) -> Callable[..., Any]:
    """The motion under a force in a direction, the centre at unit speed: effects, own, force."""
    return _of_unit_part if len(kinds) == 1 else _of_unit_speed


@compiled
def _of_unit_part(effects, own, force):
    return pushed(effects, own, force, 1.0)


@compiled
def _of_unit_speed(effects, own, force):
    return _sought(Speed(Amount(effects, own, force)))


@compiled
def _ratio(moved):
    """R omega / v; infinite for a rotation about the slider's centre."""
    speed = hypot(moved.v_x, moved.v_y)
    return moved.spin / speed if speed > 0.0 else copysign(inf, moved.spin)


@compiled
def spin_ratio(effects, own, force):
    """As `base.spin_ratio`."""
    moved = _typical(effects, own, force)
    return _ratio(moved)


@compiled
def motion_angle(effects, own, force):
    """As `base.motion_angle`."""
    return angle_of(own, force, _typical(effects, own, force))


@compiled
def motion_angles(effects, own, force):
    """As `base.motion_angles`: of one effect, and of two those of each alone and of all between them."""
    if len(effects) > 1:
        low, high = _angles_alone(effects[:1], own, force)
        other = angle_of(own, force, pushed(effects[-1:], own, force, 1.0))
        # Of the motions of a corner, the slowest are the nearest to that of inertia.
        near = min(max(low, other), high)
        right, left = between(Amount(effects, own, force))
        return min(near, other, force.angle - right), max(near, other, force.angle + left)
    return _angles_alone(effects, own, force)


@compiled
def _angles_alone(effects, own, force):
    """Least and greatest angle under a force, of one effect."""
    corner = corner_under(effects, line_of(effects, own, force, 1.0))
    if corner.exists:
        one = angle_of(own, force, at_end(own, corner.first, 0.0, 0.0))
        other = angle_of(own, force, at_end(own, corner.last, 0.0, 0.0))
    else:
        one = angle_of(own, force, pushed(effects, own, force, 1.0))
        other = one
    return min(one, other), max(one, other)


@generic
def _on_curve(kinds: Any) -> Callable[..., Any]:
    """The motion of a force on the limit curve: effects, own, force."""
    return _of_unit_energy if MassAt in kinds else _of_unit_part


@compiled
def _of_unit_energy(effects, own, force):
    return _sought(Energy(Amount(effects, own, force)))


@compiled
def _sought(equation):
    """The motion at the root of an equation that increases with its part along the line of force."""
    width, at = 1.0, excess(equation, 0.0)[0]
    while True:
        other = -width if at > 0.0 else width
        beyond = excess(equation, other)[0]
        if (beyond > 0.0) != (at > 0.0) or width >= RANGE:
            ends = min(0.0, other), max(0.0, other), min(at, beyond), max(at, beyond)
            return motion_of(equation.amount, bracketed(equation, *ends))
        width *= 2.0


@compiled
def limit_motion(effects, own, force):
    """As `base.limit_motion`."""
    moved = _on_curve(effects, own, force)
    return hypot(moved.f_x, moved.f_y), _ratio(moved), angle_of(own, force, moved)


@compiled
def _center(moved_x, moved_y, spin):
    """Motion centre from the origin of a motion."""
    if spin != 0.0:
        return -moved_y / spin, moved_x / spin
    x = -copysign(inf, moved_y) if moved_y != 0.0 else 0.0
    return x, copysign(inf, moved_x) if moved_x != 0.0 or x == 0.0 else 0.0


@compiled
def center_of(effects, own, motion):
    """As `base.center_of`."""
    x, y = _center(motion[0], motion[1], motion[2])
    return x + own.length * own.x, y + own.length * own.y


@compiled
def center_under(effects, own, force):
    """As `base.center_under`."""
    moved = _typical(effects, own, force)
    return _center(moved.v_x, moved.v_y, moved.spin)
