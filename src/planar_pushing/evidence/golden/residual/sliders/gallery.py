"""The supports of a study as exact pieces, and the motions at the edges of its friction cones."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from typing import Any, NamedTuple

import numpy as np
import xarray as xr
from flint import arb, fmpq

from planar_pushing.certified.balls import rational
from planar_pushing.certified.effects.cone_edges import Edge, edge, pivot_load
from planar_pushing.certified.supports.pressure.pieces import Pieces, pieces

#: Sign of an edge of a cone, by its name in the datasets.
SIDES = {"right": 1, "left": -1}
#: Axes of the rods.
ROD = ("rod_length", "rod_angle")
#: Relative difference of the square of a point's force from that of its share that rounding explains.
OPEN = 2e-12


class Rod(NamedTuple):
    """A support on a rod, and its place in the grid."""

    place: tuple[int, ...]
    support: Pieces
    length: fmpq
    angle: fmpq


def gallery(study: Any) -> dict[str, Pieces]:
    """Supports of a study, by name."""
    return {name: pieces(entry.model_dump()) for name, entry in study.supports.items()}


def rods(dataset: xr.Dataset, study: Any) -> Iterator[Rod]:
    """Every support on every rod of a dataset."""
    supports = gallery(study)
    axes = [dataset[name].values for name in ("support", *ROD)]
    for place in product(*(range(len(axis)) for axis in axes)):
        name, length, angle = (axis[i] for axis, i in zip(axes, place, strict=True))
        yield Rod(place, supports[str(name)], rational(length), rational(angle))


def edges(rod: Rod, friction: float) -> dict[int, Edge]:
    """The motions at both edges, by their signs."""
    return {side: edge(*rod[1:], float(friction), side) for side in SIDES.values()}


def expected_pivot(rod: Rod, friction: float, side: int, stored: int) -> int:
    """Number of the point that an edge pivots about; the stored one where rounding leaves it open."""
    found = edge(*rod[1:], float(friction), side).moved.pivot
    number = max(found, int(stored))
    if found == stored or number >= len(rod.support.points):
        return found
    load = pivot_load(*rod[1:], float(friction), side, number)
    return int(stored) if load is not None and abs(load - 1) < OPEN else found


def gap(stored: float, ball: arb) -> float:
    """Difference of a double from a ball's middle."""
    return abs(float(arb(float(stored)) - ball.mid())) if np.isfinite(stored) else np.inf
