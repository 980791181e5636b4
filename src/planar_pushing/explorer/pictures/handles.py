"""The handles of the picture: their positions, and the state after a drag."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache

import numpy as np

from planar_pushing.drawing.sketch import Sketch
from planar_pushing.explorer.boundary import nearest_to, perimeter, place_at
from planar_pushing.explorer.objects import object_of, with_contact, with_object_size
from planar_pushing.explorer.state import (
    MAGNITUDES,
    SMALLEST,
    Handle,
    State,
    with_push,
    with_rod,
    with_size,
)
from planar_pushing.mechanics.contact import PerfectlyRough
from planar_pushing.mechanics.force.cones import friction_cone, is_magnitude_open, motion_angle
from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.solve import solve

#: Drawn lengths of the pusher's arrow for the smallest and largest magnitude, in units of the reach.
LENGTHS = 0.3, 1.25
#: Distance of the handle of the line of force, in units of the reach.
LINE = 1.15
#: Ratios of force to weight between which the push of a force angle is interpolated.
RATIOS = np.geomspace(1e-2, 1e4, 49)


@lru_cache(maxsize=8)
def frame_of(scene: Scene) -> Sketch:
    """Sketch of a scene without a push, which gives the positions of the handles."""
    return Sketch.of(scene)


def unit_of_magnitude(scene: Scene) -> float:
    """W / m, or W / c with viscous friction, if the magnitude of a push matters; otherwise 1."""
    if not is_magnitude_open(scene):
        return 1.0
    return float(scene.weight / scene.rows.strength(2))


def arrow_length(state: State) -> float:
    """Drawn length of the pusher's arrow, in units of the reach."""
    scene = state.scene
    if not is_magnitude_open(scene):
        return 1.0
    length = np.interp(
        math.log(state.magnitude / unit_of_magnitude(scene)), np.log(MAGNITUDES), LENGTHS
    )
    return float(length)


def _magnitude(state: State, length: float) -> float:
    """Magnitude of the push with an arrow of this length."""
    scene = state.scene
    if not is_magnitude_open(scene):
        return state.magnitude
    return unit_of_magnitude(scene) * math.exp(
        float(np.interp(length, LENGTHS, np.log(MAGNITUDES)))
    )


def handle_positions(state: State, force: Array | None) -> dict[Handle, Array]:
    """Positions of the handles; the line of force has one if the pusher transmits a force.

    With a side on the fence, only the pusher has one: the others belong to a contact at one point. An
    object with an outline has its contact as a handle, which moves along the outline, and another object
    the end of its rod.
    """
    frame, angle = frame_of(state.scene), math.radians(state.angle)
    pusher = frame.reach * arrow_length(state) * direction(angle)
    if state.flush:
        return {Handle.PUSHER: pusher}
    positions = {Handle.PUSHER: pusher}
    if state.has_outline:
        positions |= {Handle.CONTACT: np.zeros(2), Handle.SIZE: _far_corner(state.scene)}
    else:
        positions |= {
            Handle.ROD: frame.center,
            Handle.SIZE: frame.middle + frame.half * direction(frame.pose.angle - math.pi / 4),
        }
    if force is not None and np.any(force):
        positions[Handle.LINE] = LINE * frame.reach * force / np.hypot(*force)
    return positions


def handles_of(state: State) -> list[Handle]:
    """Handles that a state can have, in the order of the page."""
    if state.flush:
        return [Handle.PUSHER]
    middle = Handle.CONTACT if state.has_outline else Handle.ROD
    return [Handle.PUSHER, middle, Handle.SIZE, Handle.LINE]


def handle_of(state: State) -> Handle:
    """The handle that the keys move: that of the state, or the pusher if the state cannot have that one."""
    return state.handle if state.handle in handles_of(state) else Handle.PUSHER


@lru_cache(maxsize=8)
def _far_corner(scene: Scene) -> Array:
    """The place of the outline farthest from the contact, in the fence frame."""
    outline = scene.slider.outline_in_body()
    assert outline is not None, "only a state with an outline has its corners"
    corners = frame_of(scene).pose.to_plane(outline.vertices())
    return np.asarray(corners[np.hypot(*corners.T).argmax()])


def _drag_pusher(state: State, position: Array) -> State:
    if not np.any(position):
        return state
    length = float(np.hypot(*position)) / frame_of(state.scene).reach
    return with_push(
        state, math.degrees(math.atan2(position[1], position[0])), _magnitude(state, length)
    )


def _drag_rod(state: State, position: Array) -> State:
    angle = math.degrees(math.atan2(max(position[1], 0.0), position[0]))
    return with_rod(state, float(np.hypot(*position)), angle)


def _drag_contact(state: State, position: Array) -> State:
    """State with the contact at the place of the outline nearest to a position."""
    body = object_of(state)
    return with_contact(state, nearest_to(body.outline, body.fence.point_out(position)))


def _drag_size(state: State, position: Array) -> State:
    if state.has_outline:
        corner = _far_corner(state.scene)
        ratio = float(position @ corner / (corner @ corner))
        return with_object_size(state, max(ratio, SMALLEST))
    frame = frame_of(state.scene)
    away = float(np.hypot(*(position - frame.middle)))
    return with_size(state, state.size * away / frame.half)


def _drag_line(state: State, position: Array) -> State:
    """State with the push that sticks under a force along the line, or along the nearest in the cone."""
    if not np.any(position):
        return state
    scene = state.scene
    cone = friction_cone(scene)
    middle = (cone.right + cone.left) / 2
    offset = math.remainder(math.atan2(position[1], position[0]) - middle, 2 * math.pi)
    force = middle + float(np.clip(offset, -cone.span / 2, cone.span / 2))
    angle = _push_of_force(scene, force, state.magnitude)
    return with_push(replace(state, shown="STICK"), math.degrees(angle), state.magnitude)


def _push_of_force(scene: Scene, force: float, magnitude: float) -> float:
    """Direction of the push that sticks under a force angle.

    With friction and inertia, the motion under a force angle depends on the magnitude.
    """
    if not is_magnitude_open(scene):
        return float(motion_angle(scene, force))
    tries = np.asarray(motion_angle(scene, force, force_ratio=RATIOS))
    slow = replace(scene, effects=tuple(effect for effect in scene.effects if effect.degree == 1))
    tries = np.unwrap([motion_angle(slow, force), *tries[np.isfinite(tries)]])
    rough = replace(scene, contact=PerfectlyRough())
    solutions = solve(rough, tries, magnitude)
    sticks = solutions.force[np.arange(len(tries)), np.argmax(solutions.mode == 1, axis=-1)]
    off = np.remainder(np.arctan2(sticks[:, 1], sticks[:, 0]) - force + np.pi, 2 * np.pi) - np.pi
    order = np.argsort(off)
    return float(np.interp(0.0, off[order], tries[order]))


DRAGS: dict[Handle, Callable[[State, Array], State]] = {
    Handle.PUSHER: _drag_pusher,
    Handle.CONTACT: _drag_contact,
    Handle.ROD: _drag_rod,
    Handle.SIZE: _drag_size,
    Handle.LINE: _drag_line,
}


def drag_handle(state: State, handle: Handle, position: Array) -> State:
    """State after a handle is dragged to a position in the picture."""
    return DRAGS[handle](state, np.asarray(position, dtype=float))


#: Steps of a key in degrees and in fractions of a length; ten times larger with the shift key.
DEGREE, PART = 1.0, 0.02


def nudge_handle(state: State, force: Array | None, right: int, up: int, coarse: bool) -> State:
    """State after an arrow key: left and right turn its handle, up and down change its length.

    They move a contact along the outline; the size of an object with an outline only changes.
    """
    handle, step = handle_of(state), 10.0 if coarse else 1.0
    if handle == Handle.CONTACT:
        return _nudge_contact(state, step * (right + up))
    if handle == Handle.SIZE and state.has_outline:
        return with_object_size(state, 1.0 + PART * step * up) if up else state
    position = handle_positions(state, force).get(handle)
    if position is None:
        return state
    about = frame_of(state.scene).middle if handle == Handle.SIZE else np.zeros(2)
    arm = position - about
    angle = math.atan2(arm[1], arm[0]) - math.radians(DEGREE * step * right)
    length = float(np.hypot(*arm)) * (1.0 + PART * step * up)
    return drag_handle(state, handle, about + length * direction(angle))


def _nudge_contact(state: State, steps: float) -> State:
    """State with the contact moved along the outline, counterclockwise, by fractions of its length."""
    body = object_of(state)
    length = body.place.length + steps * PART / 2.0 * perimeter(body.outline)
    return with_contact(state, place_at(body.outline, length))
