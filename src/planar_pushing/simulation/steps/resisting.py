"""The effects of a step: friction, and inertia, which acts toward the previous twist."""

from __future__ import annotations

from collections.abc import Callable
from math import sqrt
from typing import Any

from planar_pushing.simulation.legacy.compiled import compiled, generic
from planar_pushing.simulation.legacy.load import Wrench
from planar_pushing.simulation.legacy.mass import Mass
from planar_pushing.simulation.steps.clock import seen
from planar_pushing.simulation.systems import base
from planar_pushing.simulation.systems.drag import load_at, scaled_films, with_loads
from planar_pushing.simulation.systems.frame import to_body


@compiled
def _quasi_static_step(system, run, now, h, size, before):
    """Effects of a step without inertia, which does not depend on the previous twist, and its unit."""
    effects = (*system.friction, *scaled_films(system.films, size))
    return with_loads(system.loads, effects, system.body, run.state[base.ANGLE]), size


@compiled
def _inertial_step(system, run, now, h, size, before):
    """Effects of a step with inertia, which acts toward the previous twist, and its unit of motion."""
    body, (v_x, v_y), spin = system.body, seen(system, run, run.twist), run.twist[2]
    load, (x, y) = load_at(body, run.state[base.ANGLE]), to_body(now.frame, v_x, v_y)
    c_x, c_y = body.center
    # Momentum of the center of mass, and about the slider's center, divided by the length of the step.
    p_x, p_y = body.mass * (x - spin * c_y) / h, body.mass * (y + spin * c_x) / h
    turn = body.moment * spin / h + (c_x * p_y - c_y * p_x)
    pull = Wrench(load.x + p_x, load.y + p_y, load.torque + turn)
    push = h * sqrt(load.x * load.x + load.y * load.y) / body.mass
    unit = max(size, before, push)
    mass = Mass(unit * body.mass / h, body.moment / body.mass, c_x, c_y)
    return (*system.friction, *scaled_films(system.films, unit), mass, pull), unit


@generic
def stepped(kind: Any) -> Callable[..., Any]:
    """Effects of a step and their unit. Arguments: system, run, pose, length, pusher and contact speeds."""
    return _inertial_step if kind is base.Inertial else _quasi_static_step
