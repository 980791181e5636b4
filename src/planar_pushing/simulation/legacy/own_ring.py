"""Friction of the slider's own ring in the compiled core, in closed form (Eqs. 2-3)."""

from __future__ import annotations

from math import sqrt
from typing import NamedTuple

from planar_pushing.simulation.legacy.base import (
    Resistance,
    moment_of,
    no_energy,
    no_place,
    no_points,
    no_pull,
)
from planar_pushing.simulation.legacy.compiled import compiled
from planar_pushing.simulation.legacy.ring import ring_response

#: Degree of homogeneity.
DEGREE = 1


class RingSupport(NamedTuple):
    """Friction of a ring of unit radius about the origin."""

    weight: float


@compiled
def made(effect, row, i):
    return RingSupport(row[i])


@compiled
def count_fields(effect):
    return 1


@compiled
def resistance(effect, x, y, spin, blur):
    weight, speed = effect.weight, sqrt(x * x + y * y)
    force, torque, vv, vs, ss = ring_response(speed, spin)
    c, s, across = (x / speed, y / speed, force / speed) if speed > 0.0 else (0.0, 0.0, vv)
    bend = vv - across
    return Resistance(
        weight * across * x, weight * across * y, weight * torque,
        weight * (across + bend * c * c), weight * bend * c * s, weight * (across + bend * s * s),
        weight * vs * c, weight * vs * s, weight * ss, 0.0, -1, 0.0,
    )  # fmt: skip


@compiled
def moment(effect, speed, x, y):
    return moment_of(effect.weight / speed, 1.0, -x, -y)


count_points, place, pull, energy = no_points, no_place, no_pull, no_energy
