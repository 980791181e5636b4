"""Steps of a scene with inertia, and with or without friction.

A step solves ``M (v+ - v) + h dD(v+) = J^T P`` for the twist v+ and the contact's impulse P. By isotropy
every part of it is a root in one unknown: the direction of the motion under a known impulse, the
rotation in a stick, the impulse's size in a slip. Rest is a solution where the impulse lies inside the
limit surface times h.
"""

from __future__ import annotations

from collections.abc import Callable
from math import atan2, copysign, cos, pi, sin, sqrt
from typing import Any, NamedTuple

from planar_pushing.mechanics.compiled import compiled, generic
from planar_pushing.mechanics.effects.base import response
from planar_pushing.mechanics.effects.inertia import Mass
from planar_pushing.mechanics.numerics.bracket import bracketed
from planar_pushing.mechanics.numerics.root import EQUATIONS, root
from planar_pushing.mechanics.plane import contact_motion, moment_arm, toward
from planar_pushing.mechanics.reduced.isotropic import spin_ratio
from planar_pushing.simulation.steps.trials import PARTS, SLACK, Step

#: A target below this part of the speeds is a contact that stands still.
STILL = 1e-14
#: Part by which the range of a slip's impulse is widened: friction along the contact's motion shifts it by
#: exactly its all, and the root is then at an end.
WIDER = 1e-3


class Braked(NamedTuple):
    """Impulse across the motion that a step lacks, over the angle of the motion (v, R omega)."""

    effects: tuple[Any, ...]
    push: float
    turn: float
    size: float


@compiled
def _left(of, angle):
    """What friction leaves of an impulse and of a turn in a direction of the motion, and their slopes."""
    c, s = cos(angle), sin(angle)
    force, torque, vv, _, ss = response(of.effects[:1], c, s)
    return of.push - of.size * force, of.turn - of.size * torque, of.size * (vv + ss), c, s


@compiled
def _braked(of, angle):
    mass = of.effects[1].mass
    moment = mass * of.effects[1].gyration
    left, over, bend, c, s = _left(of, angle)
    value = left * moment * s - over * mass * c
    slope = bend * (mass * c * c + moment * s * s) + over * mass * s + left * moment * c
    return value, slope


EQUATIONS[Braked] = _braked


@compiled
def _moving(of, low, high):
    """Speed and rotation whose direction lies between two angles; negative where friction holds them."""
    mass = of.effects[1].mass
    moment = mass * of.effects[1].gyration
    angle = root(of, low, high, low + (high - low) / 2)[0]
    left, over, _, c, s = _left(of, angle)
    size = (mass * c * left + moment * s * over) / ((mass * c) ** 2 + (moment * s) ** 2)
    return size * c, size * s, size


@generic
def _slowed(kinds: Any) -> Callable[..., Any]:
    """Twist after friction took its part of an impulse and of a turn: effects, both, length of the step."""
    return _not_slowed if kinds == (Mass,) else _slowed_by_friction


@compiled
def _not_slowed(effects, b_x, b_y, turn, size):
    mass, gyration = effects[0]
    return b_x / mass, b_y / mass, turn / (mass * gyration)


@compiled
def _slowed_by_friction(effects, b_x, b_y, turn, size):
    push = sqrt(b_x * b_x + b_y * b_y)
    speed, spin = _speeds(effects, push, abs(turn), size)
    scale = speed / push if push > 0.0 else 0.0
    return scale * b_x, scale * b_y, copysign(spin, turn)


@compiled
def _speeds(effects, push, turn, size):
    """Speed and rotation that are left; both zero at rest. The unknown is the angle of (v, R omega).

    Where the impulse lies inside the limit surface times h the motion at the root is negative; elsewhere
    the root sought last lies between the directions that friction alone and inertia alone would give.
    """
    if push == 0.0 and turn == 0.0:
        return 0.0, 0.0
    braked = Braked(effects, push, turn, size)
    speed, spin, found = _moving(braked, 0.0, pi / 2)
    if found > 0.0:
        return speed, spin
    v, s = _limit_motion(effects, push, turn)
    force, torque, _, _, _ = response(effects[:1], v, s)
    if push * force + turn * torque > size * (force * force + torque * torque):
        slow, fast = atan2(s, v), atan2(turn / effects[1].gyration, push)
        speed, spin, found = _moving(braked, min(slow, fast), max(slow, fast))
        if found > 0.0:
            return speed, spin
    return 0.0, 0.0


@compiled
def _limit_motion(effects, push, turn):
    """Motion under friction alone whose wrench has the direction of an impulse."""
    if push == 0.0 or turn == 0.0:
        return push, turn
    return 1.0, spin_ratio(effects[:1], turn / push)


@compiled
def _after(system, step, p_x, p_y, torque):
    """Twist after a step under a known impulse: the minimum of a strictly convex potential."""
    body = system.body
    body.evaluations += 1
    b_x, b_y = body.mass * step.v_x + p_x, body.mass * step.v_y + p_y
    turn = body.moment * step.spin + torque
    return _slowed(system.effects, b_x, b_y, turn, step.size)


@compiled
def free(system, step):
    return _after(system, step, 0.0, 0.0, 0.0)


class Turned(NamedTuple):
    """Torque about the contact that a sticking step lacks, over its rotation."""

    effects: tuple[Any, ...]
    step: Step
    stiffness: float
    middle: float


@compiled
def _turned(of, spin):
    step = of.step
    c, s = step.own.length * step.own.x, step.own.length * step.own.y
    v_x, v_y = step.x - s * spin, step.y + c * spin
    speed = sqrt(v_x * v_x + v_y * v_y)
    force, torque, vv, vs, ss = response(of.effects[:1], speed, spin)
    rate, side = step.own.length, 0.0
    if speed > 0.0:
        rate, side = (c * v_y - s * v_x) / speed, (c * v_x + s * v_y) / speed
    value = of.stiffness * (spin - of.middle) + step.size * (force * rate + torque)
    bend = vv * rate * rate + 2.0 * vs * rate + ss
    if speed > 0.0:
        bend += force * side * side / speed
    return value, of.stiffness + step.size * bend


EQUATIONS[Turned] = _turned


@compiled
def stick(system, step):
    system.body.evaluations += 1
    body, own = system.body, step.own
    c, s = own.length * own.x, own.length * own.y
    stiffness = body.moment + body.mass * own.length * own.length
    # The rotation that inertia alone takes; friction shifts it by no more than its own torque.
    pull = body.moment * step.spin
    pull += body.mass * (s * (step.x - step.v_x) - c * (step.y - step.v_y))
    spin = _rotation(system.effects, step, stiffness, pull / stiffness)
    v_x, v_y = step.x - s * spin, step.y + c * spin
    f_x, f_y = _sustained(system.effects, step, v_x, v_y, spin, pull)
    return (
        v_x, v_y, spin,
        body.mass * (v_x - step.v_x) + step.size * f_x,
        body.mass * (v_y - step.v_y) + step.size * f_y,
    )  # fmt: skip


@generic
def _rotation(kinds: Any) -> Callable[..., Any]:
    """Rotation of a sticking step: the root of the torque about the contact."""
    return _unresisted if kinds == (Mass,) else _resisted


@compiled
def _unresisted(effects, step, stiffness, middle):
    return middle


@compiled
def _resisted(effects, step, stiffness, middle):
    length, weight = step.own.length, effects[0].weight
    if sqrt(step.x * step.x + step.y * step.y) <= STILL * length * abs(middle):
        force, torque, _, _, _ = response(effects[:1], length, 1.0)
        shift = step.size * (length * force + torque) / stiffness
        return copysign(max(abs(middle) - shift, 0.0), middle)
    if step.x == 0.0 and step.y == 0.0:
        return 0.0
    spread = step.size * weight * (length + 1.0) / stiffness
    equation = Turned(effects, step, stiffness, middle)
    return root(equation, middle - spread, middle + spread, middle)[0]


@generic
def _sustained(kinds: Any) -> Callable[..., Any]:
    """Force of friction in a stick; at rest the one whose torque about the contact is just enough."""
    return _no_force if kinds == (Mass,) else _force_of_friction


@compiled
def _no_force(effects, step, v_x, v_y, spin, pull):
    return 0.0, 0.0


@compiled
def _force_of_friction(effects, step, v_x, v_y, spin, pull):
    speed = sqrt(v_x * v_x + v_y * v_y)
    if speed != 0.0 or spin != 0.0:
        force = response(effects[:1], speed, abs(spin))[0]
        part = force / speed if speed > 0.0 else 0.0
        return part * v_x, part * v_y
    length = step.own.length
    force, torque, _, _, _ = response(effects[:1], length, 1.0)
    part = pull / (step.size * (length * force + torque))
    return -part * force * step.own.y, part * force * step.own.x


class Lifted(NamedTuple):
    """Normal motion that a slipping step has too much, over the size of its impulse along (x, y)."""

    system: Any
    step: Step
    x: float
    y: float
    arm: float


@compiled
def _lifted(of, size):
    v_x, v_y, spin = _after(of.system, of.step, size * of.x, size * of.y, size * of.arm)
    return contact_motion(of.step.own, v_x, v_y, spin)[1] - of.step.y, 0.0


EQUATIONS[Lifted] = _lifted


@compiled
def slips(system, step, angle, found):
    own = step.own
    edge = toward(own, angle)
    equation = Lifted(system, step, edge.x, edge.y, moment_arm(own, edge))
    low, high = _range(system, step, equation)
    sizes = _sizes(system.effects, equation, low, high, found)
    for i in range(sizes):
        size = found[i, 0]
        twist = _after(system, step, size * edge.x, size * edge.y, size * equation.arm)
        found[i, 0], found[i, 1], found[i, 2] = twist
        found[i, 3], found[i, 4] = size * edge.x, size * edge.y
    return sizes


@compiled
def _range(system, step, lifted):
    """Bounds of a slip's impulse: that of inertia alone, shifted by what friction can do at most."""
    body, own = system.body, step.own
    away = contact_motion(own, step.v_x, step.v_y, step.spin)[1] - step.y
    gain = lifted.y / body.mass - own.length * own.x * lifted.arm / body.moment
    # A gain of nothing but rounding leaves the size open.
    gain = copysign(max(abs(gain), SLACK / body.mass), gain)
    reach = own.length * abs(own.x)
    shift = step.size * body.weight * (1.0 / body.mass + reach / body.moment)
    one, other = (-away - shift) / gain, (-away + shift) / gain
    low, high = min(one, other), max(one, other)
    wider = WIDER * (high - low)
    return max(low - wider, 0.0), high + wider


@generic
def _sizes(kinds: Any) -> Callable[..., Any]:
    """Write down the sizes of the impulse without an excess of normal motion; their number."""
    return _one_size if kinds == (Mass,) else _every_size


@compiled
def _one_size(effects, lifted, low, high, found):
    found[0, 0] = high
    return 1 if high > 0.0 else 0


@compiled
def _every_size(effects, lifted, low, high, found):
    if not low < high:
        return 0
    count, last = 0, low
    at_last = _lifted(lifted, low)[0]
    for i in range(1, PARTS + 1):
        size = low + (high - low) * i / PARTS
        value = _lifted(lifted, size)[0]
        if (at_last < 0.0) != (value < 0.0):
            found[count, 0] = (
                bracketed(lifted, last, size, at_last, value) if at_last != 0.0 else last
            )
            count += 1
        last, at_last = size, value
    return count
