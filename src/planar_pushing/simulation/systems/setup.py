"""Creation of systems and states from rows of numbers, one for each scene."""

from __future__ import annotations

from math import inf, sqrt
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene, Slider
from planar_pushing.simulation.fence import typical_speed
from planar_pushing.simulation.legacy.compiled import compiled, kernel, owning
from planar_pushing.simulation.legacy.core import Entry, entries
from planar_pushing.simulation.legacy.load import Wrench
from planar_pushing.simulation.legacy.plane import unit_vector
from planar_pushing.simulation.legacy.record import MOST, SOLUTION
from planar_pushing.simulation.legacy.slips import ENTRIES, SLIPS
from planar_pushing.simulation.outlines import tolerance
from planar_pushing.simulation.problem import Problem
from planar_pushing.simulation.rows import records
from planar_pushing.simulation.systems import base, inertial, quasi_static
from planar_pushing.simulation.systems.drag import columns_of, effects_of
from planar_pushing.simulation.systems.shapes import base as shapes
from planar_pushing.simulation.systems.shapes import fence as fences
from planar_pushing.simulation.systems.shapes import finger
from planar_pushing.terms.options import Shape

#: Numbers in a row after those of the effects. They include twist, gap, ends of the side and finger radius
#: in units of the slider's radius, and the slider's radius in tolerances of the outline.
WEIGHT, MASS, GYRATION, MASS_X, MASS_Y, LOAD_X, LOAD_Y, CROSS, DOT = range(9)
LENGTH, ANGLE, RIGHT, LEFT, SLIPS_AT, CLOSED, ROUGH, V_X, V_Y, SPIN, GAP = range(9, 20)
START, END, FINE, FINGER = range(20, 24)
NUMBERS = FINGER + 1
#: Kinds of systems, by whether they have inertia.
KINDS = {False: base.QuasiStatic, True: base.Inertial}
base.SYSTEMS.update({base.QuasiStatic: quasi_static, base.Inertial: inertial})
shapes.SHAPES.update({fences.Fence: fences, finger.Finger: finger})
#: Prototypes of the pushers, without the numbers of a scene.
PUSHERS = {
    Shape.FENCE: fences.Fence(),
    Shape.FINGER: finger.Finger(1.0, 1.0, 1.0, 0.0, -1.0, 1.0, 0.0),
}


class Kinds(NamedTuple):
    """Kinds of the resisting effects, of friction, of viscous friction, and of loads."""

    effects: tuple[Any, ...]
    friction: tuple[Any, ...]
    films: tuple[Any, ...]
    loads: tuple[Any, ...]


def resisting(scene: Scene) -> list[Entry]:
    """Friction followed by viscous friction, in the form of the core."""
    return entries(scene.friction, scene) + entries(scene.viscous, scene)


def kinds_of(scene: Scene) -> Kinds:
    """The kinds for which the equations of a scene are compiled."""
    every = resisting(scene)
    loads = (Wrench(0.0, 0.0, 0.0),) if scene.loads else ()
    return Kinds(
        tuple(entry.kind for entry in every),
        tuple(entry.kind for entry in every if entry.degree == 1),
        tuple(entry.kind for entry in every if entry.degree == 2),
        loads,
    )


def order_of(scene: Scene) -> list[int]:
    """Index of each effect of a scene among the resisting effects, -1 for the others."""
    resist = [*_in_order(scene.friction, scene), *scene.viscous]
    return [next((i for i, e in enumerate(resist) if e is each), -1) for each in scene.effects]


def _in_order(friction: list[Any], scene: Scene) -> list[Any]:
    """Effects in the order of their entries."""
    kinds = [type(entries([each], scene)[0].kind).__name__ for each in friction]
    return [friction[i] for i in sorted(range(len(kinds)), key=lambda i: kinds[i], reverse=True)]


def columns(scene: Scene, twist: Any, gap: Any, finger_radius: Any) -> list[Any]:
    """Numbers of one or many scenes, their initial states, and the radius of the finger.

    The core has lengths in units of the radius. Its masses and viscous friction coefficients are therefore
    those of the scene multiplied by the radius. The weight is zero without friction, and the mass is zero
    without inertia.
    """
    slider, (mass, gyration) = scene.slider, scene.inertia
    radius, (v_x, v_y, omega) = slider.radius, twist
    found = []
    for entry in resisting(scene):
        found += [each * (radius if entry.degree == 2 else 1.0) for each in entry.forces]
        found += entry.others
    return [
        *found,
        scene.weight if scene.friction else 0.0,
        mass * radius if scene.stores_energy else 0.0,
        gyration, *scene.mass_center, *_loads(scene), slider.length_ratio, slider.rod_angle,
        *scene.law, v_x / radius, v_y / radius, omega, gap / radius,
        *(end / radius for end in slider.side), _fineness(slider), finger_radius / radius,
    ]  # fmt: skip


def _fineness(slider: Slider) -> Any:
    """Radius in units of the outline's tolerance, 0 without an outline."""
    return 0.0 if slider.outline is None else slider.radius / tolerance(slider.outline)


def corners_of(slider: Slider) -> Array:
    """Corners of the outline in units of its tolerance, shape (corners, 2); empty without an outline."""
    if slider.outline is None:
        return np.empty((0, 2))
    return np.array(slider.outline) / tolerance(slider.outline)


def _loads(scene: Scene) -> list[Any]:
    """Force of the loads in the initial body frame, and its cross and dot products with their points."""
    c, s = np.cos(scene.slider.rod_angle), np.sin(scene.slider.rod_angle)
    whole = [0.0, 0.0, 0.0, 0.0]
    for load in scene.loads:
        (x, y), (p_x, p_y) = load.force, scene.mass_center
        if load.center is not None:
            p_x, p_y = (each / scene.slider.radius for each in load.center)
        g_x, g_y = x * c + y * s, y * c - x * s
        terms = g_x, g_y, p_x * g_y - p_y * g_x, p_x * g_x + p_y * g_y
        whole = [sum(pair) for pair in zip(whole, terms, strict=True)]
    return whole


@kernel
@compiled
def fill(row, fence, body):
    """Store the constants of a scene, from the numbers after those of the effects."""
    own = max(sqrt(row[V_X] * row[V_X] + row[V_Y] * row[V_Y]), abs(row[SPIN]))
    load = sqrt(row[LOAD_X] * row[LOAD_X] + row[LOAD_Y] * row[LOAD_Y])
    speed = max(own, typical_speed(fence))
    if speed == 0.0 and load > 0.0 and row[MASS] > 0.0:
        # Speed that the load gives the slider within one length.
        speed = sqrt(load / row[MASS])
    body.speed = speed if speed > 0.0 else 1.0
    body.length, body.weight, body.mass = row[LENGTH], row[WEIGHT], row[MASS]
    body.moment = body.mass * row[GYRATION]
    body.center[0], body.center[1] = row[MASS_X], row[MASS_Y]
    body.load[0], body.load[1] = row[LOAD_X], row[LOAD_Y]
    body.load[2], body.load[3] = row[CROSS], row[DOT]
    body.start_angle = row[ANGLE]
    body.force = body.mass * body.speed * body.speed + body.weight + load
    if body.force == 0.0:
        body.force = 1.0
    body.right_angle, body.left_angle = row[RIGHT], row[LEFT]
    body.right[0], body.right[1] = unit_vector(row[RIGHT])
    body.left[0], body.left[1] = unit_vector(row[LEFT])
    body.slips, body.closed = row[SLIPS_AT] != 0.0, row[CLOSED] != 0.0
    body.rough = row[ROUGH] != 0.0
    body.gap, body.evaluations, body.parted = row[GAP], 0, False
    body.fine, body.low, body.high = row[FINE], -inf, inf


@kernel
@compiled
def put(system, row, state):
    """Store the state at time 0."""
    base.initial(system, row[ANGLE], row[GAP], row[V_X:GAP], state)


@kernel
@compiled
def shape_of(shape, row):
    """Pusher of the scene of a row."""
    return shapes.made(shape, row[LENGTH], row[ANGLE], row[START], row[END], row[FINGER])


def new_room(scene: Scene) -> base.Room:
    """Work arrays of a scene's system, and the corners of its outline."""
    return base.Room(
        np.empty((SLIPS, ENTRIES)), np.empty(MOST, SOLUTION), np.zeros(MOST, np.int64),
        np.zeros(MOST, np.int64), np.zeros(MOST, np.int64), np.zeros((MOST, 3)), np.zeros(size_of(scene)),
        corners_of(scene.slider),
    )  # fmt: skip


def size_of(scene: Scene) -> int:
    """Number of entries of the state of a scene's system."""
    return (base.MOVING if scene.stores_energy else base.STILL) + len(resisting(scene))


@owning
def parts_of(kinds, row):
    """Resisting effects, and separately friction and viscous friction."""
    friction = effects_of(kinds.friction, row, 0)
    films = effects_of(kinds.films, row, columns_of(kinds.friction))
    return (*friction, *films), friction, films


def system_of(problem: Problem, row: Array, fence: Any) -> Any:
    """System of one scene, from its row and its fence."""
    body, scene = records(base.BODY, 1)[0], problem.scene
    kinds, numbers = kinds_of(scene), row[-NUMBERS:]
    fill(numbers, fence, body)
    system: Any = KINDS[scene.stores_energy]
    effects, friction, films = parts_of(kinds, row)
    return system(
        effects, friction, films, kinds.loads, body, fence,
        shape_of(PUSHERS[problem.shape], numbers), new_room(scene),
    )  # fmt: skip


def row_of(problem: Problem) -> Array:
    """Row of a problem with one scene."""
    given = problem.twist, problem.gap, problem.pusher.radius
    return np.array([float(each) for each in columns(problem.scene, *given)])
