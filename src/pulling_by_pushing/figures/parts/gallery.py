"""Supports in figures of sliders: their shapes, their families, and the flats of their limit curves."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from pydantic import TypeAdapter

from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.supports import Composite, Points, Ring, Segment
from planar_pushing.scenes.entries import SupportEntry

if TYPE_CHECKING:
    import xarray as xr

SECTION = "Ours, any slider"


def shapes(supports: xr.Dataset) -> dict[str, Any]:
    """Supports to draw, by name, from their descriptions in the dataset `supports`."""
    entry: TypeAdapter[Any] = TypeAdapter(SupportEntry)
    texts = zip(supports.support.values, supports.description.values, strict=True)
    return {str(name): entry.validate_python(json.loads(str(text))).build() for name, text in texts}


def name_ring(supports: xr.Dataset, radius: float) -> str:
    """Name of the ring beside the supports, for a caption."""
    same = np.allclose(supports.extent, radius)
    return "a ring of the same extent" if same else "a ring"


def families(supports: Mapping[str, Any], radius: float) -> tuple[list[str], list[str]]:
    """Names of the supports on areas, and of those on points and lines, without the ring of a radius."""
    others = [name for name, support in supports.items() if support != Ring(radius)]
    areas = [name for name in others if _is_area(supports[name])]
    return areas, [name for name in others if name not in areas]


def _is_area(support: Any) -> bool:
    """Whether a support presses on an area, not only on points and lines."""
    if isinstance(support, Composite):
        return any(_is_area(member) for _, member in support.members)
    return not isinstance(support, (Ring, Points, Segment))


def curve(force: xr.DataArray, turn: float = 0.0) -> Array:
    """Points of a limit curve, turned by an angle in degrees, shape (angle, xy)."""
    angle = np.deg2rad(force.force_angle.values + turn)
    return np.asarray(force.values[:, None] * direction(angle))


def flat_parts(pivots: Array) -> list[tuple[int, slice]]:
    """Number of the support point, and slice of the curve, for every flat."""
    starts = np.flatnonzero(np.diff(pivots, prepend=-2))
    ends = [*starts[1:], len(pivots)]
    return [
        (int(pivots[start]), slice(int(start), int(stop)))
        for start, stop in zip(starts, ends, strict=True)
        if pivots[start] >= 0
    ]
