"""A uniform disc: the flat base of a can."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any

import numpy as np

from planar_pushing.mechanics.pictures import Pictured
from planar_pushing.mechanics.plane import Frame, position_in_frame
from planar_pushing.mechanics.pressure.pieces import Pieces
from planar_pushing.mechanics.supports.base import POSITION, Position, a_length
from planar_pushing.terms.declared import replace_checked, require_declared


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

    radius: Annotated[float, a_length("use Points for a support on one point")]
    center: Annotated[Any, POSITION] = (0.0, 0.0)

    def __post_init__(self) -> None:
        require_declared(self)

    @property
    def center_of_pressure(self) -> Position:
        return self.center  # type: ignore[no-any-return]

    @property
    def extent(self) -> float:
        return self.radius

    def in_frame(self, frame: Frame) -> Disc:
        """The same disc expressed in another frame."""
        return replace_checked(self, center=position_in_frame(self.center, frame))

    def pieces(self) -> Pieces:
        return Pieces(discs=np.array([[*self.center, self.radius, 1.0]]))
