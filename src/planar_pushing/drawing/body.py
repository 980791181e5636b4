"""Marks of a slider (support, rod, contact, centers) and of the fence or finger that pushes it."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.drawing.canvas.colors import DARK, FENCE, PUSHER, SLIDER, tint
from planar_pushing.drawing.canvas.marks import (
    AREAS,
    ARROWS,
    LINES,
    NOTE,
    Hatch,
    Picture,
    Positions,
    arc,
)
from planar_pushing.drawing.supports import OUTLINE, Ink, Pose, add_support, extents
from planar_pushing.mechanics.force.rubbing import support_of
from planar_pushing.mechanics.outline import Outline
from planar_pushing.mechanics.outline.chains import sample_chain, split_chains
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.supports import Polygon, Ring
from planar_pushing.terms.caches import cache_results

#: Keys of a scene file that do not concern a motion over time.
SCENE_KEYS = ("slider", "contact", "effects")
#: A center closer to the body's origin than this, in units of the support's size, counts as at the origin.
NEAR = 1e-6
#: Extent of dots and signs around their positions, in units of half the support.
RIM = 0.07
#: Labels of the centers.
NAMES = {"pressure": "center of\npressure", "mass": "center\nof mass"}
#: Strength of the color of an outline's area.
OBJECT = 0.06
#: Largest distance of a drawn outline from its arcs, in sizes of the outline.
FLAT = 1e-4
#: Width of a side on the fence, in units of the outline's.
SIDE = 1.5
#: Drawing order of the disc of a finger.
FINGER = AREAS + 0.9
#: Distance between strokes of a fence's hatch, in units of its depth.
STROKE_SPACING = 0.8

#: Vertices of an outline and of its holes.
Rings = tuple[tuple[tuple[float, float], ...], ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Body:
    """A slider in its body frame, with its outline and the marked centers, which are off the origin."""

    support: Any
    centers: tuple[tuple[str, Any], ...] = ()
    outline: Rings = ()

    @property
    def half(self) -> float:
        """Half the larger side of the support; the radius of a ring."""
        return float(np.ptp(self.bounds, axis=0).max() / 2)

    @property
    def bounds(self) -> Array:
        """Corners of the box around the support, with sides along the axes of the body."""
        return _bounds(self.support, self.outline)

    @property
    def middle(self) -> Array:
        """Center of the box around the support."""
        return np.asarray(self.bounds.mean(axis=0))

    @property
    def is_ring(self) -> bool:
        return isinstance(self.support, Ring)

    def box(self, pose: Pose) -> Array:
        """Corners of the upright box around the support and the marks, at a pose."""
        centers = [center for _, center in self.centers]
        marked = map(pose.to_plane, (*centers, *_exterior(self.outline)))
        points = [*extents(self.support, pose), *marked]
        rim = 0.0 if self.is_ring else RIM * self.half
        return np.array([np.min(points, axis=0) - rim, np.max(points, axis=0) + rim])


@cache_results(32)
def _bounds(support: Any, outline: Rings) -> Array:
    points = np.array([*extents(support, Pose((0.0, 0.0), 0.0)), *_exterior(outline)])
    return np.array([points.min(axis=0), points.max(axis=0)])


def body_of(scene: Scene) -> Body:
    """Slider of a scene; an outline equal to the support's is drawn with the support."""
    support, outline = support_of(scene), _outline_rings(scene)
    if isinstance(support, Polygon):
        rings = support.vertices, *support.holes
        outline = () if {*map(frozenset, rings)} == {*map(frozenset, outline)} else outline
    if scene.isotropic:
        return Body(support=support, outline=outline)
    pressure = support.center_of_pressure
    mass = tuple(scene.slider.radius * coordinate for coordinate in scene.mass_center)
    centers = {"pressure": pressure} if scene.friction else {}
    centers |= {"mass": mass} if scene.masses else {}
    near = NEAR * support.extent
    off_origin = any(np.hypot(*center) > near for center in centers.values())
    marked = tuple(centers.items()) if off_origin else ()
    return Body(support=support, centers=marked, outline=outline)


def _outline_rings(scene: Scene) -> Rings:
    """Vertices of a scene's outline and of its holes in the body frame; none without an outline."""
    outline = scene.slider.outline_in_body()
    return () if outline is None else outline_rings(outline)


@cache_results(32)
def outline_rings(outline: Outline) -> Rings:
    """Vertices of an outline and of its holes."""
    chains, tolerance = split_chains(outline.pieces), FLAT * outline.size
    return tuple(tuple(map(tuple, sample_chain(chain, tolerance).tolist())) for chain in chains)


def _exterior(outline: Rings) -> tuple[tuple[float, float], ...]:
    """Vertices of the exterior; none without an outline."""
    return outline[0] if outline else ()


def body_in(data: xr.Dataset) -> Body:
    """Slider of a scene's dataset or of a log; a ring if the dataset names no scene."""
    text = data.attrs.get("scene") or data.attrs.get("parameters")
    if text is None:
        return Body(support=Ring(float(data["radius"])))
    return _read(text)


@lru_cache(maxsize=16)
def _read(text: str) -> Body:
    return body_of(scene_in(text))


def scene_in(text: str) -> Scene:
    """Scene stored in an attribute of a dataset."""
    content = json.loads(text)
    entry = content.get("scene", content)
    from planar_pushing.scenes.scene_model import SceneFile  # most pictures need no scene file

    return SceneFile.model_validate({name: entry[name] for name in SCENE_KEYS}).build()


def add_body(
    picture: Picture,
    body: Body,
    pose: Pose,
    *,
    contact: Positions = (0.0, 0.0),
    side: Array | None = None,
    ink: Ink | None = None,
) -> None:
    """Add the outline, the support, the signs of the centers, and the rod with the contact.

    A side that lies on the fence, given by its ends, replaces the rod.
    """
    ink = ink or Ink()
    if body.outline:
        add_outline(picture, [pose.to_plane(ring) for ring in body.outline], ink)
    add_support(picture, body.support, pose, ink)
    if side is None:
        add_rod(picture, pose.origin, contact=contact, ink=ink)
    else:
        add_side(picture, side, pose.origin, ink)
    for name, center in body.centers:
        face = ink.color if name == "pressure" else "white"
        edge, width = ("white", 0.6) if name == "pressure" else (ink.color, 0.9)
        picture.dot(
            pose.to_plane(center), 7.2, face, edge=edge, width=width, shape=name, order=ARROWS - 0.5
        )


def add_outline(picture: Picture, rings: list[Array], ink: Ink) -> None:
    """Add the outline of an object and its holes: thin lines around a pale area."""
    picture.area(*rings, color=tint(ink.color, OBJECT), order=AREAS)
    for ring in rings:
        closed = np.vstack([ring, ring[:1]])
        picture.line(closed, tint(ink.color, 0.6), width=0.4 * ink.width, order=LINES)


def add_rod(picture: Picture, center: Positions, *, contact: Positions, ink: Ink) -> None:
    """Add the slider's center, the rod from there to the contact, and the dot of the contact."""
    picture.line([contact, center], ink.color, width=0.6 * ink.width, order=OUTLINE)
    picture.dot(center, 2.2, ink.color)
    picture.dot(contact, 4.0, ink.color, order=ARROWS + 1)


def add_side(picture: Picture, side: Array, center: Positions, ink: Ink) -> None:
    """Add a side that lies on the fence, with a dot at each end, and the slider's center."""
    picture.line(side, ink.color, width=SIDE * ink.width, order=OUTLINE)
    picture.dot(center, 2.2, ink.color)
    for end in side:
        picture.dot(end, 2.2 * ink.width, ink.color, order=ARROWS + 1)


def name_centers(picture: Picture, body: Body, pose: Pose) -> None:
    """Label the signs of the centers."""
    for name, center in body.centers:
        picture.label(
            pose.to_plane(center), NAMES[name], size=NOTE, color=DARK, offset=(0.0, -14.0)
        )


def add_fence(
    picture: Picture, left: float, right: float, *, y: float = 0.0, color: str = FENCE,
    width: float = 1.2, depth: float = 0.0,
) -> None:  # fmt: skip
    """Add a horizontal fence, hatched to a depth on the side away from the slider."""
    picture.line([(left, y), (right, y)], color, width=width)
    if depth:
        starts = np.arange(left + depth, right + 1e-9 * depth, STROKE_SPACING * depth)
        tops = np.stack([starts, np.full(len(starts), y)], axis=-1)
        picture.add(Hatch(np.stack([tops, tops - depth], axis=1), color))


def add_finger(
    picture: Picture,
    side: Array,
    contact: Positions,
    color: str = SLIDER,
    center: Positions | None = None,
) -> None:
    """Add the flat side of the slider as a line, and the finger that touches it.

    A point finger is a dot; a finger with a center away from the contact is a disc.
    """
    picture.line(side, color, width=1.2, order=OUTLINE)
    away = np.zeros(2) if center is None else np.subtract(contact, center)
    if not away.any():
        picture.dot(contact, 6.0, tint(PUSHER, 0.5), edge=PUSHER, width=0.9, order=ARROWS + 1)
        return
    start = math.atan2(away[1], away[0])
    rim = np.asarray(center) + math.hypot(*away) * arc(start, start + 2 * math.pi)
    picture.area(rim, color=tint(PUSHER, 0.5), order=FINGER)
    picture.line(rim, PUSHER, width=0.9, order=OUTLINE)
