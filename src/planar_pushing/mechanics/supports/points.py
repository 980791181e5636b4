"""Points that carry weight: the feet of a table, a tripod."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from planar_pushing.mechanics.frames import Frame
from planar_pushing.mechanics.pictures import Pictured
from planar_pushing.mechanics.pressure.assembly import center, extent
from planar_pushing.mechanics.pressure.pieces import Pieces
from planar_pushing.mechanics.supports.base import Position, positions, weights
from planar_pushing.mechanics.supports.layouts import (
    disc_places,
    placed_corners,
    rectangle_corners,
    regular_corners,
)
from planar_pushing.terms.errors import InvalidValue, number_of


@dataclass(frozen=True, slots=True)
class Points(Pictured):
    """Support on points.

    Parameters
    ----------
    positions : sequence of pairs, or a mapping of names to pairs
        Points in the body frame. Points at the same place act as one.
    weights : sequence of float, optional
        Load on each point, > 0, in any unit; equal by default.
    names : sequence of str, optional
        A name for each point, which the command line prints for a pivot.

    Raises
    ------
    InvalidValue
        If there is no point, a number is not finite, or a weight is missing or not positive.
    """

    positions: Any
    weights: Any = None
    names: Any = None

    def __post_init__(self) -> None:
        remedy = "give x and y of each point in the body frame"
        named = isinstance(self.positions, Mapping)
        given = list(self.positions.values()) if named else self.positions
        places = positions("positions", given, remedy)
        if not places:
            raise InvalidValue("positions", self.positions, "at least one point", remedy)
        shares = [1.0] * len(places) if self.weights is None else self.weights
        loads = weights("weights", shares, len(places), "give one weight for each point")
        names = _names(list(self.positions) if named else self.names, len(places))
        object.__setattr__(self, "positions", places)
        object.__setattr__(self, "weights", loads)
        object.__setattr__(self, "names", names)

    @classmethod
    def rectangle(
        cls, width: float, height: float, center: Any = (0.0, 0.0), angle: float = 0.0
    ) -> Points:
        """Four equal feet at the corners of a rectangle whose width is at an angle from x, in radians."""
        return cls(placed_corners(rectangle_corners(width, height), center, angle))

    @classmethod
    def regular(
        cls, count: int, radius: float, center: Any = (0.0, 0.0), angle: float = 0.0
    ) -> Points:
        """Equal feet at the corners of a regular polygon, the first at an angle from x, in radians."""
        return cls(placed_corners(regular_corners(count, radius), center, angle))

    @classmethod
    def disc(cls, rings: int, radius: float, center: Any = (0.0, 0.0)) -> Points:
        """Equal feet spread evenly over a disc: one at the center and rings of 6, 12, 18, ... around it."""
        return cls(placed_corners(disc_places(rings, radius), center, 0.0))

    def moved(self, frame: Frame) -> Points:
        """The same points expressed in another frame."""
        return replace(self, positions=frame.point_in(self.positions) + 0.0)

    @property
    def center_of_pressure(self) -> Position:
        return center(self.pieces())

    @property
    def extent(self) -> float:
        return extent(self.pieces())

    def pieces(self) -> Pieces:
        loads = np.array(self.weights)
        return Pieces(atoms=np.column_stack([self.positions, loads / loads.sum()]))


def _names(given: Any, count: int) -> tuple[str, ...] | None:
    """A name for each point, or None."""
    if given is None:
        return None
    names = tuple(given) if isinstance(given, (list, tuple)) else ()
    if len(names) != count or not all(isinstance(each, str) and each for each in names):
        raise InvalidValue(
            "names", given, number_of(count, "name"), "give a name for each point, or none"
        )
    if len(set(names)) < count:
        raise InvalidValue("names", given, "distinct names", "give each point its own name")
    return names
