"""Marks of a scene under a push: slider, pusher, cones, and consistent solutions; SVG for notebooks."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from planar_pushing.drawing.body import (
    add_body,
    add_fence,
    add_finger,
    name_centers,
)
from planar_pushing.drawing.canvas.colors import CENTER, DARK, FORCE, MOTION, PUSHER, SLIP, tint
from planar_pushing.drawing.canvas.marks import AREAS, ARROWS, LINES, NOTE, Picture
from planar_pushing.drawing.canvas.svg import to_svg
from planar_pushing.drawing.sketch import (
    MOTION_CONE,
    SUPPORT_LENGTH,
    Sketch,
    forces,
    heading_of,
    moves,
)
from planar_pushing.drawing.supports import Ink, Pose, add_support, extents
from planar_pushing.drawing.walls import add_wall
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.pictures import PICTURES
from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.scene import Scene, require_single
from planar_pushing.mechanics.solutions import Solution, Solutions

#: Strength of the color of the solutions that are not drawn in full.
PALE = 0.38
#: Half the width of the fence, and depth of its hatch, in units of the reach.
HALF, DEPTH = 1.5, 0.09
#: Width of a notebook's picture and its maximum height in pixels, pixels per point, and padding in points.
WIDTH, HEIGHT, POINT, PAD = 420.0, 420.0, 1.35, 16.0


def scene_picture(sketch: Sketch, *, cones: bool = True, friction: bool = True) -> Picture:
    """Complete picture, with the chosen solution in full and the others pale."""
    picture = Picture()
    add_slider(picture, sketch)
    if cones:
        add_cones(picture, sketch)
    if len(sketch.curve):
        add_curve(picture, sketch)
    for index, solution in enumerate(sketch.solutions):
        if index != sketch.chosen:
            add_solution(picture, sketch, solution, PALE)
    if sketch.solution is not None:
        add_solution(picture, sketch, sketch.solution)
    add_pusher(picture, sketch)
    if friction:
        add_friction(picture, sketch)
    name_centers(picture, sketch.body, sketch.pose)
    return picture


def add_slider(
    picture: Picture, sketch: Sketch, left: float | None = None, right: float | None = None
) -> None:
    """Add the walls, the slider, and the fence between two positions along it, or the finger."""
    for segment, normal in sketch.wall_segments:
        add_wall(picture, segment, normal, 2.0 * sketch.half)
    half = HALF * sketch.reach
    if sketch.side is None:
        low, high = sketch.box[:, 0]
        low, high = (low if left is None else left), (high if right is None else right)
        add_fence(picture, float(low), float(high), depth=DEPTH * sketch.reach)
    else:
        ends = tuple(float(np.clip(end, -half, half)) for end in sketch.side)
        side = np.array([(end, 0.0) for end in ends])
        add_finger(picture, side, (0.0, 0.0), center=(0.0, -sketch.finger_radius))
    on_fence = None if sketch.ends is None else np.array(sketch.contacts)
    add_body(picture, sketch.body, sketch.pose, side=on_fence)


def add_cones(picture: Picture, sketch: Sketch) -> None:
    """Add the motion cone and, inside it, the friction cone; of a side, the friction cones at its ends."""
    if sketch.ends is None:
        picture.cone(*sketch.motion, MOTION_CONE * sketch.reach, MOTION, order=AREAS + 0.5)
    for apex in sketch.contacts:
        radius = sketch.friction_radius
        picture.cone(*sketch.friction, radius, FORCE, apex=apex, order=AREAS + 0.7)


def add_solution(
    picture: Picture, sketch: Sketch, solution: Solution, strength: float = 1.0
) -> None:
    """Add force, line of force, motion, slip and center of a solution, labeled if drawn in full."""
    if solution.mode == ContactMode.SEPARATE:
        return
    add_force(picture, sketch, solution, strength)
    add_line_of_force(picture, sketch, solution, strength)
    add_motion(picture, sketch, solution, strength)
    add_center(picture, sketch, solution, strength)


def add_force(picture: Picture, sketch: Sketch, solution: Solution, strength: float = 1.0) -> None:
    """Add the force of the pusher on the slider, or a fan if a pivot leaves its direction undetermined."""
    if not moves(solution):
        return
    name = r"$\mathbf{f}$ (adhesive)" if solution.adhesive else r"$\mathbf{f}$"
    color, ends, tail = tint(FORCE, strength), forces(solution), sketch.tail_of(solution)
    arrows = [sketch.force_scale(solution) * force for force in ends]
    for vector in arrows:
        text = name if len(arrows) == 1 and strength == 1 else ""
        picture.force(tail, vector, text, width=1.6, color=color, order=_order(strength))
    if solution.end_forces is not None:
        add_end_forces(picture, sketch, solution, strength)
    if len(arrows) > 1 and strength == 1:
        _fan(picture, arrows, name, tail)


def add_end_forces(
    picture: Picture, sketch: Sketch, solution: Solution, strength: float = 1.0
) -> None:
    """Add the position of the force on a side, and thin forces at the ends where they are determined."""
    color = tint(FORCE, 0.75 * strength)
    for tail, vector in sketch.end_arrows(solution):
        picture.force(tail, vector, width=0.9, head=8.0, color=color, order=_order(strength) - 0.5)
    position = sketch.tail_of(solution)
    if strength == 1 and solution.flush and position[1] == 0.0:
        picture.dot(position, 3.0, FORCE, order=ARROWS + 1)
        picture.label(position, "$x^{*}$", color=FORCE, size=NOTE, offset=(0.0, -8.0))


def _order(strength: float) -> float:
    return ARROWS if strength == 1 else ARROWS - 1


def _fan(picture: Picture, ends: list[Array], name: str, apex: Array) -> None:
    """Add the range of force directions that are possible at a pivot."""
    right, left = (float(np.arctan2(*end[::-1])) for end in ends)
    turn, length = (left - right) % (2 * np.pi), 0.8 * min(float(np.hypot(*end)) for end in ends)
    picture.cone(right, right + turn, length, FORCE, apex=apex, strength=0.42, order=AREAS + 0.8)
    ahead = direction(right + turn / 2)
    shift = 11.0 * float(ahead[0]), 9.0 * float(ahead[1])
    picture.label(apex + length * ahead, name, offset=shift, color=FORCE)


def add_line_of_force(
    picture: Picture, sketch: Sketch, solution: Solution, strength: float = 1.0
) -> None:
    """Add the line along which the pusher's force and the resistance of the slider act."""
    if moves(solution):
        tail = sketch.tail_of(solution)
        for force in forces(solution):
            picture.guide(tail, sketch.end_of_line(force, tail), tint(FORCE, strength))


def add_motion(picture: Picture, sketch: Sketch, solution: Solution, strength: float = 1.0) -> None:
    """Add the motion of the contact and its slip relative to the pusher."""
    tail, motion = sketch.contact_of(solution), sketch.motion_scale * solution.contact_motion
    color, bold, order = tint(MOTION, strength), rf"\mathbf{{{sketch.symbol}}}", _order(strength)
    sticks, named = solution.mode == ContactMode.STICK, strength == 1
    name = rf"${bold}_s = {bold}_p$" if sticks else rf"${bold}_s$"
    picture.motion(tail, motion, name if named else "", color=color, order=order)
    if sticks or sketch.pusher is None:
        return
    pusher = sketch.motion_scale * sketch.pusher
    text = rf"${bold}_\mathrm{{slip}}$" if named else ""
    style = {"color": tint(SLIP, strength), "order": order - 0.5}
    add_slip(picture, tail + pusher, motion - pusher, text, **style)


def add_slip(picture: Picture, tail: Array, vector: Array, text: str, **rest: Any) -> None:
    """Add the slip of the contact relative to the pusher, as a dashed arrow."""
    style = {"color": SLIP, "dash": "--", "width": 1.0, "head": 10.0, "fraction": 0.5}
    picture.motion(tail, vector, text, offset=(0.0, 8.0), **style | rest)


def add_pusher(picture: Picture, sketch: Sketch) -> None:
    """Add the motion of the pusher if it differs from that of the contact."""
    solution = sketch.solution
    if sketch.pusher is not None and (solution is None or solution.mode != ContactMode.STICK):
        name = rf"$\mathbf{{{sketch.symbol}}}_p$"
        tail, motion = sketch.contact_of(solution), sketch.motion_scale * sketch.pusher
        picture.motion(tail, motion, name, color=PUSHER)


def add_center(picture: Picture, sketch: Sketch, solution: Solution, strength: float = 1.0) -> None:
    """Add the motion center on the perpendicular to the motion, or its distance if it is far away."""
    if not moves(solution):
        return
    color, named = tint(CENTER, strength), strength == 1
    if sketch.is_near(solution):
        picture.guide(sketch.center, solution.center, color)
        add_center_mark(picture, solution.center, color=color, pivot=solution.pivot >= 0)
        if named:
            ahead = heading_of(solution.center - sketch.center)
            noun = "acceleration" if sketch.symbol == "a" else "velocity"
            text = "pivot" if solution.pivot >= 0 else f"{noun}\ncenter"
            offset = 30.0 * float(ahead[0]), 17.0 * float(ahead[1])
            picture.label(solution.center, text, offset=offset, color=color)
        return
    end = sketch.far_center(solution)
    if not np.array_equal(end, sketch.center):
        picture.guide(sketch.center, end, color)
        if named:
            away = sketch.distance(solution) / sketch.half
            length = "radii" if sketch.body.is_ring else "half-widths"
            text = (
                f"center\n{away:,.0f} {length} away" if away < 1e6 else "center\nalmost at infinity"
            )
            picture.label(end, text, offset=(0.0, 12.0), color=color, size=NOTE)


def add_center_mark(
    picture: Picture, position: Any, *, color: str = CENTER, pivot: bool = False, size: float = 5.5
) -> None:
    """Add a motion center: a circle with a dot, and a second circle for a pivot."""
    if pivot:
        picture.dot(position, 2.3 * size, None, edge=color, width=1.2, order=ARROWS + 1)
    picture.dot(position, size, "white", edge=color, width=1.0, order=ARROWS + 1)
    picture.dot(position, 0.3 * size, color, order=ARROWS + 2)


def add_friction(picture: Picture, sketch: Sketch) -> None:
    """Add the friction of the support on the slider, in a paler color than the pusher's force."""
    positions, friction = sketch.rubbing
    largest = float(np.max(np.hypot(*friction.T), initial=0.0))
    for position, force in zip(positions, friction, strict=True):
        if np.any(force):
            along = SUPPORT_LENGTH * sketch.half * force / largest
            picture.force(
                position, along, width=0.7, head=6.5, color=tint(FORCE, 0.62), order=ARROWS - 0.8
            )


def add_curve(picture: Picture, sketch: Sketch) -> None:
    """Add the limit curve around the contact, heavier along its flats."""
    limit_line(picture, sketch.curve_scale * sketch.curve, sketch.flats, order=LINES + 0.4)


def limit_line(
    picture: Picture,
    curve: Array,
    flat: Sequence[slice],
    *,
    color: str = DARK,
    order: float = LINES,
) -> None:
    """Add a limit curve with its flats, on which an interval of forces has one pivot."""
    picture.line(curve, color, width=1.0, order=order)
    for part in flat:
        picture.line(curve[part], FORCE, width=2.6, order=order + 0.1)


def add_scale(picture: Picture, box: Array, length: float, unit: str = "") -> None:
    """Add a scale bar of a round length, with its unit, in the lower right corner of a box."""
    power = 10.0 ** np.floor(np.log10(length))
    rounded = power * max(factor for factor in (1.0, 2.0, 5.0) if factor * power <= length)
    (_, low), (right, _) = box
    picture.scale_bar((right - rounded, low), rounded, f"{rounded:g} {unit}".strip())


def scene_svg(scene: Scene) -> str:
    """Picture of a slider with its cones."""
    sketch = Sketch.of(require_single(scene))
    return _svg(scene_picture(sketch), sketch.box, sketch.unit)


def push_svg(scene: Scene, angle: float, magnitude: float, solutions: Solutions) -> str:
    """Picture of a scene under a push with its solutions."""
    sketch = Sketch.of(scene, angle, magnitude, solutions=solutions)
    return _svg(scene_picture(sketch), sketch.box, sketch.unit)


def support_svg(support: Any) -> str:
    """Picture of a support in its body frame."""
    picture, pose = Picture(), Pose((0.0, 0.0), 0.0)
    add_support(picture, support, pose, Ink())
    low, high = extents(support, pose)
    below = low - np.array([0.0, 0.14 * float(np.max(high - low))])
    return _svg(picture, np.array([below, high]))


def _svg(picture: Picture, box: Array, unit: str = "") -> str:
    """SVG of a picture with its scale bar, as high as needed."""
    wide, high = np.ptp(box, axis=0)
    add_scale(picture, box, 0.3 * float(max(wide, high)), unit)
    room = WIDTH - 2 * PAD * POINT
    needed = room * high / max(wide, 1e-12 * high) + 2.6 * PAD * POINT
    return to_svg(picture, box, (WIDTH, min(HEIGHT, needed)), PAD, POINT)


PICTURES.update(scene=scene_svg, push=push_svg, support=support_svg)
