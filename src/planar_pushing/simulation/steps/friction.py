"""Steps of a scene whose effects are all friction: no memory of the twist before."""

from __future__ import annotations

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.plane import toward
from planar_pushing.mechanics.reduced import base
from planar_pushing.simulation.systems import contact
from planar_pushing.simulation.systems.quasi_static import sticking


@compiled
def free(system, step, found):
    found[:] = 0.0


@compiled
def stick(system, step, found):
    system.body.evaluations += 1
    (x, y, spin, f_x, f_y), size = sticking(step.now, step.x, step.y)
    found[0], found[1], found[2] = size * x, size * y, size * spin
    found[3], found[4] = step.size * f_x, step.size * f_y


@compiled
def slips(system, step, kind, found):
    system.body.evaluations += 1
    now = step.now
    edge = toward(now.own, contact.edge_of(system.body, kind)[2])
    count = base.slips(now.effects, now.own, edge, step.y, step.x, found)
    for i in range(count):
        found[i, 3] *= step.size
        found[i, 4] *= step.size
    return count
