"""The supports that claims about any slider are checked on: a gallery, and random ones."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import cache
from typing import Any

import numpy as np

from planar_pushing.evidence.claims.proofs.verdicts import Evidence, on_grid
from planar_pushing.mechanics.contact import InfiniteFriction
from planar_pushing.mechanics.effects import SupportFriction
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene, Slider
from planar_pushing.mechanics.supports import (
    Composite,
    Disc,
    Points,
    Polygon,
    PressureMap,
    Ring,
    Segment,
)
from planar_pushing.mechanics.supports.base import Support
from planar_pushing.mechanics.supports.pressure.table import extents_of

#: Seed of the random supports, so that every run has the same.
SEED = 1995
#: Rods of random supports: decades of their length over the support's reach, and their angles.
DECADES, ROD_ANGLES = (-1.0, 1.0), (0.05, np.pi - 0.05)


def _even(count: int) -> Array:
    """Even directions, the first along the rod."""
    turn = 2 * np.pi * np.arange(count) / count
    return np.column_stack([np.cos(turn), np.sin(turn)])


def _rectangle(long: float, short: float) -> Polygon:
    return Polygon([(-long, -short), (long, -short), (long, short), (-long, short)])


#: Supports that their mirror image about the rod's line equals.
SYMMETRIC: dict[str, Support] = {
    "ring": Ring(1.0),
    "disc": Disc(1.0),
    "square": _rectangle(1.0, 1.0),
    "rectangle 2:1": _rectangle(2.0, 1.0),
    "rectangle 4:1": _rectangle(4.0, 1.0),
    "tripod": Points(_even(3), np.ones(3)),
    "quadruped": Points([(1, 1), (-1, 1), (-1, -1), (1, -1)], np.ones(4)),
    "segment across": Segment((0.0, -1.0), (0.0, 1.0)),
    "segment along": Segment((-1.0, 0.0), (1.0, 0.0)),
}
#: An L of two equal legs about its center of pressure: no line along or across a leg mirrors it.
L_SHAPE = Polygon([(-5, -5), (7, -5), (7, 1), (1, 1), (1, 7), (-5, 7)])
GALLERY = SYMMETRIC | {
    "L": L_SHAPE,
    "pressure map": PressureMap([-1, 0, 1], [-1, 0, 1], [[1, 2], [3, 6]]),
}


def stacked(supports: Iterable[Support]) -> Any:
    """Supports as an array with one more axis, for rods to be broadcast along."""
    members = list(supports)
    found = np.empty((len(members), 1), dtype=object)
    found[:, 0] = members
    return found


def everywhere(holds: Any, names: Iterable[object], method: str) -> Evidence:
    """Evidence for what holds for each support, and for each rod and angle behind it."""
    listed = list(names)
    wrong = [", ".join(map(str, [listed[i], *rest])) for i, *rest in np.argwhere(~holds)]
    return on_grid(wrong, holds.size, method)


def reach(supports: Any) -> Array:
    """Largest distance of each support from its center of pressure."""
    return extents_of(supports[:, 0])[:, None]


def touched(supports: Any, length: Any, angle: Any) -> Scene:
    """Sliders on these supports, under infinite friction; lengths in units of the support's reach."""
    slider = Slider(rod_length=reach(supports) * length, rod_angle=angle)
    effects = (SupportFriction(support=supports),)
    return Scene(slider=slider, contact=InfiniteFriction(), effects=effects)


@cache
def random_supports(count: int) -> Any:
    """Points, segments, polygons, and mixtures of them, at random."""
    random = np.random.default_rng(SEED)
    kinds = [_points] * 5 + [_segment] * 2 + [_polygon] + [_mixture] * 2
    return stacked(kinds[i % len(kinds)](random) for i in range(count))


def random_scenes(supports: Any, contacts: int) -> Scene:
    """Each support touched at random places, from random sides."""
    random = np.random.default_rng(SEED)
    shape = len(supports), contacts
    return touched(
        supports, 10 ** random.uniform(*DECADES, shape), random.uniform(*ROD_ANGLES, shape)
    )


Random = np.random.Generator


def _points(random: Random) -> Points:
    count = int(random.integers(2, 7))
    return Points(random.uniform(-1, 1, (count, 2)), random.uniform(0.05, 1, count))


def _segment(random: Random) -> Segment:
    return Segment(random.uniform(-1, 1, 2), random.uniform(-1, 1, 2))


def _polygon(random: Random) -> Polygon:
    """Vertices around a place at random distances: simple, and seldom convex."""
    corners = _even(int(random.integers(3, 8)))
    return Polygon(random.uniform(-1, 1, 2) + corners * random.uniform(0.2, 1, (len(corners), 1)))


def _mixture(random: Random) -> Composite:
    makes: list[Callable[[Random], Support]] = [_points, _segment, _disc]
    return Composite(
        [
            (share, make(random))
            for share, make in zip(random.uniform(0.1, 1, 3), makes, strict=True)
        ]
    )


def _disc(random: Random) -> Disc:
    return Disc(random.uniform(0.1, 1), random.uniform(-1, 1, 2))
