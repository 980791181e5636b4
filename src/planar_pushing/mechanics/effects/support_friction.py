"""Friction between the slider and its support, of degree 1 (Eqs. 2-3)."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Annotated, Any, ClassVar

import numpy as np

from planar_pushing.mechanics.kernels.arrays import same
from planar_pushing.mechanics.plane import Frame
from planar_pushing.mechanics.supports.base import SUPPORTS, support_in_frame
from planar_pushing.mechanics.supports.even_ring import Ring
from planar_pushing.terms.declared import positive, replace_checked, require_declared
from planar_pushing.terms.domain import Number, require_in_range, require_ratio
from planar_pushing.terms.options import EffectKind

#: The declaration of a weight.
WEIGHT = positive("leave the effect out of the scene if the support is frictionless")


@dataclass(frozen=True, slots=True, kw_only=True)
class SupportFriction:
    """Coulomb friction between the slider and its support.

    Parameters
    ----------
    support : Support, or array of supports
        Pressure of the slider on the plane.
    weight : float or array
        W = mu_s m g, the weight times the coefficient of support friction; > 0.

    Raises
    ------
    InvalidValue
        If the weight is not a positive finite number, or the support is of another type.
    """

    kind: ClassVar = EffectKind.SUPPORT_FRICTION
    support: Annotated[Any, SUPPORTS] = field(default_factory=Ring)
    weight: Annotated[Number, WEIGHT] = 1.0

    def __post_init__(self) -> None:
        require_declared(self)

    def __eq__(self, other: object) -> Any:
        return same(self, other)

    def in_frames(self, body: Frame, fence: Frame) -> SupportFriction:
        """The same effect expressed in the body frame instead of the object's frame."""
        return replace_checked(self, support=support_in_frame(self.support, body))

    @property
    def degree(self) -> int:
        return 1


@dataclass(frozen=True, slots=True, kw_only=True)
class RingFriction:
    """Coulomb friction between the ring and the plane, with uniform pressure around the ring.

    Parameters
    ----------
    weight : float or array
        W = mu_s m g, the weight times the coefficient of support friction; > 0.

    Raises
    ------
    InvalidValue
        If the weight is not a positive finite number.
    """

    kind: ClassVar = EffectKind.SUPPORT_FRICTION
    weight: Annotated[Number, WEIGHT] = 1.0

    def __post_init__(self) -> None:
        require_declared(self)

    def __eq__(self, other: object) -> Any:
        return same(self, other)

    @property
    def support(self) -> Ring:
        """A ring with the slider's radius."""
        return Ring()

    @property
    def degree(self) -> int:
        return 1


def weight(mass: Number, support_friction: Number, gravity: Number = 9.80665) -> Number:
    """W = mu_s m g, the weight times the coefficient of support friction.

    The `weight` of `SupportFriction`: the force that slides an object over the table in pure translation.

    Parameters
    ----------
    mass : float or array
        m > 0, in kilograms.
    support_friction : float or array
        mu_s > 0, the coefficient of friction between the object and the table.
    gravity : float or array
        g > 0, in meters per second squared; by default standard gravity.

    Returns
    -------
    float or array
        W, in newtons.

    Raises
    ------
    InvalidValue
        If a number, or their product, is not positive and finite.
    """
    mass = require_in_range("mass", mass)
    coefficient = require_in_range("support_friction", support_friction)
    with np.errstate(over="ignore", under="ignore"):
        force = mass * coefficient * require_in_range("gravity", gravity)
    return require_ratio("weight", force)
