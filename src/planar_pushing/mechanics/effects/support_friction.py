"""Friction between the slider and its support, of degree 1 (Eqs. 2-3)."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from planar_pushing.mechanics.arrays import same
from planar_pushing.mechanics.frames import Frame
from planar_pushing.mechanics.pressure.support_in_frames import SupportInFrames, listed
from planar_pushing.mechanics.supports.base import is_kind, moved_support
from planar_pushing.mechanics.supports.even_ring import Ring
from planar_pushing.terms.domain import Number, require_fields, required, required_ratio
from planar_pushing.terms.errors import InvalidValue


@dataclass(frozen=True, slots=True, kw_only=True)
class SupportFriction:
    """Coulomb friction between the slider and its support.

    Parameters
    ----------
    support : Support, or array of supports
        Pressure of the slider on the plane: `Ring`, `Points`, `Segment`, `Disc`, `Annulus`, `Polygon`,
        `PressureMap` or `Composite`.
    weight : float or array
        W = mu_s m g, the weight times the coefficient of support friction; > 0.

    Raises
    ------
    InvalidValue
        If the weight is not a positive finite number, or the support is of another type.
    """

    support: Any = field(default_factory=Ring)
    weight: Number = 1.0

    def __post_init__(self) -> None:
        require_fields(self, "weight")
        own = self.support
        supports = [own.support] if isinstance(own, SupportInFrames) else listed(own)
        if not len(supports) or not all(map(is_kind, map(type, supports))):
            raise InvalidValue(
                "support", self.support,
                "Ring, Points, Segment, Disc, Annulus, Polygon, PressureMap or Composite",
                "construct one of these supports",
            )  # fmt: skip

    def __eq__(self, other: object) -> Any:
        return same(self, other)

    def moved(self, body: Frame, fence: Frame) -> SupportFriction:
        """The same effect expressed in the body frame instead of the object's frame."""
        return replace(self, support=moved_support(self.support, body))

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

    weight: Number = 1.0

    def __post_init__(self) -> None:
        require_fields(self, "weight")

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
    own, coefficient = required("mass", mass), required("support_friction", support_friction)
    with np.errstate(over="ignore", under="ignore"):
        force = own * coefficient * required("gravity", gravity)
    return required_ratio("weight", force)
