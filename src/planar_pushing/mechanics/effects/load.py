"""A load in the plane: gravity on a tilted table, for instance."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar

from planar_pushing.mechanics.kernels.arrays import same
from planar_pushing.mechanics.plane import Frame, position_in_frame, vector_in_frame
from planar_pushing.terms.declared import Pair, finite, replace_checked, require_declared
from planar_pushing.terms.numbers import Number
from planar_pushing.terms.options import EffectKind


@dataclass(frozen=True, slots=True, kw_only=True)
class Load:
    """A constant force at a point of the slider: potential ``-g . v``, with v the point's velocity.

    Parameters
    ----------
    force : (x, y), of floats or arrays
        g, along and normal to the fence at time 0; its direction in the world is constant.
    center : (x, y), of floats or arrays, optional
        The point in the body frame; by default the center of mass, or without inertia the slider's center.

    Raises
    ------
    InvalidValue
        If the force or the center is not two finite numbers.
    """

    kind: ClassVar = EffectKind.LOAD
    force: Annotated[tuple[Number, Number], Pair(finite("give its components along x and y"))]
    center: Annotated[
        tuple[Number, Number] | None, Pair(finite("give x and y in the body frame"))
    ] = None

    def __post_init__(self) -> None:
        require_declared(self)

    def __eq__(self, other: object) -> Any:
        return same(self, other)

    def in_frames(self, body: Frame, fence: Frame) -> Load:
        """The same effect, with force in the fence frame and center in the body frame."""
        force = vector_in_frame(self.force, fence)
        center = None if self.center is None else position_in_frame(self.center, body)
        return replace_checked(self, force=force, center=center)

    @property
    def degree(self) -> int:
        return 1
