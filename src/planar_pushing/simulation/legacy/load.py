"""A load in the plane: a constant wrench."""

from __future__ import annotations

from typing import NamedTuple

from planar_pushing.simulation.legacy.base import Moment, Resistance, no_energy, no_place, no_points
from planar_pushing.simulation.legacy.compiled import compiled


class Wrench(NamedTuple):
    """A constant wrench about the origin, in the body frame."""

    x: float
    y: float
    torque: float


#: Degree of homogeneity.
DEGREE = 1


@compiled
def made(effect, row, i):
    return Wrench(row[i], row[i + 1], row[i + 2])


@compiled
def count_fields(effect):
    return 3


@compiled
def resistance(effect, x, y, spin, blur):
    return Resistance(
        -effect.x, -effect.y, -effect.torque, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1, 0.0
    )


@compiled
def moment(effect, speed, x, y):
    return Moment(0.0, 0.0, 0.0, 0.0)


@compiled
def pull(effect):
    return effect.x, effect.y, effect.torque


count_points, place, energy = no_points, no_place, no_energy
