"""Steps of a scene whose effects are all friction: no memory of the twist before."""

from __future__ import annotations

from math import nan, sqrt

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.plane import Direction, toward
from planar_pushing.mechanics.reduced import base


@compiled
def free(system, step):
    return 0.0, 0.0, 0.0


@compiled
def stick(system, step):
    system.body.evaluations += 1
    own, pace = step.own, sqrt(step.x * step.x + step.y * step.y)
    if pace == 0.0:
        return 0.0, 0.0, 0.0, 0.0, 0.0
    x, y = step.x / pace, step.y / pace
    towards = Direction(nan, x, y, x * own.x + y * own.y, x * own.y - y * own.x)
    moved = base.stick(system.effects, own, towards)
    return (
        pace * moved.v_x, pace * moved.v_y, pace * moved.spin,
        step.size * moved.f_x, step.size * moved.f_y,
    )  # fmt: skip


@compiled
def slips(system, step, angle, found):
    system.body.evaluations += 1
    count = base.slips(system.effects, step.own, toward(step.own, angle), step.y, found)
    for i in range(count):
        found[i, 3] *= step.size
        found[i, 4] *= step.size
    return count
