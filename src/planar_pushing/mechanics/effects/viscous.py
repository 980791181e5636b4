"""Viscous support friction: a thin film of oil, or friction that grows with speed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar

from planar_pushing.mechanics.kernels.arrays import same
from planar_pushing.mechanics.plane import Frame
from planar_pushing.mechanics.supports.base import SUPPORT, support_in_frame
from planar_pushing.terms.declared import positive, replace_checked, require_declared
from planar_pushing.terms.numbers import Number
from planar_pushing.terms.options import EffectKind


@dataclass(frozen=True, slots=True, kw_only=True)
class Viscous:
    """Friction proportional to the speed of each support point: potential ``c <v^2> / 2`` (support mean).

    It resists velocities. It is therefore absent in a push from rest of a slider with inertia, which has no
    velocity yet.

    Parameters
    ----------
    support : Support
        Pressure of the slider on the plane.
    coefficient : float or array
        c > 0: force divided by speed in a translation.

    Raises
    ------
    InvalidValue
        If the coefficient is not a positive finite number, or the support is of another type.
    """

    kind: ClassVar = EffectKind.VISCOUS
    support: Annotated[Any, SUPPORT]
    coefficient: Annotated[
        Number, positive("leave the effect out of the scene if nothing is viscous")
    ] = 1.0

    def __post_init__(self) -> None:
        require_declared(self)

    def __eq__(self, other: object) -> Any:
        return same(self, other)

    def in_frames(self, body: Frame, fence: Frame) -> Viscous:
        """The same effect expressed in the body frame instead of the object's frame."""
        return replace_checked(self, support=support_in_frame(self.support, body))

    @property
    def degree(self) -> int:
        return 2
