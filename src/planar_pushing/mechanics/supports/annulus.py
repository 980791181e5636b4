"""A uniform annulus: the rim of a cup."""

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
class Annulus(Pictured):
    """Support between two concentric circles, with uniform pressure.

    Parameters
    ----------
    inner, outer : float
        Radii, ``0 < inner < outer``.
    center : pair of float
        In the body frame.

    Raises
    ------
    InvalidValue
        If a radius is not positive, the inner one is not the smaller, or the center is not a pair of finite
        numbers.

    Notes
    -----
    The annulus is computed as the difference of two discs: its relative error is that of a disc times
    ``outer / (outer - inner)``. For a width of a thousandth of the radius that is about 1e-12, and for a
    hundred thousandth 1e-10. Use `Ring` for a rim narrower than the uncertainty of its radius.
    """

    inner: Annotated[float, a_length("use Disc for a support without a hole")]
    outer: Annotated[float, a_length("give the outer radius")]
    center: Annotated[Any, POSITION] = (0.0, 0.0)

    def __post_init__(self) -> None:
        require_declared(self)
        if self.inner >= self.outer:
            raise InvalidValue(
                "inner", self.inner, f"a number less than outer, {self.outer!r}",
                "use Ring for a rim without width",
            )  # fmt: skip

    @property
    def center_of_pressure(self) -> Position:
        return self.center  # type: ignore[no-any-return]

    @property
    def extent(self) -> float:
        return self.outer

    def in_frame(self, frame: Frame) -> Annulus:
        """The same annulus expressed in another frame."""
        return replace_checked(self, center=position_in_frame(self.center, frame))

    def pieces(self) -> Pieces:
        ratio = self.inner / self.outer
        hole = ratio * ratio / ((1.0 - ratio) * (1.0 + ratio))
        rows = [[*self.center, self.outer, 1.0 + hole], [*self.center, self.inner, -hole]]
        return Pieces(discs=np.array(rows))
