"""The motion at an instant, and what does not depend on the system: rod, energy, friction."""

from __future__ import annotations

from collections.abc import Callable
from math import cos, nan, sin, sqrt
from typing import Any, NamedTuple

from planar_pushing.mechanics.compiled import compiled, generic
from planar_pushing.mechanics.effects.base import response
from planar_pushing.mechanics.effects.inertia import Mass
from planar_pushing.mechanics.plane import Direction, Rod


class Motion(NamedTuple):
    """The motion at an instant.

    Velocities of the contact over the fence, of the fence, and of the slider at the ring's centre, with the
    centre's speed; force of the fence on the slider; what friction on the support dissipates; and
    accelerations of the contact over the fence and of the rotation, zero without inertia. `lift` is the
    contact's normal acceleration without the force; without inertia, its normal velocity in a slip of unit
    size.
    """

    slip: float
    rise: float
    fence_x: float
    fence_y: float
    v_x: float
    v_y: float
    spin: float
    speed: float
    f_x: float
    f_y: float
    rubbed: float
    a_x: float
    a_y: float
    turn: float
    lift: float


@compiled
def at_rest(x, y, a_x, a_y):
    """The motion of a slider at rest over a fence with a velocity and an acceleration."""
    return Motion(-x, -y, x, y, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -a_x, -a_y, 0.0, 0.0)


@compiled
def rod_of(body, angle):
    """The rod at an angle."""
    return Rod(body.length, angle, cos(angle), sin(angle))


@compiled
def seen_from(own, x, y):
    """The direction of a unit vector, seen from a rod."""
    return Direction(nan, x, y, x * own.x + y * own.y, x * own.y - y * own.x)


@compiled
def size_of(v_x, v_y, spin):
    """Speed of the ring's centre and of the rotation together."""
    return sqrt(v_x * v_x + v_y * v_y) + abs(spin)


@compiled
def kinetic_energy(body, v_x, v_y, spin):
    """Of the slider."""
    return (body.mass * (v_x * v_x + v_y * v_y) + body.moment * spin * spin) / 2


@generic
def friction(kinds: Any) -> Callable[..., Any]:
    """Force and torque of friction on the support, zero at rest: effects, v_x, v_y, R omega."""
    return _no_friction if kinds == (Mass,) else _friction


@compiled
def _no_friction(effects, v_x, v_y, spin):
    return 0.0, 0.0, 0.0


@compiled
def _friction(effects, v_x, v_y, spin):
    speed = sqrt(v_x * v_x + v_y * v_y)
    if speed == 0.0 and spin == 0.0:
        return 0.0, 0.0, 0.0
    force, torque, _, _, _ = response(effects[:1], speed, spin)
    part = force / speed if speed > 0.0 else 0.0
    return part * v_x, part * v_y, torque
