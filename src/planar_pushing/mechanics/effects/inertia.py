"""Inertia: the quadratic potential of a mass that starts from rest (Eqs. 8-10)."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.errors import InvalidValue, require_positive
from planar_pushing.mechanics.planar import LONGEST, Array


@dataclass(frozen=True, slots=True, kw_only=True)
class Inertia:
    """Inertia of the slider: ``m (v^2 + rho^2 omega^2) / 2``.

    Parameters
    ----------
    mass : float
        m > 0.
    gyration_radius : float
        rho > 0 about the ring centre, in the unit of the slider's lengths.

    Raises
    ------
    InvalidValue
        Where a parameter is not a positive finite number.
    """

    mass: float = 1.0
    gyration_radius: float = 1.0

    def __post_init__(self) -> None:
        remedy = "leave the effect out of the scene if the slider has no inertia"
        require_positive("mass", self.mass, remedy)
        require_positive("gyration_radius", self.gyration_radius, remedy)

    @property
    def degree(self) -> int:
        return 2

    @property
    def kinks(self) -> tuple[float, ...]:
        return ()

    def scaled(self, length: float, force: float = 1.0) -> Inertia:
        ratio = float(self.gyration_radius) / float(length)
        if not 1 / LONGEST <= ratio <= LONGEST:
            raise InvalidValue(
                "gyration_radius", self.gyration_radius,
                f"{1 / LONGEST:g} to {LONGEST:g} times the slider's radius",
                "the square of this ratio leaves the doubles: model a point mass or a longer rod",
            )  # fmt: skip
        return replace(self, mass=self.mass / force, gyration_radius=ratio)

    def potential(self, twist: Array) -> Array:
        return np.asarray((twist * self.wrench(twist)).sum(axis=-1) / 2)

    def wrench(self, twist: Array) -> Array:
        return np.asarray(self.mass * (twist * np.array([1.0, 1.0, self.gyration_radius**2])))

    def profile(self, spin_ratio: npt.ArrayLike) -> tuple[Array, Array]:
        spin_ratio = np.asarray(spin_ratio, dtype=float)
        torque = self.mass * (self.gyration_radius**2 * spin_ratio)
        return np.full_like(spin_ratio, self.mass), torque

    def spin_ratio(self, moment_arm: npt.ArrayLike) -> Array:
        return np.asarray(np.divide(moment_arm, self.gyration_radius**2))
