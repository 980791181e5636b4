"""How friction on the support slows a free slider in a step: the least of ``|v+ - v|_M^2 / 2 + h D(v+)``.

By isotropy the motion keeps its line, and its direction (v, R omega) is the one unknown: it lies between
those that friction alone and inertia alone would give. Momentum inside the limit curve times h leaves rest.
"""

from __future__ import annotations

from collections.abc import Callable
from math import atan, atan2, copysign, cos, sin, sqrt
from typing import Any, NamedTuple

from planar_pushing.mechanics.compiled import compiled, generic_owning
from planar_pushing.mechanics.effects.any_support import Support
from planar_pushing.mechanics.effects.base import response
from planar_pushing.mechanics.numerics.root import EQUATIONS, root
from planar_pushing.mechanics.plane import Rod
from planar_pushing.mechanics.reduced.base import limit_motion
from planar_pushing.simulation.steps import braking
from planar_pushing.simulation.systems.motion import seen_from


class Braked(NamedTuple):
    """Momentum of a unit mass that is across its motion (v, R omega), over the angle of the motion."""

    effects: tuple[Any, ...]
    push: float
    turn: float
    size: float


@compiled
def _left(of, angle):
    """Direction at an angle, what friction leaves of push and turn there, and a slope of friction."""
    c, s = cos(angle), sin(angle)
    force, torque, vv, _, ss = response(of.effects[:1], c, s)
    return c, s, of.push - of.size * force, of.turn - of.size * torque, of.size * (vv + ss)


@compiled
def _braked(of, angle):
    gyration, (c, s, left, over, bend) = of.effects[1].gyration, _left(of, angle)
    slope = bend * (c * c + gyration * s * s) + over * s + left * gyration * c
    return left * gyration * s - over * c, slope


EQUATIONS[Braked] = _braked


@generic_owning
def slowed(kinds: Any) -> Callable[..., Any]:
    """Motion of the centre of mass, and rotation, that friction leaves of those before.

    Parameters are effects, rod, v_x, v_y, R omega, and length of the step.
    """
    if len(kinds) == 1:
        return _not_slowed
    return braking.slowed if kinds[0] is Support else _slowed


@compiled
def _not_slowed(effects, own, v_x, v_y, spin, size):
    return v_x, v_y, spin


@compiled
def _slowed(effects, own, v_x, v_y, spin, size):
    speed = sqrt(v_x * v_x + v_y * v_y)
    slower, rotation = _slowed_by_friction(effects, speed, abs(spin), size)
    part = slower / speed if speed > 0.0 else 0.0
    return part * v_x, part * v_y, copysign(rotation, spin)


@compiled
def _slowed_by_friction(effects, speed, spin, size):
    """The momentum is like a force on a line; friction takes all of it inside the limit curve."""
    mass, gyration = effects[1]
    size, turn = size / mass, gyration * spin
    if speed == 0.0:
        torque = response(effects[:1], 0.0, 1.0)[1]
        return 0.0, max(turn - size * torque, 0.0) / gyration
    below = Rod(turn / speed, 0.0, 0.0, 1.0)
    most, ratio, _ = limit_motion(effects[:1], below, seen_from(below, 1.0, 0.0))
    if speed <= size * most:
        return 0.0, 0.0
    slow, fast = atan(ratio), atan2(spin, speed)
    of = Braked(effects, speed, turn, size)
    # A short step takes little: inertia's own direction is near.
    angle = root(of, min(slow, fast), max(slow, fast), fast)[0]
    c, s, left, over, _ = _left(of, angle)
    size = (c * left + s * over) / (c * c + gyration * s * s)
    return size * c, size * s
