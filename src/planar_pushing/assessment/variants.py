"""Variants of a push: with more effects, and with the contact or another input a little off."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from planar_pushing.assessment.estimate import body_frame
from planar_pushing.mechanics.contact import Coulomb
from planar_pushing.mechanics.effects import Effect, Inertia, Load, RingFriction, SupportFriction
from planar_pushing.mechanics.outline.chains import RHO
from planar_pushing.mechanics.outline.outline import Outline
from planar_pushing.mechanics.outline.places import nearest_place
from planar_pushing.mechanics.plane import Array, Frame
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.supports import Ring
from planar_pushing.objects.scene_at import (
    measure_object,
    place_object,
    require_effects,
    with_center,
)
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.options import PusherFrame, Shape

#: A scene and its pusher.
Push = tuple[Scene, Pusher]
#: Normals closer than this are the same.
SAME_NORMAL = 1e-12


def fence_frame(scene: Scene) -> Frame:
    """The fence frame at time 0, in the object's frame."""
    x, y = scene.to_object((0.0, 0.0), "point").tolist()
    a, b = scene.to_object((1.0, 0.0), "vector").tolist()
    return Frame((x, y), (a, b))


def with_candidates(scene: Scene, candidates: Sequence[Effect]) -> Scene:
    """A scene with more effects, which are given in the object's frame as for `scene_at`.

    All loads of the result have a center, so that leaving out a mass does not move them.
    """
    body, fence = body_frame(scene), fence_frame(scene)
    own = in_object(scene)
    acting = require_effects([*own, *candidates], _outline_in_object(scene))
    center = measure_object(tuple(own))[0]
    added = [
        with_center(effect, center, acting).in_frames(body, fence) for effect in acting[len(own) :]
    ]
    full = replace(scene, effects=(*scene.effects, *added))
    x, y = (float(full.slider.radius * coordinate) for coordinate in full.mass_center)
    return replace(full, effects=tuple(_with_center(effect, (x, y)) for effect in full.effects))


def in_object(scene: Scene) -> list[Any]:
    """The effects of a scene in the object's frame."""
    body, fence = _plain(body_frame(scene).inverse), _plain(fence_frame(scene).inverse)
    return [_on_ring(effect, scene).in_frames(body, fence) for effect in scene.effects]


def moved_contact(scene: Scene, pusher: Pusher, distance: float, angle: float) -> Push:
    """A push whose contact is elsewhere along the outline, or whose fence at a corner is turned.

    Parameters
    ----------
    scene : Scene
        One scene, without a side on the fence.
    pusher : Pusher
    distance : float
        Along the outline, toward +x of the fence frame at time 0.
    angle : float
        Of the fence at a corner, in radians, counterclockwise.

    Returns
    -------
    (Scene, Pusher)
        With the same motion of the pusher in the world.

    Raises
    ------
    InvalidValue
        If the contact cannot be there.
    """
    fence, outline = fence_frame(scene), _outline_in_object(scene)
    point, normal = np.array(fence.origin), np.array([-fence.axis[1], fence.axis[0]])
    if outline is not None and pusher.shape == Shape.FENCE and is_corner(outline, point):
        normal = _turn(normal, angle)
    else:
        point, normal = _along(outline, point, normal, distance)
    effects, contact, units = in_object(scene), scene.contact, scene.units
    moved, _ = place_object(point, normal, None, effects, contact, outline, units)
    if outline is None:
        start, end = (float(end) - distance for end in scene.slider.side)
        if not start <= 0.0 <= end:
            raise InvalidValue("point", distance, "a place of the side", "move it less")
        moved = replace(moved, slider=replace(moved.slider, side=(start, end)))
    there = fence_frame(moved)
    if np.hypot(*np.subtract(there.axis, fence.axis)) <= SAME_NORMAL:
        return moved, pusher
    # The pusher moves as before in the world, whose axes are those of the object at time 0.
    return moved, turned_pusher(pusher, np.arctan2(fence.axis[1], fence.axis[0]), world=True)


def is_corner(outline: Outline, point: Array) -> bool:
    """Whether a point of an outline is at a corner."""
    spot = nearest_place(outline, point[None])
    corners = outline.pieces[outline.pieces[:, RHO] == 0.0][:, :2]
    return bool((np.hypot(*(corners - spot.point).T) <= outline.tolerance).any())


def turned_pusher(pusher: Pusher, angle: float, world: bool = False) -> Pusher:
    """A pusher whose velocity is turned, by an angle in radians counterclockwise.

    With `world`, a velocity in the axes of a fence at this angle is turned to those of the world.
    """
    if world and pusher.frame == PusherFrame.WORLD:
        return pusher
    pieces: Any = [(start, _pair(_turn(velocity, angle))) for start, velocity in pusher.pieces]
    return Pusher(
        velocity=pieces or (lambda time: _pair(_turn(pusher.velocity_at(time), angle))),
        breakpoints=pusher.breakpoints, shape=pusher.shape, radius=pusher.radius,
        frame=PusherFrame.WORLD if world else pusher.frame,
    )  # fmt: skip


def changed_inputs(
    scene: Scene, pusher: Pusher, size: float, change: float
) -> Iterator[tuple[str, Callable[[float], Push]]]:
    """The inputs of a push, each with the push in which it is off to one side, 1 or -1.

    Lengths are off by `change` times the size of the object, angles by `change` in radians, and numbers by
    `change` times themselves.
    """
    outline = _outline_in_object(scene)
    if not scene.slider.flush:
        corner = outline is not None and is_corner(outline, np.array(fence_frame(scene).origin))
        turns = corner and pusher.shape == Shape.FENCE
        yield (
            "angle of the fence" if turns else "place of the contact",
            lambda side: moved_contact(scene, pusher, side * change * size, side * change),
        )
    yield "direction of the push", lambda side: (scene, turned_pusher(pusher, side * change))
    if any(hasattr(effect, "support") for effect in scene.effects):
        step, angle = change * size, float(scene.slider.rod_angle)
        c, s = np.cos(angle), np.sin(angle)
        yield (
            "pressure along the side",
            lambda side: (_with_pressure(scene, (side * step * c, -side * step * s)), pusher),
        )
        yield (
            "pressure across the side",
            lambda side: (_with_pressure(scene, (side * step * s, side * step * c)), pusher),
        )
    law = scene.contact
    if isinstance(law, Coulomb):
        yield (
            "friction of the contact",
            lambda side: (replace(scene, contact=_scale_law(law, 1.0 + side * change)), pusher),
        )
    if scene.masses:
        yield "mass", lambda side: (_with_mass(scene, 1.0 + side * change), pusher)


def _scale_law(law: Coulomb, factor: float) -> Coulomb:
    coefficient: Any = law.friction_coefficient
    return Coulomb(coefficient * factor)


def _with_mass(scene: Scene, factor: float) -> Scene:
    """A scene whose masses are larger, under the same friction."""
    effects = tuple(
        replace(effect, mass=effect.mass * factor) if isinstance(effect, Inertia) else effect
        for effect in scene.effects
    )
    return replace(scene, effects=effects)


def _with_pressure(scene: Scene, shift: tuple[float, float]) -> Scene:
    """A scene whose supports are shifted in the body frame."""
    frame = Frame((-float(shift[0]), -float(shift[1])), (1.0, 0.0))
    effects = [_on_ring(effect, scene) for effect in scene.effects]
    shifted = tuple(
        effect.in_frames(frame, frame) if hasattr(effect, "support") else effect
        for effect in effects
    )
    return replace(scene, effects=shifted)


def _along(
    outline: Outline | None, point: Array, normal: Array, distance: float
) -> tuple[Array, Any]:
    """The place of an outline at a distance along the tangent, and its normal; None on an arc."""
    moved = point + distance * np.array([normal[1], -normal[0]])
    if outline is None:
        return moved, normal
    spot = nearest_place(outline, moved[None])
    there = spot.point[0]
    if is_corner(outline, there):
        if np.hypot(*(there - point)) <= outline.tolerance:
            raise InvalidValue("point", distance, "a place of the side", "move it less")
        return there, normal
    return there, None


def _outline_in_object(scene: Scene) -> Outline | None:
    """The outline in the object's frame; that of a scene file is in the body frame."""
    body, slider = body_frame(scene), scene.slider
    outline: Outline | None = slider.outline
    if outline is None or slider.outline_frame == body:
        return outline
    in_body = slider.outline_in_body()
    return None if in_body is None else in_body.in_frame(_plain(body.inverse))


def _on_ring(effect: Any, scene: Scene) -> Any:
    """An effect with its own support, in place of the slider's ring."""
    ring = Ring(float(scene.slider.radius))
    if isinstance(effect, RingFriction):
        return SupportFriction(support=ring, weight=effect.weight)
    if getattr(effect, "support", None) == Ring():
        return replace(effect, support=ring)
    return effect


def _with_center(effect: Any, center: tuple[float, float]) -> Any:
    """A load with a center, by default the given one in the body frame."""
    if isinstance(effect, Load) and effect.center is None:
        return replace(effect, center=center)
    return effect


def _turn(vector: Any, angle: float) -> Array:
    (x, y), c, s = vector, np.cos(angle), np.sin(angle)
    return np.array([x * c - y * s, x * s + y * c])


def _pair(vector: Array) -> tuple[float, float]:
    x, y = vector.tolist()
    return x, y


def _plain(frame: Frame) -> Frame:
    """A frame of floats."""
    (x, y), (a, b) = ((float(pair[0]), float(pair[1])) for pair in frame)
    return Frame((x, y), (a, b))
