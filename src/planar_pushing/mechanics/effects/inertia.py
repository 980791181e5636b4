"""Inertia: the quadratic potential of a mass that starts from rest (Eqs. 8-10)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.effects.base import GYRATION, MASS
from planar_pushing.terms.domain import Number, require_fields, required
from planar_pushing.terms.errors import InvalidValue


@dataclass(frozen=True, slots=True, kw_only=True)
class Inertia:
    """Inertia of the slider: ``m (v^2 + rho^2 omega^2) / 2``.

    Parameters
    ----------
    mass : float or array
        m > 0.
    gyration_radius : float or array
        rho > 0 about the centre of mass, in the unit of the slider's lengths.
    center : (x, y), of floats or arrays
        Centre of mass in the body frame: origin at the slider's centre, x along the rod and away from the
        contact.

    Raises
    ------
    InvalidValue
        Where a parameter is not a positive finite number, or the centre not two finite ones.
    """

    mass: Number = 1.0
    gyration_radius: Number = 1.0
    center: tuple[Number, Number] = (0.0, 0.0)

    def __post_init__(self) -> None:
        require_fields(self, "mass", "gyration_radius")
        if not isinstance(self.center, (tuple, list)) or len(self.center) != 2:
            raise InvalidValue(
                "center", self.center, "two finite numbers", "give x and y in the body frame"
            )
        center = tuple(required("mass_center", each) for each in self.center)
        object.__setattr__(self, "center", center)

    @property
    def degree(self) -> int:
        return 2


class Mass(NamedTuple):
    """Inertia in the compiled core: mass, and the square of the radius of gyration in radii."""

    mass: float
    gyration: float


@compiled
def response(effect, speed, spin):
    moment = effect.mass * effect.gyration
    return effect.mass * speed, moment * spin, effect.mass, 0.0, moment


@compiled
def made(effect, row):
    return Mass(row[MASS], row[GYRATION])


@compiled
def spin_ratio(effect, arm):
    return arm / effect.gyration  # Eq. (10)


@compiled
def leverages(effect):
    return effect.gyration, effect.gyration


@compiled
def scaled(effect, factor):
    return Mass(factor * effect.mass, effect.gyration)
