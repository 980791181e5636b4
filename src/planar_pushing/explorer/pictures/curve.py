"""The limit curve with the force of every solution on it and the motion along its normal there."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache
from typing import Any

import numpy as np

from planar_pushing.drawing.canvas.colors import FORCE, GUIDE, LIGHT, MOTION, tint
from planar_pushing.drawing.canvas.marks import Picture
from planar_pushing.drawing.scene import PALE, limit_line
from planar_pushing.drawing.sketch import flats, moves
from planar_pushing.mechanics.effects import Inertia, Viscous
from planar_pushing.mechanics.force.cones import friction_cone, is_magnitude_open
from planar_pushing.mechanics.force.limit_curve import LimitCurve, curve_of_unit_motions
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.solutions import Solution

#: Force angles of the curve, radians; fewer if the magnitude of the motion matters, which takes longer.
ANGLES = {False: np.linspace(0.0, 2 * np.pi, 241), True: np.linspace(0.0, 2 * np.pi, 97)}
#: Box of the picture, and drawn length of a motion, in units of the largest force.
BOX, MOVES = np.array([(-1.45, -1.2), (1.45, 1.3)]), 0.34


#: Text in the place of the curve of a side on the fence.
NO_CURVE = "A side lies on the fence: the motion also\ndepends on the place of the force."


def curve_picture(scene: Scene, solutions: Sequence[Solution], chosen: int, symbol: str) -> Picture:
    """Picture of the curve, scaled to a largest force of 1, with the friction cone and the solutions."""
    if scene.slider.flush:
        return words_alone(BOX, NO_CURVE)
    picture, cone = Picture(), friction_cone(scene)
    curve = curve_at(scene, level(scene, solutions[chosen] if chosen >= 0 else None))
    largest = float(np.max(curve.magnitude))
    picture.cone(cone.right, cone.left, 1.2, FORCE)
    for axis in np.eye(2):
        picture.line([-1.4 * axis, 1.4 * axis], LIGHT, width=0.6)
    limit_line(picture, curve.force / largest, flats(curve.motion_angle))
    for index, solution in enumerate(solutions):
        if moves(solution):
            _on_curve(picture, curve, solution, symbol if index == chosen else "")
    return picture


def words_alone(box: Array, text: str) -> Picture:
    """Picture of a text in the middle of a box."""
    picture = Picture()
    picture.label(box.mean(axis=0), text, color=GUIDE, held=True)
    return picture


def _on_curve(picture: Picture, curve: LimitCurve, solution: Solution, symbol: str) -> None:
    """Add a force from the origin to the curve and the motion that it causes, labeled if drawn in full."""
    tip, speed = _tip(curve, solution.force), float(np.hypot(*solution.contact_motion))
    strength = 1.0 if symbol else PALE
    picture.force((0.0, 0.0), tip, r"$\mathbf{f}$" if symbol else "", color=tint(FORCE, strength))
    if speed:
        name = rf"$\mathbf{{{symbol}}}_s$" if symbol else ""
        along = MOVES * solution.contact_motion / speed
        picture.motion(tip, along, name, color=tint(MOTION, strength), head=11.0)


def _tip(curve: LimitCurve, force: Array) -> Array:
    """Point of the curve along a force, in units of the largest force."""
    angle = np.remainder(np.arctan2(force[1], force[0]), 2 * np.pi)
    length = np.interp(angle, np.asarray(curve.force_angle), np.asarray(curve.magnitude))
    return np.asarray(length / np.max(curve.magnitude) * force / np.hypot(*force))


@lru_cache(maxsize=8)
def curve_at(scene: Scene, magnitude: float) -> LimitCurve:
    """Limit curve of motions of a given magnitude, in the force unit of the solutions."""
    effects = tuple(_scale_effect(effect, magnitude) for effect in scene.effects)
    angles = ANGLES[is_magnitude_open(scene)]
    curve: LimitCurve = curve_of_unit_motions(replace(scene, effects=effects), angles)
    return curve


def _scale_effect(effect: Any, magnitude: float) -> Any:
    """Effect that causes, at unit motion, the force of the given effect at a magnitude of motion."""
    if isinstance(effect, Inertia):
        return replace(effect, mass=magnitude * effect.mass)
    if isinstance(effect, Viscous):
        return replace(effect, coefficient=magnitude * effect.coefficient)
    return effect


def level(scene: Scene, solution: Solution | None) -> float:
    """Magnitude of motion for the limit curve: that of the translation of equal energy.

    A curve contains the forces of motions with equal kinetic energy or equal power of viscous friction.
    With support friction as well, its shape depends on this magnitude; otherwise the magnitude is 1.
    """
    if not is_magnitude_open(scene) or solution is None or not moves(solution):
        return 1.0
    turn, radius = float(scene.slider.rod_angle), scene.slider.radius
    v_x, v_y, spin = solution.twist[0], solution.twist[1], radius * solution.twist[2]
    energy = total = 0.0
    for entry in scene.rows.entries:
        if entry.degree == 2:
            body = entry.values
            mass, ratio, x, y = (
                body[name] for name in ("mass", "gyration", "center_x", "center_y")
            )
            arm_x, arm_y = np.cos(turn) * x - np.sin(turn) * y, np.sin(turn) * x + np.cos(turn) * y
            square = (v_x - spin * arm_y) ** 2 + (v_y + spin * arm_x) ** 2 + ratio * spin**2
            energy, total = energy + mass * square, total + mass
    return float(np.sqrt(energy / total))
