"""Steps of a scene with inertia, and with or without friction.

A step solves ``M (v+ - v) + h dD(v+) = J^T P`` for the twist v+ and the contact's impulse P. It is a root
in one unknown: the rotation in a stick, the impulse's size in a slip.
"""

from __future__ import annotations

from math import copysign, sqrt
from typing import Any, NamedTuple

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.numerics.bracket import bracketed
from planar_pushing.mechanics.numerics.root import EQUATIONS
from planar_pushing.mechanics.plane import contact_motion
from planar_pushing.simulation.steps.slowing import slowed
from planar_pushing.simulation.steps.trials import PARTS, SLACK, Step
from planar_pushing.simulation.systems.contact import edge_of, moment_of, pushed
from planar_pushing.simulation.systems.motion import farthest, friction, widest

#: A target below this part of the speeds is a contact that stands still.
STILL = 1e-14
#: Part by which the range of a slip's impulse is widened: friction along the contact's motion shifts it by
#: exactly its all, and the root is then at an end.
WIDER = 1e-3


@compiled
def _after(system, step, p_x, p_y):
    """Twist after a step under a known impulse: the minimum of a strictly convex potential."""
    body, now = system.body, step.now
    body.evaluations += 1
    x, y = now.x, now.y
    v_x = step.v_x - step.spin * y + p_x / body.mass
    v_y = step.v_y + step.spin * x + p_y / body.mass
    spin = step.spin + moment_of(now.arm, p_x, p_y) / body.moment
    v_x, v_y, spin = slowed(now.effects, now.own, v_x, v_y, spin, step.size)
    return v_x + spin * y, v_y - spin * x, spin


@compiled
def free(system, step, found):
    found[0], found[1], found[2] = _after(system, step, 0.0, 0.0)
    found[3], found[4] = 0.0, 0.0


class Turned(NamedTuple):
    """Torque about the contact that a sticking step lacks, over its rotation."""

    step: Step
    stiffness: float
    middle: float


@compiled
def _about_contact(now, x, y, spin):
    """Force of friction where the contact moves by (x, y), and its torque about the contact."""
    v_x, v_y = contact_motion(now.own, x, y, -spin)
    f_x, f_y, torque = friction(now.effects, now.own, v_x, v_y, spin)
    return f_x, f_y, torque - moment_of(now.own, f_x, f_y)


@compiled
def _turned(of, spin):
    step = of.step
    torque = _about_contact(step.now, step.x, step.y, spin)[2]
    return of.stiffness * (spin - of.middle) + step.size * torque, 0.0


EQUATIONS[Turned] = _turned


@compiled
def stick(system, step, found):
    body, own, arm = system.body, step.now.own, step.now.arm
    body.evaluations += 1
    stiffness = body.moment + body.mass * arm.length * arm.length
    x, y = step.now.x, step.now.y
    w_x, w_y = step.v_x - step.spin * y, step.v_y + step.spin * x
    lag = moment_of(arm, body.mass * (step.x - w_x), body.mass * (step.y - w_y))
    # The rotation that inertia alone takes; friction shifts it by no more than its own torque.
    middle = (body.moment * step.spin + lag) / stiffness
    spin, f_x, f_y = _sticking(system, step, stiffness, middle)
    v_x, v_y = contact_motion(own, step.x, step.y, -spin)
    found[0], found[1], found[2] = v_x, v_y, spin
    found[3] = body.mass * (v_x - spin * y - w_x) + step.size * f_x
    found[4] = body.mass * (v_y + spin * x - w_y) + step.size * f_y


@compiled
def _sticking(system, step, stiffness, middle):
    """Rotation and force of friction in a stick; where it is held, the part of the force that holds it."""
    now, own = step.now, step.now.own
    grip = farthest(now.effects, own.length)
    most = step.size * system.body.weight * grip / stiffness
    f_x, f_y, torque = _about_contact(now, 0.0, 0.0, 1.0)
    pivot = step.size * torque / stiffness
    if sqrt(step.x * step.x + step.y * step.y) > STILL * own.length * abs(middle):
        equation = Turned(step, stiffness, middle)
        low, high = middle - most, middle + most
        spin = bracketed(equation, low, high, _turned(equation, low)[0], _turned(equation, high)[0])
    elif abs(middle) < pivot:
        return 0.0, middle / pivot * f_x, middle / pivot * f_y
    else:
        spin = middle - copysign(pivot, middle)
    return spin, *_about_contact(now, step.x, step.y, spin)[:2]


class Lifted(NamedTuple):
    """Normal motion that a slipping step has too much, over the size of its impulse along (x, y)."""

    system: Any
    step: Step
    x: float
    y: float


@compiled
def _lifted(of, size):
    twist = _after(of.system, of.step, size * of.x, size * of.y)
    return contact_motion(of.step.now.own, *twist)[1] - of.step.y, 0.0


EQUATIONS[Lifted] = _lifted


@compiled
def slips(system, step, kind, found):
    x, y, _ = edge_of(system.body, kind)
    lifted = Lifted(system, step, x, y)
    low, high = _range(system, step, lifted)
    count = _sizes(lifted, low, high, found)
    for i in range(count):
        found[i, 3], found[i, 4] = found[i, 0] * x, found[i, 0] * y
        found[i, 0], found[i, 1], found[i, 2] = _after(system, step, found[i, 3], found[i, 4])
    return count


@compiled
def _range(system, step, lifted):
    """Bounds of a slip's impulse: that of inertia alone, shifted by what friction can do at most."""
    body, own, arm = system.body, step.now.own, step.now.arm
    away = contact_motion(own, step.v_x, step.v_y, step.spin)[1] - step.y
    gain = pushed(body, arm, lifted.x, lifted.y)[1]
    # A gain of nothing but rounding leaves the size open.
    gain = copysign(max(abs(gain), SLACK / body.mass), gain)
    grip = widest(step.now.effects) * arm.length * abs(arm.x) / body.moment
    shift = step.size * body.weight * (1.0 / body.mass + grip)
    one, other = (-away - shift) / gain, (-away + shift) / gain
    low, high = min(one, other), max(one, other)
    wider = WIDER * (high - low)
    return max(low - wider, 0.0), high + wider


@compiled
def _sizes(lifted, low, high, found):
    """Write down the sizes of the impulse without an excess of normal motion; their number."""
    if not low < high:  # without friction the bounds are the size
        found[0, 0] = high
        return 1 if high > 0.0 else 0
    count, last, at_last = 0, low, _lifted(lifted, low)[0]
    for i in range(1, PARTS + 1):
        size = low + (high - low) * i / PARTS
        value = _lifted(lifted, size)[0]
        if (at_last < 0.0) != (value < 0.0):
            exact = value == 0.0
            found[count, 0] = size if exact else bracketed(lifted, last, size, at_last, value)
            count += 1
        last, at_last = size, value
    return count
