"""Slips of any support: the force is on an edge of the friction cone, the motion that of the edge."""

from __future__ import annotations

from typing import Any

import numpy as np

from planar_pushing.certified.effects.cone_edges import Edge
from planar_pushing.evidence.golden.residual.contact_modes.push import MODES, SLIPS, Decision
from planar_pushing.evidence.golden.residual.finding import DEGREE, EPSILON
from planar_pushing.evidence.golden.residual.sliders.gallery import Rod, edges, expected_pivot
from planar_pushing.evidence.golden.residual.sliders.table import Tables, turned

#: Roundings of an angle and of a rotation.
ANGLE, SPIN = 32, 64


def slips(pushers: Any, edge: Edge, side: int, near: float) -> Decision:
    """Where the contact moves with the fence, and over it to its side."""
    angle, radians = np.deg2rad(float(edge.angle)), np.deg2rad(pushers)
    moves = np.where((pushers == 0) | (np.abs(pushers) == 180), 0.0, np.sign(np.sin(radians)))
    normal, turn = np.sin(angle), np.sin(radians - angle)
    along = np.sign(normal) * moves > 0
    found = along & (np.sign(normal) * turn * side < 0)
    open_ = (np.abs(normal) <= near) | ((np.abs(turn) <= near) & along)
    return Decision(found, open_ & (moves != 0))


def slip_values(
    tables: Tables, rod: Rod, at: tuple[int, ...], mode: str, friction: float, pusher: float
) -> None:
    """Check the force, the motion and the rotation of a slip."""
    place, edge = (*at, MODES.index(mode)), edges(rod, friction)[SLIPS[mode]]
    angle, stored = float(edge.angle), int(tables.pivot[place])
    rounding = ANGLE * EPSILON * (1 + float(rod.length) ** 2)
    force = float(edge.force_angle)
    expected = {"force_angle": force, "force_angle_end": force, "motion_angle": angle}
    for name, wanted in expected.items():
        error = turned(tables.values[name][place], wanted)
        tables.put(name, place, error, rounding * DEGREE)
    pivots = expected_pivot(rod, friction, SLIPS[mode], stored)
    tables.put("pivot", place, 0.0 if stored == pivots else np.inf, 0.0)
    normal = abs(np.sin(np.deg2rad(angle)))
    turn = float(edge.moved.turn * rod.support.extent)
    spin = turn * abs(np.sin(np.deg2rad(pusher))) / normal
    error = abs(tables.values["spin"][place] - spin)
    tables.put("spin", place, error, SPIN * rounding / ANGLE * (1 + abs(spin)) / min(normal, 1.0))
