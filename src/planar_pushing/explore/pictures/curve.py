"""The limit curve with the force of every solution on it, and the motion along its normal there."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from typing import Any

import numpy as np

from planar_pushing.explore.pictures.arrows import cone, force_arrow, motion_arrow
from planar_pushing.explore.pictures.columns import Marks
from planar_pushing.explore.pictures.scene import PALE, Found, letter
from planar_pushing.explore.state import State
from planar_pushing.figures.parts.forces import flats
from planar_pushing.figures.style import CENTER, DARK, FORCE, LIGHT
from planar_pushing.mechanics.cones import is_magnitude_open
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.effects import Inertia, Viscous
from planar_pushing.mechanics.limit_curve import LimitCurve, limit_curve
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.solutions import Solution

#: Force angles of the curve, radians: fewer where the size of the motion matters and each takes longer.
ANGLES = {False: np.linspace(0.0, 2 * np.pi, 241), True: np.linspace(0.0, 2 * np.pi, 97)}
#: Half the width of the picture, in units of the farthest point of the curve.
ROOM = 1.5


def level(scene: Scene, solution: Solution | None) -> float:
    """Size of the motion whose curve is shown: the translation of equal energy.

    A curve holds the forces whose motions have one kinetic energy, or one power of viscous friction. With
    friction too its shape depends on it; else its size is a unit.
    """
    open_ = is_magnitude_open(scene)
    if not open_ or solution is None or solution.mode == ContactMode.SEPARATE:
        return 1.0
    turn, radius = float(scene.slider.rod_angle), scene.slider.radius
    v_x, v_y, spin = solution.twist[0], solution.twist[1], radius * solution.twist[2]
    energy = whole = 0.0
    for entry in scene.from_rest:
        if entry.degree == 2:
            (mass,), (ratio, x, y) = entry.forces, entry.others
            own_x, own_y = np.cos(turn) * x - np.sin(turn) * y, np.sin(turn) * x + np.cos(turn) * y
            square = (v_x - spin * own_y) ** 2 + (v_y + spin * own_x) ** 2 + ratio * spin**2
            energy, whole = energy + mass * square, whole + mass
    return float(np.sqrt(energy / whole))


@lru_cache(maxsize=8)
def curve_at(scene: Scene, size: float) -> LimitCurve:
    """The limit curve of motions of a size, in the unit of the solutions' forces."""
    effects = tuple(_scaled(each, size) for each in scene.effects)
    found: LimitCurve = limit_curve(
        replace(scene, effects=effects), ANGLES[is_magnitude_open(scene)]
    )
    return found


def _scaled(effect: Any, size: float) -> Any:
    """The effect whose force at a unit of motion is that of this one at a size."""
    if isinstance(effect, Inertia):
        return replace(effect, mass=size * effect.mass)
    if isinstance(effect, Viscous):
        return replace(effect, coefficient=size * effect.coefficient)
    return effect


def picture(state: State, given: Found) -> dict[str, Any]:
    """Columns of the picture, by the kind of mark; the longest force of the curve has length 1."""
    marks = Marks()
    curve = curve_at(state.scene, level(state.scene, given.solution))
    points = curve.force / np.max(curve.magnitude)
    cone(marks, given.friction.right, given.friction.left, 1.25, FORCE, 0.12)
    for axis in np.eye(2):
        marks.line([-ROOM * axis, ROOM * axis], LIGHT, 1.0)
    marks.line(points, DARK, 2.0)
    _flats(marks, points, curve)
    for index, solution in enumerate(given.solutions):
        if index != given.shown:
            _on_curve(marks, state, curve, solution, PALE)
    if given.solution is not None:
        _on_curve(marks, state, curve, given.solution, 1.0)
    return marks.columns


def _flats(marks: Marks, points: Array, curve: LimitCurve) -> None:
    """Heavier line along the flats, where one pivot belongs to an interval of forces."""
    for flat in flats(np.rad2deg(curve.motion_angle)):
        marks.line(points[flat], CENTER, 4.5)


def _on_curve(
    marks: Marks, state: State, curve: LimitCurve, solution: Solution, strength: float
) -> None:
    """A force from the origin to the curve, and the motion that it causes, normal to the curve."""
    if solution.mode == ContactMode.SEPARATE or not np.any(solution.force):
        return
    tip = _tip(curve, solution.force)
    size = float(np.hypot(*solution.contact_motion))
    named = strength == 1.0
    force_arrow(marks, (0.0, 0.0), tip, 1.0, "f" if named else "", alpha=strength)
    if size:
        along = 0.34 * solution.contact_motion / size
        text = f"{letter(state)}\u209b" if named else ""
        motion_arrow(marks, tip, along, 0.8, text, alpha=strength)


def _tip(curve: LimitCurve, force: Array) -> Array:
    """Point of the curve along a force, longest of the curve 1."""
    angle = np.remainder(np.arctan2(force[1], force[0]), 2 * np.pi)
    size = np.interp(angle, np.asarray(curve.force_angle), np.asarray(curve.magnitude))
    return np.asarray(size / np.max(curve.magnitude) * force / np.hypot(*force))
