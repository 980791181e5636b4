"""The effects of a run: friction, viscous friction and loads, and the problems that they pose."""

from __future__ import annotations

from math import cos, fabs, sin, sqrt
from typing import NamedTuple

from planar_pushing.core.motion.kinematics.system import System, is_loaded
from planar_pushing.core.numbers import INFINITY, Numbers
from planar_pushing.core.supports.resistance import (
    Resistance,
    constant_wrench,
    effect_resistance,
    resistance,
)
from planar_pushing.core.supports.rows import (
    NO_POINT,
    Effects,
    LoadRow,
    MassRow,
    Vector,
    column_of,
    foot_position,
)
from planar_pushing.core.supports.tolerances import ROUNDING


def resisting_effects(system: System) -> Effects:
    """Friction and viscous friction."""
    return _effects_of(system, system.row, system.scene.resisting)


def friction_effects(system: System) -> Effects:
    """Friction alone."""
    return _effects_of(system, system.row, system.scene.frictions)


def problem_effects(system: System) -> Effects:
    """All effects, with the numbers for the problem at hand."""
    return _effects_of(system, system.problem, system.run.effects)


def depends_on_speed(system: System) -> bool:
    """Whether the direction of the motion depends on its magnitude, with viscous friction or loads."""
    return system.run.resists_squarely or is_loaded(system)


def _effects_of(system: System, row: Numbers, length: int) -> Effects:
    run = system.run
    return Effects(
        row,
        system.data,
        length,
        run.feet,
        run.frictional,
        run.resists_squarely,
        run.linear,
        one=1.0,
        two=1.0,
    )


def scale_films(system: System, factor: float) -> None:
    """Multiply the viscous friction of the problem at hand by a factor."""
    for i in range(system.scene.frictions, system.scene.resisting):
        column = column_of(system.data, i)
        system.problem[column] = factor * system.row[column]


def put_mass(system: System, factor: float) -> None:
    """Store the inertia of the problem at hand, multiplied by a factor."""
    scene = system.scene
    body = MassRow(system.problem[column_of(system.data, scene.resisting) :])
    body.mass, body.gyration = factor, system.run.moment / scene.mass
    body.center_x, body.center_y = scene.center.x, scene.center.y


def put_load(system: System, load: Vector) -> None:
    """Store the wrench of the loads of the problem at hand."""
    row = LoadRow(system.problem[column_of(system.data, system.run.effects - 1) :])
    row.x, row.y, row.torque = load.x, load.y, load.spin


def load_at(system: System, angle: float) -> Vector:
    """Wrench of the loads at a rod angle; their direction in the world is constant."""
    scene, turn = system.scene, angle - system.scene.angle
    c, s = cos(turn), sin(turn)
    x, y = scene.load.x, scene.load.y
    return Vector(x * c + y * s, y * c - x * s, scene.cross * c - scene.dot * s)


def put_loads_at(system: System, angle: float) -> None:
    """Store the loads of the problem at hand for a rod angle, if there are any."""
    if is_loaded(system):
        put_load(system, load_at(system, angle))


def load_work(system: System, angle: float, x: float, y: float) -> float:
    """Work of the loads since time 0 if the slider's center is at (x, y) in the world."""
    scene, run, turn = system.scene, system.run, angle - system.scene.angle
    c, s = run.rod.x, run.rod.y
    d_x, d_y = x - scene.length * c, y - scene.length * s
    b_x, b_y = d_x * c + d_y * s, d_y * c - d_x * s
    work = scene.load.x * b_x + scene.load.y * b_y
    return work + scene.dot * (cos(turn) - 1.0) + scene.cross * sin(turn)


def drag(system: System, x: float, y: float, spin: float) -> Resistance:
    """`Resistance` of friction and viscous friction, 0 at rest, without points at the center."""
    effects = resisting_effects(system)
    if effects.length == 0 or (x == 0.0 and y == 0.0 and spin == 0.0):
        return constant_wrench(0.0, 0.0, 0.0)
    return resistance(effects, x, y, spin, ROUNDING * (fabs(x) + fabs(y)))


def write_powers(
    system: System, x: float, y: float, spin: float, total: float, powers: Numbers
) -> None:
    """Store the power that each effect dissipates; the last one takes the rest of the total."""
    effects = resisting_effects(system)
    moves: bool = x != 0.0 or y != 0.0 or spin != 0.0
    for i in range(effects.length - 1):
        powers[i] = 0.0
        if moves:
            part = effect_resistance(effects, i, x, y, spin, ROUNDING * (fabs(x) + fabs(y)))
            powers[i] = part.f_x * x + part.f_y * y + part.torque * spin
        total -= powers[i]
    if effects.length > 0:
        powers[effects.length - 1] = total


class Foot(NamedTuple):
    """The slowest support point of a twist, -1 without points, and its speed."""

    number: int
    speed: float


def slowest_foot(system: System, x: float, y: float, spin: float) -> Foot:
    """The slowest support point under a twist of the body frame."""
    effects = friction_effects(system)
    number, lowest = NO_POINT, INFINITY
    for i in range(effects.feet):
        foot = foot_position(effects, i)
        v_x, v_y = x - spin * foot.y, y + spin * foot.x
        speed = sqrt(v_x * v_x + v_y * v_y)
        if speed < lowest:
            number, lowest = i, speed
    return Foot(number, lowest)
