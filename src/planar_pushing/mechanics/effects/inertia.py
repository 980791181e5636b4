"""Inertia: the quadratic potential of a mass that starts from rest (Eqs. 8-10)."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, NamedTuple

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.effects.base import (
    Resistance,
    moment_of,
    no_place,
    no_points,
    no_pull,
)
from planar_pushing.mechanics.frames import Frame, moved_place
from planar_pushing.mechanics.numerics.arrays import same
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


class Mass(NamedTuple):
    """A mass in the compiled core, with its squared radius of gyration and its center in the body frame."""

    mass: float
    gyration: float
    x: float
    y: float


#: Degree of homogeneity.
DEGREE = 2


@compiled
def made(effect, row, i):
    return Mass(row[i], row[i + 1], row[i + 2], row[i + 3])


@compiled
def count_fields(effect):
    return 4


@compiled
def scaled(effect, one, two):
    return Mass(two * effect.mass, effect.gyration, effect.x, effect.y)


@compiled
def resistance(effect, x, y, spin, blur):
    mass, gyration, own_x, own_y = effect
    f_x, f_y = mass * (x - spin * own_y), mass * (y + spin * own_x)
    torque = mass * gyration * spin + own_x * f_y - own_y * f_x
    whole = mass * (gyration + own_x * own_x + own_y * own_y)
    return Resistance(
        f_x,
        f_y,
        torque,
        mass,
        0.0,
        mass,
        -mass * own_y,
        mass * own_x,
        whole,
        0.0,
        -1,
        mass * abs(spin) * (abs(own_x) + abs(own_y)),
    )


@compiled
def moment(effect, speed, x, y):
    return moment_of(effect.mass, effect.gyration, effect.x - x, effect.y - y)


@compiled
def energy(effect, x, y, spin):
    v_x, v_y = x - spin * effect.y, y + spin * effect.x
    return effect.mass * (v_x * v_x + v_y * v_y + effect.gyration * spin * spin) / 2.0


count_points, place, pull = no_points, no_place, no_pull
