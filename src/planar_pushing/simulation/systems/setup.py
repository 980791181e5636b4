"""Systems and their states from rows of numbers: a scene's, or one of an array of scenes."""

from __future__ import annotations

from math import hypot, sqrt
from typing import Any

import numpy as np

from planar_pushing.mechanics.compiled import compiled, kernel
from planar_pushing.mechanics.effects.base import (
    COLUMNS,
    GYRATION,
    MASS,
    MASS_X,
    MASS_Y,
    WEIGHT,
    made,
)
from planar_pushing.mechanics.plane import Array, rod, unit_vector
from planar_pushing.mechanics.scene import Scene
from planar_pushing.simulation.fence import typical_speed
from planar_pushing.simulation.problem import Problem
from planar_pushing.simulation.rows import records
from planar_pushing.simulation.systems import base, inertial, quasi_static
from planar_pushing.simulation.systems.shapes import base as shapes
from planar_pushing.simulation.systems.shapes import fence as fences
from planar_pushing.simulation.systems.shapes import finger
from planar_pushing.terms.options import Shape

#: Columns of a row behind those of the effects; twist, gap and ends of the side in radii.
LENGTH, ANGLE, RIGHT, LEFT, SLIPS, CLOSED, ROUGH, V_X, V_Y, SPIN = range(COLUMNS, COLUMNS + 10)
GAP, START, END = range(COLUMNS + 10, COLUMNS + 13)
#: Systems by whether they have inertia.
KINDS = {False: base.QuasiStatic, True: base.Inertial}
base.SYSTEMS.update({base.QuasiStatic: quasi_static, base.Inertial: inertial})
shapes.SHAPES.update({fences.Fence: fences, finger.Finger: finger})
#: What pushes, without the numbers of a scene.
PUSHERS = {Shape.FENCE: fences.Fence(), Shape.FINGER: finger.Finger(rod(1.0, 1.0), -1.0, 1.0)}


def columns(scene: Scene, twist: Any, gap: Any) -> list[Any]:
    """The numbers of a scene, or arrays of them, and its initial state, in the order of the columns.

    The core has lengths in radii, so its mass is the scene's times the radius; without friction the weight
    is zero, and without inertia the mass.
    """
    slider, (mass, gyration) = scene.slider, scene.inertia
    radius, (v_x, v_y, omega) = slider.radius, twist
    return [
        scene.weight if scene.friction else 0.0,
        mass * radius if scene.stores_energy else 0.0,
        gyration, *scene.placement, slider.length_ratio, slider.rod_angle, *scene.law,
        v_x / radius, v_y / radius, omega, gap / radius, *(end / radius for end in slider.side),
    ]  # fmt: skip


@kernel
@compiled
def fill(row, fence, body):
    """Write down what of a scene does not change while it moves."""
    own = max(sqrt(row[V_X] * row[V_X] + row[V_Y] * row[V_Y]), abs(row[SPIN]))
    speed = max(own, typical_speed(fence))
    body.speed = speed if speed > 0.0 else 1.0
    body.length, body.weight, body.mass = row[LENGTH], row[WEIGHT], row[MASS]
    body.moment = body.mass * row[GYRATION]
    body.center[0], body.center[1] = row[MASS_X], row[MASS_Y]
    along, body.reach = row[LENGTH] + row[MASS_X], hypot(row[LENGTH] + row[MASS_X], row[MASS_Y])
    body.lean[0], body.lean[1] = 1.0, 0.0
    if body.reach > 0.0:
        body.lean[0], body.lean[1] = along / body.reach, row[MASS_Y] / body.reach
    body.force = body.mass * body.speed * body.speed + body.weight
    body.right_angle, body.left_angle = row[RIGHT], row[LEFT]
    body.right[0], body.right[1] = unit_vector(row[RIGHT])
    body.left[0], body.left[1] = unit_vector(row[LEFT])
    body.slips, body.closed, body.rough = row[SLIPS] != 0.0, row[CLOSED] != 0.0, row[ROUGH] != 0.0
    body.gap, body.evaluations, body.parted = row[GAP], 0, False


@kernel
@compiled
def put(system, row, state):
    """Write down the state at time 0."""
    base.initial(system, row[ANGLE], row[GAP], row[V_X:GAP], state)


@kernel
@compiled
def shape_of(shape, row):
    """What pushes the scene of a row."""
    return shapes.made(shape, rod(row[LENGTH], row[ANGLE]), row[START], row[END])


def system_of(problem: Problem, row: Array, fence: Any) -> Any:
    """The system of one scene, from its row and its fence."""
    body, scene = records(base.BODY, 1)[0], problem.scene
    fill(row, fence, body)
    shape = shape_of(PUSHERS[problem.shape], row)
    return KINDS[scene.stores_energy](made(scene.kinds, row), body, fence, shape)


def row_of(scene: Scene, twist: Any, gap: float) -> Array:
    """The row of one scene."""
    return np.array([float(each) for each in columns(scene, twist, gap)])
