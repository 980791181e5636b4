"""The object of a state in its own frame, and states with another contact, outline or size of it."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.explorer.boundary import Place, lowest_place, nearest_to, place_on
from planar_pushing.explorer.state import (
    State,
    duration,
    entries,
    scale_support,
    simulate_entries,
    with_entries,
    with_push,
    with_rod,
    with_simulation,
)
from planar_pushing.mechanics.effects import Inertia, RingFriction, SupportFriction
from planar_pushing.mechanics.entries import scene_entry
from planar_pushing.mechanics.outline import Outline
from planar_pushing.mechanics.outline.chains import (
    LENGTH,
    RHO,
    START,
    X,
    Y,
    sample_chain,
    split_chains,
)
from planar_pushing.mechanics.outline.entries import OUTLINE
from planar_pushing.mechanics.outline.outline import outline_of_pieces
from planar_pushing.mechanics.plane import Array, Frame, direction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.supports import Disc, Polygon, Ring
from planar_pushing.objects.scene_at import place_object
from planar_pushing.terms.options import Shape

#: Columns of pieces with lengths.
SCALED = [X, Y, RHO, LENGTH, START]
#: Deviation of the base of an outline with arcs from it, in sizes of the outline.
FINE = 1e-5


class PushedObject(NamedTuple):
    """An object in its own frame.

    Attributes
    ----------
    outline : Outline
    effects : tuple
        With supports, centers and forces in the object's frame.
    place : Place
        Its contact.
    fence, body : Frame
        The fence frame and the body frame in the object's frame.
    """

    outline: Outline
    effects: tuple[Any, ...]
    place: Place
    fence: Frame
    body: Frame


def frame_in_object(scene: Scene, origin: Any, axis: Any) -> Frame:
    """A frame in the object's frame; its origin and its axis x are given in the fence frame."""
    x, y = scene.to_object(origin, "point").tolist()
    a, b = scene.to_object(axis, "vector").tolist()
    return Frame((x, y), (a, b))


@lru_cache(maxsize=32)
def object_of(state: State) -> PushedObject:
    """The object of a state with an outline."""
    scene = state.scene
    slider = scene.slider
    axis = direction(slider.rod_angle)
    body = frame_in_object(scene, slider.rod_length * axis, axis)
    fence = frame_in_object(scene, (0.0, 0.0), (1.0, 0.0))
    outline = slider.outline_in_body()
    assert outline is not None, "only states with an outline have an object"
    outline = outline.in_frame(body.inverse)
    effects = tuple(
        _with_own_ring(effect, slider.radius).in_frames(body.inverse, fence.inverse)
        for effect in scene.effects
    )
    place = nearest_to(outline, np.array(fence.origin))
    return PushedObject(outline, effects, place, fence, body)


def _with_own_ring(effect: Any, radius: float) -> Any:
    """An effect whose ring has its radius."""
    if isinstance(effect, RingFriction):
        return SupportFriction(weight=effect.weight, support=Ring(radius))
    on_ring = isinstance(effect, SupportFriction) and isinstance(effect.support, Ring)
    if on_ring and effect.support.radius is None:
        return replace(effect, support=Ring(radius))
    return effect


def with_object(state: State, outline: Outline, effects: tuple[Any, ...], place: Place) -> State:
    """State with an object that is pushed at a place, or along its side if a side lies on the fence."""
    on_fence = state.flush and outline.corners is not None
    point, normal = (None, None) if on_fence else (place.point, place.normal)
    side = place.piece // 2 if on_fence else None  # rows of sides and corners alternate
    old = state.scene
    scene, _ = place_object(point, normal, side, effects, old.contact, outline, old.units)
    content = scene_entry(scene)
    parts = {name: content.get(name) for name in ("slider", "effects", "placement")}
    return with_entries(state, **parts)


def with_contact(state: State, place: Place) -> State:
    """State whose object is pushed at another place of its boundary; the push turns with the fence."""
    body = object_of(state)
    return with_object(state, body.outline, body.effects, place)


def with_object_size(state: State, ratio: float) -> State:
    """State with an object whose lengths are multiplied by a ratio.

    The contact, the center of mass, the radius of gyration and the supports are scaled with the outline;
    the mass and the weight stay.
    """
    outline = state.scene.slider.outline_in_body()
    assert outline is not None, "only states with an outline have an object"
    slider = state.file.slider.model_dump(exclude_none=True)
    slider |= {name: slider[name] * ratio for name in ("rod_length", "radius") if name in slider}
    if "side" in slider:
        slider["side"] = [ratio * end for end in slider["side"]]
    pieces = outline.pieces.copy()
    pieces[:, SCALED] *= ratio
    slider["outline"] = OUTLINE.to_file(outline_of_pieces(pieces))
    parts = {
        "slider": slider,
        "effects": [_scaled_effect(entry, ratio) for entry in entries(state)],
    }
    if state.file.placement is not None:
        placement = state.file.placement.model_dump()
        parts["placement"] = placement | {"point": [ratio * x for x in placement["point"]]}
    return with_entries(state, **parts)


def _scaled_effect(entry: dict[str, Any], ratio: float) -> dict[str, Any]:
    """Entry of an effect of a scaled object."""
    scaled = dict(entry)
    if "gyration_radius" in entry:
        scaled["gyration_radius"] = ratio * entry["gyration_radius"]
    if "center" in entry:
        scaled["center"] = [ratio * x for x in entry["center"]]
    if "support" in entry:
        scaled["support"] = scale_support(entry["support"], ratio)
    return scaled


def even_support(outline: Outline) -> Any:
    """Uniform pressure over the whole base of an object, without its holes."""
    if len(outline.pieces) == 1:
        x, y, radius = outline.pieces[0, :3].tolist()
        return Disc(radius, center=(x, y))
    chains = split_chains(outline.pieces)
    vertices, *holes = (sample_chain(chain, FINE * outline.size) for chain in chains)
    return Polygon(vertices, holes=holes)


def with_outline(state: State, outline: Outline) -> State:
    """State with an object of this outline, with even pressure over its base.

    The contact stays at its place if the new outline has the same kinds of pieces as the old one, such as a
    box of another size; otherwise it is at the middle of the lowest side. The push is then followed for as
    long as it takes to cover its distance, unless its velocity changes over time; an object that had no
    outline is pushed by a finger from below.
    """
    support = even_support(outline)
    effects = tuple(_on_base(effect, support) for effect in state.scene.effects)
    place = _same_place(state, outline) or lowest_place(outline)
    changed = with_object(state, outline, effects, place)
    if state.has_outline and len(simulate_entries(state).get("pusher", ())) > 1:
        return changed
    options: dict[str, Any] = {"duration": duration(changed, state.magnitude)}
    if not state.has_outline:
        # The whole side would lie on a fence, and the contact is one point of it.
        options |= {"pusher_shape": str(Shape.FINGER)}
    changed = with_simulation(changed, **options)
    return with_push(changed, state.angle if state.has_outline else 90.0, state.magnitude)


def _on_base(effect: Any, support: Any) -> Any:
    """An effect on another base: its weight or its mass stays.

    The support is the base, and the center of mass and the radius of gyration are those of the base.
    """
    if isinstance(effect, RingFriction):
        return SupportFriction(weight=effect.weight, support=support)
    if isinstance(effect, Inertia):
        return Inertia(mass=effect.mass)
    return replace(effect, support=support) if hasattr(effect, "support") else effect


def _same_place(state: State, outline: Outline) -> Place | None:
    """The place of the contact on an outline with the same pieces, of other sizes."""
    if not state.has_outline:
        return None
    body = object_of(state)
    old, new = body.outline.exterior.pieces, outline.exterior.pieces
    if not np.array_equal(_kinds_of(old), _kinds_of(new)):
        return None
    fraction = body.place.position / old[body.place.piece, LENGTH]
    return place_on(outline, body.place.piece, float(fraction * new[body.place.piece, LENGTH]))


def _kinds_of(pieces: Array) -> Array:
    """Kinds of the pieces of an outline: 0 for a corner, 1 for a side, 2 for an arc; shape (n,)."""
    rho = pieces[:, RHO]
    return np.select([rho == 0.0, np.isinf(rho)], [0, 1], 2)


def without_outline(state: State) -> State:
    """State whose object is a rod with a support."""
    slider = state.file.slider
    return with_rod(state, slider.rod_length, slider.rod_angle)
