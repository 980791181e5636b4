"""Inertia of a slider whose centre of mass is anywhere, or whose support is not isotropic about it."""

from __future__ import annotations

from typing import NamedTuple

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.effects.base import GYRATION, MASS, MASS_X, MASS_Y


class MassAt(NamedTuple):
    """Mass, square of the radius of gyration about the centre of mass, and that centre, body frame."""

    mass: float
    gyration: float
    x: float
    y: float


@compiled
def made(effect, row):
    return MassAt(row[MASS], row[GYRATION], row[MASS_X], row[MASS_Y])


@compiled
def gradient(effect, x, y, spin):
    mass, gyration, own_x, own_y = effect
    f_x, f_y = mass * (x - spin * own_y), mass * (y + spin * own_x)
    torque = mass * gyration * spin + own_x * f_y - own_y * f_x
    moment = mass * (gyration + own_x * own_x + own_y * own_y)
    return f_x, f_y, torque, mass, 0.0, mass, -mass * own_y, mass * own_x, moment


@compiled
def wrench_about(effect, i, spin, c_x, c_y):
    return gradient(effect, spin * c_y, -spin * c_x, spin)[:3]


@compiled
def rough(effect):
    return effect.x, effect.y, effect.gyration


@compiled
def fastest(effect, reach):
    return 0.0


@compiled
def scaled(effect, factor):
    return MassAt(factor * effect.mass, effect.gyration, effect.x, effect.y)
