"""Friction of a ring on the support: a convex potential in closed form (Eqs. 2-3)."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt
import scipy

from planar_pushing.mechanics.effects.base import isotropic_wrench
from planar_pushing.mechanics.effects.ring_inverse import ring_spin_ratio
from planar_pushing.mechanics.effects.ring_profile import ring_profile
from planar_pushing.mechanics.errors import require_positive
from planar_pushing.mechanics.planar import Array


@dataclass(frozen=True, slots=True, kw_only=True)
class RingFriction:
    """Coulomb friction between the ring and the support, its pressure even around the ring.

    Parameters
    ----------
    weight : float
        W > 0: the slider's weight times the coefficient of support friction.

    Raises
    ------
    InvalidValue
        Where the weight is not a positive finite number.
    """

    weight: float = 1.0

    def __post_init__(self) -> None:
        require_positive(
            "weight",
            self.weight,
            "leave the effect out of the scene if the support is frictionless",
        )

    @property
    def degree(self) -> int:
        return 1

    @property
    def kinks(self) -> tuple[float, ...]:
        return (1.0,)

    def scaled(self, length: float, force: float = 1.0) -> RingFriction:
        return replace(self, weight=self.weight / force)

    def potential(self, twist: Array) -> Array:
        """``(2 W / pi) (|v| + R |omega|) E(m)``, ``m = 4 |v| R |omega| / (|v| + R |omega|)^2``."""
        speed, spin = np.hypot(twist[..., 0], twist[..., 1]), np.abs(twist[..., 2])
        total = speed + spin
        share = np.divide(speed, total, out=np.ones_like(total), where=total > 0)
        return np.asarray(
            2 / np.pi * self.weight * total * scipy.special.ellipe(4 * share * (1 - share))
        )

    def wrench(self, twist: Array) -> Array:
        return isotropic_wrench(self, twist)

    def profile(self, spin_ratio: npt.ArrayLike) -> tuple[Array, Array]:
        force, torque = ring_profile(spin_ratio)
        return self.weight * force, self.weight * torque

    def spin_ratio(self, moment_arm: npt.ArrayLike) -> Array:
        return ring_spin_ratio(moment_arm)
