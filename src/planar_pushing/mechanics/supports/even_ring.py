"""A uniform ring, anywhere on the slider."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any

import numpy as np

from planar_pushing.mechanics.pictures import Pictured
from planar_pushing.mechanics.plane import Frame, position_in_frame
from planar_pushing.mechanics.pressure.pieces import Pieces
from planar_pushing.mechanics.supports.base import POSITION, Position, a_length
from planar_pushing.terms.declared import replace_checked, require_declared
from planar_pushing.terms.errors import InvalidValue


@dataclass(frozen=True, slots=True)
class Ring(Pictured):
    """Support on a ring, with uniform pressure; by default the paper's, about the slider's center.

    Parameters
    ----------
    radius : float, optional
        Greater than 0; by default the slider's radius.
    center : pair of float, optional
        In the body frame; by default the slider's center.

    Raises
    ------
    InvalidValue
        If the radius is not positive, or a center is given without a radius.
    """

    radius: Annotated[float | None, a_length("use Points for a support on one point")] = None
    center: Annotated[Any, POSITION] = None

    def __post_init__(self) -> None:
        require_declared(self)
        if self.center is not None and self.radius is None:
            raise InvalidValue(
                "radius", None, "a radius if a center is given", "give the radius, as in Ring(1.0)"
            )
        if self.center == (0.0, 0.0):
            object.__setattr__(self, "center", None)

    @property
    def center_of_pressure(self) -> Position:
        return (0.0, 0.0) if self.center is None else self.center

    @property
    def extent(self) -> float:
        """The radius; without one, 1: the slider's radius is then the unit of length."""
        return 1.0 if self.radius is None else self.radius

    def in_frame(self, frame: Frame) -> Ring:
        """The same ring expressed in another frame."""
        if self.radius is None:
            raise InvalidValue(
                "radius", None, "a ring with a radius", "give the radius, as in Ring(1.0)"
            )
        center = position_in_frame(self.center_of_pressure, frame)
        return replace_checked(self, center=None if center == (0.0, 0.0) else center)

    def pieces(self) -> Pieces:
        return Pieces(rings=np.array([[*self.center_of_pressure, self.extent, 1.0]]))
