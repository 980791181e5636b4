"""A uniform line of pressure: the edge of a tilted box, a blade."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated, Any

import numpy as np

from planar_pushing.mechanics.plane import Frame, position_in_frame
from planar_pushing.mechanics.pressure.pieces import Pieces
from planar_pushing.mechanics.supports.base import POSITION, InPieces, require_size
from planar_pushing.terms.declared import require_declared
from planar_pushing.terms.errors import InvalidValue


@dataclass(frozen=True, slots=True)
class Segment(InPieces):
    """Support on a straight line, with uniform pressure.

    Parameters
    ----------
    start, end : pair of float
        Ends in the body frame.

    Raises
    ------
    InvalidValue
        If an end is not a pair of finite numbers, or both ends coincide.
    """

    start: Annotated[Any, POSITION]
    end: Annotated[Any, POSITION]

    def __post_init__(self) -> None:
        require_declared(self)
        if self.start == self.end:
            raise InvalidValue(
                "end", self.end, "a position other than the start",
                "use Points for a support on one point",
            )  # fmt: skip
        require_size("end", math.dist(self.start, self.end))

    def in_frame(self, frame: Frame) -> Segment:
        """The same line expressed in another frame."""
        return Segment(position_in_frame(self.start, frame), position_in_frame(self.end, frame))

    def pieces(self) -> Pieces:
        return Pieces(segments=np.array([[*self.start, *self.end, 1.0]]))
