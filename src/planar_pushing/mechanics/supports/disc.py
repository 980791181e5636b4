"""A uniform disc: the flat base of a can."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from planar_pushing.mechanics.frames import Frame, moved_place
from planar_pushing.mechanics.pictures import Pictured
from planar_pushing.mechanics.pressure.pieces import Pieces
from planar_pushing.mechanics.supports.base import Position, length, position


@dataclass(frozen=True, slots=True)
class Disc(Pictured):
    """Support on a disc, with uniform pressure.

    Parameters
    ----------
    radius : float
        Greater than 0.
    center : pair of float
        In the body frame.

    Raises
    ------
    InvalidValue
        If the radius is not positive, or the center is not a pair of finite numbers.
    """

    radius: float
    center: Any = (0.0, 0.0)

    def __post_init__(self) -> None:
        radius = length("radius", self.radius, "use Points for a support on one point")
        object.__setattr__(self, "radius", radius)
        object.__setattr__(self, "center", position("center", self.center))

    @property
    def center_of_pressure(self) -> Position:
        return self.center  # type: ignore[no-any-return]

    @property
    def extent(self) -> float:
        return self.radius

    def moved(self, frame: Frame) -> Disc:
        """The same disc expressed in another frame."""
        return replace(self, center=moved_place(self.center, frame))

    def pieces(self) -> Pieces:
        return Pieces(discs=np.array([[*self.center, self.radius, 1.0]]))
