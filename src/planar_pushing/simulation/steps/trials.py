"""One step of the time-stepping integrator: the least potential under the contact, in each contact mode.

A step of length h minimises ``|v+ - v|_M^2 / 2 + h D(v+)`` over the twist v+ at its end, subject to the
contact, with the rod angle of its start. The normal motion of the contact is at least
``w_n - gap / h``, so that the gap never closes past zero; a contact mode takes it for equal. Without
inertia only `D` is left, and a contact mode prescribes the contact's motion or its line of force.
"""

from __future__ import annotations

from math import sqrt
from typing import Any, NamedTuple

from planar_pushing.mechanics.compiled import by_kind, compiled
from planar_pushing.mechanics.numerics.copying import copy
from planar_pushing.mechanics.plane import contact_motion
from planar_pushing.simulation.systems import base, contact
from planar_pushing.simulation.systems.shapes.base import Pose

#: Rounding error of a slip, relative to the speeds of a step.
SLACK = 1e-12
#: Parts into which the range of a slip's impulse is cut; two roots in one part go unseen.
PARTS = 6
#: Trials of a step at most.
TRIALS = 2 + 2 * PARTS


class Step(NamedTuple):
    """Length and pose of a step, twist before it, and the contact's motion that keeps it on the pusher.

    All is seen in the contact's frame at the start of the step.
    """

    size: float
    now: Pose
    v_x: float
    v_y: float
    spin: float
    x: float
    y: float


#: Of each kind of system, the module of its steps, with the functions below. They write down trials, each a
#: twist and the impulse of the fence: system, step, and where to.
INCREMENTS: dict[type, Any] = {}
#: The step without contact force.
free = by_kind(INCREMENTS, "free")
#: The step whose contact moves with the fence.
stick = by_kind(INCREMENTS, "stick")
#: The steps that slip in a mode under an impulse on its edge, whose normal motion is the fence's: system,
#: step, mode, trials. Returns how many there are.
slips = by_kind(INCREMENTS, "slips")


@compiled
def enumerate_trials(system, step, touching, kinds, trials):
    """Write down every consistent step, in the order of `ContactMode`; how many there are."""
    free(system, step, trials[0])
    v_x, v_y, spin = trials[0, 0], trials[0, 1], trials[0, 2]
    away = contact_motion(step.now.own, v_x, v_y, spin)[1] - step.y
    slack = SLACK * sqrt(step.x * step.x + step.y * step.y)
    slack += SLACK * sqrt(v_x * v_x + v_y * v_y + (step.now.own.length * spin) ** 2)
    kinds[0], count = base.SEPARATE, 1 if away >= -slack else 0
    if count == 1 and not touching:
        return count
    found = trials[count]
    stick(system, step, found)
    apart = max(abs(found[0] - v_x), abs(found[1] - v_y), abs(found[2] - spin))
    if contact.admits(system.body, found[3], found[4]) and (count == 0 or apart > slack):
        kinds[count], count = base.STICK, count + 1
    if system.body.slips:
        count = _slipping(system, step, base.SLIP_RIGHT, slack, kinds, trials, count)
        count = _slipping(system, step, base.SLIP_LEFT, slack, kinds, trials, count)
    return count


@compiled
def _slipping(system, step, kind, slack, kinds, trials, count):
    """Write down the steps whose contact slips to the side of its mode."""
    first = count
    for i in range(slips(system, step, kind, trials[first:])):
        found = trials[first + i]
        slip = contact_motion(step.now.own, found[0], found[1], found[2])[0] - step.x
        if contact.side_of(kind) * slip > slack:
            copy(trials[count], found)
            kinds[count], count = kind, count + 1
    return count
