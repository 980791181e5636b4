"""One step of the time-stepping integrator: the least potential under the contact, in each contact mode.

A step of length h minimises ``|v+ - v|_M^2 / 2 + h D(v+)`` over the twist v+ at its end, subject to the
contact, with the rod angle of its start. The normal motion of the contact is at least
``w_n - gap / h``, so that the gap never closes past zero; a contact mode takes it for equal. Without
inertia only `D` is left, and a contact mode prescribes the contact's motion or its line of force.
"""

from __future__ import annotations

from collections.abc import Callable
from math import sqrt
from typing import Any, NamedTuple

from planar_pushing.mechanics.compiled import compiled, generic
from planar_pushing.mechanics.plane import Rod, contact_motion
from planar_pushing.simulation.systems.base import (
    SEPARATE,
    SLIP_LEFT,
    SLIP_RIGHT,
    STICK,
    margin,
    member,
)

#: Relative to the speeds of a step, and in radians: what rounding leaves of a slip or of a margin.
SLACK = 1e-12
#: Parts into which the range of a slip's impulse is cut; two roots in one part go unseen.
PARTS = 6
#: Trials of a step at most.
TRIALS = 2 + 2 * PARTS
#: Of each kind of system, the module of its steps.
INCREMENTS: dict[type, Any] = {}


class Step(NamedTuple):
    """What a step starts from.

    Attributes
    ----------
    size : float
        Its length h.
    own : Rod
    v_x, v_y, spin : float
        Twist before the step.
    x, y : float
        Motion of the contact that keeps it on the fence.
    """

    size: float
    own: Rod
    v_x: float
    v_y: float
    spin: float
    x: float
    y: float


@generic
def free(kind: Any) -> Callable[..., Any]:
    """Twist after a step without contact force: system, step."""
    return member(INCREMENTS[kind], "free")


@generic
def stick(kind: Any) -> Callable[..., Any]:
    """Twist and impulse of the step whose contact moves with the fence: system, step."""
    return member(INCREMENTS[kind], "stick")


@generic
def slips(kind: Any) -> Callable[..., Any]:
    """Write down the steps under an impulse on an edge, whose normal motion is the fence's.

    Parameters
    ----------
    system, step
    angle : float
        Of the edge.
    found : ndarray, shape (PARTS, 5)
        Takes v_x, v_y, R omega, and the impulse.

    Returns
    -------
    int
        How many there are.
    """
    return member(INCREMENTS[kind], "slips")


@compiled
def _admits(body, p_x, p_y):
    """Whether an impulse lies in the cone of the law; none does not."""
    if p_x == 0.0 and p_y == 0.0:
        return False
    return margin(body, p_x, p_y, 0.0) >= (-SLACK if body.closed else SLACK)


@compiled
def _put(kind, twist, p_x, p_y, kinds, trials, count):
    kinds[count] = kind
    trials[count, 0], trials[count, 1], trials[count, 2] = twist
    trials[count, 3], trials[count, 4] = p_x, p_y
    return count + 1


@compiled
def enumerate_trials(system, step, touching, kinds, trials):
    """Write down every consistent step, in the order of `ContactMode`; how many there are."""
    body, flight, count = system.body, free(system, step), 0
    v_x, v_y, spin = flight
    away = contact_motion(step.own, v_x, v_y, spin)[1] - step.y
    scale = sqrt(step.x * step.x + step.y * step.y)
    scale += sqrt(v_x * v_x + v_y * v_y + (body.length * spin) ** 2)
    parts = away >= -SLACK * scale
    if parts:
        count = _put(SEPARATE, flight, 0.0, 0.0, kinds, trials, 0)
        if not touching:
            return count
    s_x, s_y, s_spin, p_x, p_y = stick(system, step)
    apart = max(abs(s_x - v_x), abs(s_y - v_y), abs(s_spin - spin))
    if _admits(body, p_x, p_y) and not (parts and apart <= SLACK * scale):
        count = _put(STICK, (s_x, s_y, s_spin), p_x, p_y, kinds, trials, count)
    if body.slips:
        count = _slipping(system, step, SLIP_RIGHT, scale, kinds, trials, count)
        count = _slipping(system, step, SLIP_LEFT, scale, kinds, trials, count)
    return count


@compiled
def _slipping(system, step, kind, scale, kinds, trials, count):
    """Write down the steps whose contact slips to the side of its mode."""
    body, side = system.body, 1.0 if kind == SLIP_RIGHT else -1.0
    angle = body.left_angle if kind == SLIP_RIGHT else body.right_angle
    found = trials[count:]
    kept = 0
    for i in range(slips(system, step, angle, found)):
        v_x, v_y, spin = found[i, 0], found[i, 1], found[i, 2]
        if side * (contact_motion(step.own, v_x, v_y, spin)[0] - step.x) > SLACK * scale:
            found[kept] = found[i]
            kinds[count + kept] = kind
            kept += 1
    return count + kept
