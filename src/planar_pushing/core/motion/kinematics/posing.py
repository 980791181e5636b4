"""The problem of a push at an instant of a run."""

from __future__ import annotations

from math import atan2

from planar_pushing.core.instant.directions import Direction, Rod, direction_at, rod_at
from planar_pushing.core.instant.modes import contact_modes
from planar_pushing.core.instant.pocket import modes_in_pocket
from planar_pushing.core.instant.solution import (
    Push,
)
from planar_pushing.core.motion.kinematics.drag import (
    problem_effects,
    put_loads_at,
    put_mass,
    scale_films,
)
from planar_pushing.core.motion.kinematics.rolling import frame_angle
from planar_pushing.core.motion.kinematics.shapes import Pose, pose_with_rod, to_body
from planar_pushing.core.motion.kinematics.system import (
    RunState,
    System,
    law_of,
)
from planar_pushing.core.numbers import Numbers
from planar_pushing.core.supports.rows import Vector


def pose_at_start(system: System, state: RunState) -> Pose:
    """Pose of the slider, exact if body x is at 90 degrees."""
    return pose_with_rod(system, rod_at(1.0, frame_angle(system, state)), state)


def prepare_start(system: System, state: RunState, size: float) -> None:
    """Store the effects of a start from rest, with accelerations in units of a size."""
    scale_films(system, 0.0)
    put_mass(system, size * system.scene.mass)
    put_loads_at(system, state.angle)


def momentum_over(
    system: System, rod: Rod, v_x: float, v_y: float, spin: float, divisor: float
) -> Vector:
    """Momentum of a slider whose center has the velocity (v_x, v_y), in the body frame, over a divisor."""
    scene = system.scene
    x, y = to_body(rod, v_x, v_y)
    mass, c_x, c_y = scene.mass, scene.center.x, scene.center.y
    p_x, p_y = mass * (x - spin * c_y) / divisor, mass * (y + spin * c_x) / divisor
    return Vector(p_x, p_y, system.run.moment * spin / divisor + (c_x * p_y - c_y * p_x))


def pusher_along(pose: Pose, x: float, y: float, part: float) -> Direction:
    """The motion of a pusher along (x, y), at a fraction of unit speed."""
    pusher = direction_at(pose.rod, atan2(y, x))
    if part == 1.0:
        return pusher
    return Direction(
        pusher.angle,
        x=part * pusher.x,
        y=part * pusher.y,
        along=part * pusher.along,
        across=part * pusher.across,
    )


def modes_of_push(
    system: System, pose: Pose, x: float, y: float, part: float, solutions: Numbers
) -> tuple[int, bool]:
    """`contact_modes` of the problem at hand for a pusher along (x, y), at a fraction of unit speed."""
    pusher = pusher_along(pose, x, y, part)
    push = Push(problem_effects(system), pose.contact, pose.rod.x, -pose.rod.y)
    law, pocket = law_of(system, pose.rod), system.run.wall.pocket
    if pocket > 0.0:
        return modes_in_pocket(push, pose.rod, law, pusher, pocket, solutions)
    return contact_modes(push, law, pusher, solutions)
