"""Random supports with random contacts on which the library is checked; the same in every run."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np

from planar_pushing.mechanics.contact import InfiniteFriction
from planar_pushing.mechanics.effects import SupportFriction
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene, Slider
from planar_pushing.mechanics.supports import Composite, Disc, Points, Polygon, Segment
from planar_pushing.mechanics.supports.base import Support
from planar_pushing.mechanics.supports.pressure.table import extents_of

SEED = 1995
#: Ranges of the rods: decimal logarithm of the length over the support's extent, and angle in radians.
DECADES, ROD_ANGLES = (-1.0, 1.0), (0.05, np.pi - 0.05)

Random = np.random.Generator


@cache
def random_supports(count: int) -> Any:
    """Points, segments, polygons, and mixtures of them, with a second axis for the contacts."""
    random = np.random.default_rng(SEED)
    kinds = [_points] * 5 + [_segment] * 2 + [_polygon] + [_mixture] * 2
    found = np.empty((count, 1), dtype=object)
    found[:, 0] = [kinds[i % len(kinds)](random) for i in range(count)]
    return found


def random_scenes(supports: Any, contacts: int) -> Scene:
    """Each support with random contacts, under infinite friction."""
    random, shape = np.random.default_rng(SEED), (len(supports), contacts)
    lengths, angles = 10 ** random.uniform(*DECADES, shape), random.uniform(*ROD_ANGLES, shape)
    slider = Slider(rod_length=extent(supports) * lengths, rod_angle=angles)
    effects = (SupportFriction(support=supports),)
    return Scene(slider=slider, contact=InfiniteFriction(), effects=effects)


def extent(supports: Any) -> Array:
    """Largest distance of each support from its center of pressure."""
    return extents_of(supports[:, 0])[:, None]


def _points(random: Random) -> Points:
    count = int(random.integers(2, 7))
    return Points(random.uniform(-1, 1, (count, 2)), random.uniform(0.05, 1, count))


def _segment(random: Random) -> Segment:
    return Segment(random.uniform(-1, 1, 2), random.uniform(-1, 1, 2))


def _polygon(random: Random) -> Polygon:
    """Vertices around a point at random distances: simple, and rarely convex."""
    count = int(random.integers(3, 8))
    turn = 2 * np.pi * np.arange(count) / count
    corners = np.column_stack([np.cos(turn), np.sin(turn)])
    return Polygon(random.uniform(-1, 1, 2) + corners * random.uniform(0.2, 1, (count, 1)))


def _mixture(random: Random) -> Composite:
    makes: list[Callable[[Random], Support]] = [_points, _segment, _disc]
    shares = random.uniform(0.1, 1, len(makes))
    return Composite([(share, make(random)) for share, make in zip(shares, makes, strict=True)])


def _disc(random: Random) -> Disc:
    return Disc(random.uniform(0.1, 1), random.uniform(-1, 1, 2))
