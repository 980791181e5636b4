"""Inertia: the quadratic potential of a mass that starts from rest (Eqs. 8-10)."""

from __future__ import annotations

from typing import NamedTuple

from planar_pushing.simulation.legacy.base import (
    Resistance,
    moment_of,
    no_place,
    no_points,
    no_pull,
)
from planar_pushing.simulation.legacy.compiled import compiled


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
