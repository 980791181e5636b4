"""Points that carry weight: the feet of a table, a tripod."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Any

import numpy as np

from planar_pushing.mechanics.plane import Frame, positions_in_frame
from planar_pushing.mechanics.pressure.pieces import Pieces
from planar_pushing.mechanics.supports.base import (
    POSITIONS,
    WEIGHTS,
    InPieces,
    require_count,
)
from planar_pushing.mechanics.supports.layouts import (
    disc_places,
    placed_corners,
    rectangle_corners,
    regular_corners,
)
from planar_pushing.terms.declared import Read, replace_checked, require_declared
from planar_pushing.terms.errors import InvalidValue


def _names(name: str, value: Any) -> tuple[str, ...]:
    """Distinct names."""
    names = tuple(value) if isinstance(value, (list, tuple)) else ()
    if not names or not all(isinstance(entry, str) and entry for entry in names):
        raise InvalidValue(name, value, "names of the points", "give a name for each, or none")
    if len(set(names)) < len(names):
        raise InvalidValue(name, value, "distinct names", "give each point its own name")
    return names


NAMES = Read(
    _names, "a name for each point", {"type": "array", "minItems": 1, "items": {"type": "string"}}
)


@dataclass(frozen=True, slots=True)
class Points(InPieces):
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

    positions: Annotated[Any, POSITIONS]
    weights: Annotated[Any, WEIGHTS] = None
    names: Annotated[Any, NAMES] = None

    def __post_init__(self) -> None:
        if isinstance(self.positions, Mapping):
            object.__setattr__(self, "names", list(self.positions))
            object.__setattr__(self, "positions", list(self.positions.values()))
        require_declared(self)
        count = len(self.positions)
        if self.weights is None:
            object.__setattr__(self, "weights", (1.0,) * count)
        require_count("weights", self.weights, count, "weight")
        if self.names is not None:
            require_count("names", self.names, count, "name")

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

    def in_frame(self, frame: Frame) -> Points:
        """The same points expressed in another frame."""
        return replace_checked(self, positions=positions_in_frame(self.positions, frame))

    def pieces(self) -> Pieces:
        loads = np.array(self.weights)
        atoms = np.empty((len(loads), 3))
        atoms[:, :2], atoms[:, 2] = self.positions, loads / loads.sum()
        return Pieces(atoms=atoms)
