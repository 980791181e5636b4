"""The motion at an instant, and what does not depend on the system: rod, energy, friction."""

from __future__ import annotations

from collections.abc import Callable
from math import cos, log, nan, sin, sqrt
from typing import Any, NamedTuple

from planar_pushing.mechanics.compiled import compiled, generic
from planar_pushing.mechanics.effects.any_mass import MassAt
from planar_pushing.mechanics.effects.any_support import Support
from planar_pushing.mechanics.effects.base import fastest, gradient, response, rough
from planar_pushing.mechanics.effects.inertia import Mass
from planar_pushing.mechanics.plane import Direction, Rod
from planar_pushing.mechanics.reduced.line_of_force import Line
from planar_pushing.mechanics.reduced.pivots import kink_under

#: The kinds of inertia.
MASSES = (Mass, MassAt)


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
def arm_of(body, own):
    """The line from the contact to the centre of mass, as a rod; without an offset it is the rod."""
    c, s = body.lean
    return Rod(body.reach, nan, own.x * c - own.y * s, own.x * s + own.y * c)


@compiled
def mass_offset(body, own):
    """From the slider's centre to the centre of mass."""
    x, y = body.center
    return x * own.x - y * own.y, x * own.y + y * own.x


@compiled
def seen_from(own, x, y):
    """The direction of a unit vector, seen from a rod."""
    return Direction(nan, x, y, x * own.x + y * own.y, x * own.y - y * own.x)


@compiled
def size_of(v_x, v_y, spin):
    """Speed of the ring's centre and of the rotation together."""
    return sqrt(v_x * v_x + v_y * v_y) + abs(spin)


@compiled
def kinetic_energy(body, x, y, v_x, v_y, spin):
    """Of the slider, whose centre moves by (v_x, v_y), and whose centre of mass is at (x, y) from it."""
    v_x, v_y = v_x - spin * y, v_y + spin * x
    return (body.mass * (v_x * v_x + v_y * v_y) + body.moment * spin * spin) / 2


@generic
def friction(kinds: Any) -> Callable[..., Any]:
    """Force and torque about the centre of friction on the support, zero at rest.

    Parameters are effects, rod, v_x, v_y and R omega.
    """
    if len(kinds) == 1 and kinds[0] in MASSES:
        return _no_friction
    return _pressed_friction if kinds[0] is Support else _friction


@compiled
def _no_friction(effects, own, v_x, v_y, spin):
    return 0.0, 0.0, 0.0


@compiled
def _friction(effects, own, v_x, v_y, spin):
    speed = sqrt(v_x * v_x + v_y * v_y)
    if speed == 0.0 and spin == 0.0:
        return 0.0, 0.0, 0.0
    force, torque, _, _, _ = response(effects[:1], speed, spin)
    part = force / speed if speed > 0.0 else 0.0
    return part * v_x, part * v_y, torque


@compiled
def _pressed_friction(effects, own, v_x, v_y, spin):
    if v_x == 0.0 and v_y == 0.0 and spin == 0.0:
        return 0.0, 0.0, 0.0
    along, left = v_x * own.x + v_y * own.y, v_y * own.x - v_x * own.y
    f_x, f_y, torque, _, _, _, _, _, _ = gradient(effects[0], along, left, spin)
    return f_x * own.x - f_y * own.y, f_x * own.y + f_y * own.x, torque


@generic
def farthest(kinds: Any) -> Callable[..., Any]:
    """Greatest torque of friction about the contact, per unit weight: effects, rod length."""
    return _farthest_point if kinds[0] is Support else _farthest_of_ring


@compiled
def _farthest_of_ring(effects, length):
    return length + 1.0


@compiled
def _farthest_point(effects, length):
    return 2.0 / fastest(effects[0], length)


@generic
def widest(kinds: Any) -> Callable[..., Any]:
    """Greatest torque of friction about the centre of mass, per unit weight: effects."""
    return _mean_distance if kinds[0] is Support else _radius


@compiled
def _radius(effects):
    return 1.0


@compiled
def _mean_distance(effects):
    x, y, _ = rough(effects[0])
    return effects[0].extent + sqrt((x - effects[1].x) ** 2 + (y - effects[1].y) ** 2)


@generic
def kink(kinds: Any) -> Callable[..., Any]:
    """Watch of the motion's kinks: the centre on the ring, or a pivot that starts or ends in a slip.

    Parameters are effects, rod, direction of the force of a slip, NaN without one, spin and speed.
    """
    return _kink_at_points if kinds[0] is Support else _kink_on_ring


@compiled
def _kink_at_points(effects, own, force, spin, speed):
    if force.x != force.x:
        return nan
    return kink_under(effects, Line(effects, own.length, force.along, -force.aside, 1.0))


@compiled
def _kink_on_ring(effects, own, force, spin, speed):
    total = abs(spin) + speed
    part = (abs(spin) - speed) / total if total > 0.0 else 0.0
    # As even in time as the moment arm, of which the spin ratio is a function like x / log(x) there.
    return part * (2.0 - log(abs(part))) if part != 0.0 else 0.0
