"""Supports by the names that people use, on a rod and under an object with an outline."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from typing import Any

import numpy as np

from planar_pushing.explorer.objects import even_support, object_of, with_object
from planar_pushing.explorer.presets import gallery
from planar_pushing.explorer.state import (
    ROUNDING,
    State,
    effect,
    name_in,
    scale_support,
    with_effect,
    with_support,
)
from planar_pushing.mechanics.entries import entry
from planar_pushing.mechanics.outline import Outline
from planar_pushing.mechanics.outline.places import nearest_place
from planar_pushing.mechanics.plane import Array, Frame, direction
from planar_pushing.mechanics.supports import SHAPES, Polygon
from planar_pushing.mechanics.supports.base import support_in_frame
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.options import EffectKind

#: Names of the supports of the gallery on the page.
LABELS = {
    "ring": "ring, like the rim of a cup",
    "disc": "even pressure, round base",
    "square": "even pressure, square base",
    "rectangle_2_1": "even pressure, base of 2 by 1",
    "rectangle_4_1": "even pressure, base of 4 by 1",
    "l_shape": "even pressure, L-shaped base",
    "pressure_map": "uneven pressure, on a grid",
    "tripod": "three feet",
    "quadruped": "four feet",
    "segment_across": "narrow edge, across",
    "segment_along": "narrow edge, along",
}
#: The support on the whole base of an object, and any other one.
BASE, OWN = "base", "own"
OTHERS = {BASE: "even pressure over the base", OWN: "from the scene file"}
#: Part of the largest size at which a support of the gallery is within the outline.
ROOM = 0.95
#: Steps of the search for this size.
HALVINGS = 40


def support_names(state: State) -> dict[str, str]:
    """Supports to choose from by their names on the page."""
    names = [BASE] if state.has_outline else []
    names += [*gallery(), *([OWN] if support_name(state) == OWN else [])]
    return {(LABELS | OTHERS)[name]: name for name in names}


def support_name(state: State) -> str:
    """The support of a state: that of the gallery, or on the whole base, or its own."""
    if not state.has_outline:
        current = (effect(state, EffectKind.SUPPORT_FRICTION) or {}).get("support")
        return name_in(gallery(), current, state.size) or OWN
    body = object_of(state)
    rests = [effect for effect in body.effects if effect.kind == EffectKind.SUPPORT_FRICTION]
    if not rests or _is_base(rests[0].support, body.outline):
        return BASE
    support = rests[0].support
    centered = support_in_frame(support, Frame(support.center_of_pressure, (1.0, 0.0)))
    size = float(support.extent)
    return name_in(gallery(), _without_rounding(entry(centered), size), size) or OWN


def _without_rounding(content: dict[str, Any], size: float) -> dict[str, Any]:
    """A support without a center, an origin and an axis that are those of the gallery up to rounding."""
    usual = {"center": (0.0, 0.0), "origin": (0.0, 0.0), "axis": (1.0, 0.0)}
    same = {
        key
        for key in usual.keys() & content.keys()
        if np.allclose(
            content[key], usual[key], rtol=0.0, atol=ROUNDING * (1.0 if key == "axis" else size)
        )
    }
    return {key: value for key, value in content.items() if key not in same}


def _is_base(support: Any, outline: Outline) -> bool:
    """Whether a support is even pressure over the whole outline, without its holes."""
    base = even_support(outline)
    if type(support) is not type(base):
        return False
    if not isinstance(support, Polygon):
        apart = np.subtract((support.radius, *support.center), (base.radius, *base.center))
        return bool(np.abs(apart).max() <= outline.tolerance)
    rings, base_rings = ((polygon.vertices, *polygon.holes) for polygon in (support, base))
    if list(map(len, rings)) != list(map(len, base_rings)):
        return False
    one, two = np.concatenate(rings), np.concatenate(base_rings)
    apart = np.abs(one[:, None] - two).max(axis=-1).min(axis=1)
    return bool(apart.max() <= outline.tolerance)


def with_named_support(state: State, name: str) -> State:
    """State with the support of a name; within the outline, if there is one.

    Friction of a weight of 1 is added if there is none.
    """
    if name == OWN:
        return state
    if not state.has_outline:
        return with_support(state, None if name == "ring" else gallery()[name])
    if effect(state, EffectKind.SUPPORT_FRICTION) is None:
        state = with_effect(state, EffectKind.SUPPORT_FRICTION, {"type": "ring_friction"})
    body = object_of(state)
    support = even_support(body.outline) if name == BASE else _support_in(body.outline, name)
    effects = tuple(
        replace(effect, support=support) if effect.kind == EffectKind.SUPPORT_FRICTION else effect
        for effect in body.effects
    )
    return with_object(state, body.outline, effects, body.place)


@lru_cache(maxsize=32)
def _support_in(outline: Outline, name: str) -> Any:
    """A support of the gallery about the centroid of an outline, within it.

    Raises
    ------
    InvalidValue
        If the centroid is not within the outline, as that of a thin L.
    """
    x, y = outline.centroid
    if nearest_place(outline, np.array([(x, y)])).gap[0] >= 0.0:
        raise InvalidValue(
            "Support", LABELS[name], f"{OTHERS[BASE]}, because the centroid is not within the outline",
            "take that one, or give a support in a scene file",
        )  # fmt: skip
    low, high = 0.0, outline.size
    for _ in range(HALVINGS):
        middle = (low + high) / 2.0
        points = middle * _rim(gallery()[name]) + [x, y]
        inside = bool((nearest_place(outline, points).gap <= outline.tolerance).all())
        low, high = (middle, high) if inside else (low, middle)
    content = scale_support(gallery()[name], ROOM * low)
    support = SHAPES[content.pop("shape")](**content)
    return support_in_frame(support, Frame((-x, -y), (1.0, 0.0)))


def _rim(content: dict[str, Any]) -> Array:
    """Points around a support of the gallery."""
    if "radius" in content:
        return direction(np.linspace(0.0, 2.0 * np.pi, 64, endpoint=False))
    if "x" in content:
        x, y = content["x"], content["y"]
        return np.array([(a, b) for a in (x[0], x[-1]) for b in (y[0], y[-1])], dtype=float)
    points = content.get("vertices") or content.get("positions")
    return np.array(points or [content["start"], content["end"]], dtype=float)


def support_note(state: State) -> str:
    """The name of the support in a scene file; that there is no friction, if there is none."""
    friction = effect(state, EffectKind.SUPPORT_FRICTION)
    if friction is None:
        return "There is no friction on the support."
    current = friction.get("support") or {"shape": "ring"}
    name = support_name(state)
    note = f"In a scene file: shape {current['shape']}"
    return f"{note}; in the gallery of supports: {name}." if name in LABELS else f"{note}."
