"""Inertia: the quadratic potential of a mass that starts from rest (Eqs. 8-10)."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from planar_pushing.mechanics.arrays import same
from planar_pushing.mechanics.frames import Frame, moved_place
from planar_pushing.terms.domain import Number, require_fields, required
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.numbers import pair_of


@dataclass(frozen=True, slots=True, kw_only=True)
class Inertia:
    """Inertia of the slider: ``m (v^2 + rho^2 omega^2) / 2``.

    Parameters
    ----------
    mass : float or array
        m > 0.
    gyration_radius : float or array
        rho > 0 about the center of mass, in the unit of the slider's lengths.
    center : (x, y), of floats or arrays
        Center of mass in the body frame: origin at the slider's center, x along the rod and away from the
        contact.

    Raises
    ------
    InvalidValue
        If a parameter is not a positive finite number, or the center is not two finite numbers.
    """

    mass: Number = 1.0
    gyration_radius: Number = 1.0
    center: tuple[Number, Number] = (0.0, 0.0)

    def __post_init__(self) -> None:
        require_fields(self, "mass", "gyration_radius")
        center = pair_of(self.center)
        if center is None:
            raise InvalidValue(
                "center", self.center, "two finite numbers", "give x and y in the body frame"
            )
        center = tuple(required("mass_center", each) for each in center)
        object.__setattr__(self, "center", center)

    def __eq__(self, other: object) -> Any:
        return same(self, other)

    def moved(self, body: Frame, fence: Frame) -> Inertia:
        """The same effect expressed in the body frame instead of the object's frame."""
        return replace(self, center=moved_place(self.center, body))

    @property
    def degree(self) -> int:
        return 2
